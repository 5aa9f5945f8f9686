//! The draws of the loss of a case, and their ingredients.

use asperity_core::Estimate;
use std::cell::RefCell;

use asperity::core::numerics::{Z_95, Z_975, range, standard_normal_quantile, student_t_quantile};
use asperity::ehl_regime::GapLaw;
use asperity_uncertainty::{
    Component, Draw, Expected, FilmLaw, InnerBoundary, Measured, Measurement, OtherLaw,
    PatchFlowError, Predictive, QuadraticSurface, Quantiles, Ranged, RecordedRule, SamplingError,
    StudentOfNormal, UncertainParameter, flank_draws, latin_hypercube, permutation,
};

/// A case of which nothing is uncertain but the error of the model and the rolling loss.
fn plain() -> Predictive {
    Predictive {
        at_medians_w: 100.0,
        power_in_w: 1e4,
        parts_w: [90.0, 10.0, 0.0],
        constants: Vec::new(),
        correlations: Vec::new(),
        sliding: None,
        rolling: None,
        share: None,
        surface_rms: 0.0,
        asperity_share: 0.2,
        film_law: None,
        other_law: None,
        inner_boundary: None,
        recorded: None,
        far_lay: None,
        held_thermal: None,
        patch_flow: None,
        relief: None,
        gap_law: GapLaw::Inlet,
        roughness_over_film: Some(1.0),
        max_pressure_pa: None,
        film_m: 0.3e-6,
        sampling: SamplingError::NONE,
        by_offset_w: Vec::new(),
    }
}

/// The draws that all flanks share.
fn shared_draws(found: &Predictive) -> Vec<Draw> {
    let drawn = RefCell::new(Vec::new());
    found.losses_by(0, &|draw| drawn.borrow_mut().push(*draw));
    drawn.into_inner()
}

/// Error of the model where asperities carry load.
const MODEL_ERROR: f64 = 0.05;

fn constant(kind: UncertainParameter, [low, value, high]: [f64; 3]) -> Ranged {
    Ranged {
        kind,
        estimate: Estimate { value, low, high },
        measured: None,
        lays: None,
    }
}

#[test]
fn draws_have_the_spread_of_their_components() {
    let found = plain();
    // Error of the model at s = 1 on 90 W, of the rolling loss 0.12 on 10 W: ln P to first order.
    let expected = (0.9 * MODEL_ERROR).hypot(0.1 * 0.12);
    let drawn = found.quantiles();
    assert!((drawn.drawn.value / 100.0 - 1.0).abs() < 2e-3, "{drawn:?}");
    assert!(
        (drawn.sd_ln / expected - 1.0).abs() < 0.03,
        "{drawn:?} {expected}"
    );
    let sampled = Predictive {
        sampling: SamplingError {
            standard_error: 0.1,
            freedom: 1e6,
            ..SamplingError::NONE
        },
        ..found.clone()
    };
    let alone = sampled.alone(Component::Sampling).unwrap();
    assert!((alone.sd_ln - 0.1).abs() < 1e-3, "{alone:?}");
    assert!((sampled.quantiles().sd_ln / expected.hypot(0.1) - 1.0).abs() < 0.03);
    assert_eq!(found.alone(Component::Sampling), None);
    assert_eq!(found.draws_w(), found.clone().draws_w());
    // Other flanks have other errors.
    assert_ne!(found.losses(0), found.losses(1));
}

#[test]
fn the_tails_of_two_traces_leave_a_loss_between_none_and_all_of_the_power() {
    let found = Predictive {
        sampling: SamplingError {
            standard_error: 0.1,
            freedom: 1.0,
            ..SamplingError::NONE
        },
        ..plain()
    };
    let draws = found.draws_w();
    let ends = range(draws.iter().copied());
    // exp(0.1 t) with t down to -10^4 is 0; 100 W of 10 kW are as far above 1 W as below the power.
    assert_eq!(ends, [1.0, 1e4]);
    for drawn in [found.quantiles(), found.alone(Component::Sampling).unwrap()] {
        assert!(drawn.sd_ln.is_finite() && drawn.sd_ln > 0.1, "{drawn:?}");
    }
}

