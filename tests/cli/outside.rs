//! An outside program with numbers and slices alone gets the loss of the command to the last digit.

use std::path::Path;

use asperity::prelude::Length;

use crate::bench::{Bench, E_DRIVE, root};

#[path = "../../crates/asperity/examples/case_without_files.rs"]
#[allow(missing_docs, reason = "an example")]
mod case_without_files;

/// Heights \[m\] of a shipped trace in micrometres.
fn heights(name: &str) -> Vec<f64> {
    let text = std::fs::read_to_string(root().join("fixtures/profiles").join(name)).unwrap();
    let rows = text.lines().skip(1);
    rows.map(|row| row.split_once(',').unwrap().1.parse::<f64>().unwrap() / 1e6)
        .collect()
}

#[test]
fn a_case_of_slices_loses_what_the_command_says_to_the_last_digit() {
    let case = root().join("fixtures/cases/e-drive.toml");
    let case = case.to_str().unwrap();
    let said = Bench::new()
        .run(&["run", case, "--no-output", "--no-band", "--json"])
        .well();
    let loss = case_without_files::loss_w(
        &heights("ground_pinion.csv"),
        &heights("ground_wheel.csv"),
        Length::from_si(0.5e-6),
    );
    assert_eq!(
        Some(loss.unwrap()),
        said.json()["summary"]["loss_w"].as_f64()
    );
}

#[test]
fn the_program_has_at_most_forty_lines_and_runs() {
    let file = Path::new("crates/asperity/examples/case_without_files.rs");
    let text = std::fs::read_to_string(root().join(file)).unwrap();
    assert!(text.lines().count() <= 40);
    let used = text.matches("asperity_").count();
    assert_eq!(used, 0, "one dependency is enough");
    case_without_files::main().unwrap();
}

#[test]
fn a_lay_beyond_the_records_is_named_by_check_and_by_a_run_with_its_worth() {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("case.toml", E_DRIVE);
    let far = ["--set", "model.lay=0.6"];
    let checked = bench.run(&[&["check", "case.toml"][..], &far].concat());
    let says = "W452 lay 0.60 of both flanks is above 1/3";
    assert!(checked.well().unwrapped().contains(says));
    let run = ["run", "case.toml", "--no-output"];
    let said = bench.run(&[&run[..], &far].concat()).well().unwrapped();
    assert!(
        said.contains(says) && said.contains("(effect on loss: "),
        "{said}"
    );
    let notes = [&run[..], &far, &["--notes"]].concat();
    let said = bench.run(&notes).well().unwrapped();
    assert!(said.contains("at a lay of 1/6 the loss is "), "{said}");
    let usual = bench.run(&run).well().out;
    assert!(!usual.contains("W452"), "{usual}");
}
