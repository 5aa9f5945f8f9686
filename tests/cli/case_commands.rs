//! Commands that read a case without a run: `--set`, standard input, `check`; and the lists of the library.

use std::process::Command;

use crate::bench::{Bench, E_DRIVE, program, root, with_line};

fn bench() -> Bench {
    let bench = Bench::new();
    bench.write("case.toml", E_DRIVE);
    bench.write_flanks();
    bench
}

#[test]
fn a_key_set_past_the_case_is_the_same_key_in_the_case() {
    let bench = bench();
    bench.write("other.toml", with_line("torque", "torque = \"200 N m\""));
    let run = |arguments: &[&str]| bench.run(arguments).well().json()["summary"].clone();
    let quick = ["--no-output", "--no-band", "--json"];
    let run = |file: &str, more: &[&str]| run(&[&["run", file], &quick[..], more].concat());
    let set = run("case.toml", &["--set", "operation.torque=200 N m"]);
    assert_eq!(set, run("other.toml", &[]));
    assert_ne!(set, run("case.toml", &[]));
    for command in ["film", "contact", "gear"] {
        let set = ["--set", "operation.torque=200 N m"];
        let by_key = bench
            .run(&[&[command, "case.toml"][..], &set].concat())
            .well();
        let by_file = bench.run(&[command, "other.toml"]).well();
        assert_eq!(
            by_key.out,
            by_file.out.replace("other.toml", "case.toml"),
            "{command}"
        );
    }
}

#[test]
fn a_key_that_is_set_wrong_names_itself_and_no_line_of_the_file() {
    let bench = bench();
    for (set, code, says) in [
        ("operation.torqe=3 N m", "E203", "Did you mean \"torque\"?"),
        (
            "operation.torque=3 N",
            "E204",
            "\"N\" is not a unit of torque",
        ),
        (
            "operation.torque=0 N m",
            "E209",
            "operation.torque = 0 N m: must be",
        ),
        ("gears.module=1.8 m", "E212", "gears.module = 1.8 m"),
    ] {
        let said = bench.run(&["run", "case.toml", "--no-output", "--set", set]);
        said.refused(2, code, &["case.toml (changed): ", says]);
    }
    let said = bench.run(&["run", "case.toml", "--set", "torque"]);
    assert!(
        said.status == 2 && said.err.contains("must be a key and its value"),
        "{said:?}"
    );
}

#[test]
fn a_case_is_read_from_standard_input() {
    let bench = bench();
    let piped = bench
        .run_with_input(&["run", "-", "--no-output", "--no-band", "--json"], E_DRIVE)
        .well()
        .json();
    let read = bench
        .run(&["run", "case.toml", "--no-output", "--no-band", "--json"])
        .well()
        .json();
    assert_eq!(piped["summary"], read["summary"]);
}

#[test]
fn check_tells_every_error_at_once_and_runs_nothing() {
    let bench = bench();
    let bad = E_DRIVE
        .replace("module = \"1.8 mm\"", "module = 1.8")
        .replace("torque = \"145 N m\"", "torqe = \"145 N m\"")
        .replace("speed = \"9000 1/min\"", "speed = \"0 rpm\"")
        .replace("\"pinion.csv\"", "\"nosuch.csv\"")
        .replace("offsets = 2", "offsets = 0\nwindow = 0.1");
    bench.write("bad.toml", &bad);
    let before = bench.listing();
    let said = bench.run(&["check", "bad.toml"]);
    assert_eq!(said.status, 2);
    for says in [
        "E203 bad.toml:",
        "\"operation.torqe\"",
        "gears.module: 1.8 has no unit",
        "operation.speed = \"0 rpm\"",
        "model.offsets = 0",
        "model.window = 0.1",
        "nosuch.csv",
    ] {
        assert!(said.err.contains(says), "{says} is not in {}", said.err);
    }
    assert!(said.err.contains("bad.toml: 6 errors"), "{}", said.err);
    let listed = bench.run(&["check", "bad.toml", "--json"]);
    assert_eq!(listed.json()["errors"].as_array().unwrap().len(), 6);
    assert_eq!(bench.listing(), before);
}

