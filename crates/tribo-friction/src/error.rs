//! Errors of a friction coefficient or force.

use asperity_core::numerics::RootError;
use asperity_core::{Code, DomainError, Fault};
use asperity_oil::LubricantError;

/// Errors of friction laws.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FrictionError {
    /// An input outside its domain.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// A missing setting of a friction law.
    #[error("the friction law {law} needs the setting {setting}")]
    MissingSetting {
        /// The law, by its name in a case file.
        law: &'static str,
        /// The setting, by its field name.
        setting: &'static str,
    },
    /// Two pressure fields of different size.
    #[error("{solid} solid and {fluid} fluid pressures; both must be given at the same points")]
    FieldLengths {
        /// Number of solid pressures.
        solid: usize,
        /// Number of fluid pressures.
        fluid: usize,
    },
    /// A coefficient file that cannot be read.
    #[error("coefficient file: {reason}")]
    CoefficientFile {
        /// Line, from 1.
        line: usize,
        /// Column, from 1.
        column: usize,
        /// Message of the JSON reader, with its place.
        reason: String,
    },
    /// The oil has no state or no shear stress at a temperature of the film.
    #[error(transparent)]
    Lubricant(#[from] LubricantError),
    /// An equation without a root.
    #[error("the {quantity} has no solution: {source}")]
    NoRoot {
        /// Name of the quantity.
        quantity: &'static str,
        /// Error of the root search.
        source: RootError,
    },
}

impl From<FrictionError> for Fault {
    fn from(error: FrictionError) -> Self {
        let code = match error {
            FrictionError::MissingSetting { .. } => Code::E205,
            _ => Code::E209,
        };
        Self::of(code, error)
    }
}
