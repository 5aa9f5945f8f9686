//! The case file: reading, and keys set by their path.

use std::collections::BTreeSet;
use std::sync::LazyLock;

use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::Value as Json;
use toml::{Table, Value};

use super::known_keys::{first_unknown, property};
use super::parsed::from_table;
use super::plain_words::plain;
use super::symbols::with_keys;
use super::written;
use crate::input::case_input::{CaseInput, TEMPERATURE_KEYS};
use crate::source::case_error::CaseError;
use crate::source::source_text::Source;
use asperity_core::Place;

/// A kind of file with keys.
pub(crate) trait CaseFile: Serialize + DeserializeOwned {
    /// The JSON schema of the keys that a text may have.
    fn schema_of(source: &Source) -> &'static Json;

    /// The JSON schema of the keys that it may have.
    fn schema(&self) -> &'static Json;

    /// Reads it from the table of its keys; the key and the message of what cannot be read.
    fn from_keys(table: Table) -> Result<Self, (Option<String>, String)> {
        from_table(table)
    }

    /// The table of its keys.
    fn table(&self) -> Result<Table, toml::ser::Error> {
        written::table(self)
    }

    /// This file, read from the changed keys of `before`, with what `before` has besides keys.
    fn changed_from(self, _before: &Self) -> Self {
        self
    }

    /// The case as the text states it.
    fn read(source: &Source) -> Result<Self, CaseError> {
        let schema = Self::schema_of(source);
        refuse_unknown(schema, source.key_paths(), |key| source.place_of_key(key))?;
        read_table(source.table()?, schema, |key| source.place_of(key))
    }

    /// Sets the key at `path`, which messages report at `place`; an error leaves the case unchanged.
    fn set_at(&mut self, place: Place, path: &str, value: &str) -> Result<(), CaseError> {
        let path = &*with_keys(path);
        refuse_unknown(self.schema(), std::iter::once(path), |_| place.clone())?;
        let typed = typed(value);
        let is_text = typed.is_str();
        let changed = match replaced(self, path, typed, &place) {
            // Text that parses as another type, such as a title of digits.
            Err(_) if !is_text && takes_text(self.schema(), path) => {
                replaced(self, path, Value::String(value.to_owned()), &place)?
            }
            replaced => replaced?,
        };
        *self = changed.changed_from(self);
        Ok(())
    }

    /// Removes the key at `path`, so that its default applies; an error leaves the case unchanged.
    fn unset_at(&mut self, path: &str) -> Result<(), CaseError> {
        let path = &*with_keys(path);
        let place = Source::in_memory().place_of(path);
        refuse_unknown(self.schema(), std::iter::once(path), |_| place.clone())?;
        let mut root = table_of(self, &place)?;
        let (above, last) = path.rsplit_once('.').unwrap_or(("", path));
        let mut table = Some(&mut root);
        for part in above.split('.').filter(|part| !part.is_empty()) {
            table = table.and_then(|table| table.get_mut(part)?.as_table_mut());
        }
        if let Some(table) = table {
            table.remove(last);
        }
        let changed: Self = read_table(root, self.schema(), |_| place.clone())?;
        *self = changed.changed_from(self);
        Ok(())
    }

    /// The text of a case file, which reads back to the same case.
    fn text(&self) -> Result<String, CaseError> {
        let place = || Source::in_memory().place_of("");
        written::long_file(self).map_err(|error| CaseError::value(place(), None, error))
    }

    /// Sets a key and records it in the source.
    fn set_in(&mut self, source: &mut Source, key: &str, value: &str) -> Result<(), CaseError> {
        let key = with_keys(key);
        source.set(&key, value);
        self.set_at(source.place_of(&key), &key, value)
    }
}

/// Refuses the first key that is not in the schema.
pub(crate) fn refuse_unknown<'a>(
    schema: &Json,
    paths: impl Iterator<Item = &'a str>,
    place: impl Fn(&str) -> Place,
) -> Result<(), CaseError> {
    match first_unknown(schema, paths) {
        None => Ok(()),
        Some((key, nearest)) => Err(CaseError::unknown_key(place(key), key, nearest)),
    }
}

/// The JSON schema of a case file with the table `gears`.
pub fn schema() -> Json {
    let mut schema = restricted(&OF_NAMED);
    let required = ["gears", "operation", "lubricant", "surface"];
    schema["required"] = required.into();
    schema["$defs"]["SurfaceInput"]["required"] = ["pinion"].into();
    for part in ["SealInput", "BearingInput"] {
        schema["$defs"][part]["properties"]["shaft"]["enum"] = ["pinion", "wheel"].into();
    }
    schema
}

/// The JSON schema of a case file with the table `planetary`, or tables `mesh.NAME`.
pub fn schema_of_named_meshes() -> Json {
    restricted(&OF_GEARS)
}

