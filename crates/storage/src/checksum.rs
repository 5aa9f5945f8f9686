//! SHA-256 sums and hexadecimal digits.

use sha2::{Digest, Sha256};

/// SHA-256 of `bytes` in hexadecimal digits.
///
/// ```
/// assert!(asperity_storage::sha256(b"abc").starts_with("ba7816bf"));
/// ```
pub fn sha256(bytes: &[u8]) -> String {
    hex(&Sha256::digest(bytes))
}

/// `bytes` in hexadecimal digits.
pub fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}
