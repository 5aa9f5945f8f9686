//! SHA-256 of everything that a stored result depends on.

pub use asperity_storage::sha256;

use asperity_storage::hex;
use sha2::{Digest, Sha256};

/// SHA-256 of several inputs and of the version of the program: another version may compute other numbers from them.
///
/// ```
/// use asperity_case::fingerprint::Fingerprint;
/// let of = |parts: [&[u8]; 2]| Fingerprint::default().with(parts[0]).with(parts[1]).hex();
/// assert_eq!(of([b"flank", b"oil"]), of([b"flank", b"oil"]));
/// // The boundary between two inputs counts.
/// assert_ne!(of([b"flank", b"oil"]), of([b"flanko", b"il"]));
/// ```
#[derive(Debug, Clone)]
pub struct Fingerprint(Sha256);

impl Default for Fingerprint {
    fn default() -> Self {
        Self(Sha256::new()).with(env!("CARGO_PKG_VERSION"))
    }
}

impl Fingerprint {
    /// Adds an input.
    #[must_use]
    pub fn with(mut self, input: impl AsRef<[u8]>) -> Self {
        let input = input.as_ref();
        self.0.update((input.len() as u64).to_le_bytes());
        self.0.update(input);
        self
    }

    /// 64 hexadecimal digits.
    #[must_use]
    pub fn hex(self) -> String {
        hex(&self.0.finalize())
    }
}
