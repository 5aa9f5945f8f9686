//! Losses of the gearbox beside the mesh: what a case may state, and that every output says what it covers.

use crate::bench::{Bench, Said, root};

const SEAL: &str = r#"gearbox.seals=[{ shaft = "pinion", diameter = "40 mm" }]"#;
/// The bearing of MESH: 40/68 mm, 2 kN radial, 1 kN axial, at 10 mm²/s it loses 33.349 W at 3000 1/min.
const BEARING: &str = r#"{ shaft = "wheel", kind = "deep-groove-ball", bore = "40 mm", outside_diameter = "68 mm", radial = "2 kN", axial = "1 kN", static_rating = "11 kN", r1 = 4.3e-7, r2 = 1.7, s1 = 4.63e-3, s2 = 4.25, k_z = 3.1, k_rs = 6e-8, mu_bl = 0.12, mu_ehl = 0.04 }"#;

fn bearing(change: &[(&str, &str)]) -> String {
    let mut text = BEARING.to_owned();
    for (from, to) in change {
        assert!(text.contains(from), "{from}");
        text = text.replace(from, to);
    }
    format!("gearbox.bearings=[{text}]")
}

/// The superfinished e-drive, coarsely, with a command and settings.
fn coarse(bench: &Bench, command: &[&str], settings: &[&str]) -> Said {
    let case = root().join("fixtures/cases/e-drive-superfinished.toml");
    let mut arguments = vec![command[0], case.to_str().unwrap()];
    arguments.extend(&command[1..]);
    let fast = [
        "model.positions=4",
        "model.offsets=2",
        "model.load_share=lambda-star",
    ];
    for setting in fast.iter().chain(settings) {
        arguments.extend(["--set", setting]);
    }
    bench.run(&arguments)
}

fn run(settings: &[&str]) -> Said {
    let run = ["run", "--no-output", "--no-band", "--json"];
    coarse(&Bench::new(), &run, settings)
}

#[test]
fn a_case_without_a_gearbox_says_that_it_is_of_the_mesh() {
    let result = run(&[]).well().json();
    assert_eq!(result["summary"]["scope"], "mesh");
    assert!(result["gearbox"].is_null());
    assert!(result["summary"]["gearbox_efficiency"].is_null());
}

#[test]
fn parts_are_added_to_the_mesh_one_by_one_and_the_mesh_stays_as_it_is() {
    let mesh = run(&[]).well().json();
    let jet = r#"gearbox.jet={ flow = "2.5 l/min", speed = "0.4 m/s" }"#;
    let found = run(&[SEAL, &bearing(&[]), jet]).well().json();
    let of = |value: &serde_json::Value| value.as_f64().unwrap();
    assert_eq!(found["summary"]["scope"], "gearbox");
    for key in ["efficiency", "loss_w", "power_in_w"] {
        assert_eq!(found["summary"][key], mesh["summary"][key], "{key}");
    }
    let gearbox = &found["gearbox"];
    let parts = gearbox["parts"].as_array().unwrap();
    let names: Vec<_> = parts.iter().map(|part| &part["name"]).collect();
    assert_eq!(names, ["seal 1", "bearing 1", "oil jet"]);
    // 7.69e-6 · 40² · 9000 by hand.
    assert!((of(&parts[0]["loss_w"]) - 110.736).abs() < 1e-9);
    // ρ Q v_t (v_t + v_j) by hand: pitch radius a z₁/(z₁ + z₂), 845 kg/m³ is that of 15 °C, and at 90 °C less.
    let distance = 0.5 * 1.8e-3 * 91.0 / 23.4_f64.to_radians().cos();
    let v_t = 300.0 * std::f64::consts::PI * distance * 23.0 / 91.0;
    let density = of(&parts[2]["loss_w"]) / (2.5e-3 / 60.0 * v_t * (v_t + 0.4));
    assert!((760.0..830.0).contains(&density), "{density}");
    let sum: f64 = parts.iter().map(|part| of(&part["loss_w"])).sum();
    assert!((of(&gearbox["parts_w"]) - sum).abs() < 1e-9);
    let loss = of(&mesh["summary"]["loss_w"]) + sum;
    assert!((of(&gearbox["loss_w"]) - loss).abs() < 1e-9);
    let efficiency = 1.0 - loss / of(&mesh["summary"]["power_in_w"]);
    assert!((of(&gearbox["efficiency"]) - efficiency).abs() < 1e-12);
    assert_eq!(
        found["summary"]["gearbox_efficiency"],
        gearbox["efficiency"]
    );
    let tags = found["equations"].to_string();
    for tag in ["Seal-1", "Bearing-1", "Bearing-5", "Jet-1"] {
        assert!(tags.contains(tag), "{tag}");
    }
    assert!(
        found["references"]
            .to_string()
            .contains("as quoted in later papers")
    );
}