#[test]
fn quantiles_depend_little_on_the_seed() {
    // The spread of ground flanks: constants, structure, sampling.
    let friction = constant(UncertainParameter::BoundaryFriction, [0.066, 0.09, 0.123]);
    let points: Vec<Vec<f64>> = (-4..=4).map(|k| vec![0.5 * f64::from(k)]).collect();
    let values: Vec<f64> = points.iter().map(|z| 0.12 * z[0]).collect();
    let found = Predictive {
        constants: vec![friction],
        sliding: QuadraticSurface::fit(&points, &values),
        inner_boundary: Some(InnerBoundary {
            slope: [0.07, 0.0, 0.0],
            bend: [0.0; 3],
            boundary: [0.0; 2],
        }),
        roughness_over_film: Some(2.8),
        sampling: SamplingError {
            standard_error: 0.06,
            freedom: 15.0,
            ..SamplingError::NONE
        },
        ..plain()
    };
    let law = found.law();
    let count = Predictive::count();
    let of_seed = |seed: u64| {
        let places = latin_hypercube(count, 4, 100 + seed);
        let losses = places.iter().zip(flank_draws(10 + seed as usize));
        let losses = losses.map(|(place, of_flanks)| {
            // Constants are drawn without the outermost 0.5 % of either side.
            let mut draw = Draw {
                inner_boundary: place[1],
                weight: place[2],
                rolling: standard_normal_quantile(place[3]),
                of_flanks,
                ..Draw::medians()
            };
            let kind = UncertainParameter::BoundaryFriction as usize;
            draw.constants[kind] = standard_normal_quantile(0.005 + 0.99 * place[0]);
            law.loss(&draw)
        });
        Quantiles::from_draws(&losses.collect::<Vec<_>>())
    };
    // The draws of a run are among them.
    let mut seeds: Vec<Quantiles> = (0..12).map(of_seed).collect();
    seeds.push(found.quantiles());
    let spread = |of: &dyn Fn(&Quantiles) -> f64| {
        let ends = seeds
            .iter()
            .map(of)
            .fold([f64::MAX, 0.0_f64], |[low, high], value| {
                [low.min(value), high.max(value)]
            });
        ends[1] / ends[0] - 1.0
    };
    let ends = [0, 1].map(|k: usize| spread(&|found| found.drawn.ends()[k]));
    assert!(spread(&|found| found.drawn.value) < 0.01);
    assert!(ends.iter().all(|end| *end < 0.015), "{ends:?}");
}

#[test]
fn no_draw_loses_more_than_the_power_or_nothing() {
    for k in 0..300 {
        let size = |j: u32| (0.618_034 * f64::from(7 * k + j)).fract();
        let found = Predictive {
            parts_w: [1e4 * size(1), 1e3 * size(2), 0.0],
            power_in_w: 1e4,
            asperity_share: size(3),
            roughness_over_film: Some(6.0 * size(4)),
            sampling: SamplingError {
                standard_error: size(5),
                freedom: 4.0 + 30.0 * size(6),
                ..SamplingError::NONE
            },
            ..plain()
        };
        let drawn = found.draws_w();
        assert!(
            drawn.iter().all(|loss| *loss > 0.0 && *loss <= 1e4),
            "{found:?}"
        );
    }
}

#[test]
fn measured_constants_are_drawn_with_their_correlation() {
    let measured = |kind, ends| Ranged {
        measured: Some(Measured::Calibration),
        ..constant(kind, ends)
    };
    let found = Predictive {
        constants: vec![
            measured(UncertainParameter::BoundaryFriction, [0.08, 0.09, 0.12]),
            constant(UncertainParameter::Lay, [0.008, 1.0 / 12.0, 0.158]),
            measured(UncertainParameter::LimitingShear, [0.033, 0.035, 0.037]),
        ],
        correlations: vec![vec![1.0], vec![-0.9, 0.19_f64.sqrt()]],
        ..plain()
    };
    let drawn: Vec<[f64; UncertainParameter::ALL.len()]> = shared_draws(&found)
        .into_iter()
        .map(|draw| found.standardised(&draw, &found.correlations))
        .collect();
    let n = drawn.len() as f64;
    let product = |a: usize, b: usize| drawn.iter().map(|z| z[a] * z[b]).sum::<f64>() / n;
    let correlation = product(0, 2) / (product(0, 0) * product(2, 2)).sqrt();
    assert!((correlation + 0.9).abs() < 0.01, "{correlation}");
    assert!((product(0, 1) / product(1, 1)).abs() < 0.05);
    // 2.5 % beyond the ends of the bands of a calibration, but for the cut tails.
    let beyond = drawn
        .iter()
        .filter(|z| found.constants[0].at(z[0]) > 0.12)
        .count() as f64
        / n;
    assert!((0.018..0.027).contains(&beyond), "{beyond}");
}

