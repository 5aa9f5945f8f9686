//! Character encodings: byte order marks, UTF-16 without a mark, UTF-8, or Windows-1252.

use encoding_rs::{Decoder, UTF_8, UTF_16BE, UTF_16LE, WINDOWS_1252};

use super::options::Encoding;

impl Encoding {
    /// Decoder of bytes in chunks; a byte order mark is dropped.
    pub(super) fn decoder(self) -> Decoder {
        let encoding = match self {
            Self::Utf8 => UTF_8,
            Self::Utf16Le => UTF_16LE,
            Self::Utf16Be => UTF_16BE,
            Self::Windows1252 => WINDOWS_1252,
        };
        encoding.new_decoder_with_bom_removal()
    }
}

impl Encoding {
    /// The characters of a whole file.
    pub(super) fn text(self, bytes: &[u8]) -> String {
        let mut text = String::new();
        let mut decoder = self.decoder();
        text.reserve(
            decoder
                .max_utf8_buffer_length(bytes.len())
                .unwrap_or(bytes.len()),
        );
        // The reserved length holds all characters.
        let _ = decoder.decode_to_string(bytes, &mut text, true);
        text
    }
}

/// Encoding according to a byte order mark.
pub(super) fn by_mark(head: &[u8]) -> Option<Encoding> {
    match head {
        [0xef, 0xbb, 0xbf, ..] => Some(Encoding::Utf8),
        [0xff, 0xfe, ..] => Some(Encoding::Utf16Le),
        [0xfe, 0xff, ..] => Some(Encoding::Utf16Be),
        _ => None,
    }
}

/// Guesses the encoding of a file without a mark from its first bytes; `whole` if it has no others.
pub(super) fn guess(head: &[u8], whole: bool) -> Encoding {
    const SAMPLE: usize = 4096;
    // Digits in UTF-16 have a zero as their high byte: every other byte of the text.
    let sample = &head[..head.len().min(SAMPLE)];
    let zeros = |first: usize| {
        sample
            .iter()
            .skip(first)
            .step_by(2)
            .filter(|b| **b == 0)
            .count()
    };
    let most = sample.len() / 2;
    if most > 4 {
        let (even, odd) = (zeros(0), zeros(1));
        if odd * 10 > most * 9 && even * 10 < most {
            return Encoding::Utf16Le;
        }
        if even * 10 > most * 9 && odd * 10 < most {
            return Encoding::Utf16Be;
        }
    }
    match std::str::from_utf8(head) {
        Ok(_) => Encoding::Utf8,
        // The end of the head may cut a character.
        Err(error) if error.error_len().is_none() && !whole => Encoding::Utf8,
        Err(_) => Encoding::Windows1252,
    }
}

/// Whether the characters are text: no zeros and almost no control characters.
pub(super) fn is_text(text: &str) -> bool {
    const ONE_IN: usize = 1000;
    let mut control = 0;
    for c in text.chars() {
        match c {
            '\0' => return false,
            '\t' | '\n' | '\r' | '\u{c}' | '\u{1a}' => {}
            c if c.is_control() || c == '\u{fffd}' => control += 1,
            _ => {}
        }
    }
    control * ONE_IN <= text.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_encoding_follows_from_its_mark_its_zeros_or_its_validity() {
        let utf16: Vec<u8> = "0.5;1.25"
            .encode_utf16()
            .flat_map(u16::to_le_bytes)
            .collect();
        assert_eq!(by_mark(&[0xff, 0xfe, b'x', 0]), Some(Encoding::Utf16Le));
        assert_eq!(by_mark(b"\xef\xbb\xbfx"), Some(Encoding::Utf8));
        assert_eq!(by_mark(&utf16), None);
        assert_eq!(guess(&utf16, true), Encoding::Utf16Le);
        assert_eq!(guess(b"[\xc2\xb5m]", true), Encoding::Utf8);
        assert_eq!(guess(b"[\xb5m]", true), Encoding::Windows1252);
        // A character cut at the end of the head may continue in the file.
        assert_eq!(guess(b"[\xc2", false), Encoding::Utf8);
        assert_eq!(guess(b"[\xc2", true), Encoding::Windows1252);
        assert!(!is_text("PK\0\u{3}"));
    }
}