#[test]
fn a_bearing_turns_with_its_shaft_and_its_load_grows_only_where_that_is_said() {
    let loss = |change: &[(&str, &str)], torque: &str| {
        let found = run(&[&bearing(change), torque]).well().json();
        found["gearbox"]["parts"][0]["loss_w"].as_f64().unwrap()
    };
    let (whole, half) = ("operation.torque=145 N m", "operation.torque=72.5 N m");
    let wheel = loss(&[], whole);
    let pinion = loss(&[("\"wheel\"", "\"pinion\"")], whole);
    assert!(pinion > 2.5 * wheel, "{pinion} {wheel}");
    assert_eq!(loss(&[], half), wheel);
    let at = [("radial =", "at_torque = \"145 N m\", radial =")];
    assert_eq!(loss(&at, whole), wheel);
    let halved = [
        ("\"2 kN\"", "\"1 kN\""),
        ("axial = \"1 kN\"", "axial = \"0.5 kN\""),
    ];
    // The same load, once by the torque and once as written.
    assert!((loss(&at, half) / loss(&halved, whole) - 1.0).abs() < 1e-12);
}

#[test]
fn the_summary_names_both_efficiencies_and_whose_the_parts_are() {
    let bench = Bench::new();
    let text = coarse(&bench, &["run", "--no-output", "--notes"], &[SEAL]).well();
    let text = text.unwrapped();
    assert!(text.contains("efficiency (mesh only)"), "{text}");
    let line = text
        .lines()
        .find(|line| line.starts_with("efficiency (gearbox)"));
    assert!(line.is_some_and(|line| line.contains("..")), "{text}");
    let says =
        "in addition to the mesh 111 W, from the input and without an interval: seal 1\n  111 W";
    assert!(text.contains(says), "{text}");
    coarse(&bench, &["run", "-o", "out"], &[SEAL]).well();
    let page = std::fs::read_to_string(bench.path("out/report.html")).unwrap();
    for says in [
        "efficiency (gearbox)",
        "Besides the mesh, from the input",
        "without an uncertainty",
        "data-key=\"summary.scope\"",
    ] {
        assert!(page.contains(says), "{says}");
    }
}

