//! The commands that make pages and help, through the program itself.

use crate::bench::Bench;

/// What the program printed.
fn said(bench: &Bench, arguments: &[&str]) -> String {
    let said = bench.run(arguments);
    assert_eq!(said.status, 0, "{said:?}");
    said.out
}

#[test]
fn the_demo_is_compared_and_its_report_drawn_anew() {
    let here = Bench::new();
    said(&here, &["demo", "-q"]);
    let profiles: Vec<String> = std::fs::read_dir(here.path("demo"))
        .unwrap()
        .map(|entry| entry.unwrap().path().display().to_string())
        .filter(|name| name.ends_with(".csv"))
        .collect();
    let of = |part: &str| profiles.iter().find(|name| name.contains(part)).unwrap();
    let ground = format!("--finish=ground={}", of("ground"));
    let smooth = format!("--finish=superfinished={}", of("superfinished"));
    let case = "demo/case.toml";
    let text = said(
        &here,
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
    );
    assert!(text.contains("superfinished") && text.contains("ground"));
    assert!(
        text.lines().all(|line| line.chars().count() <= 100),
        "{text}"
    );
    assert!(here.path("c/compare.html").is_file());
    let few = ["--set=model.positions=4", "--set=model.offsets=2"];
    said(&here, &[&["run", case, "-o", "r", "-q"][..], &few].concat());
    std::fs::remove_file(here.path("r/report.html")).unwrap();
    assert!(said(&here, &["report", "r/result.json"]).contains("report.html"));
    assert!(here.path("r/report.html").is_file());
}

#[test]
fn a_comparison_needs_two_finishes_and_files_that_are_there() {
    let here = Bench::new();
    said(&here, &["demo", "-q"]);
    let refused = |arguments: &[&str], code: &str| {
        let mut all = vec!["compare", "demo/case.toml"];
        all.extend(arguments);
        let said = here.run(&all);
        assert_eq!(said.status, 2, "{}", said.err);
        assert!(said.err.contains(code), "{}", said.err);
        assert!(!here.path("results").exists(), "nothing is left behind");
    };
    refused(&["--finish", "a=demo/case.toml"], "E205");
    refused(&["--finish", "a=no.csv", "--finish", "b=no.csv"], "E103");
    refused(&["--finish", "nothing"], "ground=pinion.csv,wheel.csv");
}

#[test]
fn every_shell_gets_completions_and_man_a_page_of_every_command() {
    let here = Bench::new();
    for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
        let text = said(&here, &["completions", shell]);
        assert!(
            text.contains("asperity") && text.contains("compare"),
            "{shell}"
        );
    }
    let page = said(&here, &["completions", "man"]);
    for command in ["RUN", "REPORT", "COMPARE", "FIGURES", "PROFILE", "DEMO"] {
        assert!(page.contains(&format!("ASPERITY {command}")), "{command}");
    }
    assert!(page.contains("\\-\\-finish"));
}
