//! Keys of a case set by their path; the case as text.

use serde::de::{DeserializeOwned, Error as _};
use serde::{Deserialize, Deserializer, Serializer};
use toml::Value;

use super::case_file::{CaseFile, read_table, table_of};
use super::parsed::{from_table, stated};
use super::symbols::with_keys;
use super::written;
use crate::case::builder::CaseBuilder;
use crate::case::error::CaseError;
use crate::case::input::CaseInput;
use crate::case::source::Source;
use crate::case::train_input::TrainCaseInput;
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
    /// # use asperity_case::case::{CaseInput, FlankInput, GearsInput, OperationInput};
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

    /// Removes the key at `path`, so that its default applies.
    ///
    /// # Errors
    /// When the key is not known or has no default; the case is then unchanged.
    pub fn unset(&mut self, path: &str) -> Result<(), Error> {
        let path = &*with_keys(path);
        let place = Source::in_memory().place_of(path);
        Self::refuse_unknown(std::iter::once(path), |_| place.clone())?;
        let mut root = table_of(self, &place)?;
        let (above, last) = path.rsplit_once('.').unwrap_or(("", path));
        let mut table = Some(&mut root);
        for part in above.split('.').filter(|part| !part.is_empty()) {
            table = table.and_then(|table| table.get_mut(part)?.as_table_mut());
        }
        if let Some(table) = table {
            table.remove(last);
        }
        *self = read_table(root, |_| place.clone())?;
        Ok(())
    }

    /// Reads the case in a stored result: for `#[serde(deserialize_with)]`, so that the code that reads every key is compiled
    /// once and not for every format and type of result.
    ///
    /// # Errors
    /// When a value is missing or of the wrong kind, with its key.
    pub fn stored<'de, D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        of_json(serde_json::Value::deserialize(from)?).map_err(D::Error::custom)
    }

    /// Writes the case into a stored result: for `#[serde(serialize_with)]`, compiled once as [`stored`](Self::stored) is.
    ///
    /// # Errors
    /// When the format cannot write a value.
    pub fn store<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        erased_serde::serialize(self, to)
    }

    /// The case as the text of a case file, which reads back to the same case.
    ///
    /// # Errors
    /// When a value cannot be written as text, such as a path that is not Unicode.
    pub fn to_toml(&self) -> Result<String, Error> {
        let place = Source::in_memory().place_of("");
        let unwritten = |message: String| CaseError::value(place.clone(), None, message);
        let text = written::long_file(self).map_err(|error| unwritten(error.to_string()))?;
        Ok(text)
    }
}

impl CaseBuilder {
    /// Sets the key at `path` from text, as [`CaseInput::set`] does.
    ///
    /// # Errors
    /// When the key is not known or the value cannot be read.
    pub fn set(mut self, path: &str, value: &str) -> Result<Self, Error> {
        self.input.set(path, value)?;
        Ok(self)
    }
}

/// A case from its JSON in a stored result. Not generic, so that other crates do not compile it anew.
pub(super) fn of_json(value: serde_json::Value) -> Result<CaseInput, String> {
    of_json_object(value)
}

/// A gear train from its JSON in a stored result.
pub(super) fn train_of_json(value: serde_json::Value) -> Result<TrainCaseInput, String> {
    of_json_object(value)
}

fn of_json_object<T: DeserializeOwned>(value: serde_json::Value) -> Result<T, String> {
    let Some(Value::Table(table)) = stated(value) else {
        return Err("a case is a JSON object".to_owned());
    };
    from_table(table).map_err(|(key, message)| match key {
        Some(key) => format!("{key}: {message}"),
        None => message,
    })
}

/// Reads a case from the text of a case file in TOML; files that it names are not opened.
impl std::str::FromStr for CaseInput {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self, Error> {
        let source = Source::new("case", text)?;
        Self::read(&source).map_err(|error| Error::in_text(error, source.clone()))
    }
}
