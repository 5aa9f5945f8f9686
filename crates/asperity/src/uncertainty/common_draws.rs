//! The rule by which two runs have draws in common: a constant is common as far as the thing that it belongs to is the same.
//!
//! | constants | belong to | ρ of another thing |
//! |---|---|---|
//! | boundary friction, boundary layer | oil and steels | falls to 0 with viscosity and modulus (`Oil-likeness`) |
//! | limiting shear, Eyring stress, pressure-viscosity of a family | oil | falls to ½ of two oils of one family, else to 0 |
//! | constants and law that traction curves state | curves | 0 |
//! | constants that a rig states | its calibration | 0 |
//! | lay | surfaces that show it; an assumed one to all flanks | 0 |
//! | error of the temperature | the thermometer | the smaller deviation over the larger |
//! | tip relief that is not stated | teeth | falls to 0 with their dimensions |
//! | sampling of the flanks | teeth that were measured | correlation of the losses at the offsets; 0 of other teeth |
//! | error of the model | teeth that were measured | falls with the distance of the conditions (`Model-common`); 0 of other teeth |
//! | asperity contacts formed inside the contact, rolling loss, other rules of the model | the model | - |
//!
//! A constant that one run states and the other leaves drawn is known in both as far as it belongs to the same thing: the difference
//! counts the shift of its median.

use asperity_case::case::{BodyInput, LoadedCase};
use asperity_core::numerics::correlation;
use asperity_gear::GearPair;
use asperity_uncertainty::{
    Common, MODEL_LENGTHS, Measured, Predictive, UncertainParameter, is_stated, model_correlation,
};
use serde::{Deserialize, Serialize};

/// Correlation of a constant of two oils of one family. The sources state a range over the family, and not which part of it two
/// oils share: half of the variance (assumed).
const OF_FAMILY: f64 = 0.5;
/// |ln| of the ratio of two viscosities within a grade of ISO 3448, whose limits are 10 % from its middle, and of the middles of two
/// grades.
const OF_GRADE: [f64; 2] = [0.2, 0.4];
/// The same of two Young's moduli: the moduli of steels, and another material (assumed).
const OF_STEEL: [f64; 2] = [0.03, 0.2];
/// Distance of the dimensions of two pairs of gears of equal numbers of teeth with common unknown relief, and without (assumed).
const OF_TEETH: [f64; 2] = [0.0, 0.2];

/// Name of the component of the sampling.
pub(super) const SAMPLING: &str = "sampling of the flanks";

/// A mesh of a run with its draws.
pub type DrawnCase<'a> = (&'a LoadedCase, &'a Predictive);

/// Relation of the traces of two runs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum CommonTraces {
    /// As the cases state them.
    AsStated,
    /// Of one place before and after a test, with the concordance of their heights.
    OfOnePlace(f64),
}

/// A constant of two runs, and how far its draws are common.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct CommonConstant {
    /// The constant, or another component of the uncertainty.
    pub name: String,
    /// The thing that it belongs to.
    pub belongs_to: String,
    /// Correlation of its draws: 1 where the thing is the same, 0 where each run has a thing of its own.
    pub correlation: f64,
    /// Whether one run states it: the difference counts the shift of its median.
    #[serde(default, skip_serializing_if = "is_false")]
    pub stated_in_one: bool,
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "called by serde")]
fn is_false(stated: &bool) -> bool {
    !*stated
}

