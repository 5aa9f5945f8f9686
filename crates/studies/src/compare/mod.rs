//! Several variants of a case, a pair of gears or a gear train: losses, differences, and correlation of the roughness parameters with
//! the loss. A variant has other flanks (a finish), other values of keys, or is another case.
//!
//! Differences are taken draw by draw, with the draws that two variants have in common by the things to which the constants belong. Roughness is evaluated on the windows under the contact in the middle of the path, so that it
//! belongs to the same part of the trace as the loss.

mod comparison;
mod report;
mod statistics;
mod tables;
mod variants;
mod windows;
mod words;

pub use comparison::{
    ChangedKey, CompareSettings, Comparison, Correlation, Finish, FinishResult, Finishes,
    MeshOfFinish, compare,
};
pub(crate) use comparison::{differs_by_flanks, files};
pub use statistics::rank_correlation;
pub use variants::{
    AS_IS, KeyOrFile, NamedVariant, Variant, WrittenVariant, keys_in, variants, varied,
};
pub(crate) use words::noun;
pub use words::{difference_with_interval, verdict};
