//! The gears of a case from the command: `asperity gear`, relief, rings, planetary sets, the load map.

use asperity_core::Estimate;
use std::fs;

use asperity::result::loss_band::with_interval;

use crate::bench::{Bench, E_DRIVE, NO_RELIEF, with_line};

fn bench(case: &str) -> Bench {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("case.toml", case);
    bench
}

fn codes(result: &serde_json::Value) -> Vec<&str> {
    let warnings = result["warnings"].as_array().unwrap().iter();
    warnings.map(|w| w["code"].as_str().unwrap()).collect()
}

const RELIEF: &str = "pinion.tip_relief = { amount = \"15 um\", length = \"2.9 mm\" }\n\
    wheel.tip_relief = { amount = \"15 um\", length = \"2.9 mm\" }\n";

#[test]
fn the_gear_command_tells_geometry_stiffness_and_every_law() {
    let bench = bench(E_DRIVE);
    let said = bench.run(&["gear", "case.toml"]).well().out;
    for part in [
        "teeth 23/68",
        "eps_alpha 1.5",
        "Transmission error",
        "by ISO 6336-1",
        "mean-length",
    ] {
        assert!(said.contains(part), "{part}: {said}");
    }
    let json = bench.run(&["gear", "case.toml", "--json"]).well().json();
    assert_eq!(json["law"], "elastic");
    assert_eq!(json["loss_factors"].as_array().unwrap().len(), 6);
}

#[test]
fn unrelieved_tips_are_noted_and_relieved_ones_are_not() {
    let plain = bench(E_DRIVE)
        .run(&["run", "case.toml", "--no-output", "--no-band", "--json"])
        .well()
        .json();
    assert!(codes(&plain).contains(&"W421"));
    assert!(plain["load"]["band"]["low"].as_f64() < plain["load"]["loss_factor_local"].as_f64());
    let relieved = bench(&E_DRIVE.replace(NO_RELIEF, RELIEF));
    let relieved = relieved
        .run(&["run", "case.toml", "--no-output", "--no-band", "--json"])
        .well()
        .json();
    assert!(!codes(&relieved).contains(&"W421"));
    let factor =
        |result: &serde_json::Value| result["summary"]["loss_factor_local"].as_f64().unwrap();
    assert!(factor(&relieved) < 0.75 * factor(&plain));
}

#[test]
fn cells_that_carry_almost_nothing_are_counted() {
    // On coarse traces the contact of the outermost cells is narrower than the points resolve.
    let case = E_DRIVE
        .replace(NO_RELIEF, RELIEF)
        .replace("positions = 2", "positions = 32")
        .replace("\"pinion.csv\"", "\"pinion.csv\", dx = \"1.7 um\"")
        .replace("\"wheel.csv\"", "\"wheel.csv\", dx = \"1.7 um\"");
    let result = bench(&case)
        .run(&["run", "case.toml", "--no-output", "--no-band", "--json"])
        .well()
        .json();
    assert!(codes(&result).contains(&"W422"), "{:?}", codes(&result));
}

#[test]
fn a_root_that_cannot_be_drawn_and_tips_that_may_foul_are_told() {
    let root = with_line(
        "face_width",
        "face_width = \"32 mm\"\npinion.dedendum = 3.0",
    );
    let result = bench(&root)
        .run(&["run", "case.toml", "--no-output", "--no-band", "--json"])
        .well()
        .json();
    assert!(codes(&result).contains(&"W424"), "{:?}", codes(&result));
    let ring = with_line("teeth", "teeth = [60, -68]")
        .replace("helix = \"23.4 deg\"\n", "")
        .replace("positions = 2", "positions = 16");
    let said = bench(&ring).run(&["run", "case.toml", "--no-output", "--no-band", "--json"]);
    let result = said.well().json();
    assert!(codes(&result).contains(&"W425"), "{:?}", codes(&result));
}

