//! Several finishes on one case, a pair of gears or a gear train: losses, differences, and correlation of the roughness parameters with the loss.
//!
//! All finishes run with the same draws of the uncertain parameters; differences are taken draw by draw. Roughness is evaluated on the windows under the contact in the middle of the path, so that it
//! belongs to the same part of the trace as the loss.

mod comparison;
mod report;
mod statistics;
mod tables;
mod windows;
mod words;

pub(crate) use comparison::files;
pub use comparison::{
    CaseRun, CompareSettings, Comparison, Correlation, Finish, FinishResult, Finishes,
    MeshOfFinish, compare, drawn_together,
};
pub use statistics::rank_correlation;
pub use words::{difference_with_interval, verdict};
