//! Relief that is taken from the traces: what is said of it, where it counts, what it needs.

use crate::bench::{Bench, E_DRIVE, NO_RELIEF, rows};

/// Both flanks over their whole active length, with `relief` \[µm\] at the last 1.2 mm towards the tip.
fn bench(relief: f64) -> Bench {
    let bench = Bench::new();
    let flank = |rough: f64| {
        let table = rows(7200, |i, z| {
            let from_tip = 0.5 * (7199 - i) as f64;
            let missing = relief * (1.0 - from_tip / 1200.0).max(0.0).powi(2);
            format!("{:.1},{:.5}", 0.5 * i as f64, rough * z - missing)
        });
        format!("x_um,z_um\n{table}")
    };
    bench.write("pinion.csv", flank(1.0));
    bench.write("wheel.csv", flank(0.8));
    let case = E_DRIVE
        .replace(
            NO_RELIEF,
            "pinion = { relief = \"from-trace\" }\nwheel = { relief = \"from-trace\" }\n",
        )
        .replace(
            "pinion.csv\" }",
            "pinion.csv\", at = { diameter = \"48.7101 mm\", x = \"3599.5 um\" } }",
        )
        .replace(
            "wheel.csv\", mirrored = true }",
            "wheel.csv\", at = { diameter = \"136.969 mm\", x = \"3599.5 um\" } }",
        );
    bench.write("case.toml", case);
    bench
}

#[test]
fn the_relief_of_the_traces_is_told_and_counts() {
    let bench = bench(9.0);
    let run = ["run", "case.toml", "-o", "out", "--notes"];
    let said = bench.run(&run).well().unwrapped();
    assert!(said.contains("relief  from the traces: pinion "), "{said}");
    assert!(
        said.contains("W434 form and roughness of the pinion are parted at "),
        "{said}"
    );
    let result = std::fs::read(bench.path("out/result.json")).unwrap();
    let result: serde_json::Value = serde_json::from_slice(&result).unwrap();
    for flank in result["flanks"].as_array().unwrap() {
        let form = &flank["form"];
        let at = |key: &str| form[key].as_f64().unwrap();
        assert!(
            (at("at_tip_um") - 9.0).abs() < 2.5 && at("at_root_um") < 1.5,
            "{form}"
        );
        assert!(at("cutoff_mm") > 0.5);
        let rolls = form["roll_length_mm"].as_array().unwrap();
        assert_eq!(rolls.len(), form["height_um"].as_array().unwrap().len());
    }
    let page = std::fs::read_to_string(bench.path("out/report.html")).unwrap();
    assert!(page.contains("Relief from the traces") && page.contains("id=\"relief\""));
    let factor = |extra: &[&str]| {
        let found = bench.run(&[&["gear", "case.toml", "--json"], extra].concat());
        found.well().json()["loss_factor_local"].as_f64().unwrap()
    };
    let drawn = [
        "--set",
        "gears.pinion.relief=drawn",
        "--set",
        "gears.wheel.relief=drawn",
    ];
    assert!(factor(&[]) < 0.96 * factor(&drawn));
    // The result repeats from the case that it keeps.
    let study = bench
        .run(&["sensitivity", "case.toml", "--json"])
        .well()
        .json();
    assert!(!study.to_string().contains("tip relief"), "{study}");
}

#[test]
fn a_map_has_the_relief_that_a_run_has() {
    let bench = bench(9.0);
    let map = [
        "map",
        "case.toml",
        "-o",
        "map",
        "--torque",
        "100,145",
        "--speed",
        "9000",
        "--temperature",
        "90",
    ];
    bench.run(&map).well();
    let rows = std::fs::read_to_string(bench.path("map/map.csv")).unwrap();
    let lines: Vec<&str> = rows.lines().filter(|line| !line.starts_with('#')).collect();
    let columns: Vec<&str> = lines[0].split(',').collect();
    let column = |name: &str| columns.iter().position(|column| *column == name).unwrap();
    let value = |line: &str, name: &str| {
        line.split(',')
            .nth(column(name))
            .unwrap()
            .parse::<f64>()
            .unwrap()
    };
    for torque in [100.0, 145.0] {
        let is_here =
            |line: &&&str| value(line, "torque_nm") == torque && value(line, "speed_rpm") == 9000.0;
        let line = lines[1..].iter().find(is_here).unwrap();
        let set = format!("operation.torque={torque} N m");
        let run = ["run", "case.toml", "--no-output", "--json", "--set", &set];
        let run = bench.run(&run).well().json()["summary"]["loss_w"]
            .as_f64()
            .unwrap();
        assert!(
            (value(line, "loss_w") / run - 1.0).abs() < 1e-9,
            "{line} {run}"
        );
    }
}

#[test]
fn a_relief_that_the_trace_does_not_show_is_refused() {
    let bench = bench(9.0);
    let refused = |set: &[&str], code: &str, says: &[&str]| {
        let set: Vec<&str> = set.iter().flat_map(|set| ["--set", set]).collect();
        bench
            .run(&[&["check", "case.toml"], &set[..]].concat())
            .refused(2, code, says);
    };
    let unplaced = "surface.pinion={ file = \"pinion.csv\" }";
    refused(
        &[unplaced],
        "E204",
        &["gears.pinion.relief: the place of pinion.csv on the flank is not known"],
    );
    let beside = "surface.pinion.at={ roll_length = \"4.5 mm\" }";
    refused(
        &[beside],
        "E204",
        &[
            "pinion.csv reaches from roll length 4.500 to",
            "the active flank from 3.78",
        ],
    );
    refused(
        &["surface.form=poly2"],
        "E204",
        &["surface.form = \"poly2\" removes the form"],
    );
    refused(
        &["surface.pinion={ rq = \"0.4 um\" }"],
        "E204",
        &["known by roughness values alone"],
    );
    let crowned = "gears.wheel.profile_crowning=5 um";
    refused(
        &[crowned],
        "E205",
        &["gears.wheel.profile_crowning: is in the trace already"],
    );
    let high = self::bench(300.0);
    let check = ["check", "case.toml"];
    high.run(&check)
        .refused(2, "E204", &["no relief of this module more than 90 um"]);
    let uniform = [
        "check",
        "case.toml",
        "--set",
        "model.load_distribution=uniform",
    ];
    bench
        .run(&uniform)
        .refused(2, "E209", &["model.load_distribution"]);
}
