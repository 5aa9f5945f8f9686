//! `asperity oil`: traction curves.

use std::fs;

use crate::bench::{Bench, E_DRIVE, OIL_FILE};

/// A model without shear stress of the film.
const XU: [&str; 4] = [
    "--set",
    "model.film_friction=\"xu\"",
    "--set",
    "model.load_share=\"lambda-star\"",
];

/// Columns of a table of a folder: rows of numbers.
fn rows(bench: &Bench, file: &str) -> Vec<Vec<f64>> {
    let text = fs::read_to_string(bench.path(file)).unwrap();
    let lines = text.lines().skip(1);
    lines
        .map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect())
        .collect()
}

#[test]
fn traction_is_predicted_where_the_film_separates_the_surfaces() {
    let bench = Bench::new();
    let arguments = ["oil", "traction", "e-fluid-70w75w", "--speed", "1 m/s"];
    let out = bench.run(&arguments).well().unwrapped();
    assert!(
        out.contains("At 120 °C the film at 1 m/s is thinner"),
        "{out}"
    );
    let folder = "results/e-fluid-70w75w-traction";
    for file in ["traction_over_slide_to_roll.csv", "traction_over_speed.csv"] {
        let rows = rows(&bench, &format!("{folder}/{file}"));
        assert!(rows.len() > 30);
        for row in rows {
            let [traction, low, high, ratio] = [row[4], row[5], row[6], row[8]];
            assert!(
                ratio >= 3.0 && 0.0 < low && low < traction && traction < high,
                "{row:?}"
            );
        }
    }
    let page = fs::read_to_string(bench.path(folder).join("traction.html")).unwrap();
    assert!(page.contains("guide to boundary friction, 120 °C"));
    // The guide is a drawing.
    let json = fs::read_to_string(bench.path(folder).join("traction.json")).unwrap();
    assert!(!json.contains("guide"));
}

#[test]
fn the_oil_of_a_case_has_its_own_constants() {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("case.toml", E_DRIVE);
    let traction = |set: &[&str]| {
        let mut arguments = vec!["oil", "traction", "case.toml", "-o", "found"];
        arguments.extend(set);
        bench.run(&arguments).well();
        rows(&bench, "found/traction_over_slide_to_roll.csv")
    };
    let own = traction(&[]);
    let factor = traction(&["--set", "lubricant.pressure_viscosity_factor=0.9"]);
    assert_eq!(own.len(), factor.len());
    for (own, factor) in own.iter().zip(&factor) {
        // The film keeps its thickness, the friction falls.
        assert!(own[7] == factor[7] && factor[4] < own[4]);
    }
    let falling = traction(&["--set", "lubricant.limiting_shear_temperature=0.004 1/K"]);
    assert!(
        own.iter()
            .zip(&falling)
            .all(|(own, falling)| if own[3] < 80.0 {
                falling[4] > own[4]
            } else {
                true
            })
    );
}

#[test]
fn the_data_sheet_of_an_oil_needs_no_gears() {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("case.toml", E_DRIVE);
    let sheet = OIL_FILE.split("\n[film_friction]").next().unwrap();
    let (_, sheet) = sheet.split_once("[lubricant]").unwrap();
    let sheet = format!("[lubricant]{sheet}");
    bench.write("sheet.toml", &sheet);
    bench.write("unit.toml", sheet.replace(" kg/m3", ""));
    bench.write("key.toml", sheet.replace("density", "densty"));
    let of = |file: &str| {
        let arguments = [
            "oil",
            "traction",
            file,
            "--temperature",
            "80",
            "-o",
            "found",
        ];
        bench.run(&arguments).well();
        rows(&bench, "found/traction_over_slide_to_roll.csv")
    };
    assert_eq!(of("sheet.toml"), of("case.toml"));
    let refused = |arguments: &[&str], code: &str, says: &[&str]| {
        let arguments = [&["oil", "traction"], arguments].concat();
        bench.run(&arguments).refused(2, code, says);
    };
    refused(&["unit.toml"], "E204", &["unit.toml:3", "845 has no unit"]);
    refused(&["key.toml"], "E203", &["Did you mean \"density\"?"]);
    let keys = ["--set", "lubricant.density=\"800 kg/m3\""];
    for oil in ["sheet.toml", "m100"] {
        refused(&[&[oil], &keys[..]].concat(), "E205", &["--set"]);
    }
}

