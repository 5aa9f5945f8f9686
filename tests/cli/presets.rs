//! Gears, oils and steels of the library: each runs, by its name alone.

use asperity::core::presets::steel;
use asperity::quantity::Pressure;
use serde_json::Value;

use crate::bench::{Bench, E_DRIVE};

fn names(list: &Value) -> Vec<String> {
    let names = list.as_array().unwrap().iter();
    names
        .map(|one| one["name"].as_str().unwrap().to_owned())
        .collect()
}

#[test]
fn every_gear_pair_of_the_library_runs_as_its_demo_writes_it() {
    let bench = Bench::new();
    let listed = bench.run(&["list", "gears", "--json"]).well().json();
    let gears = names(&listed["gears"]);
    assert!(gears.len() >= 14, "{gears:?}");
    let table = bench.run(&["list", "gears"]).well().out;
    for name in &gears {
        assert!(table.contains(name.as_str()));
        bench.run(&["demo", "--gears", name]).well();
        let case = format!("{name}/case.toml");
        let run = ["run", &case, "--no-output", "--no-band", "--json"];
        let few = ["--set", "model.positions=4", "--set", "model.offsets=2"];
        let run = bench.run(&[&run[..], &few].concat()).well().json();
        let summary = &run["summary"];
        let efficiency = summary["efficiency"].as_f64().unwrap();
        assert!((0.95..1.0).contains(&efficiency), "{name}: {efficiency}");
        let friction = summary["mu_equivalent"].as_f64().unwrap();
        assert!((0.01..0.12).contains(&friction), "{name}: {friction}");
        // Each number of the gears and of the operation with its certainty and source.
        let text = std::fs::read_to_string(bench.path(&case)).unwrap();
        let numbers = text.split("[gears]").nth(1).unwrap();
        let lines = numbers
            .lines()
            .filter(|line| line.contains(" = ") && !line.starts_with('#'));
        let sourced = lines.filter(|line| {
            let comment = line.split("  # ").nth(1).unwrap_or_default();
            ["A, ", "B, ", "C, ", "assumed, "]
                .iter()
                .any(|letter| comment.starts_with(letter))
        });
        assert!(sourced.count() >= 10, "{name}: {text}");
        assert!(text.contains("SYNTHETIC"));
    }
}

#[test]
fn finishes_of_a_preset_can_be_compared() {
    let bench = Bench::new();
    bench.run(&["demo", "--gears", "FZG-C", "mine"]).well();
    let finish = |name: &str| format!("{name}=mine/{name}_pinion.csv,mine/{name}_wheel.csv");
    let (ground, fine) = (finish("ground"), finish("superfinished"));
    let arguments = [
        "compare",
        "mine/case.toml",
        "--finish",
        &ground,
        "--finish",
        &fine,
        "--offsets",
        "2",
        "--set",
        "model.positions=4",
        "--json",
    ];
    let said = bench.run(&arguments).well().json();
    let loss = |i: usize| said["finishes"][i]["loss_w"].as_f64();
    let (Some(rough), Some(smooth)) = (loss(0), loss(1)) else {
        panic!("{said:#}");
    };
    assert!(smooth < rough, "{smooth} {rough}");
}

/// The e-drive with these lines as its material, run.
fn with_material(bench: &Bench, material: &str) -> crate::bench::Said {
    let (head, tail) = E_DRIVE.split_once("[material.pinion]").unwrap();
    let (_, rest) = tail.split_once("\n[").unwrap();
    bench.write(
        "case.toml",
        format!("{head}[material.pinion]\n{material}\n\n[{rest}"),
    );
    bench.run(&["run", "case.toml", "--no-output", "--no-band", "--json"])
}

fn default<'a>(run: &'a Value, key: &str) -> &'a Value {
    let defaults = run["defaults"].as_array().unwrap().iter();
    let found = defaults.into_iter().find(|one| one["key"] == key);
    found.unwrap_or_else(|| panic!("{key} is no default"))
}

#[test]
fn every_steel_of_the_library_runs_the_case_by_its_name() {
    let bench = Bench::new();
    bench.write_flanks();
    let listed = bench.run(&["list", "steels", "--json"]).well().json();
    let steels = names(&listed["steels"]);
    assert!(steels.len() >= 6);
    let table = bench.run(&["list", "steels"]).well().out;
    for name in &steels {
        assert!(table.contains(name.as_str()));
        let density = if name == "powder-metal" {
            "\ndensity = \"7.1 g/cm3\""
        } else {
            ""
        };
        let run = with_material(&bench, &format!("steel = \"{name}\"{density}"))
            .well()
            .json();
        let efficiency = run["summary"]["efficiency"].as_f64().unwrap();
        assert!((0.97..1.0).contains(&efficiency), "{name}: {efficiency}");
        let source = default(&run, "material.pinion.young")["source"]
            .as_str()
            .unwrap();
        assert!(
            source.contains(name.as_str()) || source.contains("density"),
            "{source}"
        );
        let one = bench.run(&["list", "steels", name]).well().out;
        assert!(
            one.contains("sources") && one.contains("Certainty"),
            "{one}"
        );
    }
}

