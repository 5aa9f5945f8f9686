//! Reading of a whole file into memory.

use std::io::Read;

use crate::read::error::ReadFault;
use crate::read::text::Stream;

/// Maximum size of a file of the areal formats in bytes.
const MOST_BYTES: u64 = 1 << 30;

/// The bytes of a file of `size` bytes.
pub(super) fn whole(stream: &mut dyn Stream, size: u64) -> Result<Vec<u8>, ReadFault> {
    if size > MOST_BYTES {
        return Err(ReadFault::too_large("the file", size, MOST_BYTES));
    }
    let mut bytes = Vec::new();
    stream.rewind()?;
    stream.take(MOST_BYTES).read_to_end(&mut bytes)?;
    Ok(bytes)
}