#[test]
fn a_table_is_read_between_its_nodes_and_nowhere_else() {
    let bench = Bench::new();
    bench.write_flanks();
    let head = "speed_rpm,loss_torque_nm,torque_nm,temperature_c\n";
    let grid = "0,0.1,100,80\n10000,0.3,100,80\n0,0.2,200,80\n10000,0.6,200,80\n0,0.1,100,100\n10000,0.3,100,100\n0,0.2,200,100\n10000,0.6,200,100\n";
    bench.write("other.csv", format!("{head}{grid}"));
    bench.write("case.toml", crate::bench::E_DRIVE);
    let with = |settings: &[&str]| {
        let mut arguments = vec!["run", "case.toml", "--no-output", "--no-band", "--json"];
        let fast = [
            "model.load_share=lambda-star",
            "gearbox.loss_table=other.csv",
        ];
        for setting in fast.iter().chain(settings) {
            arguments.extend(["--set", setting]);
        }
        bench.run(&arguments)
    };
    let at = [
        "operation.torque=150 N m",
        "operation.speed=5000 1/min",
        "operation.bulk_temperature=90 °C",
    ];
    let found = with(&at).well().json();
    let torque = found["gearbox"]["parts"][0]["torque_nm"].as_f64().unwrap();
    assert!((torque - 0.3).abs() < 1e-12, "{torque}");
    // Bulk temperatures are those of the flanks; the table stays in its oil.
    let bulk = r#"operation.bulk={ law = "iso", lubrication = "jet" }"#;
    let found = with(&[&at[..], &["operation.oil_temperature=100 °C", bulk]].concat());
    let found = found.well().json();
    assert!(found["bulk"]["bulk_c"].as_f64().unwrap() > 101.0);
    assert_eq!(
        found["gearbox"]["temperature_c"].as_f64().unwrap().round(),
        100.0
    );
    assert!(found["inputs"]["gearbox"]["temperature"].is_null());
    let colder = [&at[..], &["operation.bulk_temperature=70 °C"]].concat();
    let says = ["other.csv", "no loss at 150 N m, 5000 1/min, 70 °C"];
    with(&colder).refused_json("E313", says[1]);
    let kept = [&colder[..], &["gearbox.temperature=80 °C"]].concat();
    with(&kept).well();
    // The wheel drives, and the table has no such torque.
    with(&["operation.torque=-150 N m"]).refused_json("E313", "-150 N m");
    for (text, says) in [
        ("speed_rpm,loss_torque_nm\n0,-1\n", "zero or more"),
        ("speed_rpm,loss_nm\n0,1\n", "loss_torque_nm"),
        ("speed_rpm,loss_torque_nm\n0,x\n", "other.csv"),
        (
            "speed_rpm,loss_torque_nm\nnan,1\n",
            "other.csv:2: speed_rpm",
        ),
        (
            "speed_rpm,loss_torque_nm,torque_nm\n0,1,5\n1,1,6\n",
            "no row at 5 N m, 1 1/min",
        ),
        ("", "a grid"),
    ] {
        bench.write("other.csv", text);
        with(&[]).refused_json("E138", says);
    }
    with(&["gearbox.loss_table=none.csv"]).refused_json("E103", "none.csv");
}

