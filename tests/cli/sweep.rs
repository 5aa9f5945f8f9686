//! Sweeps through the command: shards, restarts, merge, effects.

use std::fs;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use asperity::message::outside_codes;

use crate::bench::{Bench, E_DRIVE, program};

fn bench(study: &str) -> Bench {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("case.toml", E_DRIVE);
    bench.write("study.toml", study);
    bench
}

const STUDY: &str = r#"case = "case.toml"
columns = ["loss_w", "efficiency"]

[[axis]]
key = "operation.torque"
values = ["-100 N m", "100 N m"]

[[axis]]
name = "finish"
choice.one = { "surface.wheel.mirrored" = true }
choice.other = { "surface.wheel.mirrored" = false }

[sample]
method = "sobol"
count = 16
seed = 1
vary."model.boundary_friction" = { uniform = [0.06, 0.10] }
vary."gears.profile_shift.0" = { triangular = [-0.02, 0.0, 40.0] }
vary."lubricant.viscosity.at_100" = { normal = ["5.9 mm2/s", "0.15 mm2/s"] }
"#;

/// Cheap cases: flanks known by a value and a formula of the load share, so that no contact is solved.
const QUICK: &str = r#"case = "quick.toml"
columns = ["loss_w"]

[sample]
method = "latin-hypercube"
count = 90
vary."operation.bulk_temperature" = { uniform = ["60 °C", "100 °C"] }
"#;

fn quick() -> Bench {
    let bench = bench(QUICK);
    let case = E_DRIVE
        .replace(
            "pinion = { file = \"pinion.csv\" }",
            "pinion = { rq = \"0.3 um\" }",
        )
        .replace(
            "wheel = { file = \"wheel.csv\", mirrored = true }",
            "wheel = { rq = \"0.3 um\" }",
        )
        .replace("[model]", "[model]\nload_share = \"lambda-star\"");
    bench.write("quick.toml", case);
    bench
}

fn sum_of(bench: &Bench, parts: &str) -> String {
    let target = format!("out-{parts}");
    let arguments = [
        "sweep",
        "merge",
        "study.toml",
        "--parts",
        parts,
        "-o",
        &target,
        "--json",
    ];
    let json = bench.run(&arguments).well().json();
    json["sha256"].as_str().unwrap().to_owned()
}

#[test]
fn shards_and_threads_give_the_same_table() {
    let bench = quick();
    bench
        .run(&[
            "sweep",
            "run",
            "study.toml",
            "--parts",
            "one",
            "--threads",
            "1",
        ])
        .well();
    for shards in [3, 7] {
        let parts = format!("of-{shards}");
        for shard in 1..=shards {
            let shard = format!("{shard}/{shards}");
            let arguments = [
                "sweep",
                "run",
                "study.toml",
                "--parts",
                &parts,
                "--shard",
                &shard,
                "--quiet",
            ];
            bench.run(&arguments).well();
        }
        assert_eq!(sum_of(&bench, &parts), sum_of(&bench, "one"));
    }
}

#[cfg(unix)]
#[test]
fn a_signal_closes_the_open_part_with_the_rows_that_are_finished() {
    const CASES: u64 = 64;
    let bench = bench(STUDY);
    let run = |parts: &str| {
        Command::new(program())
            .args(["sweep", "run", "study.toml", "--parts", parts, "--quiet"])
            .current_dir(bench.path(""))
            .stderr(Stdio::piped())
            .spawn()
            .unwrap()
    };
    let begin = Instant::now();
    assert!(run("whole").wait().unwrap().success());
    let whole = begin.elapsed();
    // All cases make a single part, which a signal used to discard. A busy machine may be too slow or too fast.
    let in_the_middle = |(signal, parts): (&str, &str)| {
        (1..=8).any(|eighth| {
            let child = run(parts);
            std::thread::sleep(whole * (9 - eighth) / 9);
            let sent = Command::new("kill")
                .args([signal, &child.id().to_string()])
                .status();
            assert!(sent.is_ok());
            let ended = child.wait_with_output().unwrap();
            let err = String::from_utf8(ended.stderr).unwrap();
            let status = [
                "sweep",
                "run",
                "study.toml",
                "--status",
                "--parts",
                parts,
                "--json",
            ];
            let done = match bench.run(&status).json()["done"].as_u64() {
                Some(done @ 1..CASES) => done,
                _ => {
                    let _ = fs::remove_dir_all(bench.path(parts));
                    return false;
                }
            };
            assert_eq!(ended.status.code(), Some(130), "{err}");
            let says = format!("E502 interrupted: {done} of {CASES} cases are done");
            assert!(err.starts_with(&says), "{err}");
            true
        })
    };
    for signal in [("-INT", "interrupted"), ("-TERM", "terminated")] {
        assert!(in_the_middle(signal), "{signal:?}");
    }
    assert!(run("interrupted").wait().unwrap().success());
    assert_eq!(sum_of(&bench, "interrupted"), sum_of(&bench, "whole"));
}

