//! A case of any kind in a stored result, and its keys set by name.

use serde::de::Error as _;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::case_file::CaseFile;
use super::load::names_meshes;
use super::set::{of_json, train_of_json};
use crate::case::any_input::AnyInput;
use crate::case::input::CaseInput;
use crate::case::source::Source;
use crate::case::train_input::TrainCaseInput;
use crate::error::Error;

impl AnyInput {
    /// The case as the text states it.
    ///
    /// # Errors
    /// When a key is not known, or a value is missing or of the wrong kind, with its place.
    pub fn read(source: &Source) -> Result<Self, Error> {
        let input = match names_meshes(source) {
            true => TrainCaseInput::read(source).map(Self::from),
            false => CaseInput::read(source).map(Self::from),
        };
        input.map_err(|error| Error::in_text(error, source.clone()))
    }

    /// Sets the key at `path`, as [`CaseInput::set`](crate::case::CaseInput::set) does.
    ///
    /// # Errors
    /// When the key is not known, or the value does not fit it; the case is then unchanged.
    pub fn set(&mut self, path: &str, value: &str) -> Result<(), Error> {
        let place = Source::in_memory().place_of(path);
        Ok(match self {
            Self::Mesh(input) => input.set_at(place, path, value),
            Self::Train(input) => input.set_at(place, path, value),
        }?)
    }
}

impl AnyInput {
    /// Removes the key at `path`, as [`CaseInput::unset`] does.
    ///
    /// # Errors
    /// When the key is not known or has no default; the case is then unchanged.
    pub fn unset(&mut self, path: &str) -> Result<(), Error> {
        Ok(match self {
            Self::Mesh(input) => input.unset_at(path),
            Self::Train(input) => input.unset_at(path),
        }?)
    }

    /// The case as the text of a case file, which reads back to the same case.
    ///
    /// # Errors
    /// When a value cannot be written as text, such as a path that is not Unicode.
    pub fn to_toml(&self) -> Result<String, Error> {
        Ok(match self {
            Self::Mesh(input) => input.text(),
            Self::Train(input) => input.text(),
        }?)
    }
}

impl Serialize for AnyInput {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Mesh(input) => input.store(to),
            Self::Train(input) => erased_serde::serialize(input, to),
        }
    }
}

impl<'de> Deserialize<'de> for AnyInput {
    /// Reads the case in a stored result; its kind follows from the table of the gears.
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        let value = serde_json::Value::deserialize(from)?;
        let has = |table: &str| value.get(table).is_some_and(serde_json::Value::is_object);
        match TrainCaseInput::TABLES.into_iter().any(has) {
            true => train_of_json(value).map(|input| Self::Train(Box::new(input))),
            false => of_json(value).map(|input| Self::Mesh(Box::new(input))),
        }
        .map_err(D::Error::custom)
    }
}
