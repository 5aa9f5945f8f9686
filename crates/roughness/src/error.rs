//! Errors of the numerical half of the crate; files are read by `asperity-profile-io`.

use asperity_core::DomainError;
use asperity_core::quantity::Length;
use serde::Serialize;

/// Errors of filters, parameters and generators.
#[derive(Debug, Clone, PartialEq, Serialize, thiserror::Error)]
#[non_exhaustive]
pub enum RoughnessError {
    /// An input outside its domain.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// The trace is shorter than the evaluation needs.
    #[error("the profile is {length:.4} long, {purpose} needs at least {needed:.4}")]
    TooShort {
        /// Length at hand.
        length: Length,
        /// Least length.
        needed: Length,
        /// Purpose.
        purpose: &'static str,
    },
    /// Fewer points than the formula takes.
    #[error("{points} points are too few for {purpose}, which needs {needed}")]
    TooFewPoints {
        /// Points at hand.
        points: usize,
        /// Least number.
        needed: usize,
        /// Purpose.
        purpose: &'static str,
    },
    /// No summit can be measured on the profile.
    #[error("no summit with a {window} window on either side lies above the {level}")]
    NoSummit {
        /// Half width of the curvature window.
        window: Length,
        /// The level summits must reach.
        level: &'static str,
    },
    /// The summits are flat or hollow on average, so they have no radius.
    #[error("the mean curvature of {count} summits is {curvature:e} 1/m: no radius follows")]
    NoRadius {
        /// Summits measured.
        count: usize,
        /// Mean curvature [1/m].
        curvature: f64,
    },
    /// Two profiles that must share a grid do not.
    #[error(
        "the profiles are spaced {first:.4} and {second:.4}; resample one, or allow linear resampling"
    )]
    SpacingDiffers {
        /// Spacing of the first profile.
        first: Length,
        /// Spacing of the second profile.
        second: Length,
    },
    /// All points around a place are outliers.
    #[error("at {place:.4} the robust filter finds no points that are not outliers")]
    NoSupport {
        /// Distance from the start of the profile.
        place: Length,
    },
    /// An iteration did not settle.
    #[error(
        "{what} did not converge in {iterations} iterations: last relative change {residual:e}"
    )]
    NotConverged {
        /// The iteration.
        what: &'static str,
        /// Iterations made.
        iterations: usize,
        /// Last relative change.
        residual: f64,
    },
}