#[test]
fn oils_and_settings_that_give_no_traction_are_refused() {
    let bench = Bench::new();
    bench.write_flanks();
    bench
        .run(&["oil", "traction", "m-100"])
        .refused(2, "E220", &["Did you mean \"m100\"?"]);
    let one = bench.run(&["oil", "traction", "paper-table-2"]);
    one.refused(2, "E208", &["known at one temperature only"]);
    let negative = bench.run(&["oil", "traction", "m100", "--load", "-3 N"]);
    negative.refused(2, "E209", &["load = -3 N"]);
    let axis = bench.run(&["oil", "traction", "m100", "--temperature", "x"]);
    axis.refused(2, "E209", &["--temperature"]);
    let friction = bench.run(&["oil", "traction", "m100", "--boundary-friction", "0"]);
    friction.refused(2, "E209", &["--boundary-friction"]);
    let rolling = bench.run(&["oil", "traction", "m100", "--slide-to-roll", "0 %"]);
    rolling.refused(2, "E209", &["slide-to-roll ratio"]);
    bench.write("case.toml", E_DRIVE);
    let law = bench.run(&[&["oil", "traction", "case.toml"], &XU[..]].concat());
    law.refused(2, "E205", &["not computed from a shear stress"]);
}

#[test]
fn constants_of_the_film_friction_need_a_shear_stress() {
    let bench = Bench::new();
    bench.write_flanks();
    for (line, says) in [
        (
            "pressure_viscosity_factor = 0.9",
            "pressure_viscosity_factor",
        ),
        (
            "limiting_shear_temperature = \"0.001 1/K\"",
            "limiting_shear_temperature",
        ),
    ] {
        let case = E_DRIVE.replacen("[lubricant]\n", &format!("[lubricant]\n{line}\n"), 1);
        bench.write("case.toml", &case);
        bench.run(&["check", "case.toml"]).well();
        let run = bench.run(&[&["run", "case.toml", "--json"], &XU[..]].concat());
        run.refused_json("E205", says);
    }
    let steep = E_DRIVE.replacen(
        "[lubricant]\n",
        "[lubricant]\nlimiting_shear_temperature = \"0.05 1/K\"\n",
        1,
    );
    bench.write("case.toml", &steep);
    bench
        .run(&["run", "case.toml", "--json"])
        .refused_json("E212", "limiting_shear_temperature");
}

const UNREAD: &str = "W454 columns of curves.csv that are not read: Remark";

/// A table with a further column.
fn with_remark(table: &str) -> String {
    table
        .replacen('\n', ",Remark\n", 1)
        .replace('\n', ",a\n")
        .replacen(",a\n", "\n", 1)
}

/// Predicted curves of an oil as a table of measured ones, each friction changed; every third point, which is fitted sooner.
fn curves(bench: &Bench, change: impl Fn(f64) -> f64) -> String {
    every(3, bench, change)
}

/// Every `step`th point of [`curves`].
fn every(step: usize, bench: &Bench, change: impl Fn(f64) -> f64) -> String {
    bench
        .run(&["oil", "traction", "m100", "-o", "curves"])
        .well();
    let mut text =
        String::from("load_n,mean_speed_m_s,slide_roll_percent,temperature_c,traction\n");
    let rows = rows(bench, "curves/traction_over_slide_to_roll.csv");
    for row in rows.into_iter().step_by(step) {
        let traction = change(row[4]);
        text.push_str(&format!(
            "{},{},{},{},{traction}\n",
            row[0], row[1], row[2], row[3]
        ));
    }
    text
}

