//! One case has one number, by whatever command, order, number of threads or shard it is computed. The number of windows is left
//! free: it follows from the contacts, and must not follow from the first case that is computed.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;

use crate::bench::{Bench, root};

const SPEED: &str =
    "[[axis]]\nkey = \"operation.speed\"\nvalues = [\"2000 1/min\", \"12000 1/min\"]\n";
const TEMPERATURE: &str =
    "[[axis]]\nkey = \"operation.bulk_temperature\"\nvalues = [\"50 °C\", \"120 °C\"]\n";
const OIL: &str =
    "[[axis]]\nkey = \"lubricant.viscosity.at_100\"\nvalues = [\"4 mm2/s\", \"8 mm2/s\"]\n";

/// The shipped drive at part load, where the windows differ most, on a short path.
fn bench() -> Bench {
    let bench = Bench::new();
    let file = root().join("fixtures/cases/e-drive.toml");
    let case = fs::read_to_string(file).unwrap();
    let profiles = root().join("fixtures/profiles");
    let case = case
        .replace("../profiles", profiles.to_str().unwrap())
        .replace("145 N m", "60 N m");
    bench.write("case.toml", case + "\n[model]\npositions = 2\n");
    bench
}

/// Files of the flanks of a finish.
fn flanks(finish: &str) -> [String; 2] {
    let profiles = root().join("fixtures/profiles");
    let names = match finish {
        "ground" => ["ground_pinion.csv", "ground_wheel.csv"],
        _ => ["superfinished.csv", "superfinished_wheel.csv"],
    };
    names.map(|name| profiles.join(name).to_str().unwrap().to_owned())
}

fn study(axes: &[&str]) -> String {
    let choice = |finish: &str| {
        let [pinion, wheel] = flanks(finish);
        format!(
            "choice.{finish} = {{ \"surface.pinion.file\" = \"{pinion}\", \"surface.wheel.file\" = \"{wheel}\" }}\n"
        )
    };
    let finishes = format!(
        "[[axis]]\nname = \"finish\"\n{}{}",
        choice("ground"),
        choice("superfinished")
    );
    let axes: Vec<&str> = axes
        .iter()
        .map(|axis| if axis.is_empty() { &*finishes } else { axis })
        .collect();
    format!(
        "case = \"case.toml\"\ncolumns = [\"loss_w\", \"efficiency\", \"boundary_w\", \"offsets\"]\n\n{}",
        axes.join("\n")
    )
}

/// The rows of a merged sweep, each by its columns with their units, without the number of the case.
fn rows(bench: &Bench, folder: &str) -> BTreeSet<BTreeMap<String, String>> {
    let file = bench.path(folder).join("sweep.csv");
    let mut reader = csv::Reader::from_path(file).unwrap();
    let head = reader.headers().unwrap().clone();
    let row = |record: csv::StringRecord| {
        let cells = head.iter().zip(&record);
        cells
            .filter(|(name, _)| *name != "case")
            .map(|(name, cell)| match name.split_once(" [") {
                Some((name, unit)) => (
                    name.to_owned(),
                    format!("{cell} {}", &unit[..unit.len() - 1]),
                ),
                None => (name.to_owned(), cell.to_owned()),
            })
            .collect()
    };
    reader
        .records()
        .map(|record| row(record.unwrap()))
        .collect()
}

#[test]
fn a_study_with_free_windows_has_the_same_rows_in_any_order_on_any_threads_and_shards_and_they_are_those_of_runs()
 {
    let bench = bench();
    let orders = [["", SPEED, TEMPERATURE, OIL], [OIL, TEMPERATURE, SPEED, ""]];
    let mut all = Vec::new();
    for (order, axes) in orders.iter().enumerate() {
        bench.write("study.toml", study(axes));
        let ways: &[(&str, i32)] = match order {
            0 => &[("1", 1), ("2", 3)],
            _ => &[("4", 5)],
        };
        for (threads, shards) in ways {
            let parts = format!("parts-{order}-{shards}");
            for shard in 1..=*shards {
                let shard = format!("{shard}/{shards}");
                let run = ["sweep", "run", "study.toml", "--parts", &parts, "-q"];
                let how = ["--threads", threads, "--shard", &shard];
                bench.run(&[&run[..], &how].concat()).well();
            }
            let folder = format!("out-{order}-{shards}");
            let merge = ["sweep", "merge", "study.toml", "--parts", &parts];
            bench
                .run(&[&merge[..], &["-o", &folder, "-q"]].concat())
                .well();
            all.push(rows(&bench, &folder));
        }
    }
    let first = &all[0];
    assert_eq!(first.len(), 16);
    assert!(all.iter().all(|other| other == first));
    let windows: BTreeSet<&str> = first.iter().map(|row| &*row["offsets"]).collect();
    assert_eq!(windows.len(), 2, "one number for each finish: {windows:?}");
    for row in first {
        let [pinion, wheel] = flanks(&row["finish"]);
        let set = [
            format!("surface.pinion.file={pinion}"),
            format!("surface.wheel.file={wheel}"),
            format!("operation.speed={}", row["operation.speed"]),
            format!(
                "operation.bulk_temperature={}",
                row["operation.bulk_temperature"]
            ),
            format!(
                "lubricant.viscosity.at_100={}",
                row["lubricant.viscosity.at_100"]
            ),
        ];
        let mut run = vec!["run", "case.toml", "--json", "--no-output", "--no-band"];
        run.extend(set.iter().flat_map(|set| ["--set", set]));
        let summary = bench.run(&run).well().json()["summary"].clone();
        for column in ["loss_w", "efficiency", "boundary_w", "offsets"] {
            assert_eq!(
                summary[column].to_string(),
                row[column],
                "{column} of {row:?}"
            );
        }
    }
}

