//! `asperity list oils`: the oils of the library.

use asperity::oil::LibraryOil;
use asperity_report::library::{listed_oil, oils_named, states};
use asperity_report::{COLUMNS, Table, columns, wrapped};

use super::presets::{LETTERS, print_listed};
use crate::args::Common;
use crate::failure::Failure;

/// `asperity list oils`
pub fn oils(name: Option<&str>, common: &Common) -> Result<(), Failure> {
    let oils = oils_named(name)?;
    print_listed(common, "oils", &oils, listed_oil, || {
        table(&oils, name.is_some())
    })
}

fn table(oils: &[LibraryOil], with_numbers: bool) -> Result<String, Failure> {
    let states = oils.iter().map(|oil| states(&oil.name));
    let states = states.collect::<Result<Vec<_>, _>>()?;
    let table = columns! { (oil, [(cold, _), (hot, alpha)]) in oils.iter().zip(states);
        head name "lubricant.oil" "" = &oil.name;
        number cold "viscosity at 40 °C" "mPa s" "{:.1}" = cold;
        number hot "viscosity at 100 °C" "mPa s" "{:.2}" = hot;
        number alpha "pressure-viscosity coefficient" "1/GPa" "{:.1}" = alpha;
    };
    let mut text = table.text("");
    for oil in oils {
        text.push_str(&format!("{}\n", oil.name));
        if with_numbers {
            text.push_str(&numbers(oil).text("  "));
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

/// The numbers of an oil with their certainty.
fn numbers(oil: &LibraryOil) -> Table {
    let values = serde_json::to_value(&oil.lubricant).unwrap_or_default();
    columns! { (key, certainty) in &oil.certainty;
        head key "key" "" = key;
        text certainty "certainty" "" = certainty.to_string();
        text value "value" "" = values[key].to_string();
    }
}
