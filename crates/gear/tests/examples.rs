//! The example runs.

#[path = "../examples/loss_factors.rs"]
mod loss_factors;

#[test]
fn the_example_runs() {
    loss_factors::main().unwrap();
}