#[test]
fn curves_of_an_oil_give_its_constants_back() {
    let bench = Bench::new();
    bench.write(
        "curves.csv",
        with_remark(&curves(&bench, |traction| traction)),
    );
    let arguments = ["oil", "fit", "curves.csv", "--oil", "m100", "-o", "found"];
    let out = bench.run(&arguments).well().unwrapped();
    assert!(out.contains(UNREAD), "{out}");
    // Exact curves: the stated errors are far too large.
    assert!(
        out.contains("W441 the residuals are 0.0 times the stated errors"),
        "{out}"
    );
    assert!(
        out.contains("The points decide the law of pressure"),
        "{out}"
    );
    let text = fs::read_to_string(bench.path("found/oil_fit.json")).unwrap();
    let json: serde_json::Value = serde_json::from_str(&text).unwrap();
    for constant in json["constants"].as_array().unwrap() {
        let [value, prior] = ["value", "prior"].map(|key| constant[key].as_f64().unwrap());
        assert!((value - prior).abs() < 1e-3 * prior.max(0.01), "{constant}");
    }
    // The oil file in a case.
    bench.write_flanks();
    let named = "[lubricant]\noil_file = \"found/oil.toml\"\n";
    bench.write("case.toml", E_DRIVE.replacen("[lubricant]\n", named, 1));
    bench.run(&["check", "case.toml"]).well();
    // The oil of the curves against another oil: no constant of the curves belongs to the other one.
    let other = [
        "compare",
        "case.toml",
        "--variant",
        "pao: lubricant.oil=pao100",
    ];
    let json = bench
        .run(&[&other[..], &["--no-output", "--json"]].concat())
        .json();
    let difference = &json["finishes"][1]["difference"];
    let rows = difference["common"].as_array().unwrap().iter();
    let own =
        rows.filter(|row| row["name"] == "limiting shear stress" || row["name"] == "Eyring stress");
    let own: Vec<_> = own.map(|row| row["correlation"].as_f64()).collect();
    assert!(
        !own.is_empty() && own.iter().all(|rho| *rho == Some(0.0)),
        "{difference}"
    );
}

