//! One case has one number, by whatever command, order, number of threads or shard it is computed. The number of windows is left
//! free: it follows from the contacts, and must not follow from the first case that is computed.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;

use crate::bench::{Bench, E_DRIVE, NO_RELIEF, heights, root};
use crate::surfaces::digital_surf;

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

/// Numbers of a column of a table that a command wrote; `None` where a cell is empty.
fn column(bench: &Bench, file: &str, name: &str) -> Vec<Option<f64>> {
    let mut reader = csv::ReaderBuilder::new()
        .comment(Some(b'#'))
        .from_path(bench.path(file))
        .unwrap();
    let head = reader.headers().unwrap().clone();
    let place = head.iter().position(|own| own == name);
    let place = place.unwrap_or_else(|| panic!("{name} is not in {file}: {head:?}"));
    let cell = |record: csv::StringRecord| record[place].parse().ok();
    reader
        .records()
        .map(|record| cell(record.unwrap()))
        .collect()
}

/// Checks that a page contains what a run prints.
fn shows(bench: &Bench, page: &str, printed: &str) {
    let text = fs::read_to_string(bench.path(page)).unwrap();
    assert!(text.contains(printed), "{printed} is not on {page}");
}

/// The loss that a run prints.
fn printed_loss(bench: &Bench, case: &str, more: &[&str]) -> String {
    let text = bench
        .run(&[&["run", case, "--no-output"][..], more].concat())
        .well()
        .unwrapped();
    let printed = text.split("loss ").nth(1).unwrap();
    printed.lines().next().unwrap().trim().to_owned()
}

/// "700 (530..920) W" of "700 W (530..920)".
fn unit_last(printed: &str) -> String {
    format!("{} W", printed.replacen(" W", "", 1))
}

