//! Refusal of tables of gearbox losses, in a build without the feature `case-files`.

use asperity_core::message::Warning;
use asperity_core::{Code, Fault};
use asperity_efficiency::loss_table::LossTable;

/// Reasons why a file is not a table of losses.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum LossTableError {
    /// This build reads no tables.
    #[error("{name}: is read only by a build with feature case-files")]
    NotRead {
        /// Name of the table.
        name: String,
    },
}

/// Refuses the table.
///
/// # Errors
/// Always.
pub fn read(name: &str, _: &str) -> Result<(LossTable, Option<Warning>), LossTableError> {
    Err(LossTableError::NotRead {
        name: name.to_owned(),
    })
}

impl From<LossTableError> for Fault {
    fn from(error: LossTableError) -> Self {
        Self::of(Code::E138, error)
    }
}
