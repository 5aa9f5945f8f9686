//! Inputs: the case with its defaults, files, equations and sources.

use asperity::result::FlankRecord;
use asperity::result::RunResult;
use maud::{Markup, html};
use serde_json::Value;

use crate::error::ReportError;

pub(super) fn section(result: &RunResult) -> Result<Markup, ReportError> {
    let rows = keys(result)?;
    Ok(html! {
        p { (result.defaults.len()) " defaults. Values marked " span.default { "default" } " are not stated in the case." }
        div.scroll { table.inputs {
            thead { tr { th { "key" } th { "value" } th { "from" } } }
            tbody {
                @for row in &rows {
                    tr {
                        th scope="row" { code { (row.key) } } td { (row.value) }
                        td { @match &row.origin {
                            None => "stated",
                            Some(source) if source.is_empty() => span.default { "default" },
                            Some(source) => { span.default { "default" } " " (source) },
                        } }
                    }
                }
            }
        } }
        (files(result))
        (equations(result))
    })
}

struct KeyRow {
    key: String,
    value: String,
    /// Source of a default; `None` for a value of the case.
    origin: Option<String>,
}

fn keys(result: &RunResult) -> Result<Vec<KeyRow>, ReportError> {
    let mut rows = Vec::new();
    flatten("", &serde_json::to_value(&result.inputs)?, &mut rows);
    for entry in &result.defaults {
        rows.push(KeyRow {
            key: entry.key.to_string(),
            value: entry.value.replace('"', ""),
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
        Value::Array(items) => {
            let texts: Vec<String> = items.iter().map(plain).collect();
            rows.push(KeyRow {
                key: path.to_owned(),
                value: texts.join(", "),
                origin: None,
            });
        }
        single => rows.push(KeyRow {
            key: path.to_owned(),
            value: plain(single),
            origin: None,
        }),
    }
}

fn plain(value: &Value) -> String {
    value
        .as_str()
        .map_or_else(|| value.to_string(), str::to_owned)
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
    let flanks = records.into_iter().filter_map(|flank| {
        let sum = flank.sha256.as_deref().unwrap_or("–");
        Some((flank.file.as_deref()?, sum))
    });
    html! {
        h3 { "Provenance" }
        p { "Made by " (result.program) ", schema version " (result.schema_version) "." }
        div.scroll { table {
            thead { tr { th { "file" } th { "SHA-256" } } }
            tbody { @for (file, sum) in flanks {
                tr { td { code { (file) } } td { code { (sum) } } }
            } }
        } }
    }
}

fn equations(result: &RunResult) -> Markup {
    html! {
        details {
            summary { "Equations used (" (result.equations.len()) ")" }
            ul { @for entry in &result.equations {
                li { code { "[" (entry.tag) "]" } " " (entry.title) }
            } }
        }
        h3 { "References" }
        ol.references { @for entry in &result.references { li { (entry.text) } } }
    }
}