#[test]
fn draws_have_the_other_law_of_pressure_with_its_probability() {
    let constants = vec![constant(UncertainParameter::EyringStress, [1.0, 2.0, 4.0])];
    let points: Vec<Vec<f64>> = (-6..=6).map(|k| vec![0.4 * f64::from(k)]).collect();
    let flat = QuadraticSurface::fit(&points, &vec![0.0; points.len()]).unwrap();
    let case = Predictive {
        sliding: Some(flat.clone()),
        other_law: Some(OtherLaw {
            probability: 0.25,
            correlations: Vec::new(),
            shift: 2f64.ln(),
            sliding: flat,
        }),
        constants,
        ..plain()
    };
    let law = case.law();
    let losses = shared_draws(&case).into_iter().map(|draw| {
        let only = Draw {
            pressure_law: draw.pressure_law,
            ..Draw::medians()
        };
        law.loss(&only)
    });
    let losses: Vec<f64> = losses.collect();
    let doubled = losses
        .iter()
        .filter(|loss| (**loss - 190.0).abs() < 1e-9)
        .count();
    let own = losses
        .iter()
        .filter(|loss| (**loss - 100.0).abs() < 1e-9)
        .count();
    assert_eq!(
        [doubled, own],
        [1, 3].map(|parts| parts * Predictive::count() / 4)
    );
    assert!(case.alone(Component::PressureLaw).is_some());
    assert!(plain().alone(Component::PressureLaw).is_none());
}

#[test]
fn the_error_of_the_film_law_acts_on_the_film_friction() {
    let found = Predictive {
        film_law: Some(FilmLaw {
            share: 0.6,
            deviation: 0.12,
        }),
        ..plain()
    };
    // 0.6 of 90 W of 100 W.
    let alone = found.alone(Component::FilmLaw).unwrap();
    assert!(
        (alone.sd_ln / (0.54 * 0.12) - 1.0).abs() < 0.02,
        "{alone:?}"
    );
    assert_eq!(plain().alone(Component::FilmLaw), None);
}

