//! A case of any kind as the user writes it.

use std::path::Path;

use asperity_core::quantity::{AngularSpeed, Torque};

use super::input::{CaseInput, MapInput, OperationInput, VehicleInput};
use super::train_input::TrainCaseInput;

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
