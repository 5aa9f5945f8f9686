//! `asperity oils`: the oils of the library.

use asperity::oil::LibraryOil;
use asperity_core::presets::Certainty;
use asperity_report::library::{listed_oil, oils_named, states};
use asperity_report::{COLUMNS, wrapped};
use serde_json::{Value, json};

use super::presets::LETTERS;
use crate::args::{Common, PresetArgs};
use crate::failure::Failure;
use crate::output::{print_json, print_text};

/// `asperity oils`
pub fn oils(args: &PresetArgs, common: &Common) -> Result<(), Failure> {
    let oils = oils_named(args.name.as_deref())?;
    if common.json {
        let listed: Vec<Value> = oils.iter().map(listed_oil).collect::<Result<_, _>>()?;
        return print_json(&json!({ "oils": listed }));
    }
    let mut text = format!(
        "{:22} {:>12} {:>12} {:>12}\n",
        "lubricant.oil", "mPa s 40 °C", "mPa s 100 °C", "alpha 1/GPa"
    );
    for oil in &oils {
        let [(cold, _), (hot, alpha)] = states(&oil.name)?;
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
    }
    debug_assert!(text.lines().all(|line| line.chars().count() <= COLUMNS));
    print_text(
        common,
        &format!(
            "{text}{LETTERS}\nA viscosity given at one temperature only is used at the bulk temperature of the case.\n"
        ),
    )
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