#[test]
fn every_table_of_cases_has_the_codes_of_inputs_outside_of_their_ranges() {
    let study = "case = \"case.toml\"\n[[axis]]\nkey = \"operation.bulk_temperature\"\nvalues = [\"90 °C\", \"250 °C\"]\n";
    let bench = bench(study);
    let hot = ["--set", "operation.bulk_temperature=250 °C"];
    let run = ["run", "case.toml", "--no-output", "--no-band", "--json"];
    let outside_in_run = |more: &[&str]| {
        let run = bench.run(&[&run[..], more].concat()).well().json();
        let codes = run["warnings"].as_array().unwrap().iter();
        outside_codes(codes.map(|warning| warning["code"].as_str().unwrap().parse().unwrap()))
    };
    let in_runs = [outside_in_run(&[]), outside_in_run(&hot)];
    assert!(in_runs[1].contains("W401"), "{in_runs:?}");
    let cells = |file: &str| -> Vec<String> {
        let mut table = csv::Reader::from_path(bench.path(file)).unwrap();
        let headers = table.headers().unwrap().clone();
        let column = headers.iter().position(|name| name == "outside").unwrap();
        let rows = table.records().map(|row| row.unwrap()[column].to_owned());
        rows.collect()
    };
    bench.run(&["sweep", "run", "study.toml", "-q"]).well();
    let merge = ["sweep", "merge", "study.toml", "-o", "out"];
    let said = bench.run(&merge).well().out;
    assert_eq!(cells("out/sweep.csv"), in_runs);
    assert!(said.contains("W401 in "), "{said}");
    let finishes = ["--finish", "a=pinion.csv", "--finish", "b=wheel.csv"];
    let compare = ["compare", "case.toml", "-o", "compared", "-q"];
    bench.run(&[&compare[..], &finishes, &hot].concat()).well();
    assert!(
        cells("compared/compare.csv")
            .iter()
            .all(|cell| cell.contains("W401"))
    );
}

#[test]
fn a_plan_of_a_million_cases_checks_corners_and_a_sample() {
    // The last torque is refused: only a corner or a large part of the sample finds it.
    let study = "case = \"quick.toml\"\ncolumns = [\"loss_w\"]\n\
        [[axis]]\nkey = \"operation.torque\"\nvalues = [\"80 N m\", \"90 N m\", \"1e300 N m\"]\n\
        [sample]\nmethod = \"latin-hypercube\"\ncount = 350000\n\
        vary.\"operation.bulk_temperature\" = { uniform = [\"60 °C\", \"100 °C\"] }\n";
    let bench = quick();
    bench.write("study.toml", study);
    let begin = Instant::now();
    let plan = bench
        .run(&["sweep", "run", "study.toml", "--plan"])
        .well()
        .out;
    // A case takes 2 ms; all of them take half an hour.
    assert!(begin.elapsed() < Duration::from_secs(120));
    assert!(
        plan.contains("1050000 cases: 3 on the axes x 350000 of the sample"),
        "{plan}"
    );
    assert!(
        plan.contains(" of them: the corners of the axes and a sample"),
        "{plan}"
    );
    assert!(plan.contains("E212 in "), "{plan}");
}

#[test]
fn missing_cases_are_told_with_status_3_and_a_restart_runs_them() {
    let bench = quick();
    let part = ["sweep", "run", "study.toml", "--shard", "1/2"];
    bench.run(&part).well();
    let status = bench.run(&["sweep", "run", "study.toml", "--status"]);
    assert_eq!(status.status, 3);
    assert!(status.out.contains("45 of 90 cases done"), "{}", status.out);
    assert!(
        status.err.starts_with("E309 45 of 90 cases"),
        "{}",
        status.err
    );
    bench
        .run(&["sweep", "merge", "study.toml"])
        .refused(3, "E309", &["2,4,6"]);
    let rest = bench.run(&["sweep", "run", "study.toml"]).well();
    assert!(rest.out.starts_with("ran 45 cases"), "{}", rest.out);
    bench
        .run(&["sweep", "run", "study.toml", "--status"])
        .well();
    bench
        .run(&["sweep", "merge", "study.toml", "-o", "out"])
        .well();
    let table = fs::read_to_string(bench.path("out/sweep.csv")).unwrap();
    assert_eq!(table.lines().count(), 91);
    assert!(table.starts_with("case,id,operation.bulk_temperature [°C],loss_w,outside,code\n0,"));
}

