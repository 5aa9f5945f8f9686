//! Traces that read well and are not what they seem: wrong units, uneven grids, roll lengths, another
//! involute, cut-offs of the instrument.

use std::io::Write;
use std::process::{Command, Stdio};

use crate::bench::{Bench, program, rows, trace, with_line};

fn codes(bench: &Bench, arguments: &[&str]) -> Vec<String> {
    let found = bench.run(&[arguments, &["--json"]].concat()).well().json();
    let warnings = found["warnings"].as_array().unwrap();
    let code = |warning: &serde_json::Value| warning["code"].as_str().unwrap().to_owned();
    warnings.iter().map(code).collect()
}

/// Micrometres under a header that says millimetres.
fn a_thousand_times_too_high() -> String {
    let table = rows(6000, |i, z| format!("{:.1},{z:.5}", 0.5 * i as f64));
    format!("x_um,z_mm\n{table}")
}

#[test]
fn heights_in_a_wrong_unit_are_warned_of_and_no_case_runs_on_them() {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("high.csv", a_thousand_times_too_high());
    let info = ["profile", "info", "high.csv", "--lambda-c", "0.25mm"];
    assert_eq!(codes(&bench, &info), ["W124"]);
    bench.write(
        "case.toml",
        with_line("pinion =", "pinion = { file = \"high.csv\" }"),
    );
    for command in [
        &["run", "case.toml", "--no-output"][..],
        &["check", "case.toml"],
    ] {
        let says = ["high.csv", "z_unit = \"um\" in surface.pinion"];
        bench.run(command).refused(2, "E131", &says);
    }
    let line = "pinion = { file = \"high.csv\", z_unit = \"um\" }";
    bench.write("case.toml", with_line("pinion =", line));
    bench.run(&["check", "case.toml", "-q"]).well();
}

#[test]
fn depths_are_heights_of_the_same_flank_and_a_case_turns_other_values() {
    let bench = Bench::new();
    bench.write_flanks();
    let file = |name: &str, sign: f64| {
        let table = rows(6000, |i, z| {
            format!("{:.1},{:.5}", 0.5 * i as f64, sign * z)
        });
        format!("x_um,{name}_um\n{table}")
    };
    bench.write("height.csv", file("height", 1.0));
    bench.write("depth.csv", file("depth", -1.0));
    bench.write("sensor.csv", file("z", -1.0));
    let info = |name: &'static str| vec!["profile", "info", name, "--lambda-c", "0.25mm"];
    assert_eq!(codes(&bench, &info("depth.csv")), ["W328"]);
    let rsk = |arguments: &[&str]| {
        let json = bench.run(&[arguments, &["--json"]].concat()).well().json();
        json["iso4287"]["rsk"].as_f64().unwrap()
    };
    let right = rsk(&info("height.csv"));
    assert!(right != 0.0);
    assert_eq!(rsk(&info("depth.csv")), right);
    assert_eq!(rsk(&info("sensor.csv")), -right);
    let turned = [&info("sensor.csv")[..], &["--invert"]].concat();
    assert_eq!((rsk(&turned), codes(&bench, &turned)), (right, vec![]));
    let kept = [&info("depth.csv")[..], &["--invert=false"]].concat();
    assert_eq!((rsk(&kept), codes(&bench, &kept)), (-right, vec![]));
    let shown = bench.run(&turned).well().out;
    assert!(shown.contains("sensor.csv\", invert = true }"), "{shown}");
    // The film of a run depends on the sign.
    let regime = |flank: &str| {
        let line = format!("pinion = {{ file = {flank} }}");
        bench.write("case.toml", with_line("pinion =", &line));
        let said = bench.run(&["run", "case.toml", "--json", "--no-output", "--no-band"]);
        said.well().json()["summary"]["loss_w"].as_f64().unwrap()
    };
    let loss = regime("\"height.csv\"");
    assert_eq!(regime("\"depth.csv\""), loss);
    assert_eq!(regime("\"sensor.csv\", invert = true"), loss);
    assert!(regime("\"sensor.csv\"") != loss);
}

