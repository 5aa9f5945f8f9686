//! Several traces of a flank through the command.

use std::fs;

use crate::bench::{Bench, E_DRIVE, with_line};

/// What was printed, in one line.
fn in_a_line(said: &str) -> String {
    said.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The small case on halves of the ground flanks: two teeth of each gear.
fn bench() -> Bench {
    let bench = Bench::new();
    bench.write_flanks();
    for name in ["pinion", "wheel"] {
        let text = fs::read_to_string(bench.path(&format!("{name}.csv"))).unwrap();
        let (header, rows) = text.split_once('\n').unwrap();
        let rows: Vec<&str> = rows.lines().collect();
        for (k, half) in rows.chunks(rows.len().div_ceil(2)).enumerate() {
            let file = format!("{name}_{}.csv", k + 1);
            bench.write(&file, format!("{header}\n{}\n", half.join("\n")));
        }
    }
    let case = with_line("pinion", "pinion = { traces = \"pinion_?.csv\" }");
    let wheel = "wheel = { file = \"wheel.csv\", mirrored = true }";
    let traces = "wheel = { traces = [\"wheel_1.csv\", { file = \"wheel_2.csv\", tooth = 7 }], mirrored = true }";
    assert!(E_DRIVE.contains(wheel));
    bench.write("case.toml", case.replace(wheel, traces));
    bench
}

#[test]
fn traced_teeth_and_their_pairs_are_told() {
    let bench = bench();
    let checked = bench.run(&["check", "case.toml"]).well().out;
    let says = "pinion 2 traces of 2 teeth, wheel 2 traces of 2 teeth: 4 pairs";
    assert!(checked.contains(says), "{checked}");
    let run = ["run", "case.toml", "-o", "out", "--notes"];
    let said = in_a_line(&bench.run(&run).well().out);
    for part in [
        "2 traced teeth of the pinion on 2 of the wheel, mean ",
        "between teeth of the pinion, s_2 ",
        "W from pair to pair",
    ] {
        assert!(said.contains(part), "{part:?} is not in {said}");
    }
    let text = fs::read_to_string(bench.path("out/result.json")).unwrap();
    let result: serde_json::Value = serde_json::from_str(&text).unwrap();
    let pairs = &result["pairs"];
    assert_eq!(pairs["losses_w"].as_array().unwrap().len(), 2);
    assert_eq!(pairs["traces"][0][1]["file"], "pinion_2.csv");
    assert_eq!(pairs["traces"][1][1]["tooth_number"], 7);
    let losses = pairs["losses_w"].as_array().unwrap().iter();
    let losses: Vec<f64> = losses
        .flat_map(|row| row.as_array().unwrap())
        .map(|loss| loss.as_f64().unwrap())
        .collect();
    let mean = losses.iter().sum::<f64>() / 4.0;
    let loss = result["summary"]["loss_w"].as_f64().unwrap();
    assert!((loss / mean - 1.0).abs() < 1e-14, "{loss} {losses:?}");
    let page = fs::read_to_string(bench.path("out/report.html")).unwrap();
    for part in [
        "The traced teeth, pair by pair",
        "pinion_2.csv",
        "wheel_1.csv",
    ] {
        assert!(page.contains(part), "{part:?} is not on the page");
    }
    // One pair alone, and one flank of which one tooth was traced.
    let one = [
        "--set",
        "surface.wheel={ file = \"wheel_1.csv\", mirrored = true }",
    ];
    let more = [
        &["run", "case.toml", "--no-output", "--no-band", "--notes"][..],
        &one[..],
    ]
    .concat();
    let said = in_a_line(&bench.run(&more).well().out);
    assert!(said.contains("a lower bound (W450);"), "{said}");
    assert!(
        said.contains("W450 one tooth of the wheel is traced"),
        "{said}"
    );
}

#[test]
fn traces_of_no_name_too_many_teeth_and_single_contacts_are_told() {
    let bench = bench();
    let run =
        |set: &str| bench.run(&["run", "case.toml", "--no-output", "--no-band", "--set", set]);
    run("surface.pinion.traces=gear_*.csv").refused(
        2,
        "E137",
        &[
            "surface.pinion.traces = \"gear_*.csv\"",
            "no file in . has such a name",
        ],
    );
    let many = [("pinion", 9), ("wheel", 8)].map(|(name, teeth)| {
        let first = fs::read(bench.path(&format!("{name}_1.csv"))).unwrap();
        let files = (1..=teeth).map(|k| format!("tooth_{k}_{name}.csv"));
        files.for_each(|file| {
            bench.write(&file, &first);
        });
        format!("surface.{name}.traces=tooth_*_{name}.csv")
    });
    let checked = bench
        .run(&[
            "check",
            "case.toml",
            "--set",
            &many[0],
            "--set",
            &many[1],
            "--set",
            "model.load_share=lambda-star",
            "--json",
        ])
        .well()
        .json();
    assert_eq!(checked["warnings"][0]["code"], "W427", "{checked:#}");
    assert_eq!(checked["traced"][0]["teeth"], serde_json::json!([8, 8]));
    bench.run(&["contact", "case.toml"]).refused(
        2,
        "E312",
        &["the case has 4 pairs of teeth", "one pair of traces"],
    );
}

#[test]
fn studies_run_on_all_pairs() {
    let bench = bench();
    let loss = |more: &[&str]| {
        let arguments = [
            &["run", "case.toml", "--no-output", "--no-band", "--json"][..],
            more,
        ]
        .concat();
        bench.run(&arguments).well().json()["summary"]["loss_w"]
            .as_f64()
            .unwrap()
    };
    let map = [
        "map",
        "case.toml",
        "--torque=145",
        "--speed=9000",
        "--temperature=90",
        "-o",
        "map",
    ];
    bench.run(&map).well();
    let rows = fs::read_to_string(bench.path("map/map.csv")).unwrap();
    let header = rows.lines().next().unwrap();
    // The first row is at standstill.
    let row = rows.lines().last().unwrap();
    let column = header
        .split(',')
        .position(|name| name == "loss_at_medians_w")
        .unwrap();
    let mapped: f64 = row.split(',').nth(column).unwrap().parse().unwrap();
    let expected = loss(&[]);
    assert!(
        (mapped / expected - 1.0).abs() < 1e-9,
        "{mapped} {expected}"
    );
    // A finish has one trace for each flank, instead of several.
    let compared = bench
        .run(&[
            "compare",
            "case.toml",
            "--offsets",
            "2",
            "-o",
            "compared",
            "--json",
            "--finish",
            "one=pinion_1.csv,wheel_1.csv",
            "--finish",
            "other=pinion_2.csv,wheel_2.csv",
        ])
        .well()
        .json();
    let single = compared["finishes"][0]["loss_at_medians_w"]
        .as_f64()
        .unwrap();
    let text = fs::read_to_string(bench.path("case.toml")).unwrap();
    assert!(text.contains("traces"), "the case itself keeps its list");
    let alone = loss(&[
        "--set",
        "surface.pinion={ file = \"pinion_1.csv\" }",
        "--set",
        "surface.wheel={ file = \"wheel_1.csv\", mirrored = true }",
    ]);
    assert!((single / alone - 1.0).abs() < 1e-12, "{single} {alone}");
}