#[test]
fn a_killed_sweep_goes_on_and_ends_with_the_same_table() {
    let bench = quick();
    bench
        .run(&["sweep", "run", "study.toml", "--parts", "whole", "--quiet"])
        .well();
    for kill in 0..6 {
        let mut child = Command::new(program())
            .args(["sweep", "run", "study.toml", "--parts", "killed", "--quiet"])
            .current_dir(bench.path(""))
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        std::thread::sleep(Duration::from_millis(5 + 23 * kill % 67));
        let _ = child.kill();
        child.wait().unwrap();
    }
    bench
        .run(&["sweep", "run", "study.toml", "--parts", "killed", "--quiet"])
        .well();
    assert_eq!(sum_of(&bench, "killed"), sum_of(&bench, "whole"));
}

#[test]
fn failed_cases_are_rows_with_their_code_and_the_rest_has_effects() {
    let bench = bench(STUDY);
    let plan = bench
        .run(&["sweep", "run", "study.toml", "--plan", "--json"])
        .well()
        .json();
    assert_eq!(plan["cases"], 2 * 2 * 16);
    assert!(
        plan["refused"]
            .as_object()
            .is_some_and(|refused| !refused.is_empty()),
        "{plan}"
    );
    // Told before the first case is run, with the first refusal of each code.
    let said = bench.run(&["sweep", "run", "study.toml"]);
    assert_eq!(said.status, 0, "{}", said.err);
    let told = said.err;
    for (code, refused) in plan["refused"].as_object().unwrap() {
        let line = format!(
            "{code} in {} cases, the first is case {}",
            refused["count"], refused["first"]
        );
        assert!(told.starts_with("W430 ") && told.contains(&line), "{told}");
    }
    bench
        .run(&["sweep", "merge", "study.toml", "-o", "out"])
        .well();
    let table = fs::read_to_string(bench.path("out/sweep.csv")).unwrap();
    let rows: Vec<Vec<&str>> = table
        .lines()
        .skip(1)
        .map(|line| line.split(',').collect())
        .collect();
    assert_eq!(rows.len(), 64);
    let failed = rows
        .iter()
        .filter(|row| row.last().is_some_and(|code| code.starts_with('E')));
    assert!((1..64).contains(&failed.count()));
    // Every case with a result has an id of its own.
    let ids: std::collections::BTreeSet<&str> = rows
        .iter()
        .map(|row| row[1])
        .filter(|id| !id.is_empty())
        .collect();
    assert_eq!(
        ids.len(),
        rows.iter().filter(|row| !row[1].is_empty()).count()
    );
    assert!(ids.iter().all(|id| id.len() == 16));
}

#[test]
fn unknown_keys_and_columns_are_refused_before_the_first_case() {
    let bench = quick();
    let head = "case = \"quick.toml\"\n";
    let axis = |key: &str| format!("[[axis]]\nkey = \"{key}\"\nvalues = [\"90 N m\"]\n");
    let choice =
        "[[axis]]\nname = \"a\"\nchoice.one = { title = \"1\" }\nchoice.two = { titel = \"2\" }\n";
    let sample = "[sample]\nmethod = \"sobol\"\ncount = 2\n";
    let columns = |names: &str| format!("columns = [{names}]\n{}", axis("operation.torque"));
    for (text, says) in [
        (
            axis("operation.torqe"),
            ["\"operation.torqe\"", "\"torque\""],
        ),
        (
            axis("gears.profil_shift.0"),
            ["\"gears.profil_shift\"", "\"profile_shift\""],
        ),
        (choice.to_owned(), ["\"titel\"", "\"title\""]),
        (
            format!(
                "{sample}vary.\"operation.sped\" = {{ uniform = [\"1 1/min\", \"2 1/min\"] }}\n"
            ),
            ["\"operation.sped\"", "\"speed\""],
        ),
        (
            columns("\"loss_w\", \"loss_p0_w\""),
            ["\"loss_p0_w\"", "\"loss_p05_w\""],
        ),
        (
            columns("\"efficency\""),
            ["\"efficency\"", "\"efficiency\""],
        ),
        // An array and a text of the summary are not columns.
        (
            columns("\"deformation_w\""),
            ["\"deformation_w\"", "study.toml"],
        ),
        (columns("\"scope\""), ["\"scope\"", "study.toml"]),
    ] {
        bench.write("study.toml", format!("{head}{text}"));
        let said = bench.run(&["sweep", "run", "study.toml"]);
        said.refused(2, "E203", &says);
        assert!(!bench.path("parts").exists());
    }
}

