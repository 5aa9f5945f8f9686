//! Errors of files that break the rules of their format.

use super::dialect::is_missing;
use super::error::{ReadFault, shortened};
use super::format::Format;
use super::metadata::number;

/// The error for a file that breaks the rules of its format.
pub(super) fn damaged(format: Format, what: &'static str, seen: &str) -> ReadFault {
    ReadFault::Damaged {
        format,
        what,
        seen: shortened(seen),
    }
}

/// The height in `field`.
pub(super) fn height(format: Format, field: &str) -> Result<f64, ReadFault> {
    number(field).ok_or_else(|| damaged(format, "a height is not a number", field))
}

/// The height in `field`, NaN for a point that the format marks as missing.
pub(super) fn height_or_gap(format: Format, field: &str) -> Result<f64, ReadFault> {
    match is_missing(field) {
        true => Ok(f64::NAN),
        false => height(format, field),
    }
}

/// The error for `found` heights where the header states another number.
pub(super) fn miscounted(
    format: Format,
    found: usize,
    stated: impl std::fmt::Display,
) -> ReadFault {
    let what = "the number of heights is not that of the header";
    damaged(format, what, &format!("{found} of {stated}"))
}
