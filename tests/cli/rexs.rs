//! Cases from REXS gearbox files.

use std::fs;

use crate::bench::{Bench, root, trace};

fn bench() -> Bench {
    let bench = Bench::new();
    for name in ["chain.rexs", "planetary.rexs"] {
        let file = root().join("crates/rexs/tests/gearboxes").join(name);
        bench.write(name, fs::read_to_string(file).unwrap());
    }
    bench.write("pinion.csv", trace("x_um,z_um", 6000));
    bench.write("wheel.csv", trace("x_um,z_um", 6000));
    bench
}

const FLANKS: [&str; 4] = ["--pinion", "pinion.csv", "--wheel", "wheel.csv"];

#[test]
fn stages_are_listed() {
    let bench = bench();
    let said = bench.run(&["case", "from-rexs", "chain.rexs"]).well().out;
    assert!(
        said.contains("stage 2: Second stage, 19/47 teeth"),
        "{said}"
    );
    assert!(said.contains("load case 2: 60 % of the time"), "{said}");
    assert!(
        said.contains("stage 3: Bevel, bevel_stage, not modelled"),
        "{said}"
    );
    let listed = bench.run(&["case", "from-rexs", "planetary.rexs", "--json"]);
    let listed = listed.well().json();
    assert_eq!(listed["stages"][0]["kind"], "planetary");
    assert_eq!(
        listed["stages"][0]["teeth"],
        serde_json::json!([27, 24, 75])
    );
}

#[test]
fn a_stage_runs_at_the_centre_distance_of_its_file() {
    let bench = bench();
    for (stage, distance) in [("1", None), ("2", Some(100.0))] {
        let mut arguments = vec![
            "case",
            "from-rexs",
            "chain.rexs",
            "--stage",
            stage,
            "-o",
            "case.toml",
        ];
        arguments.extend(FLANKS);
        let said = bench.run(&arguments);
        assert_eq!(said.status, 0, "{said:?}");
        assert!(
            said.out.contains("next: asperity check case.toml"),
            "{}",
            said.out
        );
        assert!(
            said.err.contains("the base oil is assumed to be mineral"),
            "{}",
            said.err
        );
        let run = [
            "run",
            "case.toml",
            "--json",
            "--no-output",
            "--set",
            "model.offsets=1",
        ];
        let result = bench.run(&run).well().json();
        let found = result["gears"]["centre_distance"].as_str().unwrap();
        let found: f64 = found.trim_end_matches(" mm").parse().unwrap();
        // The shifts of the first stage give another distance than its file states, which is said.
        let stated = distance.unwrap_or(63.3497);
        assert!((found - stated).abs() < 1e-4, "{found}");
    }
    let mut arguments = vec!["case", "from-rexs", "planetary.rexs", "-o", "set.toml"];
    arguments.extend(FLANKS);
    assert_eq!(bench.run(&arguments).status, 0);
    let written = fs::read_to_string(bench.path("set.toml")).unwrap();
    assert!(
        written.contains("default: the file has no lubricant"),
        "{written}"
    );
    bench.run(&["check", "set.toml"]).well();
}

#[test]
fn without_flanks_the_case_says_what_is_missing() {
    let bench = bench();
    let case = bench
        .run(&["case", "from-rexs", "chain.rexs", "--stage", "2"])
        .out;
    assert!(case.contains("# pinion.file = \"pinion.csv\""), "{case}");
    bench.write("case.toml", &case);
    bench
        .run(&["check", "case.toml"])
        .refused(2, "E204", &["pinion"]);
}

#[test]
fn what_cannot_be_used_is_refused() {
    let bench = bench();
    bench.write("broken.rexs", "<model version=\"1.4\">");
    bench.run(&["case", "from-rexs", "broken.rexs"]).refused(
        2,
        "E132",
        &["broken.rexs", "ends inside"],
    );
    bench
        .run(&["case", "from-rexs", "none.rexs"])
        .refused(2, "E103", &["none.rexs"]);
    for stage in ["3", "4"] {
        let arguments = ["case", "from-rexs", "chain.rexs", "--stage", stage];
        bench.run(&arguments).refused(2, "E133", &["stage"]);
    }
}

