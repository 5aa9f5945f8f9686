//! Messages about profile files, by `asperity profile info` and through a case.

use crate::bench::{Bench, E_DRIVE, heights, line_of, rows, trace, with_line};

/// A trace that cannot be read.
struct Bad {
    name: &'static str,
    content: Vec<u8>,
    /// Options of the command.
    options: &'static [&'static str],
    code: &'static str,
    says: &'static [&'static str],
}

fn bad(
    name: &'static str,
    content: impl Into<Vec<u8>>,
    options: &'static [&'static str],
    code: &'static str,
    says: &'static [&'static str],
) -> Bad {
    Bad {
        name,
        content: content.into(),
        options,
        code,
        says,
    }
}

/// A trace in micrometres with row `at` (from 0) replaced.
fn with_row(at: usize, row: &str) -> String {
    let good = trace("x_um,z_um", 1000);
    let lines = good.lines().enumerate();
    let changed: Vec<&str> = lines
        .map(|(i, line)| if i == at + 1 { row } else { line })
        .collect();
    changed.join("\n")
}

/// Whole numbers down to line 37, a decimal comma on line 38.
fn decimal_comma_from_line_38() -> String {
    let table = rows(500, |i, z| match i {
        0..36 => format!("{i};{i}"),
        36 => format!("{i};0,4312"),
        _ => format!("{i};{z:.4}").replace('.', ","),
    });
    format!("x [um];z [um]\n{table}")
}

#[rustfmt::skip]
fn unreadable() -> Vec<Bad> {
    let far = |z: f64| format!("{:.1}", 1e4 * z);
    vec![
        bad("flank.csv", decimal_comma_from_line_38(), &["--decimal", "point"], "E101",
            &["flank.csv:38: cannot read \"0,4312\" as a number", "the file looks like ';' with decimal comma", "Pass --decimal comma"]),
        bad("odd.csv", with_row(40, "20.0,O.431"), &[], "E101", &["odd.csv:42: cannot read \"O.431\"", "Correct this line, with NaN for a missing height"]),
        bad("empty.csv", "", &[], "E102", &["empty.csv: no rows of numbers found in 0 lines", "Export the profile"]),
        bad("prose.csv", "Dear Sir,\nthe flank is fine.\n", &[], "E102", &["the first reads \"Dear Sir,\""]),
        bad("thin.csv", trace("x_um,z_um", 1000), &["--columns", "7"], "E102", &["no rows of numbers"]),
        bad("nounit.csv", format!("x,z\n{}", rows(1000, |i, z| format!("{:.1},{}", 0.5 * i as f64, far(z)))), &[], "E104",
            &["nounit.csv: no unit found for the heights, which span", "Pass --z-unit um | nm"]),
        bad("back.csv", with_row(500, "1.0,0.1"), &[], "E105", &["back.csv:502: x goes from 249.5 to 1", "--columns"]),
        bad("few.csv", trace("x_um,z_um", 50), &[], "E106", &["few.csv: 50 points", "at least 100"]),
        bad("gap.csv", with_row(77, "38.5,NaN"), &[], "E107", &["gap.csv:79: 1 of 1000 points", "\"38.5,NaN\"", "--gaps interpolate"]),
        bad("noise.dat", vec![0, 159, 3, 200, 0, 1, 7, 255, 0, 12, 0, 0, 9, 130, 4], &[], "E108", &["noise.dat: binary data", "Export the profile"]),
        bad("sheet.xlsx", b"PK\x03\x04\x14\0\x06\0\x08\0".to_vec(), &[], "E117", &["sheet.xlsx: not a valid workbook", "Export it again"]),
        bad("uneven.csv", with_row(500, "250.3,0.1"), &[], "E109", &["uneven.csv:502: uneven spacing, x = 250.3", "Pass --uneven resample"]),
        bad("one.csv", rows(1000, |_, z| format!("{z:.5}")), &["--z-unit", "um"], "E110", &["one.csv: no x column and no spacing of the points was found", "Pass --dx"]),
        bad("ragged.csv", with_row(50, "25.0,0.1,9"), &[], "E111", &["ragged.csv:52: 3 columns where other rows have 2", "\"25.0,0.1,9\""]),
        bad("three.csv", format!("a,b,c\n{}", rows(500, |i, z| format!("{i},{z:.4},{z:.4}"))), &[], "E112", &["three.csv: 3 columns", "Pass --columns, e.g. --columns 1,2"]),
        bad("commas.csv", rows(500, |i, z| format!("{i},5,0,{}", (100.0 * z.abs()) as u32)), &[], "E113", &["commas.csv:1: \"0,5,0,", "Pass --separator and --decimal"]),
        bad("volt.csv", trace("x [um],z [V]", 500), &[], "E114", &["volt.csv: the header gives the heights in \"V\"", "m, mm, um, nm, angstrom, inch"]),
        bad("turned.csv", trace("x_um,z_um", 500), &["--dx", "-1um"], "E116", &["turned.csv: spacing is", "which no profile has"]),
        bad("short.csv", trace("x_um,z_um", 200), &[], "E120", &["short.csv: the profile is", "needs at least 250 um"]),
        bad("coarse.csv", format!("x_um,z_um\n{}", rows(500, |i, z| format!("{},{z:.4}", 20 * i))), &[], "E120", &["coarse.csv: cut-off", "shorter than the spacing"]),
    ]
}

