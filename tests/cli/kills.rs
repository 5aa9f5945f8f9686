//! Kills and signals at any moment: no half file, no lost result, nothing left behind.

use std::fs;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::Duration;

use crate::bench::{Bench, E_DRIVE, program};

/// Kills of each command; `ASPERITY_KILLS` asks for more, as 200.
fn kills() -> u64 {
    const FEW: u64 = 3;
    let wanted = std::env::var("ASPERITY_KILLS").ok();
    wanted.and_then(|text| text.parse().ok()).unwrap_or(FEW)
}

fn start(bench: &Bench, arguments: &[&str]) -> Child {
    Command::new(program())
        .args(arguments)
        .current_dir(bench.path(""))
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap()
}

fn drafts(bench: &Bench) -> Vec<String> {
    let mut names = bench.listing();
    names.retain(|name| name.starts_with(".asperity-"));
    names
}

fn bench() -> Bench {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("case.toml", E_DRIVE);
    bench
}

/// Kills `arguments` after times spread over the time of a whole run, and checks with `whole` what is
/// there after each.
fn kill(bench: &Bench, arguments: &[&str], whole: impl Fn()) {
    let begin = std::time::Instant::now();
    bench.run(arguments).well();
    let time = begin.elapsed().as_micros() as u64;
    let count = kills();
    for k in 0..count {
        // The golden ratio spreads any number of moments evenly; the last part writes.
        let share = (0.618_034 * (k + 1) as f64).fract().sqrt();
        let mut child = start(bench, arguments);
        std::thread::sleep(Duration::from_micros((share * time as f64) as u64));
        let _ = child.kill();
        child.wait().unwrap();
        whole();
    }
    // The next start clears up, and works; a draft that was killed before it had its lock is taken for
    // one that is being made for some seconds.
    bench.run(arguments).well();
    if !drafts(bench).is_empty() {
        std::thread::sleep(Duration::from_secs(6));
        bench.run(arguments).well();
    }
    assert_eq!(drafts(bench), Vec::<String>::new());
    whole();
}

fn is_json(file: &Path) {
    let text = fs::read_to_string(file).unwrap();
    serde_json::from_str::<serde_json::Value>(&text).unwrap();
}

fn is_page(file: &Path) {
    assert!(fs::read_to_string(file).unwrap().ends_with("</html>"));
}

#[test]
fn a_killed_run_leaves_the_older_result() {
    let bench = bench();
    kill(&bench, &["run", "case.toml", "-o", "out"], || {
        // The name is never lost, not even for a moment: the system exchanges two names at once.
        if cfg!(target_os = "linux") {
            is_json(&bench.path("out/result.json"));
            is_page(&bench.path("out/report.html"));
        }
    });
}

#[test]
fn a_killed_report_leaves_a_whole_page() {
    let bench = bench();
    bench.run(&["run", "case.toml", "-o", "out", "-q"]).well();
    kill(&bench, &["report", "out"], || {
        is_page(&bench.path("out/report.html"))
    });
    // And what was killed in the middle is still a result that may be replaced.
    bench.run(&["run", "case.toml", "-o", "out", "-q"]).well();
}

#[test]
fn a_killed_comparison_leaves_the_older_one() {
    let bench = bench();
    let arguments = [
        "compare",
        "case.toml",
        "--finish",
        "a=pinion.csv",
        "--finish",
        "b=wheel.csv",
        "--offsets",
        "2",
        "-o",
        "out",
    ];
    kill(&bench, &arguments, || {
        if cfg!(target_os = "linux") {
            is_json(&bench.path("out/compare.json"));
            is_page(&bench.path("out/compare.html"));
        }
    });
}

#[test]
fn a_killed_conversion_leaves_the_older_file() {
    let bench = bench();
    let lines = |name: &str| {
        fs::read_to_string(bench.path(name))
            .unwrap()
            .lines()
            .count()
    };
    bench
        .run(&["profile", "convert", "pinion.csv", "out.csv"])
        .well();
    let whole = lines("out.csv");
    kill(
        &bench,
        &["profile", "convert", "pinion.csv", "out.csv"],
        || {
            assert_eq!(lines("out.csv"), whole);
        },
    );
}

#[cfg(unix)]
#[test]
fn a_signal_leaves_nothing_behind() {
    let bench = bench();
    bench.write("case.toml", E_DRIVE.replace("offsets = 2", "offsets = 32"));
    bench.run(&["run", "case.toml", "-o", "out", "-q"]).well();
    let before = fs::read(bench.path("out/result.json")).unwrap();
    for (k, signal) in ["-INT", "-TERM", "-INT", "-TERM"].into_iter().enumerate() {
        let mut child = start(&bench, &["run", "case.toml", "-o", "out"]);
        std::thread::sleep(Duration::from_millis(40 + 45 * k as u64));
        let sent = Command::new("kill")
            .args([signal, &child.id().to_string()])
            .status();
        assert!(sent.is_ok());
        child.wait().unwrap();
        assert_eq!(drafts(&bench), Vec::<String>::new(), "{signal}");
        assert_eq!(fs::read(bench.path("out/result.json")).unwrap(), before);
    }
}
