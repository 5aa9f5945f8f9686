//! `asperity oils`: the oils of the library.

use asperity::oil::{LibraryOil, LubricantError, LubricantInput, library};
use asperity_core::presets::Certainty;
use asperity_core::quantity::Temperature;
use asperity_report::{COLUMNS, wrapped};
use serde_json::{Value, json};

use super::presets::{LETTERS, unknown};
use crate::args::{Common, PresetArgs};
use crate::failure::Failure;
use crate::output::{print_json, print_text};

/// Temperatures \[°C\] of the viscosities in the table.
const SHOWN: [f64; 2] = [40.0, 100.0];

/// `asperity oils`
pub fn oils(args: &PresetArgs, common: &Common) -> Result<(), Failure> {
    let internal = |error: &dyn std::fmt::Display| Failure::new("E501", error.to_string());
    let mut oils = library().map_err(|error| internal(&error))?;
    if let Some(name) = &args.name {
        oils = vec![named(name)?];
    }
    let mut listed = Vec::new();
    let mut text = format!(
        "{:22} {:>12} {:>12} {:>12}\n",
        "lubricant.oil", "mPa s 40 °C", "mPa s 100 °C", "alpha 1/GPa"
    );
    for oil in &oils {
        let states = states(&oil.name).map_err(|error| internal(&error))?;
        let [cold, hot] = states.map(|state| state.0);
        let (_, alpha) = states[1];
        text.push_str(&format!(
            "{:22} {cold:>12.1} {hot:>12.2} {alpha:>12.1}\n",
            oil.name
        ));
        if args.name.is_some() {
            text.push_str(&numbers(oil));
        }
        for line in [&oil.note, &oil.source] {
            let line = wrapped(&format!("  {line}"), "  ");
            text.push_str(&format!("{line}\n"));
        }
        listed.push(json!({
            "name": oil.name,
            "note": oil.note,
            "source": oil.source,
            "certainty": oil.certainty,
            "lubricant": oil.lubricant,
            "dynamic_viscosity_40_mpa_s": cold,
            "dynamic_viscosity_100_mpa_s": hot,
            "pressure_viscosity_100_per_gpa": alpha,
        }));
    }
    if common.json {
        return print_json(&json!({ "oils": Value::from(listed) }));
    }
    debug_assert!(text.lines().all(|line| line.chars().count() <= COLUMNS));
    print_text(
        common,
        &format!(
            "{text}{LETTERS}\nA viscosity given at one temperature only is used at the bulk temperature of the case.\n"
        ),
    )
}

/// The oil of the library with this name, in upper or lower case.
pub fn named(name: &str) -> Result<LibraryOil, Failure> {
    let mut oils = library().map_err(|error| Failure::new("E501", error.to_string()))?;
    let is_named = |oil: &LibraryOil| oil.name.eq_ignore_ascii_case(name.trim());
    match oils.iter().position(is_named) {
        Some(index) => Ok(oils.swap_remove(index)),
        None => {
            let known: Vec<String> = oils.into_iter().map(|oil| oil.name).collect();
            Err(unknown("oil", name, &known))
        }
    }
}

/// One line per number of an oil, with its certainty.
fn numbers(oil: &LibraryOil) -> String {
    let values = serde_json::to_value(&oil.lubricant).unwrap_or_default();
    let line = |(key, certainty): (&String, &Certainty)| {
        let line = format!("  {key:22} {certainty:8} {}", values[key]);
        wrapped(&line, "      ") + "\n"
    };
    oil.certainty.iter().map(line).collect()
}

/// Viscosity \[mPa s\] and α \[1/GPa\] of an oil at the temperatures of the table.
fn states(name: &str) -> Result<[(f64, f64); 2], LubricantError> {
    let input = LubricantInput {
        oil: Some(name.to_owned()),
        ..LubricantInput::default()
    };
    let at = |celsius: f64| -> Result<(f64, f64), LubricantError> {
        let temperature = Temperature::from_celsius(celsius);
        // A viscosity without a temperature applies at the temperature of the case.
        let state = input.resolve(temperature)?.at(temperature)?.value;
        let alpha = state.pressure_viscosity.si() / 1e-9;
        Ok((state.dynamic_viscosity.si() / 1e-3, alpha))
    };
    Ok([at(SHOWN[0])?, at(SHOWN[1])?])
}
