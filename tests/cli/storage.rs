//! Outputs of every command: ours are replaced, the user's are kept, nothing odd gets out.

use std::fs;
use std::path::Path;

use crate::bench::{Bench, E_DRIVE, root};

const RUN: [&str; 6] = ["run", "case.toml", "-o", "out", "-q", "--no-band"];

fn bench() -> Bench {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("case.toml", E_DRIVE);
    bench
}

#[test]
fn files_of_the_user_in_a_result_survive() {
    let bench = bench();
    bench.run(&[&RUN[..], &["--fields", "all"]].concat()).well();
    for (file, says) in [
        ("out/position_99", "(position_99 is not part of a result)"),
        (
            "out/position_01/notes.txt",
            "(position_01/notes.txt is not part of a result)",
        ),
        ("out/path.csv", "path.csv: was changed since it was written"),
    ] {
        let before = fs::read(bench.path(file)).ok();
        bench.write(file, "mine");
        bench.run(&RUN).refused(2, "E401", &[says]);
        assert_eq!(fs::read(bench.path(file)).unwrap(), b"mine");
        match before {
            Some(bytes) => fs::write(bench.path(file), bytes).unwrap(),
            None => fs::remove_file(bench.path(file)).unwrap(),
        }
    }
    bench.write("out/report.html", "my own words");
    let says = ["report.html: was changed since"];
    bench.run(&["report", "out"]).refused(2, "E401", &says);
    assert_eq!(
        fs::read(bench.path("out/report.html")).unwrap(),
        b"my own words"
    );
}

#[test]
fn a_manifest_that_names_a_file_outside_its_folder_removes_nothing() {
    let bench = bench();
    std::fs::create_dir(bench.path("box")).unwrap();
    let run = ["run", "case.toml", "-o", "box/out", "-q", "--no-band"];
    bench.run(&run).well();
    bench.write("victim.txt", "mine");
    bench.write("box/victim.txt", "mine");
    let manifest = fs::read_to_string(bench.path("box/out/manifest.json")).unwrap();
    /// SHA-256 of `mine`.
    const SUM: &str = "3fd30542fe3f61b14bd4a4b2dc0b6fb30fa6f63ebce52dd1778aaa8c4dc02cff";
    for name in ["../victim.txt", "../../victim.txt", "../../../victim.txt"] {
        let planted = format!("\"sha256\": {{\n{name:?}: [{SUM:?}],");
        let planted = manifest.replacen("\"sha256\": {", &planted, 1);
        bench.write("box/out/manifest.json", planted);
        let says = ["exists and is not a result folder"];
        bench.run(&run).refused(2, "E401", &says);
        for file in ["victim.txt", "box/victim.txt"] {
            assert_eq!(fs::read(bench.path(file)).unwrap(), b"mine", "{name}");
        }
    }
    bench.write("box/out/manifest.json", manifest);
    bench.run(&run).well();
}

#[cfg(unix)]
#[test]
fn a_link_is_not_followed_onto_the_file_behind_it() {
    use std::os::unix::fs::symlink;
    let bench = bench();
    bench.run(&RUN).well();
    bench.write("precious.html", "mine");
    fs::remove_file(bench.path("out/report.html")).unwrap();
    symlink(bench.path("precious.html"), bench.path("out/report.html")).unwrap();
    symlink(bench.path("precious.html"), bench.path("link.csv")).unwrap();
    symlink(bench.path("out"), bench.path("link")).unwrap();
    let says = ["is a link"];
    bench.run(&["report", "out"]).refused(2, "E401", &says);
    bench
        .run(&["run", "case.toml", "-o", "out"])
        .refused(2, "E401", &says);
    bench
        .run(&["run", "case.toml", "-o", "link"])
        .refused(2, "E401", &says);
    let convert = ["profile", "convert", "pinion.csv", "link.csv"];
    bench.run(&convert).refused(2, "E401", &says);
    assert_eq!(fs::read(bench.path("precious.html")).unwrap(), b"mine");
}