/// Every attribute of a version reaches the case with its source, and what does not is listed by component.
#[test]
fn each_version_gives_its_modifications_roughness_oil_and_tools() {
    use asperity_fixtures::gearbox::{VERSIONS, rexs};
    let bench = Bench::new();
    for (number, version) in VERSIONS.iter().enumerate() {
        let at_least = |other: &str| VERSIONS.iter().position(|v| *v == other).unwrap() <= number;
        bench.write("box.rexs", rexs(version));
        let listed = bench.run(&["case", "from-rexs", "box.rexs"]).well().out;
        assert!(listed.contains("23/57 teeth"), "{listed}");
        let arguments = [
            "case",
            "from-rexs",
            "box.rexs",
            "--stage",
            "1",
            "-o",
            "case.toml",
        ];
        assert_eq!(bench.run(&arguments).status, 0);
        let case = fs::read_to_string(bench.path("case.toml")).unwrap();
        let has = |line: &str, since: &str| {
            assert_eq!(
                case.contains(line),
                at_least(since),
                "{version}, {line}\n{case}"
            );
        };
        has("teeth = [23, 57]", "1.0");
        has("pinion.tip_chamfer = \"0.2 mm\"", "1.0");
        has("pinion.fillet_radius = 0.3", "1.0");
        // 1.35 of the tool, and 0.05 more from the shift that it generates.
        has("pinion.dedendum = 1.4", "1.3");
        assert!(
            at_least("1.3") || case.contains("pinion.dedendum = 1.35"),
            "{case}"
        );
        has(
            "wheel.tip_relief = { amount = \"20 um\", length = \"3.5 mm\" }",
            "1.2",
        );
        has(
            "wheel.root_relief = { amount = \"8 um\", length = \"2 mm\", power = 2 }",
            "1.2",
        );
        has("wheel.profile_crowning = \"3 um\"", "1.2");
        has("wheel.profile_slope = \"2 um\"", "1.2");
        has("wheel.crowning = \"5 um\"", "1.2");
        has("wheel.lead_slope = \"6 um\"", "1.2");
        has(
            "end_relief = { amount = \"12 um\", length = \"4 mm\" }",
            "1.2",
        );
        has("pinion.ra = \"0.4 um\"", "1.2");
        has("wheel.ra = \"0.5 um\"", "1.2");
        has("pinion.rz = \"3 um\"", "1.3");
        has(
            "base_oil = \"pao\"  # lubricant 54: lubricant_type_agma_925",
            "1.3",
        );
        assert!(
            at_least("1.3") || case.contains("assume_base_oil = \"pao\""),
            "{case}"
        );
        // 0.010326 mm2/N times 20 to the power 0.0507.
        has("pressure_viscosity = \"0.01201", "1.3");
        has("operating_viscosity is 32.5 mm2/s", "1.4");
        has("bulk_temperature = \"70 °C\"", "1.0");
        has("# profile_twist 207, 307: nothing", "1.2");
        has("# concept_bearing 51: nothing", "1.0");
        has("# cylindrical_gear 2: u_coordinate_on_shaft", "1.0");
        assert!(listed.contains("35 % of the time"), "{listed}");
        // The first version with the roughness, and the last.
        if *version == "1.2" || number + 1 == VERSIONS.len() {
            bench.run(&["check", "case.toml"]).well();
        }
    }
}

/// An oil whose viscosity is known at the operating temperature only is read as such.
#[test]
fn an_operating_viscosity_stands_alone() {
    let bench = Bench::new();
    let text = asperity_fixtures::gearbox::rexs("1.7");
    let text = text.replace("viscosity_at_40_degree_celsius", "custom_viscosity");
    bench.write("box.rexs", text);
    let case = bench
        .run(&["case", "from-rexs", "box.rexs", "--stage", "1"])
        .out;
    // 32.5 mm2/s times 860 kg/m3.
    let line = "dynamic_viscosity = \"27.95 mPa s\", temperature = \"70 °C\"";
    assert!(case.contains(line), "{case}");
}

/// A gearbox without its bevel stage: the relation of that stage is of another type.
fn without_bevels() -> String {
    let file = root().join("crates/rexs/tests/gearboxes/chain.rexs");
    let text = fs::read_to_string(file).unwrap();
    text.replace(
        "<relation id=\"3\" type=\"stage\">",
        "<relation id=\"3\" type=\"other\">",
    )
}

#[test]
fn all_stages_become_one_case() {
    let bench = bench();
    bench.write("box.rexs", without_bevels());
    let all = ["case", "from-rexs", "box.rexs", "--all", "-o", "box.toml"];
    let said = bench.run(&all);
    assert!(said.out.contains("wrote box.toml: all stages"), "{said:?}");
    assert!(said.err.contains("state surface.finish"), "{said:?}");
    let written = fs::read_to_string(bench.path("box.toml")).unwrap();
    assert_eq!(written.matches("# finish = ").count(), 1, "{written}");
    // The first pinion has an Ra, the other flanks are asked for once.
    let flanks = [
        "--set",
        "surface.finish=ground",
        "--set",
        "surface.pinion.ra=0.4 um",
    ];
    // A finish without a height is refused, with the key to state.
    let finish_alone = ["check", "box.toml", "--set", "surface.finish=ground"];
    let says = ["surface.finish: ", "surface.pinion.ra, such as \"0.4 um\""];
    bench.run(&finish_alone).refused(2, "E205", &says);
    let run = [
        "run",
        "box.toml",
        "--json",
        "--no-output",
        "--no-band",
        "--set",
        "model.positions=4",
        "--set",
        "model.offsets=1",
    ];
    let train = bench.run(&[&run[..], &flanks].concat()).well().json();
    assert_eq!(train["meshes"].as_array().unwrap().len(), 2);
    // The torque of the second stage is that of a case of its own.
    let of_stage = [
        "case",
        "from-rexs",
        "box.rexs",
        "--stage",
        "2",
        "-o",
        "two.toml",
    ];
    assert_eq!(bench.run(&of_stage).status, 0);
    let run = [
        "run",
        "two.toml",
        "--json",
        "--no-output",
        "--no-band",
        "--set",
        "model.positions=4",
        "--set",
        "model.offsets=1",
    ];
    let two = fs::read_to_string(bench.path("two.toml")).unwrap();
    let surface = "[surface]\nfinish = \"ground\"\npinion.ra = \"0.4 um\"";
    bench.write("two.toml", two.replace("[surface]", surface));
    let stage = bench.run(&run).well().json();
    let w = |value: &serde_json::Value| value.as_f64().unwrap();
    let [of_train, alone] = [&train["meshes"][1]["loss_w"], &stage["summary"]["loss_w"]].map(w);
    assert!((of_train / alone - 1.0).abs() < 1e-6, "{of_train} {alone}");
    // Bevel gears are refused, and a planetary set is a train of one stage.
    let all = ["case", "from-rexs", "chain.rexs", "--all"];
    bench.run(&all).refused(2, "E133", &["stage 3"]);
    let set = [
        "case",
        "from-rexs",
        "planetary.rexs",
        "--all",
        "-o",
        "set.toml",
    ];
    let arguments = [&set[..], &FLANKS].concat();
    assert_eq!(bench.run(&arguments).status, 0);
    bench.run(&["check", "set.toml"]).well();
}
