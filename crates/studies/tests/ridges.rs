//! The study of ridges against runs and the study of sensitivities.

use std::path::Path;

use asperity::case;
use asperity::pipeline::{LossGradient, gradient, gradient_with};
use asperity::result::ridges::{RidgeRow, height_of_mean_line};
use asperity::uncertainty::{UncertainParameter, sampling_interval};
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

/// Heights of the traces of a case with these ridges at the mean line.
fn pressed(traces: [&Profile; 2], rows: &[RidgeRow]) -> [Vec<f64>; 2] {
    let of = |body: usize| {
        let mut z = traces[body].heights().to_vec();
        let line = height_of_mean_line(traces[body]);
        for row in rows
            .iter()
            .filter(|row| row.flank == ["pinion", "wheel"][body])
        {
            z[row.first_point..=row.last_point].fill(line);
        }
        z
    };
    [of(0), of(1)]
}

#[test]
fn the_interval_of_a_ridge_contains_its_watts_with_each_constant_at_its_ends() {
    use UncertainParameter::{BoundaryFriction, Lay};
    let file = Path::new("../../fixtures/cases/e-drive.toml");
    let few = |input: &mut case::CaseInput| {
        (input.model.positions, input.model.offsets) = (Some(4), Some(3));
    };
    let case = case::load_with(file, &few).unwrap();
    let study = ridges(&case, &|_, _| {}).unwrap();
    let (found, traces) = (&study.found, study.flanks.each_ref().map(|f| &f.trace));
    let lower = pressed(traces, &found.rows);
    let mut changed = case.clone();
    let profile = |body: usize| Profile::new(traces[body].spacing(), lower[body].clone()).unwrap();
    changed.surfaces = changed.surfaces.with_traces([0, 1].map(profile));
    let exact = [&case, &changed].map(|case| gradient(case).unwrap());
    let pressed_w = exact[1].losses.summary.loss_w;
    assert!((pressed_w / found.pressed_loss_w - 1.0).abs() < 1e-9);
    let wider = |[low, high]: [f64; 2], of_sampling: [f64; 2]| {
        low < high && high - low > 1.1 * (of_sampling[1] - of_sampling[0])
    };
    let of_saving = found.saving_quantiles_w.unwrap();
    assert!(wider(of_saving, found.sampling_quantiles_w.unwrap()));
    // Watts of a ridge at each offset, by the mean of the gradients.
    let by_window = |row: &RidgeRow, gradients: &[LossGradient; 2]| -> Vec<f64> {
        let body = usize::from(row.flank == "wheel");
        let fall = |i: usize| traces[body].heights()[i] - lower[body][i];
        let of = |gradient: &[Vec<f64>; 2]| -> f64 {
            let points = row.first_point..=row.last_point;
            points.map(|i| gradient[body][i] * fall(i)).sum()
        };
        let [before, after] = gradients.each_ref().map(|one| one.by_offset.iter());
        before
            .zip(after)
            .map(|(a, b)| 0.5 * (of(a) + of(b)))
            .collect()
    };
    let of_rows = found.rows.iter().map(|row| {
        let sampled = by_window(row, &exact);
        let sampled = sampling_interval(&exact[0].case, &exact[0].losses, &sampled);
        let interval = [row.low_w.unwrap(), row.high_w.unwrap()];
        assert!(wider(interval, sampled.unwrap()), "{row:?} {sampled:?}");
        (row, interval)
    });
    let of_rows: Vec<_> = of_rows.collect();
    let mut beyond_sampling = 0;
    for kind in [BoundaryFriction, Lay] {
        for end in kind.range(&case).unwrap().unwrap().1 {
            let moved = exact.each_ref().map(|found| {
                let mut case = found.case.clone();
                kind.set(&mut case, end).unwrap();
                gradient_with(&found.contacts, &case).unwrap()
            });
            let [a, b] = moved.each_ref().map(|one| one.losses.summary.loss_w);
            let [low, high] = of_saving;
            assert!((low..high).contains(&(a - b)), "{kind:?} {end}: {a} {b}");
            let [low, high] = found.sampling_quantiles_w.unwrap();
            beyond_sampling += usize::from(!(low..high).contains(&(b - a)));
            for (row, [low, high]) in &of_rows {
                let watts = by_window(row, &moved).iter().sum::<f64>() / 3.0;
                assert!(
                    (*low..*high).contains(&watts),
                    "{kind:?} {end}: {watts} W of {row:?}"
                );
            }
        }
    }
    assert!(beyond_sampling > 0, "the interval needs the constants");
}
