//! Oil files: precedence of their constants, refusals, and the intervals of every command.

use std::fs;

use asperity::case::CalibratedName;
use asperity_calibration::parameters::Parameter;
use serde_json::Value;

use crate::bench::{Bench, E_DRIVE, OIL_FILE, root};

/// A case that names an oil file, with lines in its table `lubricant`, and others at its end.
fn case(lubricant: &str, more: &str) -> String {
    let named = format!("[lubricant]\noil_file = \"oil.toml\"\n{lubricant}");
    E_DRIVE.replacen("[lubricant]\n", &named, 1) + more
}

/// A bench with the oil file and superfinished flanks.
fn bench() -> Bench {
    let bench = Bench::new();
    for (file, name) in [
        ("superfinished", "pinion"),
        ("superfinished_wheel", "wheel"),
    ] {
        let trace = root().join(format!("fixtures/profiles/{file}.csv"));
        fs::copy(trace, bench.path(&format!("{name}.csv"))).unwrap();
    }
    bench.write("oil.toml", OIL_FILE);
    bench.write("case.toml", case("", ""));
    bench.write("family.toml", E_DRIVE);
    bench
}

fn json(bench: &Bench, file: &str) -> Value {
    serde_json::from_str(&fs::read_to_string(bench.path(file)).unwrap()).unwrap()
}

/// Result of a run.
fn result(bench: &Bench, case: &str) -> Value {
    bench.write("run.toml", case);
    bench
        .run(&["run", "run.toml", "--no-output", "--json"])
        .well()
        .json()
}

/// Result of a run without draws.
fn at_medians(bench: &Bench, case: &str) -> Value {
    bench.write("run.toml", case);
    let arguments = ["run", "run.toml", "--no-output", "--no-band", "--json"];
    bench.run(&arguments).well().json()
}

/// Result of a run and its page.
fn with_page(bench: &Bench, case: &str) -> (Value, String) {
    bench.write("run.toml", case);
    let arguments = ["run", "run.toml", "-o", "out", "--json"];
    let result = bench.run(&arguments).well().json();
    let page = fs::read_to_string(bench.path("out/report.html")).unwrap();
    (result, page)
}

/// Names of the constants that were drawn.
fn drawn(result: &Value) -> Vec<&str> {
    let constants = result["uncertainty"]["constants"].as_array().unwrap();
    let names = constants.iter().map(|row| row["name"].as_str().unwrap());
    names.collect()
}

fn warned(result: &Value, code: &str) -> String {
    let warnings = result["warnings"].as_array().unwrap().iter();
    let of_code = warnings.filter(|warning| warning["code"] == code);
    let texts = of_code.map(|warning| warning["text"].as_str().unwrap().to_owned());
    texts.collect::<Vec<String>>().join("\n")
}

/// The value of a constant of the film friction.
fn constant(result: &Value, name: &str) -> f64 {
    let all = result["film_constants"].as_array().unwrap().iter();
    let mut of_name = all.filter(|row| row["name"] == name);
    of_name.next().unwrap()["value"].as_f64().unwrap()
}

#[test]
fn constants_from_simulated_measurements_are_warned_of() {
    let bench = bench();
    let checked = |case: &str| {
        bench.write("run.toml", case);
        let said = bench.run(&["check", "run.toml"]).well();
        let text = said.unwrapped();
        let lines = text.lines().filter(|line| line.starts_with("W446"));
        lines.map(str::to_owned).collect::<Vec<String>>()
    };
    let constant = "eyring_stress = { value = \"5 MPa\", low = \"4.5 MPa\", high = \"5.6 MPa\" }\n";
    let calibrated = |simulated: bool| {
        format!("\n[calibration]\nsimulated = {simulated}\nsource = \"rig.csv\"\n{constant}")
    };
    assert_eq!(checked(&case("", &calibrated(false))), [""; 0]);
    assert_eq!(
        checked(&case("", &calibrated(true))),
        ["W446 calibration: constants were fitted to simulated measurements: rig.csv"]
    );
    let simulated = OIL_FILE.replacen(
        "source = \"",
        "simulated = true\nsource = \"simulated.csv ",
        1,
    );
    assert_ne!(simulated, OIL_FILE);
    bench.write("oil.toml", simulated);
    let of_oil = checked(&case("", ""));
    assert_eq!(of_oil.len(), 1, "{of_oil:?}");
    assert!(of_oil[0].contains("lubricant.oil_file") && of_oil[0].contains("simulated.csv"));
}

