//! Gear trains: their losses against runs of single meshes, the balance of their powers, and the digits of a result.

use std::sync::Arc;

use asperity::case::{PartKind, Source, Train, from_text};
use asperity::core::quantity::{AngularSpeed, Force};
use asperity::efficiency::rolling_bearing::RollingBearing;
use asperity::pipeline::Kept;
use asperity::train::{MeshRow, Whole};
use asperity::{Error, Run, RunResult};
use asperity_ehl_regime::FilmLaw;
use asperity_tests::planetary_set;

/// Pinion and wheel of the shipped ground flanks.
const FLANKS: &str = r#"
pinion = { file = "ground_pinion.csv" }
wheel = { file = "ground_wheel.csv", mirrored = true }
cutoff = "0.25 mm"
"#;

const COMMON: &str = r#"
[operation]
torque = "145 N m"
speed = "9000 1/min"
bulk_temperature = "90 °C"
[lubricant]
oil = "m100"
[model]
positions = 4
offsets = 1
depths = 0
"#;

const GEARS: [&str; 3] = [
    r#"{ teeth = [23, 68], module = "1.8 mm", face_width = "32 mm", helix = "23.4 deg" }"#,
    r#"{ teeth = [25, 61], module = "2.5 mm", face_width = "40 mm", helix = "15 deg" }"#,
    r#"{ teeth = [21, 67], module = "4 mm", face_width = "70 mm" }"#,
];

fn profiles() -> std::path::PathBuf {
    std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../fixtures/profiles")
}

fn train_of(gears: [&str; 3], keys: &[(&str, &str)]) -> Train {
    try_train_of(gears, keys).unwrap()
}

fn try_train_of(gears: [&str; 3], keys: &[(&str, &str)]) -> Result<Train, Error> {
    let meshes: String = (gears.iter().enumerate())
        .map(|(k, gears)| {
            let next = k + 1;
            format!("mesh.m{next} = {{ shafts = [\"s{k}\", \"s{next}\"], gears = {gears} }}\n")
        })
        .collect();
    let text = format!(
        "title = \"three stages\"\ntrain.input = \"s0\"\n{meshes}{COMMON}[surface]{FLANKS}"
    );
    let source = Source::from_bytes("train.toml", text.as_bytes()).unwrap();
    let keys: Vec<(String, String)> = (keys.iter())
        .map(|(key, value)| ((*key).to_owned(), (*value).to_owned()))
        .collect();
    Train::load_set(source, &profiles(), &keys, &|_| {})
}

fn run(train: &Train, band: bool) -> Whole {
    Run::new(train)
        .pictures(Kept::Highest)
        .interval(band)
        .execute()
        .unwrap()
        .whole
}

#[test]
fn a_pair_of_gears_is_a_train_of_one_mesh() {
    let outcome = |shaft: &str, gears: &str| {
        let seal = format!("gearbox.seals = [{{ shaft = \"{shaft}\", diameter = \"40 mm\" }}]");
        let text = format!("title = \"one mesh\"\n{gears}\n{seal}\n{COMMON}[surface]{FLANKS}");
        let source = Source::from_bytes("one.toml", text.as_bytes()).unwrap();
        let loaded = Train::load_set(source, &profiles(), &[], &|_| {}).unwrap();
        let outcome = Run::new(&loaded)
            .pictures(Kept::Highest)
            .interval(true)
            .execute();
        (loaded, outcome.unwrap())
    };
    let (loaded, pair) = outcome("pinion", &format!("gears = {}", GEARS[0]));
    let named = format!(
        "train.input = \"s0\"\nmesh.m = {{ shafts = [\"s0\", \"s1\"], gears = {} }}",
        GEARS[0]
    );
    let (of_named, named) = outcome("s0", &named);
    // The result of a pair is the result of its mesh; a named mesh is in the result of a train.
    let only = &pair.only().unwrap().result;
    assert!(loaded.only().is_some() && of_named.only().is_none() && named.only().is_none());
    let json = |outcome| serde_json::to_value(outcome).unwrap();
    assert_eq!(json(&pair), serde_json::to_value(only).unwrap());
    assert_eq!(json(&named), serde_json::to_value(&named.whole).unwrap());
    // Both lose the same, with the same interval and the same parts of the gearbox.
    assert_eq!(only.path, named.meshes[0].result.path);
    assert_eq!(only.summary.loss_w, named.whole.loss_w);
    assert_eq!(pair.whole.loss_distribution, named.whole.loss_distribution);
    assert_eq!(pair.whole.gearbox, named.whole.gearbox);
    assert_eq!(only.gearbox, named.whole.gearbox);
    let loss = only.uncertainty.as_ref().unwrap().loss.drawn().ends();
    assert_eq!(pair.whole.loss_distribution.unwrap().drawn.ends(), loss);
    // The ratio of the pair and the tooth numbers of the train differ by their rounding.
    for (a, b) in pair.whole.shafts.iter().zip(&named.whole.shafts) {
        assert!((a.torque_nm / b.torque_nm - 1.0).abs() < 1e-14);
        assert!((a.power_w / b.power_w - 1.0).abs() < 1e-14);
    }
}

