//! Reading of a whole file into memory.

use std::io::Read;

use crate::read::error::ReadError;
use crate::read::text::Stream;

/// Maximum size of a file of the areal formats in bytes.
const MOST_BYTES: u64 = 1 << 30;

/// The bytes of a file of `size` bytes.
pub(super) fn whole(file: &str, stream: &mut dyn Stream, size: u64) -> Result<Vec<u8>, ReadError> {
    if size > MOST_BYTES {
        return Err(ReadError::TooLarge {
            file: file.to_owned(),
            what: "the file",
            bytes: size,
            most: MOST_BYTES,
        });
    }
    let mut bytes = Vec::new();
    let read = stream
        .rewind()
        .and_then(|()| stream.take(MOST_BYTES).read_to_end(&mut bytes));
    read.map_err(|source| ReadError::NotReadable {
        file: file.to_owned(),
        source,
    })?;
    Ok(bytes)
}
