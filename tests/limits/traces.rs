//! Traces that are simpler than measured ones.

use asperity::result::{Outcome, Regime};
use asperity_tests::{CaseText, assert_close, run, table_2, trace_csv};
use toml::Value;

const SPACING: f64 = 0.5e-6;
const POINTS: usize = 6001;

/// Table 2 between two traces, unfiltered.
fn between(pinion: &[f64], wheel: &[f64], change: impl Fn(CaseText) -> CaseText) -> Outcome {
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str, heights: &[f64]| {
        std::fs::write(folder.path().join(name), trace_csv(SPACING, heights)).unwrap();
        let mut flank = toml::Table::new();
        flank.insert("file".to_owned(), Value::from(name));
        flank
    };
    let case = table_2()
        .with("material.pinion.flow_pressure", "7 GPa")
        .with("surface.cutoff", "0 mm")
        .with("surface.noise_cutoff", "0 um")
        .with("surface.form", "none")
        .with("model.offsets", 4)
        .with("surface.pinion", file("pinion.csv", pinion))
        .with("surface.wheel", file("wheel.csv", wheel));
    run(&change(case).load_in(folder.path()))
}

fn flat() -> Vec<f64> {
    vec![0.0; POINTS]
}

/// A cosine of 20 points to the period.
fn wave(amplitude: f64) -> Vec<f64> {
    (0..POINTS)
        .map(|i| amplitude * (std::f64::consts::TAU * i as f64 / 20.0).cos())
        .collect()
}

#[test]
fn smooth_traces_run_as_roughness_values_that_vanish() {
    let traced = between(&flat(), &flat(), |case| case);
    let values = table_2()
        .with("surface.pinion.rq", "1e-9 um")
        .with("surface.wheel.rq", "1e-9 um")
        .run();
    assert!(
        traced
            .result
            .path
            .iter()
            .all(|row| row.regime == Regime::FullFilm)
    );
    let (traced, values) = (traced.result.summary, values.result.summary);
    // Xu's roughness of 1.4e-9 um against none.
    assert_close("sliding", traced.sliding_w, values.sliding_w, 1e-8);
    assert_close("rolling", traced.rolling_w, values.rolling_w, 1e-13);
}

#[test]
fn smooth_traces_are_the_same_wherever_they_meet() {
    let summary = between(&flat(), &flat(), |case| case).result.summary;
    assert_eq!(
        (summary.offsets, summary.efficiency_deviation),
        (4, Some(0.0))
    );
}

#[test]
fn a_periodic_trace_is_nearly_the_same_wherever_it_meets_a_smooth_one() {
    let outcome = between(&wave(0.4e-6), &flat(), |case| case);
    let spread = outcome.result.summary.efficiency_deviation.unwrap();
    // A window holds some sixty periods; the part of a period at its ends shifts its Rq by a
    // hundredth at most, and the loss of half a per cent with it.
    assert!(spread < 2e-5, "{spread}");
    // The waves' own Rq.
    let ratio = outcome.result.path[16].film_minimum_um / outcome.result.path[16].film_ratio;
    assert_close("S", ratio, 0.4 / 2f64.sqrt(), 0.01);
}

#[test]
fn waves_on_the_pinion_or_on_the_wheel_give_the_same_gap() {
    let full = |case: CaseText| case.with("model.offsets", 1).with("model.depths", 2);
    // Shallow waves in a film that they hardly touch, and deep ones.
    for amplitude in [0.2e-6, 3e-6] {
        let pinion = between(&wave(amplitude), &flat(), full);
        let wheel = between(&flat(), &wave(amplitude), full);
        // One offset takes both windows from the middle.
        for (a, b) in pinion.result.path.iter().zip(&wheel.result.path) {
            assert_eq!(a.lambda_star, b.lambda_star);
            assert_eq!((a.mu, a.p_max_mpa), (b.mu, b.p_max_mpa));
        }
    }
}

#[test]
fn traces_in_full_film_lose_what_their_roughness_values_lose() {
    let traced = between(&wave(0.2e-6), &flat(), |case| {
        case.with("model.boundary_friction", 0.0)
    });
    let row = &traced.result.path[0];
    let rq = row.film_minimum_um / row.film_ratio;
    let values = table_2()
        .with("surface.pinion.rq", format!("{rq} um"))
        .with("surface.wheel.rq", "1e-9 um")
        .run();
    if row.regime == Regime::FullFilm {
        assert_close("mu", row.mu, values.result.path[0].mu, 1e-3);
    } else {
        panic!("waves of 0.2 um touch at Lambda* {:?}", row.lambda_star);
    }
}
