//! Where mixed lubrication begins and where it has gone.

use asperity::result::{MeshOutcome, Regime};
use asperity_tests::{CaseText, assert_close, constant, table_2};

/// Table 2 with flanks whose reduced peak height is `rpk` \[m\] each and whose ridges are round.
fn with_peaks(rpk: f64) -> CaseText {
    let text = format!("{:.12e} m", rpk);
    table_2()
        .with("surface.pinion.rpk", text.clone())
        .with("surface.wheel.rpk", text)
        .with("surface.pinion.asperity_radius", "100 um")
        .with("surface.wheel.asperity_radius", "100 um")
}

/// Reduced peak height of each flank at which Λ* is 1 at the first position.
fn critical_peak() -> f64 {
    1e-6 * with_peaks(1e-6).run().result.path[0].lambda_star.unwrap()
}

fn losses(outcome: &MeshOutcome) -> [f64; 3] {
    let summary = &outcome.result.summary;
    [summary.sliding_w, summary.rolling_w, summary.efficiency]
}

#[test]
fn flanks_with_hardly_any_peaks_run_as_those_without() {
    let without = table_2().run();
    let with = with_peaks(1e-12).run();
    assert!(
        with.result
            .path
            .iter()
            .all(|row| row.lambda_star.unwrap() > 1e5)
    );
    assert_eq!(losses(&with), losses(&without));
    assert_eq!(with.result.summary.mixed_share, 0.0);
}

#[test]
fn the_share_of_the_film_is_continuous_where_the_peaks_begin_to_touch() {
    let critical = critical_peak();
    let first = |factor: f64| with_peaks(factor * critical).run().result.path[0].clone();
    let (apart, touching) = (first(1.0 - 1e-6), first(1.0 + 1e-6));
    assert_eq!(apart.film_share, 1.0);
    // 1 − (1 − Λ*)² has no slope there.
    assert!(
        (1.0 - touching.film_share) < 2e-12,
        "{}",
        touching.film_share
    );
    assert_close("mu", touching.mu, apart.mu, 1e-11);
    // A hundredth past it the share falls with the square.
    let past = first(1.0 / 0.99);
    assert_close("solid share", 1.0 - past.film_share, 1e-4, 1e-6);
}

#[test]
fn a_film_is_full_below_two_hundredths_of_the_load_on_asperities() {
    let critical = critical_peak();
    // (1 − Λ*)² is 0.0196 and 0.0204.
    let [below, above] =
        [0.14, 0.143].map(|past| with_peaks(critical / (1.0 - past)).run().result.path[0].regime);
    assert_eq!((below, above), (Regime::FullFilm, Regime::Mixed));
}

#[test]
fn half_the_film_parameter_leaves_three_quarters_to_the_film() {
    let row = with_peaks(2.0 * critical_peak()).run().result.path[0].clone();
    assert_close("Lambda*", row.lambda_star.unwrap(), 0.5, 1e-9);
    assert_close("share", row.film_share, 0.75, 1e-9);
    assert_close("mu", row.mu, 0.25 * 0.1 + 0.75 * row.mu_film, 1e-9);
}

#[test]
fn peaks_far_above_the_film_leave_boundary_friction_alone() {
    let outcome = with_peaks(4e-4).run();
    let summary = &outcome.result.summary;
    assert_eq!(summary.mixed_share, 1.0);
    for row in &outcome.result.path {
        assert!(row.film_share < 1e-2);
        assert_close("mu", row.mu, 0.1, 1e-2);
    }
    // With one coefficient everywhere the loss is that of constant friction.
    let expected = 0.1 * summary.loss_factor_local * summary.power_in_w;
    assert_close("sliding", summary.sliding_w, expected, 1e-2);
}

#[test]
fn where_film_and_solids_rub_alike_the_share_does_not_matter() {
    let alike = |case: CaseText| {
        case.with("model.film_friction", constant(0.08))
            .with("model.boundary_friction", 0.08)
            .run()
    };
    let (mixed, full) = (alike(with_peaks(2e-6)), alike(table_2()));
    assert!(mixed.result.summary.mixed_share > 0.9);
    assert_close(
        "sliding",
        mixed.result.summary.sliding_w,
        full.result.summary.sliding_w,
        1e-13,
    );
}

#[test]
fn it_does_not_matter_which_flank_is_the_rougher() {
    let flanks = |pinion: &str, wheel: &str| {
        let case = with_peaks(1e-6)
            .with("surface.pinion.rq", pinion)
            .with("surface.wheel.rq", wheel);
        losses(&case.run())
    };
    assert_eq!(flanks("0.1 um", "0.5 um"), flanks("0.5 um", "0.1 um"));
    // Two alike are as one rougher by the root of two against a smooth one.
    let alike = flanks("0.3 um", "0.3 um");
    let one = flanks("0.42426406871 um", "1e-9 um");
    assert_close("sliding", one[0], alike[0], 1e-10);
}
