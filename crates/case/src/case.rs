//! The case: the inputs of a run, completed with defaults.
//!
//! [`CaseInput`] is the case as the user writes it; [`Case`] has every choice made and checked; [`LoadedCase`] adds
//! the flanks and is ready for a run; [`OperatingCase`] has the temperature of the flanks and the oil there. Each is made once and read
//! only; [`Overrides`] are what draws and studies vary in addition to the keys. All defaults in use are listed.
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

pub use asperity_flanks::statements::Statements;

pub use crate::input::bulk_input::{BulkInput, BulkLaw, Lubrication};
pub use crate::input::calibration::cholesky;
pub use crate::input::calibration::{CalibratedName, CalibrationInput, CorrelationInput};
pub use crate::input::case_input::{
    BodyInput, CaseInput, CoastInput, FlankInput, GearsInput, MapInput, MaterialInput,
    OperationInput, SurfaceInput, VehicleInput,
};
pub use crate::input::contact_name::ContactName;
pub use crate::input::files::{Content, FILE_KEYS, FileContents, FileSums, HeldTrace};
pub use crate::input::film_friction_input::{FilmFrictionInput, FrictionSetting};
pub use crate::input::finish::FinishName;
pub use crate::input::flank_place::{FlankPlaceInput, TraceStart};
pub use crate::input::gear_input::{
    EndReliefInput, GearFlankInput, NoRelief, ReliefInput, ReliefSource, TipRelief,
};
pub use crate::input::gearbox_input::{
    BearingInput, BearingKind, GearboxInput, Hand, JetInput, MeshJetInput, SealInput, TableInput,
};
pub use crate::input::key_ranges::range_of;
pub use crate::input::law_names::{FullFilmName, LoadShareName};
pub use crate::input::micropitting_input::MicropittingInput;
pub use crate::input::model::{
    EhlChoices, EhlInput, LEAST_OFFSETS, Model, ModelInput, PaperChoices, PaperInput,
};
pub use crate::input::one_or_two::OneOrTwo;
pub use crate::input::path_point::{NamedPoint, PathPoint, Positions};
pub use crate::input::rows::Limits;
pub use crate::input::running_in_input::{RunningInEntry, RunningInInput};
pub use crate::input::trace_list::{TraceEntry, TraceInput, TraceList};
#[cfg(feature = "case-files")]
pub use crate::load::{
    check::{Findings, check},
    load_case::{
        Change, Resolver, from_contents, from_text, load, load_holding, load_set, load_with,
        open_source,
    },
    page::markdown,
};
pub use crate::loaded::builder::CaseBuilder;
pub use crate::loaded::loaded_case::{Loaded, LoadedCase};
pub use crate::loaded::operating_case::OperatingCase;
pub use crate::loaded::trace::{Flank, Trace};
pub use crate::resolved::assumed_relief::AssumedRelief;
pub use crate::resolved::bulk::{BulkModel, BulkReport};
pub use crate::resolved::constant::UncertainParameter;
pub use crate::resolved::gearbox::{BearingLoads, Gearbox, MeshPlace, Part, PartKind};
pub use crate::resolved::gears::gear_pair;
pub use crate::resolved::load_inputs::LoadInputs;
pub use crate::resolved::measured::Measured;
pub use crate::resolved::oil_file::{
    DECISIVE, FitQuality, FittedFriction, FittedName, OilConstant, OilFile, OilSchema,
    POORLY_EXPLAINED, STEEPEST_FALL, law_error,
};
pub use crate::resolved::overrides::{Alternative, Overrides};
pub use crate::resolved::resolve::{Case, Resolved, resolve};
pub use crate::resolved::running_in::RunningInPlan;
pub use crate::resolved::shafting::{Flow, MeshLoad, Shafting, StageKind};
pub use crate::resolved::share_law::{PublishedShare, ShareLaw};
pub use crate::resolved::steel::STEEL_FLOW_PRESSURE;
pub use crate::source::case_error::CaseError;
pub use crate::source::defaults::DefaultUsed;
pub use crate::source::source_text::Source;
#[cfg(feature = "case-files")]
pub use crate::text::case_file::{schema, schema_of_named_meshes};
pub use crate::train::gear_train::Train;
pub use crate::train::{gear_train as train, planetary};
pub use asperity_core::Place;
