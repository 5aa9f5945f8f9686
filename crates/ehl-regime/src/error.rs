//! Errors of a film or a regime.

use asperity_core::{Code, DomainError, Fault};

/// Errors of film thickness and regime.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RegimeError {
    /// An input outside its domain.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// A film law needs an input that was not given.
    #[error("the film law {law} needs {input}")]
    MissingInput {
        /// The law, by its name in a case file.
        law: &'static str,
        /// The input, by its field name.
        input: &'static str,
    },
}

impl From<RegimeError> for Fault {
    fn from(error: RegimeError) -> Self {
        let code = match error {
            RegimeError::MissingInput { .. } => Code::E205,
            RegimeError::Domain(_) => Code::E209,
        };
        Self::of(code, error)
    }
}