#[test]
fn the_load_map_is_written_when_it_is_asked_for() {
    let bench = bench(E_DRIVE);
    bench
        .run(&["run", "case.toml", "--no-band", "-o", "plain"])
        .well();
    assert!(!bench.path("plain/map.csv").exists());
    bench
        .run(&["run", "case.toml", "--no-band", "-o", "whole", "--load-map"])
        .well();
    let map = fs::read_to_string(bench.path("whole/map.csv")).unwrap();
    assert!(map.starts_with("phase,xi,s_mm,y_mm,load_n_per_mm,weight_mm\n"));
    assert!(map.lines().count() > 1000);
    let page = fs::read_to_string(bench.path("whole/report.html")).unwrap();
    assert!(page.contains("Load over the flank, from A to E and across the face"));
    // A result with its map is replaced as a whole.
    bench
        .run(&["run", "case.toml", "--no-band", "-o", "whole"])
        .well();
    assert!(!bench.path("whole/map.csv").exists());
}

#[test]
fn a_tip_that_reaches_into_the_mating_fillet_is_told() {
    let bench = bench(&with_line("helix", "helix = \"23.4 deg\"\naddendum = 1.2"));
    let arguments = ["run", "case.toml", "--no-output", "--no-band", "--json"];
    let long = bench.run(&arguments).well().json();
    assert!(codes(&long).contains(&"W433"), "{long:#}");
    let text = long.to_string();
    assert!(text.contains("below the involute of the pinion"), "{text}");
    bench.write("case.toml", E_DRIVE);
    assert!(!codes(&bench.run(&arguments).well().json()).contains(&"W433"));
}

pub const SET: &str = r#"
title = "small set"
[planetary]
teeth = [27, 24, -75]
planets = 3
module = "1.5 mm"
face_width = ["20 mm", "20 mm", "20 mm"]
[operation]
torque = "120 N m"
speed = "3000 1/min"
bulk_temperature = "90 °C"
[lubricant]
oil = "m100"
[surface]
cutoff = "0.25 mm"
sun = { file = "pinion.csv" }
planet = { file = "wheel.csv", mirrored = true }
[model]
positions = 6
offsets = 2
depths = 0
"#;

#[test]
fn a_planetary_set_gives_a_table_and_a_result_for_each_mesh() {
    let bench = bench(SET);
    let run = ["run", "case.toml", "--notes", "--load-map", "-o", "set"];
    let said = bench.run(&run).well().out;
    assert!(said.contains("3 planets   carrier 794.1 1/min"), "{said}");
    for file in [
        "sun_planet/map.csv",
        "planetary.json",
        "meshes.csv",
        "report.html",
        "sun_planet/result.json",
        "planet_ring/report.html",
    ] {
        assert!(bench.path("set").join(file).is_file(), "{file}");
    }
    let json = fs::read_to_string(bench.path("set/planetary.json")).unwrap();
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    assert_eq!(json["meshes"].as_array().unwrap().len(), 2);
    // The quantiles of the set are about three times the sum of those of its meshes.
    let w = |value: &serde_json::Value| value.as_f64().unwrap();
    let of_meshes = |name: &str| {
        json["meshes"]
            .as_array()
            .unwrap()
            .iter()
            .map(|mesh| w(&mesh[name]))
            .sum::<f64>()
    };
    for (k, name) in ["loss_p05_w", "loss_p95_w"].into_iter().enumerate() {
        let of_set = w(&json["loss_distribution"]["quantiles_w"][k]);
        assert!(
            (of_set / (3.0 * of_meshes(name)) - 1.0).abs() < 0.12,
            "{json:#}"
        );
    }
    // A mesh has the same loss in the row of the set and in its own summary, and its warnings are printed.
    for mesh in json["meshes"].as_array().unwrap() {
        let name = mesh["mesh"].as_str().unwrap();
        let row = said.lines().find(|line| line.starts_with(name)).unwrap();
        let [median, low, high] = ["loss_w", "loss_p05_w", "loss_p95_w"].map(|key| w(&mesh[key]));
        for (at, unit) in [(row, ""), (&said, " W")] {
            let [loss, _] = with_interval(Estimate::new(median, [low, high]), 1e5, [unit, ""]);
            assert!(at.contains(&loss), "{loss} is not in {at}");
        }
    }
    assert!(said.contains("W439 tip relief"), "{said}");
    assert!((w(&json["loss_w"]) / (3.0 * of_meshes("loss_w")) - 1.0).abs() < 1e-12);
    assert!(w(&json["loss_distribution"]["quantiles_w"][0]) < w(&json["loss_w"]));
    bench.write("case.toml", SET.replace("planets = 3", "planets = 12"));
    bench
        .run(&["run", "case.toml"])
        .refused(2, "E206", &["12 planets do not fit"]);
}