#[test]
fn uneven_positions_are_warned_of_and_resampled_on_request() {
    let bench = Bench::new();
    let uneven = rows(2000, |i, z| {
        let off = if i % 2 == 0 { 0.0 } else { 0.05 };
        format!("{:.3},{z:.5}", 0.5 * i as f64 + off)
    });
    bench.write("uneven.csv", format!("x_um,z_um\n{uneven}"));
    let info = ["profile", "info", "uneven.csv", "--level"];
    assert_eq!(codes(&bench, &info), ["W125"]);
    let resampled = [&info[..], &["--uneven", "resample"]].concat();
    assert_eq!(codes(&bench, &resampled), ["W126"]);
}

#[test]
fn a_gap_in_the_positions_is_not_drawn_over() {
    let bench = Bench::new();
    let gap = rows(1000, |i, z| {
        let off = if i > 500 { 20.0 } else { 0.0 };
        format!("{:.1},{z:.5}", 0.5 * i as f64 + off)
    });
    bench.write("gap.csv", format!("x_um,z_um\n{gap}"));
    bench
        .run(&["profile", "info", "gap.csv", "--uneven", "resample"])
        .informed("E136", &["gap.csv"]);
}

#[test]
fn an_uneven_trace_is_converted_with_the_places_of_its_points() {
    let bench = Bench::new();
    let uneven = rows(2000, |i, z| {
        let off = if i % 3 == 0 { 0.2 } else { 0.0 };
        format!("{:.1},{z:.5}", 0.5 * i as f64 + off)
    });
    bench.write("uneven.csv", format!("x_um,z_um\n{uneven}"));
    bench
        .run(&["profile", "info", "uneven.csv"])
        .informed("E109", &["Pass --uneven resample"]);
    for kept in ["kept.csv", "kept.x3p"] {
        let said = bench.run(&["profile", "convert", "uneven.csv", kept]);
        let text = said.well().unwrapped();
        assert!(
            text.contains("2000 uneven points") && text.contains("W324"),
            "{text}"
        );
        bench
            .run(&["profile", "info", kept])
            .informed("E109", &["away from an even grid of 499.9 nm"]);
    }
    bench
        .run(&["profile", "convert", "uneven.csv", "kept.smd"])
        .refused(2, "E401", &["unevenly spaced"]);
    let even = ["profile", "convert", "uneven.csv", "even.smd"];
    let resampled = [&even[..], &["--resample", "0.25um", "--json"]].concat();
    let found = bench.run(&resampled).well().json();
    assert_eq!(found["reading"]["warnings"][0]["kind"], "resampled");
    assert_eq!(found["n"], 3998);
    let text = bench.run(&[&even[..], &["--uneven", "resample"]].concat());
    let text = text.well().unwrapped();
    assert!(
        text.contains("W126") && text.contains("root mean square"),
        "{text}"
    );
    let filter = [
        "profile",
        "filter",
        "uneven.csv",
        "r.csv",
        "--uneven",
        "resample",
    ];
    let text = bench.run(&[&filter[..], &["--lambda-c", "0.08mm"]].concat());
    assert!(text.well().unwrapped().contains("W126"));
}

#[test]
fn roll_lengths_need_the_base_radius() {
    let bench = Bench::new();
    let table = rows(2000, |i, z| format!("{:.4},{z:.5}", 8.0 + 0.002 * i as f64));
    bench.write("roll.csv", format!("roll length [mm],z [um]\n{table}"));
    let info = ["profile", "info", "roll.csv", "--lambda-c", "0.25mm"];
    bench
        .run(&info)
        .refused(2, "E130", &["roll.csv", "Pass --base-radius"]);
    let converted = [&info[..], &["--base-radius", "40mm"]].concat();
    assert!(codes(&bench, &converted).contains(&"W127".to_owned()));
    // A base radius is of no use to distances along the flank.
    bench.write("flank.csv", trace("x_um,z_um", 2000));
    let idle = [
        "profile",
        "info",
        "flank.csv",
        "--level",
        "--base-radius",
        "40mm",
    ];
    bench.run(&idle).refused(2, "E205", &["--base-radius"]);
}

#[test]
fn another_involute_than_that_of_the_trace_is_told() {
    let bench = Bench::new();
    // No involute at all: taking one off leaves a parabola of x²/(2ρ).
    bench.write("flank.csv", trace("x_um,z_um", 6000));
    let info = ["profile", "info", "flank.csv", "--lambda-c", "0.25mm"];
    let involute = [
        "--form",
        "involute",
        "--base-radius",
        "50mm",
        "--roll-length",
        "15mm",
    ];
    assert!(codes(&bench, &[&info[..], &involute].concat()).contains(&"W128".to_owned()));
    assert!(!codes(&bench, &info).contains(&"W128".to_owned()));
}