#[test]
fn losses_narrow_what_all_flanks_share() {
    // μ_b alone is shared, 0.3 of ln loss; error of the model at s = 1, of the measurement 0.04.
    let friction = constant(UncertainParameter::BoundaryFriction, [0.066, 0.09, 0.123]);
    let points: Vec<Vec<f64>> = (-4..=4).map(|k| vec![0.5 * f64::from(k)]).collect();
    let values: Vec<f64> = points.iter().map(|z| 0.3 * z[0]).collect();
    let found = Predictive {
        parts_w: [100.0, 0.0, 0.0],
        constants: vec![friction],
        sliding: QuadraticSurface::fit(&points, &values),
        ..plain()
    };
    let after = |measurement| Expected::new(&[(&found, 1, 0)]).after(&[Some(measurement)]);
    let losses = Measurement::Losses { deviation: 0.04 };
    let left = after(losses).unwrap();
    // Normal distributions: 1/(1/0.3² + 1/(0.04² + e²)), and the error of the model of the own flanks.
    let error = 0.04_f64.hypot(MODEL_ERROR);
    let expected = (1.0 / (1.0 / 0.09 + 1.0 / error.powi(2)) + MODEL_ERROR * MODEL_ERROR).sqrt();
    assert!(
        (left.sd_ln / expected - 1.0).abs() < 0.05,
        "{left:?} {expected}"
    );
    let [low, high] = left.drawn.ends();
    let width = (high / low).ln();
    assert!((width / (2.0 * 1.645 * expected) - 1.0).abs() < 0.08);
    // A friction that is known to a third of its error.
    let sd = (0.123_f64 / 0.066).ln() / 2.0 / 1.645;
    let third = Measurement::BoundaryFriction {
        deviation: sd / 3.0,
    };
    let left = after(third).unwrap();
    // Constants are drawn without the outermost 0.5 % of either side, which leaves 0.9616 of their deviation.
    let expected = (0.1 * 0.9616_f64).hypot(MODEL_ERROR);
    assert!((left.sd_ln / expected - 1.0).abs() < 0.01);
    assert_eq!(after(Measurement::TipRelief), None);
    assert_eq!(after(Measurement::Lay), None);
    // Two such meshes: the constant is common, the errors of the model are independent unless the flanks are equal.
    let two = |flanks: usize, known: [Option<Measurement>; 2]| {
        Expected::new(&[(&found, 1, 0), (&found, 3, flanks)])
            .after(&known)
            .unwrap()
            .sd_ln
    };
    let independent = MODEL_ERROR * 0.25_f64.hypot(0.75);
    let of_both = two(1, [Some(third); 2]);
    let common = (left.sd_ln.powi(2) - MODEL_ERROR * MODEL_ERROR).sqrt();
    let expected = common.hypot(independent);
    assert!(
        (of_both / expected - 1.0).abs() < 0.02,
        "{of_both} {expected}"
    );
    let of_equal = two(0, [Some(third); 2]);
    assert!((of_equal / left.sd_ln - 1.0).abs() < 1e-12, "{of_equal}");
    // Known in the first only, a quarter of the loss: 3/4 of the constant remains, and 1/4 of a third of it.
    let of_one = two(1, [Some(third), None]);
    let constant = 0.3 * (0.75_f64 + 0.25 / 3.0);
    assert!(
        (of_one / constant.hypot(independent) - 1.0).abs() < 0.05,
        "{of_one}"
    );
    let error = 0.04_f64.hypot(independent);
    let expected = (1.0 / (1.0 / 0.09 + 1.0 / error.powi(2)) + independent.powi(2)).sqrt();
    let of_losses = two(1, [Some(losses); 2]);
    assert!(
        (of_losses / expected - 1.0).abs() < 0.05,
        "{of_losses} {expected}"
    );
}

#[test]
fn the_boundary_share_of_inner_spots_is_drawn_evenly_about_the_run() {
    let found = Predictive {
        inner_boundary: Some(InnerBoundary {
            slope: [0.1, 0.02, 0.0],
            bend: [0.01, 0.0, 0.0],
            boundary: [0.2, 0.01],
        }),
        ..plain()
    };
    // The sliding loss of 90 W.
    for (place, ln) in [(0.0, -0.09), (0.5, 0.0), (1.0, 0.11)] {
        let expected = 90.0 * f64::exp(ln) + 10.0;
        let at = found.at_inner_boundary(place).unwrap();
        assert!((at - expected).abs() < 1e-9, "{place}: {at}");
    }
    let inner = found.inner_boundary.as_ref().unwrap();
    for (place, expected) in [(0.0, 0.81), (0.5, 1.0), (1.0, 1.21)] {
        assert!((inner.boundary_at(place) - expected).abs() < 1e-15);
    }
    let ends = [0.0, 0.5, 1.0].map(InnerBoundary::value);
    assert!(
        ends.iter()
            .zip([0.6, 0.75, 0.9])
            .all(|(a, b)| (a - b).abs() < 1e-15)
    );
    let drawn = found.alone(Component::InnerBoundary).unwrap();
    assert!((drawn.drawn.value / 100.0 - 1.0).abs() < 1e-3, "{drawn:?}");
    // An even distribution has its 5 and 95 % quantiles at 0.1 of its width from the ends.
    for (found, x) in drawn.drawn.ends().into_iter().zip([-0.9, 0.9]) {
        let expected = 90.0 * f64::exp(0.1 * x + 0.01 * x * x) + 10.0;
        assert!((found - expected).abs() < 0.02, "{found} {expected}");
    }
    assert_eq!(plain().at_inner_boundary(0.5), None);
}

