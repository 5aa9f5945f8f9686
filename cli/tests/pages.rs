//! The commands that make pages and help, through the program itself.

#![allow(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use std::path::Path;
use std::process::{Command, Output};

/// Runs the program in `folder`.
fn asperity(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_asperity"))
        .args(arguments)
        .current_dir(folder)
        .output()
        .unwrap()
}

fn said(output: &Output) -> String {
    assert!(output.status.success(), "{output:?}");
    String::from_utf8(output.stdout.clone()).unwrap()
}

#[test]
fn the_demo_is_compared_and_its_report_drawn_anew() {
    let place = tempfile::tempdir().unwrap();
    let here = place.path();
    said(&asperity(here, &["demo", "-q"]));
    let profiles: Vec<String> = std::fs::read_dir(here.join("demo"))
        .unwrap()
        .map(|entry| entry.unwrap().path().display().to_string())
        .filter(|name| name.ends_with(".csv"))
        .collect();
    let of = |part: &str| profiles.iter().find(|name| name.contains(part)).unwrap();
    let ground = format!("--finish=ground={}", of("ground"));
    let smooth = format!("--finish=superfinished={}", of("superfinished"));
    let case = "demo/case.toml";
    let text = said(&asperity(
        here,
        &[
            "compare",
            case,
            &ground,
            &smooth,
            "--offsets",
            "4",
            "--set",
            "model.positions=4",
            "-o",
            "c",
        ],
    ));
    assert!(text.contains("superfinished") && text.contains("ground"));
    assert!(
        text.lines().all(|line| line.chars().count() <= 100),
        "{text}"
    );
    assert!(here.join("c/compare.html").is_file());
    let few = ["--set=model.positions=4", "--set=model.offsets=2"];
    said(&asperity(
        here,
        &[&["run", case, "-o", "r", "-q"][..], &few].concat(),
    ));
    std::fs::remove_file(here.join("r/report.html")).unwrap();
    assert!(said(&asperity(here, &["report", "r/result.json"])).contains("report.html"));
    assert!(here.join("r/report.html").is_file());
}

#[test]
fn a_comparison_needs_two_finishes_and_files_that_are_there() {
    let place = tempfile::tempdir().unwrap();
    said(&asperity(place.path(), &["demo", "-q"]));
    let refused = |arguments: &[&str], code: &str| {
        let mut all = vec!["compare", "demo/case.toml"];
        all.extend(arguments);
        let output = asperity(place.path(), &all);
        let text = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{text}");
        assert!(text.contains(code), "{text}");
        assert!(
            !place.path().join("results").exists(),
            "nothing is left behind"
        );
    };
    refused(&["--finish", "a=demo/case.toml"], "E205");
    refused(&["--finish", "a=no.csv", "--finish", "b=no.csv"], "E103");
    refused(&["--finish", "nothing"], "ground=pinion.csv,wheel.csv");
}

#[test]
fn every_shell_gets_completions_and_man_a_page_of_every_command() {
    let place = tempfile::tempdir().unwrap();
    for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
        let text = said(&asperity(place.path(), &["completions", shell]));
        assert!(
            text.contains("asperity") && text.contains("compare"),
            "{shell}"
        );
    }
    let page = said(&asperity(place.path(), &["completions", "man"]));
    for command in ["RUN", "REPORT", "COMPARE", "FIGURES", "PROFILE", "DEMO"] {
        assert!(page.contains(&format!("ASPERITY {command}")), "{command}");
    }
    assert!(page.contains("\\-\\-finish"));
}
