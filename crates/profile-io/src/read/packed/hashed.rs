//! MD5 checksum of a stream.

use std::io::Read;

use asperity_storage::hex;
use md5::{Digest, Md5};

/// A reader that computes the MD5 checksum of the bytes read.
pub(super) struct Hashed<R> {
    inner: R,
    hash: Md5,
}

impl<R: Read> Hashed<R> {
    pub(super) fn new(inner: R) -> Self {
        Self {
            inner,
            hash: Md5::new(),
        }
    }

    pub(super) fn finish(self) -> String {
        hex(&self.hash.finalize())
    }
}

impl<R: Read> Read for Hashed<R> {
    fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
        let count = self.inner.read(buffer)?;
        self.hash.update(&buffer[..count]);
        Ok(count)
    }
}