/// A single mesh as a case of its own, in the text of a case file.
fn single(gears: &str, row: &MeshRow) -> RunResult {
    let operation = COMMON
        .replace("145 N m", &format!("{:?} N m", row.torque_nm))
        .replace("9000 1/min", &format!("{:?} rad/s", row.speed_rad_per_s));
    let text = format!("gears = {gears}\n{operation}[surface]{FLANKS}");
    let case = from_text("case.toml", &text, &|name| {
        std::fs::read(profiles().join(name))
    })
    .unwrap();
    Run::new(&case)
        .pictures(Kept::Highest)
        .execute()
        .unwrap()
        .into_only()
        .unwrap()
        .result
}

#[test]
fn the_loss_of_three_stages_is_the_sum_of_three_single_runs_to_the_last_digit() {
    let result = run(&train_of(GEARS, &[]), false);
    let rows = result.meshes.iter().zip(GEARS);
    let sum: f64 = rows
        .map(|(row, gears)| single(gears, row).summary.loss_w)
        .sum();
    assert_eq!(result.loss_w, sum);
    // By the tooth numbers, without losses.
    let torques: Vec<f64> = result.meshes.iter().map(|row| row.torque_nm).collect();
    let second = 145.0 * 68.0 / 23.0;
    assert_eq!(torques, [145.0, second, second * 61.0 / 25.0]);
}

#[test]
fn a_user_defined_law_is_the_named_law_in_every_mesh_of_a_train() {
    let named = run(&train_of(GEARS, &[("model.film", "moes")]), false);
    let train = train_of(GEARS, &[]);
    assert_ne!(named.loss_w, run(&train, false).loss_w);
    let own = train.with_laws(&|laws| laws.film = Some(Arc::new(FilmLaw::Moes)));
    assert_eq!(named.loss_w, run(&own, false).loss_w);
    let rows = own.defaults.iter().filter(|row| row.key == "model.film");
    let sources: Vec<_> = rows.map(|row| row.source.as_deref()).collect();
    assert_eq!(sources, [Some("user-defined law")]);
}

/// The sum of all powers into the train is its loss, and the power out is by torque and speed of its shaft.
fn assert_balanced(result: &Whole) {
    let powers = result
        .shafts
        .iter()
        .map(|shaft| shaft.torque_nm * shaft.speed_rad_per_s);
    let powers: Vec<f64> = powers.collect();
    let sum: f64 = powers.iter().sum();
    assert!(
        (sum - result.loss_w).abs() < 1e-12 * result.power_in_w,
        "{result:#?}"
    );
    let out: f64 = powers.iter().filter(|power| **power < 0.0).sum();
    assert_eq!(result.power_out_w, -out);
    let efficiency = result.power_out_w / result.power_in_w;
    assert!((result.efficiency - efficiency).abs() < 1e-12);
    let of_kinds: f64 = result.kinds.rows().iter().map(|(_, loss)| loss).sum();
    assert!((of_kinds / result.loss_w - 1.0).abs() < 1e-12);
}

#[test]
fn powers_and_losses_are_in_balance() {
    for keys in [
        &[][..],
        &[("operation.torque", "-145 N m")],
        &[("train.losses", "passed-on")],
        &[
            ("train.losses", "passed-on"),
            ("operation.torque", "-145 N m"),
        ],
        &[
            ("train.input", "s3"),
            ("operation.torque", "3000 N m"),
            ("operation.speed", "400 1/min"),
        ],
    ] {
        assert_balanced(&run(&train_of(GEARS, keys), false));
    }
    assert_balanced(&run(&planetary_set(), false));
}

#[test]
fn passed_on_losses_lower_each_following_torque() {
    let train = train_of(GEARS, &[("train.losses", "passed-on")]);
    let result = run(&train, false);
    let rows = &result.meshes;
    assert_eq!(rows[0].torque_nm, 145.0);
    for (k, ratio) in [68.0 / 23.0, 61.0 / 25.0].into_iter().enumerate() {
        let power = rows[k].torque_nm * rows[k].speed_rad_per_s - rows[k].loss_w;
        let torque = power / rows[k + 1].speed_rad_per_s;
        assert!(
            (rows[k + 1].torque_nm / torque - 1.0).abs() < 1e-9,
            "{rows:#?}"
        );
        assert!(rows[k + 1].torque_nm < rows[k].torque_nm * ratio * 0.998);
    }
    // The output carries what the last mesh leaves.
    let last = rows[2].torque_nm * rows[2].speed_rad_per_s - rows[2].loss_w;
    assert!((result.power_out_w / last - 1.0).abs() < 1e-9);
    // Backwards each mesh supplies the losses of those behind it.
    let back = train_of(
        GEARS,
        &[
            ("train.losses", "passed-on"),
            ("operation.torque", "-145 N m"),
        ],
    );
    let rows = &run(&back, false).meshes;
    assert!(
        rows[1].torque_nm < -145.0 * 68.0 / 23.0 * 1.002,
        "{rows:#?}"
    );
}

