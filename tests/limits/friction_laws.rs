//! The laws that a result shows side by side.

use std::path::Path;

use asperity::result::{ComparisonOutcome, RunResult};
use asperity_tests::{CaseText, assert_close, run};

const LAWS: [&str; 3] = ["xu", "iso-14179-2", "benedict-kelley"];

/// The shipped case of Table 2, mixed nearly everywhere.
fn with_law(formulation: &str, law: &str) -> RunResult {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fixtures");
    let trace = folder.join("profiles/damaged.txt").display().to_string();
    let text = std::fs::read_to_string(folder.join("cases/table2.toml")).unwrap();
    let case = CaseText::new(&text)
        .with("formulation", formulation)
        .with("model.friction", law)
        .with("surface.pinion.file", trace.clone())
        .with("surface.wheel.file", trace);
    run(&case.load()).result
}

#[test]
fn each_law_shown_beside_the_own_gives_what_it_gives_alone() {
    for formulation in ["corrected", "paper"] {
        let beside = with_law(formulation, "xu").friction_laws;
        for law in LAWS {
            let shown = beside.iter().find(|shown| shown.law == law).unwrap();
            let ComparisonOutcome::Efficiency(shown) = shown.outcome else {
                panic!("{law} is refused");
            };
            let alone = with_law(formulation, law).summary.efficiency;
            let what = format!("{formulation} {law}");
            // Means over the offsets, summed in another order.
            assert_close(&what, shown, alone, 1e-13);
        }
    }
}
