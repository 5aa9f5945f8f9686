//! The first screen of every command: a command that answers a question prints at most ten lines of 80 columns; a command whose
//! purpose is a list prints its list.

use std::collections::BTreeSet;
use std::fs;

use asperity_report::StudySettings;
use asperity_studies::every_study;

use crate::bench::{Bench, E_DRIVE, root};

/// Most lines of a first screen.
const MOST_LINES: usize = 10;

/// Checks the number of lines that a command printed, unless it prints a list or was told to print everything.
pub fn is_first_screen(arguments: &[&str], screen: &str) {
    let is_list = LISTS.iter().any(|name| {
        let words: Vec<&str> = name.split(' ').collect();
        arguments.starts_with(&words)
    });
    let is_whole = is_list
        || arguments
            .iter()
            .any(|word| ["--notes", "--json", "--explain-defaults"].contains(word));
    let lines = screen.lines().count();
    assert!(is_whole || lines <= MOST_LINES, "{arguments:?}:\n{screen}");
}

/// Commands whose purpose is a list, or that ask questions.
const LISTS: [&str; 7] = [
    "completions",
    "equations",
    "explain",
    "figures",
    "list",
    "new",
    "schema",
];

/// Commands that answer a question, with their arguments, in an order in which each has its inputs.
const ANSWERS: [(&str, &[&str]); 21] = [
    ("demo", &["worked"]),
    ("check", &["case.toml"]),
    ("run", &["case.toml", "-o", "one"]),
    ("run", &["set.toml", "-o", "set"]),
    ("report", &["one"]),
    ("gear", &["case.toml"]),
    ("gear", &["set.toml"]),
    ("film", &["case.toml"]),
    (
        "contact",
        &[
            "case.toml",
            "--stress",
            "stress.csv",
            "--elastic-limit",
            "1500 MPa",
        ],
    ),
    ("ehl", &["case.toml", "--smooth"]),
    (
        "ehl",
        &[
            "case.toml",
            "--cells",
            "256",
            "--half-widths",
            "1",
            "--start",
            "1",
            "--compare",
        ],
    ),
    ("profile info", &["pinion.csv"]),
    ("profile info", &["pinion.csv", "wheel.csv"]),
    ("profile compare", &["pinion.csv", "wheel.csv"]),
    ("profile change", &["pinion.csv", "worn.csv"]),
    ("profile plot", &["pinion.csv", "-o", "plot.svg"]),
    ("profile convert", &["pinion.csv", "same.x3p"]),
    ("profile filter", &["pinion.csv", "rough.csv"]),
    ("profile generate", &["-o", "made.csv"]),
    (
        "case from-rexs",
        &["chain.rexs", "--stage", "2", "-o", "stage.toml"],
    ),
    ("sweep run", &["study.toml"]),
];

const STUDY: &str = "case = \"case.toml\"\ncolumns = [\"loss_w\"]\n[[axis]]\nkey = \"operation.torque\"\n\
    values = [\"60 N m\", \"140 N m\"]\n";

#[test]
fn every_command_is_known_and_an_answer_is_a_first_screen() {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("case.toml", E_DRIVE);
    bench.write("set.toml", crate::gear::SET);
    bench.write("study.toml", STUDY);
    bench.write_worn("pinion.csv", "worn.csv");
    let gearbox = root().join("crates/rexs/tests/gearboxes/chain.rexs");
    fs::copy(gearbox, bench.path("chain.rexs")).unwrap();
    let mut known: BTreeSet<&str> = LISTS.into_iter().collect();
    for (command, arguments) in ANSWERS {
        known.insert(command);
        let words: Vec<&str> = command
            .split(' ')
            .chain(arguments.iter().copied())
            .collect();
        let said = bench.first_screen(&words);
        assert_eq!(said.status, 0, "{command}: {}", said.err);
        for line in said.out.lines() {
            assert!(line.chars().count() <= 80, "{command}: {line}");
        }
        is_first_screen(&words, &(said.out + &said.err));
    }
    // A study prints `Report::brief`, which has so many lines at most.
    known.extend(every_study!(command));
    known.insert("sweep merge");
    let listed = bench.first_screen(&["completions", "markdown"]).well().out;
    let names = listed.lines().filter_map(|line| {
        let (name, _) = line.strip_prefix("| [`asperity ")?.split_once('`')?;
        Some(name)
    });
    let all: BTreeSet<&str> = names.collect();
    assert_eq!(all, known);
}

fn command<S: StudySettings>() -> &'static str {
    S::COMMAND
}
