//! A file that comes a few bytes at a time.

use std::io::{Cursor, Read, Result, Seek, SeekFrom};

/// Chunks end inside numbers, characters, byte order marks and line ends.
pub struct Drops<'a>(pub Cursor<&'a [u8]>);

impl Read for Drops<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> Result<usize> {
        const MOST: usize = 7;
        let most = buffer.len().min(MOST);
        self.0.read(&mut buffer[..most])
    }
}

impl Seek for Drops<'_> {
    fn seek(&mut self, to: SeekFrom) -> Result<u64> {
        self.0.seek(to)
    }
}
