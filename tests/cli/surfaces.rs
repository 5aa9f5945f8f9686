//! Surfaces of instruments in the command and in cases.

use crate::bench::{Bench, heights, rows, trace, with_line};

/// A Digital Surf file of `count` rows of `points` points, 0.5 um apart, of this kind of content.
fn sur(points: usize, count: usize, kind: i16, replica: i16) -> Vec<u8> {
    let all = heights(points + 500 * count);
    let mut bytes = vec![0; 512];
    let mut set = |at: usize, part: &[u8]| bytes[at..at + part.len()].copy_from_slice(part);
    set(0, b"DIGITAL SURF");
    set(14, &1_i16.to_le_bytes());
    set(18, &kind.to_le_bytes());
    set(98, &32_i16.to_le_bytes());
    set(108, &(points as i32).to_le_bytes());
    set(112, &(count as i32).to_le_bytes());
    set(120, &0.5_f32.to_le_bytes());
    set(124, &0.5_f32.to_le_bytes());
    set(128, &0.1_f32.to_le_bytes());
    for unit in [180, 196] {
        set(unit, b"um");
    }
    set(212, b"nm");
    set(288, &replica.to_le_bytes());
    for row in 0..count {
        for z in &all[500 * row..500 * row + points] {
            bytes.extend(((z * 1e4).round() as i32).to_le_bytes());
        }
    }
    bytes
}

/// A MAT-file of level 5 with two vectors that are not named z.
fn two_arrays() -> Vec<u8> {
    let element = |kind: u32, data: &[u8]| {
        let mut bytes = [kind, data.len() as u32].map(u32::to_le_bytes).concat();
        bytes.extend(data);
        bytes.resize(bytes.len().next_multiple_of(8), 0);
        bytes
    };
    let mut bytes = vec![0; 128];
    bytes[..19].copy_from_slice(b"MATLAB 5.0 MAT-file");
    bytes[124..].copy_from_slice(b"\x00\x01IM");
    for name in ["left", "right"] {
        let flags = [6_u32, 0].map(u32::to_le_bytes).concat();
        let sizes = [3_i32, 1].map(i32::to_le_bytes).concat();
        let numbers = [1.0_f64, 2.0, 3.0].map(f64::to_le_bytes).concat();
        let parts = [
            element(6, &flags),
            element(5, &sizes),
            element(1, name.as_bytes()),
            element(9, &numbers),
        ];
        bytes.extend(element(14, &parts.concat()));
    }
    bytes
}

#[test]
fn a_surface_gives_a_row_or_its_mean() {
    let bench = Bench::new();
    bench.write("flank.sur", sur(6000, 3, 2, 0));
    let info = |more: &[&str]| {
        let all = ["profile", "info", "flank.sur", "--lambda-c", "0.25 mm"];
        bench.run(&[&all, more].concat())
    };
    let none = info(&[]);
    none.surveyed(&[
        "flank.sur: the file holds 3 profiles",
        "--row",
        "--line mean",
    ]);
    assert!(
        none.out.contains("Sq ") && none.out.contains("lay = "),
        "{}",
        none.out
    );
    let json = info(&["--json"]).json();
    assert_eq!(json["rows"], 3);
    assert!(json["areal"]["sdr"].as_f64().unwrap() > 0.0, "{json:#}");
    assert_eq!(json["error"]["code"], "E119");
    // A trace without parameters is one document too.
    bench.write("short.csv", trace("x_um,z_um", 150));
    let short = bench.run(&["profile", "info", "short.csv", "--json"]);
    assert_eq!(short.json()["error"]["code"], "E120");
    assert!(short.err.starts_with("E120 "), "{}", short.err);
    let ra = |more: &[&str]| {
        let found = info(&[more, &["--json"]].concat()).well().json();
        (
            found["iso4287"]["ra_um"].as_f64().unwrap(),
            found["warnings"].to_string(),
        )
    };
    let (row, _) = ra(&["--row", "2"]);
    let (mean, notes) = ra(&["--line", "mean"]);
    assert!(mean < row && notes.contains("W320"), "{mean} {row} {notes}");
    let short = info(&["--line", "column", "--row", "1"]);
    short.refused(2, "E106", &["flank.sur: 3 points"]);
}