#[test]
fn check_of_thousands_of_wrong_keys_shows_fifty() {
    let bench = bench();
    let keys: String = (0..2000).map(|key| format!("k{key} = {key}\n")).collect();
    bench.write("keys.toml", format!("{keys}{E_DRIVE}"));
    let said = bench.run(&["check", "keys.toml"]);
    assert_eq!(said.status, 2);
    assert_eq!(said.err.matches("E203 ").count(), 50);
    assert!(
        said.err
            .ends_with("keys.toml: 2000 errors; 1950 more than the 50 shown\n"),
        "{}",
        said.err
    );
    let listed = bench.run(&["check", "keys.toml", "--json"]).json();
    assert_eq!(listed["errors"].as_array().unwrap().len(), 50);
    assert_eq!(listed["errors_not_shown"], 1950);
}

/// A copy of the text and its index for each error took 1.6 GB; the limit on the address space leaves room for the program
/// and its threads, the test of /usr/bin/time for the peak is 27 MB.
#[test]
#[cfg(target_os = "linux")]
fn check_of_thousands_of_wrong_keys_needs_little_memory() {
    let bench = bench();
    let keys: String = (0..2000).map(|key| format!("k{key} = {key}\n")).collect();
    bench.write("keys.toml", format!("{keys}{E_DRIVE}"));
    let limited = Command::new("sh")
        .args(["-c", "ulimit -v 400000; exec \"$0\" check keys.toml"])
        .arg(program())
        .current_dir(bench.path("."))
        .output()
        .unwrap();
    let err = String::from_utf8(limited.stderr).unwrap();
    assert_eq!(limited.status.code(), Some(2), "{err}");
    assert!(err.contains("2000 errors"), "{err}");
}

#[test]
fn check_refuses_what_a_run_refuses_before_it_solves_a_contact() {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("case.toml", E_DRIVE);
    for key in ["model.window=40", "operation.torque=0.01 N m"] {
        let run = bench.run(&["run", "case.toml", "--no-output", "--set", key]);
        let check = bench.run(&["check", "case.toml", "--set", key]);
        assert_eq!(run.status, check.status, "{key}: {run:?} {check:?}");
        let message = |said: &str| said.lines().next().map(str::to_owned);
        assert_eq!(message(&run.err), message(&check.err), "{key}");
    }
}

#[test]
fn check_computes_no_records_of_mixed_lubrication() {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("case.toml", E_DRIVE);
    let keys = [
        "--set",
        "model.load_share=ehl",
        "--set",
        "model.ehl.cache=records",
    ];
    bench
        .run(&[&["check", "case.toml"][..], &keys].concat())
        .well();
    assert!(!bench.path("records").exists());
}

#[test]
fn check_of_a_good_case_lists_defaults_and_work() {
    let bench = bench();
    let said = bench.run(&["check", "case.toml"]).well().out;
    for says in [
        "case.toml: no errors",
        " (--explain-defaults)",
        "A run takes ",
    ] {
        assert!(said.contains(says), "{says} is not in {said}");
    }
    let listed = bench.run(&["check", "case.toml", "--explain-defaults"]);
    assert!(listed.well().out.contains("model.window = 3"));
    let told = bench.run(&["check", "case.toml", "--json"]).well().json();
    assert_eq!(told["errors"].as_array().unwrap().len(), 0);
    assert!(told["estimate"]["contacts"].as_u64().unwrap() > 0);
}

#[test]
fn an_unusual_number_warns_one_beyond_sense_is_refused_and_symbols_are_named() {
    let bench = bench();
    let unusual = [
        "run",
        "case.toml",
        "--no-output",
        "--no-band",
        "--notes",
        "--set",
        "operation.speed=70000 1/min",
    ];
    let said = bench.run(&unusual).well();
    let says = "W201 operation.speed = 70000 1/min is unusual; usual is 1 to 60000 1/min";
    assert!(said.unwrapped().contains(says), "{}", said.out);
    // 0.9 million revolutions a minute of this pinion are 2 km/s.
    let said = bench.run(&[
        "run",
        "case.toml",
        "--no-output",
        "--no-band",
        "--set",
        "operation.speed=9e5 1/min",
    ]);
    said.refused(2, "E212", &["pitch-line speed", "beyond physical sense"]);
    let case = E_DRIVE
        .replace("teeth = ", "z = ")
        .replace("module = ", "m_n = ")
        .replace("[lubricant]", "[oil]");
    bench.write("case.toml", case);
    let said = bench
        .run(&["run", "case.toml", "--no-output", "--no-band", "--notes"])
        .well();
    let says = "W202 gears.m_n is gears.module, gears.z is gears.teeth, oil is lubricant";
    assert!(said.unwrapped().contains(says), "{}", said.out);
}

