//! Keys of a case in the paper's formulation.

#![allow(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use std::collections::BTreeSet;
use std::path::Path;

use asperity::case::{LoadedCase, load};
use asperity_paper_2022::register;
use serde_json::Value;

fn e_drive() -> LoadedCase {
    register();
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/cases/e-drive.toml");
    load(&file, None).unwrap()
}

/// A value of each key that the formulation refuses.
const STATED: [(&str, &str); 6] = [
    (
        "calibration",
        "{ boundary_friction = { value = 0.09, low = 0.08, high = 0.1 } }",
    ),
    ("micropitting", "{}"),
    ("model.inlet_layer", "1 um"),
    ("operation.bulk", r#"{ law = "iso", lubrication = "jet" }"#),
    ("operation.running_in", "true"),
    ("operation.temperature_deviation", "3 K"),
];

#[test]
fn each_key_of_the_other_formulation_is_refused() {
    // An oil file must be there to be refused; tests/cli/oil_file.rs has one.
    let refused = register().refused_keys().iter();
    let refused = refused.filter(|(key, _)| *key != "lubricant.oil_file");
    let known: BTreeSet<&str> = STATED.iter().map(|(key, _)| *key).collect();
    assert_eq!(
        refused
            .clone()
            .map(|(key, _)| *key)
            .collect::<BTreeSet<_>>(),
        known
    );
    for (key, rule) in refused {
        let (_, value) = STATED.iter().find(|(stated, _)| stated == key).unwrap();
        let case = e_drive().with(|input| {
            input.formulation = Some(register());
            input.set(key, value).unwrap();
            if *key == "operation.bulk" {
                input.set("operation.oil_temperature", "90 °C").unwrap();
                input.operation.bulk_temperature = None;
            }
        });
        let error = case.unwrap_err();
        assert_eq!(error.code(), "E205", "{key}: {error}");
        let text = error.to_string();
        assert!(text.contains(key) && text.contains(rule), "{key}: {text}");
    }
}

#[test]
fn a_switch_that_is_off_is_not_refused() {
    let case = e_drive().with(|input| {
        input.formulation = Some(register());
        input.set("operation.running_in", "false").unwrap();
    });
    assert_eq!(case.unwrap().case.running_in, None);
}

/// The rows of the table `model` in the schema.
fn rows() -> serde_json::Map<String, Value> {
    register();
    let schema = asperity::case::schema();
    schema["$defs"]["ModelInput"]["properties"]
        .as_object()
        .unwrap()
        .clone()
}

#[test]
fn the_page_of_the_keys_has_the_defaults_of_the_formulation() {
    let (rows, paper) = (rows(), register());
    let Value::Object(defaults) = serde_json::to_value(paper.defaults()).unwrap() else {
        unreachable!("a table");
    };
    let stated = defaults.into_iter().filter(|(_, value)| !value.is_null());
    let listed = stated.filter(|(key, _)| {
        !paper
            .unused_keys()
            .contains(&format!("model.{key}").as_str())
    });
    let mut seen = 0;
    for (key, value) in listed {
        seen += 1;
        let about = rows[&key]["description"].as_str().unwrap();
        let (_, after) = about
            .split_once("`paper`: ")
            .unwrap_or_else(|| panic!("{key}: {about}"));
        let shown = match &value {
            Value::String(text) => text.split(' ').next().unwrap().to_owned(),
            other => other.to_string(),
        };
        let said = after.trim_start_matches('`');
        assert!(said.starts_with(&shown), "{key}: {shown} in {about}");
    }
    assert!(seen >= 8, "{seen}");
}

#[test]
fn keys_that_are_not_used_exist_and_are_not_among_the_defaults() {
    let (rows, paper) = (rows(), register());
    let case = e_drive()
        .with(|input| input.formulation = Some(paper))
        .unwrap();
    let listed: BTreeSet<&str> = case
        .case
        .defaults
        .iter()
        .map(|used| used.key.as_ref())
        .collect();
    for key in paper.unused_keys() {
        assert!(rows.contains_key(key.trim_start_matches("model.")), "{key}");
        assert!(!listed.contains(key), "{key}");
    }
    for key in [
        "formulation",
        "paper.position",
        "paper.delta_step",
        "paper.numerical_error",
    ] {
        let is_stated = key == "formulation";
        assert!(is_stated || listed.contains(key), "{key}: {listed:?}");
    }
    let with_default = e_drive();
    let listed = with_default
        .case
        .defaults
        .iter()
        .map(|used| used.key.as_ref());
    let listed: BTreeSet<&str> = listed.collect();
    assert!(paper.unused_keys().iter().any(|key| listed.contains(key)));
}
