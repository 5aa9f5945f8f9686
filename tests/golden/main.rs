//! Golden results of the shipped cases, so that no change of a result goes unnoticed: the numbers one looks at
//! first, and of every other number in a result ([`outline`]) its mean and size over where it stands.
//!
//! `ASPERITY_WRITE=1 cargo test -p asperity-tests --test golden` writes the values anew; do that only
//! with a reason, and say it in the change.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may panic")]

mod outline;
mod shipped_profiles;

use asperity::pipeline::Kept;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use asperity::case::load;
use asperity::ehl_regime::FULL_FILM;
use asperity::formulation::FormulationChoice;
use asperity::result::{Regime, RunResult};
use asperity_tests::assert_close;
use serde_json::{Map, Value, json};

/// Fourier transforms round differently from processor to processor, and a contact is solved to 1e-8.
const TOLERANCE: f64 = 1e-6;

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(name)
}

/// Every shipped case by its name.
fn cases() -> BTreeMap<String, PathBuf> {
    std::fs::read_dir(folder("../fixtures/cases"))
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|ending| ending == "toml"))
        .map(|path| (path.file_stem().unwrap().display().to_string(), path))
        .collect()
}

fn values(result: &RunResult) -> Map<String, Value> {
    let summary = &result.summary;
    let (first, last) = (&result.path[0], result.path.last().unwrap());
    let json = json!({
        "efficiency": summary.efficiency,
        "efficiency_deviation": summary.efficiency_deviation,
        "loss_w": summary.loss_w,
        "sliding_w": summary.sliding_w,
        "rolling_w": summary.rolling_w,
        "mixed_share": summary.mixed_share,
        "lambda_star_first": first.lambda_star,
        "lambda_star_last": last.lambda_star,
    });
    json.as_object().unwrap().clone()
}

fn computed(case: &Path, formulation: FormulationChoice) -> Map<String, Value> {
    let loaded = load(case, Some(formulation)).unwrap();
    let run = asperity::Run::new(&loaded)
        .pictures(Kept::NoPictures)
        .execute();
    let result = run.unwrap().into_only().unwrap().result;
    if formulation == FormulationChoice::default() {
        for row in &result.path {
            let touches = row.film_share <= 1.0 - FULL_FILM;
            assert!(!touches || row.regime != Regime::FullFilm, "{row:?}");
            assert_eq!(row.mixed_share == 0.0, row.regime == Regime::FullFilm);
        }
    }
    values(&result)
}

/// Both formulations of a case, with what the file says of itself.
fn golden(case: &Path) -> Value {
    json!({
        "reason": "computed by this program when its validation held; guards against change, proves nothing else",
        "relative_tolerance": TOLERANCE,
        "corrected": computed(case, FormulationChoice::default()),
        "paper": computed(case, asperity_paper_2022::register()),
    })
}

fn compare(name: &str, expected: &Value, actual: &Value) {
    assert_eq!(expected["relative_tolerance"], json!(TOLERANCE));
    for formulation in ["corrected", "paper"] {
        let (expected, actual) = (
            expected[formulation].as_object().unwrap(),
            actual[formulation].as_object().unwrap(),
        );
        let keys = |values: &Map<String, Value>| values.keys().cloned().collect::<Vec<_>>();
        assert_eq!(keys(expected), keys(actual), "{name} {formulation}");
        for (key, value) in expected {
            let what = format!("{name} {formulation} {key}");
            match (value.as_f64(), actual[key].as_f64()) {
                (Some(expected), Some(actual)) => {
                    assert_close(&what, actual, expected, TOLERANCE);
                }
                _ => assert_eq!(value, &actual[key], "{what}"),
            }
        }
    }
}

#[test]
fn the_shipped_cases_give_what_they_gave() {
    let writing = std::env::var_os("ASPERITY_WRITE").is_some();
    for (name, case) in cases() {
        let file = folder("golden").join(format!("{name}.json"));
        let actual = golden(&case);
        if writing {
            let text = serde_json::to_string_pretty(&actual).unwrap();
            std::fs::write(&file, text + "\n").unwrap();
            continue;
        }
        let text = std::fs::read_to_string(&file)
            .unwrap_or_else(|_| panic!("no golden values of {name}: write them"));
        compare(&name, &serde_json::from_str(&text).unwrap(), &actual);
    }
}

#[test]
fn every_golden_file_belongs_to_a_shipped_case() {
    let cases = cases();
    for entry in std::fs::read_dir(folder("golden")).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|ending| ending == "json") {
            assert!(cases.contains_key(&path.file_stem().unwrap().display().to_string()));
        }
    }
}