#[test]
fn a_study_without_a_single_result_has_the_exit_status_of_its_cases() {
    let bench = quick();
    let study = |torques: &str| {
        let axis = format!("[[axis]]\nkey = \"operation.torque\"\nvalues = [{torques}]\n");
        bench.write("study.toml", format!("case = \"quick.toml\"\n{axis}"));
    };
    study("\"90 Nm/s\", \"95 s\"");
    for arguments in [
        &["sweep", "run", "study.toml", "--quiet"][..],
        &["sweep", "run", "study.toml", "--status"],
        &["sweep", "merge", "study.toml", "-o", "out"],
    ] {
        let said = bench.run(arguments);
        said.failed(2, "E204", &["none of 2 cases has a result: E204 in 2"]);
    }
    assert!(bench.path("out/sweep.csv").exists());
    let json = bench.run(&["sweep", "run", "study.toml", "--status", "--json"]);
    assert_eq!((json.status, json.json()["done"].as_u64()), (2, Some(2)));
    // A single case with a result is enough.
    study("\"90 N m\", \"95 s\"");
    assert_eq!(
        bench.run(&["sweep", "run", "study.toml", "--quiet"]).status,
        0
    );
}

#[test]
fn indices_of_a_study_tell_which_input_matters() {
    let study = r#"case = "case.toml"
columns = ["boundary_w"]
[sample]
method = "sobol"
count = 16
indices = true
vary."model.boundary_friction" = { uniform = [0.06, 0.10] }
vary."model.hysteresis" = { uniform = [0.009, 0.011] }
"#;
    let bench = bench(study);
    bench.run(&["sweep", "run", "study.toml", "--quiet"]).well();
    let json = bench
        .run(&["sweep", "merge", "study.toml", "-o", "out", "--json"])
        .well()
        .json();
    let effects = json["effects"].as_array().unwrap();
    let of = |input: &str| effects.iter().find(|row| row["input"] == input).unwrap();
    // The boundary loss is as good as proportional to its coefficient and knows no hysteresis.
    let friction = &of("model.boundary_friction")["indices"];
    assert!(
        (friction["first"].as_f64().unwrap() - 1.0).abs() < 0.1,
        "{friction}"
    );
    assert_eq!(of("model.hysteresis")["indices"]["total"], 0.0);
    assert!(
        fs::read_to_string(bench.path("out/sweep.html"))
            .unwrap()
            .contains("Effects on boundary loss")
    );
}

#[test]
fn what_makes_no_study_is_refused() {
    let bench = bench("case = \"case.toml\"\nwrong = 1\n");
    bench
        .run(&["sweep", "run", "study.toml"])
        .refused(2, "E202", &["study.toml", "wrong"]);
    bench.write(
        "study.toml",
        "case = \"case.toml\"\n[[axis]]\nkey = \"operation.torque\"\n",
    );
    bench
        .run(&["sweep", "run", "study.toml"])
        .refused(2, "E204", &["operation.torque", "values"]);
    bench
        .run(&["sweep", "run", "none.toml"])
        .refused(2, "E103", &["none.toml"]);
    let axis = "[[axis]]\nkey = \"operation.torque\"\nfrom = \"1 N m\"\nto = \"9 N m\"\n";
    for (text, says) in [
        (format!("{axis}count = 4294967296\n"), "2 to 1000000"),
        (format!("{axis}count = 4000\n").repeat(2), "are more than"),
        (format!("{axis}count = 2\n").repeat(2), "from two axes"),
        (
            "[sample]\nmethod = \"latin-hypercube\"\ncount = 4294967296\n[sample.vary]\n\"operation.torque\" = { uniform = [\"1 N m\", \"9 N m\"] }\n".to_owned(),
            "1 to 1000000",
        ),
    ] {
        bench.write("study.toml", format!("case = \"case.toml\"\n{text}"));
        bench
            .run(&["sweep", "run", "study.toml", "--plan"])
            .refused(2, "E204", &[says]);
    }
    bench.write("study.toml", "case = \"case.toml\"\n");
    bench
        .run(&["sweep", "run", "study.toml", "--shard", "3/2"])
        .refused(2, "E209", &["3/2"]);
}