#[test]
fn a_lay_beyond_the_records_is_drawn_from_the_loss_at_a_confirmed_lay_to_its_own() {
    let found = Predictive {
        far_lay: Some(0.7),
        ..plain()
    };
    // The sliding loss of 90 W.
    assert!((found.at_confirmed_lay().unwrap() - (0.7 * 90.0 + 10.0) / 100.0).abs() < 1e-12);
    let drawn = found.alone(Component::FarLay).unwrap();
    for (quantile, part) in drawn.drawn.ends().into_iter().zip([0.95, 0.05]) {
        let expected = 90.0 * (1.0 - 0.3 * part) + 10.0;
        assert!((quantile - expected).abs() < 0.02, "{quantile} {expected}");
    }
    assert_eq!(plain().alone(Component::FarLay), None);
}

#[test]
fn a_held_thermal_reduction_is_drawn_to_the_printed_one() {
    let found = Predictive {
        held_thermal: Some([0.8, 0.4]),
        ..plain()
    };
    // Sliding 90 W, rolling 10 W.
    let drawn = found.alone(Component::HeldThermal).unwrap();
    for (quantile, part) in drawn.drawn.ends().into_iter().zip([0.95, 0.05]) {
        let expected = 90.0 * (1.0 - 0.2 * part) + 10.0 * (1.0 - 0.6 * part);
        assert!((quantile - expected).abs() < 0.02, "{quantile} {expected}");
    }
    assert_eq!(plain().alone(Component::HeldThermal), None);
}

#[test]
fn the_flow_over_a_patch_is_drawn_to_the_one_of_lines() {
    let of = |wider: f64, by_lines: f64| Predictive {
        patch_flow: Some(PatchFlowError { wider, by_lines }),
        ..plain()
    };
    // The sliding loss of 90 W.
    let drawn = of(1.0, -0.3).alone(Component::PatchFlow).unwrap();
    for (quantile, part) in drawn.drawn.ends().into_iter().zip([0.95, 0.05]) {
        let expected = 90.0 * (1.0 - 0.3 * part) + 10.0;
        assert!((quantile - expected).abs() < 0.02, "{quantile} {expected}");
    }
    let drawn = of(0.9, 0.0).alone(Component::PatchFlow).unwrap();
    for (quantile, z) in drawn.drawn.ends().into_iter().zip([Z_95, -Z_95]) {
        let expected = 90.0 * 0.9_f64.powf(z) + 10.0;
        assert!((quantile - expected).abs() < 0.05, "{quantile} {expected}");
    }
    assert_eq!(plain().alone(Component::PatchFlow), None);
}

#[test]
fn thin_films_are_corrected_downwards() {
    let of = |s: f64| Predictive {
        roughness_over_film: Some(s),
        ..plain()
    };
    let near = |found: f64, expected: f64| (found - expected).abs() < 1e-12;
    // The bias in full, on the sliding loss of 90 W.
    let bias = |found: &Predictive| {
        let all = Draw {
            weight: 1.0,
            ..Draw::medians()
        };
        -((found.law().loss(&all) - 10.0) / 90.0).ln()
    };
    for (s, error) in [
        (0.5, 0.05),
        (1.75, 0.05),
        (3.0, 0.05),
        (3.5, 0.1),
        (4.0, 0.15),
        (6.0, 0.15),
    ] {
        assert_eq!(bias(&of(s)), 0.0, "{s}");
        assert!((of(s).model_error() - error).abs() < 1e-12, "{s}");
    }
    let power = |s: f64| Predictive {
        gap_law: GapLaw::Power,
        ..of(s)
    };
    assert!(near(bias(&power(2.5)), 0.08) && near(bias(&power(6.0)), 0.2));
    assert_eq!(power(6.0).model_error(), 0.05);
    assert!(power(6.0).quantiles().drawn.value < 95.0);
    // The error of the rolling loss of 10 W.
    for (film_m, error) in [(0.4e-6, 0.12), (1.2e-6, 0.25)] {
        let found = Predictive { film_m, ..plain() };
        let one = Draw {
            rolling: 1.0,
            ..Draw::medians()
        };
        assert!(near(((found.law().loss(&one) - 90.0) / 10.0).ln(), error));
    }
}

