//! Errors of contact computations.

use asperity_core::cancel::Cancelled;
use asperity_core::quantity::{Length, LineLoad, Pressure};
use asperity_core::remedy::{Remedy, Setting, Value};
use asperity_core::{Code, DomainError, Fault, number};

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
    /// An error that no caller distinguishes from others.
    #[error(transparent)]
    Fault(#[from] Fault),
}

impl ContactError {
    /// Too few points for a contact.
    pub(crate) fn too_few_points(points: usize, least: usize) -> Self {
        Self::Fault(Fault::new(
            Code::E209,
            format!("{points} points are too few for a contact: give at least {least}"),
        ))
    }

    /// Too many points for a dense matrix.
    pub(crate) fn too_many_points(points: usize, most: usize) -> Self {
        Self::Fault(Fault::new(
            Code::E209,
            format!(
                "{points} points are too many for the dense solution (at most {most}): use the solver with transforms"
            ),
        ))
    }

    /// The datum distance is too small for the approach to fix the load.
    pub(crate) fn datum_too_near(datum: Length, least: Length) -> Self {
        Self::Fault(Fault::new(Code::E209, format!("the approach is measured from a datum at {datum:.6}, which must lie farther than {least:.6} (a quarter of the window): choose a larger datum distance")).with(Remedy::state(Setting::Key("datum")).because("to a larger one")))
    }

    /// The approach of a periodic contact is beyond its mean gap, where no finite load holds it.
    pub(crate) fn approach_beyond_mean_gap(approach: Length, mean_gap: Length) -> Self {
        Self::Fault(Fault::new(Code::E209, format!("a periodic contact is fully closed at an approach of {mean_gap:.6}, so {approach:.6} needs an infinite load: lower the approach or control the load")).with(Remedy::state(Setting::Key("approach")).because("to a smaller one").or_set(Setting::Key("load"), Value::Any).because("in its place")))
    }

    /// The problem has another number of points or another boundary than the solver.
    pub(crate) fn solver_mismatch(solver: SolverShape, problem: SolverShape) -> Self {
        Self::Fault(Fault::new(
            Code::E209,
            format!(
                "the solver was made for {solver} and the problem has {problem}: make a new solver"
            ),
        ))
    }

    /// The tolerance would accept useless solutions.
    pub(crate) fn tolerance_too_large(tolerance: f64, most: f64) -> Self {
        Self::Fault(Fault::new(
            Code::E211,
            format!(
                "the tolerance {tolerance} is too large: pressures could be wrong by more than half; give at most {most}",
                tolerance = number(tolerance),
                most = number(most)
            ),
        ))
    }

    /// A computation that needs plastic flow was requested without a pressure limit.
    pub(crate) fn limit_needed(purpose: &'static str) -> Self {
        Self::Fault(Fault::new(
            Code::E209,
            format!(
                "{purpose} needs a pressure at which the softer body flows: give a pressure limit"
            ),
        ))
    }

    /// The flanks still flow after all cycles.
    pub(crate) fn not_run_in(cycles: usize, left: f64, shakedown: f64) -> Self {
        Self::Fault(Fault::new(Code::E301, format!("after {cycles} cycles the flanks still dissipate {left} of the first cycle's energy, more than the required {shakedown}: allow more cycles or a tighter tolerance of the contacts", left = number(left), shakedown = number(shakedown))).with(Remedy::state(Setting::Key("tolerance")).because("to a smaller one").or_set(Setting::Key("pressure_limit"), Value::Any).because("to a higher one")))
    }

    /// The active set of the dense solver did not settle.
    pub(crate) fn active_set_unsettled(steps: usize, changes: usize) -> Self {
        Self::Fault(Fault::new(
            Code::E209,
            format!("the active set still changed at {changes} points after {steps} steps"),
        ))
    }
}

/// Number of points and of rows, and boundary of a [`Solver`](crate::Solver).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub struct SolverShape {
    /// Number of points.
    pub points: usize,
    /// Rows along the lead; one of a line.
    pub rows: usize,
    /// Boundary of the window.
    pub boundary: Boundary,
}

impl ContactError {
    /// Stable code of the message, for a contact without a case.
    pub fn code(&self) -> Code {
        match self {
            Self::NotConverged { .. } => Code::E301,
            Self::LimitBelowMeanPressure { .. } => Code::E302,
            Self::Fault(fault) => fault.code(),
            _ => Code::E209,
        }
    }
}

impl std::fmt::Display for SolverShape {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self {
            points,
            rows,
            boundary,
        } = self;
        match rows {
            1 => write!(f, "{points} points with {boundary}"),
            _ => write!(f, "{points} points in {rows} rows with {boundary}"),
        }
    }
}

impl From<ContactError> for Fault {
    fn from(error: ContactError) -> Self {
        let key = Setting::Key;
        let remedy = match error {
            ContactError::NotConverged { .. } => Remedy::state(key("tolerance"))
                .because("to a larger one (at most 1e-4)")
                .or_do("look for spikes in the gap"),
            ContactError::LimitBelowMeanPressure { .. } => Remedy::state(key("pressure_limit"))
                .because("to a higher one")
                .or_set(key("load"), Value::Any)
                .because("to a lower one"),
            ContactError::Fault(fault) => return fault,
            _ => Remedy::none(),
        };
        Self::from_cause(error.code(), error).with(remedy)
    }
}
