//! Shared by `gears`, `steels` and `oils`: the numbers of a preset with certainty and source.

use std::collections::BTreeSet;

use asperity::case::nearest_name;
use asperity_core::presets::{FigureRow, PresetError, PresetSource, sources};
use asperity_report::wrapped;
use serde_json::{Value, json};

use crate::failure::Failure;

/// What the letters stand for.
pub const LETTERS: &str = "Certainty: A read in the source, B quoted by others, C derived; assumed: not\nknown of this one.";

/// A preset that cannot be had.
pub fn refused(error: &PresetError) -> Failure {
    match error {
        PresetError::Unknown { kind, name, known } => {
            unknown(if *kind == "steels" { "steel" } else { kind }, name, known)
        }
        error => Failure::new("E501", error.to_string()),
    }
}

/// A name that no preset has, with the one most like it.
pub fn unknown(kind: &str, name: &str, known: &[String]) -> Failure {
    let nearest = nearest_name(name, known);
    let meant = nearest.map_or(".".to_owned(), |name| format!(". Did you mean \"{name}\"?"));
    let known = known.join(", ");
    Failure::new(
        "E220",
        format!("the library has no {kind} named \"{name}\"{meant} It has: {known}"),
    )
}

/// A line per number, then the sources in full.
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

/// The sources that the numbers name.
pub fn used(rows: &[FigureRow<'_>]) -> Result<Vec<PresetSource>, Failure> {
    let keys: BTreeSet<&str> = rows.iter().map(|row| row.source).collect();
    let all = sources().map_err(|error| refused(&error))?;
    let is_used = |source: &PresetSource| keys.contains(source.key.as_str());
    Ok(all.into_iter().filter(is_used).collect())
}

/// The numbers and their sources for programs.
pub fn figures_json(rows: &[FigureRow<'_>]) -> Result<(Value, Value), Failure> {
    Ok((json!(rows), json!(used(rows)?)))
}

/// The least certain of numbers, as their listing shows it.
pub fn least(rows: &[FigureRow<'_>]) -> &'static str {
    let least = rows.iter().map(|row| row.certainty).max();
    least.map_or("", |certainty| certainty.text())
}

/// Keys of the sources, each once, in the order of the numbers.
pub fn keys<'a>(rows: &[FigureRow<'a>]) -> String {
    let mut seen: Vec<&str> = Vec::new();
    for row in rows {
        if !seen.contains(&row.source) {
            seen.push(row.source);
        }
    }
    seen.join(", ")
}