#[test]
fn a_constant_alone_moves_the_loss_along_its_surface() {
    // S = μ_b/0.09: the loss has the distribution of the friction.
    let friction = constant(UncertainParameter::BoundaryFriction, [0.066, 0.09, 0.123]);
    let slope = (0.123_f64 / 0.09).ln() / Z_95;
    let points: Vec<Vec<f64>> = (-4..=4).map(|k| vec![0.5 * f64::from(k)]).collect();
    let values: Vec<f64> = points.iter().map(|z| slope * z[0]).collect();
    let found = Predictive {
        parts_w: [90.0, 0.0, 0.0],
        at_medians_w: 90.0,
        constants: vec![friction],
        sliding: QuadraticSurface::fit(&points, &values),
        ..plain()
    };
    let alone = found.alone(Component::Constant(0)).unwrap();
    let [low, high] = alone.drawn.ends().map(|loss| loss * 1e-3);
    assert!(
        (high / 0.123 - 1.0).abs() < 0.01 && (low / 0.066 - 1.0).abs() < 0.01,
        "{alone:?}"
    );
    assert_eq!(
        UncertainParameter::ALL[found.constants[0].kind as usize],
        UncertainParameter::BoundaryFriction
    );
}

#[test]
fn constants_have_the_quantiles_of_their_distributions() {
    let near = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-12;
    let of = |kind, measured| Ranged {
        kind,
        estimate: Estimate::new(0.09, [0.066, 0.123]),
        measured,
        lays: None,
    };
    let prior = of(UncertainParameter::BoundaryFriction, None);
    assert!(
        near(prior.at(-Z_95), 0.066) && near(prior.at(0.0), 0.09) && near(prior.at(Z_95), 0.123)
    );
    let calibrated = of(
        UncertainParameter::BoundaryFriction,
        Some(Measured::Calibration),
    );
    assert!(near(calibrated.at(Z_975), 0.123) && calibrated.at(Z_95) < 0.123);
    let fall = of(
        UncertainParameter::LimitingShearTemperature,
        Some(Measured::OilFile),
    );
    assert!(near(fall.at(Z_975), 0.123) && near(fall.at(-0.5 * Z_975), 0.078));
    let lay = of(UncertainParameter::Lay, None);
    assert!(near(lay.at(0.0), 1.0 / 12.0) && near(lay.at(Z_95), 0.95 / 6.0));
}

#[test]
fn every_stratum_of_every_axis_is_drawn_once() {
    let points = latin_hypercube(24, 5, 3);
    for k in 0..5 {
        let mut strata: Vec<usize> = points.iter().map(|p| (24.0 * p[k]) as usize).collect();
        strata.sort_unstable();
        assert_eq!(strata, (0..24).collect::<Vec<_>>());
    }
    assert_eq!(points, latin_hypercube(24, 5, 3));
    assert_ne!(points, latin_hypercube(24, 5, 4));
}

#[test]
fn axes_are_not_drawn_in_the_same_order() {
    let points = latin_hypercube(240, 5, 3);
    for (a, b) in [(0, 1), (1, 2), (3, 4)] {
        let product = |p: &Vec<f64>| (p[a] - 0.5) * (p[b] - 0.5);
        let correlation = points.iter().map(product).sum::<f64>() / 240.0 * 12.0;
        assert!(correlation.abs() < 0.2, "{a} {b} {correlation}");
    }
}

#[test]
fn the_t_distribution_follows_from_its_table() {
    for freedom in [4.0, 7.5, 60.0] {
        let table = StudentOfNormal::new(freedom);
        for p in [0.6, 0.9, 0.95, 0.999] {
            let exact = student_t_quantile(2.0 * p - 1.0, freedom);
            let found = table.at(standard_normal_quantile(p));
            assert!(
                (found / exact - 1.0).abs() < 2e-3,
                "{freedom} {p}: {found} {exact}"
            );
            assert_eq!(table.at(-1.0), -table.at(1.0));
        }
    }
}