#[test]
fn curves_that_give_no_constants_are_refused() {
    let bench = Bench::new();
    let fit = |text: &str, more: &[&str]| {
        bench.write("curves.csv", text);
        let arguments = [&["oil", "fit", "curves.csv", "--oil", "m100"], more].concat();
        bench.run(&arguments)
    };
    let table = every(6, &bench, |traction| traction);
    fit(&table.replace("load_n", "load_kg"), &[]).refused(2, "E317", &["load_kg is not known"]);
    fit(&table.replace("traction", "friction"), &[]).refused(
        2,
        "E317",
        &["friction is not known; write traction"],
    );
    let named = table
        .replace("load_n", "Max Hertz pressure (GPa)")
        .replace("mean_speed_m_s", "Rolling Speed (m/s)");
    let renamed = [
        "max_hertz_pressure_gpa is not known; write max_pressure_gpa",
        "write mean_speed_m_s",
    ];
    fit(&named, &[]).refused(2, "E317", &renamed);
    fit(&table.replace("load_n", "x").replace("traction", "y"), &[]).refused(
        2,
        "E317",
        &["columns load_n, traction are missing"],
    );
    fit(&table.replacen("30,2,", "30,2000,", 1), &[]).refused(2, "E317", &["mean_speed_m_s"]);
    fit("MTM Test Data File\n", &[]).refused(2, "E317", &["no table has the columns"]);
    let few: Vec<&str> = table.lines().take(6).collect();
    fit(&few.join("\n"), &[]).refused(2, "E318", &["5 of 5 set points"]);
    fit(&table, &["--rq", "1 um"]).refused(2, "E318", &["film thinner than three times"]);
    // 0.948 GPa are 30 N on a ball of 9.525 mm on a flat, with 115.385 GPa.
    let by_pressure = table
        .replace("load_n", "max_pressure_gpa")
        .replace("\n30,2,", "\n0.948,2,");
    let both = [fit(&table, &["--json"]), fit(&by_pressure, &["--json"])];
    let [by_load, by_pressure] =
        both.map(|run| run.json()["points"][0]["load_n"].as_f64().unwrap());
    assert!(
        (by_pressure / by_load - 1.0).abs() < 2e-3,
        "{by_pressure} {by_load}"
    );
    let light = table.replace("\n30,2,", "\n0.5,2,");
    fit(&light, &[]).refused(2, "E318", &["at least 0.4 GPa"]);
    let high = every(1, &bench, |traction| 2.0 * traction);
    let machine = fit(&high, &[]);
    machine.refused(2, "E319", &["the machine would have to read the friction"]);
    let scattered = every(6, &bench, |traction| match (1e7 * traction) as i64 % 2 {
        0 => 1.15 * traction,
        _ => 0.85 * traction,
    });
    fit(&scattered, &[]).refused(2, "E319", &["no law explains the curves", "curves.csv:"]);
    let low = every(6, &bench, |traction| 0.2 * traction);
    fit(&low, &["--wide"]).refused(2, "E319", &["no known oil has this"]);
    fit(&low, &["--wide", "--force"]).well();
    // A limiting stress that falls so fast that a film would have several temperatures: no case takes it, forced or not.
    let steep = table.lines().map(|line| {
        let (place, traction) = line.rsplit_once(',').unwrap();
        let factor = match place.rsplit_once(',').unwrap().1 {
            "80" => 0.6,
            "120" => 0.3,
            _ => return line.to_owned(),
        };
        format!("{place},{}", factor * traction.parse::<f64>().unwrap())
    });
    let steep = steep.collect::<Vec<String>>().join("\n");
    let forced = ["--wide", "--force", "--point-floor", "0.01"];
    fit(&steep, &forced).refused(2, "E319", &["no case takes it"]);
    let one = bench.run(&["oil", "fit", "curves.csv", "--oil", "paper-table-2"]);
    one.refused(2, "E208", &["known at one temperature only"]);
    bench.write_flanks();
    bench.write("case.toml", E_DRIVE);
    let law = [&["oil", "fit", "curves.csv", "--oil", "case.toml"], &XU[..]].concat();
    bench
        .run(&law)
        .refused(2, "E205", &["not computed from a shear stress"]);
    let no_family = ["--set", "lubricant.base_oil=\"unknown\""];
    let no_family = [
        &["oil", "fit", "curves.csv", "--oil", "case.toml"],
        &no_family[..],
    ]
    .concat();
    assert_ne!(bench.run(&no_family).status, 0);
    fit(&table.replace("load_n", "load_n_m"), &[]).refused(2, "E317", &["line; its losses"]);
    let out = bench.run(&["oil", "fit", "nothere.csv", "--oil", "m100"]);
    out.refused(2, "E103", &["nothere.csv"]);
    fit(&table, &["--point-sd", "0 %"]).refused(2, "E209", &["--point-sd"]);
    let cold: Vec<&str> = table
        .lines()
        .filter(|line| !line.contains(",120,") && !line.contains(",80,"))
        .collect();
    let out = fit(&cold.join("\n"), &[]).well().unwrapped();
    assert!(out.contains("W441 one temperature"), "{out}");
}

