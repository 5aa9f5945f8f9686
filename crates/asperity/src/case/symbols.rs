//! Symbols of a gear drawing and short forms in place of the keys of a case file.
//!
//! A symbol is read in the table of its key (`gears.z`) or, if only one table has it, above all tables (`z`). Where both
//! the symbol and its key are written, the symbol stays an unknown key.

use toml::{Table, Value};

/// Table, symbol and key of each symbol.
const SYMBOLS: &[(&str, &str, &str)] = &[
    ("gears", "z", "teeth"),
    ("gears", "m_n", "module"),
    ("gears", "mn", "module"),
    ("gears", "m", "module"),
    ("gears", "b", "face_width"),
    ("gears", "a", "centre_distance"),
    ("gears", "x", "profile_shift"),
    ("gears", "alpha_n", "pressure_angle"),
    ("gears", "alpha", "pressure_angle"),
    ("gears", "α_n", "pressure_angle"),
    ("gears", "α", "pressure_angle"),
    ("gears", "beta", "helix"),
    ("gears", "β", "helix"),
    ("gears", "d_a", "tip_diameter"),
    ("gears", "da", "tip_diameter"),
    ("gears", "h_aP", "addendum"),
    ("gears.pinion", "C_a", "tip_relief"),
    ("gears.wheel", "C_a", "tip_relief"),
    ("gears.pinion", "C_beta", "crowning"),
    ("gears.wheel", "C_beta", "crowning"),
    ("gears.pinion", "h_fP", "dedendum"),
    ("gears.wheel", "h_fP", "dedendum"),
    ("gears.pinion", "rho_fP", "fillet_radius"),
    ("gears.wheel", "rho_fP", "fillet_radius"),
    ("material.pinion", "E", "young"),
    ("material.pinion", "nu", "poisson"),
    ("material.pinion", "ν", "poisson"),
    ("operation", "n", "speed"),
    ("operation", "rpm", "speed"),
    ("operation", "T", "torque"),
    ("operation", "theta", "bulk_temperature"),
    ("operation", "ϑ", "bulk_temperature"),
    ("lubricant", "oil", "oil"),
    ("lubricant", "rho", "density"),
    ("lubricant", "ρ", "density"),
    ("lubricant", "nu", "viscosity"),
    ("lubricant", "ν", "viscosity"),
    ("lubricant.viscosity", "nu_40", "at_40"),
    ("lubricant.viscosity", "nu_100", "at_100"),
    ("lubricant.viscosity", "ν_40", "at_40"),
    ("lubricant.viscosity", "ν_100", "at_100"),
    ("planetary", "z", "teeth"),
    ("planetary", "m_n", "module"),
    ("planetary", "mn", "module"),
    ("planetary", "m", "module"),
    ("planetary", "b", "face_width"),
    ("planetary", "a", "centre_distance"),
    ("planetary", "x", "profile_shift"),
    ("planetary", "alpha_n", "pressure_angle"),
    ("planetary", "alpha", "pressure_angle"),
    ("planetary", "α_n", "pressure_angle"),
    ("planetary", "α", "pressure_angle"),
    ("planetary", "beta", "helix"),
    ("planetary", "β", "helix"),
    ("planetary", "d_a", "tip_diameter"),
    ("planetary", "da", "tip_diameter"),
];

/// Tables that the symbols above all tables are moved into.
const OF_A_CASE: [&str; 3] = ["gears", "operation", "lubricant"];

/// Tables whose text is the name of a file.
const FILES: [&str; 4] = [
    "surface.pinion",
    "surface.wheel",
    "surface.coast.pinion",
    "surface.coast.wheel",
];

/// Path of the key that `name` in the table `above` means; `None` if it is no symbol.
pub(super) fn key_of_symbol(above: &str, name: &str) -> Option<String> {
    let tables: &[&str] = if above.is_empty() {
        &OF_A_CASE
    } else {
        &[above]
    };
    let (table, _, key) =
        (SYMBOLS.iter()).find(|(table, symbol, _)| *symbol == name && tables.contains(table))?;
    (above.is_empty() || name != *key).then(|| format!("{table}.{key}"))
}

/// The key among `known` that `name` is a symbol of.
pub(super) fn key_named<'a>(
    name: &str,
    mut known: impl Iterator<Item = &'a str>,
) -> Option<&'a str> {
    known.find(|key| {
        SYMBOLS
            .iter()
            .any(|(_, symbol, of)| *symbol == name && of == key)
    })
}

/// The symbols of a drawing with their keys, for the page of the case file.
pub(super) fn listed() -> String {
    let shown = SYMBOLS
        .iter()
        .filter(|(table, symbol, key)| *table != "planetary" && symbol != key);
    let rows: Vec<String> = shown
        .map(|(table, symbol, key)| format!("`{table}.{symbol}` for `{key}`"))
        .collect();
    rows.join(", ")
}

/// Key of a flank's file that a text at `path` means.
pub(super) fn key_of_text(path: &str) -> Option<String> {
    FILES.contains(&path).then(|| format!("{path}.file"))
}

