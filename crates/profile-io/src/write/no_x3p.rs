//! Refusal to write X3P, in a build without the feature `packed`.

use super::error::WriteError;
use super::places::Places;
use crate::read::metadata::Metadata;

/// Refuses to write.
pub(super) fn write(
    _: Places<'_>,
    _: &[f64],
    _: Option<(usize, f64)>,
    _: &Metadata,
) -> Result<Vec<u8>, WriteError> {
    Err(WriteError::not_packed())
}
