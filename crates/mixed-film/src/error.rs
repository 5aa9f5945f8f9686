//! Errors of a load share solution.

use asperity_contact::ContactError;
use asperity_core::numerics::RootError;
use asperity_core::quantity::Pressure;
use asperity_core::{Code, DomainError, Fault, number};
use asperity_ehl_regime::RegimeError;
use asperity_oil::LubricantError;
use asperity_tribo_friction::FrictionError;

/// Errors of a load share solution. A caller distinguishes a rough contact without solution, of which it can keep the gap,
/// and a flow pressure that is too low, for which it knows the key.
#[derive(Debug, Clone, thiserror::Error)]
#[non_exhaustive]
pub enum LoadShareError {
    /// The rough contact has no solution, or did not converge.
    #[error(transparent)]
    Contact(#[from] ContactError),
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
    /// An error that no caller distinguishes from others.
    #[error(transparent)]
    Fault(#[from] Fault),
}

impl LoadShareError {
    /// A window of `points` points from point `start` that ends behind a trace of `available` points.
    pub fn window_beyond_trace(start: usize, points: usize, available: usize) -> Self {
        let text = format!(
            "a window of {points} points from point {start} leaves a trace of {available} points"
        );
        Fault::new(Code::E209, text).into()
    }

    /// A row of a contact table that the film needs and nobody solved.
    pub(crate) fn row_not_solved(asperity_share: f64) -> Self {
        let text = format!(
            "the rough contact at asperity share {} is needed and not solved: solve the rows for this film first",
            number(asperity_share)
        );
        Fault::new(Code::E209, text).into()
    }

    /// Patches with a gap law that has no inlet for their flow.
    pub(crate) fn flow_without_inlet() -> Self {
        let text = "patches need the gap law `inlet`: `power` has no flow".to_owned();
        Fault::new(Code::E205, text).into()
    }

    /// A scalar equation for `quantity` without root.
    pub(crate) fn no_root(quantity: &'static str, source: RootError) -> Self {
        let text = format!("the {quantity} has no solution: {source}");
        Fault::new(Code::E301, text).caused_by(source).into()
    }
}

macro_rules! outside_the_domain {
    ($($error:ty),+) => {
        $(impl From<$error> for LoadShareError {
            fn from(error: $error) -> Self {
                Self::Fault(Fault::from_cause(Code::E209, error))
            }
        })+
    };
}

outside_the_domain!(DomainError, RegimeError, FrictionError, LubricantError);

impl From<LoadShareError> for Fault {
    fn from(error: LoadShareError) -> Self {
        Self::from_cause(Code::E209, error)
    }
}
