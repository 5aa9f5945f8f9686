//! Several finishes on one case: what each loses, how they differ, and which roughness parameter goes
//! with the loss.
//!
//! Every finish runs at the same offsets of its traces, and differences are taken offset by offset.
//! Roughness is that of the windows under the contact where the mesh spends most of its path, so that
//! window and loss belong together.

mod comparison;
mod page;
mod statistics;
mod summary;
mod windows;
mod write;

pub use comparison::{CONFIDENCE, Comparison, Correlation, Finish, FinishResult, compare};
pub use statistics::{Interval, paired_interval, rank_correlation};
pub use summary::summary;
pub use write::{check_place, write};
