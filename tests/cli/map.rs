//! Maps, cycles and their exports through the command.

use std::collections::BTreeMap;
use std::fs;

use asperity::case::{load_set, open_source};
use asperity_studies::export::Format;

use crate::bench::{Bench, E_DRIVE, root, with_line};

/// Rows of a table by the names of its columns.
fn table(bench: &Bench, file: &str) -> Vec<BTreeMap<String, String>> {
    let text = fs::read_to_string(bench.path(file)).unwrap();
    let mut lines = text.lines();
    let header: Vec<&str> = lines.next().unwrap().split(',').collect();
    let row = |line: &str| {
        let cells = line.split(',').map(str::to_owned);
        header
            .iter()
            .map(|name| (*name).to_owned())
            .zip(cells)
            .collect()
    };
    lines.map(row).collect()
}

fn number(row: &BTreeMap<String, String>, column: &str) -> f64 {
    row[column].parse().unwrap()
}

fn bench(case: &str) -> Bench {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("case.toml", case);
    bench
}

const AXES: [&str; 4] = [
    "--torque=-100,2.5,40,100",
    "--speed=500,9000",
    "--temperature=60,90",
    "-o",
];

fn map(bench: &Bench, folder: &str, more: &[&str]) {
    let mut arguments = vec!["map", "case.toml"];
    arguments.extend(AXES);
    arguments.push(folder);
    arguments.extend(more);
    bench.run(&arguments).well();
}

#[test]
fn a_map_without_a_loss_is_refused() {
    let bench = bench(E_DRIVE);
    // Hertz pressures that no steel carries, at every point under load.
    let axes = ["--torque=900000,1000000", "--speed=4000,9000"];
    let said = bench.run(&[&["map", "case.toml", "-o", "m"][..], &axes].concat());
    said.refused(2, "E212", &["no point of the map has a loss"]);
    assert!(!bench.path("m/map.csv").exists());
}

#[test]
fn a_map_of_a_case_without_a_solution_at_standstill_is_refused_at_once() {
    let bench = bench(E_DRIVE);
    for key in ["model.load_share=ehl", "model.full_film=ehl-transient"] {
        let said = bench.run(&["map", "case.toml", "--set", key, "-o", "m"]);
        said.refused(2, "E205", &["standstill"]);
        assert!(!bench.path("m").exists());
    }
}

#[test]
fn a_cycle_on_a_map_with_a_hole_names_it() {
    let bench = bench(&with_line(
        "positions",
        "positions = 4\nload_share = \"lambda-star\"",
    ));
    // Hertz pressures that no steel carries at one of the torques.
    let axes = [
        "--torque=100,900000",
        "--speed=4000",
        "--band",
        "none",
        "-o",
        "m",
    ];
    bench
        .run(&[&["map", "case.toml"][..], &axes].concat())
        .well();
    bench.write(
        "trace.csv",
        "time_s,torque_nm,speed_rpm\n0,50,500\n1,50,500\n",
    );
    let said = bench.run(&["cycle", "m", "trace.csv", "--no-output"]);
    said.refused(
        2,
        "E402",
        &["2 of 4 points of the map have no result", "900000 N m"],
    );
    assert!(!said.err.contains("Name a result folder"), "{}", said.err);
}

#[test]
fn the_verdict_and_a_cycle_are_at_the_temperature_of_the_case() {
    let bench = bench(&with_line(
        "positions",
        "positions = 4\nload_share = \"lambda-star\"",
    ));
    bench.write(
        "trace.csv",
        "time_s,torque_nm,speed_rpm\n0,50,500\n1,50,500\n",
    );
    let says = |temperatures: &str, parts: &[&str]| {
        let axes = ["--torque=-200,200", "--speed=500,20000", "--band", "none"];
        let folder = ["--temperature", temperatures, "-o", temperatures];
        let line = [&["map", "case.toml"][..], &axes, &folder].concat();
        let said = bench.run(&line).well().unwrapped();
        for part in parts {
            assert!(said.contains(part), "{part}: {said}");
        }
        let cycle = [
            "cycle",
            temperatures,
            "trace.csv",
            "--no-output",
            "--allow-outside",
        ];
        bench.run(&cycle).well().unwrapped()
    };
    let of_case = says(
        "70,90",
        &["1/min, 90 °C.", "at the operating point of the case"],
    );
    assert!(of_case.contains("flanks at 90 °C"), "{of_case}");
    let next = says(
        "60,80",
        &[
            "1/min, 80 °C.",
            "at 80 °C, the temperature of the map next to the 90 °C of the case",
        ],
    );
    assert!(next.contains("flanks at 80 °C"), "{next}");
}

