//! The case: the inputs of a run, completed with defaults.
//!
//! [`CaseInput`] is the case as the user writes it; [`Case`] has every choice made and checked; [`LoadedCase`] adds
//! the flanks and is ready for a run. All defaults in use are listed.
//!
//! | from | by |
//! |---|---|
//! | a file and the traces it names | [`load`] |
//! | a text and a resolver of its files | [`from_text`] |
//! | quantities and traces in memory | [`Case::builder`] |
//! | a value | [`LoadedCase::try_from`] a [`CaseInput`] |
//! | another case | [`LoadedCase::with`], [`LoadedCase::with_key`] |
//!
//! [`Train`] is a case of any number of meshes, [`LoadedCase`] that of one.

mod assumed_relief;
mod builder;
mod bulk;
mod bulk_input;
mod calibrated;
mod calibration;
mod defaults;
mod error;
mod files;
mod finish;
mod flank_form;
mod flank_pairs;
mod flank_place;
mod flank_sample;
mod flank_trace;
mod flanks;
mod gear_input;
mod gearbox;
mod gearbox_input;
mod gears;
mod input;
mod input_tables;
mod key_ranges;
mod law_names;
mod lay;
mod load_inputs;
mod loaded;
mod mesh_input;
mod micropitting_input;
mod model;
mod nearest_name;
mod oil_file;
mod one_or_two;
mod own_laws;
mod path_point;

pub mod planetary;
mod plausibility;
mod ranges;
mod resolve;
mod rows;
mod section;
mod shafting;
mod source;
mod steel;
mod surrogates;
#[cfg_attr(not(feature = "case-files"), path = "no_text.rs")]
mod text;
mod trace;
mod trace_filters;
mod trace_list;
pub mod train;
mod train_heat_input;
mod train_input;
mod train_parts;

pub use asperity_core::Place;
pub use assumed_relief::AssumedRelief;
pub use builder::CaseBuilder;
pub use bulk::{BulkModel, BulkReport, FoundBulk};
pub use bulk_input::{BulkInput, BulkLaw, Lubrication};
pub use calibration::cholesky;
pub use calibration::{Calibrated, CalibratedName, CalibrationInput, CorrelationInput, SIMULATED};
pub use defaults::DefaultUsed;
pub use error::{CaseError, did_you_mean};
pub use files::{Content, FILE_KEYS, FileContents, FileSums};
pub use finish::FinishName;
pub use flank_place::{FlankPlaceInput, TraceStart};
pub use gear_input::{
    EndReliefInput, GearFlankInput, NoRelief, ReliefInput, ReliefSource, TipRelief,
};
pub use gearbox::{BearingLoads, Gearbox, MeshPlace, Part, PartKind};
pub use gearbox_input::{
    BearingInput, BearingKind, GearboxInput, Hand, JetInput, MeshJetInput, SealInput, TableInput,
};
pub use gears::gear_pair;
pub use input::{
    BodyInput, CaseInput, CoastInput, FlankInput, GearsInput, MapInput, MaterialInput,
    OperationInput, SurfaceInput, VehicleInput,
};
pub use key_ranges::range_of;
pub use law_names::{FilmFrictionLaw, FullFilmName, LoadShareName};
pub use load_inputs::LoadInputs;
pub use loaded::LoadedCase;
pub use micropitting_input::MicropittingInput;
pub use model::{EhlChoices, EhlInput, LEAST_OFFSETS, Model, ModelInput};
pub use nearest_name::nearest_name;
pub use oil_file::{
    DECISIVE, FitQuality, FittedFriction, FittedName, OilConstant, OilFile, OilSchema,
    POORLY_EXPLAINED, STEEPEST_FALL, law_error,
};
pub use one_or_two::OneOrTwo;
pub use path_point::{NamedPoint, PathPoint, Positions};
pub use resolve::{Case, resolve};
pub use rows::Limits;
pub use shafting::{Flow, MeshLoad, Shafting, StageKind};
pub use source::Source;
pub use steel::STEEL_FLOW_PRESSURE;
#[cfg(feature = "case-files")]
pub use text::{
    Change, Findings, Resolver, check, from_contents, from_text, load, load_holding, load_set,
    load_with, markdown, open_source, schema, schema_of_named_meshes,
};
pub use trace::{Flank, Trace};
pub use trace_list::{TraceEntry, TraceInput, TraceList};
pub use train::Train;
