//! The table of messages, the codes in the sources and the tests that provoke them agree.

use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;

use asperity::message::EXPLANATIONS;

use crate::bench::{Bench, root};
use crate::faces::short_sentences;

/// Codes that no input provokes, and why.
const NOT_PROVOKED: &[(&str, &str)] = &[
    (
        "W463",
        "crates/asperity/tests/surrogates.rs loads such a case",
    ),
    ("W458", "crates/asperity/tests/patches.rs loads such flanks"),
    ("W459", "crates/asperity/tests/patches.rs loads such scans"),
    ("W460", "crates/asperity/tests/patches.rs loads such a scan"),
    ("W464", "crates/asperity/tests/patches.rs loads such a scan"),
    ("W465", "crates/asperity/tests/patches.rs loads such a scan"),
    ("W467", "crates/asperity/tests/patches.rs loads such a scan"),
    ("W466", "crates/asperity/tests/patches.rs loads such a scan"),
    (
        "E302",
        "is of a gap that Python presses: crates/python/tests/test_errors.py",
    ),
    ("W414", "crates/contact/tests/limits.rs presses such a gap"),
    (
        "E140",
        "is of cases that Python pickles: crates/python/tests/test_case.py",
    ),
    (
        "E501",
        "stands for a fault of the program; a test that provoked one would be a bug report",
    ),
    (
        "W423",
        "the rounds of the load map settle for every mesh that is known",
    ),
    (
        "W440",
        "the samples interpolate every shipped case to .5 % of its loss",
    ),
];

fn is_code(word: &str) -> bool {
    let mut letters = word.chars();
    word.len() == 4
        && letters.next().is_some_and(|first| "EW".contains(first))
        && letters.all(|c| c.is_ascii_digit())
}

/// Every `Code::E101` in `text`.
fn codes_in(text: &str) -> BTreeSet<String> {
    let named = text.split("Code::").skip(1);
    let codes = named.filter_map(|rest| rest.get(..4));
    codes
        .filter(|word| is_code(word))
        .map(str::to_owned)
        .collect()
}

/// Every code with which a quoted text of a test begins: `"E101"`, `"E101 flank.csv: "`.
fn codes_told_in(text: &str) -> BTreeSet<String> {
    let quoted = text.split('"').skip(1);
    let first = quoted.filter_map(|text| text.split(' ').next());
    let codes = first.map(|word| word.trim_start_matches("\\n"));
    codes
        .filter(|word| is_code(word))
        .map(str::to_owned)
        .collect()
}

fn sources(folders: &[&str]) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut left: Vec<PathBuf> = folders.iter().map(|name| root().join(name)).collect();
    while let Some(folder) = left.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                left.push(path);
            } else if path.extension().is_some_and(|ending| ending == "rs") {
                found.push(path);
            }
        }
    }
    found
}

fn codes_of(
    folders: &[&str],
    without: &str,
    found: fn(&str) -> BTreeSet<String>,
) -> BTreeSet<String> {
    let texts = sources(folders)
        .into_iter()
        .filter(|path| !path.ends_with(without))
        .map(|path| fs::read_to_string(path).unwrap());
    texts.flat_map(|text| found(&text)).collect()
}

fn explained() -> BTreeSet<String> {
    let codes = EXPLANATIONS.iter().map(|entry| entry.code.to_string());
    codes.collect()
}

#[test]
fn every_code_is_raised_in_the_sources() {
    let used = codes_of(&["crates", "cli/src"], "words.rs", codes_in);
    assert_eq!(used, explained());
}

#[test]
fn every_code_is_provoked_by_a_test_or_said_why_not() {
    let mut provoked = codes_of(
        &["tests/cli", "tests/validation"],
        "codes.rs",
        codes_told_in,
    );
    provoked.extend(NOT_PROVOKED.iter().map(|(code, _)| (*code).to_owned()));
    let missing: Vec<_> = explained().difference(&provoked).cloned().collect();
    assert_eq!(missing, Vec::<String>::new());
}

#[test]
fn explain_prints_meaning_and_remedy_of_every_code() {
    let bench = Bench::new();
    let all = bench.run(&["explain"]).well().out;
    assert_eq!(all.lines().count(), EXPLANATIONS.len());
    for entry in EXPLANATIONS {
        assert!(all.contains(&format!("{}  {}", entry.code, entry.title)));
        short_sentences(entry.meaning, entry.code.as_str());
        short_sentences(entry.remedy, entry.code.as_str());
    }
    let one = bench.run(&["explain", "w402"]).well().out;
    assert!(
        one.starts_with("W402  equivalent friction implausible\n"),
        "{one}"
    );
    assert!(
        one.contains("0.01 to 0.12") && one.contains("what to do"),
        "{one}"
    );
    let made = bench.run(&["explain", "--markdown"]).well().out;
    let headings = made.lines().filter(|line| line.starts_with("### "));
    assert_eq!(headings.count(), EXPLANATIONS.len());
    let listed = bench.run(&["explain", "--json"]).well().json();
    assert_eq!(listed.as_array().unwrap().len(), EXPLANATIONS.len());
}