#[test]
fn the_cut_offs_of_a_file_are_the_default_and_an_override_is_said() {
    let bench = Bench::new();
    let table = rows(6000, |_, z| format!("{z:.4}"));
    bench.write("stated.tx1", format!("3.00000\n6000\n{table}"));
    bench.write(
        "stated.tx3",
        "Evaluation length\t3.0mm\nCutoff\t0.25mm\nCutoff Ls\t8um\n",
    );
    let said = |options: &[&str]| {
        let all = [&["profile", "info", "stated.tx1"][..], options].concat();
        bench.run(&all).well()
    };
    let json = |options: &[&str]| said(&[options, &["--json"]].concat()).json()["iso4287"].take();
    let stated = json(&[]);
    assert_eq!(stated, json(&["--lambda-c", "0.25mm", "--lambda-s", "8um"]));
    assert_ne!(stated, json(&["--lambda-c", "0.5mm"]));
    assert!(
        said(&[])
            .unwrapped()
            .contains("cut-offs as the file states them")
    );
    let overridden = said(&["--lambda-c", "0.5mm"]).unwrapped();
    let says = "the cut-offs of the file are overridden; to filter like the instrument, pass --lambda-c \"250 um\" --lambda-s \"8 um\"";
    assert!(overridden.contains(says), "{overridden}");
}

#[test]
fn a_case_filters_as_its_file_states_unless_it_says_otherwise() {
    let bench = Bench::new();
    bench.write_flanks();
    let table = rows(6000, |_, z| format!("{z:.4}"));
    bench.write("stated.tx1", format!("3.00000\n6000\n{table}"));
    let facts = "Evaluation length\t3.0mm\nCutoff\t0.5mm\nCutoff Ls\t8um\n";
    bench.write("stated.tx3", facts);
    let case = with_line("pinion =", "pinion = { file = \"stated.tx1\" }");
    bench.write("asked.toml", &case);
    bench.write("open.toml", case.replace("cutoff = \"0.25 mm\"\n", ""));
    let result = |case: &str| {
        let run = ["run", case, "--no-output", "--json"];
        bench.run(&run).well().json()
    };
    let cutoffs = |found: &serde_json::Value| {
        [0, 1].map(|body| {
            let recipe = &found["flanks"][body]["preparation"]["recipe"];
            [&recipe["lambda-c"], &recipe["lambda-s"]].map(|text| text.as_str().unwrap().to_owned())
        })
    };
    let open = result("open.toml");
    // The wheel's file states nothing: 0.25 mm, as is usual on gears.
    assert_eq!(cutoffs(&open), [["500 um", "8 um"], ["250 um", "2.5 um"]]);
    let stated = |default: &&serde_json::Value| {
        default["source"] == "stated in stated.tx1" && default["key"] == "surface.cutoff"
    };
    let mut defaults = open["defaults"].as_array().unwrap().iter();
    assert_eq!(defaults.find(stated).unwrap()["value"], "\"500 um\"");
    assert_eq!(cutoffs(&result("asked.toml"))[0], ["250 um", "8 um"]);
    let said = bench.run(&["run", "asked.toml", "--no-output", "--notes"]);
    let said = said.well().unwrapped();
    let says = "W129 stated.tx1: the file states λc 500 um, the case surface.cutoff = 250 um";
    assert!(said.contains(says), "{said}");
}

#[test]
fn standard_input_is_a_file_like_any_other() {
    let bench = Bench::new();
    let text = trace("x_um,z_um", 6000);
    bench.write("flank.csv", &text);
    let piped = |arguments: &[&str]| {
        let mut child = Command::new(program())
            .args(arguments)
            .current_dir(bench.path(""))
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let mut input = child.stdin.take().unwrap();
        input.write_all(text.as_bytes()).unwrap();
        drop(input);
        let said = child.wait_with_output().unwrap();
        assert!(said.status.success(), "{said:?}");
        String::from_utf8(said.stdout).unwrap()
    };
    let options = ["--lambda-c", "0.25mm", "--json"];
    let of = |text: &str| serde_json::from_str::<serde_json::Value>(text).unwrap();
    let from_pipe = of(&piped(&[&["profile", "info", "-"][..], &options].concat()));
    let from_file = bench.run(&[&["profile", "info", "flank.csv"][..], &options].concat());
    assert_eq!(from_pipe["iso4287"], from_file.well().json()["iso4287"]);
    let converted = piped(&["profile", "convert", "-", "-"]);
    let of_file = bench.run(&["profile", "convert", "flank.csv", "-"]).well();
    assert_eq!(converted, of_file.out);
}

