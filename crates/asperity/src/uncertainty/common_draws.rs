//! The rule by which two runs have draws in common: a constant is common where the thing that it belongs to is the same.
//!
//! | constants | belong to | ρ of another thing |
//! |---|---|---|
//! | boundary friction, boundary layer | oil and steels | 0 |
//! | limiting shear, Eyring stress, pressure-viscosity of a family | oil | ½ of two oils of one family, else 0 |
//! | constants and law that traction curves state | curves | 0 |
//! | constants that a rig states | its calibration | 0 |
//! | lay | surfaces that show it; an assumed one to all flanks | 0 |
//! | error of the temperature | its stated deviation | 0 |
//! | tip relief that is not stated | teeth | 0 |
//! | sampling of the flanks | traces on the same teeth | 0; of one place before and after a test as their windows lose alike |
//! | error of the model | traces | 0; 1 − 0.03²/s² of the same traces under other conditions; of one place before and after a test the concordance of their heights |
//! | inner spots, rolling loss, other rules of the model | the model | - |

use asperity_case::case::LoadedCase;
use asperity_uncertainty::{Common, Measured, Predictive, UncertainParameter};
use serde::{Deserialize, Serialize};

/// Correlation of a constant of two oils of one family. The sources state a range over the family, and not which part of it two
/// oils share: half of the variance (judgement).
const OF_FAMILY: f64 = 0.5;
/// Standard deviation of ln friction by which the error of the model differs from one condition to another on the same flanks: in
/// 85 records on 27 pairs of traces it is 0.026, at most 0.039 (95 %); 0.044 belongs to the traces.
pub(super) const OF_CONDITION: f64 = 0.03;

/// Name of the component of the sampling.
pub(super) const SAMPLING: &str = "sampling of the flanks";

/// A mesh of a run with its draws.
pub type DrawnCase<'a> = (&'a LoadedCase, &'a Predictive);

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
}

