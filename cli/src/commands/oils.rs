//! `asperity oils`: the oils of the library.

use asperity::oil::LibraryOil;
use asperity_core::presets::Certainty;
use asperity_report::library::{listed_oil, oils_named, states};
use asperity_report::{COLUMNS, wrapped};

use super::presets::{LETTERS, print_listed};
use crate::args::{Common, PresetArgs};
use crate::failure::Failure;

/// `asperity oils`
pub fn oils(args: &PresetArgs, common: &Common) -> Result<(), Failure> {
    let oils = oils_named(args.name.as_deref())?;
    print_listed(common, ("oils", &oils), listed_oil, || {
        table(&oils, args.name.is_some())
    })
}

fn table(oils: &[LibraryOil], with_numbers: bool) -> Result<String, Failure> {
    let mut text = format!(
        "{:22} {:>12} {:>12} {:>12}\n",
        "lubricant.oil", "mPa s 40 °C", "mPa s 100 °C", "alpha 1/GPa"
    );
    for oil in oils {
        let [(cold, _), (hot, alpha)] = states(&oil.name)?;
        text.push_str(&format!(
            "{:22} {cold:>12.1} {hot:>12.2} {alpha:>12.1}\n",
            oil.name
        ));
        if with_numbers {
            text.push_str(&numbers(oil));
        }
        for line in [&oil.note, &oil.source] {
            let line = wrapped(&format!("  {line}"), "  ");
            text.push_str(&format!("{line}\n"));
        }
    }
    debug_assert!(text.lines().all(|line| line.chars().count() <= COLUMNS));
    Ok(format!(
        "{text}{LETTERS}\nA viscosity given at one temperature only is used at the bulk temperature of the case.\n"
    ))
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