#[test]
fn the_bulk_temperature_of_both_meshes_of_a_set_rises_by_iso() {
    let heated = r#"oil_temperature = "60 °C"
bulk = { law = "iso", lubrication = "dip" }"#;
    let line = SET
        .lines()
        .find(|line| line.starts_with("bulk_temperature"));
    let bench = bench(&SET.replace(line.unwrap(), heated));
    let run = ["run", "case.toml", "--no-band", "-o", "set"];
    bench.run(&run).well();
    for mesh in ["sun_planet", "planet_ring"] {
        let text = fs::read_to_string(bench.path("set").join(mesh).join("result.json")).unwrap();
        let result: serde_json::Value = serde_json::from_str(&text).unwrap();
        let rise = result["bulk"]["bulk_c"].as_f64().unwrap() - 60.0;
        assert!((0.1..40.0).contains(&rise), "{mesh}: {rise}");
    }
}

#[test]
fn a_planetary_set_takes_keys_and_standard_input_and_is_checked() {
    let bench = bench(SET);
    let other = SET.replace("120 N m", "100 N m");
    bench.write("other.toml", &other);
    let loss = |arguments: &[&str]| bench.run(arguments).well().json()["loss_w"].clone();
    let of_file = loss(&["run", "other.toml", "--no-output", "--no-band", "--json"]);
    let by_key = [
        "run",
        "case.toml",
        "--no-output",
        "--no-band",
        "--json",
        "--set",
    ];
    assert_eq!(
        loss(&[&by_key[..], &["operation.torque=100 N m"]].concat()),
        of_file
    );
    assert_ne!(
        loss(&["run", "case.toml", "--no-output", "--no-band", "--json"]),
        of_file
    );
    let piped = bench.run_with_input(&["run", "-", "--no-output", "--no-band", "--json"], &other);
    assert_eq!(piped.well().json()["loss_w"], of_file);
    bench
        .run(&["run", "case.toml", "--set", "planetary.plantes=4"])
        .refused(2, "E203", &["Did you mean \"planets\"?"]);

    let said = bench
        .run(&["check", "case.toml", "--explain-defaults"])
        .well()
        .out;
    for says in [
        "planetary.ring_speed",
        "material.ring.young",
        "24 rough contacts",
    ] {
        assert!(said.contains(says), "{says} is not in {said}");
    }
    assert!(!said.contains("material.pinion"), "{said}");
}