#[cfg(unix)]
#[test]
fn devices_and_pipes_are_no_files_of_any_command() {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("case.toml", E_DRIVE);
    let of_device = with_line(
        "pinion =",
        "pinion = { file = \"/dev/zero\", dx = \"1 um\" }",
    );
    bench.write("device.toml", of_device);
    let says = ["a device or a pipe"];
    for (command, code) in [
        (&["check", "/dev/zero"][..], "E201"),
        (&["run", "/dev/zero"], "E201"),
        (&["run", "device.toml"], "E103"),
        (&["profile", "info", "/dev/zero"], "E103"),
    ] {
        bench.run(command).refused(2, code, &says);
    }
    bench
        .run(&["report", "/dev/zero"])
        .refused(2, "E402", &["it is not a file"]);
    let large = std::fs::File::options()
        .write(true)
        .open(bench.path("case.toml"));
    large.unwrap().set_len(100 << 20).unwrap();
    bench
        .run(&["check", "case.toml"])
        .refused(2, "E201", &["larger than 10 MB"]);
}

#[test]
fn every_fault_of_a_trace_is_named_with_its_line_and_remedy() {
    let bench = Bench::new();
    for entry in unreadable() {
        bench.write(entry.name, &entry.content);
        let mut arguments = vec!["profile", "info", entry.name];
        arguments.extend(entry.options);
        let said = bench.run(&arguments);
        if ["E109", "E120"].contains(&entry.code) {
            said.informed(entry.code, entry.says)
        } else {
            said.refused(2, entry.code, entry.says)
        }
    }
    bench.run(&["profile", "info", "nosuch.csv"]).refused(
        2,
        "E103",
        &["nosuch.csv: the file cannot be read"],
    );
}

#[test]
fn a_separator_that_does_not_fit_is_refused() {
    let bench = Bench::new();
    // Two columns by blanks; a lone comma would make one column of each row.
    bench.write("blank.txt", rows(500, |i, z| format!("{i} {z:.4}")));
    let said = bench.run(&["profile", "info", "blank.txt", "--separator", "comma"]);
    assert!(
        ["E101", "E115"]
            .iter()
            .any(|code| said.err.starts_with(code)),
        "{said:?}"
    );
    assert_eq!(said.status, 2);
}

#[test]
fn a_trace_named_in_a_case_is_refused_with_the_place_that_names_it() {
    let bench = Bench::new();
    bench.write_flanks();
    for entry in unreadable().iter().filter(|entry| entry.options.is_empty()) {
        bench.write(entry.name, &entry.content);
        let line = format!("pinion = {{ file = \"{}\" }}", entry.name);
        bench.write("case.toml", with_line("pinion", &line));
        let before = bench.listing();
        let said = bench.run(&["run", "case.toml", "-o", "out"]);
        let named = format!("(named at case.toml:{}", line_of("pinion"));
        let place = if entry.code == "E120" {
            entry.name
        } else {
            &named
        };
        // The short trace is long enough for the cut-off of the case, but not for both its ends.
        said.refused(2, entry.code, &[place]);
        assert_eq!(bench.listing(), before);
    }
    bench.write(
        "case.toml",
        with_line("pinion", "pinion = { file = \"nosuch.csv\" }"),
    );
    bench.run(&["run", "case.toml"]).refused(
        2,
        "E103",
        &["nosuch.csv: cannot be opened", ", surface.pinion.file"],
    );
    let line = "film_friction = { xu = \"nosuch.json\" }";
    bench.write("case.toml", with_line("offsets", line));
    bench.run(&["run", "case.toml"]).refused(
        2,
        "E103",
        &["nosuch.json: cannot be opened", "model.film_friction.xu"],
    );
}

#[test]
fn options_of_the_reader_are_keys_of_a_case() {
    let bench = Bench::new();
    bench.write_flanks();
    let table = rows(4000, |i, z| format!("{:.1};{:.1}", 0.5 * i as f64, 1e4 * z));
    bench.write("nounit.csv", format!("x;z\n{table}"));
    bench.write(
        "case.toml",
        with_line("pinion", "pinion = { file = \"nounit.csv\" }"),
    );
    let says = [
        "Write z_unit = \"um\", or \"nm\" in surface.pinion",
        "(named at case.toml:",
    ];
    bench.run(&["run", "case.toml"]).refused(2, "E104", &says);
    let line = "pinion = { file = \"nounit.csv\", x_unit = \"um\", z_unit = \"nm\" }";
    bench.write("case.toml", with_line("pinion", line));
    bench.run(&["run", "case.toml", "--no-output"]).well();
}