/// The draws of the meshes of another run in common with the first run, whose flanks have the numbers `flanks`.
#[must_use]
pub fn common_draws(
    first: &[DrawnCase<'_>],
    flanks: &[usize],
    other: &[DrawnCase<'_>],
) -> Vec<Common> {
    let mut found: Vec<Common> = Vec::with_capacity(other.len());
    for (k, own) in other.iter().enumerate() {
        let most = |of: &dyn Fn(&DrawnCase<'_>) -> f64| first.iter().map(of).fold(0.0, f64::max);
        let is_any = |of: &dyn Fn(&DrawnCase<'_>) -> bool| first.iter().any(of);
        let number = |is_same: &dyn Fn(&DrawnCase<'_>) -> bool, of: fn(&Common) -> usize| {
            let of_first = first.iter().position(is_same).map(|same| flanks[same]);
            let of_own = || Some(of(&found[other[..k].iter().position(is_same)?]));
            of_first.or_else(of_own).unwrap_or(first.len() + k)
        };
        let same_traces = |known: &DrawnCase<'_>| has_traces_of(known.0, own.0);
        let on_teeth = |known: &DrawnCase<'_>| same_traces(known) && has_teeth_of(known.0, own.0);
        let common = Common {
            flanks: number(&same_traces, |common| common.flanks),
            windows: number(&on_teeth, |common| common.windows),
            constants: UncertainParameter::ALL
                .map(|kind| most(&|known| correlation(kind, *known, *own))),
            model: match is_any(&same_traces) {
                true => most(&|known| of_model(*known, *own)),
                false => 1.0,
            },
            relief: is_any(&|known| has_teeth_of(known.0, own.0)),
            curves: is_any(&|known| known.0.case.oil_file == own.0.case.oil_file),
        };
        found.push(common);
    }
    found
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
    };
    let both = |is_drawn: &dyn Fn(&Predictive) -> bool| is_drawn(first.1) && is_drawn(other.1);
    let one = |is_same: bool| f64::from(u8::from(is_same));
    let is_drawn = |kind| both(&|of: &Predictive| of.constants.iter().any(|one| one.kind == kind));
    let constants = UncertainParameter::ALL
        .into_iter()
        .filter(|kind| is_drawn(*kind));
    let mut rows: Vec<CommonConstant> = constants
        .map(|kind| {
            row(
                kind.name(),
                thing_of(kind, other.1),
                least(&|of| of.constants[kind as usize]),
            )
        })
        .collect();
    let model = match theirs.flanks == own.flanks {
        true => least(&|of| of.model),
        false => 0.0,
    };
    let further = [
        (
            both(&|of| of.relief.is_some()),
            "tip relief not stated",
            "the teeth",
            one(own.relief && theirs.relief),
        ),
        (
            both(&|of| of.film_law.is_some()),
            "error of the film law",
            "the traction curves",
            one(own.curves && theirs.curves),
        ),
        (
            true,
            "error of the fast model",
            "the traces and their conditions",
            model,
        ),
        (
            both(&|of| of.sampling.standard_error > 0.0),
            SAMPLING,
            "the traces on their teeth",
            one(theirs.windows == own.windows),
        ),
        (
            both(&|of| of.inner_boundary.is_some() || of.recorded.is_some()),
            "boundary share of inner spots",
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
fn correlation(kind: UncertainParameter, a: DrawnCase<'_>, b: DrawnCase<'_>) -> f64 {
    use UncertainParameter as P;
    let (own, theirs) = (&a.0.case, &b.0.case);
    let is_same = match (measured(kind, a.1), measured(kind, b.1)) {
        (Some(Measured::Calibration), Some(Measured::Calibration)) => {
            own.input.calibration == theirs.input.calibration
        }
        (Some(Measured::OilFile), Some(Measured::OilFile)) => own.oil_file == theirs.oil_file,
        (Some(Measured::Surfaces), Some(Measured::Surfaces)) => has_traces_of(a.0, b.0),
        (None, None) => match kind {
            P::BoundaryFriction | P::BoundaryLayer => {
                has_oil_of(a.0, b.0) && own.materials == theirs.materials
            }
            P::Lay => a.0.flank_lays() == b.0.flank_lays(),
            P::TemperatureError => {
                let deviation = |of: &LoadedCase| of.case.input.operation.temperature_deviation;
                deviation(a.0) == deviation(b.0)
            }
            _ if has_oil_of(a.0, b.0) => true,
            _ => {
                let family = |of: &LoadedCase| of.case.lubricant.base_oil();
                return match family(a.0).is_some() && family(a.0) == family(b.0) {
                    true => OF_FAMILY,
                    false => 0.0,
                };
            }
        },
        _ => false,
    };
    f64::from(u8::from(is_same))
}

/// ρ of the error of the model on the same traces.
///
/// ```text
/// ρ = 1 − r²/s²,  r = 0.03                                                     [Model-common]
/// ```
///
/// s: standard deviation of the error; r: the part of it that differs from condition to condition.
fn of_model(a: DrawnCase<'_>, b: DrawnCase<'_>) -> f64 {
    let operation = |of: &LoadedCase| of.case.input.operation;
    let teeth = has_teeth_of(a.0, b.0) && a.0.case.gears.face_width == b.0.case.gears.face_width;
    if !has_traces_of(a.0, b.0) {
        return 0.0;
    }
    if teeth && has_oil_of(a.0, b.0) && operation(a.0) == operation(b.0) {
        return 1.0;
    }
    asperity_core::cite!("Model-common");
    let error = a.1.model_error().max(b.1.model_error());
    1.0 - (OF_CONDITION / error).powi(2).min(1.0)
}

fn has_traces_of(a: &LoadedCase, b: &LoadedCase) -> bool {
    a.surfaces.has_flanks_of(&b.surfaces)
}

fn has_oil_of(a: &LoadedCase, b: &LoadedCase) -> bool {
    a.case.lubricant.is_oil_of(&b.case.lubricant)
}

/// Whether both have the same teeth, of any width.
fn has_teeth_of(a: &LoadedCase, b: &LoadedCase) -> bool {
    let [a, b] = [a, b].map(|of| &of.case.gears);
    a.teeth == b.teeth
        && a.internal == b.internal
        && a.normal_module == b.normal_module
        && a.normal_pressure_angle == b.normal_pressure_angle
        && a.helix == b.helix
        && a.profile_shift == b.profile_shift
        && a.centre_distance == b.centre_distance
        && a.tip_radius == b.tip_radius
}

#[cfg(test)]
mod tests {
    use asperity_core::numerics::standard_normal_quantile;
    use asperity_uncertainty::{Draw, latin_hypercube};

    use super::super::{Likeness, PairedDifference, Uncertainty, difference, difference_of_places};
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
        fn of(file: &str, change: &dyn Fn(&mut CaseInput)) -> Self {
            let loaded = load_with(std::path::Path::new(file), &|input| {
                (input.model.positions, input.model.offsets) = (Some(4), Some(4));
                change(input);
            });
            let loaded = loaded.unwrap();
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

    /// Shares of the variance that a thing has in common with another: of the oil, of the family, of nothing.
    const SAME: f64 = 1.0;
    const HALF: f64 = 0.5;
    const OWN: f64 = 0.0;

    /// Share of truths of a difference within its interval. `oil` is the shared variance of the constants of two oils, `layer` of the
    /// boundary layer, `windows` of the sampling and `traces` of the error of the model. `of_difference` is the standard error of a
    /// difference whose windows are paired \[W\].
    fn coverage(
        [first, other]: [&Drawn; 2],
        interval: asperity_core::Estimate,
        ([oil, layer, windows, traces], of_difference): ([f64; 4], f64),
    ) -> f64 {
        use UncertainParameter as P;
        const TRUTHS: usize = 400;
        const AXES_OF_ONE: usize = 40;
        let [laws, errors] = [[first, other], [first, other]];
        let errors = errors.map(|of| of.predictive.model_error());
        let laws = laws.map(|of| of.predictive.law());
        let truths = latin_hypercube(TRUTHS, AXES_OF_ONE, 77);
        let within = truths.iter().filter(|u| {
            let z = |k: usize| standard_normal_quantile(u[k]);
            // A thing that both have, and those that each has.
            let of = |side: usize, share: f64, k: usize| {
                share.sqrt() * z(k) + (1.0 - share).sqrt() * z(k + 10 + 10 * side)
            };
            let draw = |side: usize| {
                let mut draw = Draw::medians();
                for (k, kind) in UncertainParameter::ALL.into_iter().enumerate() {
                    draw.constants[k] = match kind {
                        P::BoundaryFriction | P::BoundaryLayer => of(side, layer, k),
                        P::Lay | P::TemperatureError => z(k),
                        _ => of(side, oil, k),
                    };
                }
                (draw.inner_boundary, draw.rolling, draw.power) = (u[30], z(31), z(32));
                let of_flanks = |share: f64, k: usize| {
                    share.sqrt() * z(k) + (1.0 - share).sqrt() * z(k + 1 + side)
                };
                // The error on the same traces has a part of the condition.
                let condition = OF_CONDITION / errors[side];
                draw.of_flanks.sampling = match of_difference > 0.0 {
                    true => 0.0,
                    false => of_flanks(windows, 33),
                };
                draw.of_flanks.model = of_flanks(traces.min(1.0 - condition * condition), 36);
                draw
            };
            let [a, b] = [0, 1].map(|side| laws[side].loss(&draw(side)));
            (interval.low..=interval.high).contains(&(b - a + of_difference * z(39)))
        });
        within.count() as f64 / TRUTHS as f64
    }

    #[test]
    fn truths_drawn_by_the_rule_lie_in_the_interval_of_their_difference() {
        let as_is = Drawn::of(FILE, &|_| {});
        let with = |keys: &'static [(&str, &str)]| Drawn::of(FILE, &|input| set(input, keys));
        let warm = with(&[("operation.bulk_temperature", "110 °C")]);
        let viscous = with(&[(
            "lubricant.viscosity",
            "{ law = \"astm-d341\", at_40 = \"46 mm2/s\", at_100 = \"8 mm2/s\" }",
        )]);
        let mineral = Drawn::of(FILE, &|input| {
            input.lubricant = Default::default();
            set(input, &[("lubricant.oil", "m100")]);
        });
        let gears = with(&[("gears.teeth", "[30, 89]"), ("gears.module", "1.4 mm")]);
        let finish = Drawn::of("../../fixtures/cases/e-drive-superfinished.toml", &|_| {});
        let beside = |other: &Drawn| other.against(&as_is).watts;
        const OF_DIFFERENCE: f64 = 15.0;
        let worn = Likeness {
            heights: 0.9,
            windows: 0.8,
            standard_error_w: OF_DIFFERENCE,
            freedom: 1e6,
        };
        let [before, after] =
            [&as_is, &finish].map(|of| (&of.loaded, &of.predictive, &of.uncertainty));
        let worn = difference_of_places(before, after, worn).watts;
        for (name, other, interval, shares) in [
            (
                "another temperature",
                &warm,
                beside(&warm),
                [SAME, SAME, SAME, SAME],
            ),
            (
                "an oil of the family",
                &viscous,
                beside(&viscous),
                [HALF, OWN, SAME, SAME],
            ),
            (
                "an oil of another family",
                &mineral,
                beside(&mineral),
                [OWN, OWN, SAME, SAME],
            ),
            (
                "other gears",
                &gears,
                beside(&gears),
                [SAME, SAME, OWN, SAME],
            ),
            (
                "another finish",
                &finish,
                beside(&finish),
                [SAME, SAME, OWN, OWN],
            ),
            (
                "flanks after a test",
                &finish,
                worn,
                [SAME, SAME, SAME, 0.9],
            ),
        ] {
            let paired = if interval == worn { OF_DIFFERENCE } else { 0.0 };
            let share = coverage([&as_is, other], interval, (shares, paired));
            println!("{name}: {share}");
            assert!((0.85..=0.95).contains(&share), "{name}: {share}");
        }
    }

    #[test]
    fn the_order_of_two_runs_changes_the_signs_of_their_difference_only() {
        let as_is = Drawn::of(FILE, &|_| {});
        let finish = Drawn::of("../../fixtures/cases/e-drive-superfinished.toml", &|_| {});
        let mineral = Drawn::of(FILE, &|input| {
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