#[test]
fn the_default_result_is_small_and_fields_are_kept_on_request() {
    let bench = bench();
    bench.write(
        "case.toml",
        E_DRIVE.replace("positions = 2", "positions = 3"),
    );
    let said = |arguments: &[&str]| {
        let mut all = vec!["run", "case.toml", "-o", "out", "-q"];
        all.extend(arguments);
        bench.run(&all)
    };
    said(&[]).well();
    let names = |folder: &str| {
        let entries = fs::read_dir(bench.path(folder)).unwrap();
        let mut names: Vec<String> = entries
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        names
    };
    let small = [
        "friction_laws.csv",
        "load.csv",
        "losses.csv",
        "manifest.json",
        "offsets.csv",
        "page.json",
        "path.csv",
        "report.html",
        "result.json",
    ];
    assert_eq!(names("out"), small);
    let kept = ["report", "out", "--position", "1"];
    let other = ["report", "out", "--position", "3"];
    let refused = [bench.run(&kept), bench.run(&other)];
    assert!(
        refused
            .iter()
            .any(|said| said.status == 2 && said.err.contains("were not stored"))
    );
    said(&["--no-band", "--fields", "1,3"]).well();
    assert!(bench.path("out/position_01/surface.csv").is_file());
    assert!(!bench.path("out/position_02").exists());
    // A page of a position that was chosen names it.
    let named = [(&kept, 1), (&other, 3)].map(|(arguments, position)| {
        bench.run(arguments).well();
        let page = fs::read_to_string(bench.path("out/report.html")).unwrap();
        page.contains(&format!("contact at position {position} of 3"))
    });
    assert_eq!(named, [false, true]);
    said(&["--fields", "9"]).refused(2, "E402", &["position 9 is not among the 3"]);
    said(&["--fields", "some"]).refused(2, "E209", &["must be all, or numbers"]);
}

#[test]
fn a_dash_is_standard_output_for_a_file_and_refused_for_a_folder() {
    let bench = bench();
    let before = bench.listing();
    for arguments in [
        &["run", "case.toml", "-o", "-"][..],
        &[
            "compare",
            "case.toml",
            "--finish",
            "a=pinion.csv",
            "--finish",
            "b=wheel.csv",
            "-o",
            "-",
        ],
        &["demo", "-"],
    ] {
        bench
            .run(arguments)
            .refused(2, "E401", &["standard output"]);
    }
    let said = bench.run(&["profile", "convert", "pinion.csv", "-"]).well();
    let of_file = bench
        .run(&["profile", "convert", "pinion.csv", "out.csv", "-q"])
        .well();
    assert_eq!(of_file.out, "");
    assert_eq!(said.out, fs::read_to_string(bench.path("out.csv")).unwrap());
    fs::remove_file(bench.path("out.csv")).unwrap();
    let said = bench.run(&["contact", "case.toml", "-o", "-"]).well();
    assert!(said.out.starts_with("x_m,h_m,"), "{}", said.out);
    assert!(
        said.out
            .lines()
            .skip(1)
            .all(|line| line.split(',').count() == 6)
    );
    let both = ["contact", "case.toml", "-o", "-", "--json"];
    let said = bench.run(&both);
    assert!(said.status == 2 && said.err.starts_with("E205"), "{said:?}");
    assert_eq!(bench.listing(), before);
}

#[test]
fn a_single_file_needs_a_folder_that_is_there() {
    let bench = bench();
    let says = ["there is no folder none"];
    bench
        .run(&["contact", "case.toml", "-o", "none/x.csv"])
        .refused(2, "E401", &says);
    bench
        .run(&["profile", "convert", "pinion.csv", "none/x.csv"])
        .refused(2, "E401", &says);
    assert!(!bench.path("none").exists());
}

#[test]
fn names_and_titles_do_nothing_in_a_spreadsheet_or_a_terminal() {
    let bench = bench();
    let formula = "=HYPERLINK(1)";
    let (first, second) = (format!("{formula}=pinion.csv"), "b=wheel.csv");
    // A name ends at the first equals sign: one that starts with it is told.
    let said = bench.run(&[
        "compare",
        "case.toml",
        "--finish",
        &first,
        "--finish",
        second,
    ]);
    assert_eq!(said.status, 2, "{said:?}");
    let arguments = [
        "compare",
        "case.toml",
        "--finish",
        "@SUM(A1)=pinion.csv",
        "--finish=-1+1=wheel.csv",
        "--offsets",
        "2",
        "-o",
        "out",
        "-q",
    ];
    bench.run(&arguments).well();
    for table in ["out/compare.csv", "out/offsets.csv"] {
        let text = fs::read_to_string(bench.path(table)).unwrap();
        assert!(
            text.contains("'@SUM(A1)") && text.contains("'-1+1"),
            "{text}"
        );
        assert!(
            text.lines()
                .all(|line| !line.starts_with(['=', '+', '-', '@'])),
            "{text}"
        );
    }
    let title = "title = \"red \\u001b[31m title\"";
    bench.write(
        "case.toml",
        E_DRIVE.replace("title = \"small case\"", title),
    );
    let said = bench
        .run(&["run", "case.toml", "--no-output", "--no-band"])
        .well();
    assert!(
        !said.out.contains('\u{1b}') && said.out.contains("\\u{1b}[31m"),
        "{}",
        said.out
    );
    let missing = bench.run(&["profile", "info", "no\u{1b}[31m.csv"]);
    assert!(!missing.err.contains('\u{1b}'), "{}", missing.err);
}

