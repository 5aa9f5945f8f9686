//! Messages of the TOML and JSON parsers, in words of the case file instead of Rust.

use asperity_core::type_in_words;
use serde_json::Value;

use super::known_keys::{property, required};

/// `message` of a parser about the value of `key`, with the meaning of the key in the schema.
pub(crate) fn plain(schema: &Value, key: Option<&str>, message: &str) -> String {
    if let Some(missing) = between(message, "missing field `", "`") {
        let path = key.map_or(missing.to_owned(), |table| format!("{table}.{missing}"));
        let said = format!("missing key \"{missing}\"{}", meaning(schema, &path));
        // All of them at once: the parser stops at the first that is missing.
        let needed = key.map(|table| required(schema, table)).unwrap_or_default();
        return match needed.as_slice() {
            [] | [_] => said,
            needed => format!("{said}; the table needs {}", needed.join(", ")),
        };
    }
    let meaning = key.map(|key| meaning(schema, key)).unwrap_or_default();
    if let Some(rest) = message.strip_prefix("unknown variant ") {
        return format!("unknown choice {rest}{meaning}");
    }
    if message.starts_with("data did not match any variant") {
        return format!("the value does not fit{meaning}");
    }
    for kind in ["invalid type: ", "invalid value: ", "invalid length "] {
        let parts = message
            .strip_prefix(kind)
            .and_then(|rest| rest.split_once(", expected "));
        let Some((seen, expected)) = parts else {
            continue;
        };
        let seen = match (kind, seen) {
            ("invalid length ", "1") => "1 value",
            ("invalid length ", count) => &format!("{count} values"),
            (_, "map") => "a table",
            (_, "sequence") => "a list",
            (_, seen) => seen,
        };
        if key == Some("lubricant.viscosity") && seen.to_lowercase().contains("vg") {
            return format!(
                "{seen} states the viscosity at 40 °C only; write both values of the data sheet, \
                 {{ at_40 = \"100 mm2/s\", at_100 = \"11.2 mm2/s\" }}, or the viscosity index, \
                 {{ grade = 100, viscosity_index = 95 }}, or name an oil of the library"
            );
        }
        return format!(
            "{seen} does not fit, expected {}{meaning}",
            type_in_words(expected)
        );
    }
    message.to_owned()
}

/// Description of a key in the schema, in brackets.
fn meaning(schema: &Value, key: &str) -> String {
    let Some(node) = property(schema, key) else {
        return String::new();
    };
    let text = |node: &Value| {
        let description = node.get("description")?.as_str()?;
        let first = description.split("\n\n").next()?.replace('\n', " ");
        Some(first.trim_end_matches('.').to_owned())
    };
    let of_type = node
        .get("$ref")
        .and_then(Value::as_str)
        .and_then(|name| schema["$defs"].get(name.strip_prefix("#/$defs/")?))
        .filter(|node| node.get("type").and_then(Value::as_str) == Some("string"))
        .and_then(text);
    let parts: Vec<String> = [text(node), of_type].into_iter().flatten().collect();
    if parts.is_empty() {
        String::new()
    } else {
        format!(" ({})", parts.join("; "))
    }
}

fn between<'a>(text: &'a str, before: &str, after: &str) -> Option<&'a str> {
    let rest = text.strip_prefix(before)?;
    Some(&rest[..rest.find(after)?])
}
