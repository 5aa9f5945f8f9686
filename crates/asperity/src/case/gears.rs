//! From the gears as written to the pair, its flanks and what the load map takes.

use asperity_core::quantity::{Angle, Length};
use asperity_gear::{
    AmountDirection, EndRelief, GearError, GearPair, GearPairInput, LoadConditions,
    LoadDistribution, LoadMapSettings, MicroGeometry, Plane, Relief, ReliefExtent, ReliefShape,
    RootForm,
};

use super::defaults::Defaults;
use super::domain::domain;
use super::error::CaseError;
use super::gear_input::{GearFlankInput, ReliefInput};
use super::input::{CaseInput, Formulation};
use super::key_names::key_of;
use super::model::Model;
use super::source::Source;

/// Basic rack of ISO 53.
const PRESSURE_ANGLE: f64 = 20.0 * std::f64::consts::PI / 180.0;

/// The pair of the case; a negative tooth number of the wheel makes it a ring.
pub(super) fn gears(
    input: &CaseInput,
    source: &Source,
    defaults: &mut Defaults,
) -> Result<GearPair, CaseError> {
    let given = &input.gears;
    let shift = match (given.profile_shift, given.centre_distance) {
        (None, None) => Some(defaults.take("gears.profile_shift", None, [0.0, 0.0])),
        (shift, _) => shift,
    };
    let [z1, z2] = given.teeth;
    if z1 < 0 {
        return Err(CaseError::Conflict {
            place: source.place_of("gears.teeth"),
            key: "gears.teeth",
            rule: "only the wheel may be a ring, with a negative number, as [24, -75]",
        });
    }
    let geometry = GearPairInput {
        teeth: [z1.unsigned_abs(), z2.unsigned_abs()],
        module: given.module,
        module_plane: defaults.take("gears.module_plane", given.module_plane, Plane::Normal),
        helix: defaults.take("gears.helix", given.helix, Angle::from_si(0.0)),
        pressure_angle: defaults.take(
            "gears.pressure_angle",
            given.pressure_angle,
            Angle::from_si(PRESSURE_ANGLE),
        ),
        face_width: given.face_width.both(),
        overlap: None,
        profile_shift: shift,
        centre_distance: given.centre_distance,
        tip_radius: given.tip_diameter.map(|d| d.map(|d| d / 2.0)),
        addendum: match given.tip_diameter {
            Some(_) => given.addendum.unwrap_or(1.0),
            None => defaults.take("gears.addendum", given.addendum, 1.0),
        },
    };
    let pair = match z2 < 0 {
        true => GearPair::internal(&geometry),
        false => GearPair::new(&geometry),
    };
    let of = |flank: &Option<GearFlankInput>| flank.as_ref().and_then(|flank| flank.tip_chamfer);
    let none = Length::from_si(0.0);
    let chamfer = [
        defaults.take("gears.pinion.tip_chamfer", of(&given.pinion), none),
        defaults.take("gears.wheel.tip_chamfer", of(&given.wheel), none),
    ];
    let chamfered = pair.and_then(|pair| match chamfer == [none; 2] {
        true => Ok(pair),
        false => pair.with_tip_chamfer(chamfer),
    });
    chamfered.map_err(|error| refused(error, source))
}

fn refused(error: GearError, source: &Source) -> CaseError {
    match error {
        GearError::Domain(error) => domain(source, key_of("gears", error.name))(error),
        error => CaseError::Gears {
            place: source.place_of_key("gears"),
            source: error,
        },
    }
}

/// The modifications of both flanks; amounts that a drawing gives for each gear add up.
pub(super) fn micro_geometry(
    input: &CaseInput,
    source: &Source,
    defaults: &mut Defaults,
) -> Result<MicroGeometry, CaseError> {
    let given = &input.gears;
    let flanks = [
        given.pinion.unwrap_or_default(),
        given.wheel.unwrap_or_default(),
    ];
    for (key, flank) in [
        ("gears.pinion.tip_relief", &flanks[0]),
        ("gears.wheel.tip_relief", &flanks[1]),
    ] {
        if flank.tip_relief.is_none() && !flank.is_from_trace() {
            defaults.note(key, &"none");
        }
    }
    refuse_drawn_and_measured(&flanks, source)?;
    let sum = |amount: fn(&GearFlankInput) -> Option<Length>, sign: f64| {
        let [first, second] =
            [amount(&flanks[0]), amount(&flanks[1])].map(Option::unwrap_or_default);
        first + second * sign
    };
    let tip = ["gears.pinion.tip_relief", "gears.wheel.tip_relief"];
    let root = ["gears.pinion.root_relief", "gears.wheel.root_relief"];
    let each = |keys: [&'static str; 2], of: fn(&GearFlankInput) -> Option<ReliefInput>| {
        let one = |gear: usize| {
            of(&flanks[gear])
                .map(|given| relief(given, keys[gear], source))
                .transpose()
        };
        Ok::<_, CaseError>([one(0)?, one(1)?])
    };
    let end_relief = given.end_relief.map(|end| {
        Ok::<_, CaseError>(EndRelief {
            amount: end.amount,
            length: end.length,
            shape: shape(end.power, "gears.end_relief", source)?,
        })
    });
    let micro = MicroGeometry {
        tip_relief: each(tip, |flank| flank.tip_relief)?,
        root_relief: each(root, |flank| flank.root_relief)?,
        crowning: sum(|flank| flank.crowning, 1.0),
        end_relief: end_relief.transpose()?,
        lead_slope: sum(|flank| flank.lead_slope, 1.0),
        // The tip of the wheel touches at A, that of the pinion at E.
        profile_slope: sum(|flank| flank.profile_slope, -1.0),
        profile_crowning: sum(|flank| flank.profile_crowning, 1.0),
        pitch: given.pitch_deviations.clone().unwrap_or_default(),
        // Known with the traces.
        measured: [None, None],
        direction: AmountDirection::default(),
    };
    if micro.is_unmodified() {
        return Ok(micro);
    }
    let direction = defaults.take("gears.amounts", given.amounts, AmountDirection::default());
    Ok(MicroGeometry { direction, ..micro })
}