/// Every cell of the tables in `folder` and the folders below it, with the name of its file.
fn cells_of_tables(folder: &Path) -> Vec<(String, String)> {
    let mut cells = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            cells.extend(cells_of_tables(&path));
        } else if path.extension().is_some_and(|ending| ending == "csv") {
            let mut reader = csv::ReaderBuilder::new()
                .has_headers(false)
                .flexible(true)
                .from_path(&path)
                .unwrap();
            let name = path.file_name().unwrap().to_string_lossy().into_owned();
            for row in reader.records() {
                let row = row.unwrap();
                cells.extend(row.iter().map(|cell| (name.clone(), cell.to_owned())));
            }
        }
    }
    cells
}

#[track_caller]
fn no_formula_in_tables_of(folder: &Path) {
    let cells = cells_of_tables(folder);
    assert!(!cells.is_empty());
    for (file, cell) in cells {
        let is_number = cell.parse().is_ok_and(f64::is_finite);
        assert!(
            is_number || !cell.trim_start().starts_with(['=', '+', '-', '@']),
            "{file}: {cell}"
        );
    }
}

#[test]
fn no_name_of_a_train_or_a_sweep_is_a_formula_in_a_table() {
    let bench = bench();
    bench.write(
        "train.toml",
        r#"
[train]
input = "motor"
[mesh.fast]
shafts = ["motor", "=cmd|' /C calc'!A0"]
gears = { teeth = [23, 68], module = "1.8 mm", helix = "23.4 deg", face_width = "32 mm", pinion = { tip_relief = "none" }, wheel = { tip_relief = "none" } }
[operation]
torque = "145 N m"
speed = "9000 1/min"
bulk_temperature = "90 °C"
[lubricant]
oil = "m100"
[surface]
cutoff = "0.25 mm"
pinion = { file = "pinion.csv" }
wheel = { file = "wheel.csv" }
[model]
offsets = 2
positions = 4
"#,
    );
    let whole = ["run", "train.toml", "--no-band", "-q", "-o", "train"];
    bench.run(&whole).well();
    no_formula_in_tables_of(&bench.path("train"));
    bench.write(
        "study.toml",
        r#"
case = "case.toml"
[[axis]]
name = "=1+1"
choice."=cmd|calc, \"A\"" = { "operation.torque" = "80 N m" }
choice.b = { "operation.torque" = "90 N m" }
[[axis]]
key = "gears.profile_shift.0"
values = ["-0.01", "+0.01", "0.02"]
"#,
    );
    for shard in ["1/2", "2/2"] {
        bench
            .run(&["sweep", "run", "study.toml", "-q", "--shard", shard])
            .well();
    }
    no_formula_in_tables_of(&bench.path("parts"));
    bench
        .run(&["sweep", "merge", "study.toml", "-q", "-o", "out"])
        .well();
    no_formula_in_tables_of(&bench.path("out"));
    let table = fs::read_to_string(bench.path("out/sweep.csv")).unwrap();
    assert!(table.contains("\"'=cmd|calc, \"\"A\"\"\""), "{table}");
    // Names are read back from the parts without their marks.
    let json = fs::read_to_string(bench.path("out/sweep.json")).unwrap();
    assert!(json.contains("=1+1") && !json.contains("'=1+1"), "{json}");
}

