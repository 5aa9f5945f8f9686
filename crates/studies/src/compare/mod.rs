//! Several finishes on one case: what each loses, how they differ, and which roughness parameter goes
//! with the loss.
//!
//! Every finish runs at the same offsets of its traces and with the same draws of what is uncertain, and differences are
//! taken draw by draw.
//! Roughness is that of the windows under the contact where the mesh spends most of its path, so that
//! window and loss belong together.

mod comparison;
mod page;
mod statistics;
mod summary;
mod windows;
mod write;

pub(crate) use comparison::files;
pub use comparison::{Comparison, Correlation, Finish, FinishResult, compare};
pub use statistics::rank_correlation;
pub use summary::summary;
pub use write::{check_place, write};
