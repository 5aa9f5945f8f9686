//! Keys of a case set by their path; the case as text.

use serde::de::Error as _;
use serde::ser::Error as _;
use serde::{Deserialize, Deserializer, Serialize as _, Serializer};
use serde_json::Value as Json;
use toml::Value;

use crate::error::Error;
use crate::input::case_input::CaseInput;
use crate::loaded::builder::CaseBuilder;
use crate::source::source_text::Source;
use crate::text::case_file::CaseFile;
use crate::text::parsed::stated;
use crate::text::symbols::with_keys;
use crate::train::train_input::without_nulls;

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

    /// Leaves out the oil of the case and its calibration if one of `keys`, which are set over the case, names an oil: another oil is
    /// not the oil of the case with some of its numbers.
    ///
    /// ```
    /// # use asperity_case::case::{CaseInput, FlankInput, GearsInput, OperationInput};
    /// # let gears = GearsInput::new([23, 68], "1.8 mm".parse()?, "32 mm".parse()?);
    /// # let operation = OperationInput::new("145 N m".parse()?, "9000 1/min".parse()?, "90 °C".parse()?);
    /// let mut case = CaseInput::new(gears, operation, Default::default(), FlankInput::default());
    /// case.set("lubricant.density", "860 kg/m3")?;
    /// case.make_way_for(["lubricant.heat_capacity"]);
    /// assert!(case.lubricant.density.is_some());
    /// case.make_way_for(["lubricant.oil"]);
    /// assert!(case.lubricant.density.is_none());
    /// case.set("lubricant.oil", "m100")?;
    /// assert_eq!(case.lubricant.replaced, ["lubricant.density"]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn make_way_for<'a>(&mut self, keys: impl IntoIterator<Item = &'a str>) {
        /// Keys that name an oil.
        const OILS: [&str; 2] = ["lubricant.oil", "lubricant.oil_file"];
        if !keys.into_iter().any(|key| OILS.contains(&&*with_keys(key))) {
            return;
        }
        let oil = std::mem::take(&mut self.lubricant);
        let stated = oil.stated().map(|key| format!("lubricant.{key}"));
        let calibration = self.calibration.take().map(|_| "calibration".to_owned());
        self.lubricant.replaced = stated.chain(calibration).collect();
    }

    /// Removes the key at `path`, so that its default applies.
    ///
    /// # Errors
    /// When the key is not known or has no default; the case is then unchanged.
    pub fn unset(&mut self, path: &str) -> Result<(), Error> {
        Ok(self.unset_at(path)?)
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
        if !self.names_meshes() {
            return erased_serde::serialize(self, to);
        }
        // Steel and flanks of all meshes are stated in part.
        let mut case = serde_json::to_value(self).map_err(S::Error::custom)?;
        let meshes = case.get_mut("mesh").and_then(Json::as_object_mut);
        for mesh in meshes.into_iter().flat_map(|meshes| meshes.values_mut()) {
            strip_unstated(mesh);
        }
        strip_unstated(&mut case);
        case.serialize(to)
    }

    /// The case as the text of a case file, which reads back to the same case.
    ///
    /// # Errors
    /// When a value cannot be written as text, such as a path that is not Unicode.
    pub fn to_toml(&self) -> Result<String, Error> {
        Ok(self.text()?)
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

fn strip_unstated(of: &mut Json) {
    for table in ["material", "surface"] {
        if let Some(keys) = of.get_mut(table) {
            *keys = without_nulls(keys.take());
        }
    }
}

/// A case from its JSON in a stored result. Not generic, so that other crates do not compile it again.
fn of_json(value: serde_json::Value) -> Result<CaseInput, String> {
    let Some(Value::Table(table)) = stated(value) else {
        return Err("a case is a JSON object".to_owned());
    };
    CaseInput::from_keys(table).map_err(|(key, message)| match key {
        Some(key) => format!("{key}: {message}"),
        None => message,
    })
}

impl CaseInput {
    /// Reads a case as the text of `source` states it; files that it names are not opened.
    ///
    /// # Errors
    /// When a key is not known, or a value is missing or of the wrong kind, with its place.
    pub fn of_source(source: &Source) -> Result<Self, Error> {
        Self::read(source).map_err(|error| Error::in_text(error, source.clone()))
    }
}

/// Reads a case from the text of a case file in TOML; files that it names are not opened.
impl std::str::FromStr for CaseInput {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self, Error> {
        Self::of_source(&Source::new("case", text)?)
    }
}
