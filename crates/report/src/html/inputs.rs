//! Inputs: the case with its defaults, files, equations and sources.

use crate::{Cell, columns, error};
use asperity::result::FlankRecord;
use asperity::result::RunResult;
use asperity_core::Fault;
use asperity_storage::json_value;
use maud::{Markup, html};
use serde_json::Value;

pub(super) fn section(result: &RunResult) -> Result<Markup, Fault> {
    let rows = keys(result)?;
    Ok(html! {
        p { (result.defaults.len()) " defaults. Values marked " span.default { "default" } " are not stated in the case." }
        (columns! { row in &rows;
            head key "key" "" = Cell::code(&row.key);
            text value "value" "";
            text origin "from" "" = from(row.origin.as_deref());
        }.classed("inputs"))
        (files(result))
        (equations(result))
    })
}

/// "stated", or the mark of a default with its source.
fn from(origin: Option<&str>) -> Cell {
    let Some(source) = origin else {
        return "stated".into();
    };
    let markup = html! { span.default { "default" } @if !source.is_empty() { " " (source) } };
    Cell::marked(format!("default {source}"), markup)
}

struct KeyRow {
    key: String,
    value: String,
    /// Source of a default; `None` for a value of the case.
    origin: Option<String>,
}

fn keys(result: &RunResult) -> Result<Vec<KeyRow>, Fault> {
    let mut rows = Vec::new();
    flatten(
        "",
        &json_value(&result.inputs).map_err(error::of_json)?,
        &mut rows,
    );
    for entry in &result.defaults {
        rows.push(KeyRow {
            key: entry.key.to_string(),
            value: match serde_json::from_str(&entry.value) {
                Ok(value) => listed(&value),
                Err(_) => entry.value.clone(),
            },
            origin: Some(entry.source.as_deref().unwrap_or_default().to_owned()),
        });
    }
    rows.sort_by(|a, b| a.key.cmp(&b.key));
    Ok(rows)
}

/// Appends all given values with the paths of their keys.
fn flatten(path: &str, value: &Value, rows: &mut Vec<KeyRow>) {
    match value {
        Value::Null => {}
        Value::Object(entries) => {
            for (name, inner) in entries {
                let key = if path.is_empty() {
                    name.clone()
                } else {
                    format!("{path}.{name}")
                };
                flatten(&key, inner, rows);
            }
        }
        given => rows.push(KeyRow {
            key: path.to_owned(),
            value: listed(given),
            origin: None,
        }),
    }
}

/// A value, or the values of a list, with at most six significant digits.
fn listed(value: &Value) -> String {
    match value {
        Value::Array(items) => items.iter().map(listed).collect::<Vec<_>>().join(", "),
        Value::String(text) => text.clone(),
        Value::Number(number) if number.is_f64() => {
            let rounded = number.as_f64().map(|value| format!("{value:.5e}"));
            let rounded: Option<f64> = rounded.and_then(|text| text.parse().ok());
            rounded.map_or_else(
                || number.to_string(),
                |value| {
                    if (1e-4..1e7).contains(&value.abs()) || value == 0.0 {
                        value.to_string()
                    } else {
                        format!("{value:e}")
                    }
                },
            )
        }
        other => other.to_string(),
    }
}

fn files(result: &RunResult) -> Markup {
    let records: Vec<&FlankRecord> = match &result.pairs {
        Some(pairs) => pairs
            .traces
            .iter()
            .flatten()
            .map(|trace| &trace.record)
            .collect(),
        None => result.flanks.iter().collect(),
    };
    let flanks = records.iter().filter_map(|flank| {
        let sum = flank.sha256.as_deref().unwrap_or("–");
        Some((flank.file.as_deref()?, sum))
    });
    let mut measured: Vec<(&str, &str)> = Vec::new();
    let like = records.iter().filter_map(|flank| flank.generated.as_ref());
    for trace in like.flat_map(|made| made.like.iter().chain(&made.after)) {
        let row = (trace.file.as_str(), trace.sha256.as_str());
        if !measured.contains(&row) {
            measured.push(row);
        }
    }
    let flanks = flanks.chain(measured);
    html! {
        h3 { "Provenance" }
        p { "Made by " (result.program) ", schema version " (result.schema_version) "." }
        (columns! { row in flanks;
            code file "file" "" = row.0;
            code sum "SHA-256" "" = row.1;
        })
    }
}

fn equations(result: &RunResult) -> Markup {
    html! {
        details {
            summary { "Equations used (" (result.equations.len()) ")" }
            ul.references { @for entry in &result.equations {
                li { code { "[" (entry.tag) "]" } " " (entry.title) }
            } }
        }
        h3 { "References" }
        ol.references { @for entry in &result.references { li { (entry.text) } } }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn values_have_at_most_six_digits() {
        let texts = [
            json!(1.0 / 12.0),
            json!([0.0, 0.5]),
            json!("23.4 deg"),
            json!(1e-8),
            json!(24),
        ];
        let shown = ["0.0833333", "0, 0.5", "23.4 deg", "1e-8", "24"];
        assert_eq!(texts.each_ref().map(listed), shown);
    }
}
