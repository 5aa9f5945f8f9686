//! Gear pair, flank modifications and settings of the load map, from the gears as written.

use asperity_core::DomainError;
use asperity_core::quantity::{Angle, Length};
use asperity_gear::{
    AmountDirection, EndRelief, GearError, GearPair, GearPairInput, LoadMapSettings, MicroGeometry,
    Plane, Relief, ReliefExtent, ReliefShape, RootForm,
};

use super::assumed_relief::AssumedRelief;
use crate::input::case_input::{CaseInput, GearsInput};
use crate::input::gear_input::{EndReliefInput, GearFlankInput, ReliefInput};
use crate::input::model::Model;
use crate::source::case_error::CaseError;
use crate::source::defaults::Defaults;
use crate::source::section::{Section, domain};
use crate::source::source_text::Source;
use crate::text::key_of;

/// Basic rack of ISO 53.
const PRESSURE_ANGLE: f64 = 20.0 * std::f64::consts::PI / 180.0;
/// Tables of the flanks of both gears.
const FLANKS: [&str; 2] = ["gears.pinion", "gears.wheel"];

/// The flanks of both gears, each with its table.
fn flanks<'a>(gears: &GearsInput, source: &'a Source) -> [(GearFlankInput, Section<'a>); 2] {
    let [pinion, wheel] = FLANKS.map(|table| Section::new(source, table));
    [
        (gears.pinion.unwrap_or_default(), pinion),
        (gears.wheel.unwrap_or_default(), wheel),
    ]
}

/// The pair of the gears of a case, without the rest of it; `source` gives the places of the keys.
///
/// # Errors
/// When the gears cannot mesh.
///
/// ```
/// use asperity_case::case::{GearsInput, Source, gear_pair};
/// let gears = GearsInput::new([23, 68], "1.8 mm".parse()?, "32 mm".parse()?);
/// let pair = gear_pair(gears, &Source::in_memory())?;
/// assert_eq!(format!("{:.2}", 1e3 * pair.centre_distance.si()), "81.90");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn gear_pair(gears: GearsInput, source: &Source) -> Result<GearPair, CaseError> {
    let input = CaseInput {
        gears,
        ..CaseInput::default()
    };
    super::gears::gears(&input, source, &mut Defaults::default())
}

/// The pair of the case; a negative tooth number of the wheel makes it a ring.
pub(crate) fn gears(
    input: &CaseInput,
    source: &Source,
    defaults: &mut Defaults,
) -> Result<GearPair, CaseError> {
    // The other keys are of the modifications.
    let GearsInput {
        teeth: [z1, z2],
        module,
        module_plane,
        helix,
        pressure_angle,
        face_width,
        profile_shift,
        centre_distance,
        tip_diameter,
        addendum,
        pinion: _,
        wheel: _,
        end_relief: _,
        pitch_deviations: _,
        amounts: _,
        relief_tolerance: _,
    } = input.gears;
    let profile_shift = match (profile_shift, centre_distance) {
        (None, None) => Some(defaults.take("gears.profile_shift", None, [0.0, 0.0])),
        (shift, _) => shift,
    };
    if z1 < 0 {
        let rule = "only the wheel may be a ring, with a negative number, as [24, -75]";
        return Err(Section::new(source, "gears").conflict("teeth", rule));
    }
    let geometry = GearPairInput {
        teeth: [z1.unsigned_abs(), z2.unsigned_abs()],
        module,
        module_plane: defaults.take("gears.module_plane", module_plane, Plane::Normal),
        helix: defaults.take("gears.helix", helix, Angle::from_si(0.0)),
        pressure_angle: defaults.take(
            "gears.pressure_angle",
            pressure_angle,
            Angle::from_si(PRESSURE_ANGLE),
        ),
        face_width: face_width.both(),
        overlap: None,
        profile_shift,
        centre_distance,
        tip_radius: tip_diameter.map(|d| d.map(|d| d / 2.0)),
        addendum: match tip_diameter {
            Some(_) => addendum.unwrap_or(1.0),
            None => defaults.take("gears.addendum", addendum, 1.0),
        },
    };
    let pair = if z2 < 0 {
        GearPair::internal(&geometry)
    } else {
        GearPair::new(&geometry)
    };
    if let (Some(_), None, None, Ok(pair)) = (centre_distance, profile_shift, tip_diameter, &pair) {
        let shifts = pair.profile_shift.unwrap_or_default();
        let [first, second] = shifts.map(|x| (x * 1e4).round() / 1e4);
        defaults.take_from(
            "gears.profile_shift",
            None,
            [first, second],
            Some(
                "sum from the centre distance, divided for equal specific sliding at both ends of contact"
                    .to_owned(),
            ),
        );
    }
    let none = Length::from_si(0.0);
    let chamfer = flanks(&input.gears, source)
        .map(|(flank, section)| defaults.take(section.key("tip_chamfer"), flank.tip_chamfer, none));
    let chamfered = pair.and_then(|pair| {
        if chamfer == [none; 2] {
            Ok(pair)
        } else {
            pair.with_tip_chamfer(chamfer)
        }
    });
    chamfered.map_err(|error| refused(error, source))
}

