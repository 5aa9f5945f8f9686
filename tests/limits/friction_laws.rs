//! The published laws that a result shows beside, each applied whole.

use asperity::result::{PublishedOutcome, RunResult};
use asperity_tests::{CaseText, assert_close, table_2};
use asperity_tribo_friction::FrictionLaw;

/// The laws that a result shows beside.
fn whole_laws() -> impl Iterator<Item = &'static str> {
    let rows = FrictionLaw::ALL.iter().map(|law| law.published());
    rows.filter(|row| row.is_whole).map(|row| row.name)
}

fn result(case: CaseText) -> RunResult {
    case.run().result
}

/// Losses \[W\] of `law` as shown, all and sliding.
fn shown(result: &RunResult, law: &str) -> [f64; 2] {
    let mut rows = result.published_laws.iter();
    let row = rows.find(|shown| shown.law == law).unwrap();
    let PublishedOutcome::Applied {
        loss_w, sliding_w, ..
    } = row.outcome
    else {
        panic!("{law} is refused");
    };
    [loss_w, sliding_w]
}

#[test]
fn a_law_applied_whole_loses_what_it_loses_where_the_film_carries_all() {
    let beside = result(table_2());
    for law in whole_laws() {
        let [loss, sliding] = shown(&beside, law);
        let alone = result(table_2().with("model.film_friction", law)).summary;
        assert_close(law, sliding, alone.sliding_w, 1e-13);
        let rolling = if law.starts_with("iso") {
            0.0
        } else {
            alone.rolling_w
        };
        assert_close(law, loss, alone.sliding_w + rolling, 1e-13);
    }
}

#[test]
fn no_asperities_are_added_to_a_law_that_has_them() {
    // Peaks far above the film: everything rubs with the boundary coefficient, and no law notices.
    let (smooth, rough) = (result(table_2()), {
        let peaks =
            |case: CaseText, flank: &str| case.with(&format!("surface.{flank}.rpk"), "5 um");
        result(peaks(peaks(table_2(), "pinion"), "wheel"))
    });
    assert!(rough.summary.sliding_w > 1.5 * smooth.summary.sliding_w);
    for law in whole_laws() {
        assert_eq!(shown(&smooth, law), shown(&rough, law), "{law}");
    }
}

#[test]
fn a_law_outside_what_it_was_fitted_to_says_so() {
    let hot = result(table_2().with("operation.bulk_temperature", "200 °C"));
    assert!(hot.published_laws.iter().all(|row| !row.inside_its_range));
    assert!(hot.published_laws.iter().all(|row| !row.outside.is_empty()));
}
