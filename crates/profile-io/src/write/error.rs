//! Errors of writing a profile.

/// Errors of writing a profile.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum WriteError {
    /// The archive could not be created.
    #[error("the X3P archive cannot be made: {step} failed")]
    Archive {
        /// Failed step.
        step: &'static str,
    },
    /// This build writes no X3P.
    #[error(
        "X3P is written only by a build with feature packed; write CSV or SMD, or take a released binary or wheel"
    )]
    NotPacked,
    /// The points are uneven, but the format supports only even points.
    #[error(
        "the points are unevenly spaced, which an SMD file has no known place for; resample the trace, or write CSV or X3P"
    )]
    Uneven,
    /// There is no point, or a height or the spacing is not a finite number.
    #[error("the trace has no points, or heights that are no numbers")]
    NoProfile,
}
