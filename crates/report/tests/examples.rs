//! The example runs.

#![allow(missing_docs, reason = "examples have no documentation of their parts")]
#![allow(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use std::path::Path;

#[path = "../examples/load_run_report.rs"]
#[allow(dead_code, reason = "its main reads arguments")]
mod load_run_report;

#[test]
fn a_case_is_loaded_run_and_reported() {
    let case = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/cases/table2.toml");
    let place = tempfile::tempdir().unwrap();
    let folder = place.path().join("result");
    load_run_report::load_run_report(&case, &folder).unwrap();
    assert!(folder.join("report.html").exists());
}
