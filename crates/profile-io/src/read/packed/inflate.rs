//! Bounded unpacking of zlib streams.

use std::io::Read;

use flate2::read::ZlibDecoder;

use crate::read::damage::damaged;
use crate::read::error::ReadFault;
use crate::read::format::Format;

/// The content of a zlib stream in a file of `format`, of at most `most` bytes.
pub(crate) fn inflated(format: Format, packed: &[u8], most: u64) -> Result<Vec<u8>, ReadFault> {
    let mut content = Vec::new();
    let unpacked = ZlibDecoder::new(packed)
        .take(most.saturating_add(1))
        .read_to_end(&mut content);
    if unpacked.is_ok() && content.len() as u64 <= most {
        Ok(content)
    } else {
        Err(damaged(format, "a stream cannot be unpacked", ""))
    }
}