#[test]
fn gear_tells_of_each_mesh_of_a_set_and_commands_of_a_pair_refuse_it() {
    let bench = bench(SET);
    let said = bench.run(&["gear", "case.toml"]).well().out;
    for says in [
        "small set: sun and planet",
        "teeth 27/24 ",
        "small set: planet and ring",
        "teeth 24/-75 ",
    ] {
        assert!(said.contains(says), "{says} is not in {said}");
    }
    let gears = bench.run(&["gear", "case.toml", "--json"]).well().json();
    let meshes = gears["meshes"].as_array().unwrap();
    assert_eq!(meshes.len(), 2);
    // The torque of the sun over three planets, and by the teeth at the planet.
    assert_eq!(meshes[0]["torque_nm"], 40.0);
    assert!((meshes[1]["torque_nm"].as_f64().unwrap() - 40.0 * 24.0 / 27.0).abs() < 1e-9);
    let finishes = ["--finish", "a=pinion.csv", "--finish", "b=wheel.csv"];
    for command in [&["film", "case.toml"][..], &["contact", "case.toml"]] {
        let refused = bench.run(command);
        let says = ["has several meshes: \"sun and planet\", \"planet and ring\""];
        refused.refused(2, "E205", &says);
    }
    // A comparison, a map, a sweep and a study of changes take all meshes.
    let few = ["--set", "model.positions=4"];
    let compared = [
        &["compare", "case.toml", "-o", "compared"],
        &finishes[..],
        &few,
    ]
    .concat();
    let said = bench.run(&compared).well().out;
    assert!(said.contains("3 × sun and planet, b"), "{said}");
    let page = fs::read_to_string(bench.path("compared/compare.html")).unwrap();
    assert!(page.contains("Losses of one mesh of each kind"), "{page}");
    // A finish of one mesh leaves the other as it is.
    let of_one = [
        "--finish",
        "own=pinion.csv,wheel.csv",
        "--finish",
        "ring=pinion.csv,wheel.csv",
        "--finish",
        "ring@planet and ring=wheel.csv,pinion.csv",
    ];
    let found = bench
        .run(
            &[
                &["compare", "case.toml", "-o", "one", "--json"],
                &of_one[..],
                &few,
            ]
            .concat(),
        )
        .well()
        .json();
    let ring = &found["finishes"][1];
    assert_eq!(
        ring["meshes"][0]["difference"]["verdict"], "equal",
        "{ring:#}"
    );
    assert_ne!(ring["meshes"][1]["difference"]["at_medians_w"], 0.0);
    for (finish, says) in [
        ("a@none=pinion.csv", "there is no mesh \"none\""),
        ("b@sun and planet=pinion.csv", "stated twice"),
    ] {
        let twice = ["--finish", "b@sun and planet=wheel.csv", "--finish", finish];
        bench
            .run(&[&["compare", "case.toml"][..], &twice].concat())
            .refused(2, "E205", &[says]);
    }
    let study = "case = \"case.toml\"\n[[axis]]\nkey = \"operation.torque\"\nvalues = [\"20 N m\", \"30 N m\"]\n";
    bench.write("whole.toml", study);
    bench.run(&["sweep", "run", "whole.toml", "-q"]).well();
    bench
        .run(&["sweep", "merge", "whole.toml", "-o", "merged"])
        .well();
    let table = fs::read_to_string(bench.path("merged/sweep.csv")).unwrap();
    assert!(table.contains("mesh.planet and ring.loss_w"), "{table}");
    // A map and a study of changes.
    let axes = [
        "map",
        "case.toml",
        "-o",
        "maps",
        "--torque",
        "120",
        "--speed",
        "3000",
    ];
    let map = [&axes[..], &few, &finishes[..]].concat();
    let said = bench.run(&map).well().out;
    assert!(said.contains("loss of the meshes only"), "{said}");
    assert!(
        said.contains("\nb       sun and planet        3 "),
        "{said}"
    );
    let changes = [
        "sensitivity",
        "case.toml",
        "--set",
        "model.offsets=1",
        "--set",
        "model.positions=4",
        "--json",
    ];
    let found = bench.run(&changes).well().json();
    let at_medians = found["loss_w"].as_f64().unwrap();
    let rows = found["rows"].as_array().unwrap();
    let lower = rows
        .iter()
        .find(|row| row["what"] == "heights of both flanks");
    let change = lower.unwrap()["effect"]["difference_w"].as_f64().unwrap();
    assert!(change < 0.0 && change > -at_medians, "{found}");
    // One of the meshes is a case of its own.
    let mesh = ["--mesh", "planet and ring"];
    let alone = [
        &["run", "case.toml", "--no-output", "--no-band", "--json"],
        &mesh[..],
    ]
    .concat();
    let alone = bench.run(&alone).well().json();
    let set = bench
        .run(&["run", "case.toml", "--no-output", "--no-band", "--json"])
        .well()
        .json();
    assert_eq!(alone["summary"]["loss_w"], set["meshes"][1]["loss_w"]);
    let map = [
        &[
            "map",
            "case.toml",
            "--torque",
            "10,20",
            "--speed",
            "1000,2000",
            "--set",
            "model.offsets=1",
        ],
        &mesh[..],
    ];
    bench.run(&map.concat()).well();
    let none = ["film", "case.toml", "--mesh", "none"];
    bench
        .run(&none)
        .refused(2, "E205", &["has no mesh \"none\""]);
    let study = "case = \"case.toml\"\nmesh = \"sun and planet\"\n[[axis]]\nkey = \"operation.torque\"\nvalues = [\"20 N m\", \"30 N m\"]\n";
    bench.write("study.toml", study);
    assert!(
        bench
            .run(&["sweep", "run", "study.toml", "--plan"])
            .well()
            .out
            .contains("2 cases")
    );
    bench.write("study.toml", study.replace("sun and planet", "none"));
    bench
        .run(&["sweep", "run", "study.toml", "--plan"])
        .refused(2, "E202", &["must name one of the meshes"]);
}