#[test]
fn points_of_a_map_and_finishes_of_a_comparison_are_those_of_runs() {
    let bench = bench();
    let map = [
        "map",
        "case.toml",
        "--torque",
        "20,60",
        "--speed",
        "3000,9000",
        "--temperature",
        "60,90",
        "--band",
        "none",
        "-q",
        "-o",
        "map",
    ];
    bench.run(&map).well();
    let mut reader = csv::Reader::from_path(bench.path("map").join("map.csv")).unwrap();
    let head = reader.headers().unwrap().clone();
    let mut points = 0;
    for record in reader.records() {
        let record = record.unwrap();
        let cell = |name: &str| &record[head.iter().position(|own| own == name).unwrap()];
        // Standstill is a point of every map, and no case.
        if cell("speed_rpm") == "0.0" {
            continue;
        }
        let set = [
            format!("operation.torque={} N m", cell("torque_nm")),
            format!("operation.speed={} 1/min", cell("speed_rpm")),
            format!("operation.bulk_temperature={} °C", cell("temperature_c")),
        ];
        let mut run = vec!["run", "case.toml", "--json", "--no-output", "--no-band"];
        run.extend(set.iter().flat_map(|set| ["--set", set]));
        let summary = bench.run(&run).well().json()["summary"].clone();
        assert_eq!(summary["loss_w"].to_string(), cell("loss_w"), "{set:?}");
        points += 1;
    }
    assert_eq!(points, 8);
    let finishes = ["ground", "superfinished"];
    let named = finishes.map(|name| format!("{name}={}", flanks(name).join(",")));
    let compare = [
        "compare",
        "case.toml",
        "--json",
        "--finish",
        &named[0],
        "--finish",
        &named[1],
    ];
    let found = bench.run(&compare).well().json();
    for (name, compared) in finishes.iter().zip(found["finishes"].as_array().unwrap()) {
        let [pinion, wheel] = flanks(name);
        let set = [
            format!("surface.pinion.file={pinion}"),
            format!("surface.wheel.file={wheel}"),
        ];
        let mut run = vec!["run", "case.toml", "--json", "--no-output"];
        run.extend(set.iter().flat_map(|set| ["--set", set]));
        let alone = bench.run(&run).well().json();
        assert_eq!(compared["loss_w"], alone["summary"]["loss_w"], "{name}");
        let drawn = |result: &serde_json::Value| result["uncertainty"]["loss"].clone();
        assert_eq!(drawn(compared), drawn(&alone), "{name}");
        assert!(drawn(compared)["median_w"].is_number());
    }
}

#[test]
fn what_a_sensitivity_and_an_evidence_start_from_and_a_page_shows_is_a_run() {
    let bench = bench();
    let run = bench
        .run(&["run", "case.toml", "--json", "-o", "run"])
        .well();
    let run = run.json();
    let changes = bench.run(&["sensitivity", "case.toml", "--json", "-o", "sensitivity"]);
    assert_eq!(changes.well().json()["loss_w"], run["summary"]["loss_w"]);
    let drawn = &run["uncertainty"]["loss"];
    let evidence = bench
        .run(&["evidence", "case.toml", "--json"])
        .well()
        .json();
    for key in ["median_w", "quantiles_w", "sd_ln"] {
        assert!(!drawn[key].is_null());
        assert_eq!(evidence["loss"][key], drawn[key], "{key}");
    }
    // The page has the verdict of the terminal.
    let page = fs::read_to_string(bench.path("run/report.html")).unwrap();
    let text = bench
        .run(&["run", "case.toml", "--no-output"])
        .well()
        .unwrapped();
    let verdict = text.split("loss ").nth(1).unwrap();
    let verdict = &verdict[..=verdict.find(')').unwrap()];
    assert!(page.contains(verdict), "{verdict}");
}
