//! Every number of a whole result, folded by the place where it stands.
//!
//! A change of one column of the path, of one part of the band or of one picture shows here; the numbers that
//! should have changed are then looked at, and the file is written again with a reason.

use std::collections::BTreeMap;
use std::fmt::Write;

use asperity::Run;
use asperity::case::{CaseInput, LoadedCase, load_with};
use asperity::pipeline::Kept;
use asperity::pipeline::survey;
use asperity::uncertainty::difference;
use asperity_paper_2022::film;
use asperity_tests::planetary_set;
use serde_json::Value;

use super::folder;

/// Folded numbers differ between processors more than the losses: some are small differences of large ones.
const TOLERANCE: f64 = 1e-4;

/// Keys whose numbers say how a solver went and not what it found, and what was only read.
const LEFT_OUT: [&str; 11] = [
    "equations",
    "evidence",
    "inputs",
    "load_error",
    "references",
    "residual_k",
    "schema_version",
    "steps",
    "worst_duality_gap",
    "worst_load_error",
    "rounds",
];

/// The numbers at one place.
#[derive(Default)]
struct Numbers {
    count: usize,
    sum: f64,
    /// Sum with weights 1, 2, 3, 1, 2, 3…, so that numbers that change places show.
    weighted: f64,
    squares: f64,
}

impl Numbers {
    fn add(&mut self, value: f64) {
        self.weighted += (1 + self.count % 3) as f64 * value;
        self.count += 1;
        self.sum += value;
        self.squares += value * value;
    }

    /// Count, mean, weighted mean and root mean square.
    fn folded(&self) -> [f64; 4] {
        let n = self.count as f64;
        let rms = (self.squares / n).sqrt();
        [n, self.sum / n, self.weighted / n, rms]
    }
}

/// The numbers of a JSON value by their path, with `[]` for every index.
fn numbers(value: &Value, path: &str, found: &mut BTreeMap<String, Numbers>) {
    match value {
        Value::Number(number) => {
            let value = number.as_f64().unwrap();
            found.entry(path.to_owned()).or_default().add(value);
        }
        Value::Bool(is) => found
            .entry(path.to_owned())
            .or_default()
            .add(f64::from(u8::from(*is))),
        Value::Array(items) => {
            for item in items {
                numbers(item, &format!("{path}[]"), found);
            }
        }
        Value::Object(keys) => {
            for (key, item) in keys {
                if !LEFT_OUT.contains(&key.as_str()) {
                    numbers(item, &format!("{path}.{key}"), found);
                }
            }
        }
        Value::Null | Value::String(_) => {}
    }
}

/// What a result warns of, with the rounded numbers in its texts.
fn warnings(value: &Value, found: &mut Vec<String>) {
    match value {
        Value::Array(items) => items.iter().for_each(|item| warnings(item, found)),
        Value::Object(keys) => {
            if let (Some(Value::String(code)), Some(Value::String(text))) =
                (keys.get("code"), keys.get("text"))
            {
                found.push(format!("{code}: {text}"));
            }
            keys.values().for_each(|item| warnings(item, found));
        }
        _ => {}
    }
}

/// A line for each place: path, count, mean, weighted mean, root mean square. Then the warnings.
fn outline(value: &Value) -> String {
    let mut found = BTreeMap::new();
    numbers(value, "", &mut found);
    let mut text = found.iter().fold(String::new(), |mut text, (path, at)| {
        let [count, mean, weighted, rms] = at.folded();
        writeln!(text, "{path} {count} {mean:.9e} {weighted:.9e} {rms:.9e}").unwrap();
        text
    });
    let mut warned = Vec::new();
    warnings(value, &mut warned);
    for line in warned {
        writeln!(text, "{line}").unwrap();
    }
    text
}

/// Compares two outlines line by line.
fn compare(name: &str, expected: &str, actual: &str) {
    let mut differences = Vec::new();
    let split = |line: &str| -> (String, Vec<f64>) {
        let mut words = line.split(' ');
        let path = words.next().unwrap().to_owned();
        (path, words.map(|word| word.parse().unwrap()).collect())
    };
    let is_place = |line: &&str| line.starts_with('.');
    let table = |text: &str| -> BTreeMap<String, Vec<f64>> {
        text.lines().filter(is_place).map(split).collect()
    };
    let warned = |text: &str| -> Vec<String> {
        let lines = text.lines().filter(|line| !is_place(line));
        lines.map(str::to_owned).collect()
    };
    assert_eq!(warned(expected), warned(actual), "{name}");
    let (expected, actual) = (table(expected), table(actual));
    for (path, was) in &expected {
        let Some(is) = actual.get(path) else {
            differences.push(format!("{path} is gone"));
            continue;
        };
        let allowed = TOLERANCE * was[3];
        let differs = was[0] != is[0] || (1..4).any(|i| (was[i] - is[i]).abs() > allowed);
        if differs {
            differences.push(format!("{path} was {was:?}, is {is:?}"));
        }
    }
    let new = actual.keys().filter(|path| !expected.contains_key(*path));
    differences.extend(new.map(|path| format!("{path} is new")));
    assert!(
        differences.is_empty(),
        "{name}:\n{}",
        differences.join("\n")
    );
}