pub(crate) fn refused(error: GearError, source: &Source) -> CaseError {
    match error {
        GearError::Domain(error) => domain(source, key_of("gears", error.name))(error),
        error => CaseError::gears(source.place_of_key("gears"), error),
    }
}

/// The modifications of both flanks; amounts that a drawing states for each gear are added.
pub(crate) fn micro_geometry(
    input: &CaseInput,
    source: &Source,
    defaults: &mut Defaults,
) -> Result<MicroGeometry, CaseError> {
    let flanks = flanks(&input.gears, source);
    for (flank, section) in &flanks {
        refuse_drawn_and_measured(flank, *section)?;
    }
    let sum = |amount: fn(&GearFlankInput) -> Option<Length>, sign: f64| {
        let [first, second] = flanks.map(|(flank, _)| amount(&flank).unwrap_or_default());
        first + second * sign
    };
    let each = |name: &str, of: fn(&GearFlankInput) -> Option<ReliefInput>| {
        let one = |gear: usize| {
            let (flank, section) = &flanks[gear];
            let drawn = of(flank).map(|drawn| relief(drawn, *section, name));
            drawn.transpose()
        };
        Ok::<_, CaseError>([one(0)?, one(1)?])
    };
    for (flank, section) in &flanks {
        let check = |name: &'static str, value: Option<f64>, [least, most]: [f64; 2], rule| {
            let number = value.unwrap_or(least);
            DomainError::require((least..=most).contains(&number), name, number, "-", rule)
                .map_err(section.domain(name))
        };
        let rule = "must be 0.5 to 3 modules";
        check("dedendum", flank.dedendum, [0.5, 3.0], rule)?;
        let rule = "must be 0 to 1 module";
        check("fillet_radius", flank.fillet_radius, [0.0, 1.0], rule)?;
    }
    let section = Section::new(source, "gears");
    let end_relief = |EndReliefInput {
                          amount,
                          length,
                          power,
                      }| {
        let shape = shape(power, section, "end_relief")?;
        Ok::<_, CaseError>(EndRelief {
            amount,
            length,
            shape,
        })
    };
    let micro = MicroGeometry {
        tip_relief: each("tip_relief", |flank| flank.tip_relief?.drawn())?,
        root_relief: each("root_relief", |flank| flank.root_relief)?,
        crowning: sum(|flank| flank.crowning, 1.0),
        end_relief: input.gears.end_relief.map(end_relief).transpose()?,
        lead_slope: sum(|flank| flank.lead_slope, 1.0),
        // The tip of the wheel is in contact at A, the tip of the pinion at E.
        profile_slope: sum(|flank| flank.profile_slope, -1.0),
        profile_crowning: sum(|flank| flank.profile_crowning, 1.0),
        pitch: input.gears.pitch_deviations.clone().unwrap_or_default(),
        // Known with the traces.
        measured: [None, None],
        direction: AmountDirection::default(),
    };
    if micro.is_unmodified() {
        return Ok(micro);
    }
    let direction = AmountDirection::default();
    let direction = defaults.take("gears.amounts", input.gears.amounts, direction);
    Ok(MicroGeometry { direction, ..micro })
}

