//! The example of the README runs.

#![allow(missing_docs, reason = "an example has no documentation of its parts")]

#[path = "../examples/oil_from_data_sheet.rs"]
mod oil_from_data_sheet;

#[test]
fn the_example_runs() {
    oil_from_data_sheet::main().unwrap();
}