#[test]
fn keys_of_the_case_and_its_calibration_replace_constants_of_the_oil_file() {
    let bench = bench();
    let (plain, page) = with_page(&bench, &case("", ""));
    assert!(drawn(&plain).contains(&"pressure-viscosity factor of the friction"));
    assert!(drawn(&plain).contains(&"fall of the limiting shear"));
    assert_eq!(constant(&plain, "eyring_stress_pa"), 4.8e6);
    assert_eq!(warned(&plain, "W442"), "");
    assert_eq!(warned(&plain, "W443"), "");
    assert!(page.contains(">pressure-viscosity factor of the friction</th>"));

    let of_case = result(
        &bench,
        &case(
            "pressure_viscosity_factor = 0.9\ndensity = \"850 kg/m3\"\n",
            "",
        )
        .replacen("density = \"845 kg/m3\"\n", "", 1),
    );
    let names = drawn(&of_case);
    assert!(!names.contains(&"pressure-viscosity factor of the friction"));
    assert!(names.contains(&"fall of the limiting shear"));
    let held = of_case["uncertainty"]["held"].as_array().unwrap();
    assert!(held.contains(&Value::from("pressure-viscosity factor of the friction")));
    let said = warned(&of_case, "W442");
    assert!(
        said.contains("lubricant.pressure_viscosity_factor, lubricant.density of the case replaces the value of oil.toml"),
        "{said}"
    );

    let calibrated = "\n[calibration]\neyring_stress = { value = \"5 MPa\", low = \"4.5 MPa\", high = \"5.6 MPa\" }\n";
    let of_rig = at_medians(&bench, &case("", calibrated));
    assert_eq!(constant(&of_rig, "eyring_stress_pa"), 5e6);
    assert_eq!(constant(&of_rig, "limiting_shear"), 0.035);
    let said = warned(&of_rig, "W442");
    assert!(
        said.contains("calibration.eyring_stress of the case"),
        "{said}"
    );

    // The oil of the file is enough for a case.
    let own: String = E_DRIVE
        .lines()
        .filter(|line| {
            !["viscosity", "density", "base_oil"]
                .iter()
                .any(|key| line.starts_with(key))
        })
        .map(|line| format!("{line}\n"))
        .collect();
    let own = own.replacen("[lubricant]\n", "[lubricant]\noil_file = \"oil.toml\"\n", 1);
    let of_file = at_medians(&bench, &own);
    assert_eq!(
        of_file["summary"]["loss_w"],
        plain["summary"]["loss_at_medians_w"]
    );

    // An oil file whose family was assumed is enough as well, and the law of its fit is listed.
    let file = fs::read_to_string(bench.path("oil.toml")).unwrap();
    assert!(file.contains("base_oil = "), "{file}");
    bench.write(
        "oil.toml",
        file.replacen("base_oil = ", "assume_base_oil = ", 1),
    );
    let of_assumed = at_medians(&bench, &own);
    assert_eq!(
        of_assumed["summary"]["loss_w"],
        plain["summary"]["loss_at_medians_w"]
    );
    let defaults = of_assumed["defaults"].to_string();
    for key in ["lubricant.base_oil", "model.film_pressure_law"] {
        assert!(defaults.contains(key), "{key}: {defaults}");
    }
}

