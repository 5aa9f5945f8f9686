//! The example of the README runs.

#![allow(missing_docs, reason = "an example has no documentation of its parts")]

#[path = "../examples/quantities.rs"]
mod quantities;

#[test]
fn the_example_runs() {
    quantities::main().unwrap();
}