/// A trace that is read with a warning: content, options, code, what it says.
type Noted = (
    String,
    &'static [&'static str],
    &'static str,
    &'static [&'static str],
);

#[rustfmt::skip]
fn noted() -> Vec<Noted> {
    let long = 8000;
    let arc = |i: usize| 38.0 * (i as f64 / 1500.0 - 1.0).powi(2);
    vec![
        (trace("x,z", long), &[], "W111", &["no unit found for the x values", "taken as um", "Pass --x-unit um to confirm"]),
        (format!("x_um,z_um\n{}", rows(3001, |i, z| format!("{:.1},{:.5}", 0.5 * i as f64, z + arc(i)))), &["--lambda-c", "0.25 mm"],
            "W112", &["form not removed (parabola of 38", "over 1.5 mm", "is not roughness. Pass --form poly2"]),
        (trace("x_um,z_um", long), &["--dx", "1um"], "W113", &["spacing 1 um is more than a fifth of lambda_s 2.5 um", "Measure finer, or pass --lambda-s 5um"]),
        (trace("x_um,z_um", 2000), &[], "W114", &["sampling lengths of 250 um", "five are usual"]),
        (with_row(77, "38.5,NaN"), &["--gaps", "interpolate", "--lambda-c", "0.08 mm"], "W115", &["1 missing points interpolated"]),
        (format!("x_um,z_um\n{}", rows(long, |i, z| format!("{:.1},{z:.5}", 0.5 * (long - i) as f64))), &[], "W116", &["x decreases along the file"]),
        (trace("x_um,z_um", long), &["--dx", "0.4um"], "W117", &["spacing 400 nm was stated, the file says 500 nm"]),
        (trace("# dx = 0.4 um\nx_um,z_um", long), &[], "W325", &["states a spacing of 400", "Pass --dx to choose"]),
        (trace("x_um,z_um", long) + &"NaN,NaN\n".repeat(9), &[], "W326", &["9 rows hold neither a position nor a height"]),
        (format!("x_um,z_um\n{}", rows(long, |i, _| format!("{:.1},3.25", 0.5 * i as f64))), &[], "W327", &["all heights are equal", "perfectly smooth"]),
        (trace("roughness profile\nx_um,z_um", long), &[], "W118", &["already filtered roughness profile", "--lambda-c none"]),
    ]
}

#[test]
fn what_is_odd_about_a_trace_is_noted_beside_its_numbers() {
    let bench = Bench::new();
    for (content, options, code, says) in noted() {
        bench.write("flank.csv", content);
        let mut arguments = vec!["profile", "info", "flank.csv"];
        arguments.extend(options);
        let said = bench.run(&arguments).well();
        let text = said.unwrapped();
        let note = text
            .lines()
            .find(|line| line.trim_start().starts_with(code));
        let note = note.unwrap_or_else(|| panic!("no {code} in {}", said.out));
        for part in says {
            assert!(note.contains(part), "{part:?} is not in {note:?}");
        }
        let mut with_json = arguments.clone();
        with_json.push("--json");
        let notes = bench.run(&with_json).well().json()["warnings"].clone();
        let codes: Vec<_> = notes
            .as_array()
            .unwrap()
            .iter()
            .map(|note| &note["code"])
            .collect();
        assert!(codes.iter().any(|seen| *seen == code), "{codes:?}");
    }
}

#[test]
fn the_remedies_for_a_misread_trace_work() {
    let bench = Bench::new();
    let ra = |arguments: &[&str]| bench.run(arguments).well().json()["iso4287"]["ra_um"].clone();
    bench.write("flank.csv", trace("x_um,z_um", 4000));
    let expected = ra(&["profile", "info", "flank.csv", "--json"]);
    let comma = rows(4000, |i, z| {
        format!("{:.1};{z:.5}", 0.5 * i as f64).replace('.', ",")
    });
    bench.write("comma.csv", format!("Weg [um];Höhe [um]\n{comma}"));
    assert_eq!(ra(&["profile", "info", "comma.csv", "--json"]), expected);
    bench.write("column.txt", rows(4000, |_, z| format!("{z:.5}")));
    let stated = [
        "profile",
        "info",
        "column.txt",
        "--dx",
        "0.5um",
        "--z-unit",
        "um",
        "--json",
    ];
    assert_eq!(ra(&stated), expected);
    // A cut-off of none leaves the wave of 101 points in either way.
    let heights = heights(4000);
    let mean = heights.iter().sum::<f64>() / 4000.0;
    let plain = heights.iter().map(|z| (z - mean).abs()).sum::<f64>() / 4000.0;
    let unfiltered = ra(&["profile", "info", "flank.csv", "--as-is", "--json"]);
    // As-is keeps the mean, which is below a hundredth of Ra here.
    assert!(
        (unfiltered.as_f64().unwrap() / plain - 1.0).abs() < 0.02,
        "{unfiltered} {plain}"
    );
}
