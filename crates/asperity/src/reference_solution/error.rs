//! Errors of the reference solution.

use asperity_core::{Code, Fault};
use asperity_ehl::EhlError;
use asperity_oil::LubricantError;

use asperity_case::error::PositionError;
use asperity_mixed_film::LoadShareError;

/// Errors of the transient reference solution.
#[derive(Debug, Clone, thiserror::Error)]
#[non_exhaustive]
pub enum ReferenceError {
    /// The place on the path has no smooth contact, or a flank no trace.
    #[error(transparent)]
    Position(#[from] PositionError),
    /// The lubricated contact has no solution, or did not converge.
    #[error(transparent)]
    Ehl(#[from] EhlError),
    /// The solved share to compare with has no solution.
    #[error(transparent)]
    Share(#[from] LoadShareError),
    /// The base oil is not known, and with it the Eyring stress.
    #[error("the shear thinning of the film follows from the base oil, and the case names none")]
    NoBaseOil,
}

/// A position whose load share is recorded has the errors of the records.
impl From<ReferenceError> for PositionError {
    fn from(error: ReferenceError) -> Self {
        match error {
            ReferenceError::Position(error) => error,
            ReferenceError::Ehl(error) => Self::Ehl(error),
            ReferenceError::Share(error) => Self::LoadShare(error),
            ReferenceError::NoBaseOil => LubricantError::no_base_oil().into(),
        }
    }
}

macro_rules! by_position {
    ($($error:ty),+) => {
        $(impl From<$error> for ReferenceError {
            fn from(error: $error) -> Self {
                Self::Position(error.into())
            }
        })+
    };
}

by_position!(
    asperity_core::DomainError,
    asperity_ehl_regime::RegimeError,
    asperity_roughness::RoughnessError,
    asperity_tribo_friction::FrictionError,
    LubricantError
);

impl From<ReferenceError> for Fault {
    fn from(error: ReferenceError) -> Self {
        match error {
            ReferenceError::Position(error) => error.into(),
            ReferenceError::Ehl(error) => error.into(),
            error @ ReferenceError::NoBaseOil => Self::from_cause(Code::E208, error)
                .helping("Set lubricant.base_oil in the case: mineral, pao, ester or polyglycol."),
            error @ ReferenceError::Share(_) => Self::from_cause(Code::E305, error),
        }
    }
}