#[test]
fn every_oil_of_the_library_runs_the_case_by_its_name_alone() {
    let bench = Bench::new();
    bench.write_flanks();
    let oils = bench.run(&["list", "oils", "--json"]).well().json();
    let names: Vec<String> = oils["oils"]
        .as_array()
        .unwrap()
        .iter()
        .map(|oil| oil["name"].as_str().unwrap().to_owned())
        .collect();
    assert!(names.len() >= 6);
    let listed = bench.run(&["list", "oils"]).well().out;
    let lines: Vec<&str> = E_DRIVE
        .lines()
        .filter(|line| {
            !["viscosity", "density", "base_oil"]
                .iter()
                .any(|key| line.starts_with(key))
        })
        .collect();
    for name in names {
        assert!(listed.contains(&name));
        let oil = format!("[lubricant]\noil = \"{name}\"");
        bench.write("case.toml", lines.join("\n").replace("[lubricant]", &oil));
        let said = bench
            .run(&["run", "case.toml", "--no-output", "--no-band", "--json"])
            .well()
            .json();
        let efficiency = said["summary"]["efficiency"].as_f64().unwrap();
        assert!((0.97..1.0).contains(&efficiency), "{name}: {efficiency}");
    }
}

#[test]
fn a_flank_known_by_ra_or_rz_alone_runs_and_lists_what_follows() {
    let bench = bench();
    for (given, follows) in [
        (
            "{ ra = \"0.2 um\" }",
            "surface.pinion.rq = \"250.7 nm\"  (Ra/0.798",
        ),
        (
            "{ rz = \"1.2 um\" }",
            "surface.pinion.rq = \"200 nm\"  (Rz/6",
        ),
        (
            "{ rq = \"0.2 um\" }",
            "surface.pinion.ra = \"159.6 nm\"  (0.798 Rq",
        ),
    ] {
        bench.write(
            "case.toml",
            with_line("pinion", &format!("pinion = {given}")),
        );
        let said = bench
            .run(&[
                "run",
                "case.toml",
                "--no-output",
                "--no-band",
                "--explain-defaults",
                "--set",
                "model.load_share=lambda-star",
            ])
            .well();
        assert!(said.out.contains(follows), "{}", said.out);
    }
}

#[test]
fn cite_prints_an_entry_for_each_source() {
    let bench = bench();
    let entries = bench
        .run(&["run", "case.toml", "--no-output", "--no-band", "--cite"])
        .well()
        .out;
    let result = bench
        .run(&["run", "case.toml", "--no-output", "--no-band", "--json"])
        .well()
        .json();
    let sources = result["references"].as_array().unwrap();
    assert_eq!(entries.matches("@misc{").count(), sources.len());
    for source in sources {
        let key = source["key"].as_str().unwrap();
        assert!(entries.contains(&format!("@misc{{{key},")), "{key}");
    }
    assert_eq!(entries.matches('{').count(), entries.matches('}').count());
}

#[test]
fn compare_reads_the_files_of_a_finish_as_the_case_reads_its_own() {
    let bench = Bench::new();
    // Heights alone, without unit or spacing: the keys of the case tell both.
    for name in ["a.txt", "b.txt"] {
        let heights = crate::bench::heights(6000);
        let text: String = heights.iter().map(|z| format!("{z:.5}\n")).collect();
        bench.write(name, text);
    }
    let keys = "dx = \"0.5 um\", z_unit = \"um\"";
    let case = with_line(
        "pinion",
        &format!("pinion = {{ file = \"a.txt\", {keys} }}"),
    )
    .replace("wheel = { file = \"wheel.csv\", mirrored = true }\n", "");
    bench.write("case.toml", case);
    let arguments = [
        "compare",
        "case.toml",
        "--finish",
        "a=a.txt",
        "--finish",
        "b=b.txt",
        "--offsets",
        "2",
    ];
    let said = bench.run(&arguments).well().out;
    assert!(said.contains("finish"), "{said}");
    // Two offsets are no basis for a correlation; warnings are printed.
    assert!(
        !said.contains("correlation") && said.contains("W404"),
        "{said}"
    );
}

#[test]
fn the_page_of_the_case_file_is_what_the_command_prints() {
    let made = Bench::new().run(&["schema", "--markdown"]).well().out;
    let shown = std::fs::read_to_string(root().join("docs/CASE_FILE.md")).unwrap();
    assert_eq!(
        shown, made,
        "asperity schema --markdown > docs/CASE_FILE.md writes it anew"
    );
}