/// Checks that every face of a case states one loss, and one loss at the medians where it is drawn.
fn one_loss(bench: &Bench, case: &str, more: &[&str]) {
    let is = |found: f64, expected: f64, face: &str| {
        let off = (found / expected - 1.0).abs();
        assert!(off < 1e-9, "{case} {more:?}, {face}: {found} {expected}");
    };
    let run = [&["run", case, "--json", "-o", "run"][..], more].concat();
    let result = bench.run(&run).well().json();
    let is_train = result["meshes"].is_array();
    let is_drawn = !more.contains(&"--no-band");
    let summary = if is_train {
        &result
    } else {
        &result["summary"]
    };
    let of = |json: &serde_json::Value, key: &str| json[key].as_f64().unwrap();
    let loss = of(summary, "loss_w");
    let at_medians = summary["loss_at_medians_w"].as_f64();
    assert_eq!(at_medians.is_some(), is_drawn);
    let at_medians = at_medians.unwrap_or(loss);
    // The result itself: the median that is printed, efficiency, and parts that add up.
    let drawn = if is_train {
        &result["loss_distribution"]
    } else {
        &result["uncertainty"]["loss"]
    };
    if is_drawn {
        is(of(drawn, "median_w"), loss, "median of the samples");
    }
    let power = of(summary, "power_in_w");
    is(
        (1.0 - of(summary, "efficiency")) * power,
        loss,
        "efficiency",
    );
    if is_train {
        let meshes = result["meshes"].as_array().unwrap();
        let sum = |key: &str| -> f64 {
            let watts = meshes.iter().map(|mesh| of(mesh, "count") * of(mesh, key));
            watts.sum()
        };
        is(sum("loss_w"), loss, "meshes");
        if is_drawn {
            is(
                sum("loss_at_medians_w"),
                at_medians,
                "meshes at the medians",
            );
        }
        let kinds = result["kinds"].as_object().unwrap().values();
        is(
            kinds.map(|watts| watts.as_f64().unwrap()).sum(),
            loss,
            "kinds",
        );
        let shafts = result["shafts"].as_array().unwrap().iter();
        is(
            shafts.map(|shaft| of(shaft, "power_w")).sum(),
            loss,
            "shafts",
        );
        is(
            of(summary, "power_in_w") - of(summary, "power_out_w"),
            loss,
            "power out",
        );
        let counts = column(bench, "run/meshes.csv", "count");
        let rows = column(bench, "run/meshes.csv", "loss_w");
        let rows = counts
            .iter()
            .zip(&rows)
            .map(|(n, w)| n.unwrap() * w.unwrap());
        is(rows.sum(), loss, "meshes.csv");
    } else {
        let parts = ["film_w", "lubricated_asperity_w", "boundary_w", "rolling_w"];
        is(
            parts.map(|key| of(summary, key)).iter().sum(),
            loss,
            "parts",
        );
        let powers = column(bench, "run/losses.csv", "power_w");
        is(powers[0].unwrap() + powers[1].unwrap(), loss, "losses.csv");
        let of_path = |key: &str| column(bench, "run/path.csv", key);
        let (weights, sliding) = (of_path("weight_m"), of_path("sliding_w_per_m"));
        let rows = weights.iter().zip(sliding).zip(of_path("rolling_w_per_m"));
        let rows = rows.map(|((w, s), r)| w.unwrap() * (s.unwrap() + r.unwrap()));
        is(rows.sum(), loss, "path.csv");
        let offsets = column(bench, "run/offsets.csv", "loss_w");
        let mean = offsets.iter().flatten().sum::<f64>() / offsets.len() as f64;
        is(mean, loss, "offsets.csv");
        let friction = of(summary, "mu_equivalent") * of(summary, "loss_factor_local");
        is(friction, 1.0 - of(summary, "efficiency"), "mu_equivalent");
    }
    // What is printed, by terminal and page.
    let printed = &*printed_loss(bench, case, more);
    let number: f64 = printed.split(' ').next().unwrap().parse().unwrap();
    assert!((number / loss - 1.0).abs() < 0.06, "{printed} {loss}");
    shows(bench, "run/report.html", printed);

    // Other commands on the same case, which state it as a run does.
    let faces = more.iter().filter(|option| **option != "--no-band");
    let faces: Vec<&str> = faces.copied().collect();
    if is_drawn {
        let other = "other: model.hysteresis=2 %";
        let compare = ["compare", case, "--variant", "as is", "--variant", other];
        let compare = [&compare[..], &["--json", "-o", "compared"], &faces].concat();
        let compared = bench.run(&compare).well().json();
        let own = &compared["finishes"][0];
        is(of(own, "loss_w"), loss, "compare");
        is(
            of(own, "loss_at_medians_w"),
            at_medians,
            "compare at the medians",
        );
        let rows = column(bench, "compared/compare.csv", "loss_w");
        is(rows[0].unwrap(), loss, "compare.csv");
        shows(bench, "compared/compare.html", &unit_last(printed));
        let changes = ["sensitivity", case, "--json", "-o", "sensitivity"];
        let changes = bench.run(&[&changes[..], &faces].concat()).well().json();
        is(of(&changes, "loss_w"), loss, "sensitivity");
        is(
            of(&changes, "loss_at_medians_w"),
            at_medians,
            "sensitivity at the medians",
        );
        // The page states no interval of it, so two or three digits.
        let page = fs::read_to_string(bench.path("sensitivity/sensitivity.html")).unwrap();
        let (_, stated) = page.split_once(">Loss ").unwrap();
        let stated: f64 = stated.split(' ').next().unwrap().parse().unwrap();
        assert!(
            (stated / loss - 1.0).abs() < 0.01,
            "page of the sensitivity: {stated} {loss}"
        );
    }
    let columns = if is_drawn {
        "\"loss_w\", \"loss_at_medians_w\", \"loss_p05_w\""
    } else {
        "\"loss_w\""
    };
    let set = faces.iter().filter_map(|option| option.split_once('='));
    let axis = |(key, value): (&str, &str)| {
        let quoted = value.trim_matches(['[', ']']);
        format!("[[axis]]\nkey = \"{key}\"\nvalues = [\"{quoted}\"]\n")
    };
    let hysteresis = "[[axis]]\nkey = \"model.hysteresis\"\nvalues = [\"1 %\", \"2 %\"]\n";
    let axes = set.map(axis).collect::<String>() + hysteresis;
    let study = format!("case = \"{case}\"\ncolumns = [{columns}]\n{axes}");
    bench.write("study.toml", study);
    let hysteresis = ["--set", "model.hysteresis=1 %"];
    let run = [
        &["run", case, "--json", "--no-output"][..],
        more,
        &hysteresis,
    ]
    .concat();
    let result = bench.run(&run).well().json();
    let summary = if is_train {
        &result
    } else {
        &result["summary"]
    };
    let parts = ["sweep", "run", "study.toml", "--parts", "parts", "-q"];
    bench.run(&parts).well();
    let merge = [
        "sweep",
        "merge",
        "study.toml",
        "--parts",
        "parts",
        "-q",
        "-o",
        "swept",
    ];
    bench.run(&merge).well();
    let swept = column(bench, "swept/sweep.csv", "loss_w");
    is(swept[0].unwrap(), of(summary, "loss_w"), "sweep.csv");
    if is_drawn {
        let swept = column(bench, "swept/sweep.csv", "loss_at_medians_w");
        is(
            swept[0].unwrap(),
            of(summary, "loss_at_medians_w"),
            "sweep.csv",
        );
    }
}

