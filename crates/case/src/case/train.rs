//! A gear train as a case: pairs of gears and planetary sets on common shafts, each mesh an ordinary case of its own.
//!
//! A case with `[mesh.NAME]` tables has several meshes; a case with `[planetary]` is a train of one planetary set. Oil,
//! operating point and model are common to all meshes. Torque and speed of the operation are those of the input shaft.

pub use super::loaded_train::{LoadedMesh, LoadedStage, Train};
#[cfg(feature = "case-files")]
pub use super::text::train::{
    TrainFindings, check, from_text, is_train, load, load_holding, load_set,
};
#[cfg(feature = "case-files")]
pub use super::text::train_keys::schema;
pub use super::train_heat_input::HeatInput;
pub use super::train_input::{
    MeshInput, PassedLosses, TrainCaseInput, TrainInput, TrainMaterialInput, TrainSurfaceInput,
};
pub use super::train_parts::mesh_folder;
