//! Errors of filters, parameters and generators.

use asperity_core::cancel::Cancelled;
use asperity_core::quantity::Length;
use asperity_core::{Code, DomainError, Fault, number};
use serde::Serialize;

/// Errors of filters, parameters and generators.
#[derive(Debug, Clone, PartialEq, Serialize, thiserror::Error)]
#[non_exhaustive]
pub enum RoughnessError {
    /// An input outside its domain.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// The work was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// The trace is too short for the evaluation.
    #[error("the profile is {length:.4} long, {purpose} needs at least {needed:.4}")]
    TooShort {
        /// Length of the trace.
        length: Length,
        /// Minimum length.
        needed: Length,
        /// Purpose.
        purpose: &'static str,
    },
    /// Too few points for the formula.
    #[error("{points} points are too few for {purpose}, which needs {needed}")]
    TooFewPoints {
        /// Number of points.
        points: usize,
        /// Minimum number.
        needed: usize,
        /// Purpose.
        purpose: &'static str,
    },
    /// The profile has no suitable summit.
    #[error("no summit with a {window:.6} window on either side lies above the {level}")]
    NoSummit {
        /// Half width of the curvature window.
        window: Length,
        /// Minimum level of the summits.
        level: &'static str,
    },
    /// The summits are flat or hollow on average, so they have no radius.
    #[error("the mean curvature of {count} summits is {curvature} 1/m: they have no radius", curvature = number(*curvature))]
    NoRadius {
        /// Number of summits.
        count: usize,
        /// Mean curvature [1/m].
        curvature: f64,
    },
    /// Two profiles have different spacings.
    #[error(
        "the profiles are spaced {first:.4} and {second:.4}; resample one, or allow linear resampling"
    )]
    SpacingDiffers {
        /// Spacing of the first profile.
        first: Length,
        /// Spacing of the second profile.
        second: Length,
    },
    /// All points around a position are outliers.
    #[error("all points around {place:.4} are outliers of the robust filter")]
    NoSupport {
        /// Distance from the start of the profile.
        place: Length,
    },
    /// An iteration did not converge.
    #[error(
        "{what} did not converge in {iterations} iterations: last relative change {residual:.1e}"
    )]
    NotConverged {
        /// The iteration.
        what: &'static str,
        /// Number of iterations.
        iterations: usize,
        /// Last relative change.
        residual: f64,
    },
}

/// Name of the noise cut-off in errors about it.
pub(crate) const NOISE_CUTOFF: &str = "cut-off lambda_s";

impl RoughnessError {
    /// Whether the error is about the noise cut-off λ_s.
    #[must_use]
    pub fn is_of_noise_cutoff(&self) -> bool {
        matches!(self, Self::Domain(error) if error.name == NOISE_CUTOFF)
    }

    /// Checks the number of points.
    ///
    /// # Errors
    /// When `points` are fewer than `needed`.
    pub(crate) fn at_least(
        points: usize,
        needed: usize,
        purpose: &'static str,
    ) -> Result<(), Self> {
        if points >= needed {
            Ok(())
        } else {
            Err(Self::TooFewPoints {
                points,
                needed,
                purpose,
            })
        }
    }
}

impl From<RoughnessError> for Fault {
    fn from(error: RoughnessError) -> Self {
        let code = match error {
            RoughnessError::Cancelled(_) => Code::E502,
            _ => Code::E120,
        };
        Self::from_cause(code, error)
    }
}
