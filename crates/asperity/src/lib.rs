//! From two measured tooth flanks to the efficiency of a gear mesh.
//!
//! [`case::load`] reads a case file and the traces it names; [`pipeline::run`] computes it, pure data in
//! and pure data out. The physics lives in the crates below this one; the
//! order in which it is used lives in [`pipeline`] alone.

mod assembly;
mod attention;
mod branch;
pub mod case;
mod chosen_laws;
mod comparison;
mod decision;
mod deformation_losses;
mod detail;
pub mod dry_contact;
pub mod encounter;
pub mod equations;
pub mod error;
mod fields;
pub mod flank_record;
pub mod fluid;
mod formulation;
mod friction;
pub mod laws;
pub mod load_share;
pub mod load_share_law;
pub mod local_roughness;
mod losses;
pub mod message;
pub mod pipeline;
mod position;
mod provenance;
pub mod result;
mod solve;
mod solved;
pub mod station;
mod stations;
pub mod surfaces;
pub mod survey;

pub use error::{PositionError, RunError, UnsolvedContact};
pub use pipeline::{contacts, losses, run};