#[test]
fn quantiles_at_the_nodes_of_a_map_are_those_of_runs() {
    let bench = bench(E_DRIVE);
    let axes = [
        "--torque=-50,0.5,20,50,80,100",
        "--speed=500,4000,9000,12000",
        "--set",
        "model.load_share=lambda-star",
    ];
    let of = |folder: &str, more: &[&str]| {
        let arguments = [&["map", "case.toml", "-o", folder][..], &axes, more].concat();
        let said = bench.run(&arguments).well().out;
        (said, table(&bench, &format!("{folder}/map.csv")))
    };
    let (said, rows) = of("m", &[]);
    assert!(said.contains("The 90 % interval of the loss"), "{said}");
    let at = |torque: f64, speed: f64| {
        let is = |row: &&BTreeMap<String, String>| {
            number(row, "torque_nm") == torque && number(row, "speed_rpm") == speed
        };
        rows.iter().find(is).unwrap()
    };
    let columns = ["loss_w", "loss_p05_w", "loss_p95_w"];
    let row = at(20.0, 4000.0);
    let run = bench.run(&[
        "run",
        "case.toml",
        "--json",
        "--no-output",
        "--set",
        "model.load_share=lambda-star",
        "--set",
        "operation.torque=20 N m",
        "--set",
        "operation.speed=4000 1/min",
    ]);
    let loss = &run.well().json()["uncertainty"]["loss"];
    let there = [
        &loss["median_w"],
        &loss["quantiles_w"][0],
        &loss["quantiles_w"][1],
    ];
    for (column, there) in columns.iter().zip(there) {
        let (here, there) = (number(row, column), there.as_f64().unwrap());
        assert!(
            (here / there - 1.0).abs() < 1e-12,
            "{column}: {here} {there}"
        );
    }
    for row in &rows {
        let [median, low, high] = columns.map(|column| number(row, column));
        if number(row, "speed_rpm") == 0.0 {
            assert_eq!([median, low, high], [0.0; 3])
        } else {
            assert!(0.0 < low && low < median && median < high, "{row:?}")
        }
    }
    // The best efficiency is of a median, as the largest loss.
    let efficiency = |row: &BTreeMap<String, String>| {
        let [torque, speed, loss] =
            ["torque_nm", "speed_rpm", "loss_w"].map(|column| number(row, column));
        let at_pinion = torque * speed * std::f64::consts::PI / 30.0;
        let power_in = at_pinion.max(loss - at_pinion);
        100.0 * (1.0 - loss / power_in)
    };
    let best = rows.iter().map(efficiency).fold(0.0, f64::max);
    let line = said
        .lines()
        .find(|line| line.starts_with("these flanks"))
        .unwrap();
    let printed = line.split_whitespace().rev().nth(1);
    let printed: f64 = printed.unwrap().parse().unwrap();
    assert!((printed - best).abs() < 0.006, "{line} {best}");
    // The same flanks carry the load at negative torque.
    assert_eq!(
        columns.map(|column| number(at(-50.0, 4000.0), column)),
        columns.map(|column| number(at(50.0, 4000.0), column))
    );
    let (_, without) = of("n", &["--band", "none"]);
    assert!(without.iter().all(|row| row["loss_p05_w"].is_empty()));
    assert!(
        without
            .iter()
            .all(|row| row["loss_at_medians_w"].is_empty())
    );
    assert_eq!(without[9]["loss_w"], rows[9]["loss_at_medians_w"]);
}

