//! The page docs/CASE_FILE.md: every key of a case file, made from its schema.

use std::collections::BTreeMap;

use asperity_core::unique;
use serde_json::Value;

use super::load_case::from_text;
use crate::error::Error;
use crate::input::key_ranges::{range_of, relations};
use crate::text::case_file::schema;
use crate::text::symbols;

/// The shortest case: the keys that it leaves out show the defaults.
const SHORTEST: &str = r#"
gears = { teeth = [23, 68], module = "2 mm", face_width = "30 mm" }
operation = { torque = "100 N m", speed = "3000 1/min", bulk_temperature = "60 °C" }
lubricant = { oil = "m100" }
surface = { pinion = { file = "flank", dx = "0.5 um", z_unit = "um" } }
"#;

const HEAD: &str = "\
# The case file

Made by `asperity schema --markdown` from the schema of the case file; a test checks that it is up to date.

A case is a TOML file (or JSON with the same keys). Quantities are text with a unit, e.g. `\"1.8 mm\"`; file names are
relative to the case file. `asperity check case.toml` lists all errors at once and the defaults that a run would use;
`--set key=value` sets any of these keys on the command line.

The column \"default\" shows what the shortest possible case uses, in the formulation `corrected`; \"-\" means that the key is
required, has no default, or takes its default as its description says. A value outside the usual range raises warning
W201; the case still runs.
";

const RELATIONS: &str = "\
Quantities that follow from several keys, with the same warning; so have the Hertz pressure at the pitch point and the \
pitch-line speed.
";

const SYMBOLS: &str = "\
The symbols of a gear drawing are read as these keys (W202 names each). Those of `gears`, `operation` and `lubricant` may \
also be written above all tables: `z = [23, 68]`. A text instead of a flank is its file: `surface.pinion = \"flank.csv\"`. \
";

const TAIL: &str = "\
## Coefficients of Xu's law

`model.film_friction = { xu = \"file.json\" }` names a JSON file with the coefficients of your own calibration:

```json
{
  \"source\": \"own twin-disc tests, 2024\",
  \"oil\": \"0W-20 transmission fluid\",
  \"coefficients\": {
    \"b1\": -8.9, \"b2\": 1.0, \"b3\": 1.0, \"b4\": -0.35, \"b5\": 2.8, \"b6\": -0.1, \"b7\": 0.75, \"b8\": -0.39, \"b9\": 0.62
  }
}
```
";

/// A key with its row of the page.
struct PageKey {
    path: String,
    takes: String,
    meaning: String,
}

/// The page.
///
/// # Errors
/// When the shortest case cannot be completed, which a test excludes.
///
/// ```
/// let page = asperity_case::case::markdown()?;
/// assert!(page.contains("| `operation.torque` |"));
/// # Ok::<(), asperity_case::error::Error>(())
/// ```
pub fn markdown() -> Result<String, Error> {
    let flank: String = (0..4000)
        .map(|i| format!("{:.4}\n", (0.3 * f64::from(i)).sin()))
        .collect();
    let shortest = from_text("case.toml", SHORTEST, &|_| Ok(flank.clone().into_bytes()))?;
    let defaults: BTreeMap<&str, &str> = shortest
        .case
        .defaults
        .iter()
        .map(|default| (&*default.key, default.value.as_str()))
        .collect();
    let schema = schema();
    let mut page = HEAD.to_owned();
    let tables = properties(&schema, &schema);
    let (tables, keys): (Vec<_>, Vec<_>) = tables
        .into_iter()
        .partition(|(_, node)| is_table(&schema, node));
    let top: Vec<PageKey> = keys
        .into_iter()
        .map(|(name, node)| key(&schema, name, node))
        .collect();
    section(&mut page, "Top of the file", "", &top, &defaults);
    for (name, node) in tables {
        let mut keys = Vec::new();
        collect(&schema, name, node, &mut keys);
        section(
            &mut page,
            &format!("[{name}]"),
            &text_of(node),
            &keys,
            &defaults,
        );
    }
    page.push_str("\n## Relations between keys\n\n");
    page.push_str(RELATIONS);
    page.push_str("\n| key | quantity | usual |\n|---|---|---|\n");
    for [key, quantity, usual] in relations() {
        page.push_str(&format!("| `{key}` | {quantity} | {usual} |\n"));
    }
    page.push_str(&format!(
        "\n## Symbols of a drawing\n\n{SYMBOLS}{}.\n",
        symbols::listed()
    ));
    page.push('\n');
    page.push_str(TAIL);
    Ok(page)
}

