//! Reading of a whole file into memory, and the limit of unpacked sizes.

use std::io::Read;

use crate::read::error::ReadFault;
use crate::read::text::Stream;

/// Maximum size of a file of the areal formats in bytes.
const MOST_BYTES: u64 = 1 << 30;

/// Unpacked size that is always permitted, in bytes.
const FREE: u64 = 16 << 20;
/// Maximum ratio of the unpacked to the packed size of larger members.
const RATIO: u64 = 200;
/// Maximum unpacked size of a member in bytes: 10⁸ heights.
const MOST: u64 = 1 << 30;

/// The bytes of a file of `size` bytes.
pub(crate) fn whole(stream: &mut dyn Stream, size: u64) -> Result<Vec<u8>, ReadFault> {
    if size > MOST_BYTES {
        return Err(ReadFault::too_large("the file", size, MOST_BYTES));
    }
    let mut bytes = Vec::new();
    stream.rewind()?;
    stream.take(MOST_BYTES).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// Maximum unpacked size of `packed` bytes.
pub(crate) fn most_unpacked(packed: u64) -> u64 {
    FREE.max(packed.saturating_mul(RATIO)).min(MOST)
}