/// Whether the efficiency that is drawn has the points of the map, and between them the mean loss torque.
fn assert_efficiency_is_that_of_the_loss_torque(
    rows: &[BTreeMap<String, String>],
    drawn: &[BTreeMap<String, String>],
) {
    let at = |rows: &[BTreeMap<String, String>], column: &str, torque: f64, speed: f64| {
        let place = [
            ("torque_nm", torque),
            ("speed_rpm", speed),
            ("temperature_c", 90.0),
        ];
        let is = |row: &&BTreeMap<String, String>| {
            place.iter().all(|(key, value)| number(row, key) == *value)
        };
        rows.iter().find(is).unwrap()[column].clone()
    };
    for torque in [-100.0, 0.0, 2.5, 40.0, 100.0] {
        for speed in [0.0, 500.0, 9000.0] {
            let [there, here] =
                [rows, drawn].map(|rows| at(rows, "efficiency", torque, speed).parse::<f64>());
            assert_eq!(here.is_ok(), there.is_ok(), "{torque} {speed}");
            if let (Ok(here), Ok(there)) = (here, there) {
                assert!((here - there).abs() < 1e-14, "{here} {there}");
            }
        }
    }
    let loss = |torque: f64| {
        let text = at(rows, "loss_torque_nm", torque, 9000.0);
        text.parse::<f64>().unwrap()
    };
    let between = |torque: f64| at(drawn, "efficiency", torque, 9000.0).parse::<f64>();
    let due = 1.0 - 0.5 * (loss(0.0) + loss(2.5)) / 1.25;
    assert!((between(1.25).unwrap() - due).abs() < 1e-12);
    let lost = 0.5 * (loss(0.0) + loss(-100.0));
    let due = 50.0 / (50.0 + lost);
    assert!((between(-50.0).unwrap() - due).abs() < 1e-12);
    // At rest the loss torque is that at 1 1/min.
    assert!(at(drawn, "efficiency", 40.0, 1.0).parse::<f64>().is_ok());
}