/// Tables and keys of a case with `gears`.
const OF_GEARS: [(&str, &str); 4] = [
    ("", "gears"),
    ("", "micropitting"),
    ("GearboxInput", "loss_table"),
    ("GearboxInput", "jet"),
];

/// Tables and keys of a case whose meshes have names.
const OF_NAMED: [(&str, &str); 12] = [
    ("", "train"),
    ("", "mesh"),
    ("", "planetary"),
    ("", "heat"),
    ("MaterialInput", "sun"),
    ("MaterialInput", "planet"),
    ("MaterialInput", "ring"),
    ("SurfaceInput", "sun"),
    ("SurfaceInput", "planet"),
    ("SurfaceInput", "ring"),
    ("GearboxInput", "jets"),
    ("GearboxInput", "tables"),
];

/// The schema of a case without some keys.
fn restricted(without: &[(&str, &str)]) -> Json {
    let mut schema = schemars::schema_for!(CaseInput).to_value();
    for (table, key) in without {
        let node = match *table {
            "" => &mut schema,
            table => &mut schema["$defs"][table],
        };
        if let Some(keys) = node["properties"].as_object_mut() {
            keys.remove(*key);
        }
    }
    // The flanks and gears of a mesh are not optional, and their defaults are no case.
    for key in ["gears", "surface"] {
        if let Some(node) = schema["properties"]
            .get_mut(key)
            .and_then(Json::as_object_mut)
        {
            node.remove("default");
        }
    }
    let mut used = BTreeSet::new();
    let root = schema["properties"].clone();
    add_definitions(&schema["$defs"], &root, &mut used);
    if let Some(definitions) = schema["$defs"].as_object_mut() {
        definitions.retain(|name, _| used.contains(name));
    }
    schema
}

/// Adds the names of the definitions that `node` refers to.
fn add_definitions(definitions: &Json, node: &Json, used: &mut BTreeSet<String>) {
    match node {
        Json::Object(fields) => {
            let name = fields.get("$ref").and_then(Json::as_str);
            if let Some(name) = name.and_then(|name| name.strip_prefix("#/$defs/"))
                && used.insert(name.to_owned())
            {
                add_definitions(definitions, &definitions[name], used);
            }
            for inner in fields.values() {
                add_definitions(definitions, inner, used);
            }
        }
        Json::Array(values) => {
            for inner in values {
                add_definitions(definitions, inner, used);
            }
        }
        _ => {}
    }
}

/// The schema of a case whose meshes have names or not.
pub(crate) fn schema_with(names_meshes: bool) -> &'static Json {
    static OF_GEARS: LazyLock<Json> = LazyLock::new(schema);
    static OF_NAMED: LazyLock<Json> = LazyLock::new(schema_of_named_meshes);
    if names_meshes { &OF_NAMED } else { &OF_GEARS }
}

/// Whether a case whose meshes have names has the key.
pub(crate) fn is_key_of_named_meshes(key: &str) -> bool {
    first_unknown(schema_with(true), std::iter::once(key)).is_none()
}

/// Whether the text has tables `[mesh.NAME]` or `[planetary]`, whose meshes have names.
pub(crate) fn names_meshes(source: &Source) -> bool {
    let mut keys = source.key_paths();
    keys.any(|key| CaseInput::NAMED.contains(&key))
}

impl CaseFile for CaseInput {
    fn schema_of(source: &Source) -> &'static Json {
        schema_with(names_meshes(source))
    }

    fn schema(&self) -> &'static Json {
        schema_with(self.names_meshes())
    }

    fn from_keys(table: Table) -> Result<Self, (Option<String>, String)> {
        let missing = |key: &str| format!("missing field `{key}`");
        let are_named = CaseInput::NAMED.iter().any(|key| table.contains_key(*key));
        if !are_named && !table.contains_key("gears") {
            return Err((None, missing("gears")));
        }
        let surface = table.get("surface").and_then(Value::as_table);
        let has_flank = surface.map(|surface| surface.contains_key("pinion"));
        let input = from_table(table)?;
        match has_flank {
            _ if are_named => Ok(input),
            None => Err((None, missing("surface"))),
            Some(false) => Err((Some("surface".to_owned()), missing("pinion"))),
            Some(true) => Ok(input),
        }
    }

    /// The oil that another one replaced is not a key.
    fn changed_from(mut self, before: &Self) -> Self {
        self.lubricant
            .replaced
            .clone_from(&before.lubricant.replaced);
        self
    }

    /// A flank whose keys were taken away stays a table, so that others can be set after it.
    fn table(&self) -> Result<Table, toml::ser::Error> {
        let mut root = written::table(self)?;
        if !self.names_meshes() {
            let empty = || Value::Table(Table::new());
            let surface = root.entry("surface").or_insert_with(empty);
            if let Value::Table(surface) = surface {
                surface.entry("pinion").or_insert_with(empty);
            }
        }
        Ok(root)
    }
}

