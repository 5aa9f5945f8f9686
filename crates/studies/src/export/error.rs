//! Errors of exports.

use super::added::AddedLossError;
use asperity_core::number;

/// Error of an export.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ExportError {
    /// A point has no result.
    #[error("finish {finish}: points of the map have no result, so nothing is exported")]
    Holes {
        /// Name of the finish.
        finish: String,
    },
    /// Two files would have one name.
    #[error(
        "finishes {:?} and {:?} would both be exported as {name}: a name of a file has only letters, digits, - and _, and capitals count as small letters. Change one of the names",
        finishes[0], finishes[1]
    )]
    SameFile {
        /// Names of the finishes.
        finishes: [String; 2],
        /// Name of the file.
        name: String,
    },
    /// The format needs torques of both signs.
    #[error("{format} needs torques of both signs, from beyond the smallest to beyond the largest")]
    OneSign {
        /// The format.
        format: &'static str,
    },
    /// The format needs more than one node along both axes.
    #[error("{format} needs at least two torques and two speeds")]
    TooSmall {
        /// The format.
        format: &'static str,
    },
    /// The format needs the ratio of input and output speed.
    #[error(
        "{format} needs the ratio of input and output speed, and several shafts of the train are outputs"
    )]
    NoRatio {
        /// The format.
        format: &'static str,
    },
    /// The loss torque rises faster than the torque.
    #[error(
        "{format} cannot hold this map: near {torque_nm} N m and {speed_rpm} 1/min the loss torque rises faster than the torque", torque_nm = number(*torque_nm), speed_rpm = number(*speed_rpm))]
    Slope {
        /// The format.
        format: &'static str,
        /// Torque \[N m\].
        torque_nm: f64,
        /// Speed \[1/min\].
        speed_rpm: f64,
    },
    /// The format needs a cycle as weight.
    #[error("{format} takes one number, weighted by a cycle, and no cycle was given")]
    NoCycle {
        /// The format.
        format: &'static str,
    },
    /// The cycle is partly outside of the map.
    #[error("{format} takes one number, weighted by a cycle: {source}")]
    Uncovered {
        /// The format.
        format: &'static str,
        /// Shares outside of the map.
        source: crate::cycle::Uncovered,
    },
    /// The added loss does not fit.
    #[error(transparent)]
    Added(#[from] AddedLossError),
    /// A value cannot be written.
    #[error("cannot be written: {0}")]
    Json(#[from] serde_json::Error),
    /// An archive cannot be made.
    #[error("cannot be written: {0}")]
    Zip(#[from] zip::result::ZipError),
    /// A file cannot be written.
    #[error("cannot be written: {0}")]
    Io(#[from] std::io::Error),
}