#[test]
fn a_quadratic_function_is_found_again() {
    let function = |z: &[f64]| 0.3 * z[0] - 0.1 * z[1] + 0.05 * z[0] * z[2] - 0.02 * z[1] * z[1];
    let points = latin_hypercube(QuadraticSurface::evaluations(3), 3, 1);
    let values: Vec<f64> = points.iter().map(|point| function(point)).collect();
    let surface = QuadraticSurface::fit(&points, &values).unwrap();
    let other = [1.3, -0.7, 2.0];
    assert!((surface.at(&other) - function(&other)).abs() < 1e-12);
    assert_eq!(surface.at(&[0.0; 3]), 0.0);
}

#[test]
fn records_have_their_own_error_and_half_of_the_draws_for_each_rule() {
    let drawn = |stepped: f64| Predictive {
        parts_w: [100.0, 0.0, 0.0],
        roughness_over_film: Some(2.9),
        recorded: Some(RecordedRule { stepped }),
        ..plain()
    };
    let logs = |found: &Predictive| -> Vec<f64> {
        let losses = found.draws_w();
        losses.iter().map(|loss| (loss / 100.0).ln()).collect()
    };
    let moments = |logs: &[f64]| {
        let mean = logs.iter().sum::<f64>() / logs.len() as f64;
        let square = |log: &f64| (log - mean).powi(2);
        let variance = logs.iter().map(square).sum::<f64>() / logs.len() as f64;
        [mean, variance.sqrt()]
    };
    // Short waves 0.02 ± 0.02 and the records' own 0.03, whatever the roughness over the film.
    let [mean, deviation] = moments(&logs(&drawn(1.0)));
    assert!((mean - 0.02).abs() < 1e-4, "{mean}");
    assert!(
        (deviation / 0.0013_f64.sqrt() - 1.0).abs() < 0.01,
        "{deviation}"
    );
    // Half of the draws rise by ln 1.1 about a run with the mean of both: half of it is a further standard deviation.
    let rise = 1.1_f64.ln();
    let [mean, deviation] = moments(&logs(&drawn(1.1)));
    assert!(
        (mean - 0.02 - 0.5 * rise + 1.05_f64.ln()).abs() < 1e-4,
        "{mean}"
    );
    let expected = 0.0013_f64.sqrt().hypot(0.5 * rise);
    assert!((deviation / expected - 1.0).abs() < 0.01, "{deviation}");
    let found = drawn(1.1);
    let ends = [0.0, 0.5, 1.0].map(|place| found.at_inner_boundary(place).unwrap());
    let expected = [100.0 / 1.05, 100.0, 110.0 / 1.05];
    assert!(
        ends.iter()
            .zip(expected)
            .all(|(end, expected)| (end - expected).abs() < 1e-9)
    );
    let alone = found.alone(Component::InnerBoundary).unwrap();
    let [low, high] = alone.drawn.ends();
    assert!((high / low - 1.1).abs() < 1e-12);
}

#[test]
fn an_axis_has_the_stream_of_its_name_and_moves_no_other() {
    let drawn = shared_draws(&plain());
    let strata = drawn.len();
    let place = |stratum: usize| (stratum as f64 + 0.5) / strata as f64;
    for (k, kind) in UncertainParameter::ALL.into_iter().enumerate() {
        let order = permutation(strata, 3, &format!("{kind:?}"));
        // The outermost 0.5 % of either side is not drawn.
        let z = |j: usize| standard_normal_quantile(0.005 + 0.99 * place(order[j]));
        assert!(
            (0..strata).all(|j| drawn[j].constants[k] == z(j)),
            "{kind:?}"
        );
    }
    let length = permutation(strata, 3, "length");
    assert!((0..strata).all(|j| drawn[j].length == place(length[j])));
    // Orders of two axes have nothing in common.
    let product: f64 = drawn
        .iter()
        .map(|draw| draw.constants[0] * draw.constants[1])
        .sum();
    assert!((product / strata as f64).abs() < 0.03, "{product}");
}
