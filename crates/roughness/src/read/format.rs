//! Which format a file is in: by its first bytes, then by telling lines, last by its name.
//!
//! Formats that are known but not read are named, so that the user learns what to export instead.

use serde::Serialize;

use super::text::Head;

/// A file format.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Format {
    /// Rows of numbers as text, in any dialect.
    DelimitedText,
    /// One column of heights under the spacing in um (NPL softgauge text).
    NplText,
    /// One column of heights in um under nominal length and number of points (Surfcom tx1, tx2).
    SurfcomText,
    /// Measuring conditions of a Surfcom trace (tx3).
    SurfcomConditions,
    /// ISO 25178-72.
    X3p,
    /// A workbook, old or new.
    Excel,
    /// Mitutoyo SurfTest workbook.
    MitutoyoXlsx,
    /// Bruker Dektak, binary.
    Opdx,
    /// Wyko and Veeco, binary.
    Opd,
    /// MATLAB data.
    Matlab,
    /// HDF5.
    Hdf5,
    /// Hommel, binary.
    HommelHwp,
    /// Mahr, binary.
    MahrPcd,
    /// Mahr `[PROFILE_VALUES]` text.
    MahrText,
    /// Digital Surf and MountainsMap (mnt, sur, pro).
    DigitalSurf,
    /// Sensofar.
    Sensofar,
    /// ISO 25178-71 as text.
    SdfAscii,
    /// ISO 25178-71, binary.
    SdfBinary,
    /// SigmaSurf text.
    SigmaSurf,
    /// ISO 5436-2 SMD.
    Smd,
    /// Taylor Hobson text profile (prf), as NPL writes it too.
    TaylorHobsonPrf,
    /// Hommel text profile (hfm).
    HommelHfm,
    /// Dektak profile with its meta data as text.
    DektakCsv,
    /// PTB reference software text.
    PtbPr,
    /// A compressed archive.
    Archive,
    /// A picture or a printed report.
    Document,
    /// Binary data of an unknown kind.
    UnknownBinary,
}

impl std::fmt::Display for Format {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::DelimitedText => "delimited text",
            Self::NplText => "NPL text profile",
            Self::SurfcomText => "Surfcom text profile",
            Self::SurfcomConditions => "Surfcom measuring conditions (tx3)",
            Self::X3p => "X3P (ISO 25178-72)",
            Self::Excel => "Excel workbook",
            Self::MitutoyoXlsx => "Mitutoyo SurfTest workbook",
            Self::Opdx => "Bruker OPDx",
            Self::Opd => "Wyko OPD",
            Self::Matlab => "MATLAB data (mat)",
            Self::Hdf5 => "HDF5",
            Self::HommelHwp => "Hommel hwp",
            Self::MahrPcd => "Mahr pcd",
            Self::MahrText => "Mahr [PROFILE_VALUES] text",
            Self::DigitalSurf => "Digital Surf (mnt, sur, pro)",
            Self::Sensofar => "Sensofar plu",
            Self::SdfAscii => "SDF text (ISO 25178-71)",
            Self::SdfBinary => "binary SDF (ISO 25178-71)",
            Self::SigmaSurf => "SigmaSurf sig",
            Self::Smd => "SMD (ISO 5436-2)",
            Self::TaylorHobsonPrf => "Taylor Hobson text profile (prf)",
            Self::HommelHfm => "Hommel text profile (hfm)",
            Self::DektakCsv => "Dektak csv",
            Self::PtbPr => "PTB pr",
            Self::Archive => "a compressed archive",
            Self::Document => "a picture or document",
            Self::UnknownBinary => "binary data of an unknown format",
        })
    }
}

impl Format {
    /// What the user can do about a format that is not read.
    pub fn remedy(self) -> &'static str {
        match self {
            Self::SurfcomConditions => {
                "read the .tx1 (primary) or .tx2 (roughness) file beside it, which holds the heights"
            }
            Self::Archive => "unpack it first",
            Self::Document => "export the heights, not the report",
            _ => "export the profile as text with an x and a height column",
        }
    }
}

