//! Many cases from one study file: crossed axes and samples of the inputs, in shards that any scheduler can run.
//!
//! A case has a number, row-major in the axes and then the sample, and an id computed from its content. Shards write parts,
//! each completely or not at all; a restart runs the missing cases. The merged table is the same for any number of shards
//! and threads.

mod amount;
mod axes;
mod case_list;
mod cases;
mod columns;
mod draws;
mod effects;
mod error;
mod known_columns;
mod merge;
mod merged;
mod parts;
mod plan;
mod refused;
mod report;
mod run;
mod settings;
mod study;
mod study_input;
mod words;

pub(crate) use amount::written;
pub use asperity_core::numerics::standard_normal_quantile;
pub use cases::Cases;
pub use columns::{InputColumn, InputValues};
pub use draws::Draws;
pub(crate) use draws::{stream, uniform};
pub use effects::{Effect, Indices, Regressor, effects, sobol_indices};
pub use error::SweepError;
pub use merge::merge;
pub use merged::{EffectRow, Merged};
pub use parts::{Status, status};
pub use plan::{Plan, plan};
pub use refused::Refused;
pub use run::{Event, Shard, run};
pub use settings::Settings as Keys;
pub(crate) use settings::set_all as set_keys;
pub use study::Study;
pub use study_input::Method;