#[test]
fn a_fit_under_a_condition_is_warned_about() {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("case.toml", E_DRIVE);
    let fit = |text: &str, oil: &str, more: &[&str]| {
        bench.write("curves.csv", text);
        let arguments = [&["oil", "fit", "curves.csv", "--oil", oil], more].concat();
        let out = bench.run(&[&arguments[..], &["-o", "found"]].concat());
        out.well().unwrapped()
    };
    let warned = |out: &str, part: &str| assert!(out.contains(part), "{part:?} is not in {out}");
    let table = curves(&bench, |traction| traction);
    let only = |out: &[&str]| {
        let is_in = |line: &&str| !out.iter().any(|part| line.contains(part));
        let lines: Vec<&str> = table.lines().filter(is_in).collect();
        lines.join("\n")
    };
    let thin = fit(&table, "m100", &["--rq", "60 nm"]);
    warned(&thin, "points are dropped");
    warned(
        &thin,
        "W441 one temperature: the constants hold within 15 K of 40 °C",
    );
    let low = every(1, &bench, |traction| 0.5 * traction);
    let low = fit(&low, "m100", &["--wide", "--force"]);
    warned(
        &low,
        "W441 the zero of curve 3 would have to be +0.0010 of the friction: 2.1",
    );
    warned(&low, "standard deviations from the family of the base oil");
    // The doubts go with the oil file, and are what the first screen of a run says.
    let of_fit = "[lubricant]\noil_file = \"found/oil.toml\"\n";
    let fitted = E_DRIVE.replacen("[lubricant]\n", of_fit, 1);
    bench.write("fitted.toml", fitted);
    let run = bench.run(&["run", "fitted.toml"]).well().unwrapped();
    warned(
        &run,
        "W441 fit of found/oil.toml: the zero of curve 3 would",
    );
    let scattered = curves(&bench, |traction| match (1e7 * traction) as i64 % 2 {
        0 => 1.025 * traction,
        _ => 0.975 * traction,
    });
    warned(
        &fit(&scattered, "m100", &[]),
        "the error of the law is 12 %",
    );
    let cold = only(&[",80,", ",120,"]);
    let decided = fit(&cold, "m100", &[]);
    warned(
        &decided,
        "the stated or estimated pressure-viscosity coefficient does, and must be right to 10 %",
    );
    let wide = fit(&cold, "m100", &["--wide"]);
    warned(&wide, "W441 the points do not decide the law of pressure");
    warned(&wide, "By the other law of pressure (roelands)");
    warned(
        &wide,
        "W441 Eyring stress [MPa] times pressure-viscosity factor to the power of",
    );
    warned(
        &wide,
        "the points do not separate the constants (correlation -0.9",
    );
    let own = [
        "oil",
        "traction",
        "case.toml",
        "--temperature",
        "40",
        "-o",
        "own",
    ];
    bench.run(&own).well();
    let own = fs::read_to_string(bench.path("own/traction_over_slide_to_roll.csv")).unwrap();
    let of_case = fit(&own, "case.toml", &[]);
    warned(
        &of_case,
        "W441 the case has 90 °C, 50 K outside of the tested 40 °C",
    );
}