#[test]
fn a_picture_without_a_name_replaces_no_other_file() {
    let bench = Bench::new();
    bench.write("flank.csv", trace("x_um,z_um", 6000));
    bench.write("flank.svg", "mine");
    let plot = ["profile", "plot", "flank.csv", "--lambda-c", "0.25mm"];
    bench
        .run(&plot)
        .refused(2, "E401", &["flank.svg: exists", "-o"]);
    assert_eq!(std::fs::read(bench.path("flank.svg")).unwrap(), b"mine");
    let named = [&plot[..], &["-o", "flank.svg"]].concat();
    bench.run(&named).well();
    let picture = std::fs::read(bench.path("flank.svg")).unwrap();
    assert!(picture.starts_with(b"<svg"));
    // The same picture again is no loss.
    bench.run(&plot).well();
    assert_eq!(std::fs::read(bench.path("flank.svg")).unwrap(), picture);
    assert_eq!(bench.listing(), ["flank.csv", "flank.svg"]);
}

/// A flank on which dust or lost light left 25 spikes of up to two points.
fn with_spikes() -> String {
    let table = rows(8000, |i, z| {
        let height = match i % 300 {
            40 => 9.0,
            41 if i % 900 == 41 => 8.0,
            _ => 0.0,
        };
        let height = if (300..7800).contains(&i) {
            height
        } else {
            0.0
        };
        format!("{:.1},{:.5}", 0.5 * i as f64, z + height)
    });
    format!("x_um,z_um\n{table}")
}

#[test]
fn spikes_are_named_as_spikes_and_replaced_on_request() {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("spikes.csv", with_spikes());
    let info = ["profile", "info", "spikes.csv", "--lambda-c", "0.25mm"];
    let said = bench.run(&info).well().unwrapped();
    assert!(
        said.contains("25 spikes of up to 2 points") && said.contains("Pass --outliers 6"),
        "{said}"
    );
    let cleaned = [&info[..], &["--outliers", "6"]].concat();
    assert_eq!(codes(&bench, &cleaned), ["W130"]);
    let flank = |more: &str| {
        let case = with_line("pinion =", "pinion = { file = \"spikes.csv\" }");
        case.replace("[surface]\n", &format!("[surface]\n{more}"))
    };
    bench.write("case.toml", flank(""));
    let says = ["25 spikes", "outliers = 6 in surface"];
    bench
        .run(&["run", "case.toml", "--no-output"])
        .refused(2, "E131", &says);
    bench.write("case.toml", flank("outliers = 6\n"));
    let found = bench.run(&["check", "case.toml", "--json"]).well().json();
    assert!(
        found["warnings"]
            .to_string()
            .contains("33 points were replaced"),
        "{found:#}"
    );
    bench.write("case.toml", flank("outliers = -6\n"));
    bench.run(&["run", "case.toml", "--no-output"]).refused(
        2,
        "E209",
        &["outliers", "must be positive"],
    );
}

#[test]
fn fewer_heights_than_the_header_states_are_warned_of_and_more_are_refused() {
    let bench = Bench::new();
    let table = rows(2000, |i, z| format!("{:.1},{z:.5}", 0.5 * i as f64));
    let info = ["profile", "info", "flank.csv", "--level"];
    for (stated, code) in [(2000, None), (2400, Some("W131"))] {
        bench.write("flank.csv", format!("Points: {stated}\nx_um,z_um\n{table}"));
        assert_eq!(codes(&bench, &info), Vec::from_iter(code));
    }
    bench.write("flank.csv", format!("Points: 1999\nx_um,z_um\n{table}"));
    bench
        .run(&info)
        .refused(2, "E117", &["line 1", "1999", "2000 read"]);
}

