//! From two measured tooth flanks to the efficiency of a gear mesh.
//!
//! [`case::load`] reads a case file and the traces it names; [`pipeline::run`] computes it, pure data in
//! and pure data out; [`report`] writes the result. The physics lives in the crates below this one; the
//! order in which it is used lives in [`pipeline`] alone.

mod assembly;
mod attention;
mod branch;
pub mod case;
pub mod dry_contact;
pub mod encounter;
pub mod equations;
pub mod error;
mod fluid;
mod friction;
pub mod load_share;
pub mod local_roughness;
mod losses;
pub mod message;
pub mod pipeline;
mod position;
pub mod provenance;
pub mod report;
pub mod result;
pub mod station;
pub mod surfaces;
pub mod survey;

pub use error::{PositionError, RunError, UnsolvedContact};
pub use pipeline::run;