/// Valid values of the keys of a case, which replace wrong ones.
pub(crate) const VALID: &str = r#"
gears = { teeth = [23, 68], module = "2 mm", face_width = "30 mm" }
operation = { torque = "100 N m", speed = "3000 1/min", bulk_temperature = "60 °C" }
lubricant = { oil = "m100" }
surface = { pinion = { rq = "0.3 um" }, wheel = { rq = "0.3 um" } }
"#;

/// The same of a case whose meshes have names.
pub(crate) const VALID_OF_NAMED: &str = r#"
train = { input = "input" }
mesh.only = { shafts = ["input", "output"], gears = { teeth = [23, 68], module = "2 mm", face_width = "30 mm" } }
planetary = { teeth = [27, 24, -75], planets = 3, module = "2 mm", face_width = ["30 mm", "30 mm", "30 mm"] }
operation = { torque = "100 N m", speed = "3000 1/min", bulk_temperature = "60 °C" }
lubricant = { oil = "m100" }
surface = { pinion = { rq = "0.3 um" }, wheel = { rq = "0.3 um" }, sun = { rq = "0.3 um" }, planet = { rq = "0.3 um" }, ring = { rq = "0.3 um" } }
"#;

/// The table of the keys of a case.
fn table_of<T: CaseFile>(case: &T, place: &Place) -> Result<Table, CaseError> {
    case.table()
        .map_err(|error| CaseError::value(place.clone(), None, error))
}

/// The case with `value` at `path`.
fn replaced<T: CaseFile>(
    case: &T,
    path: &str,
    value: Value,
    place: &Place,
) -> Result<T, CaseError> {
    let mut root = table_of(case, place)?;
    let (above, last) = path.rsplit_once('.').unwrap_or(("", path));
    let mut table = &mut root;
    for part in above.split('.').filter(|part| !part.is_empty()) {
        let entry = table
            .entry(part)
            .or_insert_with(|| Value::Table(Table::new()));
        // `true` states a table without keys.
        if entry.is_bool() {
            *entry = Value::Table(Table::new());
        }
        table = match entry {
            Value::Table(inner) => inner,
            other => {
                return Err(CaseError::value(
                    place.clone(),
                    Some(path),
                    format!("{part} is {other} and no table"),
                ));
            }
        };
    }
    table.insert(last.to_owned(), value);
    remove_replaced(table, path);
    // A case that is put together key by key may be incomplete.
    read_part(root, case.schema(), |_| place.clone())
}

/// Removes from the table of the key at `path` the keys that it replaces.
pub(crate) fn remove_replaced(table: &mut Table, path: &str) {
    let replaced = TEMPERATURE_KEYS.iter().find(|(key, _)| *key == path);
    for other in replaced.map_or(&[][..], |(_, others)| others) {
        table.remove(*other);
    }
}

/// A value as written in a case file; text that is not a value needs no quotation marks.
fn typed(text: &str) -> Value {
    match text.trim().parse::<Value>() {
        Ok(Value::Datetime(_)) | Err(_) => Value::String(text.trim().to_owned()),
        Ok(value) => value,
    }
}

/// Whether the schema accepts text at `path`.
fn takes_text(schema: &Json, path: &str) -> bool {
    property(schema, path).is_some_and(|node| match node.get("type") {
        Some(Json::String(kind)) => kind == "string",
        Some(Json::Array(kinds)) => kinds.iter().any(|kind| kind == "string"),
        _ => false,
    })
}

/// Reads a case from the table of its keys; `place` is the place of a key in messages.
pub(crate) fn read_table<T: CaseFile>(
    root: Table,
    schema: &Json,
    place: impl Fn(&str) -> Place,
) -> Result<T, CaseError> {
    T::from_keys(root).map_err(|(key, message)| value_error(key, message, schema, place))
}

/// Reads a part of a case whose keys are in `schema`.
pub(crate) fn read_part<T: DeserializeOwned>(
    root: Table,
    schema: &Json,
    place: impl Fn(&str) -> Place,
) -> Result<T, CaseError> {
    from_table(root).map_err(|(key, message)| value_error(key, message, schema, place))
}

/// The error about a value that cannot be read, by its key and the message, in the words of the schema.
fn value_error(
    key: Option<String>,
    message: String,
    schema: &Json,
    place: impl Fn(&str) -> Place,
) -> CaseError {
    CaseError::value(
        place(key.as_deref().unwrap_or_default()),
        key.as_deref(),
        plain(schema, key.as_deref(), &message),
    )
}