#[test]
fn a_steel_as_a_value_has_the_constants_of_a_case() {
    let bench = Bench::new();
    bench.write_flanks();
    let run = with_material(&bench, "steel = \"18CrNiMo7-6\"")
        .well()
        .json();
    let of_case = |key: &str| -> Pressure {
        let value = &default(&run, &format!("material.pinion.{key}"))["value"];
        value.as_str().unwrap().trim_matches('"').parse().unwrap()
    };
    let material = steel("18CrNiMo7-6").unwrap().material().unwrap();
    // 60 HRC lies above the steels of the relation.
    assert_eq!(material.outside.len(), 1);
    assert_eq!(of_case("young"), material.value.young);
    let limit = of_case("elastic_limit").si() / material.value.elastic_limit.si();
    assert!((limit - 1.0).abs() < 1e-5, "{limit}");
}

#[test]
fn a_hardness_sets_the_flow_pressure_and_what_is_given_wins() {
    let bench = Bench::new();
    bench.write_flanks();
    let soft = with_material(&bench, "steel = \"18CrNiMo7-6\"\nhardness = \"600 HV\"")
        .well()
        .json();
    let flow = default(&soft, "material.pinion.flow_pressure");
    assert_eq!(flow["value"], "\"5.88399 GPa\"");
    assert!(flow["source"].as_str().unwrap().contains("600 HV"));
    // 2.876 · 600 − 90.7
    assert_eq!(
        default(&soft, "material.pinion.elastic_limit")["value"],
        "\"1.6349 GPa\""
    );
    let given = with_material(
        &bench,
        "steel = \"16MnCr5\"\nyoung = \"200 GPa\"\nflow_pressure = \"7 GPa\"",
    )
    .well()
    .json();
    let keys = given["defaults"].as_array().unwrap();
    for key in ["material.pinion.young", "material.pinion.flow_pressure"] {
        assert!(keys.iter().all(|one| one["key"] != key), "{key}");
    }
    assert_eq!(default(&given, "material.pinion.poisson")["value"], "0.28");
}

#[test]
fn sintered_steel_is_softer_the_lighter_it_is_and_warns_outside_of_its_data() {
    let bench = Bench::new();
    bench.write_flanks();
    let powder = |density: &str| {
        with_material(
            &bench,
            &format!("steel = \"powder-metal\"\ndensity = \"{density} g/cm3\""),
        )
    };
    let run = powder("7.1").well().json();
    let young = default(&run, "material.pinion.young")["value"]
        .as_str()
        .unwrap()
        .to_owned();
    // 206.74 GPa·(7.1/7.83)^3.39 = 148.4 GPa; the standard has 150 GPa.
    assert!(young.starts_with("\"148.3"), "{young}");
    let codes = |run: &Value| {
        let warnings = run["warnings"].as_array().unwrap().iter();
        let codes = warnings.map(|one| one["code"].as_str().unwrap().to_owned());
        codes.collect::<Vec<_>>()
    };
    assert!(!codes(&run).contains(&"W428".to_owned()));
    let light = powder("6.6").well().json();
    assert_eq!(
        codes(&light).iter().filter(|code| *code == "W428").count(),
        1
    );
    let text = bench
        .run(&["run", "case.toml", "--no-output", "--no-band", "--notes"])
        .out;
    assert!(text.contains("W428 density"), "{text}");
    powder("7.9").refused_json("E209", "6264 and 7830");
    with_material(&bench, "steel = \"powder-metal\"").refused_json("E205", "needs density");
}

#[test]
fn a_wrong_name_is_answered_with_the_nearest_one() {
    let bench = Bench::new();
    bench.write_flanks();
    with_material(&bench, "steel = \"18CrNiMo\"")
        .refused_json("E220", "Did you mean \"18CrNiMo7-6\"");
    with_material(&bench, "steel = \"x\"").refused_json("E220", "no such steel");
    with_material(&bench, "hardness = \"60\"").refused_json("E204", "60 HRC");
    with_material(&bench, "hardness = \"75 HRC\"").refused_json("E209", "20 to 68 HRC");
    for (arguments, nearest) in [
        (vec!["list", "gears", "fzgc"], "fzg-c"),
        (vec!["list", "steels", "16mncr"], "16MnCr5"),
        (vec!["list", "oils", "m-100"], "m100"),
        (vec!["demo", "--gears", "vw-id-3-1"], "vw-id3-1"),
    ] {
        let meant = format!("Did you mean \"{nearest}\"?");
        bench
            .run(&arguments)
            .refused(2, "E220", &[&meant, "It has: "]);
    }
}