#[test]
fn an_oil_file_is_used_beyond_its_curves_with_a_warning_and_a_larger_error() {
    let bench = bench();
    let widths = ["120", "80"].map(|highest| {
        let file = OIL_FILE.replace(
            "\"40 °C\", \"120 °C\"",
            &format!("\"40 °C\", \"{highest} °C\""),
        );
        bench.write("oil.toml", file.replace("80 °C", "60 °C"));
        let found = result(&bench, &case("", ""));
        let sd = found["uncertainty"]["loss"]["parts"]
            .as_array()
            .unwrap()
            .iter();
        let mut law = sd.filter(|part| part["name"] == "error of the film law");
        let sd = law.next().unwrap()["sd_ln"].as_f64().unwrap();
        (sd, warned(&found, "W443"))
    });
    let [(within, silent), (beyond, said)] = widths;
    assert!(!silent.contains("°C") && said.contains("measured at 40 to 60 °C, the flanks are at 90 °C: the film friction is sampled with an error of 8 %"), "{said}");
    // 2 % and, 30 K beyond, 7.8 % of the film friction.
    assert!(
        (beyond / within / 3.88 - 1.0).abs() < 0.05,
        "{within} {beyond}"
    );
    bench.write(
        "oil.toml",
        OIL_FILE.replace("0.76", "2.2").replace("309.0", "80.0"),
    );
    let said = warned(&result(&bench, &case("", "")), "W443");
    assert!(
        said.contains("residuals are 1.5 times the stated errors: the film friction is sampled with an error of 12 %"),
        "{said}"
    );
    assert!(said.contains("do not decide the law of pressure"), "{said}");
}

#[test]
fn an_undecided_law_of_pressure_is_in_the_interval() {
    let bench = bench();
    let interval = |result: &Value| {
        let interval = &result["uncertainty"]["loss"]["quantiles_w"];
        [0, 1].map(|k| interval[k].as_f64().unwrap())
    };
    let first = OIL_FILE.replace("309.0", "78.2");
    let (_, table) = first.split_once("[film_friction]").unwrap();
    let other = table.replace("barus", "roelands").replace(
        "other_law = 78.2, this_law = 78.0",
        "other_law = 78.0, this_law = 78.2",
    );
    bench.write("oil.toml", format!("{first}\n[other_law]{other}"));
    let both = result(&bench, &case("", ""));
    let said = warned(&both, "W443");
    assert!(
        said.contains(
            "the run has barus, the interval has roelands as well, with a probability of 48 %"
        ),
        "{said}"
    );
    // The Roelands viscosity with the same constants shears more easily.
    let alone = ["barus", "roelands"].map(|law| {
        let stated = format!("\n[model]\nfilm_pressure_law = \"{law}\"\n");
        let text = if E_DRIVE.contains("[model]\n") {
            case("", "").replacen("[model]\n", &stated, 1)
        } else {
            case("", &stated)
        };
        let found = result(&bench, &text);
        let said = warned(&found, "W443");
        assert!(!said.contains("the interval has"), "{said}");
        found
    });
    let loss = |result: &Value| result["summary"]["loss_at_medians_w"].as_f64().unwrap();
    assert_eq!(loss(&both), loss(&alone[0]));
    assert!(loss(&alone[1]) < 0.95 * loss(&alone[0]));
    let [own, other] = [&alone[0], &alone[1]].map(interval);
    let [low, high] = interval(&both);
    // Nearly half of the draws have either law: the ends lie near the outer ends of both.
    assert!(
        low < other[0].midpoint(own[0]) && low > other[0],
        "{low} {own:?} {other:?}"
    );
    assert!(
        high > own[1].midpoint(other[1]) && high < own[1],
        "{high} {own:?} {other:?}"
    );
    let parts = both["uncertainty"]["loss"]["parts"].as_array().unwrap();
    assert!(
        parts
            .iter()
            .any(|part| part["name"] == "law of pressure of the film")
    );
}

