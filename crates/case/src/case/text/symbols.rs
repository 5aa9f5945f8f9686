//! Symbols of a gear drawing and short forms in place of the keys of a case file.
//!
//! A symbol is read in the table of its key (`gears.z`) or, if only one table has it, above all tables (`z`). Where both
//! the symbol and its key are written, the symbol stays an unknown key.

use toml::{Table, Value};

/// A key with its symbols, and the tables that have it.
struct Row {
    tables: &'static [&'static str],
    symbols: &'static [&'static str],
    key: &'static str,
}

const fn row(
    tables: &'static [&'static str],
    symbols: &'static [&'static str],
    key: &'static str,
) -> Row {
    Row {
        tables,
        symbols,
        key,
    }
}

/// Tables of a pair of gears, of each flank, of a steel, of the operation, of the oil and of its viscosity.
const GEARS: &[&str] = &["gears", "planetary"];
const FLANK: &[&str] = &["gears.pinion", "gears.wheel"];
const STEEL: &[&str] = &["material.pinion", "material.wheel"];
const OPERATION: &[&str] = &["operation"];
const OIL: &[&str] = &["lubricant"];
const VISCOSITY: &[&str] = &["lubricant.viscosity"];

/// The keys that have symbols.
#[rustfmt::skip]
const SYMBOLS: &[Row] = &[
    row(GEARS, &["z"], "teeth"),
    row(GEARS, &["m_n", "mn", "m"], "module"),
    row(GEARS, &["b"], "face_width"),
    row(GEARS, &["a"], "centre_distance"),
    row(GEARS, &["x"], "profile_shift"),
    row(GEARS, &["alpha_n", "alpha", "α_n", "α"], "pressure_angle"),
    row(GEARS, &["beta", "β"], "helix"),
    row(GEARS, &["d_a", "da"], "tip_diameter"),
    row(GEARS, &["h_aP"], "addendum"),
    row(FLANK, &["C_a"], "tip_relief"),
    row(FLANK, &["C_beta", "C_β"], "crowning"),
    row(FLANK, &["h_fP"], "dedendum"),
    row(FLANK, &["rho_fP", "ρ_fP"], "fillet_radius"),
    row(STEEL, &["E"], "young"),
    row(STEEL, &["nu", "ν"], "poisson"),
    row(OPERATION, &["n", "rpm"], "speed"),
    row(OPERATION, &["T"], "torque"),
    row(OPERATION, &["theta", "ϑ"], "bulk_temperature"),
    row(OIL, &["oil"], "oil"),
    row(OIL, &["rho", "ρ"], "density"),
    row(OIL, &["nu", "ν"], "viscosity"),
    row(VISCOSITY, &["nu_40", "ν_40"], "at_40"),
    row(VISCOSITY, &["nu_100", "ν_100"], "at_100"),
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

/// Path of the key for the symbol `name` in the table `above`; `None` if it is not a symbol.
pub(super) fn key_of_symbol(above: &str, name: &str) -> Option<String> {
    let of = |table: &&str| {
        let rows = SYMBOLS.iter();
        let mut found =
            rows.filter(|row| row.tables.contains(table) && row.symbols.contains(&name));
        found.next().map(|row| format!("{table}.{}", row.key))
    };
    let key = match above {
        "" => OF_A_CASE.iter().find_map(of),
        above => of(&above),
    };
    key.filter(|key| above.is_empty() || !key.ends_with(&format!(".{name}")))
}

/// The key among `known` that `name` is a symbol of.
pub(super) fn key_named<'a>(
    name: &str,
    mut known: impl Iterator<Item = &'a str>,
) -> Option<&'a str> {
    let is_of = |row: &Row, key: &str| row.key == key && row.symbols.contains(&name);
    known.find(|key| SYMBOLS.iter().any(|row| is_of(row, key)))
}

/// The symbols of a drawing with their keys, for the page of the case file.
pub(super) fn listed() -> String {
    let shown = SYMBOLS.iter().filter(|row| !row.symbols.contains(&row.key));
    let rows = shown.map(|row| {
        let symbols: Vec<String> = row.symbols.iter().map(|name| format!("`{name}`")).collect();
        format!(
            "{} for `{}.{}`",
            symbols.join(" or "),
            row.tables[0],
            row.key
        )
    });
    rows.collect::<Vec<_>>().join(", ")
}

/// Path of the file key for a text at the path of a flank; `None` elsewhere.
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

/// Names the law of a viscosity that is stated by the two values of a data sheet alone, or by grade and index.
pub(super) fn name_viscosity_law(root: &mut Table) {
    let Some((viscosity, law)) = parent(root, "lubricant.viscosity.law", false) else {
        return;
    };
    // "ISO VG 100" is the number of its grade.
    if let Some(text) = viscosity.get("grade").and_then(Value::as_str)
        && let Ok(grade) = text
            .trim_start_matches(|c: char| !c.is_ascii_digit())
            .parse::<f64>()
    {
        viscosity.insert("grade".to_owned(), Value::from(grade));
    }
    if viscosity.contains_key(law) {
        return;
    }
    let named = [
        ("at_40", "astm-d341"),
        ("at_100", "astm-d341"),
        ("grade", "iso-vg"),
    ];
    if let Some((_, name)) = named.iter().find(|(key, _)| viscosity.contains_key(*key)) {
        viscosity.insert(law.to_owned(), Value::from(*name));
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
            let symbol = (SYMBOLS.iter())
                .find(|row| row.tables.contains(&above) && row.key == name)
                .map(|row| row.symbols[0]);
            let value = match value {
                Value::Table(inner) => Value::Table(drawn(inner, &path, is_flat, top)),
                value => value,
            };
            match symbol {
                Some(symbol) if is_flat && OF_A_CASE.contains(&above) => {
                    top.insert(symbol.to_owned(), value);
                }
                Some(symbol) => {
                    out.insert(symbol.to_owned(), value);
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
    fn two_viscosities_of_a_data_sheet_need_no_law() {
        let text = |viscosity: &str| {
            format!(
                "gears = {{ teeth = [23, 68], module = \"2 mm\", face_width = \"30 mm\" }}\n\
             operation = {{ torque = \"100 N m\", speed = \"3000 1/min\", bulk_temperature = \"60 °C\" }}\n\
             lubricant = {{ viscosity = {{ {viscosity} }}, density = \"865 kg/m3\" }}\n\
             surface = {{ pinion = {{ rq = \"0.3 um\" }} }}\n"
            )
        };
        let both = "at_40 = \"68 mm2/s\", at_100 = \"10.4 mm2/s\"";
        let short: CaseInput = text(both).parse().unwrap();
        let named = text(&format!("law = \"astm-d341\", {both}"));
        assert_eq!(short, named.parse().unwrap());
        let grade = text("grade = \"ISO VG 68\", viscosity_index = 100");
        let number = text("law = \"iso-vg\", grade = 68, viscosity_index = 100");
        let [grade, number] = [grade, number].map(|text| text.parse::<CaseInput>().unwrap());
        assert_eq!(grade, number);
        let refused = text("at_40 = \"68 mm2/s\"")
            .parse::<CaseInput>()
            .unwrap_err()
            .to_string();
        assert!(refused.contains("at_100"), "{refused}");
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
