//! The example runs.

#![allow(missing_docs, reason = "examples have no documentation of their parts")]
#![allow(clippy::disallowed_methods, reason = "tests read their own files")]
#![allow(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use std::path::Path;

#[path = "../examples/load_run_report.rs"]
#[allow(dead_code, reason = "its main reads arguments")]
mod load_run_report;

#[test]
fn a_case_is_loaded_run_and_reported() {
    let shipped = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures");
    let text = std::fs::read_to_string(shipped.join("cases/table2.toml")).unwrap();
    let profiles = shipped.canonicalize().unwrap().join("profiles");
    let text = text.replace("../profiles", profiles.to_str().unwrap());
    let few = "[model]\npositions = 4\noffsets = 2";
    let place = tempfile::tempdir().unwrap();
    let case = place.path().join("case.toml");
    std::fs::write(&case, text.replace("[model]", few)).unwrap();
    let folder = place.path().join("result");
    load_run_report::load_run_report(&case, &folder).unwrap();
    assert!(folder.join("report.html").exists());
}
