//! The lubricant of a case, from its text to its state.
#![allow(clippy::unwrap_used)] // Helpers outside test functions.

use std::collections::BTreeSet;

use asperity_core::quantity::{PerKelvin, Temperature};
use asperity_oil::{LubricantError, LubricantInput, LubricantState, library};

fn input(text: &str) -> LubricantInput {
    serde_json::from_str(text).unwrap()
}

fn celsius(t: f64) -> Temperature {
    Temperature::from_si(273.15 + t)
}

fn state(text: &str, t: f64) -> LubricantState {
    let oil = input(text).resolve(celsius(t)).unwrap();
    oil.at(celsius(t)).unwrap().value
}

const DATA_SHEET: &str = r#"{
    "viscosity": {"law": "astm-d341", "at_40": "100 mm2/s", "at_100": "11.2 mm2/s"},
    "density": "880 kg/m3", "base_oil": "mineral"}"#;

#[test]
fn a_data_sheet_is_enough_for_a_whole_state() {
    let s = state(DATA_SHEET, 60.0);
    // 880·(1 − 5.8e-4·45), and ν recomputed independently.
    assert!((s.density.si() - 857.032).abs() < 1e-9);
    assert!((s.kinematic_viscosity.si() / 39.859_219_084_521_17e-6 - 1.0).abs() < 1e-12);
    assert!((s.dynamic_viscosity.si() - s.kinematic_viscosity.si() * 857.032).abs() < 1e-15);
    assert!((s.pressure_viscosity.si() - 9.904e-9 * 39.859_219f64.powf(0.139)).abs() < 1e-15);
    assert!((1900.0..2200.0).contains(&s.heat_capacity.si()));
    assert!((0.12..0.14).contains(&s.thermal_conductivity.si()));
}

#[test]
fn the_temperature_coefficient_is_the_slope_of_the_dynamic_viscosity() {
    for text in [
        DATA_SHEET,
        r#"{"viscosity": {"law": "vogel", "limit_viscosity": "0.08686 mPa s", "slope_kelvin": 890, "pole_kelvin": 182},
            "density": "882 kg/m3", "pressure_viscosity": "20 1/GPa"}"#,
        r#"{"viscosity": {"law": "given", "dynamic_viscosity": "97.5 mPa s"}, "temperature_coefficient": "0.045 1/K",
            "density": "998 kg/m3", "pressure_viscosity": "20 1/GPa"}"#,
    ] {
        let oil = input(text).resolve(celsius(60.0)).unwrap();
        let eta = |t| oil.at(celsius(t)).unwrap().value.dynamic_viscosity.si();
        let slope = -(eta(60.01) - eta(59.99)) / 0.02 / eta(60.0);
        let beta = oil.at(celsius(60.0)).unwrap().value.temperature_coefficient;
        // Central difference: error β³·dt²/6, about 1e-9, and cancellation 1e-11.
        assert!((beta.si() - slope).abs() < 1e-8, "{text}");
    }
}

#[test]
fn every_assumption_is_listed() {
    let oil = input(DATA_SHEET).resolve(celsius(60.0)).unwrap();
    let keys: Vec<_> = oil.assumptions().iter().map(|a| a.key).collect();
    assert_eq!(
        keys,
        [
            "density_temperature",
            "thermal_expansion",
            "pressure_viscosity",
            "thermal_conductivity",
            "heat_capacity"
        ]
    );
}

#[test]
fn a_viscosity_without_its_slope_is_refused() {
    let text = r#"{"viscosity": {"law": "given", "dynamic_viscosity": "97.5 mPa s"},
        "density": "998 kg/m3", "pressure_viscosity": "2e-8 m2/N"}"#;
    let error = input(text).resolve(celsius(60.0)).unwrap_err();
    assert!(error.to_string().contains("beta_T"));
    let twice = LubricantInput {
        temperature_coefficient: Some(PerKelvin::from_si(0.04)),
        ..input(DATA_SHEET)
    };
    let said = twice.resolve(celsius(60.0)).unwrap_err().to_string();
    assert!(
        said.contains("the viscosity law astm-d341 already fixes it"),
        "{said}"
    );
}

