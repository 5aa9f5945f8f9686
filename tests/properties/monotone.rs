//! Effects of more torque, more roughness, more speed.

use asperity_tests::{run, table_2, trace_csv};
use proptest::prelude::*;
use proptest::test_runner::Config;

use crate::cases::{config, drawn};

/// A random trace: waves of 7 to 60 µm with random phases.
fn rough(phases: &[f64], amplitude: f64) -> Vec<f64> {
    let lengths = [7.3, 11.9, 17.1, 23.7, 31.3, 43.9, 60.1];
    (0..5001)
        .map(|i| {
            let x = 0.5 * f64::from(i);
            let waves = lengths.iter().zip(phases);
            let sum: f64 = waves
                .map(|(length, phase)| (std::f64::consts::TAU * (x / length + phase)).sin())
                .sum();
            amplitude * sum
        })
        .collect()
}

/// Λ* along the path of Table 2 between two traces of this amplitude \[m\].
fn lambda_star(phases: &[f64; 14], amplitude: f64) -> Vec<f64> {
    let folder = tempfile::tempdir().unwrap();
    let flank = |name: &str, phases: &[f64]| {
        let text = trace_csv(0.5e-6, &rough(phases, amplitude));
        std::fs::write(folder.path().join(name), text).unwrap();
        let mut flank = toml::Table::new();
        flank.insert("file".to_owned(), toml::Value::from(name));
        flank
    };
    let case = table_2()
        .with("surface.cutoff", "0 mm")
        .with("material.pinion.flow_pressure", "7 GPa")
        .with("model.positions", 4)
        .with("model.offsets", 2)
        .with("model.depths", 0)
        .with("surface.pinion", flank("pinion.csv", &phases[..7]))
        .with("surface.wheel", flank("wheel.csv", &phases[7..]));
    let outcome = run(&case.load_in(folder.path()));
    outcome
        .result
        .path
        .iter()
        .map(|row| row.lambda_star.unwrap())
        .collect()
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn more_torque_loses_more(drawn in drawn(), factor in 1.2..3.0f64) {
        let more = format!("{} N m", factor * drawn.torque);
        let light = drawn.case().run().result.summary;
        let heavy = drawn.case().with("operation.torque", more).run().result.summary;
        prop_assert!(heavy.sliding_w > light.sliding_w);
        prop_assert!(heavy.loss_w > light.loss_w);
    }

    #[test]
    fn higher_peaks_come_through_the_film_in_proportion(drawn in drawn(), factor in 1.1..10.0f64) {
        let higher = format!("{} um", factor * drawn.rpk_um);
        let low = drawn.case().run().result;
        let high = drawn
            .case()
            .with("surface.pinion.rpk", higher.clone())
            .with("surface.wheel.rpk", higher)
            .run()
            .result;
        for (low, high) in low.path.iter().zip(&high.path) {
            let ratio = low.lambda_star.unwrap() / high.lambda_star.unwrap();
            prop_assert!((ratio / factor - 1.0).abs() < 1e-9);
            prop_assert!(high.film_share <= low.film_share);
        }
        prop_assert!(high.summary.mixed_share >= low.summary.mixed_share);
    }

    #[test]
    fn rougher_flanks_rub_more_in_a_full_film(drawn in drawn(), factor in 1.1..3.0f64) {
        let film = |factor: f64| {
            let rq = |flank: usize| format!("{} um", factor * drawn.rq_um[flank]);
            let case = drawn.case().with("surface.pinion.rq", rq(0)).with("surface.wheel.rq", rq(1));
            case.run().result
        };
        let (smooth, rough) = (film(1.0), film(factor));
        for (smooth, rough) in smooth.path.iter().zip(&rough.path) {
            // Held alike beyond 0.6 um.
            prop_assert!(rough.mu_film >= smooth.mu_film);
            prop_assert!((smooth.film_ratio.unwrap() / rough.film_ratio.unwrap() / factor - 1.0).abs() < 1e-9);
        }
    }

    #[test]
    fn a_faster_mesh_lifts_a_thicker_isothermal_film(drawn in drawn(), factor in 1.1..5.0f64) {
        let by = |law: &str, speed: f64| {
            let case = drawn.case().with("model.thermal", "none").with("model.film", law);
            case.with("operation.speed", format!("{speed} 1/min")).run().result
        };
        let [slow, fast] = [1.0, factor].map(|factor| by("steady", factor * drawn.speed));
        for (slow, fast) in slow.path.iter().zip(&fast.path) {
            prop_assert!(fast.film_central_um > slow.film_central_um);
            prop_assert!(fast.film_minimum_um > slow.film_minimum_um);
            prop_assert!(fast.lambda_star > slow.lambda_star);
        }
        let [slow, fast] = [1.0, factor].map(|factor| by("dowson-toyoda", factor * drawn.speed));
        for (slow, fast) in slow.path.iter().zip(&fast.path) {
            // Dowson-Toyoda and Dowson-Higginson.
            let (central, minimum) = (
                fast.film_central_um / slow.film_central_um,
                fast.film_minimum_um / slow.film_minimum_um,
            );
            prop_assert!((central / factor.powf(0.69) - 1.0).abs() < 1e-9);
            prop_assert!((minimum / factor.powf(0.70) - 1.0).abs() < 1e-9);
            prop_assert!(fast.lambda_star > slow.lambda_star);
        }
    }
}

proptest! {
    // Each case reads four traces and solves sixteen contacts.
    #![proptest_config(Config::with_cases(6))]

    #[test]
    fn rougher_traces_lower_the_film_parameter(
        phases in proptest::array::uniform14(0.0..1.0f64),
        factor in 1.2..4.0f64,
    ) {
        let (smooth, rough) = (lambda_star(&phases, 0.05e-6), lambda_star(&phases, factor * 0.05e-6));
        for (smooth, rough) in smooth.iter().zip(&rough) {
            // Peaks are higher by the factor, and sharper, so that they lift less film.
            prop_assert!(rough * factor < smooth * (1.0 + 1e-6), "{smooth} {rough}");
        }
    }
}
