//! Shared by `gears`, `steels` and `oils`: the numbers of a preset with certainty and source.

use asperity_core::Fault;
use asperity_core::presets::FigureRow;
use asperity_report::library::used;
use asperity_report::wrapped;
use serde_json::{Value, json};

use crate::args::Common;
use crate::failure::Failure;
use crate::output::{print_json, print_text};

/// Legend of the certainty letters.
pub const LETTERS: &str = "Certainty: A read in the source, B quoted by others, C derived; assumed: not\nknown of this one.";

/// Prints presets: their values as JSON under a name, or a text.
pub fn print_listed<T>(
    common: &Common,
    (name, presets): (&str, &[T]),
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
    let mut text = String::new();
    for row in rows {
        let note = row.note.map_or(String::new(), |note| format!("  ({note})"));
        let line = format!(
            "  {:22} {:24} {:8} {}{note}",
            row.key, row.value, row.certainty, row.source
        );
        text.push_str(&wrapped(&line, "      "));
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

/// Distinct keys of the sources, in the order of the numbers.
pub fn keys<'a>(rows: &[FigureRow<'a>]) -> String {
    let mut sources: Vec<&str> = Vec::new();
    for row in rows {
        if !sources.contains(&row.source) {
            sources.push(row.source);
        }
    }
    sources.join(", ")
}
