//! Profiles as SMD (ISO 5436-2).

use std::fmt::Write as _;

use asperity_core::Profile;

use super::field::field;
use crate::read::metadata::Metadata;

/// End of a record and of the file.
const END_OF_RECORD: &str = "\u{3}\r\n";
const END_OF_FILE: char = '\u{1a}';

/// Writes four records: axes, description, heights, checksum.
pub(super) fn write(profile: &Profile, metadata: &Metadata) -> Vec<u8> {
    let n = profile.len();
    let title = metadata
        .title
        .as_deref()
        .map_or_else(|| "profile".to_owned(), ascii);
    let mut text = format!(
        "ISO 5436-2:2012\0{title}\0\r\nPRF\0 1 ISO5436\0\r\n\
         CX\0 I\0 {n} m\0 1.0e0 D\0 {:e}\0\r\nCZ\0 A\0 {n} m\0 1.0e0 D\0\r\n{END_OF_RECORD}",
        profile.spacing().si()
    );
    for (name, value) in [
        ("DATE", &metadata.date),
        ("INSTRUMENT_ID", &metadata.instrument),
    ] {
        if let Some(value) = value {
            let _ = write!(text, "{name} {}\0\r\n", ascii(value));
        }
    }
    text += END_OF_RECORD;
    for z in profile.heights() {
        let _ = write!(text, "{z:e}\r\n");
    }
    text += END_OF_RECORD;
    let sum = text
        .bytes()
        .fold(0_u16, |sum, byte| sum.wrapping_add(byte.into()));
    let _ = write!(text, "{sum}\r\n{END_OF_RECORD}{END_OF_FILE}");
    text.into_bytes()
}

/// `text` in ASCII, as the format requires.
fn ascii(text: &str) -> String {
    field(text)
        .replace(['µ', 'μ'], "u")
        .chars()
        .map(|c| if c.is_ascii() { c } else { '?' })
        .collect()
}
