//! Numbers and texts at known offsets of a header; `None` beyond its end.

use encoding_rs::WINDOWS_1252;

/// A number of fixed width.
pub(crate) trait PlainBytes: Sized {
    /// Number of bytes.
    const WIDTH: usize;
    fn little(bytes: &[u8]) -> Option<Self>;
    fn big(bytes: &[u8]) -> Option<Self>;
}

macro_rules! plain {
    ($($type:ty),+) => {$(
        impl PlainBytes for $type {
            const WIDTH: usize = size_of::<$type>();
            fn little(bytes: &[u8]) -> Option<Self> {
                bytes.try_into().ok().map(<$type>::from_le_bytes)
            }
            fn big(bytes: &[u8]) -> Option<Self> {
                bytes.try_into().ok().map(<$type>::from_be_bytes)
            }
        }
    )+};
}

plain!(u8, i8, u16, i16, u32, i32, u64, i64, f32, f64);

/// `length` bytes from `at` on.
pub(super) fn part(bytes: &[u8], at: usize, length: usize) -> Option<&[u8]> {
    bytes.get(at..at.checked_add(length)?)
}

/// The number at `at`, low byte first.
pub(crate) fn little<T: PlainBytes>(bytes: &[u8], at: usize) -> Option<T> {
    T::little(part(bytes, at, T::WIDTH)?)
}

/// The number at `at`, high byte first.
pub(super) fn big<T: PlainBytes>(bytes: &[u8], at: usize) -> Option<T> {
    T::big(part(bytes, at, T::WIDTH)?)
}

/// The text in `length` bytes from `at` on, up to its first zero, trimmed.
pub(super) fn text(bytes: &[u8], at: usize, length: usize) -> Option<String> {
    let field = part(bytes, at, length)?;
    let end = field
        .iter()
        .position(|byte| *byte == 0)
        .unwrap_or(field.len());
    let (text, _) = WINDOWS_1252.decode_without_bom_handling(&field[..end]);
    Some(text.trim().to_owned())
}

/// Sequential reading of bytes.
pub(super) struct Cursor<'a> {
    pub bytes: &'a [u8],
    pub at: usize,
}

impl<'a> Cursor<'a> {
    /// The next number, low byte first.
    pub(super) fn number<T: PlainBytes>(&mut self) -> Option<T> {
        T::little(self.take(T::WIDTH)?)
    }

    /// The next `length` bytes.
    pub(super) fn take(&mut self, length: usize) -> Option<&'a [u8]> {
        let found = part(self.bytes, self.at, length)?;
        self.at += length;
        Some(found)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_lies_beyond_the_end_is_none() {
        let bytes = [1, 2, 3, 4, b'a', 0, b'b'];
        assert_eq!(little::<u16>(&bytes, 0), Some(0x0201));
        assert_eq!(big::<u16>(&bytes, 0), Some(0x0102));
        assert_eq!(little::<u32>(&bytes, 4), None);
        assert_eq!(little::<u8>(&bytes, usize::MAX), None);
        assert_eq!(text(&bytes, 4, 3).as_deref(), Some("a"));
    }
}