#[test]
fn the_key_of_an_older_version_is_answered_with_todays() {
    let bench = bench(SET);
    bench
        .run(&["check", "case.toml", "--set", "model.load_sharing=uniform"])
        .refused(2, "E203", &["Did you mean \"load_distribution\"?"]);
}

#[test]
fn check_tells_every_error_of_a_planetary_set_once() {
    let bad = SET
        .replace("1.5 mm", "1.5 m")
        .replace("m100", "m1000")
        .replace("wheel.csv", "nosuch.csv")
        .replace("planets = 3", "planets = 3\nplanet = 3");
    let bench = bench(&bad);
    let before = bench.listing();
    let said = bench.run(&["check", "case.toml"]);
    assert_eq!(said.status, 2);
    for says in [
        "E204 case.toml:6: planetary.planet",
        "E212 case.toml:7 (mesh of the sun, its pinion, and a planet): gears.module = \"1.5 m\"",
        "E208 case.toml:13: lubricant",
        "E103 nosuch.csv",
        "case.toml: 4 errors",
    ] {
        assert!(said.err.contains(says), "{says} is not in {}", said.err);
    }
    assert_eq!(bench.listing(), before);
}

/// Two stages on three shafts.
pub const TRAIN: &str = r#"
title = "two stages"
[train]
input = "motor"
[mesh.fast]
shafts = ["motor", "middle"]
gears = { teeth = [23, 68], module = "1.8 mm", face_width = "32 mm", helix = "23.4 deg" }
[mesh.slow]
shafts = ["middle", "wheel"]
gears = { teeth = [25, 61], module = "2.5 mm", face_width = "40 mm" }
[operation]
torque = "100 N m"
speed = "6000 1/min"
bulk_temperature = "90 °C"
[lubricant]
oil = "m100"
[surface]
cutoff = "0.25 mm"
pinion = { file = "pinion.csv" }
wheel = { file = "wheel.csv", mirrored = true }
[model]
positions = 4
offsets = 2
depths = 0
"#;

#[test]
fn a_train_of_thousands_of_meshes_is_refused() {
    let mesh = |k: usize| {
        let gears = "gears = { teeth = [23, 68], module = \"1.8 mm\", face_width = \"32 mm\" }";
        format!(
            "[mesh.m{k}]\nshafts = [\"s{k}\", \"s{}\"]\n{gears}\n",
            k + 1
        )
    };
    let meshes: String = (0..3000).map(mesh).collect();
    let rest = TRAIN.split_once("[operation]").unwrap().1;
    let bench = bench(&format!(
        "[train]\ninput = \"s0\"\n{meshes}[operation]{rest}"
    ));
    for command in ["check", "run"] {
        let said = bench.run(&[command, "case.toml"]);
        said.refused(2, "E212", &["mesh: a train of 3000 meshes", "at most 100"]);
    }
}