#[test]
fn the_misprinted_alpha_of_the_paper_is_refused_with_its_cure() {
    let text = r#"{"viscosity": {"law": "given", "dynamic_viscosity": "97.5 mPa s"}, "temperature_coefficient": "0.045 1/K",
        "density": "998 kg/m3", "pressure_viscosity": "2e-8 mm2/N"}"#;
    let error = input(text).resolve(celsius(60.0)).unwrap_err();
    assert!(error.to_string().ends_with("Did you mean 2e-8 m2/N?"));
}

#[test]
fn missing_and_impossible_numbers_are_named() {
    let resolve = |text: &str| input(text).resolve(celsius(60.0)).unwrap_err();
    let no_density =
        r#"{"viscosity": {"law": "astm-d341", "at_40": "100 mm2/s", "at_100": "11 mm2/s"}}"#;
    for (text, lacks) in [
        ("{}".to_owned(), "viscosity:"),
        (
            no_density.to_owned(),
            "density and no pressure-viscosity coefficient:",
        ),
        (
            no_density.replacen('{', r#"{"base_oil": "pao", "#, 1),
            "density:",
        ),
        (
            no_density.replacen('{', r#"{"density": "880 kg/m3", "#, 1),
            "pressure-viscosity coefficient:",
        ),
    ] {
        let said = resolve(&text).to_string();
        assert!(
            said.starts_with(&format!("the lubricant has no {lacks}")),
            "{said}"
        );
    }
    assert!(matches!(
        resolve(&DATA_SHEET.replace("880", "-880")),
        LubricantError::Domain(_)
    ));
    assert!(serde_json::from_str::<LubricantInput>(r#"{"viscosty": "1"}"#).is_err());
}

#[test]
fn an_unknown_oil_is_answered_with_the_known_ones() {
    let text = input(r#"{"oil": "snake"}"#).resolve(celsius(60.0));
    let message = text.unwrap_err().to_string();
    for oil in library().unwrap() {
        assert!(message.contains(&oil.name));
    }
}

#[test]
fn every_oil_of_the_library_gives_a_plausible_state_by_its_name_alone() {
    for oil in library().unwrap() {
        let completed = LubricantInput {
            oil: Some(oil.name.to_uppercase()),
            ..LubricantInput::default()
        };
        let s = completed.resolve(celsius(60.0)).unwrap();
        let s = s.at(celsius(60.0)).unwrap().value;
        assert!(
            (5e-3..0.2).contains(&s.dynamic_viscosity.si()),
            "{}",
            oil.name
        );
        assert!(
            (9e-9..2.5e-8).contains(&s.pressure_viscosity.si()),
            "{}",
            oil.name
        );
        assert!(
            (0.01..0.06).contains(&s.temperature_coefficient.si()),
            "{}",
            oil.name
        );
        assert!(!oil.source.is_empty() && !oil.note.is_empty());
    }
}

#[test]
fn numbers_of_the_case_replace_those_of_the_library() {
    let s = state(r#"{"oil": "m100", "pressure_viscosity": "21 1/GPa"}"#, 40.0);
    assert_eq!(s.pressure_viscosity.si(), 21e-9);
    assert!((s.kinematic_viscosity.si() / 96e-6 - 1.0).abs() < 1e-12);
}

#[test]
fn an_input_survives_its_own_text() {
    for oil in library().unwrap() {
        let text = serde_json::to_string(&oil.lubricant).unwrap();
        assert_eq!(input(&text), oil.lubricant);
    }
}

#[test]
fn every_key_of_every_oil_has_its_certainty() {
    for oil in library().unwrap() {
        let values = serde_json::to_value(&oil.lubricant).unwrap();
        let given: BTreeSet<String> = values
            .as_object()
            .unwrap()
            .iter()
            .filter(|(_, value)| !value.is_null())
            .map(|(key, _)| key.clone())
            .collect();
        let marked: BTreeSet<String> = oil.certainty.keys().cloned().collect();
        assert_eq!(given, marked, "{}", oil.name);
    }
}
