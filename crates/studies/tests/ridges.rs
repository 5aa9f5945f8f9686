//! The study of ridges against runs and the study of sensitivities.

#![allow(clippy::unwrap_used, reason = "tests may panic")]

use std::path::Path;

use asperity::case::{self, LoadedCase};
use asperity::mixed_film::TraceChange;
use asperity::pipeline::{LossGradient, gradient, gradient_with, mean_along};
use asperity::result::ridges::{RidgeRow, height_of_mean_line};
use asperity::uncertainty::{UncertainParameter, range, sampling_interval};
use asperity_core::Profile;
use asperity_report::ridges::notes;
use asperity_roughness::preparation::prepare;
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
    let changes = sensitivity(&case.into(), &|_, _| {}).unwrap().rows;
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

/// The case with traces from which `part` of the height of these ridges above the mean line is taken off.
fn pressed(case: &LoadedCase, rows: &[RidgeRow], part: f64) -> LoadedCase {
    let traces = case.surfaces.traces().unwrap();
    let of = |body: usize| {
        let mut z = traces[body].heights().to_vec();
        let line = height_of_mean_line(traces[body]);
        for row in rows
            .iter()
            .filter(|row| row.flank == ["pinion", "wheel"][body])
        {
            for z in &mut z[row.first_point..=row.last_point] {
                *z = line + (1.0 - part) * (*z - line);
            }
        }
        Profile::new(traces[body].spacing(), z).unwrap()
    };
    case.with_surfaces(case.surfaces.with_traces([of(0), of(1)]))
}

/// Fall of the heights of each trace from one case to another.
fn falls([from, to]: [&LoadedCase; 2]) -> [TraceChange; 2] {
    let traces = [from, to].map(|case| case.surfaces.traces().unwrap());
    let of = |body: usize| {
        let [from, to] = traces.map(|traces| traces[body]);
        let heights = from.heights().iter().zip(to.heights());
        let fall = heights.map(|(from, to)| from - to).collect();
        TraceChange::new(body, fall, from.spacing()).unwrap()
    };
    [of(0), of(1)]
}

/// Saving at each offset by heights that fall from one case to another, by the mean of three gradients.
fn mean_saving(gradients: [&LossGradient; 3], cases: [&LoadedCase; 2]) -> Vec<f64> {
    let along = gradients.map(|gradient| gradient.along(&falls(cases)).unwrap());
    let [mut of_pinion, of_wheel] = mean_along(along.each_ref().map(Vec::as_slice))
        .try_into()
        .unwrap();
    of_pinion
        .iter_mut()
        .zip(of_wheel)
        .for_each(|(sum, one)| *sum += one);
    of_pinion
}

/// The same by one gradient, in the mean over the offsets.
fn saving(gradient: &LossGradient, [from, to]: [&LoadedCase; 2]) -> f64 {
    let traces = [from, to].map(|case| case.surfaces.traces().unwrap());
    let of = |body: usize| -> f64 {
        let [from, to] = traces.map(|traces| traces[body].heights());
        let falls = from.iter().zip(to).map(|(from, to)| from - to);
        let products = falls.zip(&gradient.by_height[body]);
        products.map(|(fall, g)| fall * g).sum()
    };
    of(0) + of(1)
}

/// Presses ridges of the e-drive case one at a time. `ASPERITY_RIDGES=10` presses the ten costliest: on 23 November 2026 the mean
/// gradient was within 7 % of the saving by a run for nine of them, and 17 % too low for one.
#[test]
fn a_ridge_pressed_to_half_its_height_saves_what_the_mean_gradient_predicts() {
    const FEW: usize = 2;
    let wanted = std::env::var("ASPERITY_RIDGES").ok();
    let wanted = wanted.and_then(|text| text.parse::<usize>().ok());
    let few = |input: &mut case::CaseInput| {
        if wanted.is_none() {
            (input.model.positions, input.model.offsets) = (Some(8), Some(8));
        }
    };
    let case = case::load_with(Path::new("../../fixtures/cases/e-drive.toml"), &few).unwrap();
    let rows = ridges(&case, &|_, _| {}).unwrap().found.rows;
    let before = gradient(&case).unwrap();
    let mut by_preparation = 0.0_f64;
    for row in rows.chunks(1).take(wanted.unwrap_or(FEW)) {
        let cases = [0.25, 0.5].map(|part| pressed(&before.case, row, part));
        let [half, after] = cases.each_ref().map(|case| gradient(case).unwrap());
        let saved = before.losses.summary.loss_w - after.losses.summary.loss_w;
        let moved = [&before.case, &cases[1]];
        let mean = mean_saving([&before, &half, &after], moved);
        let predicted = mean.iter().sum::<f64>() / mean.len() as f64;
        let of_ends = 0.5 * (saving(&before, moved) + saving(&after, moved));
        // Each change is flattened, or the gradient of all windows is: the same product.
        let along = before.along(&falls(moved)).unwrap();
        let along = along.iter().flatten().sum::<f64>() / mean.len() as f64;
        assert!(
            (along / saving(&before, moved) - 1.0).abs() < 1e-11,
            "{along}"
        );
        println!(
            "{} at {:.4} mm: {saved:.2} W by a run, {predicted:.2} W; {of_ends:.2} W by both ends",
            row[0].flank, row[0].place_mm
        );
        let error = predicted / saved - 1.0;
        assert!(error.abs() < 0.2, "{row:?}: {predicted} W, {saved} W");
        // The preparation is linear: heights taken off the measured trace are prepared like a trace.
        let body = usize::from(row[0].flank == "wheel");
        let record = before.case.flanks[body].preparation.clone().unwrap();
        let [from, to] = [&before.case, &cases[1]].map(|case| case.surfaces.traces().unwrap());
        let [from, to] = [from[body].heights(), to[body].heights()];
        let mut fall = vec![0.0; record.points_before];
        for (i, (from, to)) in from.iter().zip(to).enumerate() {
            fall[record.dropped_each_end + i] = 2.0 * (from - to);
        }
        let fall = Profile::new(record.spacing, fall).unwrap();
        let fall = prepare(&fall, &record.recipe).unwrap().profile;
        let products = fall.heights().iter().zip(&before.by_height[body]);
        let expected: f64 = products.map(|(fall, g)| fall * g).sum();
        let measured = row[0].measured_first_order_w.unwrap();
        assert!((measured / expected - 1.0).abs() < 1e-9);
        by_preparation = by_preparation.max((measured / row[0].first_order_w - 1.0).abs());
    }
    // The filtered mean line of a measured trace moves with it.
    assert!(by_preparation > 1e-3, "{by_preparation}");
}

