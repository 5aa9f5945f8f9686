//! Promises about results: whole or not at all, the same in a file and on the screen, quiet on request.

use std::fs;
use std::io::Read;
use std::process::{Command, Stdio};
use std::time::Duration;

use crate::bench::{Bench, E_DRIVE, program, root};

fn small_case() -> Bench {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("case.toml", E_DRIVE);
    bench
}

#[test]
fn the_demo_runs_as_it_is_written() {
    let bench = Bench::new();
    let said = bench.run(&["demo"]).well();
    assert!(
        said.out.contains("next: asperity run demo/case.toml"),
        "{}",
        said.out
    );
    let few = ["--set", "model.positions=2", "--set", "model.offsets=2"];
    let run = [&["run", "demo/case.toml", "--no-band"], &few[..]].concat();
    let said = bench.run(&run).well();
    assert!(
        said.out.contains("efficiency (mesh only)  99."),
        "{}",
        said.out
    );
    assert!(
        said.out.contains("SYNTHETIC") || said.out.contains("synthetic"),
        "{}",
        said.out
    );
    assert!(bench.path("results/demo-case/result.json").is_file());
    bench
        .run(&["demo"])
        .refused(2, "E401", &["demo: exists already"]);
    let named = bench
        .run(&["demo", "my first/case", "--json"])
        .well()
        .json();
    assert_eq!(named["folder"], "my first/case");
    let files = named["files"].as_array().unwrap();
    assert!(files.iter().all(|file| {
        bench
            .path("my first/case")
            .join(file.as_str().unwrap())
            .is_file()
    }));
}

#[test]
fn json_on_the_screen_is_the_result_file() {
    let bench = small_case();
    let said = bench
        .run(&["run", "case.toml", "-o", "out", "--json"])
        .well();
    assert_eq!(
        said.out,
        fs::read_to_string(bench.path("out/result.json")).unwrap()
    );
    let result = said.json();
    assert_eq!(
        result["schema_version"].as_u64(),
        Some(u64::from(asperity::result::SCHEMA_VERSION))
    );
    assert!(result["summary"]["efficiency"].as_f64().unwrap() > 0.9);
    for flank in result["flanks"].as_array().unwrap() {
        assert_eq!(flank["sha256"].as_str().unwrap().len(), 64);
    }
    // Nothing of the machine or of the day: the same case gives the same file.
    bench
        .run(&["run", "case.toml", "-o", "again", "--quiet"])
        .well();
    let again = fs::read_to_string(bench.path("again/result.json")).unwrap();
    assert_eq!(again, said.out);
}

#[test]
fn quiet_says_nothing_but_errors() {
    let bench = small_case();
    for arguments in [
        &["run", "case.toml", "-o", "out", "--no-band", "--quiet"][..],
        &["-q", "gear", "case.toml"],
        &["film", "case.toml", "-q"],
        &["contact", "case.toml", "-q"],
        &["profile", "info", "pinion.csv", "-q"],
        &["demo", "-q"],
    ] {
        assert_eq!(bench.run(arguments).well().out, "", "{arguments:?}");
    }
    bench
        .run(&["run", "nosuch.toml", "-q"])
        .refused(2, "E201", &["nosuch.toml"]);
}

#[test]
fn an_older_result_is_replaced_as_a_whole() {
    let bench = small_case();
    bench.write(
        "case.toml",
        E_DRIVE.replace("positions = 2", "positions = 3"),
    );
    let run = ["run", "case.toml", "-o", "out", "-q", "--no-band"];
    bench.run(&[&run[..], &["--fields", "all"]].concat()).well();
    assert!(bench.path("out/position_03").is_dir());
    bench.write("case.toml", E_DRIVE);
    bench.run(&run).well();
    assert!(!bench.path("out/position_03").exists());
    assert_eq!(
        bench.listing(),
        ["case.toml", "out", "pinion.csv", "wheel.csv"]
    );
}

#[test]
fn folders_on_the_way_are_made_and_blanks_in_names_do_no_harm() {
    let bench = Bench::new();
    fs::create_dir(bench.path("with blank")).unwrap();
    bench.write("with blank/case.toml", E_DRIVE);
    let flanks = small_case();
    for name in ["pinion.csv", "wheel.csv"] {
        fs::copy(flanks.path(name), bench.path("with blank").join(name)).unwrap();
    }
    let said = bench
        .run(&[
            "run",
            "with blank/case.toml",
            "--no-band",
            "-o",
            "new/and deep/out",
        ])
        .well();
    assert!(
        said.out.contains("report: new/and deep/out/report.html"),
        "{}",
        said.out
    );
    assert!(bench.path("new/and deep/out/result.json").is_file());
    bench
        .run(&["run", "with blank/case.toml", "--no-band"])
        .well();
    let folder = "results/with blank-case/result.json";
    assert!(bench.path(folder).is_file());
}

#[test]
fn no_output_writes_nothing() {
    let bench = small_case();
    let before = bench.listing();
    let said = bench
        .run(&["run", "case.toml", "--no-output", "--no-band"])
        .well();
    assert!(!said.out.contains("report:"), "{}", said.out);
    assert_eq!(bench.listing(), before);
}

