//! Traces that are simpler than measured ones.

use asperity::result::{MeshOutcome, Regime};
use asperity_tests::{CaseText, assert_close, run, table_2, trace_csv};
use toml::Value;

const SPACING: f64 = 0.5e-6;
const POINTS: usize = 6001;

/// Table 2 between two traces, unfiltered.
fn between(pinion: &[f64], wheel: &[f64], change: impl Fn(CaseText) -> CaseText) -> MeshOutcome {
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

/// A cosine of some 20 points to the period.
fn wave(amplitude: f64) -> Vec<f64> {
    (0..POINTS)
        .map(|i| amplitude * (std::f64::consts::TAU * i as f64 / 20.37).cos())
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
    let ratio = outcome.result.path[8].film_minimum_um / outcome.result.path[8].film_ratio.unwrap();
    assert_close("S", ratio, 0.4 / 2f64.sqrt(), 0.01);
}

/// Three cosines, whose heights are nearly normal. A single one has no reduced peak height: its
/// material ratio curve is least steep at its ends.
fn waves(amplitude: f64) -> Vec<f64> {
    let with_period = |i: usize, points: f64| (std::f64::consts::TAU * i as f64 / points).cos();
    (0..POINTS)
        .map(|i| {
            let sum: f64 = [20.37, 33.11, 51.73]
                .map(|points| with_period(i, points))
                .iter()
                .sum();
            amplitude * sum
        })
        .collect()
}

/// One offset, which takes both windows of the first cell from the middle, and an oil too thin to part waves of 1 µm.
fn thin_oil(case: CaseText) -> CaseText {
    case.with("model.offsets", 1)
        .with("model.depths", 0)
        .with("lubricant.viscosity.dynamic_viscosity", "2 mPa s")
}

#[test]
fn waves_on_the_pinion_or_on_the_wheel_give_the_same_gap() {
    let pinion = between(&waves(1e-6), &flat(), thin_oil);
    let wheel = between(&flat(), &waves(1e-6), thin_oil);
    assert_eq!(pinion.result.summary.mixed_share, 1.0);
    let [a, b] = [&pinion, &wheel].map(|outcome| &outcome.result.path[0]);
    assert_eq!(a.lambda_star, b.lambda_star);
    assert_eq!((a.mu, a.p_max_mpa), (b.mu, b.p_max_mpa));
}

#[test]
fn traces_in_full_film_lose_what_their_roughness_values_lose() {
    let traced = between(&wave(0.2e-6), &flat(), |case| case).result;
    let values = table_2()
        .with("surface.pinion.rq", "0.14142136 um")
        .with("surface.wheel.rq", "1e-9 um")
        .run()
        .result;
    for (traced, values) in traced.path.iter().zip(&values.path) {
        assert_eq!(traced.regime, Regime::FullFilm);
        // The window cuts a period, which shifts Rq by less than a hundredth.
        assert_close("mu", traced.mu, values.mu, 2e-3);
    }
}

#[test]
fn film_and_asperities_together_carry_the_load() {
    let outcome = between(&waves(1e-6), &flat(), thin_oil);
    for (row, fields) in outcome.result.path.iter().zip(&outcome.fields) {
        // Thin oil: most of the friction is of the boundary layer.
        assert_eq!(row.regime, Regime::Boundary);
        let sum = |pressure: &[f64]| pressure.iter().sum::<f64>() * SPACING / 1e3;
        let solid = sum(&fields.pressure_solid);
        // The solver meets its load to round-off; the film is Hertz's ellipse at 450 points.
        let expected = (1.0 - row.film_share) * row.line_load_n_per_mm;
        assert_close("solids", solid, expected, 1e-9);
        let together = solid + sum(&fields.pressure_fluid);
        assert_close("together", together, row.line_load_n_per_mm, 1e-4);
        // The friction of both is the shear on the surface, against the sliding.
        let shear = sum(&fields.shear).abs() / row.line_load_n_per_mm;
        assert_close("shear", shear, row.mu, 1e-4);
        assert!(sum(&fields.shear) * row.sliding_m_per_s < 0.0);
    }
}

#[test]
fn plastic_work_of_the_first_engagement_is_in_no_loss() {
    let found = between(&waves(1e-6), &flat(), |case| {
        thin_oil(case).with("material.pinion.flow_pressure", "1 GPa")
    })
    .result;
    let work = found.running_in.first_pass_w;
    assert!(work > 0.0);
    let s = &found.summary;
    assert_close("loss", s.sliding_w + s.rolling_w, s.loss_w, 1e-12);
    // 50 teeth at 50 turns a second.
    let energy = found.running_in.energy_per_engagement_j;
    assert_close("energy", energy * 2500.0, work, 1e-12);
}