#[test]
fn a_case_takes_lines_of_a_surface() {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("flank.sur", sur(6000, 3, 2, 0));
    let run = |line: &str| {
        bench.write("case.toml", with_line("pinion", line));
        bench.run(&["run", "case.toml", "--no-output", "--json"])
    };
    let of = |line: &str| {
        run(line).well().json()["summary"]["loss_w"]
            .as_f64()
            .unwrap()
    };
    let row = of("pinion = { file = \"flank.sur\", row = 2 }");
    let mean = of("pinion = { file = \"flank.sur\", line = \"mean\" }");
    assert_ne!(row, mean);
    // Rows 1 and 3 of three, each a tooth of its own.
    let rows = of("pinion = { file = \"flank.sur\", rows = 2 }");
    let listed = of(
        "pinion = { traces = [{ file = \"flank.sur\", row = 1 }, { file = \"flank.sur\", row = 3 }] }",
    );
    assert_eq!(rows, listed);
    assert_ne!(rows, row);
    let said = run("pinion = { file = \"flank.sur\", rows = 4 }");
    said.refused_json("E209", "surface.pinion.rows = 4");
    let said = run("pinion = { file = \"flank.sur\", rows = 2, row = 1 }");
    said.refused_json("E205", "leave row and line out");
    let said = run("pinion = { file = \"pinion.csv\", line = \"mean\" }");
    let says = "surface.pinion.file: this file holds a single profile; leave line out";
    assert!(said.err.contains(says), "{}", said.err);
    let said = bench.run(&["profile", "info", "pinion.csv", "--line", "mean"]);
    said.refused(2, "E119", &["pinion.csv: the file holds a single profile"]);
}

#[test]
fn files_without_heights_and_replicas_are_told() {
    let bench = Bench::new();
    bench.write("colours.sur", sur(200, 3, 12, 0));
    let said = bench.run(&["profile", "info", "colours.sur"]);
    said.refused(
        2,
        "E320",
        &["colours.sur: the file (Digital Surf (sur, pro)) holds a colour image"],
    );
    bench.write("two.mat", two_arrays());
    let said = bench.run(&["profile", "info", "two.mat"]);
    said.refused(
        2,
        "E321",
        &["two.mat: the file holds several arrays", "left, right"],
    );
    bench.write("cast.sur", sur(6000, 1, 2, 1));
    let said = bench.run(&[
        "profile",
        "info",
        "cast.sur",
        "--lambda-c",
        "0.25 mm",
        "--json",
    ]);
    assert!(said.well().json()["warnings"].to_string().contains("W321"));
}

#[test]
fn a_stated_unit_never_shrinks_a_surface_that_has_its_own() {
    let bench = Bench::new();
    bench.write("flank.sur", sur(6000, 1, 2, 0));
    bench.write_flanks();
    let ra = |file: &str, unit: &[&str]| {
        let info = ["profile", "info", file, "--lambda-c", "0.25 mm", "--json"];
        let found = bench.run(&[&info, unit].concat()).well().json();
        let ra = found["iso4287"]["ra_um"].as_f64().unwrap();
        (ra, found["warnings"].to_string())
    };
    let (plain, _) = ra("flank.sur", &[]);
    let (stated, notes) = ra("flank.sur", &["--z-unit", "um"]);
    assert!(
        stated == plain && notes.contains("W323"),
        "{stated} {notes}"
    );
    let (_, notes) = ra("pinion.csv", &["--z-unit", "nm"]);
    assert!(notes.contains("W322"), "{notes}");
}

#[test]
fn heights_too_small_for_a_flank_are_refused_by_a_case() {
    let bench = Bench::new();
    bench.write_flanks();
    let small = rows(6000, |i, z| format!("{};{:.9}", 0.5 * i as f64, 1e-6 * z));
    bench.write("small.csv", format!("x [um];z [um]\n{small}"));
    bench.write(
        "case.toml",
        with_line("pinion", "pinion = { file = \"small.csv\" }"),
    );
    let said = bench.run(&["run", "case.toml", "--no-output"]);
    said.refused(2, "E131", &["small.csv", "no flank is as smooth as"]);
}

#[test]
fn material_ratios_and_heights_are_told_where_asked_for() {
    let bench = Bench::new();
    // Straight flanks from -1 um to 1 um: the material ratio falls evenly.
    let zigzag = |i: usize| 2.0 * ((i % 200) as f64 / 100.0 - 1.0).abs() - 1.0;
    let rows: String = (0..4000)
        .map(|i| format!("{:.1};{:.4}\n", 0.5 * i as f64, zigzag(i)))
        .collect();
    bench.write("zigzag.csv", format!("x [um];z [um]\n{rows}"));
    let asked = [
        "profile",
        "info",
        "zigzag.csv",
        "--as-is",
        "--rmr",
        "0.5um",
        "--rdc",
        "5:75",
    ];
    let said = bench.run(&asked).well();
    assert!(
        said.out.contains("Rmr(0.5 um) 25.") && said.out.contains("Rdc(5 %, 75 %) 1.4"),
        "{}",
        said.out
    );
    let found = bench.run(&[&asked[..], &["--json"]].concat()).well().json();
    let levels = &found["material_levels"];
    let percent = levels["rmr"][0]["percent"].as_f64().unwrap();
    let height = levels["rdc"][0]["um"].as_f64().unwrap();
    assert!(
        (percent - 25.0).abs() < 0.5 && (height - 1.4).abs() < 0.01,
        "{levels}"
    );
    let wrong = bench.run(&["profile", "info", "zigzag.csv", "--rdc", "75:5"]);
    assert!(
        wrong.status != 0 && wrong.err.contains("the smaller first"),
        "{}",
        wrong.err
    );
}