/// Checks that a map with its exports and a cycle on it state the loss of a run.
fn one_loss_of_a_map(bench: &Bench, case: &str, [torque, speed]: [f64; 2], more: &[&str]) {
    let run = [&["run", case, "--json", "--no-output"][..], more].concat();
    let result = bench.run(&run).well().json();
    let summary = if result["meshes"].is_array() {
        &result
    } else {
        &result["summary"]
    };
    let of = |key: &str| summary[key].as_f64().unwrap();
    let map = [
        "map",
        case,
        "--torque",
        &torque.to_string(),
        "--speed",
        &format!("3000,{speed}"),
        "--temperature",
        "90",
    ];
    let map = [&map[..], &["--export", "csv", "-o", "map", "-q"], more].concat();
    bench.run(&map).well();
    let speeds = column(bench, "map/map.csv", "speed_rpm");
    let at = speeds.iter().position(|at| *at == Some(speed)).unwrap();
    let is = |found: Option<f64>, expected: f64, face: &str| {
        let found = found.unwrap();
        assert!(
            (found / expected - 1.0).abs() < 1e-9,
            "{case} {more:?}, {face}: {found} {expected}"
        );
    };
    let loss = of("loss_w");
    let number = |name: &str| column(bench, "map/map.csv", name)[at];
    is(number("loss_w"), loss, "map.csv");
    is(
        number("loss_at_medians_w"),
        of("loss_at_medians_w"),
        "map.csv at the medians",
    );
    is(
        number("efficiency"),
        of("efficiency"),
        "efficiency of map.csv",
    );
    let omega = speed * std::f64::consts::PI / 30.0;
    is(
        number("loss_torque_nm"),
        loss / omega,
        "loss torque of map.csv",
    );
    is(
        column(bench, "map/extremes.csv", "loss_w")[0],
        loss,
        "extremes.csv",
    );
    let name = case.strip_suffix(".toml").unwrap();
    let exported = format!("map/export/{name}.csv");
    let exported = column(bench, &exported, "loss_torque_nm")[at];
    is(exported, loss / omega, "export");
    let printed = printed_loss(bench, case, more);
    shows(bench, "map/map.html", &unit_last(&printed));
    bench.write(
        "cycle.csv",
        format!("time_s,torque_nm,speed_rpm\n0,{torque},{speed}\n3600,{torque},{speed}\n"),
    );
    bench
        .run(&["cycle", "map", "cycle.csv", "-o", "cycle", "-q"])
        .well();
    is(
        column(bench, "cycle/cycle.csv", "loss_w")[0],
        loss,
        "cycle.csv",
    );
    let energies = column(bench, "cycle/energies.csv", "lost_at_medians_wh");
    is(
        energies[0],
        of("loss_at_medians_w"),
        "energies.csv at the medians",
    );
    // The sampling of an energy errs less than that of a loss, which moves its median little.
    let lost = column(bench, "cycle/energies.csv", "lost_wh")[0].unwrap();
    assert!((lost / loss - 1.0).abs() < 0.01, "{lost} {loss}");
}

const FEW: [&str; 4] = ["--set", "model.positions=4", "--set", "model.offsets=4"];

