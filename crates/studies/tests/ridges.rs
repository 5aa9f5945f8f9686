//! The study of ridges against runs and the study of sensitivities.

use std::path::Path;

use asperity::case;
use asperity::pipeline::{LossGradient, gradient, gradient_with};
use asperity::result::ridges::{RidgeRow, height_of_mean_line};
use asperity::uncertainty::UncertainParameter;
use asperity_core::Profile;
use asperity_studies::ridges::ridges;
use asperity_studies::sensitivity::sensitivity;

#[test]
fn the_octaves_add_up_to_the_change_that_the_sensitivity_finds() {
    let file = Path::new("../../fixtures/cases/e-drive.toml");
    let few = |input: &mut case::CaseInput| {
        (input.model.positions, input.model.offsets) = (Some(4), Some(1));
    };
    let case = case::load_with(file, &few).unwrap();
    let by_log_height = ridges(&case, &|_, _| {}).unwrap().found.by_log_height_w;
    let changes = sensitivity(&case, &|_, _| {}).unwrap().rows;
    let of_heights = |to: &str| {
        let row = (changes.iter()).find(|row| row.what.starts_with("heights") && row.to == to);
        row.and_then(|row| row.effect).unwrap().difference_w
    };
    let change = of_heights("× 1.25") - of_heights("× 0.8");
    let expected = change / (1.25_f64 / 0.8).ln();
    let error = by_log_height / expected - 1.0;
    assert!(
        error.abs() < 0.1,
        "{by_log_height} W by the gradient, {expected} W by runs"
    );
}

/// Traces of a case with these ridges at the mean line.
fn pressed(traces: [&Profile; 2], rows: &[RidgeRow]) -> [Profile; 2] {
    let of = |body: usize| {
        let mut z = traces[body].heights().to_vec();
        let line = height_of_mean_line(traces[body]);
        for row in rows
            .iter()
            .filter(|row| row.flank == ["pinion", "wheel"][body])
        {
            z[row.first_point..=row.last_point].fill(line);
        }
        Profile::new(traces[body].spacing(), z).unwrap()
    };
    [of(0), of(1)]
}

#[test]
fn the_interval_of_a_ridge_contains_its_watts_with_each_constant_at_its_ends() {
    use UncertainParameter::*;
    let file = Path::new("../../fixtures/cases/e-drive.toml");
    // A single offset: no sampling in the interval.
    let case = case::load_with(file, &|input| {
        (input.model.positions, input.model.offsets) = (Some(4), Some(1));
    })
    .unwrap();
    let study = ridges(&case, &|_, _| {}).unwrap();
    let (found, traces) = (
        &study.found,
        study.flanks.each_ref().map(|flank| &flank.trace),
    );
    let lower = pressed(traces, &found.rows);
    let mut changed = case.clone();
    changed.surfaces = changed.surfaces.with_traces(lower.clone());
    let exact = [&case, &changed].map(|case| gradient(case).unwrap());
    assert!((exact[1].losses.summary.loss_w / found.pressed_loss_w - 1.0).abs() < 1e-9);
    assert_eq!(found.sampling_quantiles_w, None);
    let mut largest: f64 = 0.0;
    for kind in [
        BoundaryFriction,
        BoundaryLayer,
        Lay,
        LimitingShear,
        EyringStress,
        PressureViscosity,
    ] {
        for end in kind.range(&case).unwrap().unwrap().1 {
            let moved = exact.each_ref().map(|found| {
                let mut case = found.case.clone();
                kind.set(&mut case, end).unwrap();
                gradient_with(&found.contacts, &case).unwrap()
            });
            let [a, b] = moved.each_ref().map(|found| found.losses.summary.loss_w);
            let [low, high] = found.saving_quantiles_w.unwrap();
            assert!(
                (low..high).contains(&(a - b)),
                "{kind:?} {end}: {} W",
                a - b
            );
            for row in &found.rows {
                let body = usize::from(row.flank == "wheel");
                let fall = |i: usize| traces[body].heights()[i] - lower[body].heights()[i];
                let of = |found: &LossGradient| -> f64 {
                    let points = row.first_point..=row.last_point;
                    points.map(|i| found.by_height[body][i] * fall(i)).sum()
                };
                let watts = 0.5 * (of(&moved[0]) + of(&moved[1]));
                let interval = [row.low_w.unwrap(), row.high_w.unwrap()];
                println!(
                    "{kind:?} {end:.3e} {} {:.2} {watts:.2} {interval:.2?}",
                    row.flank, row.mean_gradient_w
                );
                assert!(
                    (interval[0]..interval[1]).contains(&watts),
                    "{kind:?} {end}: {watts} W of {row:?}"
                );
                largest = largest.max((watts / row.mean_gradient_w - 1.0).abs());
            }
        }
    }
    // An interval without the constants would fail.
    assert!(largest > 0.3, "{largest}");
}
