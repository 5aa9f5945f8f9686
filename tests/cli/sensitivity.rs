//! `asperity sensitivity` through the command.

use std::fs;

use serde_json::Value;

use crate::bench::{Bench, E_DRIVE};

fn bench(case: &str) -> Bench {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("case.toml", case);
    bench
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

#[test]
fn one_thing_changes_at_a_time_and_its_parts_add_up() {
    let bench = bench(E_DRIVE);
    let arguments = ["sensitivity", "case.toml", "-o", "out"];
    let found = bench
        .run(&[&arguments[..], &["--json"]].concat())
        .well()
        .json();
    let rows = found["rows"].as_array().unwrap();
    let of = |what: &str, to: &str| {
        let mut named = rows
            .iter()
            .filter(|row| row["what"].as_str().unwrap().starts_with(what));
        let row = named.find(|row| row["to"] == to);
        row.unwrap_or_else(|| panic!("{what} {to}: {found:#}"))["effect"].clone()
    };
    for row in rows {
        let effect = &row["effect"];
        assert!(effect.is_object(), "{row:#}");
        let parts = ["film_w", "lubricated_asperity_w", "boundary_w", "rolling_w"];
        let sum: f64 = parts.iter().map(|part| number(&effect[part])).sum();
        assert!(
            (sum - number(&effect["difference_w"])).abs() < 1e-6,
            "{row:#}"
        );
        let change = number(&effect["difference_w"]) / number(&found["loss_w"]);
        assert!(
            (change - number(&effect["change"])).abs() < 1e-12,
            "{row:#}"
        );
    }
    let watts = |what: &str, to: &str| number(&of(what, to)["difference_w"]);
    assert!(watts("heights of both flanks", "× 0.8") < 0.0);
    assert!(watts("heights of both flanks", "× 1.25") > 0.0);
    // A boundary layer rubs in proportion to its coefficient.
    let [low, high] = ["0.08", "0.1"].map(|to| watts("boundary friction 0.09", to));
    assert!(low < 0.0 && (high / -low - 1.0).abs() < 0.1, "{low} {high}");
    assert_eq!(of("heights of both flanks", "× 0.8")["rolling_w"], 0.0);
    assert!(watts("tip relief", "5 and 5 um") < 0.0);
    assert!(
        rows.iter()
            .filter(|row| row["what"].as_str().unwrap().starts_with("wavelengths"))
            .count()
            >= 2
    );
    // The same through the keys of the case.
    let loss = |key: &str| {
        let arguments = ["run", "case.toml", "--no-output", "--no-band", "--json"];
        let arguments = [&arguments[..], &["--set", key]].concat();
        number(&bench.run(&arguments).well().json()["summary"]["loss_w"])
    };
    let at_medians = number(&found["loss_at_medians_w"]);
    let difference = loss("lubricant.base_oil=\"mineral\"") - at_medians;
    let expected = difference * number(&found["loss_w"]) / at_medians;
    assert!((watts("base oil", "mineral") / expected - 1.0).abs() < 1e-9);

    let table = fs::read_to_string(bench.path("out/sensitivity.csv")).unwrap();
    assert_eq!(table.lines().count(), 1 + rows.len());
    let page = fs::read_to_string(bench.path("out/sensitivity.html")).unwrap();
    assert!(page.contains("These are answers of the model, not measurements"));
    // The folder is its own: written again, never over something else.
    let text = bench.run(&arguments).well().out;
    assert!(text.contains("heights of both flanks     × 0.8 "), "{text}");
    bench
        .run(&["sensitivity", "case.toml", "-o", "."])
        .refused(2, "E401", &[]);
}

#[test]
fn a_change_that_cannot_be_run_says_why_and_a_calibrated_constant_is_changed() {
    let fitted = "[calibration]\nboundary_friction = { value = 0.1, low = 0.09, high = 0.11 }\n";
    let bench = bench(&format!("{E_DRIVE}{fitted}"));
    let uniform = [
        "sensitivity",
        "case.toml",
        "--set",
        "model.load_distribution=uniform",
    ];
    let found = bench
        .run(&[&uniform[..], &["--json"]].concat())
        .well()
        .json();
    let rows = found["rows"].as_array().unwrap();
    let relief = rows.iter().find(|row| row["group"] == "gears").unwrap();
    assert!(relief["effect"].is_null());
    let layer = rows.iter().filter(|row| row["group"] == "boundary layer");
    assert!(layer.clone().count() == 4 && layer.clone().all(|row| row["effect"].is_object()));
    assert!(
        relief["refused"]["code"].as_str().unwrap().starts_with('E'),
        "{relief}"
    );
    let text = bench.run(&uniform).well().out;
    let line = "tip relief 0 and 0 µm → 5 and 5 µm: E";
    assert!(text.contains(line), "{text}");
}