/// The draws of the meshes of two runs in common, of the first with the numbers `flanks` of its flanks.
#[must_use]
pub fn common_draws(
    first: &[DrawnCase<'_>],
    flanks: &[usize],
    other: &[DrawnCase<'_>],
) -> [Vec<Common>; 2] {
    common_by(first, flanks, other, CommonTraces::AsStated)
}

/// The same with a relation of their traces.
pub(super) fn common_by(
    first: &[DrawnCase<'_>],
    flanks: &[usize],
    other: &[DrawnCase<'_>],
    traces: CommonTraces,
) -> [Vec<Common>; 2] {
    let is_same = |known: &DrawnCase<'_>, own: &DrawnCase<'_>| match traces {
        CommonTraces::AsStated => known.0.has_teeth_of(own.0),
        CommonTraces::OfOnePlace(_) => true,
    };
    let mut of_other: Vec<Common> = Vec::with_capacity(other.len());
    for (k, own) in other.iter().enumerate() {
        let same: Vec<&DrawnCase<'_>> = first.iter().filter(|known| is_same(known, own)).collect();
        let place = first.iter().position(|known| is_same(known, own));
        let earlier = other[..k].iter().position(|known| is_same(known, own));
        let number = place.map(|place| flanks[place]);
        let number = number.or_else(|| Some(of_other[earlier?].flanks));
        let most = |of: &dyn Fn(&DrawnCase<'_>) -> f64, all: &[&DrawnCase<'_>]| {
            all.iter().map(|known| of(known)).fold(0.0, f64::max)
        };
        let of_flanks = |of: &dyn Fn(&DrawnCase<'_>) -> f64| {
            if same.is_empty() {
                1.0
            } else {
                most(of, &same)
            }
        };
        let all: Vec<&DrawnCase<'_>> = first.iter().collect();
        of_other.push(Common {
            flanks: number.unwrap_or(first.len() + k),
            model: of_flanks(&|known| of_model(known.1, own.1, traces)),
            sampling: of_flanks(&|known| of_sampling(known.1, own.1)),
            relief: most(&|known| of_teeth(known.0, own.0), &all),
            curves: all
                .iter()
                .any(|known| known.0.case.oil_file == own.0.case.oil_file),
            ..of_constants(*own, first, traces)
        });
    }
    let of_first = first.iter().zip(flanks);
    let of_first = of_first.map(|(own, flanks)| {
        let mut common = Common::from(*flanks);
        let beside = of_constants(*own, other, traces);
        for (k, stated) in beside
            .stated
            .into_iter()
            .enumerate()
            .filter(|(_, stated)| *stated)
        {
            (common.stated[k], common.constants[k]) = (stated, beside.constants[k]);
        }
        common
    });
    [of_first.collect(), of_other]
}

/// The draws of the constants of a mesh in common with the meshes of the other run.
fn of_constants(own: DrawnCase<'_>, others: &[DrawnCase<'_>], traces: CommonTraces) -> Common {
    let mut common = Common::from(0);
    for kind in UncertainParameter::ALL {
        let place = kind as usize;
        let most = |others: &mut dyn Iterator<Item = &DrawnCase<'_>>| {
            others
                .map(|other| likeness(kind, own, *other, traces))
                .fold(0.0, f64::max)
        };
        let is_stated_in = |case: &DrawnCase<'_>| is_stated(kind, case.0);
        let is_known = is_stated_in(&own) || others.iter().any(is_stated_in);
        let is_known = is_known && draws(own.1, kind);
        let rho = match (is_stated_in(&own), is_known) {
            // Drawn of a changed case by the draws of the case before the change.
            (true, _) => 1.0,
            (false, true) => most(&mut others.iter().filter(|other| is_stated_in(other))),
            (false, false) => most(&mut others.iter()),
        };
        (common.stated[place], common.constants[place]) = (is_known && rho > 0.0, rho);
    }
    common
}

fn draws(of: &Predictive, kind: UncertainParameter) -> bool {
    of.constants.iter().any(|one| one.kind == kind)
}

/// The record of the rule for two meshes with these draws in common.
#[must_use]
pub(crate) fn common_constants(
    first: DrawnCase<'_>,
    other: DrawnCase<'_>,
    commons: [&Common; 2],
) -> Vec<CommonConstant> {
    // One of the two runs has the first set of draws throughout.
    let least = |of: &dyn Fn(&Common) -> f64| commons.map(of).into_iter().fold(1.0, f64::min);
    let [own, theirs] = commons;
    let row = |name: &str, belongs_to: &str, correlation: f64| CommonConstant {
        name: name.to_owned(),
        belongs_to: belongs_to.to_owned(),
        correlation,
        stated_in_one: false,
    };
    let both = |is_drawn: &dyn Fn(&Predictive) -> bool| is_drawn(first.1) && is_drawn(other.1);
    let one = |is_same: bool| f64::from(u8::from(is_same));
    let is_known = |kind: UncertainParameter| commons.iter().any(|of| of.stated[kind as usize]);
    let is_drawn = |kind| is_known(kind) || both(&|of: &Predictive| draws(of, kind));
    let constants = UncertainParameter::ALL
        .into_iter()
        .filter(|kind| is_drawn(*kind));
    let mut rows: Vec<CommonConstant> = constants
        .map(|kind| CommonConstant {
            stated_in_one: is_known(kind),
            ..row(
                kind.name(),
                thing_of(kind, other.1),
                least(&|of| of.constants[kind as usize]),
            )
        })
        .collect();
    let of_flanks = |of: &dyn Fn(&Common) -> f64| {
        if theirs.flanks == own.flanks {
            least(of)
        } else {
            0.0
        }
    };
    let further = [
        (
            both(&|of| of.relief.is_some()),
            "tip relief not stated",
            "the teeth",
            least(&|of| of.relief),
        ),
        (
            both(&|of| of.film_law.is_some()),
            "error of the film law",
            "the traction curves",
            one(own.curves && theirs.curves),
        ),
        (
            true,
            "error of the model",
            "the measured teeth and their conditions",
            of_flanks(&|of| of.model),
        ),
        (
            both(&|of| of.sampling.standard_error > 0.0),
            SAMPLING,
            "the measured teeth",
            of_flanks(&|of| of.sampling),
        ),
        (
            both(&|of| of.inner_boundary.is_some() || of.recorded.is_some()),
            "boundary share of inner contacts",
            "the model",
            1.0,
        ),
        (true, "rolling loss", "the model", 1.0),
    ];
    let further = further.into_iter().filter(|(is_drawn, ..)| *is_drawn);
    rows.extend(further.map(|(_, name, belongs_to, rho)| row(name, belongs_to, rho)));
    rows
}

/// The measurements that state a constant; `None` of one that is drawn from its family, or not at all.
fn measured(kind: UncertainParameter, of: &Predictive) -> Option<Measured> {
    let mut constants = of.constants.iter();
    constants.find(|one| one.kind == kind)?.measured
}

fn thing_of(kind: UncertainParameter, of: &Predictive) -> &'static str {
    use UncertainParameter as P;
    match (measured(kind, of), kind) {
        (Some(Measured::Calibration), _) => "the calibration",
        (Some(Measured::OilFile), _) => "the traction curves",
        (_, P::BoundaryFriction | P::BoundaryLayer) => "oil and steels",
        (Some(Measured::Surfaces), _) => "the surfaces",
        (_, P::Lay) => "all flanks, as assumed",
        (_, P::TemperatureError) => "the thermometer",
        _ => "the oil",
    }
}

/// ρ of a constant of two meshes.
fn likeness(
    kind: UncertainParameter,
    a: DrawnCase<'_>,
    b: DrawnCase<'_>,
    traces: CommonTraces,
) -> f64 {
    use UncertainParameter as P;
    let (own, theirs) = (&a.0.case, &b.0.case);
    let is_same = match (measured(kind, a.1), measured(kind, b.1)) {
        (Some(Measured::Calibration), Some(Measured::Calibration)) => {
            own.input.calibration == theirs.input.calibration
        }
        (Some(Measured::OilFile), Some(Measured::OilFile)) => own.oil_file == theirs.oil_file,
        (Some(Measured::Surfaces), Some(Measured::Surfaces)) => {
            traces != CommonTraces::AsStated || a.0.has_teeth_of(b.0)
        }
        (None, None) => match kind {
            P::BoundaryFriction | P::BoundaryLayer => {
                return of_oils(a.0, b.0, 0.0) * of_steels(a.0, b.0);
            }
            P::Lay => {
                let is_one = || traces != CommonTraces::AsStated || a.0.has_teeth_of(b.0);
                a.0.flank_lays() == b.0.flank_lays() || is_one()
            }
            P::TemperatureError => {
                let deviation = |of: &LoadedCase| of.case.input.operation.temperature_deviation;
                return deviation(a.0).zip(deviation(b.0)).map_or(0.0, |(a, b)| {
                    let [a, b] = [a.si(), b.si()];
                    if a == b { 1.0 } else { a.min(b) / a.max(b) }
                });
            }
            _ => return of_oils(a.0, b.0, OF_FAMILY),
        },
        _ => false,
    };
    f64::from(u8::from(is_same))
}

/// 1 up to the first of two distances and 0 from the second; between them the deviation of a difference rises linearly.
fn falling([from, to]: [f64; 2], distance: f64) -> f64 {
    1.0 - ((distance - from) / (to - from)).clamp(0.0, 1.0).powi(2)
}

/// ρ of what belongs to an oil.
///
/// ```text
/// ρ = k + (1 − k) ρ_f,  k = 1 − t²,  t = (|ln ν₁/ν₂| − 0.2)/(0.4 − 0.2), 0 ≤ t ≤ 1           [Oil-likeness]
/// ```
///
/// ν: kinematic viscosity at 40 or 100 °C, the larger ratio of both; ρ_f: ρ of two oils of one family. Batches within a grade of ISO
/// 3448 are one oil, the middles of two grades are two. Oils with other names, and of another base oil, have k = 0.
fn of_oils(a: &LoadedCase, b: &LoadedCase, of_family: f64) -> f64 {
    asperity_core::cite!("Oil-likeness");
    let (own, theirs) = (&a.case, &b.case);
    let family = own.lubricant.base_oil();
    if family != theirs.lubricant.base_oil() {
        return 0.0;
    }
    let of_family = if family.is_some() { of_family } else { 0.0 };
    let name = |of: &LoadedCase| of.case.input.lubricant.oil.clone();
    let is_named_same = name(a) == name(b) || own.lubricant.is_oil_of(&theirs.lubricant);
    let k = if is_named_same && own.oil_file == theirs.oil_file {
        falling(
            OF_GRADE,
            own.lubricant.viscosity_distance(&theirs.lubricant),
        )
    } else {
        0.0
    };
    k + (1.0 - k) * of_family
}

/// ρ of what belongs to the steels: by their names and their moduli.
fn of_steels(a: &LoadedCase, b: &LoadedCase) -> f64 {
    let names = |of: &LoadedCase| {
        let stated = &of.case.input.material;
        let name = |body: Option<&BodyInput>| body.and_then(|body| body.steel.clone());
        let pinion = name(Some(&stated.pinion));
        let wheel = stated
            .wheel
            .as_ref()
            .map_or(pinion.clone(), |wheel| name(Some(wheel)));
        [pinion, wheel]
    };
    if names(a) != names(b) {
        return 0.0;
    }
    let bodies = a.case.materials.iter().zip(&b.case.materials);
    let distances = bodies.map(|(own, other)| (own.young.si() / other.young.si()).ln().abs());
    falling(OF_STEEL, distances.fold(0.0, f64::max))
}

/// ρ of the unknown tip relief of two pairs of gears: 0 of other numbers of teeth, and falling with the difference of the dimensions in
/// which one drawing may vary.
fn of_teeth(a: &LoadedCase, b: &LoadedCase) -> f64 {
    let [a, b] = [a, b].map(|of| &of.case.gears);
    if a.teeth != b.teeth || a.internal != b.internal {
        return 0.0;
    }
    let dimensions = |of: &GearPair| {
        let module = of.normal_module.si();
        let shift = |body: usize| of.profile_shift.map_or(0.0, |shifts| shifts[body]);
        [
            module.ln(),
            of.normal_pressure_angle.si(),
            of.helix.si(),
            of.centre_distance.si() / module,
            shift(0),
            shift(1),
            of.tip_radius[0].si() / module,
            of.tip_radius[1].si() / module,
        ]
    };
    let differences = dimensions(a).into_iter().zip(dimensions(b));
    falling(OF_TEETH, differences.map(|(a, b)| (a - b).abs()).sum())
}

/// ρ of the error of the model on the same teeth, at most the concordance of heights before and after a test.
fn of_model(a: &Predictive, b: &Predictive, traces: CommonTraces) -> f64 {
    let conditions = |of: &Predictive| {
        let film = of.film_m;
        let roughness = of
            .roughness_over_film
            .map_or(f64::NAN, |ratio| ratio * film);
        let pressure = of.max_pressure_pa.unwrap_or(f64::NAN);
        [film, roughness, pressure, of.parts_w[0] / of.power_in_w]
    };
    let by_conditions = model_correlation(MODEL_LENGTHS, conditions(a), conditions(b));
    match traces {
        CommonTraces::AsStated => by_conditions,
        CommonTraces::OfOnePlace(concordance) => by_conditions.min(concordance.max(0.0)),
    }
}

/// ρ of the sampling of the same teeth: the correlation of the losses at the offsets that both have; 1 if they leave none.
fn of_sampling(a: &Predictive, b: &Predictive) -> f64 {
    let (own, theirs): (Vec<f64>, Vec<f64>) = a.by_offset_w.iter().zip(&b.by_offset_w).unzip();
    if own.len() > 2 {
        correlation(&own, &theirs).map_or(1.0, |rho| rho.max(0.0))
    } else {
        1.0
    }
}

#[cfg(test)]
mod tests {
    use asperity_core::Profile;
    use asperity_core::numerics::standard_normal_quantile;
    use asperity_uncertainty::{Draw, latin_hypercube};

    use super::super::{PairedDifference, Uncertainty, difference, difference_of_places};
    use super::*;
    use crate::Run;
    use crate::pipeline::Kept;
    use asperity_case::case::{CaseInput, load_with};

    const FILE: &str = "../../fixtures/cases/e-drive.toml";

    struct Drawn {
        loaded: LoadedCase,
        predictive: Predictive,
        uncertainty: Uncertainty,
    }

    impl Drawn {
        fn new(file: &str, change: &dyn Fn(&mut CaseInput)) -> Self {
            let loaded = load_with(std::path::Path::new(file), &|input| {
                (input.model.positions, input.model.offsets) = (Some(4), Some(4));
                change(input);
            });
            Self::run(loaded.unwrap())
        }

        fn run(loaded: LoadedCase) -> Self {
            let run = Run::new(&loaded).pictures(Kept::Highest);
            let (outcome, drawn) = run
                .interval(true)
                .execute()
                .unwrap()
                .only_with_draws()
                .unwrap();
            Self {
                predictive: drawn.unwrap(),
                uncertainty: outcome.result.uncertainty.unwrap(),
                loaded,
            }
        }

        fn against(&self, first: &Self) -> PairedDifference {
            let [first, own] =
                [first, self].map(|of| (&of.loaded, &of.predictive, &of.uncertainty));
            difference(first, own)
        }
    }

    fn set(input: &mut CaseInput, keys: &[(&str, &str)]) {
        for (key, value) in keys {
            input.set(key, value).unwrap();
        }
    }

    /// Share of truths of a difference within its interval: of each component both have a part in common, with the correlations that
    /// `interval` states.
    fn coverage([first, other]: [&Drawn; 2], interval: &PairedDifference) -> f64 {
        const TRUTHS: usize = 400;
        const AXES_OF_ONE: usize = 40;
        let laws = [first, other].map(|of| of.predictive.law());
        let of_row = |name: &str| {
            let mut rows = interval.common.iter();
            rows.find(|row| row.name == name)
                .map_or(1.0, |row| row.correlation)
        };
        let truths = latin_hypercube(TRUTHS, AXES_OF_ONE, 77);
        let within = truths.iter().filter(|u| {
            let z = |k: usize| standard_normal_quantile(u[k]);
            let of = |side: usize, share: f64, k: usize| {
                share.sqrt() * z(k) + (1.0 - share).sqrt() * z(k + 10 + 10 * side)
            };
            let draw = |side: usize| {
                let mut draw = Draw::medians();
                for (k, kind) in UncertainParameter::ALL.into_iter().enumerate() {
                    draw.constants[k] = of(side, of_row(kind.name()), k);
                }
                (draw.inner_boundary, draw.rolling, draw.power) = (u[30], z(31), z(32));
                let of_flanks = |share: f64, k: usize| {
                    share.sqrt() * z(k) + (1.0 - share).sqrt() * z(k + 1 + side)
                };
                draw.of_flanks.sampling = of_flanks(of_row(SAMPLING), 33);
                draw.of_flanks.model = of_flanks(of_row("error of the model"), 36);
                draw
            };
            let [a, b] = [0, 1].map(|side| laws[side].loss(&draw(side)));
            (interval.watts.low..=interval.watts.high).contains(&(b - a))
        });
        within.count() as f64 / TRUTHS as f64
    }

    const VISCOUS: [(&str, &str); 1] = [(
        "lubricant.viscosity",
        "{ law = \"astm-d341\", at_40 = \"46 mm2/s\", at_100 = \"8 mm2/s\" }",
    )];

    #[test]
    fn truths_drawn_by_the_rule_lie_in_the_interval_of_their_difference() {
        let as_is = Drawn::new(FILE, &|_| {});
        let with = |keys: &'static [(&str, &str)]| Drawn::new(FILE, &|input| set(input, keys));
        let warm = with(&[("operation.bulk_temperature", "110 °C")]);
        let viscous = with(&VISCOUS);
        let mineral = Drawn::new(FILE, &|input| {
            input.lubricant = Default::default();
            set(input, &[("lubricant.oil", "m100")]);
        });
        let gears = with(&[("gears.teeth", "[30, 89]"), ("gears.module", "1.4 mm")]);
        let finish = Drawn::new("../../fixtures/cases/e-drive-superfinished.toml", &|_| {});
        let beside = |other: &Drawn| other.against(&as_is);
        let [before, after] =
            [&as_is, &finish].map(|of| (&of.loaded, &of.predictive, &of.uncertainty));
        let worn = difference_of_places(before, after, 0.9);
        // ρ of boundary friction, of the limiting shear stress; whether flanks are those of the first.
        for (name, other, found, [boundary, oil, flanks]) in [
            ("another temperature", &warm, beside(&warm), [1.0, 1.0, 1.0]),
            (
                "an oil of the family",
                &viscous,
                beside(&viscous),
                [0.0, 0.5, 1.0],
            ),
            (
                "an oil of another family",
                &mineral,
                beside(&mineral),
                [0.0, 0.0, 1.0],
            ),
            ("other gears", &gears, beside(&gears), [1.0, 1.0, 1.0]),
            ("another finish", &finish, beside(&finish), [1.0, 1.0, 0.0]),
            ("flanks after a test", &finish, worn, [1.0, 1.0, 1.0]),
        ] {
            let of_row = |kind: &str| {
                let row = found.common.iter().find(|row| row.name == kind);
                row.unwrap().correlation
            };
            let [friction, shear] = [
                UncertainParameter::BoundaryFriction,
                UncertainParameter::LimitingShear,
            ]
            .map(|kind| of_row(kind.name()));
            assert_eq!([friction, shear], [boundary, oil], "{name}");
            assert_eq!(of_row(SAMPLING) > 0.0, flanks > 0.0, "{name}");
            assert!(of_row("error of the model") <= flanks, "{name}");
            let share = coverage([&as_is, other], &found);
            println!("{name}: {share}");
            assert!((0.85..=0.95).contains(&share), "{name}: {share}");
        }
    }

    #[test]
    fn batches_of_a_grade_are_one_oil_and_two_grades_are_two() {
        let as_is = Drawn::new(FILE, &|_| {});
        let of_oil = |viscosities: [f64; 2]| {
            let [at_40, at_100] = viscosities;
            let law = format!(
                "{{ law = \"astm-d341\", at_40 = \"{at_40} mm2/s\", at_100 = \"{at_100} mm2/s\" }}"
            );
            let changed = as_is.loaded.with_key("lubricant.viscosity", &law).unwrap();
            of_oils(&as_is.loaded, &changed, OF_FAMILY)
        };
        // Of the shipped oil, 30.8 and 5.9 mm²/s.
        assert_eq!(of_oil([30.8, 5.9]), 1.0);
        assert_eq!(of_oil([30.8 * 1.2, 5.9 * 1.2]), 1.0);
        let between = of_oil([30.8 * 0.3_f64.exp(), 5.9 * 0.3_f64.exp()]);
        assert!((between - 0.875).abs() < 1e-9, "{between}");
        assert_eq!(of_oil([46.0, 8.9]), 0.5);
        let named = as_is.loaded.with_key("lubricant.oil", "m100").unwrap();
        assert_eq!(of_oils(&as_is.loaded, &named, OF_FAMILY), 0.0);
    }

    /// A key with its value at a place from 0 to 1 on the path from one case to another.
    type Path = (&'static str, fn(f64) -> String);

    const PATHS: [Path; 11] = [
        ("operation.torque", |t| format!("{} N m", 145.0 + 55.0 * t)),
        ("operation.speed", |t| {
            format!("{} 1/min", 9000.0 + 3000.0 * t)
        }),
        ("operation.bulk_temperature", |t| {
            format!("{} °C", 90.0 + 30.0 * t)
        }),
        ("lubricant.density", |t| {
            format!("{} kg/m3", 845.0 + 55.0 * t)
        }),
        ("lubricant.viscosity", |t| {
            let times = 1.0 + 0.5 * t;
            let [at_40, at_100] = [30.8 * times, 5.9 * times];
            format!(
                "{{ law = \"astm-d341\", at_40 = \"{at_40} mm2/s\", at_100 = \"{at_100} mm2/s\" }}"
            )
        }),
        ("model.lay", |t| format!("{}", 0.05 + 0.1 * t)),
        ("model.boundary_friction", |t| {
            format!("{}", 0.08 + 0.03 * t)
        }),
        ("surface.cutoff", |t| format!("{} mm", 0.25 + 0.55 * t)),
        ("gears.module", |t| format!("{} mm", 1.8 + 0.2 * t)),
        ("gears.pinion.tip_relief", |t| {
            format!("{{ amount = \"{} um\", length = \"1 mm\" }}", 2.0 + 6.0 * t)
        }),
        ("material.pinion.elastic_limit", |t| {
            format!("{} MPa", 1500.0 + 300.0 * t)
        }),
    ];

    /// The width of the difference of a run from the first along a path grows from 0 without a jump, and stays below the width of runs
    /// that have nothing in common.
    fn check_widths(name: &str, along: &dyn Fn(f64) -> Drawn) {
        /// Width that a ten-thousandth of the path may have, and the largest rise from 5 to 10 % of the path \[W\].
        const MOST_W: [f64; 2] = [2.0, 20.0];
        let first = along(0.0);
        let width = |of: asperity_core::Estimate| of.high - of.low;
        let at = |t: f64| {
            let other = along(t);
            let found = other.against(&first).watts;
            let mesh = |of: &'_ Drawn, common: Common| -> Vec<f64> { of.predictive.losses(common) };
            let strangers = Common {
                flanks: 1,
                constants: [0.0; UncertainParameter::ALL.len()],
                relief: 0.0,
                ..1.into()
            };
            let (own, theirs) = (mesh(&first, 0.into()), mesh(&other, strangers));
            let apart = own
                .iter()
                .zip(&theirs)
                .map(|(a, b)| b - a)
                .collect::<Vec<_>>();
            let apart = width(asperity_uncertainty::median_with_ends(&apart));
            assert!(
                width(found) <= 1.05 * apart,
                "{name} at {t}: {found:?}, strangers {apart}"
            );
            width(found)
        };
        assert_eq!(at(0.0), 0.0, "{name}");
        let [least, before, after] = [1e-4, 0.05, 0.1].map(at);
        assert!(least < MOST_W[0], "{name}: {least} W");
        assert!(
            (after - before).abs() < MOST_W[1],
            "{name}: {before} to {after} W"
        );
    }

    #[test]
    fn the_width_of_a_difference_grows_steadily_with_each_key() {
        for (key, value) in PATHS {
            check_widths(key, &|t| {
                Drawn::new(FILE, &|input| set(input, &[(key, &value(t))]))
            });
        }
        let face_width = |t: f64| format!("{} mm", 32.0 + 8.0 * t);
        check_widths("gears.face_width", &|t| {
            Drawn::new(FILE, &|input| {
                set(input, &[("gears.face_width", &face_width(t))])
            })
        });
        // Heights of both traces.
        let as_is = Drawn::new(FILE, &|_| {});
        let flanks = ["surface.pinion.file", "surface.wheel.file"];
        check_widths("heights", &|t| {
            let traces = as_is.loaded.all_traces();
            let scaled = traces
                .iter()
                .zip(["pinion", "wheel"])
                .map(|(report, name)| {
                    let trace = report.trace.as_ref().unwrap();
                    let heights = trace.heights().iter().map(|z| (1.0 - 0.4 * t) * z);
                    let scaled = Profile::new(trace.spacing(), heights.collect()).unwrap();
                    (std::path::PathBuf::from(name), scaled)
                });
            let held: Vec<_> = scaled.collect();
            let loaded = as_is.loaded.holding(&held);
            let loaded =
                loaded.with(|input| set(input, &[(flanks[0], "pinion"), (flanks[1], "wheel")]));
            Drawn::run(loaded.unwrap())
        });
    }

    #[test]
    fn the_order_of_two_runs_changes_the_signs_of_their_difference_only() {
        let as_is = Drawn::new(FILE, &|_| {});
        let finish = Drawn::new("../../fixtures/cases/e-drive-superfinished.toml", &|_| {});
        let mineral = Drawn::new(FILE, &|input| {
            input.lubricant = Default::default();
            set(input, &[("lubricant.oil", "m100")]);
        });
        for other in [&finish, &mineral] {
            let [there, back] = [other.against(&as_is), as_is.against(other)];
            assert_eq!(there.at_medians_w, -back.at_medians_w);
            assert_eq!(there.probability, back.probability);
            // Quantiles are interpolated between order statistics from below.
            let ends = there
                .watts
                .ends()
                .into_iter()
                .zip([-back.watts.high, -back.watts.low]);
            for (a, b) in ends.chain([(there.watts.value, -back.watts.value)]) {
                assert!((a - b).abs() < 1e-9 * a.abs(), "{a} {b}");
            }
        }
        let same = as_is.against(&as_is).watts;
        assert_eq!((same.value, same.ends()), (0.0, [0.0; 2]));
    }
}
