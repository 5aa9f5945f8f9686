//! Bytes to characters: byte order marks, UTF-16 without one, UTF-8, else Windows-1252.

use std::borrow::Cow;

use encoding_rs::{Encoding as Decoder, UTF_8, UTF_16BE, UTF_16LE, WINDOWS_1252};

use super::options::Encoding;

impl Encoding {
    fn decoder(self) -> &'static Decoder {
        match self {
            Self::Utf8 => UTF_8,
            Self::Utf16Le => UTF_16LE,
            Self::Utf16Be => UTF_16BE,
            Self::Windows1252 => WINDOWS_1252,
        }
    }
}

/// The text and the encoding it was found in; a stated encoding wins over what the bytes say.
pub(super) fn decode(bytes: &[u8], stated: Option<Encoding>) -> (Cow<'_, str>, Encoding) {
    let encoding = stated.unwrap_or_else(|| detect(bytes));
    let (text, _) = encoding.decoder().decode_with_bom_removal(bytes);
    (text, encoding)
}

fn detect(bytes: &[u8]) -> Encoding {
    const SAMPLE: usize = 4096;
    match bytes {
        [0xef, 0xbb, 0xbf, ..] => return Encoding::Utf8,
        [0xff, 0xfe, ..] => return Encoding::Utf16Le,
        [0xfe, 0xff, ..] => return Encoding::Utf16Be,
        _ => {}
    }
    // Digits in UTF-16 have a zero as their high byte: every other byte of the text.
    let sample = &bytes[..bytes.len().min(SAMPLE)];
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
    if std::str::from_utf8(bytes).is_ok() {
        Encoding::Utf8
    } else {
        Encoding::Windows1252
    }
}

/// Whether the characters are text: no zero, and next to no control character.
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
    fn encodings_are_told_by_mark_by_zeros_or_by_validity() {
        let utf16 = |mark: &[u8], text: &str| -> Vec<u8> {
            let body = text.encode_utf16().flat_map(u16::to_le_bytes);
            mark.iter().copied().chain(body).collect()
        };
        assert_eq!(
            decode(&utf16(&[0xff, 0xfe], "x µm"), None),
            ("x µm".into(), Encoding::Utf16Le)
        );
        assert_eq!(
            decode(&utf16(&[], "0.5;1.25"), None),
            ("0.5;1.25".into(), Encoding::Utf16Le)
        );
        assert_eq!(decode(b"\xef\xbb\xbfx", None), ("x".into(), Encoding::Utf8));
        assert_eq!(
            decode(b"[\xb5m]", None),
            ("[µm]".into(), Encoding::Windows1252)
        );
        assert_eq!(
            decode(b"[\xc2\xb5m]", Some(Encoding::Windows1252)).0,
            "[Âµm]"
        );
        assert!(!is_text(&decode(&[0x50, 0, 0x4b, 0x03, 0x91], None).0));
    }
}
