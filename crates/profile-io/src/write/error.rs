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
}