#[test]
fn the_error_of_a_temperature_is_drawn_where_the_case_states_it() {
    let bench = bench();
    let stated = E_DRIVE.replacen(
        "[operation]\n",
        "[operation]\ntemperature_deviation = \"10 K\"\n",
        1,
    );
    let plain = result(&bench, E_DRIVE);
    let (wide, page) = with_page(&bench, &stated);
    assert!(!drawn(&plain).contains(&"error of the temperature"));
    let part = |result: &Value| {
        let parts = result["uncertainty"]["loss"]["parts"]
            .as_array()
            .unwrap()
            .clone();
        let mut own = parts
            .into_iter()
            .filter(|part| part["name"] == "error of the temperature");
        own.next().map(|part| width(&part["quantiles_w"]))
    };
    // The ends are runs at the ends of the temperature, 16.4 K to either side.
    let at = |celsius: &str| {
        let text = E_DRIVE.replacen("\"90 °C\"", celsius, 1);
        at_medians(&bench, &text)["summary"]["loss_w"]
            .as_f64()
            .unwrap()
    };
    let found = part(&wide).unwrap();
    let expected = (at("\"73.55 °C\"") / at("\"106.45 °C\"")).ln().abs();
    // The surface of the draws misses single losses of this case of two positions by more than a percent.
    assert!((found - expected).abs() < 0.015, "{found} {expected}");
    assert_eq!(part(&plain), None);
    // A thermocouple narrows it; the report has the three measurements that narrow the interval most.
    let rows = |result: &Value| {
        result["uncertainty"]["evidence"]
            .as_array()
            .unwrap()
            .clone()
    };
    let keys: Vec<Value> = rows(&wide)
        .into_iter()
        .map(|row| row["key"].clone())
        .collect();
    assert!(keys.contains(&Value::from("thermocouple")), "{keys:?}");
    assert!(rows(&plain).iter().all(|row| row["key"] != "thermocouple"));
    let first = rows(&wide)[0]["measurement"].clone();
    assert!(
        page.contains("What would narrow the interval most")
            && page.contains(first.as_str().unwrap())
    );
    bench.write("run.toml", stated.replace("10 K", "10 °C"));
    bench.run(&["run", "run.toml", "--no-output"]).refused(
        2,
        "E204",
        &["temperature_deviation", "accepted: K"],
    );
    bench.write("run.toml", stated);
    let paper = ["run", "run.toml", "--no-output", "--formulation", "paper"];
    bench
        .run(&paper)
        .refused(2, "E205", &["temperature_deviation: widens an interval"]);
}

#[test]
fn the_loss_at_pressures_beyond_the_curves_is_printed() {
    let bench = bench();
    let watts = ["0.9 GPa", "0.01 GPa"].map(|most| {
        bench.write("oil.toml", OIL_FILE.replace("1.19 GPa", most));
        let found = result(&bench, &case("", ""));
        let said = warned(&found, "W443");
        let words = said.split_once(" W of the loss come from pressures above the tested");
        let watts = words.and_then(|(before, _)| before.parse::<f64>().ok());
        (watts.unwrap_or_else(|| panic!("{said}")), found)
    });
    let [(some, _), (all, found)] = watts;
    // All pressures are above the second one: the whole friction of film and lubricated asperities.
    let [film, asperities] =
        ["film_w", "lubricated_asperity_w"].map(|key| found["summary"][key].as_f64().unwrap());
    assert!((all / (film + asperities) - 1.0).abs() < 0.01, "{all}");
    assert!(some > 0.05 * all && some < 0.9 * all, "{some} {all}");
}

