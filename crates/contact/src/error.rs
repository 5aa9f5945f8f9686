//! What can be wrong with a contact problem.

use asperity_core::DomainError;

/// Why a contact problem has no answer.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ContactError {
    /// An input outside its domain.
    #[error(transparent)]
    Domain(#[from] DomainError),
}
