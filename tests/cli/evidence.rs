//! `asperity evidence`.

use crate::bench::{Bench, E_DRIVE};

#[test]
fn measurements_are_listed_with_hours_by_what_they_leave() {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("case.toml", E_DRIVE);
    let arguments = ["evidence", "case.toml", "--hours", "traction-plan=3"];
    let said = bench.run(&arguments).well().out;
    assert!(
        said.contains("boundary friction from a Stribeck curve"),
        "{said}"
    );
    let text = std::fs::read_to_string(bench.path("results/case-evidence/evidence.json")).unwrap();
    let table: serde_json::Value = serde_json::from_str(&text).unwrap();
    let rows = table["rows"].as_array().unwrap();
    let of = |key: &str| rows.iter().find(|row| row["key"] == key);
    assert_eq!(of("traction-plan").unwrap()["hours"], 3.0);
    let widths: Vec<f64> = rows
        .iter()
        .map(|row| row["width"].as_f64().unwrap())
        .collect();
    assert!(widths.is_sorted() && widths.iter().all(|width| (0.1..=1.0).contains(width)));
    let median = table["loss"]["median_w"].as_f64().unwrap();
    for row in rows {
        let [low, high] = ["low_w", "high_w"].map(|end| row[end].as_f64().unwrap());
        assert!(low < median && median < high, "{row}");
    }
    // What the case states has no row.
    let stated = [
        "--set",
        "model.lay=0.1",
        "--set",
        "model.boundary_friction=0.08",
    ];
    let said = bench
        .run(&[&["evidence", "case.toml"], &stated[..]].concat())
        .well()
        .out;
    for words in ["tip relief", "lay of both", "Stribeck"] {
        assert!(!said.contains(words), "{words}: {said}");
    }
}

#[test]
fn hours_of_no_measurement_and_cases_without_interval_are_refused() {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("case.toml", E_DRIVE);
    for (hours, says) in [
        ("sleep=8", "no measurement is called \"sleep\""),
        ("traction-plan", "the hours must be a number"),
        ("traction-plan=-1", "the hours must be a number"),
        ("rig-day=soon", "the hours must be a number"),
    ] {
        let run = bench.run(&["evidence", "case.toml", "--hours", hours]);
        run.refused(2, "E209", &[hours, says]);
    }
    let paper = ["--set", "formulation=paper"];
    bench
        .run(&[&["evidence", "case.toml"], &paper[..]].concat())
        .refused(2, "E205", &["no interval"]);
}
