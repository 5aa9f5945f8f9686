//! `asperity steels`: the steels of the library.

use asperity_core::Fault;
use asperity_core::presets::SteelPreset;
use asperity_report::library::{listed_steel, steels_named, strength};
use asperity_report::wrapped;

use super::presets::{LETTERS, figures, least, print_listed};
use crate::args::{Common, PresetArgs};
use crate::failure::Failure;

/// `asperity steels`
pub fn steels(args: &PresetArgs, common: &Common) -> Result<(), Failure> {
    let shown = steels_named(args.name.as_deref())?;
    print_listed(common, ("steels", &shown), listed_steel, || {
        match (&args.name, shown.first()) {
            (Some(_), Some(one)) => whole(one),
            _ => table(&shown),
        }
    })
}

fn table(steels: &[SteelPreset]) -> Result<String, Failure> {
    let mut text = format!(
        "{:13} {:>7} {:>8} {:>7} {:>6} {:>8} {:>9} {:>9}\n",
        "steel", "E GPa", "nu", "HV", "p_f", "limit", "least", "treatment"
    );
    for steel in steels {
        let (flow, limit) = strength(steel)?;
        let vickers = steel.hardness.value.vickers();
        text.push_str(&format!(
            "{:13} {:>7.1} {:>8} {:>7.0} {flow:>6.2} {:>8} {:>9} {}\n",
            steel.name,
            steel.young.value.si() / 1e9,
            steel.poisson.value,
            vickers.map_err(Fault::internal)?,
            limit.map_or("density".to_owned(), |limit| format!("{limit:.0}")),
            least(&steel.rows()),
            steel.treatment,
        ));
    }
    text.push_str(&wrapped(
        "p_f: flow pressure in GPa, 9.80665 MPa per HV. limit: elastic limit in MPa, 2.876 HV - 90.7 (Pavlina and Van \
         Tyne 2008; fitted up to 632 HV). least: the lowest certainty of the numbers.",
        "",
    ));
    Ok(format!(
        "{text}\n{LETTERS}\nIn a case: [material.pinion] steel = \"16MnCr5\", and hardness = \"58 HRC\" where\nit differs.\n"
    ))
}

fn whole(steel: &SteelPreset) -> Result<String, Failure> {
    let number = steel
        .number
        .as_ref()
        .map_or(String::new(), |number| format!(" ({number})"));
    let head = format!(
        "{}{number}, {}. {}",
        steel.name, steel.treatment, steel.note
    );
    let (flow, limit) = strength(steel)?;
    let follows = match limit {
        Some(limit) => format!(
            "flow pressure {flow:.3} GPa (9.80665 MPa per HV, Hardness-1), elastic limit {limit:.0} MPa (Pavlina-1)"
        ),
        None => format!(
            "flow pressure {flow:.3} GPa (Hardness-1); with the density follow young (Sinter-1), poisson (Sinter-2), \
             elastic_limit (Sinter-3) and conductivity (Sinter-4)"
        ),
    };
    Ok(format!(
        "{}\n{}\n{}",
        wrapped(&head, "  "),
        wrapped(&format!("  {follows}"), "    "),
        figures(&steel.rows())?
    ))
}
