//! Errors of files that break the rules of their format.

use super::dialect::{is_missing, is_word};
use super::error::{ReadFault, shortened};
use super::format::Format;
use super::metadata::number;

/// The error for a file that breaks the rules of its format.
pub(super) fn damaged(format: Format, what: &'static str, seen: &str) -> ReadFault {
    ReadFault::damaged(format, what, &shortened(seen))
}

/// The height in `field`, NaN for a word, which marks a missing point; `None` if it is neither.
pub(super) fn height(field: &str) -> Option<f64> {
    let is_mark = || is_missing(field) || is_word(field);
    number(field).or_else(|| is_mark().then_some(f64::NAN))
}

/// The error for a height `field` that is not a number.
pub(super) fn not_a_number(format: Format, field: &str) -> ReadFault {
    damaged(format, "a height is not a number", field)
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
