//! The case file as the user writes it: every key optional that has a default.
//!
//! A case states its gears as `gears`, the only mesh, which has no name, as the meshes `mesh.NAME` on named shafts, or as one set
//! `planetary`. The case of each mesh has the same structure, with `gears`.
//!
//! Quantities are text with a unit. The same structure is read from TOML and JSON, and printed as
//! a JSON schema by [`schema`].

use std::collections::BTreeMap;

use asperity_core::quantity::{AngularSpeed, Torque};
use asperity_oil::LubricantInput;

use super::calibration::CalibrationInput;
use super::formulation::FormulationChoice;
use super::gearbox_input::GearboxInput;
pub use super::input_tables::*;
use super::mesh_input::{MeshInput, PlanetaryInput, ShaftsInput};
use super::micropitting_input::MicropittingInput;
use super::model::{ModelInput, PaperInput};
use super::rows::{OPEN, ratio, table};
use super::train_heat_input::HeatInput;

table! {
    /// A case: gears, steel, oil, operation, measured flanks, and the model to use.
    #[derive(Default)]
    CaseInput;

    /// Title of the case, shown in every output.
    title: Option<String>;
    /// Reading of the model: `corrected` (default) or `paper`.
    formulation: Option<FormulationChoice>;
    /// The gear pair.
    #[serde(default, skip_serializing_if = "is_unstated")]
    gears: GearsInput => table;
    /// Input and output shaft of the meshes.
    #[serde(skip_serializing_if = "Option::is_none")]
    train: Option<ShaftsInput>;
    /// The meshes by their names, each a table `[mesh.NAME]`.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    mesh: BTreeMap<String, MeshInput> => table;
    /// The set of a case that is a single planetary set, instead of `train` and `mesh`; its shafts are `sun`, `ring` and
    /// `carrier`.
    #[serde(skip_serializing_if = "Option::is_none")]
    planetary: Option<PlanetaryInput> => table;
    /// Steel of the pinion, and of the wheel unless `material.wheel` is given; of all meshes that have no own.
    #[serde(default)]
    material: MaterialInput => table;
    /// Operating conditions: torque, speed, temperature.
    operation: OperationInput => table;
    /// The oil.
    lubricant: LubricantInput => table;
    /// The measured flanks and their preparation; of all meshes that have no own.
    #[serde(default)]
    surface: SurfaceInput => table;
    /// Heat balance, from which the temperature of the oil follows; `operation.oil_temperature` is then its start.
    #[serde(skip_serializing_if = "Option::is_none")]
    heat: Option<HeatInput> => table;
    /// Choices of the model.
    #[serde(default)]
    model: ModelInput => table;
    /// Choices of the formulation `paper`; no other uses them.
    #[serde(default, skip_serializing_if = "is_unstated")]
    paper: PaperInput => table;
    /// Parameters calibrated on a rig, as `asperity calibrate` writes them.
    #[serde(skip_serializing_if = "Option::is_none")]
    calibration: Option<CalibrationInput> => table;
    /// Losses of the gearbox other than the loss of the mesh; only the losses stated here are added.
    #[serde(skip_serializing_if = "Option::is_none")]
    gearbox: Option<GearboxInput> => table;
    /// Specific film thickness of the micropitting rating, compared with the measured flanks; computed if this table is stated.
    #[serde(skip_serializing_if = "Option::is_none")]
    micropitting: Option<MicropittingInput> => table;
    /// Ranges of the default axes of `asperity map`; a run ignores them.
    #[serde(skip_serializing_if = "Option::is_none")]
    map: Option<MapInput> => table;
    /// The vehicle of a cycle stated by its speed, for `asperity cycle`; a run ignores it.
    #[serde(skip_serializing_if = "Option::is_none")]
    vehicle: Option<VehicleInput> => table;

    => {
        "map.torque_max": "largest torque over operation.torque", |case| case.over_torque(case.map.iter().map(|map| map.torque_max)),
            "" usual [0.02, 200.0] possible OPEN;
        "map.speed_max": "largest speed over operation.speed", CaseInput::speeds_of_map, "" usual [0.02, 200.0] possible OPEN;
        "gearbox.bearings.at_torque": "torque of the loads over operation.torque", CaseInput::torques_of_bearings,
            "" usual [0.02, 200.0] possible OPEN;
    }
}

impl CaseInput {
    fn over_torque(&self, torques: impl Iterator<Item = Option<Torque>>) -> Vec<f64> {
        let size = |torque: Torque| torque.si().abs();
        let of_case = size(self.operation.torque);
        torques
            .flat_map(|torque| ratio(torque.map(size), Some(of_case)))
            .collect()
    }

    fn torques_of_bearings(&self) -> Vec<f64> {
        let bearings = self.gearbox.iter().flat_map(|gearbox| &gearbox.bearings);
        self.over_torque(bearings.map(|bearing| bearing.at_torque))
    }

    fn speeds_of_map(&self) -> Vec<f64> {
        let most = self.map.and_then(|map| map.speed_max);
        ratio(most.map(AngularSpeed::si), Some(self.operation.speed.si()))
    }
}
