//! Errors of contact problems.

use asperity_core::DomainError;
use asperity_core::cancel::Cancelled;
use asperity_core::quantity::{Length, LineLoad, Pressure};

use crate::boundary::Boundary;
use crate::certificate::Certificate;

/// Error of a contact problem.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ContactError {
    /// An input outside its domain.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// The work was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// Not enough points for a contact.
    #[error("{points} points are too few for a contact: give at least {least}")]
    TooFewPoints {
        /// Points given.
        points: usize,
        /// Points needed.
        least: usize,
    },
    /// More points than a dense matrix is meant for.
    #[error(
        "{points} points are too many for the dense solution (at most {most}): use the solver with transforms"
    )]
    TooManyPoints {
        /// Points given.
        points: usize,
        /// Points accepted.
        most: usize,
    },
    /// Two arrays that belong together differ in length.
    #[error("{name} has {got} values where {need} are needed: one per point of the gap")]
    WrongLength {
        /// The array.
        name: &'static str,
        /// Values needed.
        need: usize,
        /// Values given.
        got: usize,
    },
    /// An array holds a value that it may not hold.
    #[error("{name}[{index}] = {value} {unit}: {rule}")]
    BadElement {
        /// The array.
        name: &'static str,
        /// Index in the array.
        index: usize,
        /// The value there.
        value: f64,
        /// Its unit.
        unit: &'static str,
        /// Rule that it breaks.
        rule: &'static str,
    },
    /// The pressure limit on every point together is below the load.
    #[error(
        "the pressure limit {limit} carries at most {capacity} on this window, the load is {load}: raise the limit, widen the window or lower the load"
    )]
    LimitBelowMeanPressure {
        /// Limit of the pressure.
        limit: Pressure,
        /// Load that the whole window carries at the limit.
        capacity: LineLoad,
        /// Load asked for.
        load: LineLoad,
    },
    /// The datum distance is too small for the approach to fix the load.
    #[error(
        "the approach is measured from a datum at {datum}, which must lie farther than {least} (a quarter of the window): choose a larger datum distance"
    )]
    DatumTooNear {
        /// Datum distance given.
        datum: Length,
        /// Distance it must exceed.
        least: Length,
    },
    /// A periodic contact closed beyond its mean gap, where no finite load holds it.
    #[error(
        "a periodic contact is closed altogether at an approach of {mean_gap}, so {approach} has no finite load: lower the approach or control the load"
    )]
    ApproachBeyondMeanGap {
        /// Approach asked for.
        approach: Length,
        /// Approach at which the whole period is in contact.
        mean_gap: Length,
    },
    /// A problem given to a solver made for another number of points or another boundary.
    #[error("the solver was made for {solver} and the problem has {problem}: make a new solver")]
    SolverMismatch {
        /// Shape the solver was made for.
        solver: SolverShape,
        /// Shape of the problem.
        problem: SolverShape,
    },
    /// The iterations allowed were used up, or no further progress was possible.
    #[error(
        "not converged to {tolerance:e} after {iterations} iterations (duality gap {:e}, penetration {:e}, load error {:e}): allow more iterations or a larger tolerance",
        certificate.duality_gap, certificate.penetration, certificate.load_error
    )]
    NotConverged {
        /// Iterations used on the finest grid.
        iterations: usize,
        /// Certificate of the last iterate.
        certificate: Certificate,
        /// Tolerance asked for.
        tolerance: f64,
    },
    /// A tolerance at which any answer would pass.
    #[error(
        "the tolerance {tolerance:e} is too large: the pressures would be uselessly wrong; give at most {most:e}"
    )]
    ToleranceTooLarge {
        /// Tolerance asked for.
        tolerance: f64,
        /// Largest tolerance accepted.
        most: f64,
    },
    /// Something that is only defined under a given load was asked of a controlled approach.
    #[error("{purpose} needs a load and the problem controls the approach: control the load")]
    LoadControlNeeded {
        /// Computation asked for.
        purpose: &'static str,
    },
    /// Something that holds for elastic contacts only was asked of one with a pressure limit.
    #[error("{purpose} is elastic and the problem has a pressure limit: remove the limit")]
    ElasticOnly {
        /// Computation asked for.
        purpose: &'static str,
    },
    /// Something that needs flow was asked of a contact without pressure limit.
    #[error("{purpose} needs a pressure at which the softer body flows: give a pressure limit")]
    LimitNeeded {
        /// Computation asked for.
        purpose: &'static str,
    },
    /// The flanks still flow after all cycles.
    #[error(
        "after {cycles} cycles the flanks still dissipate {left:e} of the first cycle's energy where {shakedown:e} was asked for: allow more cycles or a tighter tolerance of the contacts"
    )]
    NotRunIn {
        /// Cycles used.
        cycles: usize,
        /// Energy of the last cycle over that of the first.
        left: f64,
        /// Ratio asked for.
        shakedown: f64,
    },
    /// Something that is only defined for free ends was asked of a periodic contact.
    #[error("{purpose} is defined for free ends and the problem is periodic: widen the window")]
    FreeEndsNeeded {
        /// Computation asked for.
        purpose: &'static str,
    },
    /// A fixed point was not reached.
    #[error(
        "the pressure still changed by {residual:e} of its largest value after {steps} steps where {tolerance:e} was asked for: allow more steps or a larger tolerance"
    )]
    NoFixedPoint {
        /// Steps used.
        steps: usize,
        /// Change in the last one over the largest pressure.
        residual: f64,
        /// Change asked for.
        tolerance: f64,
    },
    /// The dense active set did not settle.
    #[error("the active set still changed at {changes} points after {steps} steps")]
    ActiveSetUnsettled {
        /// Steps used.
        steps: usize,
        /// Points that changed in the last one.
        changes: usize,
    },
}

/// Points and ends that a [`Solver`](crate::Solver) is made for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub struct SolverShape {
    /// Number of points.
    pub points: usize,
    /// Ends of the window.
    pub boundary: Boundary,
}

impl ContactError {
    /// Stable code of the message, for a contact without a case.
    pub fn code(&self) -> &'static str {
        match self {
            Self::NotConverged { .. } | Self::NotRunIn { .. } => "E301",
            Self::LimitBelowMeanPressure { .. } => "E302",
            Self::ToleranceTooLarge { .. } => "E211",
            _ => "E209",
        }
    }
}

impl std::fmt::Display for SolverShape {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} points with {}", self.points, self.boundary)
    }
}
