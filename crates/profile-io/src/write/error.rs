//! Errors in writing a profile.

/// Errors in writing a profile.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum WriteError {
    /// The archive could not be made.
    #[error("the X3P archive cannot be made: {step} failed")]
    Archive {
        /// Action that failed.
        step: &'static str,
    },
    /// The points are uneven, and the format is written for even ones alone.
    #[error(
        "the points are unevenly spaced, which an SMD file has no known place for; resample the trace, or write CSV or X3P"
    )]
    Uneven,
    /// There is no point, or a height or the spacing is no number.
    #[error("the trace has no points, or heights that are no numbers")]
    NoProfile,
}
