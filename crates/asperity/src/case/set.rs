//! Keys of a case set by their path; the case as text.

use serde::Serialize;
use serde::de::DeserializeOwned;
use toml::{Table, Value};

use super::error::CaseError;
use super::input::{CaseInput, schema};
use super::known_keys::{first_unknown, property};
use super::place::Place;
use super::plain_words::plain;
use super::source::{Source, key_of};
use crate::error::Error;

impl CaseInput {
    /// Sets the key at `path` to `value`, written as in a case file; text needs no quotation marks.
    ///
    /// The schema of the case file checks path and value. The domain of a number is checked when the case is
    /// completed.
    ///
    /// # Errors
    /// When the key is not known, or the value does not fit it; the case is then unchanged.
    ///
    /// ```
    /// # use asperity::case::{CaseInput, FlankInput, GearsInput, OperationInput};
    /// # let gears = GearsInput::new([23, 68], "1.8 mm".parse()?, "32 mm".parse()?);
    /// # let operation = OperationInput::new("145 N m".parse()?, "9000 1/min".parse()?, "90 °C".parse()?);
    /// let mut case = CaseInput::new(gears, operation, Default::default(), FlankInput::default());
    /// case.set("operation.torque", "200 N m")?;
    /// case.set("lubricant.oil", "m100")?;
    /// case.set("gears.profile_shift", "[0.1, -0.1]")?;
    /// assert_eq!(case.operation.torque, "200 N m".parse()?);
    /// let error = case.set("operation.torqe", "200 N m").unwrap_err();
    /// assert_eq!(error.code(), "E203");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn set(&mut self, path: &str, value: &str) -> Result<(), Error> {
        Ok(self.set_at(Source::in_memory().place_of(path), path, value)?)
    }

    /// Sets the key at `path`, whose place is known.
    pub(super) fn set_at(
        &mut self,
        place: Place,
        path: &str,
        value: &str,
    ) -> Result<(), CaseError> {
        set_key(self, &schema(), place, path, value)
    }

    /// Removes the key at `path`, so that its default applies.
    ///
    /// # Errors
    /// When the key is not known or has no default; the case is then unchanged.
    pub fn unset(&mut self, path: &str) -> Result<(), Error> {
        let place = Source::in_memory().place_of(path);
        if let Some((key, nearest)) = first_unknown(&schema(), std::iter::once(path)) {
            return Err(CaseError::UnknownKey {
                place,
                key: key.to_owned(),
                nearest,
            }
            .into());
        }
        let mut root = table_of(self, &place)?;
        let (above, last) = path.rsplit_once('.').unwrap_or(("", path));
        let mut table = Some(&mut root);
        for part in above.split('.').filter(|part| !part.is_empty()) {
            table = table.and_then(|table| table.get_mut(part)?.as_table_mut());
        }
        if let Some(table) = table {
            table.remove(last);
        }
        *self = read(root, &schema(), &place)?;
        Ok(())
    }

    /// The case as the text of a case file, which reads back to the same case.
    ///
    /// # Errors
    /// When a value cannot be written as text, such as a path that is not Unicode.
    pub fn to_toml(&self) -> Result<String, Error> {
        let place = Source::in_memory().place_of("");
        let unwritten = |message: String| CaseError::Value {
            place: place.clone(),
            key: None,
            message,
        };
        let text = toml::to_string_pretty(self).map_err(|error| unwritten(error.to_string()))?;
        Ok(text)
    }
}

/// Sets the key at `path` of a case that `schema` describes; an error leaves the case unchanged.
pub(super) fn set_key<T: Serialize + DeserializeOwned>(
    case: &mut T,
    schema: &serde_json::Value,
    place: Place,
    path: &str,
    value: &str,
) -> Result<(), CaseError> {
    if let Some((key, nearest)) = first_unknown(schema, std::iter::once(path)) {
        return Err(CaseError::UnknownKey {
            place,
            key: key.to_owned(),
            nearest,
        });
    }
    let typed = typed(value);
    let is_text = typed.is_str();
    let replaced = match replaced(case, schema, path, typed, &place) {
        // Text that parses as another type, such as a title of digits.
        Err(_) if !is_text && takes_text(schema, path) => {
            let text = Value::String(value.to_owned());
            replaced(case, schema, path, text, &place)
        }
        replaced => replaced,
    };
    *case = replaced?;
    Ok(())
}

fn table_of<T: Serialize>(case: &T, place: &Place) -> Result<Table, CaseError> {
    Table::try_from(case).map_err(|error| CaseError::Value {
        place: place.clone(),
        key: None,
        message: error.to_string(),
    })
}

fn replaced<T: Serialize + DeserializeOwned>(
    case: &T,
    schema: &serde_json::Value,
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
                return Err(CaseError::Value {
                    place: place.clone(),
                    key: Some(path.to_owned()),
                    message: format!("{part} is {other} and no table"),
                });
            }
        };
    }
    table.insert(last.to_owned(), value);
    read(root, schema, place)
}

/// A value as written in a case file; text that is not a value needs no quotation marks.
fn typed(text: &str) -> Value {
    match text.trim().parse::<Value>() {
        Ok(Value::Datetime(_)) | Err(_) => Value::String(text.trim().to_owned()),
        Ok(value) => value,
    }
}

/// Whether the schema accepts text at `path`.
fn takes_text(schema: &serde_json::Value, path: &str) -> bool {
    property(schema, path).is_some_and(|node| match node.get("type") {
        Some(serde_json::Value::String(kind)) => kind == "string",
        Some(serde_json::Value::Array(kinds)) => kinds.iter().any(|kind| kind == "string"),
        _ => false,
    })
}

fn read<T: DeserializeOwned>(
    root: Table,
    schema: &serde_json::Value,
    place: &Place,
) -> Result<T, CaseError> {
    serde_path_to_error::deserialize(Value::Table(root)).map_err(|error| {
        let key = key_of(error.path());
        let message = error.inner().message().to_owned();
        CaseError::Value {
            place: place.clone(),
            message: plain(schema, key.as_deref(), &message),
            key,
        }
    })
}

/// Reads a case from the text of a case file in TOML; files that it names are not opened.
impl std::str::FromStr for CaseInput {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self, Error> {
        let source = Source::new("case", text)?;
        super::loaded::read(&source).map_err(|error| Error::in_text(error, source.clone()))
    }
}
