//! The numbers of an entry of the library with certainty and source.

use asperity_core::Fault;
use asperity_core::presets::FigureRow;
use asperity_report::library::used;
use asperity_report::{columns, wrapped};
use serde_json::{Value, json};

use crate::args::Common;
use crate::failure::Failure;
use crate::output::{print_json, print_text};

/// Legend of the certainty letters.
pub const LETTERS: &str = "Certainty: A read in the source, B quoted by others, C derived; assumed: not\nknown of this one.";

/// Prints presets: their values as JSON under a name, or a text.
pub fn print_listed<T>(
    common: &Common,
    name: &str,
    presets: &[T],
    value: fn(&T) -> Result<Value, Fault>,
    text: impl FnOnce() -> Result<String, Failure>,
) -> Result<(), Failure> {
    if common.json {
        let values: Vec<Value> = presets.iter().map(value).collect::<Result<_, _>>()?;
        return print_json(&json!({ name: values }));
    }
    print_text(common, &text()?)
}

/// One line per number, then the full sources.
pub fn figures(rows: &[FigureRow<'_>]) -> Result<String, Failure> {
    let table = columns! { row in rows;
        head key "key" "";
        text value "value" "";
        text certainty "certainty" "" = row.certainty.to_string();
        text source "source" "";
    };
    let mut text = table.text("  ");
    let noted = rows.iter().filter_map(|row| Some((row.key, row.note?)));
    for (key, note) in noted {
        text.push_str(&wrapped(&format!("  {key}: {note}"), "    "));
        text.push('\n');
    }
    text.push_str("sources\n");
    for source in used(rows)? {
        let line = format!("  {}: {}", source.key, source.text);
        text.push_str(&wrapped(&line, "    "));
        text.push('\n');
    }
    text.push_str(LETTERS);
    text.push('\n');
    Ok(text)
}

/// Lowest certainty of the numbers.
pub fn least(rows: &[FigureRow<'_>]) -> &'static str {
    let least = rows.iter().map(|row| row.certainty).max();
    least.map_or("", |certainty| certainty.text())
}
