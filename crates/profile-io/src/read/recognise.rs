//! Recognition of the format of a file by its first bytes, then by characteristic lines, then by its name.

use super::format::{Format, extension};
use super::text::Head;

/// First bytes that identify a format.
const MAGIC: &[(&[u8], Format)] = &[
    (b"MATLAB ", Format::Matlab),
    (b"VCA DATA", Format::Opdx),
    (b"\x89HDF\r\n\x1a\n", Format::Hdf5),
    (b"\x01\x00Directory", Format::Opd),
    (b"DIGITAL SURF", Format::DigitalSurf),
    (b"DSCOMPRESSED", Format::DigitalSurf),
    (b"AliconaImaging\0\r\n", Format::AliconaAl3d),
    (b"VK3_", Format::KeyenceVk),
    (b"VK4_", Format::KeyenceVk),
    (b"VK6", Format::KeyenceVk),
    (b"VK7", Format::KeyenceVk),
    (b"\x88\x1b\x03\x6f", Format::MetroPro),
    (b"\x88\x1b\x03\x70", Format::MetroPro),
    (b"\x88\x1b\x03\x71", Format::MetroPro),
    (b"FRTM_GLIDERV", Format::Frt),
    (b"GWYP", Format::Gwyddion),
    (b"GWYO", Format::Gwyddion),
    (b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", Format::Excel),
    (b"aISO-", Format::SdfAscii),
    (b"aBCR-", Format::SdfAscii),
    (b"aBCR ", Format::SdfAscii),
    (b"aBC-", Format::SdfAscii),
    (b"aNPL-", Format::SdfAscii),
    (b"bISO-", Format::SdfBinary),
    (b"bBCR-", Format::SdfBinary),
    (b"bBCR ", Format::SdfBinary),
    (b"bBC-", Format::SdfBinary),
    (b"SigmaSurf_Data", Format::SigmaSurf),
    (b"\x1f\x8b", Format::Archive),
    (b"7z\xbc\xaf\x27\x1c", Format::Archive),
    (b"Rar!", Format::Archive),
    (b"%PDF", Format::Document),
    (b"\x89PNG", Format::Document),
    (b"\xff\xd8\xff", Format::Document),
    (b"BM6", Format::Document),
];

/// File names that identify the maker of a binary file, and two text formats without distinctive lines.
const EXTENSIONS: &[(&str, Format)] = &[
    ("x3p", Format::X3p),
    ("xlsx", Format::Excel),
    ("xlsm", Format::Excel),
    ("xls", Format::Excel),
    ("opdx", Format::Opdx),
    ("opd", Format::Opd),
    ("mat", Format::Matlab),
    ("hwp", Format::HommelHwp),
    ("pip", Format::HommelHwp),
    ("pcd", Format::MahrPcd),
    ("mhp", Format::MahrPcd),
    ("mnt", Format::MountainsMnt),
    ("fts", Format::TaylorHobsonBinary),
    ("mod", Format::TaylorHobsonBinary),
    ("fls", Format::TaylorHobsonBinary),
    ("datx", Format::ZygoDatx),
    ("nms", Format::Nms),
    ("frt", Format::Frt),
    ("gwy", Format::Gwyddion),
    ("lext", Format::Lext),
    ("poir", Format::Lext),
    ("oir", Format::Lext),
    ("zon", Format::KeyenceZon),
    ("cag", Format::KeyenceZon),
    ("os3d", Format::OmniSurf),
    ("plux", Format::SensofarPlux),
    ("sur", Format::DigitalSurf),
    ("pro", Format::DigitalSurf),
    ("plu", Format::SensofarPlu),
    ("sdf", Format::SdfBinary),
];

/// First bytes of a zip.
pub(super) const ZIP: &[u8] = b"PK\x03\x04";

/// The format identified by the first bytes; a zip is identified by its name or its members.
pub(super) fn by_magic(name: &str, head: &[u8]) -> Option<Format> {
    if head.starts_with(ZIP) {
        return Some(by_extension(name).unwrap_or(Format::Archive));
    }
    let found = MAGIC.iter().find(|(magic, _)| head.starts_with(magic));
    let found = found.map(|&(_, format)| format);
    match (found, by_extension(name)) {
        // Containers that are distinguished by the name.
        (Some(Format::Excel), Some(Format::MountainsMnt)) => Some(Format::MountainsMnt),
        (Some(Format::Hdf5), Some(Format::ZygoDatx)) => Some(Format::ZygoDatx),
        // A title may start with these letters, but a number of four bytes follows.
        (Some(Format::KeyenceVk), _) if !head.get(3..12).is_some_and(|b| b.contains(&0)) => None,
        _ => found,
    }
}

/// The format that the file's name suggests, for content that is not text.
pub(super) fn by_extension(name: &str) -> Option<Format> {
    let extension = extension(name);
    let found = EXTENSIONS.iter().find(|(known, _)| *known == extension);
    found.map(|&(_, format)| format)
}

/// The text format identified by characteristic lines near the top, or by the name; `None` for a table.
pub(super) fn of_text(name: &str, head: &Head) -> Option<Format> {
    const LINES_LOOKED_AT: usize = 60;
    let magic = MAGIC
        .iter()
        .find(|(magic, _)| head.text.as_bytes().starts_with(magic));
    if let Some(&(_, format @ (Format::SdfAscii | Format::SigmaSurf))) = magic {
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
    fn a_zip_is_told_by_its_name() {
        assert_eq!(by_magic("a.zip", b"PK\x03\x04"), Some(Format::Archive));
        assert_eq!(by_magic("a.X3P", b"PK\x03\x04"), Some(Format::X3p));
    }

    #[test]
    fn telling_lines_win_over_the_name() {
        let of_text = |name, text: &str| of_text(name, &Head::of(text));
        let mahr = "[PROFILE_HEADER]\nNAME=a";
        assert_eq!(of_text("a.csv", mahr), Some(Format::MahrText));
        assert_eq!(of_text("a.csv", "0.5\n1"), None);
        let xml = "<?xml version=\"1.0\"?>\n<Profile>1</Profile>";
        assert_eq!(of_text("a.csv", xml), Some(Format::Xml));
        let prf = "1 2\na PRF\nCX M 3.0\nCZ M 3.0";
        assert_eq!(of_text("a.txt", prf), Some(Format::TaylorHobsonPrf));
    }
}
