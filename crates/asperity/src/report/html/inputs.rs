//! What went in: the case with its defaults, the files, the equations and their sources.

use maud::{Markup, html};
use serde_json::Value;

use super::data::ResultFolder;

pub(super) fn section(result: &ResultFolder) -> Markup {
    let rows = keys(result);
    html! {
        p { "Values marked " span.default { "default" } " were not in the case file." }
        div.scroll { table.inputs {
            thead { tr { th { "key" } th { "value" } th { "from" } } }
            tbody {
                @for row in &rows {
                    tr {
                        th scope="row" { code { (row.key) } } td { (row.value) }
                        td { @match &row.origin {
                            None => "case file",
                            Some(source) if source.is_empty() => span.default { "default" },
                            Some(source) => { span.default { "default" } " " (source) },
                        } }
                    }
                }
            }
        } }
        (files(result))
        (equations(result))
    }
}

struct Row {
    key: String,
    value: String,
    /// None when given; where a default comes from otherwise.
    origin: Option<String>,
}

fn keys(result: &ResultFolder) -> Vec<Row> {
    let mut rows = Vec::new();
    if let Some(inputs) = result.json.get("inputs") {
        flatten("", inputs, &mut rows);
    }
    for entry in result.rows("/defaults") {
        let text = |key: &str| entry[key].as_str().unwrap_or_default().to_owned();
        rows.push(Row {
            key: text("key"),
            value: text("value").replace('"', ""),
            origin: Some(text("source")),
        });
    }
    rows.sort_by(|a, b| a.key.cmp(&b.key));
    rows
}

/// Every value that was given, with the path of its key.
fn flatten(path: &str, value: &Value, rows: &mut Vec<Row>) {
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
            rows.push(Row {
                key: path.to_owned(),
                value: texts.join(", "),
                origin: None,
            });
        }
        single => rows.push(Row {
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

fn files(result: &ResultFolder) -> Markup {
    let flanks = result
        .rows("/flanks")
        .iter()
        .filter(|flank| flank["file"].is_string());
    html! {
        h3 { "Provenance" }
        p { "Made by " (result.text("/program")) ", schema version " (result.number("/schema_version").unwrap_or(0.0)) "." }
        div.scroll { table {
            thead { tr { th { "file" } th { "SHA-256" } } }
            tbody { @for flank in flanks {
                tr { td { code { (plain(&flank["file"])) } } td { code { (plain(&flank["sha256"])) } } }
            } }
        } }
    }
}

fn equations(result: &ResultFolder) -> Markup {
    html! {
        details {
            summary { "Equations used (" (result.rows("/equations").len()) ")" }
            ul { @for entry in result.rows("/equations") {
                li { code { "[" (plain(&entry["tag"])) "]" } " " (plain(&entry["title"])) }
            } }
        }
        h3 { "References" }
        ol.references { @for entry in result.rows("/references") { li { (plain(&entry["text"])) } } }
    }
}