/// A trace of 6 mm with a groove from 3.66 to 3.74 mm.
fn grooved() -> String {
    let groove = |x: f64| (1.0 - ((x - 3700.0) / 40.0).powi(2)).max(0.0);
    let table = rows(12_001, |i, z| {
        let x = 0.5 * i as f64;
        format!("{x:.1},{:.5}", z - 15.0 * groove(x))
    });
    format!("x_um,z_um\n{table}")
}

#[test]
fn a_groove_is_warned_of_until_the_trace_is_cut_to_its_sound_part() {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("grooved.csv", grooved());
    let info = ["profile", "info", "grooved.csv"];
    assert_eq!(codes(&bench, &info), ["W132"]);
    let said = bench.run(&info).well().unwrapped();
    assert!(
        said.contains("before the roughness filter the heights there span 15.2 um"),
        "{said}"
    );
    assert!(said.contains("Pass --range 0mm..3.62mm"), "{said}");
    let cut = [&info[..], &["--range", "0mm..3.62mm"]].concat();
    assert_eq!(codes(&bench, &cut), [""; 0]);
    let lines = bench.run(&cut).well().unwrapped();
    assert!(lines.contains("length 3.62 mm"), "{lines}");
    assert!(lines.contains("cut to 0 mm .. 3.62 mm of 6 mm"), "{lines}");
    assert!(lines.contains("range = \"0 mm .. 3.62 mm\" }"), "{lines}");
    let json = bench.run(&[&cut[..], &["--json"]].concat()).well().json();
    assert_eq!(json["reading"]["cut"]["of"], "6 mm");
    let beyond = [&info[..], &["--range", "0mm..9mm"]].concat();
    bench.run(&beyond).refused(
        2,
        "E139",
        &["0 mm .. 9 mm", "which is 6 mm long", "Pass --range"],
    );

    // Read from its other end, the trace has its groove in the same place.
    let wheel = |range: &str| {
        let line = format!("wheel = {{ file = \"grooved.csv\", mirrored = true{range} }}");
        bench.write("case.toml", with_line("wheel =", &line));
        bench.run(&["check", "case.toml"])
    };
    let said = wheel("").well().unwrapped();
    for part in [
        "W132 grooved.csv",
        "Write range = \"0 mm .. 3.62 mm\" in surface.wheel",
        "W448 filtered traces are longer than the active flank: 5.75 mm in surface.wheel on 3.4",
    ] {
        assert!(said.contains(part), "{part:?} is not in {said}");
    }
    let said = wheel(", range = \"0 mm .. 3.62 mm\"").well().unwrapped();
    assert!(!said.contains("W132") && !said.contains("W448"), "{said}");
    // Between the cut ends the place counts from the first point of the file.
    let said = wheel(", range = \"0.5 mm .. 6 mm\"").well().unwrapped();
    assert!(said.contains("\"0.5 mm .. 3."), "{said}");
    wheel(", range = \"0 mm .. 9 mm\"").refused(
        2,
        "E139",
        &["which is 6 mm long", "in surface.wheel"],
    );
    wheel(", range = \"9 mm\"").refused(2, "E204", &["two distances"]);
}

#[test]
fn a_feature_without_a_robust_line_is_to_be_left_out() {
    let bench = Bench::new();
    let groove = |x: f64| match (x - 3700.0) / 310.0 {
        u if u.abs() < 1.0 => (u * std::f64::consts::FRAC_PI_2).cos().powi(2),
        _ => 0.0,
    };
    let table = rows(12_001, |i, z| {
        let x = 0.5 * i as f64;
        format!("{x:.1},{:.5}", z - 20.0 * groove(x))
    });
    bench.write("groove.csv", format!("x_um,z_um\n{table}"));
    let robust = ["profile", "info", "groove.csv", "--robust"];
    let said = bench.run(&robust);
    said.informed(
        "E120",
        &[
            "did not converge in 100 iterations",
            "pass --range",
            "leave --robust out",
        ],
    );
    let change = said.err.split("last relative change ").nth(1).unwrap();
    assert_eq!(change.find('.').unwrap_or(0), 1, "{change}");
    assert!(change[3..].starts_with("e-"), "{change}");
    bench
        .run(&[&robust[..], &["--range", "0mm..3.3mm"]].concat())
        .well();
}