#[test]
fn a_map_has_nodes_at_rest_and_its_points_are_those_of_runs() {
    let bench = bench(E_DRIVE);
    map(&bench, "m", &[]);
    let text = fs::read_to_string(bench.path("m/map.csv")).unwrap();
    assert!(text.starts_with(
        "torque_nm,speed_rpm,temperature_c,loss_w,loss_p05_w,loss_p95_w,loss_at_medians_w,loss_torque_nm,efficiency,efficiency_deviation,\
         sliding_w,rolling_w,mu_equivalent,mixed_share,outside,code"
    ));
    let rows = table(&bench, "m/map.csv");
    // Torques -100, 0, 2.5, 40, 100, speeds 0, 500, 9000, two temperatures.
    assert_eq!(rows.len(), 5 * 3 * 2);
    for row in &rows {
        let (torque, speed) = (number(row, "torque_nm"), number(row, "speed_rpm"));
        assert!(number(row, "loss_torque_nm") > 0.0);
        if speed == 0.0 {
            assert_eq!(
                (number(row, "loss_w"), row["efficiency"].as_str()),
                (0.0, "")
            );
            continue;
        }
        let is_extended = row["outside"].contains("extended");
        assert_eq!(is_extended, torque.abs() < 2.0, "{torque}");
        if torque == 0.0 {
            assert_eq!(number(row, "loss_w"), number(row, "rolling_w"));
            continue;
        }
        let of = |key: &str, value: String| (key.to_owned(), value);
        let set = [
            of("operation.torque", format!("{} N m", row["torque_nm"])),
            of("operation.speed", format!("{} 1/min", row["speed_rpm"])),
            of(
                "operation.bulk_temperature",
                format!("{} °C", row["temperature_c"]),
            ),
        ];
        let source = open_source(&bench.path("case.toml")).unwrap();
        let case = load_set(source, &bench.path(""), &set, &|_| {}).unwrap();
        let summary = asperity::Run::new(&case)
            .execute()
            .unwrap()
            .into_only()
            .unwrap()
            .result
            .summary;
        let same = [
            ("loss_w", summary.loss_w),
            ("efficiency", summary.efficiency),
            (
                "efficiency_deviation",
                summary.efficiency_deviation.unwrap(),
            ),
            ("sliding_w", summary.sliding_w),
            ("boundary_w", summary.boundary_w),
            ("rolling_w", summary.rolling_w),
            ("mu_equivalent", summary.mu_equivalent),
            ("mixed_share", summary.mixed_share),
        ];
        // By the ratio of the median of the draws there.
        let ratio = number(row, "loss_w") / number(row, "loss_at_medians_w");
        for (column, value) in same {
            let at_median = match column {
                "mixed_share" => value,
                "efficiency" if torque > 0.0 => 1.0 - ratio * (1.0 - value),
                "efficiency" => value / (value + ratio * (1.0 - value)),
                "mu_equivalent" if torque < 0.0 => {
                    (1.0 - number(row, "efficiency")) / summary.loss_factor_local
                }
                _ => ratio * value,
            };
            let off = (number(row, column) - at_median).abs();
            let is_near = off <= 1e-12 * at_median.abs();
            assert!(is_near, "{column} at {set:?}: {at_median} {row:?}");
        }
        let at_medians = number(row, "loss_at_medians_w");
        assert_eq!(at_medians, summary.loss_w, "{set:?}");
    }
    assert_efficiency_is_that_of_the_loss_torque(&rows, &table(&bench, "m/efficiency.csv"));
    let json: serde_json::Value =
        serde_json::from_str(&fs::read_to_string(bench.path("m/map.json")).unwrap()).unwrap();
    assert_eq!(json["scope"], "mesh");
    assert_eq!(
        json["axes"]["torque_nm"],
        serde_json::json!([-100.0, 0.0, 2.5, 40.0, 100.0])
    );
    assert!(
        json["warnings"]
            .as_array()
            .unwrap()
            .iter()
            .any(|w| w["text"] == "extended")
    );
    let page = fs::read_to_string(bench.path("m/map.html")).unwrap();
    // Most of it is extrapolated, and hatched all the same.
    assert!(
        page.contains("Efficiency, these flanks, 90 °C")
            && page.contains("of these flanks the model is extrapolated")
    );
    assert!(page.contains("class=\"hatch\""));
}

#[test]
fn a_map_is_the_same_on_one_thread_and_two() {
    let bench = bench(E_DRIVE);
    for threads in ["1", "2"] {
        let axes = ["--torque=-40,100", "--speed=500,9000", "--temperature=60"];
        let map = [
            "map",
            "case.toml",
            "-o",
            threads,
            "--threads",
            threads,
            "-q",
        ];
        bench.run(&[&map[..], &axes].concat()).well();
    }
    let of = |folder: &str| fs::read(bench.path(&format!("{folder}/map.csv"))).unwrap();
    assert_eq!(of("1"), of("2"));
}

#[test]
fn all_points_of_a_map_equal_runs_with_lambda_star() {
    let bench = bench(&with_line(
        "positions",
        "positions = 4\nload_share = \"lambda-star\"",
    ));
    bench.shorten_flanks();
    let torques = "--torque=-140..140:5";
    bench
        .run(&[
            "map",
            "case.toml",
            torques,
            "--speed",
            "100..16000:5",
            "-o",
            "m",
            "--quiet",
        ])
        .well();
    let rows = table(&bench, "m/map.csv");
    let mut seen = 0;
    for row in &rows {
        if row["outside"].contains("extended") || number(row, "speed_rpm") == 0.0 {
            continue;
        }
        let set = [
            (
                "operation.torque".to_owned(),
                format!("{} N m", row["torque_nm"]),
            ),
            (
                "operation.speed".to_owned(),
                format!("{} 1/min", row["speed_rpm"]),
            ),
        ];
        let source = open_source(&bench.path("case.toml")).unwrap();
        let case = load_set(source, &bench.path(""), &set, &|_| {}).unwrap();
        let summary = asperity::Run::new(&case)
            .execute()
            .unwrap()
            .into_only()
            .unwrap()
            .result
            .summary;
        let at_medians = number(row, "loss_at_medians_w");
        assert_eq!(at_medians, summary.loss_w, "{set:?}");
        // The power into the mesh has the loss in it where the wheel drives.
        let loss = number(row, "loss_w");
        let driven = if number(row, "torque_nm") < 0.0 {
            loss - at_medians
        } else {
            0.0
        };
        let efficiency = 1.0 - loss / (summary.power_in_w + driven);
        assert!(
            (number(row, "efficiency") - efficiency).abs() < 1e-12,
            "{set:?}"
        );
        seen += 1;
    }
    assert_eq!(seen, 4 * 5);
}

