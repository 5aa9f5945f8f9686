//! Errors of contact computations.

use asperity_core::Code;
use asperity_core::Fault;
use asperity_core::cancel::Cancelled;
use asperity_core::quantity::{Length, LineLoad, Pressure};
use asperity_core::remedy::{Remedy, Setting, Value};
use asperity_core::{DomainError, number};

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
    /// Too few points for a contact.
    #[error("{points} points are too few for a contact: give at least {least}")]
    TooFewPoints {
        /// Number of points.
        points: usize,
        /// Least number of points.
        least: usize,
    },
    /// Too many points for a dense matrix.
    #[error(
        "{points} points are too many for the dense solution (at most {most}): use the solver with transforms"
    )]
    TooManyPoints {
        /// Number of points.
        points: usize,
        /// Largest number of points.
        most: usize,
    },
    /// An array does not have one value per point.
    #[error("{name} has {got} values where {need} are needed: one per point of the gap")]
    WrongLength {
        /// The array.
        name: &'static str,
        /// Number of values required.
        need: usize,
        /// Number of values of the array.
        got: usize,
    },
    /// An array has an invalid value.
    #[error("{name}[{index}] = {value} {unit}: {rule}", value = number(*value))]
    BadElement {
        /// The array.
        name: &'static str,
        /// Index in the array.
        index: usize,
        /// The value there.
        value: f64,
        /// Its unit.
        unit: &'static str,
        /// Rule that it violates.
        rule: &'static str,
    },
    /// At the pressure limit the whole window carries less than the load.
    #[error(
        "the pressure limit {limit:.6} carries at most {capacity:.6} on this window, the load is {load:.6}: raise the limit, widen the window or lower the load"
    )]
    LimitBelowMeanPressure {
        /// Limit of the pressure.
        limit: Pressure,
        /// Load that the whole window carries at the limit.
        capacity: LineLoad,
        /// Load of the problem.
        load: LineLoad,
    },
    /// The datum distance is too small for the approach to fix the load.
    #[error(
        "the approach is measured from a datum at {datum:.6}, which must lie farther than {least:.6} (a quarter of the window): choose a larger datum distance"
    )]
    DatumTooNear {
        /// Datum distance of the problem.
        datum: Length,
        /// Distance that it must exceed.
        least: Length,
    },
    /// The approach of a periodic contact is beyond its mean gap, where no finite load holds it.
    #[error(
        "a periodic contact is fully closed at an approach of {mean_gap:.6}, so {approach:.6} needs an infinite load: lower the approach or control the load"
    )]
    ApproachBeyondMeanGap {
        /// Approach of the problem.
        approach: Length,
        /// Approach at which the whole period is in contact.
        mean_gap: Length,
    },
    /// The problem has another number of points or another boundary than the solver.
    #[error("the solver was made for {solver} and the problem has {problem}: make a new solver")]
    SolverMismatch {
        /// Shape of the solver.
        solver: SolverShape,
        /// Shape of the problem.
        problem: SolverShape,
    },
    /// The largest number of iterations was reached, or no progress was possible.
    #[error(
        "not converged to {tolerance} after {iterations} iterations (duality gap {}, penetration {}, load error {}): allow more iterations or a larger tolerance",
        number(certificate.duality_gap), number(certificate.penetration), number(certificate.load_error), tolerance = number(*tolerance))]
    NotConverged {
        /// Iterations on the finest grid.
        iterations: usize,
        /// Certificate of the last iterate.
        certificate: Certificate,
        /// Tolerance of the settings.
        tolerance: f64,
    },
    /// The tolerance would accept useless solutions.
    #[error(
        "the tolerance {tolerance} is too large: pressures could be wrong by more than half; give at most {most}", tolerance = number(*tolerance), most = number(*most))]
    ToleranceTooLarge {
        /// Tolerance of the settings.
        tolerance: f64,
        /// Largest tolerance accepted.
        most: f64,
    },
    /// A computation that needs a load was requested for a controlled approach.
    #[error("{purpose} needs a load and the problem controls the approach: control the load")]
    LoadControlNeeded {
        /// The computation requested.
        purpose: &'static str,
    },
    /// A computation for elastic contacts was requested for a problem with a pressure limit.
    #[error("{purpose} is elastic and the problem has a pressure limit: remove the limit")]
    ElasticOnly {
        /// The computation requested.
        purpose: &'static str,
    },
    /// A computation that needs plastic flow was requested without a pressure limit.
    #[error("{purpose} needs a pressure at which the softer body flows: give a pressure limit")]
    LimitNeeded {
        /// The computation requested.
        purpose: &'static str,
    },
    /// The flanks still flow after all cycles.
    #[error(
        "after {cycles} cycles the flanks still dissipate {left} of the first cycle's energy, more than the required {shakedown}: allow more cycles or a tighter tolerance of the contacts", left = number(*left), shakedown = number(*shakedown))]
    NotRunIn {
        /// Number of cycles.
        cycles: usize,
        /// Dissipated energy of the last cycle relative to the first.
        left: f64,
        /// Ratio required.
        shakedown: f64,
    },
    /// A computation for free ends was requested for a periodic contact.
    #[error("{purpose} is defined for free ends and the problem is periodic: widen the window")]
    FreeEndsNeeded {
        /// The computation requested.
        purpose: &'static str,
    },
    /// A fixed point was not reached.
    #[error(
        "the pressure still changed by {residual} of its largest value after {steps} steps, more than the required {tolerance}: allow more steps or a larger tolerance", residual = number(*residual), tolerance = number(*tolerance))]
    NoFixedPoint {
        /// Number of steps.
        steps: usize,
        /// Change in the last step relative to the largest pressure.
        residual: f64,
        /// Change required.
        tolerance: f64,
    },
    /// The active set of the dense solver did not settle.
    #[error("the active set still changed at {changes} points after {steps} steps")]
    ActiveSetUnsettled {
        /// Number of steps.
        steps: usize,
        /// Points that changed in the last step.
        changes: usize,
    },
}

