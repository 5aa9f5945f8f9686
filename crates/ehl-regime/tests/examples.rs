//! The example of the README runs.

#![allow(missing_docs, reason = "an example has no documentation of its parts")]

#[path = "../examples/film_and_regime.rs"]
mod film_and_regime;

#[test]
fn the_example_runs() {
    film_and_regime::main().unwrap();
}
