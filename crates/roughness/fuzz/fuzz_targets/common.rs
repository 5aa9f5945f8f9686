//! What holds for any bytes under any name.

use std::io::{Cursor, Read, Result, Seek, SeekFrom};

use asperity_roughness::read::{ReadOptions, read_bytes, read_stream};

/// Bytes that come a few at a time: chunks end inside numbers, characters, byte order marks and line ends.
struct Drops<'a>(Cursor<&'a [u8]>);

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

/// The bytes are read to finite heights or refused, and in the same way when they come in drops.
pub fn reads_or_refuses(name: &str, bytes: &[u8]) {
    let options = ReadOptions::default();
    let whole = read_bytes(name, bytes, &options);
    if let Ok(reading) = &whole {
        assert!(reading.profile.heights().iter().all(|z| z.is_finite()));
    }
    let drops = read_stream(name, Drops(Cursor::new(bytes)), &options);
    match (whole, drops) {
        (Ok(whole), Ok(drops)) => assert_eq!(whole, drops),
        (Err(whole), Err(drops)) => assert_eq!(whole.to_string(), drops.to_string()),
        (whole, drops) => panic!("{whole:?} at once, {drops:?} in drops"),
    }
}
