//! Errors of a load share solution.

use asperity_contact::ContactError;
use asperity_core::numerics::RootError;
use asperity_core::quantity::Pressure;
use asperity_core::{Code, Fault};
use asperity_core::{DomainError, number};
use asperity_ehl_regime::RegimeError;
use asperity_oil::LubricantError;
use asperity_tribo_friction::FrictionError;

/// Errors of a load share solution.
#[derive(Debug, Clone, thiserror::Error)]
#[non_exhaustive]
pub enum LoadShareError {
    /// A number outside its domain.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// The rough contact has no solution, or did not converge.
    #[error(transparent)]
    Contact(#[from] ContactError),
    /// The film refuses the numbers.
    #[error(transparent)]
    Regime(#[from] RegimeError),
    /// Friction refuses the numbers.
    #[error(transparent)]
    Friction(#[from] FrictionError),
    /// The oil has no state or no shear stress at a temperature of the film.
    #[error(transparent)]
    Lubricant(#[from] LubricantError),
    /// A flow pressure that the film pressure reaches without asperities.
    #[error(
        "flow pressure {flow_pressure:.6} is below {least:.6}, one and a half times the Hertz pressure: the flank would yield under the film alone"
    )]
    FlowPressureTooLow {
        /// The flow pressure.
        flow_pressure: Pressure,
        /// Least accepted.
        least: Pressure,
    },
    /// A window beyond the end of a trace.
    #[error("a window of {points} points from point {start} leaves a trace of {available} points")]
    WindowBeyondTrace {
        /// First point of the window.
        start: usize,
        /// Points of the window.
        points: usize,
        /// Points of the trace.
        available: usize,
    },
    /// A row of a contact table that the film needs and nobody solved.
    #[error(
        "the rough contact at asperity share {asperity_share} is needed and not solved: solve the rows for this film first", asperity_share = number(*asperity_share))]
    RowNotSolved {
        /// Asperity share of the row.
        asperity_share: f64,
    },
    /// A scalar equation without root.
    #[error("the {quantity} has no solution: {source}")]
    NoRoot {
        /// Name that was looked for.
        quantity: &'static str,
        /// Error of the root search.
        source: RootError,
    },
}

impl From<LoadShareError> for Fault {
    fn from(error: LoadShareError) -> Self {
        Self::of(Code::E209, error)
    }
}
