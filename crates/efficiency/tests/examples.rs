//! The example of the README runs.

#![allow(missing_docs, reason = "an example has no documentation of its parts")]

#[path = "../examples/mesh.rs"]
mod mesh;

#[test]
fn the_example_runs() {
    mesh::main().unwrap();
}