#[test]
fn a_gear_train_gives_its_shafts_its_meshes_and_one_loss() {
    let bench = bench(TRAIN);
    let said = bench
        .run(&["run", "case.toml", "-o", "train", "--notes"])
        .well()
        .out;
    for says in [
        "two stages",
        "fast",
        "slow",
        "motor",
        "middle",
        "wheel",
        "295.652",
    ] {
        assert!(said.contains(says), "{says} is not in {said}");
    }
    for file in [
        "train.json",
        "meshes.csv",
        "shafts.csv",
        "report.html",
        "fast/report.html",
        "slow/result.json",
    ] {
        assert!(bench.path("train").join(file).is_file(), "{file}");
    }
    let read = |file: &str| std::fs::read_to_string(bench.path(file)).unwrap();
    let page = read("train/report.html");
    for says in [
        "fast/report.html",
        "lubricated asperities",
        "Shafts",
        "torque carried",
    ] {
        assert!(page.contains(says), "{says}");
    }
    let run = |more: &[&str]| {
        let arguments = [&["run", "case.toml", "--no-output", "--json"], more].concat();
        bench.run(&arguments).well().json()
    };
    let w = |value: &serde_json::Value| value.as_f64().unwrap();
    let json: serde_json::Value = serde_json::from_str(&read("train/train.json")).unwrap();
    let losses: Vec<f64> = [0, 1]
        .iter()
        .map(|k| w(&json["meshes"][*k as usize]["loss_w"]))
        .collect();
    assert_eq!(w(&json["loss_w"]), losses[0] + losses[1]);
    // Oil and constants are drawn together: the band is between independent and equal draws.
    let band = |row: &serde_json::Value| w(&row["loss_p95_w"]) - w(&row["loss_p05_w"]);
    let [first, second] = [0, 1].map(|k: usize| band(&json["meshes"][k]));
    let quantiles = &json["loss_distribution"]["quantiles_w"];
    let whole = w(&quantiles[1]) - w(&quantiles[0]);
    assert!(whole > 1.02 * first.hypot(second) && whole < 1.02 * (first + second));
    assert!(run(&["--no-band"])["loss_distribution"].is_null());
    // The measurements that narrow it have one row for all meshes, in the run, in its report and in their own table.
    bench
        .run(&["evidence", "case.toml", "-o", "evidence"])
        .well();
    let table: serde_json::Value = serde_json::from_str(&read("evidence/evidence.json")).unwrap();
    assert_eq!(table["loss"], json["loss_distribution"]);
    assert_eq!(table["rows"], json["evidence"]);
    let rows = json["evidence"].as_array().unwrap();
    let keys = rows.iter().map(|row| row["key"].as_str().unwrap());
    let distinct: std::collections::BTreeSet<&str> = keys.collect();
    assert!(rows.len() > 4 && rows.len() == distinct.len(), "{rows:?}");
    assert!(
        rows.iter()
            .all(|row| (0.1..1.0).contains(&w(&row["width"]))),
        "{rows:?}"
    );
    assert!(page.contains("What would narrow the interval most"));
    assert!(read("evidence/evidence.html").contains(rows[0]["measurement"].as_str().unwrap()));
    let passed = run(&["--no-band", "--set", "train.losses=passed-on"]);
    assert!(w(&passed["meshes"][1]["torque_nm"]) < w(&json["meshes"][1]["torque_nm"]));
    let slow = run(&["--no-band", "--set", "mesh.slow.gears.face_width=60 mm"]);
    let at_medians = |k: usize| &json["meshes"][k]["loss_at_medians_w"];
    assert_eq!(&slow["meshes"][0]["loss_w"], at_medians(0));
    assert_ne!(&slow["meshes"][1]["loss_w"], at_medians(1));
    // A shaft belongs to no result of another case.
    bench.run(&["check", "case.toml"]).well();
    assert_eq!(
        bench
            .run(&["gear", "case.toml"])
            .well()
            .out
            .matches("teeth 2")
            .count(),
        2
    );
}