/// Laws without contacts for an equilibrium of which the contacts are no part: it computes the losses some hundred times.
const FORMULAS: [(&str, &str); 2] = [
    ("model.load_share", "zhu-hu"),
    ("model.film_friction", "xu"),
];

const BULK: (&str, &str) = ("operation.bulk", r#"{ law = "iso", lubrication = "jet" }"#);

#[test]
fn the_heat_into_the_nodes_is_the_loss() {
    let heat = r#"{ ambient = "25 °C", oil_to_housing = "80 W/K", housing_to_ambient = "40 W/K", other_losses = "120 W" }"#;
    let keys = [("operation.oil_temperature", "80 °C"), BULK, ("heat", heat)];
    let train = train_of(GEARS, &keys);
    let result = run(&train, false);
    let report = result.heat.clone().unwrap();
    let into = result.loss_w + 120.0;
    assert!((report.heat_w / into - 1.0).abs() < 1e-12);
    let to_ambient = 40.0 * (report.housing_c - 25.0);
    let to_housing = 80.0 * (report.oil_c - report.housing_c);
    for flow in [to_ambient, to_housing] {
        assert!((flow / into - 1.0).abs() < 1e-9, "{report:?}");
    }
    // The losses are those of this oil: a run of each mesh in it, as a case without a balance.
    assert!(report.residual_k < 0.05, "{report:?}");
    let oil = format!("{:?} °C", report.oil_c);
    let keys = [("operation.oil_temperature", &*oil), BULK];
    let stated = train_of(GEARS, &keys);
    assert!((run(&stated, false).loss_w / result.loss_w - 1.0).abs() < 2e-3);
    assert_balanced(&result);
}

#[test]
fn gears_with_conductances_of_their_own_pass_the_loss_of_their_mesh_to_the_oil() {
    let heat = r#"{ ambient = "25 °C", oil_to_housing = "80 W/K", housing_to_ambient = "40 W/K" }"#;
    let of_mesh = |own: [f64; 2]| {
        let [pinion, wheel] = own;
        format!(
            r#"{{ law = "network", pinion_to_oil = "{pinion} W/K", wheel_to_oil = "{wheel} W/K" }}"#
        )
    };
    let conductances = [[30.0, 60.0], [40.0, 90.0], [60.0, 150.0]];
    let networks = conductances.map(of_mesh);
    let keys = [
        ("operation.oil_temperature", "80 °C"),
        ("mesh.m1.bulk", networks[0].as_str()),
        ("mesh.m2.bulk", networks[1].as_str()),
        ("mesh.m3.bulk", networks[2].as_str()),
        ("heat", heat),
    ];
    let result = run(&train_of(GEARS, &[&FORMULAS[..], &keys].concat()), false);
    let report = result.heat.clone().unwrap();
    let gears = report.gears.iter().zip(&result.meshes).zip(conductances);
    assert_eq!(report.gears.len(), 3);
    for ((node, mesh), [pinion, wheel]) in gears {
        let [first, second] = node.pinion_and_wheel_c.unwrap();
        let to_oil = pinion * (first - report.oil_c) + wheel * (second - report.oil_c);
        // Both temperatures are found to some hundredths of a kelvin: a few watts of some hundred.
        assert!(
            (to_oil / mesh.loss_w - 1.0).abs() < 0.02,
            "{to_oil} {mesh:?} {report:?}"
        );
        assert!(first > second && node.bulk_c > report.oil_c);
    }
    assert_balanced(&result);
    // The law of a mesh replaces the common one, and its errors name the mesh.
    let keys = [
        ("operation.oil_temperature", "80 °C"),
        BULK,
        (
            "mesh.m2.bulk",
            r#"{ law = "network", pinion_to_oil = "30 W/K" }"#,
        ),
    ];
    let error = try_train_of(GEARS, &keys).unwrap_err().to_string();
    assert!(
        error.contains("mesh \"m2\"") && error.contains("bulk.wheel_to_oil"),
        "{error}"
    );
}

#[test]
fn a_balance_without_equilibrium_is_refused_and_one_without_a_start() {
    let source = |heat: &str, keys: &[(&str, &str)]| {
        let keys: Vec<(&str, &str)> = keys.iter().copied().chain([("heat", heat)]).collect();
        let keys: Vec<(String, String)> = keys
            .iter()
            .map(|(k, v)| ((*k).to_owned(), (*v).to_owned()))
            .collect();
        let text = format!(
            "train.input = \"s0\"\nmesh.m = {{ shafts = [\"s0\", \"s1\"], gears = {} }}\n{COMMON}[surface]{FLANKS}",
            GEARS[0]
        );
        Train::load_set(
            Source::from_bytes("train.toml", text.as_bytes()).unwrap(),
            &profiles(),
            &keys,
            &|_| {},
        )
    };
    let insulated =
        r#"{ ambient = "25 °C", oil_to_housing = "2 W/K", housing_to_ambient = "1 W/K" }"#;
    let train = source(insulated, &[("operation.oil_temperature", "80 °C"), BULK]).unwrap();
    let error = Run::new(&train)
        .pictures(Kept::Highest)
        .interval(false)
        .execute()
        .unwrap_err();
    assert_eq!(error.code(), "E311", "{error}");
    let error = source(insulated, &[]).unwrap_err();
    assert!(
        error.to_string().contains("operation.oil_temperature"),
        "{error}"
    );
    let negative = insulated.replace("\"1 W/K\"", "\"-1 W/K\"");
    let error = source(&negative, &[("operation.oil_temperature", "80 °C"), BULK]).unwrap_err();
    assert!(
        error.to_string().contains("heat.housing_to_ambient"),
        "{error}"
    );
}

#[test]
fn equal_meshes_have_equal_draws_and_other_flanks_their_own() {
    let equal = [r#"{ teeth = [40, 40], module = "2 mm", face_width = "30 mm" }"#; 3];
    let result = run(&train_of(equal, &[]), true);
    let of_all = result.loss_distribution.unwrap();
    let one = &result.meshes[0];
    for row in &result.meshes {
        assert_eq!((row.loss_w, row.loss_p05_w), (one.loss_w, one.loss_p05_w));
    }
    let same = |sum: f64, of_one: Option<f64>| (sum / (3.0 * of_one.unwrap()) - 1.0).abs() < 1e-12;
    assert!(same(of_all.drawn.low, one.loss_p05_w) && same(of_all.drawn.high, one.loss_p95_w));
    // Sampling and error of the model of other flanks are drawn apart, so that they partly cancel.
    let keys = [
        ("mesh.m2.surface.pinion", r#"{ file = "ground_wheel.csv" }"#),
        (
            "mesh.m3.surface.pinion",
            r#"{ file = "superfinished.csv" }"#,
        ),
    ];
    let other = run(&train_of(equal, &keys), true);
    let quantiles = other.loss_distribution.unwrap().drawn.ends();
    let apart: f64 = other
        .meshes
        .iter()
        .map(|row| row.loss_p95_w.unwrap() - row.loss_p05_w.unwrap())
        .sum();
    assert!(
        quantiles[1] - quantiles[0] < 0.99 * apart,
        "{quantiles:?} {apart}"
    );
}

#[test]
fn a_planetary_set_is_the_sum_of_its_meshes_at_relative_speeds() {
    let set = planetary_set();
    let result = run(&set, false);
    let mut sum = 0.0;
    for (mesh, row) in set.meshes().zip(&result.meshes) {
        let losses = asperity_tests::losses(&mesh.case).unwrap();
        assert_eq!(losses.summary.loss_w, row.loss_w);
        sum += 3.0 * row.loss_w;
    }
    assert!((result.loss_w / sum - 1.0).abs() < 1e-14);
    // Willis by hand: the ring is held, carrier 3000·27/102.
    let report = result.set.unwrap();
    let rpm = |speed: f64| speed * 30.0 / std::f64::consts::PI;
    assert!((rpm(report.carrier_rad_per_s) - 3000.0 * 27.0 / 102.0).abs() < 1e-9);
    let [sun, planet] = [0, 1].map(|k: usize| rpm(result.meshes[k].speed_rad_per_s));
    assert!((sun - 3000.0 * 75.0 / 102.0).abs() < 1e-9);
    assert!((planet - 3000.0 * 75.0 / 102.0 * 27.0 / 24.0).abs() < 1e-9);
    // The same set as a stage of a train.
    let text = format!(
        "train.input = \"sun\"\nmesh.p = {{ shafts = [\"sun\", \"out\"], planetary = {{ teeth = [27, 24, -75], planets = 3, module = \"1.5 mm\", \
         face_width = [\"20 mm\", \"20 mm\", \"20 mm\"] }} }}\n{COMMON}[surface]{FLANKS}"
    );
    let source = Source::from_bytes("train.toml", text.as_bytes()).unwrap();
    let keys = [
        ("operation.torque", "120 N m"),
        ("operation.speed", "3000 1/min"),
        ("model.positions", "6"),
        ("model.offsets", "2"),
    ];
    let keys = keys.map(|(key, value)| (key.to_owned(), value.to_owned()));
    let train = run(
        &Train::load_set(source, &profiles(), &keys, &|_| {}).unwrap(),
        false,
    );
    assert_eq!(train.loss_w, result.loss_w);
    assert_eq!(train.sets["p"], report);
}

/// The numbers of "95.4 (80..110)".
fn numbers(text: &str) -> [f64; 3] {
    let cleared = text.replace(['(', ')', 'W', '%'], "").replace("..", " ");
    let found: Vec<f64> = cleared
        .split_whitespace()
        .map(|word| word.parse().unwrap())
        .collect();
    found.try_into().unwrap()
}

#[test]
fn losses_are_said_with_the_digits_of_their_band() {
    let mut result = Run::new(planetary_set())
        .pictures(Kept::All)
        .interval(true)
        .execute()
        .unwrap()
        .whole;
    let drawn = result.loss_distribution.unwrap();
    let [low, high] = drawn.drawn.ends();
    let [loss, efficiency] = result.with_bands();
    // The last place is a hundredth to a tenth of the interval, rounding half of it.
    let near = |what: &str, found: [f64; 3], expected: [f64; 3], width: f64| {
        for (found, expected) in found.into_iter().zip(expected) {
            assert!(
                (found - expected).abs() < 0.0501 * width,
                "{what}: {found} {expected}"
            );
        }
    };
    near(
        "loss",
        numbers(&loss),
        [drawn.drawn.value, low, high],
        high - low,
    );
    let percent = |loss: f64| 100.0 * (1.0 - loss / result.power_in_w);
    let expected = [drawn.drawn.value, high, low].map(percent);
    near(
        "efficiency",
        numbers(&efficiency),
        expected,
        expected[2] - expected[1],
    );
    // No digit is finer than a fiftieth of the interval, a hundredth where the loss becomes per cent.
    let step = |text: &str| {
        let first = text.split(' ').next().unwrap();
        let zeros = first.len() - first.trim_end_matches('0').len();
        let places = first.split_once('.').map(|(_, after)| after.len());
        match places {
            Some(places) => 0.1_f64.powi(places.try_into().unwrap()),
            None => 10_f64.powi(zeros.try_into().unwrap()),
        }
    };
    assert!(step(&loss) > 0.02 * (high - low), "{loss}");
    let band = expected[2] - expected[1];
    assert!(step(&efficiency) > 0.01 * band, "{efficiency}");

    for mesh in &result.meshes {
        let said = mesh.with_digits().map(|text| {
            let first = text.split(' ').next().unwrap();
            first.parse::<f64>().unwrap()
        });
        let band = mesh.loss_p95_w.unwrap() - mesh.loss_p05_w.unwrap();
        let share = band / mesh.loss_w;
        let expected = [
            (mesh.loss_w, band),
            (
                100.0 * mesh.efficiency,
                100.0 * (1.0 - mesh.efficiency) * share,
            ),
            (mesh.mu_equivalent, mesh.mu_equivalent * share),
        ];
        for (said, (value, band)) in said.into_iter().zip(expected) {
            assert!(
                (said - value).abs() < 0.126 * band,
                "{mesh:?}: {said} {value}"
            );
        }
        assert!(
            mesh.with_digits()[1..].iter().all(|text| text.len() < 9),
            "{mesh:?}"
        );
    }

    let digits = |row: &MeshRow| row.with_digits()[2].len();
    let with = digits(&result.meshes[0]);
    let mut exact = result.meshes[0].clone();
    exact.loss_p05_w = None;
    assert!(digits(&exact) > with);
    result.loss_distribution = None;
    let (loss, efficiency) = (result.loss_w, 100.0 * result.efficiency);
    let expected = [format!("{loss:.0} W"), format!("{efficiency:.4} %")];
    assert_eq!(result.with_bands(), expected);
}

/// Places of gears and bearings, with the constants of a deep groove ball bearing.
fn gearbox(bearings: &[(&str, &str, bool)]) -> String {
    let of = |(shaft, at, locating): &(&str, &str, bool)| {
        format!(
            r#"{{ shaft = "{shaft}", at = "{at}", locating = {locating}, kind = "deep-groove-ball", bore = "40 mm", outside_diameter = "68 mm", static_rating = "11 kN", r1 = 4.3e-7, r2 = 1.7, s1 = 4.63e-3, s2 = 4.25, k_z = 3.1, k_rs = 6e-8, mu_bl = 0.12, mu_ehl = 0.04 }}"#
        )
    };
    let bearings: Vec<String> = bearings.iter().map(of).collect();
    format!(
        r#"{{ seals = [{{ shaft = "s0", diameter = "30 mm" }}, {{ shaft = "s3", diameter = "60 mm" }}], bearings = [{}] }}"#,
        bearings.join(", ")
    )
}

#[test]
fn seals_and_bearings_take_their_power_from_the_shafts_and_heat_the_oil() {
    let stated = gearbox(&[("s1", "0 mm", true), ("s1", "120 mm", false)]);
    let keys = [
        ("gearbox", stated.as_str()),
        ("mesh.m1.at", "30 mm"),
        ("mesh.m1.angle", "0 deg"),
        ("mesh.m1.hand", "right"),
        ("mesh.m2.at", "90 mm"),
        ("mesh.m2.angle", "70 deg"),
        ("mesh.m2.hand", "left"),
    ];
    let plain = run(&train_of(GEARS, &FORMULAS), false);
    let keys = [&FORMULAS[..], &keys].concat();
    let train = train_of(GEARS, &keys);
    let result = run(&train, false);
    let found = result.gearbox.clone().unwrap();
    // The meshes keep every digit.
    assert_eq!(
        (result.loss_w, result.efficiency),
        (plain.loss_w, plain.efficiency)
    );
    let names: Vec<&str> = found.parts.iter().map(|part| part.name.as_str()).collect();
    assert_eq!(names, ["seal 1", "seal 2", "bearing 1", "bearing 2"]);
    let parts: f64 = found.parts.iter().map(|part| part.loss_w).sum();
    assert!(found.parts.iter().all(|part| part.loss_w > 0.0));
    let powers: f64 = result
        .shafts
        .iter()
        .map(|shaft| shaft.torque_nm * shaft.speed_rad_per_s)
        .sum();
    assert!((powers - result.loss_w - parts).abs() < 1e-12 * result.power_in_w);
    assert!((found.loss_w - result.loss_w - parts).abs() < 1e-9);
    assert!((found.efficiency - result.power_out_w / result.power_in_w).abs() < 1e-12);
    // A seal by its formula: 7.69e-6 d² n.
    assert!((found.parts[0].loss_w - 7.69e-6 * 30.0 * 30.0 * 9000.0).abs() < 1e-9);
    // The other direction of the power, and the heat of all parts.
    let back = [&keys[..], &[("operation.torque", "-145 N m")]].concat();
    let back = run(&train_of(GEARS, &back), false);
    let powers: f64 = back
        .shafts
        .iter()
        .map(|shaft| shaft.torque_nm * shaft.speed_rad_per_s)
        .sum();
    let whole = back.gearbox.unwrap().loss_w;
    assert!((powers - whole).abs() < 1e-12 * back.power_in_w);
    let heat = r#"{ ambient = "25 °C", oil_to_housing = "80 W/K", housing_to_ambient = "40 W/K" }"#;
    let warm = [("operation.oil_temperature", "80 °C"), BULK, ("heat", heat)];
    let warm = [&keys[..], &warm].concat();
    let warm = run(&train_of(GEARS, &warm), false);
    let into = warm.gearbox.unwrap().loss_w;
    assert!((warm.heat.unwrap().heat_w / into - 1.0).abs() < 1e-12);
}

#[test]
fn a_spur_gear_between_its_bearings_loads_them_by_the_lever() {
    // One pair of spur gears: F_bn at a quarter of the span, whatever the angle.
    let stated = gearbox(&[("s3", "0 mm", false), ("s3", "200 mm", false)]);
    let keys = [("gearbox", stated.as_str()), ("mesh.m3.at", "50 mm")];
    let train = train_of(GEARS, &keys);
    let result = run(&train, false);
    let [_, _, near, far] = &result.gearbox.as_ref().unwrap().parts[..] else {
        panic!("four parts");
    };
    let mesh = &train.mesh("m3").unwrap().case.case;
    let normal = mesh.gears.forces(mesh.torque).unwrap().normal_base.si();
    let oil = mesh.lubricant.at(mesh.stated_temperature).unwrap().value;
    let stage = train_gearbox_bearing(&train);
    for (part, share) in [(near, 0.75), (far, 0.25)] {
        let load = [share * normal, 0.0].map(Force::from_si);
        let speed = AngularSpeed::from_si(result.shafts[3].speed_rad_per_s.abs());
        let torque = stage.torque(load, speed, oil.kinematic_viscosity).unwrap();
        let expected = torque.value.total().si();
        assert!(
            (part.torque_nm / expected - 1.0).abs() < 1e-9,
            "{part:?} {expected}"
        );
    }
}

#[test]
fn tables_of_idle_gears_and_clutches_and_jets_take_their_power_from_their_shafts() {
    let folder = tempfile::tempdir().unwrap();
    let written = |name: &str, text: &str| {
        let file = folder.path().join(name);
        std::fs::write(&file, text).unwrap();
        file.display().to_string()
    };
    let idle = written(
        "idle.csv",
        "speed_rpm,temperature_c,loss_torque_nm\n0,60,0.1\n4000,60,0.5\n0,120,0.0\n4000,120,0.2\n",
    );
    let clutch = written("clutch.csv", "speed_rpm,loss_w\n100,2\n6000,120\n");
    let stated = |idle: &str| {
        format!(
            r#"{{ jets = [{{ mesh = "m2", flow = "2.5 l/min", speed = "20 m/s" }}], tables = [{{ shaft = "s1", file = "{idle}", name = "idle gear" }}, {{ shaft = "s1", against = "s2", file = "{clutch}" }}] }}"#
        )
    };
    let gearbox = stated(&idle);
    let plain = run(&train_of(GEARS, &[]), false);
    let train = train_of(GEARS, &[("gearbox", &gearbox)]);
    let result = run(&train, false);
    let found = result.gearbox.clone().unwrap();
    assert_eq!(
        (result.loss_w, result.efficiency),
        (plain.loss_w, plain.efficiency)
    );
    let [jet, idle_gear, clutch] = &found.parts[..] else {
        panic!("three parts: {found:?}");
    };
    assert_eq!(
        [&jet.name, &idle_gear.name, &clutch.name],
        ["jet 1", "idle gear", "clutch.csv"]
    );
    // By the tooth numbers; the table at 90 °C is in the middle of its temperatures.
    let middle = 9000.0 * 23.0 / 68.0;
    let omega = |rpm: f64| rpm * std::f64::consts::PI / 30.0;
    let torque = 0.5 * ((0.1 + 1e-4 * middle) + 5e-5 * middle);
    assert!((idle_gear.loss_w / (torque * omega(middle)) - 1.0).abs() < 1e-9);
    // The second shaft turns the other way; 2 W and 120 W are 0.191 N m at both ends.
    let relative = middle * (1.0 + 25.0 / 61.0);
    let [low, high] = [2.0 / omega(100.0), 120.0 / omega(6000.0)];
    let torque = low + (high - low) * (relative - 100.0) / 5900.0;
    assert!((clutch.loss_w / (torque * omega(relative)) - 1.0).abs() < 1e-9);
    // ρ Q v (v + v_jet) at the pitch circle.
    let mesh = &train.mesh("m2").unwrap().case.case;
    let density = mesh
        .lubricant
        .at(mesh.stated_temperature)
        .unwrap()
        .value
        .density
        .si();
    let pitch = omega(middle) * mesh.gears.working_pitch_radius[0].si();
    let expected = density * 2.5e-3 / 60.0 * pitch * (pitch + 20.0);
    assert!(
        (jet.loss_w / expected - 1.0).abs() < 1e-9,
        "{jet:?} {expected}"
    );
    let powers: f64 = (result.shafts.iter())
        .map(|shaft| shaft.torque_nm * shaft.speed_rad_per_s)
        .sum();
    assert!((powers - found.loss_w).abs() < 1e-12 * result.power_in_w);
    assert!((found.loss_w - result.loss_w - found.parts_w).abs() < 1e-9);
    let heat =
        r#"{ ambient = "25 °C", oil_to_housing = "160 W/K", housing_to_ambient = "80 W/K" }"#;
    let warm = [
        ("gearbox", gearbox.as_str()),
        ("operation.oil_temperature", "80 °C"),
        BULK,
        ("heat", heat),
    ];
    let warm = run(&train_of(GEARS, &[&FORMULAS[..], &warm].concat()), false);
    let into = warm.gearbox.unwrap().loss_w;
    assert!((warm.heat.unwrap().heat_w / into - 1.0).abs() < 1e-12);
    // A table that ends before the speed, one that is none, and parts without a place.
    let short = written("short.csv", "speed_rpm,loss_torque_nm\n0,0.1\n1000,0.5\n");
    let short = train_of(GEARS, &[("gearbox", &stated(&short))]);
    let error = Run::new(&short).execute().unwrap_err();
    assert!(error.to_string().contains("idle gear"), "{error}");
    let at_rest = written("rest.csv", "speed_rpm,loss_w\n0,1\n1000,2\n");
    for (keys, code, says) in [
        (stated(&at_rest), "E138", "loss_w at a speed above 0"),
        (stated("/nowhere.csv"), "E103", "nowhere.csv"),
        (gearbox.replace("\"s2\"", "\"s9\""), "E205", "names a shaft"),
        (
            gearbox.replace("against = \"s2\"", "against = \"s1\""),
            "E205",
            "two shafts",
        ),
        (
            gearbox.replace("\"m2\"", "\"m9\""),
            "E205",
            "must name a pair of gears",
        ),
        (gearbox.replace("2.5 l/min", "-1 l/min"), "E222", "jet 1"),
    ] {
        let error = try_train_of(GEARS, &[("gearbox", &keys)]).unwrap_err();
        assert_eq!(error.code(), code, "{error}");
        assert!(error.to_string().contains(says), "{error}");
    }
}

#[test]
fn bearings_of_planets_carry_the_forces_of_sun_and_ring_and_take_their_power_from_the_set() {
    let bearing = |more: &str| {
        format!(
            r#"{{ bearings = [{{ shaft = "m2 planet", kind = "cylindrical-roller", bore = "12 mm", outside_diameter = "24 mm", r1 = 1.09e-6, s1 = 0.16, s2 = 0.0015, k_z = 5.1, k_rs = 3e-8, mu_bl = 0.12, mu_ehl = 0.02{more} }}] }}"#
        )
    };
    let set = r#"mesh.m2 = { shafts = ["s1", "s2"], planetary = { teeth = [27, 24, -75], planets = 3, module = "2 mm", face_width = ["30 mm", "30 mm", "30 mm"] } }"#;
    let train = |stated: &str| {
        let first = GEARS[0];
        let text = format!(
            "train.input = \"s0\"\nmesh.m1 = {{ shafts = [\"s0\", \"s1\"], gears = {first} }}\n{set}\ngearbox = {stated}\n{COMMON}[surface]{FLANKS}"
        );
        let source = Source::from_bytes("train.toml", text.as_bytes()).unwrap();
        Train::load_set(source, &profiles(), &[], &|_| {})
    };
    let loaded = train(&bearing(", planet_mass = \"0.4 kg\", per_planet = 2")).unwrap();
    let result = run(&loaded, false);
    let found = result.gearbox.clone().unwrap();
    // The carrier carries T_s (1 + z_r/z_s), each planet a third of it at the distance of its axis.
    let report = result.sets.values().next().unwrap();
    let torque = 145.0 * 68.0 / 23.0;
    let distance = 1e-3 * (27.0 + 24.0);
    let tangential = torque * (1.0 + 75.0 / 27.0) / 3.0 / distance;
    let outwards = 0.4 * distance * report.carrier_rad_per_s.powi(2);
    let load = [0.5 * tangential.hypot(outwards), 0.0].map(Force::from_si);
    let PartKind::PlanetBearing {
        bearing: rolling, ..
    } = loaded.gearbox.as_ref().unwrap().parts[0].kind
    else {
        panic!("{found:?}")
    };
    let case = &loaded.meshes().next().unwrap().case.case;
    let oil = case.lubricant.at(case.stated_temperature).unwrap().value;
    let speed = AngularSpeed::from_si(report.planet_relative_rad_per_s.abs());
    let one = rolling
        .torque(load, speed, oil.kinematic_viscosity)
        .unwrap();
    let expected = 6.0 * one.value.total().si() * speed.si();
    assert!(
        (found.parts_w / expected - 1.0).abs() < 1e-9,
        "{found:?} {expected}"
    );
    let powers: f64 = (result.shafts.iter())
        .map(|shaft| shaft.torque_nm * shaft.speed_rad_per_s)
        .sum();
    assert!((powers - found.loss_w).abs() < 1e-12 * result.power_in_w);
    let heavy = train(&bearing(", planet_mass = \"-1 kg\"")).unwrap_err();
    let placed = train(&bearing(", at = \"1 mm\"")).unwrap_err();
    let few = train(&bearing(", per_planet = 0")).unwrap_err();
    let none = train(&bearing("").replace("m2 planet", "m1 planet")).unwrap_err();
    for (error, code, says) in [
        (heavy, "E222", "planet_mass"),
        (placed, "E222", "at"),
        (few, "E222", "per_planet"),
        (none, "E205", "names a shaft"),
    ] {
        assert!(
            error.code() == code && error.to_string().contains(says),
            "{error}"
        );
    }
}

#[test]
fn messages_about_the_bulk_temperature_of_a_mesh_name_its_key() {
    let bulk = r#"{ law = "network", pinion_to_oil = "12 W/K" }"#;
    let start = ("operation.oil_temperature", "80 °C");
    let error = try_train_of(GEARS, &[start, BULK, ("mesh.m2.bulk", bulk)]).unwrap_err();
    let text = error.to_string();
    assert!(text.contains("mesh.m2.bulk.wheel_to_oil"), "{text}");
    let negative = r#"{ law = "network", pinion_to_oil = "12 W/K", wheel_to_oil = "-1 W/K" }"#;
    let error = try_train_of(GEARS, &[start, BULK, ("mesh.m2.bulk", negative)]).unwrap_err();
    assert!(
        error.to_string().contains("mesh.m2.bulk.wheel_to_oil"),
        "{error}"
    );
    let error = try_train_of(GEARS, &[start, ("operation.bulk", bulk)]).unwrap_err();
    assert!(
        error.to_string().contains("operation.bulk.wheel_to_oil"),
        "{error}"
    );
}

fn train_gearbox_bearing(train: &Train) -> RollingBearing {
    let parts = &train.gearbox.as_ref().unwrap().parts;
    let bearing = parts.iter().find_map(|part| match part.kind {
        PartKind::Bearing { bearing, .. } => Some(bearing),
        _ => None,
    });
    bearing.unwrap()
}

#[test]
fn a_gearbox_that_statics_cannot_load_is_refused_with_what_is_missing() {
    let two = [("s1", "0 mm", true), ("s1", "120 mm", false)];
    let places = [("mesh.m1.at", "30 mm"), ("mesh.m2.at", "90 mm")];
    let angles = [("mesh.m1.angle", "0 deg"), ("mesh.m2.angle", "70 deg")];
    let hands = [("mesh.m1.hand", "right"), ("mesh.m2.hand", "left")];
    let says = |bearings: &[(&str, &str, bool)], keys: &[(&str, &str)]| {
        let stated = gearbox(bearings);
        let keys = [&[("gearbox", stated.as_str())], keys].concat();
        let error = try_train_of(GEARS, &keys).unwrap_err();
        format!("{} {error}", error.code())
    };
    for (bearings, keys, expected) in [
        (&two[..1], &[][..], "must be two on each shaft"),
        (&two[..], &[][..], "mesh.NAME.at"),
        (&two[..], &places[..], "mesh.NAME.angle"),
        (&two[..], &[places, angles].concat()[..], "mesh.NAME.hand"),
        (&[("s9", "0 mm", true)][..], &[][..], "names a shaft"),
        (
            &[two[0], two[0]][..],
            &[places, angles, hands].concat()[..],
            "locating",
        ),
        (
            &[two[0], ("s1", "0 mm", false)][..],
            &[places, angles, hands].concat()[..],
            "must differ",
        ),
    ] {
        let said = says(bearings, keys);
        assert!(said.contains(expected), "{expected}: {said}");
        assert!(
            said.starts_with("E205") || said.starts_with("E222"),
            "{said}"
        );
    }
    assert!(
        try_train_of(GEARS, &[("gearbox", "{ }")])
            .unwrap_err()
            .to_string()
            .contains("nothing that loses")
    );
}