/// `path` with each symbol replaced by its key.
pub(super) fn with_keys(path: &str) -> String {
    let name = |above: String, part: &str| match key_of_symbol(&above, part) {
        Some(key) => key,
        None if above.is_empty() => part.to_owned(),
        None => format!("{above}.{part}"),
    };
    path.split('.').fold(String::new(), name)
}

/// Moves the value at `from` to `to`, whose tables are made.
pub(super) fn moved(root: &mut Table, from: &str, to: &str) {
    let Some(value) = parent(root, from, false).and_then(|(table, name)| table.remove(name)) else {
        return;
    };
    if let Some((table, name)) = parent(root, to, true) {
        table.insert(name.to_owned(), value);
    }
}

/// The table that holds `path`, and the name in it; made if `is_made`.
fn parent<'a, 'b>(
    root: &'a mut Table,
    path: &'b str,
    is_made: bool,
) -> Option<(&'a mut Table, &'b str)> {
    let (above, name) = path.rsplit_once('.').unwrap_or(("", path));
    let mut table = root;
    for part in above.split('.').filter(|part| !part.is_empty()) {
        if is_made {
            table
                .entry(part)
                .or_insert_with(|| Value::Table(Table::new()));
        }
        table = table.get_mut(part)?.as_table_mut()?;
    }
    Some((table, name))
}

#[cfg(test)]
#[allow(
    clippy::disallowed_methods,
    reason = "tests read the files of the project"
)]
mod tests {
    use super::*;
    use crate::case::{CaseInput, load};

    /// The table with the first symbol of each key; those of the tables of a case above all tables if `is_flat`.
    fn drawn(table: Table, above: &str, is_flat: bool, top: &mut Table) -> Table {
        let mut out = Table::new();
        for (name, value) in table {
            let path = if above.is_empty() {
                name.clone()
            } else {
                format!("{above}.{name}")
            };
            let symbol = SYMBOLS.iter().find(|row| row.0 == above && row.2 == name);
            let value = match value {
                Value::Table(inner) => Value::Table(drawn(inner, &path, is_flat, top)),
                value => value,
            };
            match symbol {
                Some((_, symbol, _)) if is_flat && OF_A_CASE.contains(&above) => {
                    top.insert((*symbol).to_owned(), value);
                }
                Some((_, symbol, _)) => {
                    out.insert((*symbol).to_owned(), value);
                }
                None => {
                    out.insert(name, value);
                }
            }
        }
        out
    }

    #[test]
    fn every_shipped_case_can_be_written_in_the_symbols_of_its_drawing() {
        let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/cases");
        let mut seen = 0;
        for file in std::fs::read_dir(folder).unwrap() {
            let file = file.unwrap().path();
            let text = std::fs::read_to_string(&file).unwrap();
            let of_keys: CaseInput = text.parse().unwrap();
            for is_flat in [false, true] {
                let mut top = Table::new();
                let mut symbols = drawn(text.parse().unwrap(), "", is_flat, &mut top);
                symbols.extend(top);
                let symbols = toml::to_string(&symbols).unwrap();
                assert!(
                    !symbols.contains("teeth") && !symbols.contains("torque"),
                    "{symbols}"
                );
                assert_eq!(symbols.parse::<CaseInput>().unwrap(), of_keys, "{symbols}");
                seen += 1;
            }
        }
        assert!(seen > 6);
    }

    #[test]
    fn a_symbol_is_named_with_its_key_and_never_replaces_it() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("case.toml");
        let text = "z = [23, 68]\ngears = { m_n = \"2 mm\", b = \"30 mm\" }\nn = \"3000 1/min\"\nT = \"100 N m\"\n\
            theta = \"60 °C\"\noil = \"M100\"\nsurface = { pinion = { rq = \"0.3 um\" }, wheel = { rq = \"0.3 um\" } }\n";
        std::fs::write(&file, text).unwrap();
        let loaded = load(&file, None).unwrap();
        let named = loaded
            .warnings
            .iter()
            .find(|warning| warning.code == "W202");
        let named = &named.unwrap().text;
        assert!(
            named.contains("gears.m_n is gears.module") && named.contains("T is operation.torque"),
            "{named}"
        );
        let both = text.replace("m_n =", "module = \"2 mm\", m_n =");
        let refused = both.parse::<CaseInput>().unwrap_err().to_string();
        assert!(
            refused.contains("unknown key \"gears.m_n\"") && refused.contains("module"),
            "{refused}"
        );
        let mut input = loaded.case.input.clone();
        input.set("gears.z", "[24, 68]").unwrap();
        assert_eq!(input.gears.teeth, [24, 68]);
    }

    #[test]
    fn a_text_in_place_of_a_flank_is_its_file() {
        let text = |pinion: &str| {
            format!(
                "gears = {{ teeth = [23, 68], module = \"2 mm\", face_width = \"30 mm\" }}\n\
             operation = {{ torque = \"100 N m\", speed = \"3000 1/min\", bulk_temperature = \"60 °C\" }}\n\
             lubricant = {{ oil = \"m100\" }}\nsurface = {{ pinion = {pinion} }}\n"
            )
        };
        let short: CaseInput = text("\"a.csv\"").parse().unwrap();
        assert_eq!(short, text("{ file = \"a.csv\" }").parse().unwrap());
    }
}