fn hold(name: &str, value: &Value) {
    let file = folder("golden").join(format!("{name}.outline"));
    let actual = outline(value);
    if std::env::var_os("ASPERITY_WRITE").is_some() {
        std::fs::write(&file, actual).unwrap();
        return;
    }
    let expected =
        std::fs::read_to_string(&file).unwrap_or_else(|_| panic!("no outline of {name}: write it"));
    compare(name, &expected, &actual);
}

/// A shipped case, coarsely, with keys set.
fn coarse(name: &str, keys: &[(&str, &str)]) -> LoadedCase {
    let file = folder("../fixtures/cases").join(name);
    let case = load_with(&file, &|input| {
        (input.model.positions, input.model.offsets) = (Some(6), Some(4));
    });
    let set = |input: &mut CaseInput| {
        for (key, value) in keys {
            input.set(key, value).unwrap();
        }
    };
    case.unwrap().with(set).unwrap()
}

/// A case with its band: the result, the pictures, every offset, and what the path is without contacts.
fn hold_case(name: &str, case: &LoadedCase) {
    let outcome = Run::new(case)
        .pictures(Kept::Highest)
        .interval(true)
        .execute()
        .unwrap()
        .into_only()
        .unwrap();
    let value = serde_json::json!({
        "result": outcome.result,
        "offsets": outcome.offsets,
        "fields": outcome.fields,
        "views": outcome.views,
        "survey": survey(case).unwrap(),
        "film": film(case, None).unwrap(),
    });
    hold(name, &value);
}

#[test]
fn a_case_with_gearbox_rating_and_running_in_gives_what_it_gave() {
    let seals =
        r#"[{ shaft = "pinion", diameter = "40 mm" }, { shaft = "wheel", diameter = "70 mm" }]"#;
    let jet = r#"{ flow = "2.5 l/min", speed = "0.4 m/s" }"#;
    let keys = [
        ("gearbox.seals", seals),
        ("gearbox.jet", jet),
        ("micropitting", "{ permissible = 0.2, load_factor = 1.21 }"),
        ("operation.running_in", "true"),
        // Some of the contacts pass it.
        ("material.pinion.elastic_limit", "3900 MPa"),
        ("material.wheel.elastic_limit", "3900 MPa"),
    ];
    hold_case("e-drive-whole", &coarse("e-drive.toml", &keys));
}

#[test]
fn a_case_by_the_formulas_with_its_bulk_temperature_gives_what_it_gave() {
    let bulk = r#"{ law = "iso", lubrication = "jet" }"#;
    let keys = [
        ("model.load_share", "lambda-star"),
        ("operation.oil_temperature", "90 °C"),
        ("operation.bulk", bulk),
    ];
    hold_case(
        "e-drive-superfinished-whole",
        &coarse("e-drive-superfinished.toml", &keys),
    );
}

#[test]
fn steady_solutions_of_full_films_give_what_they_gave() {
    let keys = [
        ("model.full_film", "ehl"),
        ("model.load_share", "lambda-star"),
        ("operation.bulk_temperature", "60 °C"),
    ];
    let case = coarse("e-drive-superfinished.toml", &keys);
    let outcome = Run::new(&case)
        .pictures(Kept::Highest)
        .execute()
        .unwrap()
        .into_only()
        .unwrap();
    assert!(
        outcome
            .result
            .path
            .iter()
            .any(|row| row.full_film.is_some())
    );
    let value = serde_json::json!({ "result": outcome.result, "fields": outcome.fields });
    hold("full-film-whole", &value);
}

#[test]
fn the_difference_of_two_finishes_is_what_it_was() {
    let [ground, polished] = ["e-drive.toml", "e-drive-superfinished.toml"].map(|name| {
        let case = coarse(name, &[("model.load_share", "lambda-star")]);
        let (outcome, drawn) = Run::new(&case)
            .pictures(Kept::Highest)
            .interval(true)
            .execute()
            .unwrap()
            .only_with_draws()
            .unwrap();
        (case, drawn.unwrap(), outcome.result.uncertainty.unwrap())
    });
    let found = difference(
        (&ground.0, &ground.1, &ground.2),
        (&polished.0, &polished.1, &polished.2),
    );
    let value = serde_json::json!({ "difference": found });
    hold("finishes-whole", &value);
}

#[test]
fn a_planetary_set_gives_what_it_gave() {
    let loaded = planetary_set();
    let outcome = Run::new(&loaded)
        .pictures(Kept::Highest)
        .interval(true)
        .execute()
        .unwrap();
    let [first, second] = &outcome.meshes[..] else {
        panic!("two meshes");
    };
    let value = serde_json::json!({
        "set": outcome.whole,
        "sun_and_planet": first.result,
        "planet_and_ring": second.result,
    });
    hold("planetary-whole", &value);
}
