//! Known file formats, supported or not.
//!
//! Unsupported formats are named so that the message can explain how to export.

use serde::{Deserialize, Serialize};

/// A file format.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Format {
    /// Rows of numbers as text, in any dialect.
    DelimitedText,
    /// A matrix of heights as text, one trace per row.
    TextMatrix,
    /// A column of heights after the spacing in um (NPL softgauge text).
    NplText,
    /// A column of heights in um after nominal length and number of points (Surfcom tx1, tx2).
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
    /// Digital Surf exchange format (sur, pro).
    DigitalSurf,
    /// MountainsMap document.
    MountainsMnt,
    /// Alicona surface.
    AliconaAl3d,
    /// Keyence laser microscope (vk3, vk4, vk6, vk7).
    KeyenceVk,
    /// Keyence one-shot microscopes and archives (zon, cag).
    KeyenceZon,
    /// Sensofar, one binary file.
    #[serde(alias = "sensofar")]
    SensofarPlu,
    /// Sensofar, zip and XML.
    SensofarPlux,
    /// Zygo MetroPro (dat).
    MetroPro,
    /// Zygo Mx, HDF5 (datx).
    ZygoDatx,
    /// NanoFocus.
    Nms,
    /// FRT MicroProf.
    Frt,
    /// Gwyddion document.
    Gwyddion,
    /// Olympus laser microscopes (lext, poir, oir).
    Lext,
    /// Digital Metrology OmniSurf3D.
    OmniSurf,
    /// Taylor Hobson binaries (fts, mod, fls).
    TaylorHobsonBinary,
    /// ISO 25178-71 as text.
    SdfAscii,
    /// ISO 25178-71, binary.
    SdfBinary,
    /// SigmaSurf text.
    SigmaSurf,
    /// ISO 5436-2 SMD.
    Smd,
    /// Taylor Hobson text profile (prf), which NPL also writes.
    TaylorHobsonPrf,
    /// Hommel text profile (hfm).
    HommelHfm,
    /// Dektak profile with its meta data as text.
    DektakCsv,
    /// PTB reference software text.
    PtbPr,
    /// XML of an unknown layout.
    Xml,
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
            Self::TextMatrix => "matrix of heights as text",
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
            Self::HommelHwp => "Hommel binary (hwp, pip)",
            Self::MahrPcd => "Mahr binary (pcd, mhp)",
            Self::MahrText => "Mahr [PROFILE_VALUES] text",
            Self::DigitalSurf => "Digital Surf (sur, pro)",
            Self::MountainsMnt => "MountainsMap document (mnt)",
            Self::AliconaAl3d => "Alicona al3d",
            Self::KeyenceVk => "Keyence vk",
            Self::KeyenceZon => "Keyence zon or cag",
            Self::SensofarPlu => "Sensofar plu",
            Self::SensofarPlux => "Sensofar plux",
            Self::MetroPro => "Zygo MetroPro (dat)",
            Self::ZygoDatx => "Zygo datx",
            Self::Nms => "NanoFocus nms",
            Self::Frt => "FRT MicroProf",
            Self::Gwyddion => "Gwyddion gwy",
            Self::Lext => "Olympus lext, poir or oir",
            Self::OmniSurf => "OmniSurf3D os3d",
            Self::TaylorHobsonBinary => "Taylor Hobson binary (fts, mod, fls)",
            Self::SdfAscii => "SDF text (ISO 25178-71)",
            Self::SdfBinary => "binary SDF (ISO 25178-71)",
            Self::SigmaSurf => "SigmaSurf sig",
            Self::Smd => "SMD (ISO 5436-2)",
            Self::TaylorHobsonPrf => "Taylor Hobson text profile (prf)",
            Self::HommelHfm => "Hommel text profile (hfm)",
            Self::DektakCsv => "Dektak csv",
            Self::PtbPr => "PTB pr",
            Self::Xml => "XML",
            Self::Archive => "a compressed archive",
            Self::Document => "a picture or document",
            Self::UnknownBinary => "binary data of an unknown format",
        })
    }
}

impl Format {
    /// Remedy for an unsupported format.
    pub fn remedy(self) -> &'static str {
        match self {
            Self::SurfcomConditions => {
                "read the .tx1 (primary) or .tx2 (roughness) file beside it, which holds the heights"
            }
            Self::Xml => {
                "export the profile as X3P, SMD, SDF, prf or text; of an X3P pass the archive, not its main.xml"
            }
            Self::Archive => "unpack it first",
            Self::Document => "export the heights, not the report",
            Self::MahrPcd => "export the profile as X3P or as text from MarWin",
            Self::HommelHwp => {
                "export the profile as text (hfm) or as X3P from the Hommel software"
            }
            Self::TaylorHobsonBinary => {
                "export the profile as text (prf), the surface as X3P or SDF from the Talysurf software"
            }
            Self::MountainsMnt => "save the studiable as sur, pro or X3P from MountainsMap",
            Self::ZygoDatx => "export the surface as dat (MetroPro), X3P or text from Mx",
            Self::Lext | Self::KeyenceZon | Self::Nms | Self::Frt | Self::OmniSurf => {
                "export the surface as X3P, SDF or text"
            }
            Self::Gwyddion => "export the surface as SDF or as a text matrix from Gwyddion",
            Self::Hdf5 => "export the profile as text, or as MATLAB data of level 5 (-v7)",
            _ => "export the profile as text with an x and a height column",
        }
    }

    /// Whether a file of the format may hold several profiles: a surface, or traces side by side.
    ///
    /// ```
    /// use asperity_profile_io::read::Format;
    /// assert!(Format::X3p.may_hold_several() && !Format::MahrText.may_hold_several());
    /// ```
    pub fn may_hold_several(self) -> bool {
        matches!(
            self,
            Self::X3p
                | Self::SdfAscii
                | Self::SdfBinary
                | Self::TextMatrix
                | Self::DigitalSurf
                | Self::AliconaAl3d
                | Self::KeyenceVk
                | Self::SensofarPlu
                | Self::SensofarPlux
                | Self::MetroPro
                | Self::Opd
                | Self::Opdx
                | Self::Matlab
        )
    }
}

/// Lower-case extension; empty if there is none.
pub(super) fn extension(name: &str) -> String {
    let after_folder = name.rsplit(['/', '\\']).next().unwrap_or_default();
    let found = after_folder.rsplit_once('.');
    found.map_or_else(String::new, |(_, extension)| extension.to_lowercase())
}
