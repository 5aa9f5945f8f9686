//! The case: what is to be computed, read from a file and completed with defaults.
//!
//! [`CaseInput`] is the file as the user writes it; [`Case`] is the same with every choice made and
//! checked, ready for [`pipeline::run`](crate::pipeline::run). Every default used is listed.

mod defaults;
mod error;
mod files;
mod input;
mod key_names;
mod known_keys;
mod model;
mod own_laws;
mod plain_words;
mod resolve;
mod source;
mod steel;

pub use defaults::DefaultUsed;
pub use error::CaseError;
pub use files::{LoadedCase, load, load_with};
pub use input::{
    BodyInput, CaseInput, FlankInput, Formulation, GearsInput, MaterialInput, ModelInput,
    NamedPoint, OneOrTwo, OperationInput, PathPoint, SurfaceInput, schema,
};
pub use model::Model;
pub use resolve::{Case, resolve};
pub use source::{Place, Source, Syntax};
