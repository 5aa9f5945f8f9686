//! Numbers and relations of a case that no gear drive has, or few: named on the first screen, and by `check`.

use crate::bench::{Bench, E_DRIVE};

fn bench(case: &str) -> Bench {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("case.toml", case);
    bench
}

fn with_keys<'a>(command: &[&'a str], keys: &[&'a str]) -> Vec<&'a str> {
    let set = keys.iter().flat_map(|key| ["--set", key]);
    command.iter().copied().chain(set).collect()
}

const RUN: [&str; 3] = ["run", "case.toml", "--no-output"];

#[test]
fn a_mistaken_number_is_named_by_its_key_on_the_first_screen() {
    let bearing = |bore: &str, radial: &str, rating: &str, mu: &str| {
        format!(
            r#"gearbox={{ bearings = [{{ shaft = "pinion", kind = "deep-groove-ball", bore = "{bore}", outside_diameter = "47 mm",
            radial = "{radial}", static_rating = "{rating}", r1 = 4.3e-7, r2 = 1.7, s1 = 4.63e-3, s2 = 4.25, k_z = 3.1, k_rs = 3e-8,
            mu_bl = 0.12, mu_ehl = {mu} }}] }}"#
        )
        .replace('\n', " ")
    };
    let relief = |amount: &str| {
        format!(r#"gears.pinion.tip_relief={{ amount = "{amount}", length = "2 mm" }}"#)
    };
    let flank = |values: &str| {
        format!("surface={{ pinion = {{ {values} }}, wheel = {{ ra = \"0.3 um\" }} }}")
    };
    let oil = |at_40: &str, at_100: &str| {
        format!(
            r#"lubricant.viscosity={{ law = "astm-d341", at_40 = "{at_40} mm2/s", at_100 = "{at_100} mm2/s" }}"#
        )
    };
    let mistakes: [(String, &str); 35] = [
        (relief("990 um"), "E212 gears.pinion.tip_relief.amount"),
        (
            relief("400 um"),
            "W201 gears.pinion.tip_relief.amount = 400 um (222.2222 um per mm of module)",
        ),
        (relief("90 um"), "W201 gears.pinion.tip_relief.amount"),
        (
            "gears.pinion.profile_crowning=-30 um".to_owned(),
            "W201 gears.pinion.profile_crowning",
        ),
        (
            "gears.pinion.crowning=-30 um".to_owned(),
            "W201 gears.pinion.crowning",
        ),
        (
            "gears.pitch_deviations=[\"200 um\", \"0 um\"]".to_owned(),
            "W201 gears.pitch_deviations",
        ),
        (
            "gears.face_width=320 mm".to_owned(),
            "W201 gears.face_width: face width over the pitch diameter",
        ),
        (
            "gears.module=14 mm".to_owned(),
            "W201 gears.face_width: face width over the pitch diameter of the pinion (by teeth, module",
        ),
        (
            "operation.speed=60000 1/min".to_owned(),
            "W201 operation.speed: a pitch-line speed",
        ),
        (
            "operation.bulk_temperature=178 °C".to_owned(),
            "W201 operation.bulk_temperature = 178 °C",
        ),
        (
            "operation.bulk_temperature=[\"170 °C\", \"-20 °C\"]".to_owned(),
            "W201 operation.bulk_temperature",
        ),
        (
            "operation.bulk_temperature=[\"150 °C\", \"-20 °C\"]".to_owned(),
            "W201 operation.bulk_temperature: difference of the flanks = 170 K",
        ),
        (oil("4.1", "1.2"), "W201 lubricant.viscosity"),
        (
            oil("1900", "3"),
            "E212 lubricant.viscosity: viscosity index",
        ),
        (
            "material.pinion.density=1783 kg/m3".to_owned(),
            "W201 material.pinion.density",
        ),
        ("surface.cutoff=0.025 mm".to_owned(), "W201 surface.cutoff"),
        (
            "surface.noise_cutoff=80 um".to_owned(),
            "W201 surface.noise_cutoff",
        ),
        (
            flank("ra = \"0.3 um\", rz = \"0.2 um\""),
            "E212 surface.pinion.rz = \"0.2 um\": Rz over Ra",
        ),
        (
            flank("ra = \"0.5 um\", rq = \"0.3 um\""),
            "E212 surface.pinion.ra = \"0.5 um\": Ra over Rq",
        ),
        (
            flank("ra = \"0.02 um\", rpk = \"9 um\""),
            "E212 surface.pinion.rpk = \"9 um\": Rpk over Ra",
        ),
        (
            "model.boundary_layer=1 um".to_owned(),
            "W201 model.boundary_layer",
        ),
        (
            "model.hysteresis=0.5".to_owned(),
            "W201 model.hysteresis = 50 %",
        ),
        (
            "gearbox={ seals = [{ shaft = \"pinion\", diameter = \"0.04 mm\" }] }".to_owned(),
            "E212 gearbox.seals.diameter",
        ),
        (
            "gearbox={ jet = { flow = \"2500 l/min\", speed = \"20 m/s\" } }".to_owned(),
            "W201 gearbox.jet.flow",
        ),
        (
            "gearbox={ jet = { flow = \"2.5 l/min\", speed = \"20000 m/s\" } }".to_owned(),
            "E212 gearbox.jet.speed",
        ),
        (
            bearing("20 mm", "5000 kN", "6.5 kN", "0.05"),
            "E212 gearbox.bearings.radial: radial load over the square of the bore",
        ),
        (
            bearing("20 mm", "2 kN", "5000 kN", "0.05"),
            "E212 gearbox.bearings.static_rating",
        ),
        (
            bearing("20 mm", "2 kN", "6.5 kN", "20"),
            "E212 gearbox.bearings.mu_ehl",
        ),
        (
            "micropitting={ ra = [\"0.3 mm\", \"0.3 mm\"] }".to_owned(),
            "E212 micropitting.ra",
        ),
        ("vehicle.mass=1800 t".to_owned(), "E212 vehicle.mass"),
        (
            "vehicle.drag_area=600 m2".to_owned(),
            "E212 vehicle.drag_area",
        ),
        ("vehicle.ratio=0.098".to_owned(), "W201 vehicle.ratio"),
        (
            "vehicle.rolling_resistance=0.9".to_owned(),
            "E212 vehicle.rolling_resistance",
        ),
        (
            "vehicle.inertia_factor=100".to_owned(),
            "E212 vehicle.inertia_factor",
        ),
        (
            "vehicle.wheel_radius=335 m".to_owned(),
            "E212 vehicle.wheel_radius",
        ),
    ];
    let vehicle = "[vehicle]\nmass = \"1800 kg\"\nwheel_radius = \"335 mm\"\nratio = 9.8\ndrag_area = \"0.6 m2\"\n\
        rolling_resistance = 0.009\n";
    let bench = bench(&format!("{E_DRIVE}{vehicle}"));
    let mut wrong = Vec::new();
    for (key, says) in &mistakes {
        let said = bench.run(&with_keys(&RUN, &[key]));
        let said = said.unwrapped() + &said.err.replace("case.toml (changed): ", "");
        if !said.contains(says) {
            wrong.push(format!("{key}: {says} is not in {said}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn an_unusual_case_that_may_be_raises_no_warning_about_its_numbers() {
    let bench = bench(E_DRIVE);
    let cases: [&[&str]; 14] = [
        &[],
        &["operation.torque=3 N m"],
        &["gears.teeth=[23, -68]"],
        &["gears.helix=44 deg"],
        &["operation.bulk_temperature=-29 °C"],
        &["operation.bulk_temperature=[\"120 °C\", \"80 °C\"]"],
        &["lubricant.density=1100 kg/m3"],
        &["material.pinion.young=60 GPa"],
        &["material.pinion.flow_pressure=20 GPa"],
        &["gears.profile_shift=[1.4, 1.4]"],
        &["gears.addendum=1.6"],
        &["model.boundary_friction=0"],
        &["model.film_friction={ constant = 0 }"],
        &[
            "model.boundary_layer=0 nm",
            "gearbox={ jet = { flow = \"2.5 l/min\", speed = \"20 m/s\" } }",
        ],
    ];
    for keys in cases {
        let said = bench.run(&with_keys(&["check", "case.toml"], keys)).well();
        assert!(!said.out.contains("W201"), "{keys:?}: {}", said.out);
    }
}

/// A set whose sun and ring have 102 teeth together.
const SET: &str = r#"
[planetary]
teeth = [27, 24, -75]
planets = 4
module = "1.5 mm"
face_width = ["20 mm", "20 mm", "20 mm"]
[operation]
torque = "60 N m"
speed = "5000 1/min"
bulk_temperature = "60 °C"
[lubricant]
oil = "m100"
[surface]
cutoff = "0.25 mm"
sun = { file = "pinion.csv" }
planet = { file = "wheel.csv" }
[model]
positions = 4
offsets = 2
"#;

#[test]
fn planets_that_cannot_be_assembled_are_named_by_check_and_by_a_run() {
    let bench = bench(SET);
    let says =
        "W204 planetary.planets: 4 equally spaced planets cannot be assembled: the 102 teeth";
    for command in [&["check", "case.toml"][..], &RUN] {
        let said = bench.run(command).well();
        assert!(said.unwrapped().contains(says), "{}", said.out);
        let three = with_keys(command, &["planetary.planets=3"]);
        let said = bench.run(&three).well();
        assert!(!said.out.contains("W204"), "{}", said.out);
    }
    let json = bench
        .run(&["run", "case.toml", "-o", "r", "--json"])
        .well()
        .json();
    assert_eq!(json["warnings"][0]["code"], "W204", "{json:#}");
    let page = std::fs::read_to_string(bench.path("r/report.html")).unwrap();
    assert!(page.contains("W204"));
}

#[test]
fn the_own_numbers_of_a_gear_train_have_ranges() {
    let bench = bench(SET);
    for (keys, says) in [
        (
            &["planetary.load_share_factor=30"][..],
            "W201 planetary.load_share_factor = 30",
        ),
        (
            &["planetary.ring_speed=70000 1/min"],
            "W201 planetary.ring_speed = 70000 1/min",
        ),
    ] {
        let said = bench.run(&with_keys(&["check", "case.toml"], keys)).well();
        assert!(said.unwrapped().contains(says), "{}", said.out);
    }
    let heat =
        r#"heat={ ambient = "300 °C", oil_to_housing = "80 W/K", housing_to_ambient = "40 W/K" }"#;
    let keys = [heat, "planetary.planets=3000"];
    let said = bench.run(&with_keys(&["check", "case.toml"], &keys));
    for says in [
        "E212 case.toml (changed): heat.ambient",
        "E212 case.toml (changed): planetary.planets",
    ] {
        assert!(said.err.contains(says), "{}", said.err);
    }
}

#[test]
fn check_lists_what_needs_no_solution() {
    let case = E_DRIVE.replace(
        "file = \"wheel.csv\", mirrored = true",
        "file = \"pinion.csv\", mirrored = true",
    );
    let bench = bench(&case);
    let checked = bench.run(&["check", "case.toml", "--json"]).well().json();
    let run = bench
        .run(&["run", "case.toml", "--no-output", "--json"])
        .well()
        .json();
    let codes = |json: &serde_json::Value| -> Vec<String> {
        let warnings = json["warnings"].as_array().unwrap().iter();
        warnings
            .map(|warning| warning["code"].as_str().unwrap().to_owned())
            .collect()
    };
    let of_run = codes(&run);
    for code in ["W401", "W404", "W421"] {
        assert!(
            codes(&checked).contains(&code.to_owned()),
            "{code} of {checked:#}"
        );
        assert!(of_run.contains(&code.to_owned()), "{code} of {of_run:?}");
    }
}

#[test]
fn a_vehicle_that_few_have_is_noted_with_the_energy_of_its_cycle() {
    let vehicle = "[vehicle]\nmass = \"1800 kg\"\nwheel_radius = \"335 mm\"\nratio = 9.8\ndrag_area = \"0.6 m2\"\n\
        rolling_resistance = 0.009\n";
    let bench = bench(&format!("{E_DRIVE}load_share = \"lambda-star\"\n{vehicle}"));
    let axes = [
        "--torque=-300,-100,100,300",
        "--speed=500,9000",
        "--temperature=90",
    ];
    let map = [
        &["map", "case.toml", "-o", "m", "-q", "--band", "none"][..],
        &axes,
    ];
    bench.run(&map.concat()).well();
    bench.write("trace.csv", "time_s,speed_km_h\n0,50\n1,50\n2,50\n");
    let cycle = ["cycle", "m", "trace.csv", "--no-output", "--allow-outside"];
    let said = bench.run(&cycle).well();
    assert!(!said.out.contains("W201"), "{}", said.out);
    let said = bench.run(&with_keys(&cycle, &["vehicle.ratio=0.4"])).well();
    assert!(
        said.out.contains("W201 vehicle.ratio = 0.4 is unusual"),
        "{}",
        said.out
    );
    let said = bench.run(&with_keys(&cycle, &["vehicle.mass=1800 t"]));
    said.refused(2, "E212", &["vehicle.mass"]);
}