#[test]
fn coast_flanks_carry_the_load_at_a_negative_torque() {
    let smooth = root().join("fixtures/profiles/superfinished.csv");
    let case = format!("{E_DRIVE}\n[surface.coast]\npinion = {{ file = \"coast.csv\" }}\n");
    let bench = bench(&case);
    fs::copy(smooth, bench.path("coast.csv")).unwrap();
    map(&bench, "m", &["--quiet", "--band", "none"]);
    let rows = table(&bench, "m/map.csv");
    let at = |torque: f64| {
        let is = |row: &&BTreeMap<String, String>| {
            number(row, "torque_nm") == torque
                && number(row, "speed_rpm") == 500.0
                && number(row, "temperature_c") == 90.0
        };
        number(rows.iter().find(is).unwrap(), "loss_w")
    };
    assert!(at(-100.0) < 0.8 * at(100.0), "{} {}", at(-100.0), at(100.0));
    let run = |torque: &str| {
        let set = format!("operation.torque={torque} N m");
        let arguments = [
            "run",
            "case.toml",
            "--no-output",
            "--no-band",
            "--json",
            "--set",
            &set,
        ];
        let speed = ["--set", "operation.speed=500 1/min"];
        let json = bench
            .run(&[&arguments[..], &speed[..]].concat())
            .well()
            .json();
        json["summary"]["loss_w"].as_f64().unwrap()
    };
    assert_eq!(at(-100.0), run("-100"));
    assert_eq!(at(100.0), run("100"));
    let json = fs::read_to_string(bench.path("m/map.json")).unwrap();
    assert!(json.contains("coast.csv"));
}

/// A cycle of a vehicle: a start, a steady way, a stop.
const TRACE: &str =
    "# made up\ntime_s,torque_nm,speed_rpm\n0,0,0\n1,60,1500\n2,60,3000\n3,-30,3000\n4,0,0\n";