/// Refuses a profile form that is both drawn and measured.
fn refuse_drawn_and_measured(
    flanks: &[GearFlankInput; 2],
    source: &Source,
) -> Result<(), CaseError> {
    for (flank, keys) in flanks.iter().zip(PROFILE_KEYS) {
        let given = [
            flank.tip_relief.is_some(),
            flank.root_relief.is_some(),
            flank.profile_slope.is_some(),
            flank.profile_crowning.is_some(),
        ];
        let drawn = keys.into_iter().zip(given).find(|(_, is_given)| *is_given);
        if let (true, Some((key, _))) = (flank.is_from_trace(), drawn) {
            return Err(CaseError::Conflict {
                place: source.place_of(key),
                key,
                rule: "is in the trace already, by relief = \"from-trace\" of this gear; give one of the two",
            });
        }
    }
    Ok(())
}

/// Keys that draw the form of a profile, for pinion and wheel.
const PROFILE_KEYS: [[&str; 4]; 2] = [
    [
        "gears.pinion.tip_relief",
        "gears.pinion.root_relief",
        "gears.pinion.profile_slope",
        "gears.pinion.profile_crowning",
    ],
    [
        "gears.wheel.tip_relief",
        "gears.wheel.root_relief",
        "gears.wheel.profile_slope",
        "gears.wheel.profile_crowning",
    ],
];

fn relief(given: ReliefInput, key: &'static str, source: &Source) -> Result<Relief, CaseError> {
    let extent = match (given.length, given.start_diameter) {
        (Some(length), None) => ReliefExtent::RollLength(length),
        (None, Some(diameter)) => ReliefExtent::StartDiameter(diameter),
        _ => {
            return Err(CaseError::Conflict {
                place: source.place_of(key),
                key,
                rule: "needs either length (roll length from the end of the active flank) or start_diameter",
            });
        }
    };
    Ok(Relief {
        amount: given.amount,
        extent,
        shape: shape(given.power, key, source)?,
    })
}

fn shape(power: Option<u8>, key: &'static str, source: &Source) -> Result<ReliefShape, CaseError> {
    match power {
        None | Some(1) => Ok(ReliefShape::Linear),
        Some(2) => Ok(ReliefShape::Parabolic),
        Some(_) => Err(CaseError::Conflict {
            place: source.place_of(key),
            key,
            rule: "has a power that is neither 1 (linear) nor 2 (parabolic)",
        }),
    }
}

/// Numbers of the load map; the defaults of elastic teeth are written down where they count.
pub(super) fn load_settings(
    input: &CaseInput,
    is_elastic: bool,
    defaults: &mut Defaults,
) -> LoadMapSettings {
    let (given, gears) = (&input.model, &input.gears);
    let standard = LoadMapSettings::default();
    let mut take = |key, given: Option<f64>, default: f64| match is_elastic {
        true => defaults.take(key, given, default),
        false => given.unwrap_or(default),
    };
    let stiffness_factor = take(
        "model.stiffness_factor",
        given.stiffness_factor,
        standard.stiffness_factor,
    );
    let face_coupling = take(
        "model.face_coupling",
        given.face_coupling,
        standard.face_coupling,
    );
    let mut root = |flank: &Option<GearFlankInput>, keys: [&'static str; 2]| {
        let (flank, rack) = (flank.unwrap_or_default(), RootForm::default());
        RootForm {
            dedendum: take(keys[0], flank.dedendum, rack.dedendum),
            fillet_radius: take(keys[1], flank.fillet_radius, rack.fillet_radius),
        }
    };
    let root = [
        root(
            &gears.pinion,
            ["gears.pinion.dedendum", "gears.pinion.fillet_radius"],
        ),
        root(
            &gears.wheel,
            ["gears.wheel.dedendum", "gears.wheel.fillet_radius"],
        ),
    ];
    let edge_contact = match is_elastic {
        true => defaults.take("model.edge_contact", given.edge_contact, false),
        false => given.edge_contact.unwrap_or(false),
    };
    LoadMapSettings {
        stiffness_factor,
        face_coupling,
        root,
        edge_contact,
        cells: None,
    }
}

/// Solves for the load once, so that a law or number unsuitable for these gears is reported with its place.
pub(super) fn check_load(
    mesh: &LoadConditions<'_>,
    model: &Model,
    formulation: Formulation,
    source: &Source,
) -> Result<(), CaseError> {
    let not_for = |key| {
        move |error| match error {
            GearError::Domain(_)
            | GearError::UndercutContact { .. }
            | GearError::ReliefStart { .. } => refused(error, source),
            error => CaseError::NotForTheseGears {
                place: source.place_of(key),
                key,
                source: error,
            },
        }
    };
    let map = model
        .load_distribution
        .load_map(mesh)
        .map_err(not_for("model.load_distribution"))?;
    if formulation == Formulation::Corrected {
        map.cells(model.positions)
            .map_err(not_for("model.positions"))?;
    }
    Ok(())
}