#[test]
#[ignore = "slow: just test-all"]
fn slow_every_face_of_a_pair_states_one_loss() {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("case.toml", E_DRIVE);
    one_loss(&bench, "case.toml", &FEW);
    one_loss_of_a_map(&bench, "case.toml", [145.0, 9000.0], &FEW);
    one_loss(&bench, "case.toml", &[&FEW[..], &["--no-band"]].concat());
    let [pinion, wheel] = flanks("superfinished");
    let [pinion, wheel] = [("pinion", pinion), ("wheel", wheel)]
        .map(|(gear, file)| format!("surface.{gear}.file={file}"));
    let superfinished = [&FEW[..], &["--set", &pinion, "--set", &wheel]].concat();
    one_loss(&bench, "case.toml", &superfinished);
    one_loss_of_a_map(&bench, "case.toml", [145.0, 9000.0], &superfinished);
    // The median of a relief that is not stated is far from the run at the medians.
    bench.write("unstated.toml", E_DRIVE.replace(NO_RELIEF, ""));
    one_loss(&bench, "unstated.toml", &FEW);
    one_loss_of_a_map(&bench, "unstated.toml", [145.0, 9000.0], &FEW);
}

#[test]
#[ignore = "slow: just test-all"]
fn slow_every_face_of_areal_windows_states_one_loss() {
    let bench = Bench::new();
    let rows: Vec<Vec<f64>> = (0..24)
        .map(|row| heights(1500 + 40 * row)[40 * row..].to_vec())
        .collect();
    bench.write("flank.sur", digital_surf(&rows, 2.0));
    let scan = |text: String, gear: &str| {
        let file = format!("{gear} = {{ file = \"{gear}.csv\"");
        text.replace(&file, &format!("{gear} = {{ file = \"flank.sur\""))
    };
    let case = ["pinion", "wheel"]
        .into_iter()
        .fold(E_DRIVE.to_owned(), scan);
    let case = case.replace(
        "cutoff = \"0.25 mm\"",
        "cutoff = \"0.08 mm\"\ncontact = \"patch\"",
    );
    bench.write("case.toml", case.replace("145 N m", "30 N m"));
    let lay = [&FEW[..], &["--set", "model.lay=0.18"]].concat();
    one_loss(&bench, "case.toml", &lay);
    one_loss_of_a_map(&bench, "case.toml", [30.0, 9000.0], &lay);
}

#[test]
#[ignore = "slow: just test-all"]
fn slow_every_face_of_a_train_states_one_loss() {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("case.toml", crate::gear::TRAIN);
    one_loss(&bench, "case.toml", &FEW);
    one_loss_of_a_map(&bench, "case.toml", [100.0, 6000.0], &FEW);
}

#[test]
#[ignore = "slow: just test-all"]
fn slow_every_face_of_reference_solutions_states_one_loss_at_its_lay() {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("case.toml", E_DRIVE);
    let few = [
        "load_share=ehl",
        "ehl.cells=128",
        "ehl.travel=2",
        "ehl.records=2",
        "ehl.cache=kept",
    ];
    let few = few.map(|key| format!("model.{key}"));
    let few = few.iter().flat_map(|key| ["--set", key]);
    let few: Vec<&str> = FEW.into_iter().chain(few).collect();
    one_loss(&bench, "case.toml", &few);
    one_loss(&bench, "case.toml", &[&few[..], &["--no-band"]].concat());
    let loss = |lay: &str| {
        let run = ["run", "case.toml", "--json", "--no-output", "--set", lay];
        let result = bench.run(&[&run[..], &few].concat()).well().json();
        result["summary"]["loss_at_medians_w"].as_f64().unwrap()
    };
    let [across, crossed] = ["model.lay=0", "model.lay=0.158"].map(loss);
    assert!(crossed > 1.02 * across, "{crossed} {across}");
    // No interval of a change by windows that the reference solutions do not have.
    let changes = ["sensitivity", "case.toml", "--json"];
    let changes = bench.run(&[&changes[..], &few].concat()).well().json();
    let rows = changes["rows"].as_array().unwrap().iter();
    let mut intervals = rows.map(|row| &row["effect"]["quantiles_w"]);
    assert!(intervals.all(serde_json::Value::is_null));
}
