//! Symbols of a gear drawing and short forms instead of the keys of a case file.
//!
//! A symbol is read in the table of its key (`gears.z`) or, if only one table has it, above all tables (`z`). Where both
//! the symbol and its key are written, the symbol stays an unknown key.

use toml::{Table, Value};

/// A key with its symbols, and the tables that have it.
struct SymbolRow {
    tables: &'static [&'static str],
    symbols: &'static [&'static str],
    key: &'static str,
}

const fn row(
    tables: &'static [&'static str],
    symbols: &'static [&'static str],
    key: &'static str,
) -> SymbolRow {
    SymbolRow {
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
const SYMBOLS: &[SymbolRow] = &[
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
pub(crate) fn key_of_symbol(above: &str, name: &str) -> Option<String> {
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
pub(crate) fn key_named<'a>(
    name: &str,
    mut known: impl Iterator<Item = &'a str>,
) -> Option<&'a str> {
    let is_of = |row: &SymbolRow, key: &str| row.key == key && row.symbols.contains(&name);
    known.find(|key| SYMBOLS.iter().any(|row| is_of(row, key)))
}

/// The symbols of a drawing with their keys, for the page of the case file.
pub(crate) fn listed() -> String {
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
pub(crate) fn key_of_text(path: &str) -> Option<String> {
    FILES.contains(&path).then(|| format!("{path}.file"))
}

/// `path` with each symbol replaced by its key.
pub(crate) fn with_keys(path: &str) -> String {
    let name = |above: String, part: &str| match key_of_symbol(&above, part) {
        Some(key) => key,
        None if above.is_empty() => part.to_owned(),
        None => format!("{above}.{part}"),
    };
    path.split('.').fold(String::new(), name)
}

/// Moves the value at `from` to `to`, whose tables are made.
pub(crate) fn moved(root: &mut Table, from: &str, to: &str) {
    let Some(value) = parent(root, from, false).and_then(|(table, name)| table.remove(name)) else {
        return;
    };
    if let Some((table, name)) = parent(root, to, true) {
        table.insert(name.to_owned(), value);
    }
}

/// Names the law of a viscosity that is stated by the two values of a data sheet alone, or by grade and index.
pub(crate) fn name_viscosity_law(root: &mut Table) {
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