/// First bytes that settle the format.
const MAGIC: &[(&[u8], Format)] = &[
    (b"MATLAB ", Format::Matlab),
    (b"VCA DATA", Format::Opdx),
    (b"\x89HDF\r\n\x1a\n", Format::Hdf5),
    (b"\x01\x00Directory", Format::Opd),
    (b"DIGITAL SURF", Format::DigitalSurf),
    (b"DSCOMPRESSED", Format::DigitalSurf),
    (b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", Format::Excel),
    (b"aISO-", Format::SdfAscii),
    (b"aBCR-", Format::SdfAscii),
    (b"aBCR ", Format::SdfAscii),
    (b"aBC-", Format::SdfAscii),
    (b"aNPL-", Format::SdfAscii),
    (b"bISO-", Format::SdfBinary),
    (b"bBCR-", Format::SdfBinary),
    (b"SigmaSurf_Data", Format::SigmaSurf),
    (b"\x1f\x8b", Format::Archive),
    (b"7z\xbc\xaf\x27\x1c", Format::Archive),
    (b"Rar!", Format::Archive),
    (b"%PDF", Format::Document),
    (b"\x89PNG", Format::Document),
    (b"\xff\xd8\xff", Format::Document),
    (b"BM6", Format::Document),
];

/// Names that tell a binary file's maker, and two text formats without telling lines.
const EXTENSIONS: &[(&str, Format)] = &[
    ("x3p", Format::X3p),
    ("xlsx", Format::Excel),
    ("xlsm", Format::Excel),
    ("xls", Format::Excel),
    ("opdx", Format::Opdx),
    ("opd", Format::Opd),
    ("mat", Format::Matlab),
    ("hwp", Format::HommelHwp),
    ("pcd", Format::MahrPcd),
    ("mnt", Format::DigitalSurf),
    ("sur", Format::DigitalSurf),
    ("pro", Format::DigitalSurf),
    ("plu", Format::Sensofar),
    ("sdf", Format::SdfBinary),
];

/// First bytes of a zip.
pub(super) const ZIP: &[u8] = b"PK\x03\x04";

/// The format that the first bytes settle, if they do; a zip is told by its name or its members.
pub(super) fn by_magic(name: &str, head: &[u8]) -> Option<Format> {
    if head.starts_with(ZIP) {
        return Some(by_extension(name).unwrap_or(Format::Archive));
    }
    let found = MAGIC.iter().find(|(magic, _)| head.starts_with(magic));
    found.map(|&(_, format)| format)
}

/// The format that the file's name suggests, for content that is not text.
pub(super) fn by_extension(name: &str) -> Option<Format> {
    let extension = extension(name);
    let found = EXTENSIONS.iter().find(|(known, _)| *known == extension);
    found.map(|&(_, format)| format)
}

/// Lower-case extension, empty when there is none.
pub(super) fn extension(name: &str) -> String {
    let after_folder = name.rsplit(['/', '\\']).next().unwrap_or_default();
    let found = after_folder.rsplit_once('.');
    found.map_or_else(String::new, |(_, extension)| extension.to_lowercase())
}

/// The text format that telling lines near the top settle, or the name; none for a table.
pub(super) fn of_text(name: &str, head: &Head) -> Option<Format> {
    const LINES_LOOKED_AT: usize = 60;
    let magic = MAGIC
        .iter()
        .find(|(magic, _)| head.text.as_bytes().starts_with(magic));
    if let Some(&(_, format @ (Format::SdfAscii | Format::SigmaSurf))) = magic {
        return Some(format);
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
        let prf = "1 2\na PRF\nCX M 3.0\nCZ M 3.0";
        assert_eq!(of_text("a.txt", prf), Some(Format::TaylorHobsonPrf));
    }
}
