//! Gears, steels and oils by name.

use asperity::core::presets;
use asperity::message::Fault;
use asperity::oil::library as oils;
use serde_json::{Map, Value, json};

use crate::failure::Failure;

/// The libraries as JSON: each entry with its name and a note, gears with their keys of a case.
///
/// # Errors
/// When a library is damaged.
pub fn library() -> Result<String, Failure> {
    let oils = oils().map_err(Fault::internal)?;
    let oils = oils
        .iter()
        .map(|oil| json!({ "name": oil.name, "note": format!("{} ({})", oil.note, oil.source) }));
    let steels = presets::steels().map_err(Fault::internal)?;
    let steels = steels.iter().map(
        |steel| json!({ "name": steel.name, "note": format!("{}. {}", steel.treatment, steel.note) }),
    );
    let mut gears = Vec::new();
    for preset in presets::gears().map_err(Fault::internal)? {
        let mut keys = Map::new();
        for row in preset.rows() {
            // The values are lists and texts, which TOML and JSON write alike.
            put(&mut keys, row.key, serde_json::from_str(&row.value)?);
        }
        gears.push(json!({
            "name": preset.name, "title": preset.title, "note": preset.note, "keys": keys,
        }));
    }
    let all = json!({
        "oils": oils.collect::<Vec<_>>(), "steels": steels.collect::<Vec<_>>(), "gears": gears,
    });
    Ok(all.to_string())
}

/// Puts `value` at a path of two keys.
fn put(tables: &mut Map<String, Value>, path: &str, value: Value) {
    let (table, key) = path.split_once('.').unwrap_or((path, ""));
    tables.entry(table).or_insert_with(|| json!({}))[key] = value;
}