#[test]
fn parts_that_cannot_be_are_refused_by_their_names() {
    let roller = ("\"deep-groove-ball\"", "\"cylindrical-roller\"");
    for (setting, code, says) in [
        (
            r#"gearbox.seals=[{ shaft = "pinion", diameter = "40 mm" }, { name = "output", shaft = "wheel", diameter = "0 mm" }]"#.to_owned(),
            "E222",
            "gearbox.seals: output: diameter",
        ),
        (bearing(&[("k_z = 3.1", "k_z = -3.1")]), "E222", "bearing 1: k_z"),
        (bearing(&[("bore = \"40 mm\"", "bore = \"70 mm\"")]), "E222", "above the bore"),
        (bearing(&[("radial = \"2 kN\"", "radial = \"-2 kN\"")]), "E222", "radial"),
        (bearing(&[("static_rating = \"11 kN\", ", "")]), "E222", "static_rating"),
        (bearing(&[roller]), "E222", "of another kind of bearing"),
        (
            bearing(&[("\"deep-groove-ball\"", "\"tapered-roller\""), ("static_rating = \"11 kN\", ", "")]),
            "E222",
            "axial_factor",
        ),
        (bearing(&[("r1 = 4.3e-7, ", "")]), "E204", "r1"),
        (bearing(&[("r1 =", "r0 = 1, r1 =")]), "E204", "r0"),
        (r#"gearbox.jet={ flow = "0 l/min", speed = "1 m/s" }"#.to_owned(), "E222", "oil jet: flow"),
        ("gearbox.temperature=80 °C".to_owned(), "E205", "names nothing that loses"),
        (r#"gearbox.seals=[{ shaft = "third", diameter = "40 mm" }]"#.to_owned(), "E204", "pinion"),
        ("gearbox.seal=[]".to_owned(), "E203", "\"seals\""),
    ] {
        run(&[&setting]).refused_json(code, says);
    }
    // More than the whole power of 1 N m and 9000 1/min goes into the seal.
    run(&[
        r#"gearbox.seals=[{ shaft = "pinion", diameter = "400 mm" }]"#,
        "operation.torque=10 N m",
    ])
    .refused_json("E305", "not below the input power");
}

#[test]
fn a_bearing_beyond_what_its_catalogue_allows_is_warned_of() {
    let heavy = bearing(&[("axial = \"1 kN\"", "axial = \"7 kN\"")]);
    let found = run(&[&heavy]).well().json();
    let warnings = found["warnings"].to_string();
    assert!(
        warnings.contains("bearing 1: axial load over static rating"),
        "{warnings}"
    );
    assert!(warnings.contains("W401"), "{warnings}");
}

#[test]
fn check_tells_of_parts_and_a_planetary_set_takes_those_of_its_shafts() {
    let bench = Bench::new();
    bench.write_flanks();
    let text = format!(
        "{}\n[gearbox]\nseals = [{{ shaft = \"pinion\", diameter = \"-1 mm\" }}]\n",
        crate::bench::E_DRIVE
    );
    bench.write("case.toml", text);
    bench
        .run(&["check", "case.toml"])
        .refused(2, "E222", &["gearbox.seals", "seal 1"]);
    bench.write(
        "set.toml",
        r#"
planetary = { teeth = [27, 24, -75], planets = 3, module = "2 mm", face_width = ["30 mm", "30 mm", "30 mm"] }
operation = { torque = "100 N m", speed = "3000 1/min", bulk_temperature = "60 °C" }
lubricant = { oil = "m100" }
surface = { sun = { rq = "0.3 um" }, planet = { rq = "0.3 um" }, ring = { rq = "0.3 um" } }
gearbox = { seals = [{ shaft = "carrier", diameter = "40 mm" }] }
"#,
    );
    let keys = ["--set", "model.positions=4", "--set", "model.offsets=2"];
    let found = bench
        .run(&[&["run", "set.toml", "--no-output", "--json"][..], &keys].concat())
        .well()
        .json();
    // The carrier turns at 27/(27 + 75) of 3000 1/min: P = 7.69e-6 d² n [W], d in mm, n in 1/min.
    let seal = found["gearbox"]["parts_w"].as_f64().unwrap();
    let expected = 7.69e-6 * 1600.0 * 3000.0 * 27.0 / 102.0;
    assert!((seal / expected - 1.0).abs() < 1e-12, "{seal} {expected}");
    let other = [
        "--set",
        "gearbox.seals=[{ shaft = \"pinion\", diameter = \"40 mm\" }]",
    ];
    bench
        .run(&[&["run", "set.toml"][..], &other].concat())
        .refused(2, "E205", &["names a shaft that no mesh of the train has"]);
}

#[test]
fn a_comparison_says_what_it_covers() {
    let bench = Bench::new();
    let profiles = root().join("fixtures/profiles");
    let file = |name: &str| profiles.join(name).display().to_string();
    let (one, other) = (file("ground_pinion.csv"), file("ground_wheel.csv"));
    let ground = format!("ground={one},{other}");
    let (one, other) = (file("superfinished.csv"), file("superfinished_wheel.csv"));
    let fine = format!("superfinished={one},{other}");
    let of = |settings: &[&str], json: &[&str]| {
        let command = [
            "compare",
            "--finish",
            &ground,
            "--finish",
            &fine,
            "--offsets",
            "2",
        ];
        coarse(&bench, &[&command[..], json].concat(), settings).well()
    };
    let plain = of(&[], &[]).unwrapped();
    assert!(
        plain.contains("Scope mesh: without bearings, seals, churning"),
        "{plain}"
    );
    let found = of(&[SEAL], &["--json"]).json();
    assert_eq!(found["scope"], "gearbox");
    let mesh = of(&[], &["--json"]).json();
    assert_eq!(mesh["scope"], "mesh");
    for k in 0..2 {
        let (with, without) = (&found["finishes"][k], &mesh["finishes"][k]);
        assert_eq!(with["loss_w"], without["loss_w"]);
        assert_eq!(with["difference"], without["difference"]);
        assert!(with["gearbox"]["efficiency"].as_f64() < with["efficiency"].as_f64());
    }
    let text = of(&[SEAL], &[]).unwrapped();
    assert!(
        text.contains("Scope gearbox: the values above are of the mesh; with 111 W"),
        "{text}"
    );
    let table =
        std::fs::read_to_string(bench.path("results/e-drive-superfinished-compare/compare.csv"));
    assert!(table.unwrap().contains("gearbox_efficiency_percent"));
}

#[test]
fn a_map_leaves_the_gearbox_aside_says_so_and_exports_it_as_a_part_of_its_own() {
    let bench = Bench::new();
    let axes = [
        "--torque=-100,100",
        "--speed",
        "3000,9000",
        "--band",
        "none",
        "-o",
        "m",
    ];
    let map = |more: &[&str], settings: &[&str]| {
        coarse(&bench, &[&["map"][..], &axes, more].concat(), settings)
    };
    let text = map(&["--export", "csv"], &[SEAL]).well().unwrapped();
    assert!(text.contains("W431 losses are of the mesh"), "{text}");
    let page = std::fs::read_to_string(bench.path("m/map.html")).unwrap();
    assert!(page.contains("W431"));
    let name = std::fs::read_dir(bench.path("m/export"))
        .unwrap()
        .next()
        .unwrap()
        .unwrap();
    let mut rows = csv::Reader::from_path(name.path()).unwrap();
    let header = rows.headers().unwrap().clone();
    let column = |name: &str| header.iter().position(|found| found == name).unwrap();
    let mut count = 0;
    for row in rows.records().map(Result::unwrap) {
        let of = |name: &str| row[column(name)].parse::<f64>().unwrap();
        // A seal's torque does not hang on the speed: 7.69e-6 · 40² · 30/π by hand.
        let torque = 7.69e-6 * 1600.0 * 30.0 / std::f64::consts::PI;
        assert!((of("added_loss_torque_nm") - torque).abs() < 1e-9);
        assert!(row[column("scope")].contains("mesh and gearbox of the case (seal 1)"));
        count += 1;
    }
    assert!(count >= 9);
    bench.write(
        "drive.csv",
        "time_s,torque_nm,speed_rpm\n0,50,3000\n1,50,3000\n",
    );
    let said = bench
        .run(&["cycle", "m", "drive.csv", "--no-output"])
        .well();
    assert!(
        said.unwrapped().contains("W431 energies are of the mesh"),
        "{said:?}"
    );
    bench.write("added.csv", "speed_rpm,loss_torque_nm\n0,0.1\n9000,0.1\n");
    let twice = ["--export", "csv", "--add-loss", "added.csv"];
    map(&twice, &[SEAL]).refused(2, "E205", &["gearbox.loss_table"]);
    bench.write("short.csv", "speed_rpm,loss_torque_nm\n0,0.1\n8000,0.1\n");
    let short = format!("gearbox.loss_table={}", bench.path("short.csv").display());
    map(&[], &[&short]).refused(2, "E313", &["short.csv", "9000 1/min"]);
}

#[test]
fn a_study_keeps_the_gearbox_in_columns_of_its_own() {
    let bench = Bench::new();
    bench.write_flanks();
    let seal = "\n[gearbox]\nseals = [{ shaft = \"pinion\", diameter = \"40 mm\" }]\n";
    bench.write("case.toml", format!("{}{seal}", crate::bench::E_DRIVE));
    bench.write(
        "study.toml",
        "case = \"case.toml\"\n[[axis]]\nkey = \"operation.speed\"\nvalues = [\"3000 1/min\", \"6000 1/min\"]\n",
    );
    bench.run(&["sweep", "run", "study.toml"]).well();
    bench
        .run(&["sweep", "merge", "study.toml", "-o", "merged"])
        .well();
    let mut rows = csv::Reader::from_path(bench.path("merged/sweep.csv")).unwrap();
    let header = rows.headers().unwrap().clone();
    let column = |name: &str| header.iter().position(|found| found == name).unwrap();
    let mut seals = rows.records().map(Result::unwrap).map(|row| {
        let of = |name: &str| row[column(name)].parse::<f64>().unwrap();
        of("gearbox_loss_w") - of("loss_w")
    });
    // 7.69e-6 · 40² · 3000 by hand, and twice that.
    assert!((seals.next().unwrap() - 36.912).abs() < 1e-9);
    assert!((seals.next().unwrap() - 73.824).abs() < 1e-9);
}

#[test]
fn a_sensitivity_study_leaves_the_gearbox_aside_and_says_so() {
    let bench = Bench::new();
    // A table for one temperature, which the changes of the temperature leave.
    bench.write(
        "t.csv",
        "speed_rpm,loss_torque_nm,temperature_c\n0,0.1,90\n9000,0.1,90\n",
    );
    let table = format!("gearbox.loss_table={}", bench.path("t.csv").display());
    let said = coarse(&bench, &["sensitivity", "-o", "s"], &[&table]).well();
    let text = said.unwrapped();
    assert!(text.contains("W431 losses are of the mesh"), "{text}");
    assert!(!text.contains("E313"), "{text}");
}
