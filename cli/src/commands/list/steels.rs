//! `asperity list steels`: the steels of the library.

use asperity_core::Fault;
use asperity_core::presets::SteelPreset;
use asperity_report::library::{listed_steel, steels_named, strength};
use asperity_report::{columns, wrapped};

use super::presets::{LETTERS, figures, least, print_listed};
use crate::args::Common;
use crate::failure::Failure;

/// `asperity list steels`
pub fn steels(name: Option<&str>, common: &Common) -> Result<(), Failure> {
    let shown = steels_named(name)?;
    print_listed(common, "steels", &shown, listed_steel, || {
        match (name, shown.first()) {
            (Some(_), Some(one)) => whole(one),
            _ => table(&shown),
        }
    })
}

fn table(steels: &[SteelPreset]) -> Result<String, Failure> {
    let row = |steel: &'_ SteelPreset| {
        let vickers = steel.hardness.value.vickers().map_err(Fault::internal)?;
        Ok::<_, Failure>((vickers, strength(steel)?))
    };
    let rows = steels
        .iter()
        .map(row)
        .collect::<Result<Vec<_>, Failure>>()?;
    let table = columns! { (steel, (vickers, (flow, limit))) in steels.iter().zip(rows);
        head name "steel" "" = &steel.name;
        number young "E" "GPa" "{:.1}" = steel.young.value.si() / 1e9;
        number poisson "ν" "" = steel.poisson.value;
        number hardness "hardness" "HV" "{:.0}" = vickers;
        number flow "flow pressure" "GPa" "{:.2}" = flow;
        number limit "elastic limit" "MPa" = limit.map_or("density".to_owned(), |limit| format!("{limit:.0}"));
        text least "least" "" = least(&steel.rows());
        text treatment "treatment" "" = &steel.treatment;
    };
    let mut text = table.text("");
    text.push_str(&wrapped(
        "E: Young's modulus. ν: Poisson's ratio. Flow pressure: 9.80665 MPa per HV. Elastic limit: 2.876 HV - 90.7 MPa (Pavlina and Van Tyne 2008; fitted up to \
         632 HV), or by the density. least: the \
         lowest certainty of the numbers.",
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