#[test]
fn a_gear_train_that_is_not_determined_is_refused_at_its_key() {
    let bench = bench(TRAIN);
    for (set, code, says) in [
        (
            "train.input=none",
            "E205",
            "mesh.fast.shafts: has no shaft in common",
        ),
        (
            "train.output=none",
            "E205",
            "train.output: is not a shaft of any mesh",
        ),
        (
            "mesh.slow.shafts=[\"motor\", \"wheel\"]",
            "E205",
            "train.output: is needed",
        ),
        ("mesh.slow.shafts=[\"middle\"]", "E205", "mesh.slow.shafts"),
        (
            "mesh.slow.shafts=[\"middle\", \"motor\"]",
            "E205",
            "train.output: is needed",
        ),
        ("mesh.slow.gearz=1", "E203", "Did you mean \"gears\"?"),
        (
            "mesh.slow.gears.module=2.5 m",
            "E212",
            "(mesh \"slow\"): gears.module",
        ),
        ("mesh.slow.surface.pinion.file=none.csv", "E103", "none.csv"),
        ("train.losses=maybe", "E204", "passed-on"),
    ] {
        bench
            .run(&["run", "case.toml", "--no-output", "--set", set])
            .refused(2, code, &[says]);
    }
    let idle = [
        TRAIN.replace("[operation]", "[mesh.idle]\nshafts = [\"middle\", \"idle\"]\ngears = { teeth = [25, 61], module = \"2.5 mm\", face_width = \"40 mm\" }\n[operation]"),
        "train.output=wheel".to_owned(),
    ];
    bench.write("case.toml", &idle[0]);
    let run = ["run", "case.toml", "--no-output"];
    bench
        .run(&run)
        .refused(2, "E205", &["train.output: is needed"]);
    bench
        .run(&[&run[..], &["--set", &idle[1]]].concat())
        .refused(2, "E206", &["leave out meshes that run idle"]);
    // Where capitals count as small letters, both results would have one folder.
    bench.write("case.toml", TRAIN.replace("mesh.slow", "mesh.Fast"));
    let says = ["mesh.Fast", "result folder of another mesh"];
    bench.run(&run).refused(2, "E205", &says);
    let bad = TRAIN
        .replace("2.5 mm", "2.5 m")
        .replace("m100", "m1000")
        .replace("wheel.csv", "nosuch.csv");
    bench.write("case.toml", bad);
    let said = bench.run(&["check", "case.toml"]);
    for says in [
        "E212 case.toml:10 (mesh \"slow\"): gears.module",
        "E208",
        "E103",
        "3 errors",
    ] {
        assert!(said.err.contains(says), "{says} is not in {}", said.err);
    }
}

#[test]
fn tips_of_the_addendum_alone_are_noted_with_what_their_alteration_is_worth() {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("case.toml", E_DRIVE);
    let keys = |tips: &str| {
        let gears = [
            "gears.teeth=[12, 24]",
            "gears.module=3 mm",
            "gears.helix=0 deg",
            "gears.profile_shift=[0.6, 0.36]",
            "model.positions=4",
            tips,
        ];
        let set = gears.into_iter().flat_map(|key| ["--set", key]);
        let command = ["check", "case.toml"].into_iter().chain(set);
        bench.run(&command.collect::<Vec<_>>()).well().unwrapped()
    };
    // By hand: k = (a - 54 mm)/3 mm - .96 with a = 56.4999 mm; tips of 45.6 and 80.16 mm less 2 * .38 mm.
    let noted = keys("model.offsets=2");
    for part in [
        "W453 gears.tip_diameter: not stated",
        "tips of 45.600 and 80.160 mm, a contact ratio of 1.348",
        "k = -0.127 of ISO 21771 gives tips of 44.840 and 79.400 mm, a contact ratio of 1.202 and H_V 0.217",
    ] {
        assert!(noted.contains(part), "{noted}");
    }
    let stated = keys("gears.tip_diameter=[\"44.84 mm\", \"79.4 mm\"]");
    assert!(!stated.contains("W453"), "{stated}");
    let usual = bench.run(&["check", "case.toml"]).well().out;
    assert!(!usual.contains("W453"), "{usual}");
}