#[test]
fn an_oil_of_which_the_case_states_properties_is_warned_about() {
    let bench = Bench::new();
    bench.write_flanks();
    let lines = E_DRIVE.lines().map(|line| match line {
        "[lubricant]" => "[lubricant]\noil = \"m100\"\n".to_owned(),
        line => format!("{line}\n"),
    });
    let both: String = lines.collect();
    bench.write("case.toml", &both);
    let said = bench.run(&["check", "case.toml"]);
    let text = said.well().unwrapped();
    assert!(
        text.contains("W442 lubricant.base_oil, lubricant.density, lubricant.viscosity of the case replace those of the oil m100"),
        "{text}"
    );
    // Also without the viscosity, of which the density of the case is left.
    let lines = both.lines().filter(|line| {
        !["viscosity", "base_oil"]
            .iter()
            .any(|key| line.starts_with(key))
    });
    bench.write(
        "case.toml",
        lines.map(|line| format!("{line}\n")).collect::<String>(),
    );
    let said = bench.run(&["check", "case.toml"]);
    let text = said.well().unwrapped();
    assert!(
        text.contains("W442 lubricant.density of the case replaces that of the oil m100"),
        "{text}"
    );
}

#[test]
fn an_oil_named_over_a_case_replaces_its_oil_on_every_face() {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("case.toml", E_DRIVE);
    let lubricant = "[lubricant]\noil = \"m100\"\n\n[";
    let (before, after) = E_DRIVE.split_once("[lubricant]").unwrap();
    let (_, rest) = after.split_once("\n[").unwrap();
    bench.write("own.toml", format!("{before}{lubricant}{rest}"));
    let fast = [
        "--set",
        "model.positions=4",
        "--set",
        "model.offsets=2",
        "--json",
    ];
    let loss = |case: &str, more: &[&str]| {
        let arguments = [&["run", case][..], &fast, more].concat();
        bench.run(&arguments).well().json()["summary"]["loss_w"]
            .as_f64()
            .unwrap()
    };
    let plain = loss("case.toml", &[]);
    let own = loss("own.toml", &[]);
    let set = loss("case.toml", &["--set", "lubricant.oil=m100"]);
    assert_eq!(set, own);
    assert!((own / plain - 1.0).abs() > 0.01, "{own} {plain}");
    // Other keys set beside it belong to the new oil, in any order.
    let thicker = ["--set", "lubricant.pressure_viscosity=20 1/GPa"];
    let oil = ["--set", "lubricant.oil=m100"];
    let both = [[thicker, oil].concat(), [oil, thicker].concat()];
    let [first, second] = both.map(|keys| loss("case.toml", &keys));
    assert_eq!(first, second);
    assert!(first != set);
    // The first screen says what went; an oil in the file itself replaces nothing.
    let line =
        "oil m100 replaces lubricant.base_oil, lubricant.density, lubricant.viscosity of the case";
    let said = bench.run(&["run", "case.toml", "--set", "lubricant.oil=m100"]);
    let text = said.well().unwrapped();
    let words = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(words(&text).contains(line), "{text}");
    let said = bench.run(&["run", "own.toml"]).well().unwrapped();
    assert!(!said.contains("replaces"), "{said}");
    // The variant is the same case.
    let variant = [
        &[
            "compare",
            "case.toml",
            "--variant",
            "other: lubricant.oil=m100",
            "--variant",
            "as is",
        ][..],
        &fast,
    ];
    let found = bench.run(&variant.concat()).well().json();
    assert_eq!(found["finishes"][0]["loss_w"].as_f64().unwrap(), own);
}

#[test]
fn an_oil_shows_every_number_with_its_certainty() {
    let bench = Bench::new();
    let one = bench.run(&["list", "oils", "N100"]).well().out;
    assert!(
        one.contains("pressure_viscosity") && one.contains(" C "),
        "{one}"
    );
    assert!(!one.contains("m100 "), "{one}");
    let json = bench.run(&["list", "oils", "n100", "--json"]).well().json();
    assert_eq!(json["oils"][0]["certainty"]["viscosity"], "A");
}

#[test]
fn a_demo_does_not_write_over_a_folder() {
    let bench = Bench::new();
    bench.run(&["demo", "--gears", "sew-1"]).well();
    bench
        .run(&["demo", "--gears", "sew-1"])
        .refused(2, "E401", &["exists already"]);
}