#[test]
fn oil_files_that_do_not_belong_to_the_case_are_refused() {
    let bench = bench();
    let refused = |code: &str, says: &[&str], more: &[&str]| {
        let said = bench.run(&[&["run", "case.toml", "--no-output"], more].concat());
        said.refused(2, code, says);
    };
    refused(
        "E205",
        &["model.film_pressure_law: is not the law of pressure"],
        &["--set", "model.film_pressure_law=roelands"],
    );
    refused(
        "E205",
        &["lubricant.oil_file", "needs a shear stress"][..1],
        &[
            "--set",
            "model.film_friction=xu",
            "--set",
            "model.load_share=lambda-star",
        ],
    );
    refused(
        "E205",
        &["lubricant.oil_file: belongs to the corrected formulation"],
        &["--set", "formulation=paper"],
    );
    refused(
        "E103",
        &["nothere.toml: cannot be opened", "lubricant.oil_file"],
        &["--set", "lubricant.oil_file=nothere.toml"],
    );
    for (from, to, code, says) in [
        (
            "asperity-oil-1",
            "asperity-oil-2",
            "E204",
            "oil.toml:1: schema: unknown choice",
        ),
        (
            "high = 0.98",
            "high = 0.94",
            "E205",
            "oil.toml:13: film_friction.pressure_viscosity_factor: needs 0 < low < high",
        ),
        (
            "value = -0.66",
            "value = 1.66",
            "E205",
            "oil.toml:14: film_friction.correlations: contradict each other",
        ),
        (
            "source = \"curves.csv\"",
            "",
            "E204",
            "missing key \"source\"",
        ),
        (
            "temperatures",
            "temperature",
            "E203",
            "Did you mean \"temperatures\"?",
        ),
        ("[film_friction]", "film_friction", "E202", "oil.toml:8"),
    ] {
        assert!(OIL_FILE.contains(from), "{from}");
        bench.write("oil.toml", OIL_FILE.replacen(from, to, 1));
        refused(code, &[says], &[]);
    }
    bench.write("oil.toml", E_DRIVE);
    refused("E203", &["oil.toml:3: unknown key \"gears\""], &[]);
}

#[test]
fn a_fit_writes_an_oil_file_that_fits_and_cases_read() {
    let bench = bench();
    let curves = root().join("crates/calibration/tests/golden/traction_e_fluid.csv");
    fs::copy(curves, bench.path("curves.csv")).unwrap();
    let fit = |oil: &str, folder: &str| {
        let errors = ["--point-sd", "2.5 %", "--point-floor", "0.001"];
        let arguments = ["oil", "fit", "curves.csv", "--oil", oil, "-o", folder];
        bench.run(&[&arguments[..], &errors].concat()).well();
        fs::read_to_string(bench.path(folder).join("oil.toml")).unwrap()
    };
    let first = fit("family.toml", "first");
    bench.write("oil.toml", &first);
    // The file states the oil, and the fit starts at its family: no constant counts twice.
    assert_eq!(fit("oil.toml", "second"), first);
    assert_eq!(fit("case.toml", "third"), first);
    let found = at_medians(&bench, &case("", ""));
    let stress = json(&bench, "first/oil_fit.json")["constants"][0]["value"].clone();
    let stress = 1e6 * stress.as_f64().unwrap();
    assert!((constant(&found, "eyring_stress_pa") / stress - 1.0).abs() < 1e-3);
    // Traction by the fitted constants, from the file and from a case that names it.
    let traction = |oil: &str| {
        bench
            .run(&["oil", "traction", oil, "-o", "traction"])
            .well();
        let table = bench.path("traction/traction_over_slide_to_roll.csv");
        fs::read_to_string(table).unwrap()
    };
    assert_eq!(traction("oil.toml"), traction("case.toml"));
    assert_ne!(traction("oil.toml"), traction("family.toml"));
}

/// ln of the ratio of the ends of an interval.
fn width(interval: &Value) -> f64 {
    let [low, high] = [0, 1].map(|k| interval[k].as_f64().unwrap());
    (high / low).ln()
}

/// Column of the first row of a table that is not at rest.
fn cell(bench: &Bench, file: &str, name: &str) -> f64 {
    let text = fs::read_to_string(bench.path(file)).unwrap();
    let mut lines = text.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let place = lines.next().unwrap().iter().position(|head| *head == name);
    let values = lines.map(|row| row[place.unwrap()].parse().unwrap());
    values.into_iter().find(|value: &f64| *value > 0.0).unwrap()
}