#[test]
fn a_plan_lists_its_curves_and_the_errors_that_they_leave() {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("case.toml", E_DRIVE);
    let plan = |more: &[&str]| {
        let arguments = [&["oil", "plan", "--json"], more].concat();
        bench.run(&arguments).well().json()
    };
    let of_case = plan(&["--oil", "case.toml", "-o", "plan"]);
    let loss = |stage: usize| of_case["stages"][stage]["loss_deviation"].as_f64().unwrap();
    // Ten points that are chosen for the loss leave less of its error than one curve of ten points.
    assert!(loss(0) > 3.0 * loss(1) && loss(5) < loss(1) && loss(3) < loss(2));
    assert_eq!(of_case["chosen"].as_array().unwrap().len(), 10);
    let thin = of_case["curves"].as_array().unwrap();
    let thin = thin
        .iter()
        .find(|curve| curve["slides_percent"] == serde_json::json!([]));
    assert_eq!(thin.unwrap()["dropped"][0], "thin-film");
    // The table to fill in is a table of traction curves without friction.
    let table = fs::read_to_string(bench.path("plan/plan.csv")).unwrap();
    assert_eq!(table.lines().count(), 1 + 2 * 100);
    let fit = bench.run(&["oil", "fit", "plan/plan.csv", "--oil", "case.toml"]);
    fit.refused(2, "E317", &["plan.csv:2", "traction: is missing"]);
    let filled = table.lines().map(|line| {
        let cells: Vec<&str> = line.split(',').collect();
        let traction = match cells[4] {
            "" => cells[6],
            head => head,
        };
        format!(
            "{},{},{},{},{traction},{}\n",
            cells[0], cells[1], cells[2], cells[3], cells[5]
        )
    });
    bench.write("filled.csv", filled.collect::<String>());
    let out = bench.run(&["oil", "fit", "filled.csv", "--oil", "case.toml"]);
    let out = out.well().unwrapped();
    assert!(
        out.contains("200 readings at 100 set points, 100 fitted"),
        "{out}"
    );
    // Without a case, the constants together.
    let of_oil = plan(&["--oil", "e-fluid-70w75w"]);
    assert!(of_oil["case"].is_null() && of_oil["stages"][0]["loss_deviation"].is_null());
    let both = plan(&[
        "--oil",
        "e-fluid-70w75w",
        "--case",
        "case.toml",
        "-o",
        "both",
    ]);
    assert!(both["stages"][1]["loss_deviation"].is_number() && both["remaining_width"].is_null());
    let width = of_case["remaining_width"].as_f64().unwrap();
    let evidence = bench.run(&["evidence", "case.toml", "--json"]).well();
    let evidence = evidence.json();
    let rows = evidence["rows"].as_array().unwrap();
    let of_plan = rows.iter().find(|row| row["key"] == "traction-plan");
    assert_eq!(
        width,
        of_plan.map_or(1.0, |row| row["width"].as_f64().unwrap())
    );
    let rough = bench.run(&[
        "oil", "plan", "--oil", "m100", "--rq", "1 um", "-o", "rough",
    ]);
    let out = rough.well().unwrapped();
    assert!(
        out.contains("left out: film thinner than three times"),
        "{out}"
    );
    let law = bench.run(&[&["oil", "plan", "--oil", "case.toml"], &XU[..]].concat());
    law.refused(2, "E205", &["not computed from a shear stress"]);
}

/// Stribeck curves at 120 °C and 50 N: friction over speed and time of rubbing.
fn stribeck(friction: impl Fn(f64, f64) -> f64) -> String {
    let head = "load_n,mean_speed_m_s,slide_roll_percent,temperature_c,rubbing_s,traction\n";
    let row = |rubbing: f64, k: i32| {
        let speed = 0.002 * 1.5_f64.powi(k);
        format!("50,{speed},50,120,{rubbing},{}\n", friction(speed, rubbing))
    };
    let rows = [0.0, 7200.0].map(|time| (0..20).map(|k| row(time, k)).collect::<String>());
    head.to_owned() + &rows.concat()
}

/// Friction that falls from the boundary friction where the film grows.
fn rubbed(speed: f64, rubbing: f64) -> f64 {
    let boundary = if rubbing > 0.0 { 0.117 } else { 0.059 };
    0.02 + (boundary - 0.02) / (1.0 + (speed / 0.3).powi(2))
}

