//! Shared by `gears`, `steels` and `oils`: the numbers of a preset with certainty and source.

use std::collections::BTreeSet;

use asperity::case::nearest_name;
use asperity_core::presets::{FigureRow, PresetError, PresetSource, sources};
use asperity_report::wrapped;
use serde_json::{Value, json};

use crate::failure::Failure;

/// Legend of the certainty letters.
pub const LETTERS: &str = "Certainty: A read in the source, B quoted by others, C derived; assumed: not\nknown of this one.";

/// Error of a preset.
pub fn refused(error: &PresetError) -> Failure {
    match error {
        PresetError::Unknown { kind, name, known } => {
            unknown(if *kind == "steels" { "steel" } else { kind }, name, known)
        }
        error => Failure::new("E501", error.to_string()),
    }
}

/// Error of an unknown name, with the most similar known name.
pub fn unknown(kind: &str, name: &str, known: &[String]) -> Failure {
    let similar = nearest_name(name, known);
    let suggestion = similar.map_or(".".to_owned(), |name| format!(". Did you mean \"{name}\"?"));
    let known = known.join(", ");
    Failure::new(
        "E220",
        format!("the library has no {kind} named \"{name}\"{suggestion} It has: {known}"),
    )
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

/// Sources of the numbers.
pub fn used(rows: &[FigureRow<'_>]) -> Result<Vec<PresetSource>, Failure> {
    let keys: BTreeSet<&str> = rows.iter().map(|row| row.source).collect();
    let all = sources().map_err(|error| refused(&error))?;
    let is_used = |source: &PresetSource| keys.contains(source.key.as_str());
    Ok(all.into_iter().filter(is_used).collect())
}

/// Numbers and sources as JSON.
pub fn figures_json(rows: &[FigureRow<'_>]) -> Result<(Value, Value), Failure> {
    Ok((json!(rows), json!(used(rows)?)))
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
