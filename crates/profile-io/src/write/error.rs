//! Errors of writing a profile.

use asperity_core::{Code, Fault};

asperity_core::fault_error! {
    /// Errors of writing a profile.
    WriteError
}

impl WriteError {
    /// The archive could not be created.
    #[cfg(feature = "packed")]
    pub(super) fn archive(step: &'static str) -> Self {
        Self::new(format!("the X3P archive cannot be made: {step} failed"))
    }

    /// This build writes no X3P.
    #[cfg(not(feature = "packed"))]
    pub(super) fn not_packed() -> Self {
        Self::new(
            "X3P is written only by a build with feature packed; write CSV or SMD, or take a released binary or wheel",
        )
    }

    /// The points are uneven, but the format supports only even points.
    pub(super) fn uneven() -> Self {
        Self::new(
            "the points are unevenly spaced, which an SMD file has no known place for; resample the trace, or write CSV or X3P",
        )
    }

    /// There is no point, or a height or the spacing is not a finite number.
    pub(super) fn no_profile() -> Self {
        Self::new("the trace has no points, or a height or spacing that is not a finite number")
    }

    fn new(text: impl Into<String>) -> Self {
        Fault::new(Code::E401, text).into()
    }
}