#[test]
fn the_interval_of_a_ridge_contains_its_watts_with_each_constant_at_its_ends() {
    use UncertainParameter::{BoundaryFriction, Lay};
    let file = Path::new("../../fixtures/cases/e-drive.toml");
    let few = |input: &mut case::CaseInput| {
        (input.model.positions, input.model.offsets) = (Some(4), Some(8));
    };
    let case = case::load_with(file, &few).unwrap();
    let study = ridges(&case, &|_, _| {}).unwrap();
    let found = &study.found;
    let changed = [0.5, 1.0].map(|part| pressed(&case, &found.rows, part));
    let exact = [&case, &changed[0], &changed[1]].map(|case| gradient(case).unwrap());
    let pressed_w = exact[2].losses.summary.loss_w;
    assert!((pressed_w / found.pressed_at_medians_w - 1.0).abs() < 1e-9);
    // Constants and model add in squares to a sampling error of several times theirs; of a ridge that saves little in the mean, they
    // scale the sampling error: by .9 where its watts are .87 and .55 of themselves at the ends of the lay.
    let wider = |[low, high]: [f64; 2], of_sampling: [f64; 2], times: f64| {
        low < high && high - low > times * (of_sampling[1] - of_sampling[0])
    };
    let of_saving = found.saving_quantiles_w.unwrap();
    assert!(wider(of_saving, found.sampling_quantiles_w.unwrap(), 1.03));
    // Watts of a ridge at each offset, by the mean of the gradients.
    let by_window = |row: &RidgeRow, gradients: &[LossGradient; 3]| -> Vec<f64> {
        let one = pressed(&case, std::slice::from_ref(row), 1.0);
        mean_saving(gradients.each_ref(), [&case, &one])
    };
    let of_rows = found.rows.iter().map(|row| {
        let sampled = by_window(row, &exact);
        let sampled = sampling_interval(&exact[0].case, &exact[0].losses, &sampled);
        let interval = [row.low_w.unwrap(), row.high_w.unwrap()];
        let is_costly = row.mean_gradient_w.abs() > 0.2 * (interval[1] - interval[0]);
        let times = if is_costly { 1.02 } else { 0.85 };
        assert!(
            wider(interval, sampled.unwrap(), times),
            "{row:?} {sampled:?}"
        );
        (row, interval)
    });
    let of_rows: Vec<_> = of_rows.collect();
    let mut beyond_sampling = 0;
    for kind in [BoundaryFriction, Lay] {
        for end in range(kind, &case.at_stated().unwrap())
            .unwrap()
            .unwrap()
            .ends()
        {
            let moved = exact.each_ref().map(|found| {
                let case = found.case.overridden(|over| over.set(kind, end)).unwrap();
                gradient_with(&found.contacts, &case).unwrap()
            });
            let [a, _, b] = moved.each_ref().map(|one| one.losses.summary.loss_w);
            let [low, high] = of_saving;
            assert!((low..high).contains(&(a - b)), "{kind:?} {end}: {a} {b}");
            let [low, high] = found.sampling_quantiles_w.unwrap();
            beyond_sampling += usize::from(!(low..high).contains(&(b - a)));
            for (row, [low, high]) in &of_rows {
                let watts = by_window(row, &moved).iter().sum::<f64>() / 8.0;
                assert!(
                    (*low..*high).contains(&watts),
                    "{kind:?} {end}: {watts} W of {row:?}"
                );
            }
        }
    }
    assert!(beyond_sampling > 0, "the interval needs the constants");
}

#[test]
fn ridges_of_several_teeth_are_the_ridges_of_the_first_pair() {
    let file = Path::new("../../fixtures/cases/e-drive.toml");
    let of = |pinion: &str| {
        let few = |input: &mut case::CaseInput| {
            (input.model.positions, input.model.offsets) = (Some(3), Some(2));
            input.set("surface.pinion", pinion).unwrap();
        };
        ridges(&case::load_with(file, &few).unwrap(), &|_, _| {})
            .unwrap()
            .found
    };
    let first = of(r#"{ file = "../profiles/ground_pinion.csv" }"#);
    let traces =
        r#"{ traces = ["../profiles/ground_pinion.csv", "../profiles/ground_wheel.csv"] }"#;
    let several = of(traces);
    assert_eq!(
        (first.first_of_pairs, several.first_of_pairs),
        (None, Some(2))
    );
    assert!(notes(&several).iter().any(|note| note.contains("2 pairs")));
    assert_eq!(
        (several.loss_at_medians_w, several.rows),
        (first.loss_at_medians_w, first.rows)
    );
}
