//! The two kinds of case file, an ordinary case and a gear train: reading, and keys set by their path.

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
use crate::case::error::CaseError;
use crate::case::input::{CaseInput, TEMPERATURE_KEYS};
use crate::case::source::Source;
use asperity_core::Place;

/// A kind of case file.
pub(super) trait CaseFile: Serialize + DeserializeOwned {
    /// The JSON schema of the keys.
    fn schema() -> &'static Json;

    /// The case as the text states it.
    fn read(source: &Source) -> Result<Self, CaseError> {
        Self::refuse_unknown(source.key_paths(), |key| source.place_of_key(key))?;
        read_table(source.table()?, |key| source.place_of(key))
    }

    /// Refuses the first key that is not in the schema.
    fn refuse_unknown<'a>(
        paths: impl Iterator<Item = &'a str>,
        place: impl Fn(&str) -> Place,
    ) -> Result<(), CaseError> {
        match first_unknown(Self::schema(), paths) {
            None => Ok(()),
            Some((key, nearest)) => Err(CaseError::unknown_key(place(key), key, nearest)),
        }
    }

    /// Sets the key at `path`, which messages report at `place`; an error leaves the case unchanged.
    fn set_at(&mut self, place: Place, path: &str, value: &str) -> Result<(), CaseError> {
        let path = &*with_keys(path);
        Self::refuse_unknown(std::iter::once(path), |_| place.clone())?;
        let typed = typed(value);
        let is_text = typed.is_str();
        *self = match replaced(self, path, typed, &place) {
            // Text that parses as another type, such as a title of digits.
            Err(_) if !is_text && takes_text(Self::schema(), path) => {
                replaced(self, path, Value::String(value.to_owned()), &place)?
            }
            replaced => replaced?,
        };
        Ok(())
    }

    /// Sets a key and records it in the source.
    fn set_in(&mut self, source: &mut Source, key: &str, value: &str) -> Result<(), CaseError> {
        let key = with_keys(key);
        source.set(&key, value);
        self.set_at(source.place_of(&key), &key, value)
    }
}

/// A kind of case file of which a check finds all errors at once.
pub(super) trait Checked: CaseFile {
    /// Valid values of the keys, which replace wrong ones.
    const VALID: &'static str;
}

/// The JSON schema of a case file.
pub fn schema() -> serde_json::Value {
    schemars::schema_for!(CaseInput).to_value()
}

impl CaseFile for CaseInput {
    fn schema() -> &'static Json {
        static SCHEMA: LazyLock<Json> = LazyLock::new(schema);
        &SCHEMA
    }
}

impl Checked for CaseInput {
    const VALID: &'static str = r#"
gears = { teeth = [23, 68], module = "2 mm", face_width = "30 mm" }
operation = { torque = "100 N m", speed = "3000 1/min", bulk_temperature = "60 °C" }
lubricant = { oil = "m100" }
surface = { pinion = { rq = "0.3 um" }, wheel = { rq = "0.3 um" } }
"#;
}

/// The table of the keys of a case.
pub(super) fn table_of<T: Serialize>(case: &T, place: &Place) -> Result<Table, CaseError> {
    written::table(case).map_err(|error| CaseError::value(place.clone(), None, error))
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
    read_table(root, |_| place.clone())
}

/// Removes from the table of the key at `path` the keys that it replaces.
pub(super) fn remove_replaced(table: &mut Table, path: &str) {
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
pub(super) fn read_table<T: CaseFile>(
    root: Table,
    place: impl Fn(&str) -> Place,
) -> Result<T, CaseError> {
    read_part(root, T::schema(), place)
}

/// Reads a part of a case whose keys are in `schema`.
pub(super) fn read_part<T: DeserializeOwned>(
    root: Table,
    schema: &Json,
    place: impl Fn(&str) -> Place,
) -> Result<T, CaseError> {
    from_table(root).map_err(|(key, message)| {
        CaseError::value(
            place(key.as_deref().unwrap_or_default()),
            key.as_deref(),
            plain(schema, key.as_deref(), &message),
        )
    })
}