fn section(
    page: &mut String,
    title: &str,
    text: &str,
    keys: &[PageKey],
    defaults: &BTreeMap<&str, &str>,
) {
    page.push_str(&format!("\n## {title}\n\n"));
    if !text.is_empty() {
        page.push_str(&format!("{text}\n\n"));
    }
    page.push_str("| key | takes | default | usual | meaning |\n|---|---|---|---|---|\n");
    for key in keys {
        let default = defaults
            .get(key.path.as_str())
            .map_or("-".to_owned(), |value| format!("`{value}`"));
        let usual = range_of(&key.path).map_or_else(String::new, |range| range.usual());
        page.push_str(&format!(
            "| `{}` | {} | {default} | {usual} | {} |\n",
            key.path, key.takes, key.meaning
        ));
    }
}

/// The keys below `node`, with tables opened; the flank of the pinion describes that of the wheel.
fn collect(schema: &Value, path: &str, node: &Value, keys: &mut Vec<PageKey>) {
    for (name, inner) in properties(schema, node) {
        let path = format!("{path}.{name}");
        let is_twin = matches!(
            path.as_str(),
            "surface.wheel" | "surface.coast.pinion" | "surface.coast.wheel" | "material.wheel"
        );
        if is_table(schema, inner) && !is_twin {
            collect(schema, &path, inner, keys);
        } else if is_twin {
            keys.push(PageKey {
                takes: "the keys of the pinion".to_owned(),
                meaning: text_of(inner),
                path,
            });
        } else {
            keys.push(key(schema, &path, inner));
        }
    }
}

fn key(schema: &Value, path: &str, node: &Value) -> PageKey {
    PageKey {
        path: path.to_owned(),
        takes: takes(schema, node),
        meaning: text_of(node),
    }
}

/// A node with its references followed, without the alternative `null`.
fn resolved<'a>(schema: &'a Value, node: &'a Value) -> Vec<&'a Value> {
    if let Some(name) = node.get("$ref").and_then(Value::as_str) {
        let name = name.trim_start_matches("#/$defs/");
        let definition = schema["$defs"].get(name);
        return definition.map_or(Vec::new(), |node| resolved(schema, node));
    }
    for kind in ["anyOf", "oneOf", "allOf"] {
        if let Some(inner) = node.get(kind).and_then(Value::as_array) {
            let is_there = |node: &&Value| node.get("type").and_then(Value::as_str) != Some("null");
            let inner = inner.iter().filter(is_there);
            return inner.flat_map(|node| resolved(schema, node)).collect();
        }
    }
    vec![node]
}

/// Whether a value is one table with fixed keys, and nothing else.
fn is_table(schema: &Value, node: &Value) -> bool {
    matches!(resolved(schema, node)[..], [one] if one.get("properties").is_some())
}

fn properties<'a>(schema: &'a Value, node: &'a Value) -> Vec<(&'a str, &'a Value)> {
    let fields = |node: &'a Value| node.get("properties")?.as_object();
    let tables = resolved(schema, node).into_iter().filter_map(fields);
    tables
        .flatten()
        .map(|(name, node)| (name.as_str(), node))
        .collect()
}

fn text_of(node: &Value) -> String {
    let text = node
        .get("description")
        .and_then(Value::as_str)
        .unwrap_or_default();
    text.replace('\n', " ").replace('|', "\\|")
}

/// Values a key accepts, in words.
fn takes(schema: &Value, node: &Value) -> String {
    let nodes = resolved(schema, node).into_iter();
    unique(nodes.map(|node| kind(schema, node))).join(", ")
}

fn kind(schema: &Value, node: &Value) -> String {
    if let Some(name) = node.get("const").and_then(Value::as_str) {
        return format!("`{name}`");
    }
    if let Some(names) = node.get("enum").and_then(Value::as_array) {
        let names = names.iter().filter_map(Value::as_str);
        return names
            .map(|name| format!("`{name}`"))
            .collect::<Vec<_>>()
            .join(", ");
    }
    if let Some(fields) = node.get("properties").and_then(Value::as_object) {
        let law = fields.get("law").and_then(|law| law.get("const")?.as_str());
        let names: Vec<String> = fields
            .iter()
            .map(|(name, _)| match (name.as_str(), law) {
                ("law", Some(law)) => format!("law = \"{law}\""),
                (name, _) => name.to_owned(),
            })
            .collect();
        return format!("`{{ {} }}`", names.join(", "));
    }
    let kind = match node.get("type") {
        Some(Value::String(kind)) => kind.as_str(),
        Some(Value::Array(kinds)) => kinds
            .iter()
            .filter_map(Value::as_str)
            .find(|kind| *kind != "null")
            .unwrap_or_default(),
        _ => "",
    };
    match kind {
        "string" => match text_of(node) {
            text if text.contains("with a unit") => text,
            _ => "text".to_owned(),
        },
        "number" => "number".to_owned(),
        "integer" => "whole number".to_owned(),
        "boolean" => "`true`, `false`".to_owned(),
        "array" => {
            let items = node
                .get("items")
                .or_else(|| node.get("prefixItems")?.get(0));
            match items {
                Some(items) => format!("list of {}", takes(schema, items)),
                None => "list".to_owned(),
            }
        }
        _ => "value".to_owned(),
    }
}