#[test]
fn titles_and_names_of_files_begin_no_line_of_their_own() {
    let bench = bench();
    let forged = "E501 forged";
    let title = format!("title = \"small\\n{forged}\"");
    let case = E_DRIVE.replace("title = \"small case\"", &title);
    bench.write("case.toml", case.replace("pinion.csv", "pin\\nion.csv"));
    let forges = |text: &str| {
        text.lines()
            .any(|line| line.trim_start().starts_with(forged))
    };
    let missing = bench.run(&["profile", "info", &format!("none\n{forged}.csv")]);
    assert!(
        missing.err.contains(forged) && !forges(&missing.err),
        "{}",
        missing.err
    );
    let missing = bench.run(&["run", "case.toml", "--no-output"]);
    assert!(missing.err.contains("pin\\u{a}ion.csv"), "{}", missing.err);
    bench.write(
        "case.toml",
        E_DRIVE.replace("title = \"small case\"", &title),
    );
    let axes = ["--torque=-100,100", "--speed=9000", "--band", "none"];
    for arguments in [
        &[
            "run",
            "case.toml",
            "--no-band",
            "-o",
            &format!("out\n{forged}"),
        ][..],
        &["gear", "case.toml"],
        &[&["map", "case.toml", "-o", "m"][..], &axes].concat(),
    ] {
        let said = bench.run(arguments).well();
        assert!(
            said.out.contains(forged) && !forges(&said.out),
            "{}",
            said.out
        );
    }
    let case = format!("case\n{forged}.toml");
    bench.write(&case, E_DRIVE.replace("title = \"small case\"", &title));
    let gearbox =
        fs::read_to_string(root().join("crates/rexs/tests/gearboxes/chain.rexs")).unwrap();
    let program = format!("applicationId=\"by&#10;{forged}\"");
    let gearbox = gearbox.replace("applicationId=\"by hand\"", &program);
    bench.write(
        "chain.rexs",
        gearbox.replace("name=\"", &format!("name=\"a&#10;{forged}")),
    );
    let output = format!("stage\n{forged}");
    for arguments in [
        &["contact", &case][..],
        &["ehl", &case, "--smooth"],
        &[
            "ehl",
            &case,
            "--cells",
            "64",
            "--half-widths",
            "1",
            "--start",
            "0",
        ],
        &["demo", &format!("demo\n{forged}")],
        &["case", "from-rexs", "chain.rexs"],
        &[
            "case",
            "from-rexs",
            "chain.rexs",
            "--stage",
            "1",
            "-o",
            &output,
        ],
    ] {
        let said = bench.run(arguments);
        assert_eq!(said.status, 0, "{said:?}");
        let both = said.out + &said.err;
        assert!(both.contains(forged) && !forges(&both), "{both}");
    }
}

#[test]
fn flat_flanks_give_no_number_that_is_none() {
    let bench = bench();
    let rows: String = (0..6000)
        .map(|i| format!("{:.1},0\n", 0.5 * f64::from(i)))
        .collect();
    let flat = format!("x_um,z_um\n{rows}");
    bench.write("pinion.csv", &flat);
    bench.write("wheel.csv", &flat);
    let said = bench.run(&RUN);
    if said.status == 0 {
        for file in ["out/path.csv", "out/result.json", "out/report.html"] {
            let text = fs::read_to_string(bench.path(file)).unwrap();
            // The script of the page breaks its lines with one.
            let text = text.replace("? NaN :", "");
            assert!(!text.contains("NaN") && !text.contains(",inf,"), "{file}");
        }
        bench.run(&["report", "out"]).well();
    } else {
        assert!(
            said.err.starts_with('E') && !bench.path("out").exists(),
            "{said:?}"
        );
    }
}

#[test]
fn work_beyond_a_limit_is_refused_and_threads_are_capped() {
    let bench = bench();
    let large = E_DRIVE
        .replace("positions = 2", "positions = 2000")
        .replace("offsets = 2", "offsets = 1000");
    bench.write("large.toml", large);
    let says = ["rough contacts take about", "pass --max-hours"];
    let run = ["run", "large.toml", "--no-output", "--max-hours", "0.01"];
    bench.run(&run).refused(2, "E209", &says);
    let run = ["run", "case.toml", "--no-output", "--max-gb", "0.0001"];
    bench
        .run(&run)
        .refused(2, "E209", &["of memory", "--max-gb"]);
    let run = [
        "run",
        "case.toml",
        "--no-output",
        "--no-band",
        "--threads",
        "65535",
    ];
    let said = bench.run(&run);
    assert_eq!(said.status, 0);
    assert!(said.err.contains("threads are used"), "{}", said.err);
}