#[test]
fn every_default_used_is_listed_on_request() {
    let bench = small_case();
    let run = |more: &[&str]| {
        let run = ["run", "case.toml", "--no-output", "--no-band"];
        bench.run(&[&run[..], more].concat()).well()
    };
    let result = run(&["--json"]).json();
    let defaults = result["defaults"].as_array().unwrap();
    let said = run(&["--notes"]).out;
    let count = format!("defaults used: {} (--explain-defaults)", defaults.len());
    assert!(said.contains(&count), "{said}");
    let said = run(&["--explain-defaults"]).out;
    for default in defaults {
        let line = format!(
            "  {} = {}",
            default["key"].as_str().unwrap(),
            default["value"].as_str().unwrap()
        );
        assert!(said.contains(&line), "{line} is not in {said}");
    }
}

#[cfg(unix)]
#[test]
fn a_folder_that_may_not_be_written_to_stays_as_it_was() {
    use std::os::unix::fs::PermissionsExt;
    let bench = small_case();
    let place = bench.path("locked");
    fs::create_dir(&place).unwrap();
    fs::set_permissions(&place, fs::Permissions::from_mode(0o555)).unwrap();
    let is_locked = fs::write(place.join("probe"), "").is_err();
    let said = bench.run(&["run", "case.toml", "--no-band", "-o", "locked/out"]);
    let left = fs::read_dir(&place).unwrap().count();
    fs::set_permissions(&place, fs::Permissions::from_mode(0o755)).unwrap();
    // The superuser may write anywhere: then there is nothing to refuse.
    if is_locked {
        said.refused(2, "E401", &["locked"]);
        assert_eq!(left, 0);
    } else {
        said.well();
    }
}

#[test]
fn a_run_that_is_killed_leaves_a_whole_result_or_none() {
    let bench = small_case();
    bench.write("case.toml", E_DRIVE.replace("offsets = 2", "offsets = 32"));
    for milliseconds in [20, 60, 120] {
        let mut run = Command::new(program())
            .args(["run", "case.toml", "-o", "out", "-q", "--no-band"])
            .current_dir(bench.path(""))
            .spawn()
            .unwrap();
        std::thread::sleep(Duration::from_millis(milliseconds));
        run.kill().unwrap();
        run.wait().unwrap();
        let out = bench.path("out");
        if out.exists() {
            let text = fs::read_to_string(out.join("result.json")).unwrap();
            assert!(serde_json::from_str::<serde_json::Value>(&text).is_ok());
            assert!(out.join("report.html").is_file());
            fs::remove_dir_all(out).unwrap();
        }
    }
}

#[test]
fn a_reader_that_goes_away_is_no_fault() {
    for arguments in [
        &["equations"][..],
        &["schema"],
        &["equations", "--markdown"],
        &["explain"],
    ] {
        let mut run = Command::new(program())
            .args(arguments)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        drop(run.stdout.take());
        let mut said = String::new();
        run.stderr
            .take()
            .unwrap()
            .read_to_string(&mut said)
            .unwrap();
        assert_eq!(run.wait().unwrap().code(), Some(0), "{said}");
        assert_eq!(said, "");
    }
}

#[test]
fn no_colour_comes_out_of_a_pipe() {
    let bench = small_case();
    for environment in [&[][..], &[("NO_COLOR", "1")], &[("TERM", "xterm-256color")]] {
        let said = bench.run_with(
            &["run", "case.toml", "--no-output", "--no-band"],
            environment,
        );
        assert!(!said.out.contains('\u{1b}') && !said.err.contains('\u{1b}'));
        let said = bench.run_with(&["run", "nosuch.toml"], environment);
        assert!(!said.err.contains('\u{1b}'), "{}", said.err);
    }
}

#[test]
fn the_first_screen_has_at_most_ten_lines_of_80_columns_and_the_rest_is_behind_notes() {
    let folder = root().join("fixtures/cases");
    for entry in fs::read_dir(folder).unwrap() {
        let case = entry.unwrap().path();
        let bench = Bench::new();
        let run = |more: &[&str]| {
            let run = ["run", case.to_str().unwrap(), "--no-output"];
            let few = ["--set", "model.positions=4", "--set", "model.offsets=2"];
            bench.run(&[&run[..], &few, more].concat()).well().out
        };
        let (said, whole) = (run(&[]), run(&["--notes"]));
        // Messages are lines of their own, as long as what they say.
        let paper = run(&["--notes", "--formulation", "paper"]);
        for line in whole.lines().chain(paper.lines()) {
            assert!(
                line.starts_with('W') || line.chars().count() <= 80,
                "{line}"
            );
        }
        assert!(said.lines().count() <= 10, "{said}");
        assert!(said.lines().filter(|line| line.starts_with('W')).count() <= 1);
        for behind in ["power in ", "mu_eq ", "H_V ", "solved  ", "defaults used: "] {
            assert!(whole.contains(behind), "{behind}: {whole}");
            assert!(!said.contains(&format!("\n{behind}")), "{behind}: {said}");
        }
    }
}

