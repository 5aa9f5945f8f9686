//! JSON of a value.
//!
//! The value is given as `&dyn`: a generic writer is compiled for each part of each type, and in each layout again.

use erased_serde::Serialize;
use serde_json::Value;

use crate::finite::{NotFinite, check_finite};

/// Fault of a value that is to be written as JSON.
#[derive(Debug, thiserror::Error)]
pub enum NotJson {
    /// A number is not finite.
    #[error(transparent)]
    NotFinite(#[from] NotFinite),
    /// JSON cannot hold the value.
    #[error(transparent)]
    Other(#[from] serde_json::Error),
}

/// The value with an indented line for each of its parts.
///
/// # Errors
/// When a number is not finite, or JSON cannot hold the value.
///
/// ```
/// use asperity_storage::json_text;
/// assert_eq!(json_text(&vec![1.5])?, "[\n  1.5\n]");
/// assert!(json_text(&vec![f64::NAN]).is_err());
/// # Ok::<(), asperity_storage::NotJson>(())
/// ```
pub fn json_text(value: &dyn Serialize) -> Result<String, NotJson> {
    check_finite(value)?;
    Ok(serde_json::to_string_pretty(value)?)
}

/// The value in one line.
///
/// # Errors
/// When a number is not finite, or JSON cannot hold the value.
///
/// ```
/// use asperity_storage::json_line;
/// assert_eq!(json_line(&vec![1.5, 2.0])?, "[1.5,2.0]");
/// assert!(json_line(&vec![f64::NAN]).is_err());
/// # Ok::<(), asperity_storage::NotJson>(())
/// ```
pub fn json_line(value: &dyn Serialize) -> Result<String, NotJson> {
    check_finite(value)?;
    Ok(serde_json::to_string(value)?)
}

/// The value as it would be read from its JSON; a number that is not finite is `null`.
///
/// # Errors
/// When JSON cannot hold the value.
///
/// ```
/// use asperity_storage::json_value;
/// assert_eq!(json_value(&Some(1.5))?.as_f64(), Some(1.5));
/// # Ok::<(), serde_json::Error>(())
/// ```
pub fn json_value(value: &dyn Serialize) -> Result<Value, serde_json::Error> {
    serde_json::to_value(value)
}
