//! A case of any kind as the user writes it.

use std::path::Path;

use asperity_core::quantity::{AngularSpeed, Torque};
use serde::de::Error as _;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::case_file::CaseFile;
use super::input::{CaseInput, MapInput, OperationInput, VehicleInput};
use super::set::{of_json, train_of_json};
use super::source::Source;
use super::train_input::TrainCaseInput;
use crate::error::Error;

/// A case of any kind: a pair of gears, or a gear train or planetary set.
#[derive(Debug, Clone, PartialEq)]
pub enum AnyInput {
    /// A pair of gears.
    Mesh(Box<CaseInput>),
    /// A gear train or a planetary set.
    Train(Box<TrainCaseInput>),
}

impl AnyInput {
    /// The operating point, of the input shaft.
    #[must_use]
    pub fn operation(&self) -> &OperationInput {
        match self {
            Self::Mesh(input) => &input.operation,
            Self::Train(input) => &input.operation,
        }
    }

    /// Largest torque and speed of the default axes of a map.
    #[must_use]
    pub fn map_limits(&self) -> (Torque, AngularSpeed) {
        let map: Option<MapInput> = match self {
            Self::Mesh(input) => input.map,
            Self::Train(input) => input.map,
        };
        let (map, operation) = (map.unwrap_or_default(), self.operation());
        (
            map.torque_max.unwrap_or(operation.torque),
            map.speed_max.unwrap_or(operation.speed),
        )
    }

    /// The vehicle of a cycle, if the case states one.
    #[must_use]
    pub fn vehicle(&self) -> Option<&VehicleInput> {
        match self {
            Self::Mesh(input) => input.vehicle.as_ref(),
            Self::Train(input) => input.vehicle.as_ref(),
        }
    }

    /// Tables of losses of the gearbox of a train.
    pub(super) fn own_files(&self) -> impl Iterator<Item = &Path> {
        let gearbox = match self {
            Self::Mesh(_) => None,
            Self::Train(input) => input.gearbox.as_ref(),
        };
        let tables = gearbox.into_iter().flat_map(|gearbox| &gearbox.tables);
        tables.map(|table| table.file.as_path())
    }

    /// Sets the key at `path`, as [`CaseInput::set`] does.
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

impl From<CaseInput> for AnyInput {
    fn from(input: CaseInput) -> Self {
        Self::Mesh(Box::new(input))
    }
}

impl From<TrainCaseInput> for AnyInput {
    fn from(input: TrainCaseInput) -> Self {
        Self::Train(Box::new(input))
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
