//! The example of the README runs.

#![allow(missing_docs, reason = "an example has no documentation of its parts")]

#[path = "../examples/across_the_film.rs"]
mod across_the_film;

#[test]
fn the_example_runs() {
    across_the_film::main().unwrap();
}
