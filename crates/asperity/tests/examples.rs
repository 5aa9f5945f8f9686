//! The examples run, and a case from slices gives the loss of the case from files to the last digit.

#![allow(missing_docs, reason = "examples have no documentation of their parts")]

#[path = "../examples/case_without_files.rs"]
mod case_without_files;
#[path = "../examples/one_contact.rs"]
mod one_contact;
#[path = "../examples/one_film_law.rs"]
mod one_film_law;
#[path = "../examples/one_friction_law.rs"]
mod one_friction_law;

#[test]
fn every_example_runs() {
    case_without_files::main().unwrap();
    one_contact::main().unwrap();
    one_film_law::main().unwrap();
    one_friction_law::main().unwrap();
}
