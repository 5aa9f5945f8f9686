//! Messages about files of instruments.

use std::io::{Cursor, Write};

use zip::ZipWriter;
use zip::write::SimpleFileOptions;

use crate::bench::{Bench, heights, line_of, rows, with_line};

/// An SDF text that states `points` heights in `profiles` profiles and holds 500.
fn sdf(points: usize, profiles: usize) -> String {
    let heights = rows(500, |_, z| format!("{z:.4}"));
    format!(
        "aISO-1.0\nNumPoints = {points}\nNumProfiles = {profiles}\nXscale = 5E-07\nZscale = 1E-06\n*\n{heights}*\n"
    )
}

#[test]
fn damaged_overlarge_and_crowded_files_are_refused() {
    let bench = Bench::new();
    bench.write("cut.sdf", sdf(900, 1));
    let said = bench.run(&["profile", "info", "cut.sdf"]);
    said.refused(2, "E117", &["cut.sdf: not a valid SDF", "500 of 900"]);
    bench.write("two.sdf", sdf(250, 2));
    let said = bench.run(&["profile", "info", "two.sdf"]);
    said.surveyed(&["two.sdf: the file holds 2 profiles", "--row"]);
    let second = bench.run(&["profile", "info", "two.sdf", "--row", "2", "--level"]);
    assert_eq!(second.status, 0, "{second:?}");
    // A file with a hole in it takes no room on the disk.
    bench.write("huge.csv", "x_um,z_um\n");
    let huge = std::fs::File::options()
        .write(true)
        .open(bench.path("huge.csv"))
        .unwrap();
    huge.set_len(5 << 30).unwrap();
    let said = bench.run(&["profile", "info", "huge.csv"]);
    said.refused(2, "E118", &["huge.csv: the file has 5368709120 bytes"]);
}

#[test]
fn what_an_instrument_leaves_in_doubt_is_noted() {
    let bench = Bench::new();
    let heights = rows(500, |_, z| format!("{z:.4}"));
    let noted = |name: &str, code: &str| {
        let said = bench.run(&["profile", "info", name, "--level"]);
        assert!(said.out.contains(code), "{name}: {said:?}");
    };
    let smd = "ISO 5436 - 2000 a\nPRF 1 ISO5436\nCX I 500 mm 1.0e0 D 5.0e-4\nCZ A 500 um 1.0e0 D\n\u{3}\n\u{3}\n";
    bench.write("a.smd", format!("{smd}{heights}\u{3}\n1\n\u{3}\n"));
    noted("a.smd", "W120");
    bench.write("npl.txt", format!("0.5\n{heights}"));
    noted("npl.txt", "W122");
    bench.write("a.tx1", format!("1.00000\n500\n{heights}"));
    bench.write("a.tx3", "Evaluation length\t0.2500000mm\n");
    noted("a.tx1", "W121");
    bench.write("b.tx1", format!("0.25000\n500\n{heights}"));
    bench.write("b.tx3", "Evaluation length\t0.25mm\n");
    noted("b.tx1", "W123");
}

/// An X3P surface of `count` rows of `points` points; each row starts elsewhere on the same waves.
fn surface(points: usize, count: usize) -> Vec<u8> {
    let all = heights(points + 500 * count);
    let row = |k: usize| all[500 * k..500 * k + points].iter();
    let data: String = (0..count)
        .flat_map(row)
        .map(|z| format!("<Datum>{:e}</Datum>", z * 1e-6))
        .collect();
    let axis = |name: &str, kind: &str, increment: &str| {
        format!(
            "<{name}><AxisType>{kind}</AxisType><DataType>D</DataType><Increment>{increment}</Increment><Offset>0</Offset></{name}>"
        )
    };
    let main = format!(
        "<ISO5436_2><Record1><FeatureType>SUR</FeatureType><Axes>{}{}{}</Axes></Record1><Record3><MatrixDimension>\
         <SizeX>{points}</SizeX><SizeY>{count}</SizeY><SizeZ>1</SizeZ></MatrixDimension><DataList>{data}</DataList></Record3></ISO5436_2>",
        axis("CX", "I", "5e-07"),
        axis("CY", "I", "5e-07"),
        axis("CZ", "A", "1"),
    );
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    zip.start_file("main.xml", SimpleFileOptions::default())
        .unwrap();
    zip.write_all(main.as_bytes()).unwrap();
    zip.finish().unwrap().into_inner()
}

#[test]
fn a_case_runs_on_rows_of_a_surface() {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("surface.x3p", surface(6000, 3));
    let run = |line: &str| {
        bench.write("case.toml", with_line("pinion", line));
        bench.run(&["run", "case.toml", "--no-output", "--json"])
    };
    let said = run("pinion = { file = \"surface.x3p\" }");
    let place = format!("(named at case.toml:{}", line_of("pinion"));
    assert_eq!(said.status, 2);
    for part in [
        "E119 surface.x3p: the file holds 3 profiles",
        "Write row = 1 .. 3 in surface.pinion",
        &place,
        "row, rows in surface.pinion",
    ] {
        assert!(said.err.contains(part), "{part:?} is not in {}", said.err);
    }
    let said = run("pinion = { file = \"surface.x3p\", row = 4 }");
    assert!(said.err.contains("row 4 is not among them"), "{}", said.err);
    let said = run("pinion = { file = \"pinion.csv\", row = 2 }");
    let says = "surface.pinion.file: this file holds a single profile; leave row out";
    assert!(said.err.contains(says), "{}", said.err);
    let of_row = |row: usize| {
        let result = run(&format!(
            "pinion = {{ file = \"surface.x3p\", row = {row} }}"
        ));
        result.well().json()
    };
    let (first, third) = (of_row(1), of_row(3));
    assert_ne!(first["summary"]["loss_w"], third["summary"]["loss_w"]);
    let ra =
        |result: &serde_json::Value| result["flanks"][0]["parameters"]["heights"]["ra"].clone();
    let shown = [
        "profile",
        "info",
        "surface.x3p",
        "--row",
        "3",
        "--lambda-c",
        "0.25 mm",
        "--json",
    ];
    let shown = bench.run(&shown).well().json();
    let third_ra: f64 = ra(&third)
        .as_str()
        .unwrap()
        .trim_end_matches(" nm")
        .parse()
        .unwrap();
    assert!((third_ra * 1e-3 - shown["iso4287"]["ra_um"].as_f64().unwrap()).abs() < 1e-9);
}

#[test]
fn two_rows_of_one_surface_are_two_traces() {
    let bench = Bench::new();
    bench.write("surface.x3p", surface(6000, 2));
    let notes = |wheel: usize| {
        let pinion = "pinion = { file = \"surface.x3p\", row = 1 }";
        let wheel = format!("wheel = {{ file = \"surface.x3p\", row = {wheel}, mirrored = true }}");
        let case = with_line("pinion", pinion);
        let old = "wheel = { file = \"wheel.csv\", mirrored = true }";
        bench.write("case.toml", case.replace(old, &wheel));
        bench.run(&["run", "case.toml", "--no-output"]).well().out
    };
    assert!(notes(1).contains("W404"));
    assert!(!notes(2).contains("W404"));
}
