//! The format of a file: by its first bytes, then by characteristic lines, last by its name.

use super::areal::held;
use super::encoding;
use super::error::ReadFault;
use super::format::{Format, extension};
use super::options::Encoding;
use super::text::{Head, Start, Stream};

/// First bytes of a zip.
pub(super) const ZIP: &[u8] = b"PK\x03\x04";

/// The format that the first bytes settle; the name or the members decide that of a zip.
pub(super) fn by_magic(name: &str, head: &[u8]) -> Option<Format> {
    if head.starts_with(ZIP) {
        return Some(Format::named(name).unwrap_or(Format::Archive));
    }
    match (Format::starting(head), Format::named(name)) {
        // Containers of several formats, which the name distinguishes.
        (Some(Format::ExcelBinary), Some(Format::MountainsMnt)) => Some(Format::MountainsMnt),
        (Some(Format::Hdf5), Some(Format::ZygoDatx)) => Some(Format::ZygoDatx),
        // A title may start with these letters, but a number of four bytes follows.
        (Some(Format::KeyenceVk), _) if !head.get(3..12).is_some_and(|b| b.contains(&0)) => None,
        // The version of a wave may start any file; its header has 384 bytes.
        (Some(Format::IgorWave), Some(Format::IgorWave)) if head.len() > 384 => {
            Some(Format::IgorWave)
        }
        (Some(Format::IgorWave), _) => None,
        (None, _) if is_npl_xml(head) => Some(Format::NplXml),
        (None, _) if head.starts_with(b"solid ") && holds(head, b"facet normal") => {
            Some(Format::Stl)
        }
        (format, _) => format,
    }
}

/// Whether XML holds the element of the heights.
fn is_npl_xml(head: &[u8]) -> bool {
    let head = head.strip_prefix(b"\xef\xbb\xbf").unwrap_or(head);
    head.trim_ascii_start().starts_with(b"<") && holds(head, b"<DATAFILE>")
}

fn holds(head: &[u8], part: &[u8]) -> bool {
    head.windows(part.len()).any(|bytes| bytes == part)
}

/// The bytes in UTF-8 of a file in UTF-16 whose first line names a format that is read from its bytes.
pub(super) fn recoded(
    stream: &mut dyn Stream,
    start: &Start,
) -> Result<Option<Vec<u8>>, ReadFault> {
    let encoding = encoding::by_mark(&start.bytes);
    let encoding = encoding.filter(|encoding| *encoding != Encoding::Utf8);
    let Some(encoding) = encoding else {
        return Ok(None);
    };
    let is_named = |text: &str| {
        Format::starting(text.as_bytes()).is_some_and(|format| !format.is_read_by_lines())
    };
    if !is_named(&encoding.text(&start.bytes)) {
        return Ok(None);
    }
    let bytes = held::whole(stream, start.size)?;
    Ok(Some(encoding.text(&bytes).into_bytes()))
}

/// The text format that characteristic lines near the top or the name settle; `None` for a table.
pub(super) fn of_text(name: &str, head: &Head) -> Option<Format> {
    const LINES_LOOKED_AT: usize = 60;
    let settled = Format::starting(head.text.as_bytes());
    if let Some(format) = settled.filter(|format| format.is_read_by_lines()) {
        return Some(format);
    }
    if head.text.trim_start().starts_with("<?xml") {
        return Some(Format::Xml);
    }
    let (mut cx, mut cz) = (false, false);
    for line in head.lines().take(LINES_LOOKED_AT) {
        let line = line.text.trim();
        if line == "[PROFILE_VALUES]" || line == "[PROFILE_HEADER]" {
            return Some(Format::MahrText);
        }
        // Record 1 describes the two axes in lines that start CX and CZ.
        cx |= line.starts_with("CX ");
        cz |= line.starts_with("CZ ");
        if cx && cz {
            return Some(Format::TaylorHobsonPrf);
        }
    }
    let second = head.lines().nth(1);
    if second.is_some_and(|line| super::ptb::recognised(line.text)) {
        return Some(Format::PtbPr);
    }
    (extension(name) == "tx3").then_some(Format::SurfcomConditions)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_name_of_a_zip_decides_its_format() {
        assert_eq!(by_magic("a.zip", b"PK\x03\x04"), Some(Format::Archive));
        assert_eq!(by_magic("a.X3P", b"PK\x03\x04"), Some(Format::X3p));
    }

    #[test]
    fn characteristic_lines_win_over_the_name() {
        let of_text = |name, text: &str| of_text(name, &Head::from_text(text));
        let mahr = "[PROFILE_HEADER]\nNAME=a";
        assert_eq!(of_text("a.csv", mahr), Some(Format::MahrText));
        assert_eq!(of_text("a.csv", "0.5\n1"), None);
        let xml = "<?xml version=\"1.0\"?>\n<Profile>1</Profile>";
        assert_eq!(of_text("a.csv", xml), Some(Format::Xml));
        let prf = "1 2\na PRF\nCX M 3.0\nCZ M 3.0";
        assert_eq!(of_text("a.txt", prf), Some(Format::TaylorHobsonPrf));
    }
}
