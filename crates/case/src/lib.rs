//! The case of a gear mesh: the inputs of a run, checked and completed with defaults, with its measured flanks.
//!
//! It is used by `asperity`, which re-exports it, and `uncertainty`. It does not know how a run proceeds.
//!
//! | module | holds |
//! |---|---|
//! | [`case`] | keys, defaults, checks, oil files, gear trains; [`case::load`] reads a file |
//! | [`flanks`] | traces on their flanks, and the windows in contact at a mesh position |
//! | [`laws`], [`load_share_law`] | user-defined laws instead of those that a case names |
//! | [`formulation`], [`window_pressures`] | formulations of the model, which a program registers |
//! | [`error`], [`message`] | errors and warnings with a code, the place in the case and a remedy |
//!
//! No rough contact, friction or loss is computed here: the crate `asperity` does that, and re-exports these modules.
//!
#![doc = include_str!("../README.md")]

pub mod balance;
pub mod case;
pub mod error;
pub mod fingerprint;
pub mod formula_film;
mod input;
pub mod key_words;
pub mod laws;
#[cfg(feature = "case-files")]
mod load;
mod loaded;
#[cfg_attr(not(feature = "case-files"), path = "no_loss_table.rs")]
pub mod loss_table;

pub mod physical_limits;
pub mod recorded_share;
mod resolved;
mod source;
#[cfg_attr(not(feature = "case-files"), path = "no_text.rs")]
mod text;
mod train;

pub use asperity_core::message;
/// Traces on their flanks, and the windows in contact at a mesh position.
pub use asperity_flanks as flanks;
pub use asperity_flanks::mesh_position;
pub use input::{formulation, window_pressures};
pub use laws::load_share as load_share_law;