#[test]
fn a_cycle_sums_the_losses_of_the_map() {
    let bench = bench(E_DRIVE);
    bench.write("trace.csv", TRACE);
    let axes = ["--torque=-100,100", "--speed=9000", "--temperature=60,90"];
    let more = ["--cycle", "trace.csv", "--export", "fastsim,csv,vecto"];
    let map = [&["map", "case.toml", "-o", "m", "-q"][..], &axes, &more];
    bench.run(&map.concat()).well();
    let said = bench
        .run(&["cycle", "m", "trace.csv", "--temperature", "90", "-o", "c"])
        .well();
    let head = "Cycle trace: 4 s";
    assert!(
        said.out.contains(head) && said.out.contains("in brackets"),
        "{}",
        said.out
    );
    // The nodes at rest and at 9000 1/min, between which all points lie, are outside of ranges that the case keeps.
    let page = fs::read_to_string(bench.path("c/cycle.html")).unwrap();
    assert!(page.contains("lost with these flanks, 100 % is where the model is extrapolated"));
    let json: serde_json::Value =
        serde_json::from_str(&fs::read_to_string(bench.path("c/cycle.json")).unwrap()).unwrap();
    let rows = table(&bench, "c/cycle.csv");
    // All points but the ends stand for a second.
    let sum: f64 = rows[1..4].iter().map(|row| number(row, "loss_w")).sum();
    let lost = json["finishes"][0]["lost_wh"].as_f64().unwrap();
    // The median of a sum is near the sum of the medians: most of an error is common to all points.
    assert!((lost / (sum / 3600.0) - 1.0).abs() < 0.01, "{lost} {sum}");
    let of = |key: &str| json["finishes"][0][key].as_f64().unwrap();
    assert!((of("lost_drive_wh") + of("lost_coast_wh") - lost).abs() < 1e-15);
    assert_eq!(json["outside_share"], 0.0);
    let drive = 60.0 * (1500.0 + 3000.0) * std::f64::consts::PI / 30.0 / 3600.0;
    assert!((json["drive_wh"].as_f64().unwrap() - drive).abs() < 1e-9);
    assert!(
        fs::read_to_string(bench.path("c/cycle.html"))
            .unwrap()
            .contains("class=\"dots\"")
    );
    assert!(
        fs::read_to_string(bench.path("m/map.html"))
            .unwrap()
            .contains("class=\"dots\"")
    );
    let exported = fs::read_to_string(bench.path("m/export/case_90c.vtlm")).unwrap();
    assert!(exported.starts_with("# scope mesh only"));
    // A vehicle by --set, its speed in the trace.
    bench.write("speed.csv", "time_s,speed_km_h\n0,0\n1,5\n2,10\n");
    bench
        .run(&["cycle", "m", "speed.csv"])
        .refused(2, "E101", &["[vehicle]"]);
    let set = "vehicle={ mass = \"1500 kg\", wheel_radius = \"300 mm\", ratio = 10.0, drag_area = \"0.6 m2\", rolling_resistance = 0.01 }";
    let said = bench
        .run(&[
            "cycle",
            "m",
            "speed.csv",
            "--no-output",
            "--json",
            "--set",
            set,
        ])
        .well();
    assert!(said.json()["distance_km"].as_f64().unwrap() > 0.0);
}

#[test]
fn a_cycle_beyond_the_map_is_refused_unless_that_is_accepted() {
    let bench = bench(&with_line(
        "positions",
        "positions = 4\nload_share = \"lambda-star\"",
    ));
    map(&bench, "m", &["--quiet", "--band", "none"]);
    let rows = table(&bench, "m/map.csv");
    let is_edge = |row: &&BTreeMap<String, String>| {
        let place = ["torque_nm", "speed_rpm", "temperature_c"].map(|column| number(row, column));
        place == [100.0, 500.0, 90.0]
    };
    let edge = number(rows.iter().find(is_edge).unwrap(), "loss_w");
    bench.write(
        "far.csv",
        "time_s,torque_nm,speed_rpm\n0,300,500\n1,300,500\n",
    );
    let said = bench.run(&["cycle", "m", "far.csv", "--no-output"]);
    said.refused(
        4,
        "E314",
        &[
            "100.0 % of the energy",
            "2 of 2 rows",
            "300.0 at line 2 (t = 0.00 s)",
        ],
    );
    assert!(said.err.contains("--allow-outside"), "{}", said.err);
    let accepted = [
        "cycle",
        "m",
        "far.csv",
        "--allow-outside",
        "-o",
        "c",
        "--json",
    ];
    let json = bench.run(&accepted).well().json();
    assert_eq!(json["outside_energy_share"], 1.0);
    // Loss over torque is held: three times the loss of the edge.
    for row in table(&bench, "c/cycle.csv") {
        let loss = number(&row, "loss_w");
        assert!((loss / (3.0 * edge) - 1.0).abs() < 1e-12, "{loss} {edge}");
    }
    // A twentieth of the energy may be outside.
    let row = |time: usize, torque: f64| format!("{time},{torque},500\n");
    let mut few = "time_s,torque_nm,speed_rpm\n".to_owned();
    few.extend((0..99).map(|time| row(time, 100.0)));
    few.push_str(&row(99, 300.0));
    bench.write("few.csv", few);
    let said = bench
        .run(&["cycle", "m", "few.csv", "--no-output"])
        .well()
        .unwrapped();
    let outside = "torque at its edge: 1.5 % of the energy (0.5 % of the moving time).";
    assert!(said.contains(outside), "{said}");
}