#[test]
fn a_result_of_another_case_is_not_replaced_unless_it_is_named() {
    let bench = small_case();
    let run = ["run", "case.toml", "--no-band"];
    let first = bench.run(&run).well().out;
    assert!(
        first.ends_with("notes: --notes\n")
            && first.contains("\nreport: results/case/report.html ")
    );
    let again = bench.run(&run).well().out;
    assert!(
        again.contains("\nreplaced results/case (same title)\n"),
        "{again}"
    );
    let before = fs::read_to_string(bench.path("results/case/result.json")).unwrap();
    bench.write("case.toml", E_DRIVE.replace("small case", "other case"));
    let refused = ["results/case: holds the result of another case (small case)"];
    bench
        .run(&["run", "case.toml"])
        .refused(2, "E401", &refused);
    let kept = fs::read_to_string(bench.path("results/case/result.json")).unwrap();
    assert_eq!(kept, before);
    let named = bench
        .run(&[&run[..], &["-o", "results/case"]].concat())
        .well()
        .out;
    assert!(
        named.contains("\nreplaced results/case (small case)\n"),
        "{named}"
    );
}

/// Studies as runs: the folder of another case stays, unless the user names it.
#[test]
fn a_study_of_another_case_is_not_replaced_unless_it_is_named() {
    let bench = small_case();
    // Whose contacts are not solved.
    let small = E_DRIVE.replace("[model]", "[model]\nload_share = \"lambda-star\"");
    bench.write("case.toml", &small);
    let studies: [&[&str]; 3] = [
        &["sensitivity", "case.toml", "--set", "model.positions=2"],
        &[
            "map",
            "case.toml",
            "--torque",
            "100,200",
            "--speed",
            "1000,3000",
            "--band",
            "none",
        ],
        &[
            "compare",
            "case.toml",
            "--finish",
            "a=pinion.csv",
            "--finish",
            "b=wheel.csv",
        ],
    ];
    for study in studies {
        bench.run(study).well();
    }
    bench.write("case.toml", small.replace("small case", "other case"));
    for study in studies {
        let folder = format!("results/case-{}", study[0]);
        let refused = format!("{folder}: holds the result of another case (small case)");
        bench.run(study).refused(2, "E401", &[&refused]);
        bench.run(&[study, &["-o", &folder]].concat()).well();
        bench.run(study).well();
    }
    // Without titles the gears tell the cases apart.
    let untitled = E_DRIVE.replace("title = \"small case\"", "");
    bench.write("untitled.toml", &untitled);
    bench.run(&["run", "untitled.toml", "--no-band"]).well();
    bench.write("untitled.toml", untitled.replace("[23, 68]", "[24, 68]"));
    let refused =
        "results/untitled: holds the result of another case (untitled, 23/68 teeth, module 1.8 mm)";
    bench
        .run(&["run", "untitled.toml"])
        .refused(2, "E401", &[refused]);
}

/// The power behind `name` in a line of the summary \[W\]; 0 for one below the last place.
fn power(text: &str, name: &str) -> f64 {
    let rest = text.split(name).nth(1).unwrap().trim_start();
    match rest.strip_prefix("< ") {
        Some(_) => 0.0,
        None => rest.split(' ').next().unwrap().parse().unwrap(),
    }
}

#[test]
fn parts_of_the_loss_add_up_as_printed() {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("case.toml", E_DRIVE);
    for (torque, more) in [(40, &[][..]), (145, &[]), (200, &[]), (145, &["--no-band"])] {
        let set = format!("operation.torque={torque} N m");
        let run = ["run", "case.toml", "--no-output", "--set", &set];
        let said = bench.run(&[&run[..], more].concat()).well().out;
        let loss = power(&said, "   loss ");
        // The boundary layer is a part of the asperities.
        let names = ["film ", "asperities ", "rolling "];
        let line = said.lines().find(|line| line.starts_with("film ")).unwrap();
        let parts = names.map(|name| power(line, name));
        assert!((parts.iter().sum::<f64>() - loss).abs() < 1e-9, "{said}");
    }
}

#[test]
fn the_rows_of_the_path_multiply_to_the_sliding_loss() {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("case.toml", E_DRIVE);
    let json = bench
        .run(&["run", "case.toml", "-o", "out", "--no-band", "--json"])
        .well();
    let expected = json.json()["summary"]["sliding_w"].as_f64().unwrap();
    let text = fs::read_to_string(bench.path("out/path.csv")).unwrap();
    let mut lines = text.lines();
    let header: Vec<&str> = lines.next().unwrap().split(',').collect();
    let column = |name: &str| header.iter().position(|found| *found == name).unwrap();
    let columns = ["mu", "sliding_load_n_per_mm", "sliding_m_per_s", "weight_m"].map(column);
    let sum: f64 = lines
        .map(|line| {
            let cells: Vec<&str> = line.split(',').collect();
            let factors = columns.map(|at| cells[at].parse::<f64>().unwrap().abs());
            1e3 * factors.iter().product::<f64>()
        })
        .sum();
    assert!((sum / expected - 1.0).abs() < 1e-9, "{sum} {expected}");
}
