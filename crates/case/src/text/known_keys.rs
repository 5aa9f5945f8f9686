//! Unknown keys with the nearest known key, from the schema of the case file.

use serde_json::Value;

use super::symbols::key_named;
use asperity_core::most_similar;

/// Depth of the tables in which a key is searched: `surface.pinion.file` is in a table of a table.
const DEPTH: usize = 2;

/// The first key of `paths` that is not in the schema, with the nearest key of its table, or the path of the key in another
/// table.
pub(crate) fn first_unknown<'a>(
    schema: &Value,
    paths: impl Iterator<Item = &'a str>,
) -> Option<(&'a str, Option<String>)> {
    paths.filter_map(|path| unknown_at(schema, path)).next()
}

fn unknown_at<'a>(schema: &Value, path: &'a str) -> Option<(&'a str, Option<String>)> {
    let mut nodes = vec![schema];
    for segment in path.split('.') {
        let candidates: Vec<&Value> = nodes
            .iter()
            .flat_map(|node| objects(schema, node))
            .collect();
        if candidates.is_empty() {
            // The value is a table of a law with parameters, which serde checks.
            return None;
        }
        let next: Vec<&Value> = candidates
            .iter()
            .filter_map(|object| value_of(object, segment))
            .collect();
        if next.is_empty() {
            let known = candidates.iter().flat_map(|object| properties(object));
            let meant =
                nearest(segment, known).or_else(|| in_another_table(schema, own_name(segment)));
            return Some((path, meant));
        }
        nodes = next;
    }
    None
}

/// Table that a calibration writes; most of its keys have the names of keys elsewhere.
const WRITTEN_BY_PROGRAM: &str = "calibration.";

/// The path of the key with this name in another table, if only one table at the least depth has it. A table that is written by
/// hand comes before that of a calibration.
fn in_another_table(schema: &Value, name: &str) -> Option<String> {
    let mut paths = Vec::new();
    let mut tables = vec![(String::new(), schema, 0)];
    while let Some((above, node, depth)) = tables.pop() {
        for object in objects(schema, node) {
            for key in properties(object) {
                let path = format!("{above}{key}");
                if depth < DEPTH
                    && let Some(value) = value_of(object, key)
                {
                    tables.push((format!("{path}."), value, depth + 1));
                }
                if key == name && !paths.contains(&path) {
                    paths.push(path);
                }
            }
        }
    }
    let depth = |path: &String| path.matches('.').count();
    let least = paths.iter().map(depth).min()?;
    paths.retain(|path| depth(path) == least);
    if paths.len() > 1 {
        paths.retain(|path| !path.starts_with(WRITTEN_BY_PROGRAM));
    }
    match &mut paths[..] {
        [path] => Some(std::mem::take(path)),
        _ => None,
    }
}

/// The schema of the value at `path`.
pub(crate) fn property<'a>(schema: &'a Value, path: &str) -> Option<&'a Value> {
    path.split('.').try_fold(schema, |node, segment| {
        objects(schema, node)
            .into_iter()
            .find_map(|object| value_of(object, segment))
    })
}

/// The keys that a table at `path` must have; empty if it has alternatives.
pub(crate) fn required<'a>(schema: &'a Value, path: &str) -> Vec<&'a str> {
    let found = property(schema, path).map(|node| objects(schema, node));
    let [object] = found.as_deref().unwrap_or_default() else {
        return Vec::new();
    };
    let names = object.get("required").and_then(Value::as_array);
    names
        .into_iter()
        .flatten()
        .filter_map(Value::as_str)
        .collect()
}

/// The schema of the key `name` in an object; the keys of some objects are names of the user's choice.
fn value_of<'a>(object: &'a Value, name: &str) -> Option<&'a Value> {
    let of_properties = object.get("properties").and_then(|keys| keys.get(name));
    of_properties.or_else(|| named_values(object))
}

/// The schema of all values in an object whose keys are names of the user's choice.
fn named_values(object: &Value) -> Option<&Value> {
    object
        .get("additionalProperties")
        .filter(|values| values.is_object())
}

/// The object schemas of `node`, with its references and alternatives resolved.
fn objects<'a>(schema: &'a Value, node: &'a Value) -> Vec<&'a Value> {
    if node.get("properties").is_some() || named_values(node).is_some() {
        return vec![node];
    }
    if let Some(name) = node
        .get("$ref")
        .and_then(Value::as_str)
        .and_then(|reference| reference.strip_prefix("#/$defs/"))
    {
        return schema["$defs"]
            .get(name)
            .map(|definition| objects(schema, definition))
            .unwrap_or_default();
    }
    if let Some(items) = node.get("items") {
        return objects(schema, items);
    }
    ["anyOf", "oneOf", "allOf"]
        .iter()
        .filter_map(|key| node.get(*key)?.as_array())
        .flatten()
        .flat_map(|alternative| objects(schema, alternative))
        .collect()
}

fn properties(object: &Value) -> impl Iterator<Item = &str> + Clone {
    object
        .get("properties")
        .and_then(Value::as_object)
        .into_iter()
        .flat_map(|map| map.keys().map(String::as_str))
}

/// Names of a key in other programs and texts, with the name here.
const OTHER_NAMES: [(&str, &str); 7] = [
    ("load_sharing", "load_distribution"),
    ("friction", "film_friction"),
    ("friction_law", "film_friction"),
    ("sump_temperature", "oil_temperature"),
    ("flank_temperature", "bulk_temperature"),
    ("temperature", "bulk_temperature"),
    ("width", "face_width"),
];

/// The name here of a key by another name of it.
fn own_name(seen: &str) -> &str {
    let mut others = OTHER_NAMES.iter();
    others
        .find_map(|(other, ours)| (*other == seen).then_some(*ours))
        .unwrap_or(seen)
}

/// The known key for another name of it, else the key most similar to `seen`; `None` if no key is similar.
pub(crate) fn nearest<'a>(
    seen: &str,
    known: impl Iterator<Item = &'a str> + Clone,
) -> Option<String> {
    if let Some(key) = key_named(seen, known.clone()) {
        return Some(key.to_owned());
    }
    let ours = own_name(seen);
    if known.clone().any(|key| key == ours) {
        return Some(ours.to_owned());
    }
    most_similar(seen, known).map(str::to_owned)
}
