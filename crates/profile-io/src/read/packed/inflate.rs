//! Bounded unpacking of zlib streams.

use std::io::Read;

use flate2::read::ZlibDecoder;

/// The content of a zlib stream; `None` if it is damaged or has more than `most` bytes.
pub(super) fn inflated(packed: &[u8], most: u64) -> Option<Vec<u8>> {
    let mut content = Vec::new();
    let unpacked = ZlibDecoder::new(packed)
        .take(most.saturating_add(1))
        .read_to_end(&mut content);
    (unpacked.is_ok() && content.len() as u64 <= most).then_some(content)
}