/// Number of points and boundary of a [`Solver`](crate::Solver).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub struct SolverShape {
    /// Number of points.
    pub points: usize,
    /// Boundary of the window.
    pub boundary: Boundary,
}

impl ContactError {
    /// Stable code of the message, for a contact without a case.
    pub fn code(&self) -> Code {
        match self {
            Self::NotConverged { .. } | Self::NotRunIn { .. } => Code::E301,
            Self::LimitBelowMeanPressure { .. } => Code::E302,
            Self::ToleranceTooLarge { .. } => Code::E211,
            _ => Code::E209,
        }
    }
}

impl std::fmt::Display for SolverShape {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} points with {}", self.points, self.boundary)
    }
}

impl From<ContactError> for Fault {
    fn from(error: ContactError) -> Self {
        let key = Setting::Key;
        let remedy = match error {
            ContactError::NotConverged { .. } => Remedy::state(key("tolerance"))
                .because("to a larger one (at most 1e-4)")
                .or_do("look for spikes in the gap"),
            ContactError::NotRunIn { .. } => Remedy::state(key("tolerance"))
                .because("to a smaller one")
                .or_set(key("pressure_limit"), Value::Any)
                .because("to a higher one"),
            ContactError::LimitBelowMeanPressure { .. } => Remedy::state(key("pressure_limit"))
                .because("to a higher one")
                .or_set(key("load"), Value::Any)
                .because("to a lower one"),
            ContactError::DatumTooNear { .. } => {
                Remedy::state(key("datum")).because("to a larger one")
            }
            ContactError::ApproachBeyondMeanGap { .. } => Remedy::state(key("approach"))
                .because("to a smaller one")
                .or_set(key("load"), Value::Any)
                .because("in its place"),
            _ => Remedy::none(),
        };
        Self::of(error.code(), error).with(remedy)
    }
}