#[test]
fn a_number_that_no_cycle_has_is_refused_with_its_line() {
    let bench = bench(&with_line(
        "positions",
        "positions = 4\nload_share = \"lambda-star\"",
    ));
    map(&bench, "m", &["--quiet", "--band", "none"]);
    bench.write(
        "huge.csv",
        "# made up\ntime_s,torque_nm,speed_rpm\n0,10,500\n1,1e308,500\n2,10,500\n",
    );
    bench
        .run(&["cycle", "m", "huge.csv", "--no-output"])
        .refused(2, "E101", &["huge.csv: line 4: torque_nm = ", "beyond"]);
    let set = "vehicle={ mass = \"1500 kg\", wheel_radius = \"300 mm\", ratio = 10.0, drag_area = \"0.6 m2\", rolling_resistance = 0.01 }";
    bench.write("fast.csv", "time_s,speed_km_h\n0,0\n1,5000\n2,0\n");
    bench
        .run(&["cycle", "m", "fast.csv", "--no-output", "--set", set])
        .refused(2, "E101", &["line 3: speed_km_h = 5000"]);
}

#[test]
fn with_power_from_the_wheel_efficiency_is_one_minus_loss_over_power() {
    let bench = bench(&with_line("offsets", "offsets = 4"));
    let arguments = [
        "run",
        "case.toml",
        "--no-output",
        "--no-band",
        "--json",
        "--set",
        "operation.torque=-145 N m",
    ];
    let json = bench.run(&arguments).well().json();
    let of = |key: &str| json["summary"][key].as_f64().unwrap();
    let expected = 1.0 - of("loss_w") / of("power_in_w");
    assert!(
        (of("efficiency") - expected).abs() < 1e-15,
        "{} {expected}",
        of("efficiency")
    );
    let pinion = 145.0 * 9000.0 * std::f64::consts::PI / 30.0;
    assert!((of("power_in_w") - of("loss_w") - pinion).abs() < 1e-6);
}

#[test]
fn what_makes_no_map_is_refused() {
    let bench = bench(E_DRIVE);
    let map = |arguments: &[&str]| bench.run(&[&["map", "case.toml"], arguments].concat());
    map(&["--torque", "1..2"]).refused(2, "E209", &["--torque", "1..2"]);
    map(&["--speed", "-5,5"]).refused(2, "E209", &["speed", "-5"]);
    let warm = "warm: operation.bulk_temperature=100 °C";
    map(&["--variant", warm]).refused(2, "E205", &["warm", "axes"]);
    map(&["--export", "fastsim"]).refused(2, "E205", &["--export", "no cycle"]);
    let drive = [
        "--torque", "50,100", "--speed", "500,9000", "--export", "vecto",
    ];
    map(&drive).refused(2, "E205", &["vecto", "both signs"]);
    let alike = ["a b=pinion.csv,wheel.csv", "a_b=pinion.csv,wheel.csv"];
    let alike = [
        "--export", "csv", "--finish", alike[0], "--finish", alike[1],
    ];
    map(&alike).refused(2, "E205", &["csv", "\"a b\"", "\"a_b\""]);
    map(&["--cycle", "none.csv"]).refused(2, "E103", &["none.csv"]);
    bench.write("bad.csv", "speed_rpm,loss_torque_nm\n0,-1\n");
    let add = ["--torque=-1,1", "--export", "csv", "--add-loss", "bad.csv"];
    map(&[&add[..], &["--set", "model.load_share=lambda-star"]].concat()).refused(
        2,
        "E101",
        &["bad.csv", "zero or more"],
    );
    bench
        .run(&["cycle", "nothing", "bad.csv"])
        .refused(2, "E402", &["nothing"]);
}

#[test]
fn the_page_of_maps_lists_every_export() {
    let page = fs::read_to_string(root().join("docs/files/maps.md")).unwrap();
    for format in Format::ALL {
        let files: Vec<String> = format.files().map(|file| format!("`{file}`")).collect();
        let name = serde_json::json!(format);
        let (name, files) = (name.as_str().unwrap(), files.join(", "));
        let row = format!("| `{name}` | {files} | {} |", format.holds());
        assert!(page.contains(&row), "{row}");
    }
}
