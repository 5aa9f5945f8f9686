//! Values that a program stores for itself: each with its name, the version that computed it, and the SHA-256 of its content. A
//! stored value is used only if all three are right; any other is computed again.

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use crate::sha256;

/// A stored value as it is in its file.
#[derive(Debug, Serialize, Deserialize)]
struct Sealed<T> {
    name: String,
    version: String,
    sha256: String,
    value: T,
}

/// `value` with its name, the version of the program that computed it, and its sum, as JSON.
///
/// # Errors
/// When the value cannot be written as JSON.
///
/// ```
/// use asperity_storage::{seal, unseal};
/// let stored = seal("film", "1", &vec![0.1, 0.25])?;
/// assert_eq!(unseal::<Vec<f64>>("film", "1", &stored), Some(vec![0.1, 0.25]));
/// // Another name or version, or another number.
/// assert_eq!(unseal::<Vec<f64>>("gap", "1", &stored), None);
/// assert_eq!(unseal::<Vec<f64>>("film", "2", &stored), None);
/// let changed = String::from_utf8(stored)?.replace("0.25", "0.26");
/// assert_eq!(unseal::<Vec<f64>>("film", "1", changed.as_bytes()), None);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn seal(
    name: &str,
    version: &str,
    value: &dyn erased_serde::Serialize,
) -> Result<Vec<u8>, serde_json::Error> {
    serde_json::to_vec(&Sealed {
        name: name.to_owned(),
        version: version.to_owned(),
        sha256: sha256(&serde_json::to_vec(value)?),
        value,
    })
}

/// The value in `bytes` if it has this name and version and is as it was written.
#[must_use]
pub fn unseal<T: Serialize + DeserializeOwned>(
    name: &str,
    version: &str,
    bytes: &[u8],
) -> Option<T> {
    let sealed: Sealed<T> = serde_json::from_slice(bytes).ok()?;
    // Every digit of a number is read and written again, so that equal values have equal text.
    let value: &dyn erased_serde::Serialize = &sealed.value;
    let sum = sha256(&serde_json::to_vec(value).ok()?);
    let is_whole = sealed.name == name && sealed.version == version && sealed.sha256 == sum;
    is_whole.then_some(sealed.value)
}