#[test]
fn stribeck_curves_give_the_boundary_friction_of_rubbed_specimens() {
    let bench = Bench::new();
    bench.write("curves.csv", with_remark(&stribeck(rubbed)));
    let arguments = [
        "oil",
        "stribeck",
        "curves.csv",
        "--oil",
        "m100",
        "-o",
        "found",
    ];
    let out = bench.run(&arguments).well().unwrapped();
    let out = out.split_whitespace().collect::<Vec<_>>().join(" ");
    for part in [
        "before rubbing 0.0590 5 ",
        "after 7200 s of rubbing 0.117",
        UNREAD,
        "0.117 (0.099..0.138) at 120 °C; in brackets 5 to 95 %",
    ] {
        assert!(out.contains(part), "{part:?} is not in {out}");
    }
    let text = fs::read_to_string(bench.path("found/stribeck.json")).unwrap();
    let json: serde_json::Value = serde_json::from_str(&text).unwrap();
    let number = |key: &str| json[key].as_f64().unwrap();
    assert!((number("boundary_friction") / 0.117 - 1.0).abs() < 1e-3);
    assert!((number("deviation") - 0.1).abs() < 1e-3);
    // The lines for a case run.
    bench.write_flanks();
    let block = fs::read_to_string(bench.path("found/case.toml")).unwrap();
    bench.write("case.toml", format!("{E_DRIVE}\n{block}"));
    bench.run(&["check", "case.toml"]).well();
    // The case is 30 K colder.
    let of_case = [
        "oil",
        "stribeck",
        "curves.csv",
        "--oil",
        "case.toml",
        "-o",
        "of-case",
    ];
    let out = bench.run(&of_case).well().unwrapped();
    assert!(
        out.contains("W441 the case has 90 °C, 30 K outside of the tested 120 °C"),
        "{out}"
    );
    // Files with the time of rubbing on the command line.
    let table = stribeck(rubbed);
    let file = |time: &str| {
        let of = table.lines().skip(1).filter(|line| line.contains(time));
        let rows = of.map(|line| line.replace(time, ",120,") + "\n");
        let head = "load_n,mean_speed_m_s,slide_roll_percent,temperature_c,traction\n";
        head.to_owned() + &rows.collect::<String>()
    };
    bench.write("new.csv", file(",120,0,"));
    bench.write("rubbed.csv", file(",120,7200,"));
    let times = [
        "--rubbing",
        "0 s,2 h",
        "--oil",
        "m100",
        "-o",
        "files",
        "--json",
    ];
    let files = [&["oil", "stribeck", "new.csv", "rubbed.csv"], &times[..]].concat();
    let files = bench.run(&files).well().json();
    assert_eq!(files["states"], json["states"]);
}

#[test]
fn stribeck_curves_without_a_boundary_friction_are_refused() {
    let bench = Bench::new();
    let given = |text: &str, more: &[&str]| {
        bench.write("curves.csv", text);
        let arguments = [&["oil", "stribeck", "curves.csv", "--oil", "m100"], more].concat();
        bench.run(&arguments)
    };
    let table = stribeck(rubbed);
    let unstated = table.replace(",rubbing_s", "").replace(",120,0,", ",120,");
    let unstated = unstated.replace(",120,7200,", ",120,");
    given(&unstated, &[]).refused(2, "E322", &["curves.csv:2", "for each file"]);
    given(&unstated, &["--rubbing", "0 s"]).refused(2, "E322", &["new specimens"]);
    given(&unstated, &["--rubbing", "1 h,2 h"]).refused(2, "E205", &["for each file"]);
    given(&unstated, &["--rubbing", "-1 h"]).refused(2, "E209", &["--rubbing"]);
    given(&table, &["--rq", "3 nm"]).refused(2, "E322", &["0 of 20 set points", "two speeds"]);
    let one_speed: Vec<&str> = table
        .lines()
        .filter(|line| !line.starts_with("50,0.00"))
        .collect();
    given(&one_speed.join("\n"), &[]).refused(2, "E322", &["at least 4"]);
    let rolling: Vec<String> = table
        .lines()
        .map(|row| {
            let mut cells: Vec<&str> = row.split(',').collect();
            if row.starts_with("50,") {
                cells[2] = "0";
            }
            cells.join(",")
        })
        .collect();
    let says = [
        "0 of 20 set points",
        "slide-to-roll ratio of at least 0.5 %",
    ];
    given(&rolling.join("\n"), &[]).refused(2, "E322", &says);
    let falling = stribeck(|speed, _| 0.1 * speed.powf(-0.06));
    given(&falling, &[]).refused(2, "E322", &["-14 % per decade of speed"]);
    let mut slow = String::from(table.lines().next().unwrap());
    for slide in [20, 30, 40, 50, 60] {
        slow += &format!("\n50,0.002,{slide},120,7200,0.1");
    }
    given(&slow, &[]).refused(2, "E322", &["5 of 5 set points", "two speeds"]);
}