/// Refuses a profile form that is both drawn and measured.
fn refuse_drawn_and_measured(
    flank: &GearFlankInput,
    section: Section<'_>,
) -> Result<(), CaseError> {
    // A new key of the profile form belongs to `drawn`.
    let GearFlankInput {
        relief: _,
        tip_relief,
        root_relief,
        tip_chamfer: _,
        crowning: _,
        lead_slope: _,
        profile_slope,
        profile_crowning,
        dedendum: _,
        fillet_radius: _,
    } = flank;
    let drawn = [
        ("tip_relief", tip_relief.is_some()),
        ("root_relief", root_relief.is_some()),
        ("profile_slope", profile_slope.is_some()),
        ("profile_crowning", profile_crowning.is_some()),
    ];
    let drawn = drawn.into_iter().find(|(_, is_stated)| *is_stated);
    match (flank.is_from_trace(), drawn) {
        (true, Some((name, _))) => Err(section.conflict(
            name,
            "is in the trace already, by relief = \"from-trace\" of this gear; give one of the two",
        )),
        _ => Ok(()),
    }
}

/// Lists the tip relief of the gears that state none among the defaults.
pub(crate) fn note_relief(
    input: &CaseInput,
    assumed: Option<&AssumedRelief>,
    source: &Source,
    defaults: &mut Defaults,
) {
    let text = assumed.map_or("none".to_owned(), |assumed| {
        let [amount, length] = [
            1e6 * AssumedRelief::AMOUNT * assumed.approach.si(),
            1e3 * AssumedRelief::LENGTH * assumed.roll_length.si(),
        ];
        format!(
            "{amount:.1} um over {length:.1} mm of roll length, sampled from 0 to {:.1} um",
            2.0 * amount
        )
    });
    for (flank, section) in &flanks(&input.gears, source) {
        if flank.tip_relief.is_none() && !flank.is_from_trace() {
            defaults.note(section.key("tip_relief"), &text);
        }
    }
}

fn relief(drawn: ReliefInput, section: Section<'_>, name: &str) -> Result<Relief, CaseError> {
    let ReliefInput {
        amount,
        length,
        start_diameter,
        power,
    } = drawn;
    let extent = match (length, start_diameter) {
        (Some(length), None) => ReliefExtent::RollLength(length),
        (None, Some(diameter)) => ReliefExtent::StartDiameter(diameter),
        _ => {
            let rule = "needs either length (roll length from the end of the active flank) or start_diameter";
            return Err(section.conflict(name, rule));
        }
    };
    let shape = shape(power, section, name)?;
    Ok(Relief {
        amount,
        extent,
        shape,
    })
}

fn shape(power: Option<u8>, section: Section<'_>, name: &str) -> Result<ReliefShape, CaseError> {
    match power {
        None | Some(1) => Ok(ReliefShape::Linear),
        Some(2) => Ok(ReliefShape::Parabolic),
        Some(_) => {
            let rule = "has a power that is neither 1 (linear) nor 2 (parabolic)";
            Err(section.conflict(name, rule))
        }
    }
}

/// Settings of the load map; the defaults of the basic rack are listed for elastic teeth.
pub(crate) fn load_settings(
    input: &CaseInput,
    model: &Model,
    source: &Source,
    defaults: &mut Defaults,
) -> LoadMapSettings {
    let is_elastic = model.load_distribution.is_elastic();
    let root = flanks(&input.gears, source).map(|(flank, section)| {
        let rack = RootForm::default();
        let mut take = |name: &str, stated: Option<f64>, default: f64| {
            if is_elastic {
                defaults.take(section.key(name), stated, default)
            } else {
                stated.unwrap_or(default)
            }
        };
        RootForm {
            dedendum: take("dedendum", flank.dedendum, rack.dedendum),
            fillet_radius: take("fillet_radius", flank.fillet_radius, rack.fillet_radius),
        }
    });
    LoadMapSettings {
        stiffness_factor: model.stiffness_factor,
        face_coupling: model.face_coupling,
        root,
        edge_contact: model.edge_contact,
        cells: None,
    }
}