#[test]
fn the_interval_of_every_command_is_drawn_from_the_oil_file() {
    let bench = bench();
    bench.write(
        "cycle.csv",
        "time_s,torque_nm,speed_rpm\n0,145,9000\n1,145,9000\n2,145,9000\n",
    );
    let [family, fitted] = ["family", "case"].map(|name| {
        let case = format!("{name}.toml");
        let study = format!(
            "case = \"{case}\"\n[[axis]]\nkey = \"operation.torque\"\nfrom = \"145 N m\"\nto = \"150 N m\"\ncount = 2\n"
        );
        bench.write("study.toml", study);
        let map = format!("{name}-map");
        let of = |line: &str, file: &str| {
            let folder = format!("{name}-{}", line.split(' ').next().unwrap());
            let line = line.replace("CASE", &case).replace("MAP", &map);
            let words: Vec<&str> = line.split(' ').collect();
            bench.run(&[&words[..], &["-o", &folder, "-q"]].concat()).well();
            format!("{folder}/{file}")
        };
        let run = json(&bench, &of("run CASE", "result.json"));
        let map = of("map CASE --torque 145 --speed 9000", "map.csv");
        let cycle = json(&bench, &of("cycle MAP cycle.csv", "cycle.json"));
        let compare = of("compare CASE --finish a=pinion.csv --finish b=wheel.csv", "compare.csv");
        bench.run(&["sweep", "run", "study.toml", "-q", "--parts", &format!("{name}-parts")]).well();
        let sweep = of(&format!("sweep merge study.toml --parts {name}-parts"), "sweep.csv");
        let sensitivity = json(&bench, &of("sensitivity CASE", "sensitivity.json"));
        let of_table = |file: &str| {
            (cell(&bench, file, "loss_p95_w") / cell(&bench, file, "loss_p05_w")).ln()
        };
        let widths = [
            ("run", width(&run["uncertainty"]["loss"]["quantiles_w"])),
            ("map", of_table(&map)),
            ("cycle", width(&cycle["finishes"][0]["lost_quantiles_wh"])),
            ("compare", of_table(&compare)),
        ];
        let both = |of: &Value| {
            let keys = ["loss_w", "loss_at_medians_w"];
            keys.map(|key| of[key].as_f64().unwrap())
        };
        let losses = [
            both(&run["summary"]),
            both(&sensitivity),
            [cell(&bench, &sweep, "loss_w"); 2],
        ];
        (widths, losses)
    });
    for ((command, family), (_, fitted)) in family.0.into_iter().zip(fitted.0) {
        assert!(fitted < 0.6 * family, "{command}: {family} {fitted}");
    }
    // A sweep without columns of an interval draws none; its runs use the fitted constants.
    let [[run, at_medians], [sensitivity, its_medians], [sweep, _]] = fitted.1;
    assert_eq!([run, at_medians], [sensitivity, its_medians]);
    assert_eq!(at_medians, sweep);
    assert!(
        family
            .1
            .iter()
            .zip(fitted.1)
            .all(|(family, fitted)| *family != fitted)
    );
    // A calibration on a rig begins at the fitted constants, with their band as its prior.
    let of = |name: &str| {
        let case = asperity::case::load(&bench.path(name), None).unwrap();
        Parameter::all(&case).unwrap().pop().unwrap()
    };
    let (family, fitted) = (of("family.toml"), of("case.toml"));
    assert_eq!(
        (fitted.name, fitted.default.value),
        (CalibratedName::EyringStress, 4.8e6)
    );
    assert!((fitted.prior / ((5.2f64 / 4.4).ln() / 3.92) - 1.0).abs() < 1e-3);
    assert_eq!(family.prior, 0.4);
}
