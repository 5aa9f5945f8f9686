//! The ridges of the flanks in the report of a run.

use std::fs;

use crate::bench::{Bench, E_DRIVE};

#[test]
fn the_ridges_are_in_the_report_on_request_or_the_reason_why_not() {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("case.toml", E_DRIVE);
    let run = ["run", "case.toml", "--no-band", "--notes", "--ridges", "-o"];
    let said = bench.run(&[&run[..], &["found"]].concat()).well().out;
    let result = |folder: &str| -> serde_json::Value {
        let text = fs::read(bench.path(&format!("{folder}/result.json"))).unwrap();
        serde_json::from_slice(&text).unwrap()
    };
    let found = result("found");
    let ridges = &found["ridges"];
    let number = |key: &str| ridges[key].as_f64().unwrap();
    let saving = number("loss_at_medians_w") - number("pressed_at_medians_w");
    assert!(saving > 5.0, "{ridges}");
    let line = said.lines().find(|line| line.contains("ridges")).unwrap();
    let printed = line.split("saves ").nth(1).unwrap();
    let printed: f64 = printed.split(' ').next().unwrap().parse().unwrap();
    assert!((printed - saving).abs() <= 0.05 * saving, "{line}");
    // Without a band there is no interval.
    assert!(
        ridges
            .get("saving_quantiles_w")
            .is_none_or(serde_json::Value::is_null),
        "{ridges}"
    );
    assert!(!line.contains(".."), "{line}");
    assert!(!ridges["rows"].as_array().unwrap().is_empty());
    let page = fs::read_to_string(bench.path("found/report.html")).unwrap();
    assert!(page.contains("Ridges with the largest loss"));
    fs::remove_file(bench.path("found/report.html")).unwrap();
    bench.run(&["report", "found"]).well();
    let again = fs::read_to_string(bench.path("found/report.html")).unwrap();
    assert!(again.contains("Ridges with the largest loss"));

    let paper = ["none", "--formulation", "paper"];
    bench.run(&[&run[..], &paper[..]].concat()).well();
    let none = result("none");
    assert!(none.get("ridges").is_none_or(serde_json::Value::is_null));
    let why = none["no_ridges"].as_str().unwrap();
    assert!(why.contains("formulation"), "{why}");
    let page = fs::read_to_string(bench.path("none/report.html")).unwrap();
    let shown = why.replace('"', "&quot;");
    assert!(page.contains(&format!("Not computed: {shown}.")), "{why}");

    // Surrogates have no ridges to press.
    let ra = E_DRIVE.replace("file = \"pinion.csv\"", "ra = \"0.25 um\"");
    assert_ne!(ra, E_DRIVE);
    bench.write("ra.toml", &ra);
    bench
        .run(&["ridges", "ra.toml"])
        .refused(4, "E303", &["a flank has none"]);

    let plain = ["run", "case.toml", "--no-band", "-o", "plain"];
    bench.run(&plain).well();
    let page = fs::read_to_string(bench.path("plain/report.html")).unwrap();
    assert!(!page.contains("Ridges with the largest loss"));
}
