//! The known file formats, read or not, one row each.
//!
//! Unsupported formats are named so that the message can explain how to export.

use serde::{Deserialize, Serialize};

/// A format whose files hold one profile.
const ONE: bool = false;
/// A format whose files may hold a surface, or traces side by side.
const SEVERAL: bool = true;
/// Remedy for a format that is not read, if its row has none.
const AS_TEXT: &str = "export the profile as text with an x and a height column";
/// Remedy for a packed format in a build that does not unpack.
const UNPACKED: &str =
    "take a released binary or wheel, build with feature packed, or export the profile as text";

/// Facts about a format without its reader.
struct FormatRow {
    format: Format,
    title: &'static str,
    starts: &'static [&'static [u8]],
    extensions: &'static [&'static str],
    may_hold_several: bool,
    remedy: &'static str,
}

/// Rows `Name "title" [first bytes that settle it] [extensions that suggest it] ONE or SEVERAL "remedy";`.
macro_rules! formats {
    ($($(#[$meta:meta])+ $name:ident $title:literal [$($start:literal),*] [$($extension:literal),*] $holds:ident
        $($remedy:expr)?;)+) => {
        /// A file format.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
        #[serde(rename_all = "kebab-case")]
        #[non_exhaustive]
        pub enum Format {
            $($(#[$meta])+ $name),+
        }

        const ROWS: &[FormatRow] = &[$(FormatRow {
            format: Format::$name,
            title: $title,
            starts: &[$($start),*],
            extensions: &[$($extension),*],
            may_hold_several: $holds,
            remedy: [$($remedy,)? AS_TEXT][0],
        }),+];
    };
}

formats! {
    /// Rows of numbers as text, in any dialect.
    DelimitedText "delimited text" [] [] ONE;
    /// A matrix of heights as text, one trace a row.
    TextMatrix "matrix of heights as text" [] [] SEVERAL;
    /// Points x, y, z as text, line by line.
    PointText "points x, y, z as text" [] [] SEVERAL;
    /// One column of heights under the spacing in um (NPL softgauge text).
    NplText "NPL text profile" [] [] ONE;
    /// One column of heights in um under nominal length and number of points (Surfcom tx1, tx2).
    SurfcomText "Surfcom text profile" [] [] ONE;
    /// Measuring conditions of a Surfcom trace (tx3).
    SurfcomConditions "Surfcom measuring conditions (tx3)" [] [] ONE
        "read the .tx1 (primary) or .tx2 (roughness) file next to it, which has the heights";
    /// ISO 25178-72.
    X3p "X3P (ISO 25178-72)" [] ["x3p"] SEVERAL UNPACKED;
    /// A workbook as a zip.
    Excel "workbook (xlsx, ods)" [] ["xlsx", "xlsm", "ods"] SEVERAL UNPACKED;
    /// A workbook of Excel 97 to 2003.
    ExcelBinary "Excel workbook before 2007 (xls)" [b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1"] ["xls"] SEVERAL UNPACKED;
    /// Mitutoyo SurfTest workbook.
    MitutoyoXlsx "Mitutoyo SurfTest workbook" [] [] ONE;
    /// Bruker Dektak, binary.
    Opdx "Bruker OPDx" [b"VCA DATA"] ["opdx"] SEVERAL;
    /// Wyko and Veeco, binary.
    Opd "Wyko OPD" [b"\x01\x00Directory"] ["opd"] SEVERAL;
    /// Wyko and Veeco, text of Vision.
    WykoText "Wyko ASCII" [b"Wyko ASCII Data File"] [] SEVERAL;
    /// MATLAB data.
    Matlab "MATLAB data (mat)" [b"MATLAB "] ["mat"] SEVERAL UNPACKED;
    /// HDF5.
    Hdf5 "HDF5" [b"\x89HDF\r\n\x1a\n"] ["h5", "hdf5"] SEVERAL
        "take a released binary or wheel, which read HDF5, build with feature hdf5, or export the profile as text or as MATLAB data of level 5 (-v7)";
    /// Hommel, binary.
    HommelHwp "Hommel binary (hwp, pip)" [] ["hwp", "pip"] ONE
        "export the profile as text (hfm) or as X3P from the Hommel software";
    /// Mahr, binary.
    MahrPcd "Mahr binary (pcd, mhp)" [] ["pcd", "mhp"] ONE "export the profile as X3P or as text from MarWin";
    /// Mahr `[PROFILE_VALUES]` text.
    MahrText "Mahr [PROFILE_VALUES] text" [] [] ONE;
    /// Digital Surf exchange format (sur, pro).
    DigitalSurf "Digital Surf (sur, pro)" [b"DIGITAL SURF", b"DSCOMPRESSED"] ["sur", "pro"] SEVERAL UNPACKED;
    /// MountainsMap document.
    MountainsMnt "MountainsMap document (mnt)" [] ["mnt"] ONE "save the studiable as sur, pro or X3P from MountainsMap";
    /// Alicona surface.
    AliconaAl3d "Alicona al3d" [b"AliconaImaging\0\r\n"] [] SEVERAL;
    /// Keyence laser microscope (vk3, vk4, vk6, vk7).
    KeyenceVk "Keyence vk" [b"VK3_", b"VK4_", b"VK6", b"VK7"] [] SEVERAL UNPACKED;
    /// Keyence one-shot microscopes and archives (zon, cag).
    KeyenceZon "Keyence zon or cag" [] ["zon", "cag"] ONE "export the surface as X3P, SDF or text";
    /// Sensofar, one binary file.
    #[serde(alias = "sensofar")]
    SensofarPlu "Sensofar plu" [] ["plu"] SEVERAL;
    /// Sensofar, zip and XML.
    SensofarPlux "Sensofar plux" [] ["plux"] SEVERAL UNPACKED;
    /// Zygo MetroPro (dat).
    MetroPro "Zygo MetroPro (dat)" [b"\x88\x1b\x03\x6f", b"\x88\x1b\x03\x70", b"\x88\x1b\x03\x71"] [] SEVERAL;
    /// Zygo MetroPro and Mx, points as text (xyz).
    ZygoXyz "Zygo XYZ text" [b"Zygo XYZ Data File"] [] SEVERAL;
    /// Zygo MetroPro, phases as text (asc).
    ZygoText "Zygo ASCII" [b"Zygo ASCII Data File"] [] SEVERAL;
    /// Zygo Mx, HDF5 (datx).
    ZygoDatx "Zygo datx" [] ["datx"] SEVERAL
        "take a released binary or wheel, which read HDF5, build with feature hdf5, or export the surface as dat (MetroPro), X3P or text from Mx";
    /// NanoFocus.
    Nms "NanoFocus nms" [] ["nms"] ONE "export the surface as X3P, SDF or text";
    /// FRT MicroProf.
    Frt "FRT MicroProf" [b"FRTM_GLIDERV"] ["frt"] ONE "export the surface as X3P, SDF or text";
    /// Gwyddion document.
    Gwyddion "Gwyddion gwy" [b"GWYP", b"GWYO"] ["gwy"] SEVERAL;
    /// Gwyddion Simple Field.
    GwyddionSimple "Gwyddion Simple Field (gsf)" [b"Gwyddion Simple Field"] ["gsf"] SEVERAL;
    /// Points of Gwyddion.
    GwyddionPoints "Gwyddion XYZ Field" [b"Gwyddion XYZ Field"] ["gxyzf"] ONE
        "rasterise the points in Gwyddion and save the image as gwy or gsf";
    /// TrueMap and GelSight height map.
    TrueMap "TrueMap (tmd)" [b"Binary TrueMap Data File"] ["tmd"] ONE "open it in Gwyddion and save it as gwy or gsf";
    /// Images of ISO 28600 as text.
    Iso28600 "SPM data transfer format (ISO 28600)" [b"ISO/TC 201 SPM data transfer format"] [] ONE
        "open it in Gwyddion and save it as gwy or gsf";
    /// Precitec scans as text.
    Precitec "Precitec FSS Explorer" [b"Precitec Optronik - FSS Explorer"] [] ONE
        "write its columns X Pos, Y Pos and the distance or thickness to a table named x [mm], y [mm], z [um]";
    /// Code V interferograms as text.
    CodeV "Code V interferogram (int)" [] [] SEVERAL;
    /// Nanosurf scan.
    NanosurfNid "Nanosurf nid" [b"[DataSet]"] [] SEVERAL;
    /// Igor binary wave of version 5, as instruments of Asylum Research write it.
    IgorWave "Igor wave (ibw)" [b"\x05\x00", b"\x00\x05"] ["ibw"] SEVERAL;
    /// Bruker NanoScope image.
    NanoScope "Bruker NanoScope image" [b"\\*File list", b"?*File list", b"\\*Force file list", b"\\*EC File list"] [] ONE
        "export the height channel as text with its units from NanoScope Analysis, or as gwy from Gwyddion";
    /// WSxM image.
    Wsxm "WSxM image" [b"WSxM file copyright"] [] ONE "export the image as gwy from Gwyddion, or as text x y z";
    /// PicoView image.
    PicoView "PicoView image" [b"fileType      Image"] [] ONE "export the image as gwy from Gwyddion, or as text x y z";
    /// Triangles.
    Stl "STL" [] ["stl"] ONE "export the surface as points x y z on a grid, as X3P or SDF; triangles are not a grid of heights";
    /// XML profiles of ASME B46 and NPL.
    NplXml "ASME B46 or NPL XML profile" [] [] ONE UNPACKED;
    /// Olympus laser microscopes (lext, poir, oir).
    Lext "Olympus lext, poir or oir" [] ["lext", "poir", "oir"] ONE "export the surface as X3P, SDF or text";
    /// Digital Metrology OmniSurf3D.
    OmniSurf "OmniSurf3D os3d" [] ["os3d"] ONE "export the surface as X3P, SDF or text";
    /// Taylor Hobson binaries (fts, mod, fls).
    TaylorHobsonBinary "Taylor Hobson binary (fts, mod, fls)" [] ["fts", "mod", "fls"] ONE
        "export the profile as text (prf), the surface as X3P or SDF from the Talysurf software";
    /// ISO 25178-71 as text.
    SdfAscii "SDF text (ISO 25178-71)" [b"aISO-", b"aBCR-", b"aBCR ", b"aBC-", b"aNPL-"] [] SEVERAL;
    /// ISO 25178-71, binary.
    SdfBinary "binary SDF (ISO 25178-71)" [b"bISO-", b"bBCR-", b"bBCR ", b"bBC-"] ["sdf"] SEVERAL;
    /// SigmaSurf text.
    SigmaSurf "SigmaSurf sig" [b"SigmaSurf_Data"] [] ONE;
    /// ISO 5436-2 SMD.
    Smd "SMD (ISO 5436-2)" [] [] ONE;
    /// Taylor Hobson text profile (prf), as NPL writes it too.
    TaylorHobsonPrf "Taylor Hobson text profile (prf)" [] [] ONE;
    /// Hommel text profile (hfm).
    HommelHfm "Hommel text profile (hfm)" [] [] ONE;
    /// Dektak profile with its meta data as text.
    DektakCsv "Dektak csv" [] [] ONE;
    /// PTB reference software text.
    PtbPr "PTB pr" [] [] ONE;
    /// XML that is no X3P, of which no layout with heights is known.
    Xml "XML" [] [] ONE
        "export the profile as X3P, SMD, SDF, prf or text; of an X3P pass the archive, not its main.xml";
    /// A compressed archive.
    Archive "a compressed archive" [b"\x1f\x8b", b"7z\xbc\xaf\x27\x1c", b"Rar!"] [] ONE "unpack it first";
    /// A picture or a printed report.
    Document "a picture or document" [b"%PDF", b"\x89PNG", b"\xff\xd8\xff", b"BM6"] [] ONE
        "export the heights, not the report";
    /// Binary data of an unknown kind.
    UnknownBinary "binary data of an unknown format" [] [] ONE;
}

impl std::fmt::Display for Format {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.row().title)
    }
}

impl Format {
    fn row(self) -> &'static FormatRow {
        // The rows are in the order of the variants.
        &ROWS[self as usize]
    }

    /// Remedy for a format that is not read.
    pub fn remedy(self) -> &'static str {
        self.row().remedy
    }

    /// Whether a file of the format may hold several profiles: a surface, or traces side by side.
    ///
    /// ```
    /// use asperity_profile_io::read::Format;
    /// assert!(Format::X3p.may_hold_several() && !Format::MahrText.may_hold_several());
    /// ```
    pub fn may_hold_several(self) -> bool {
        self.row().may_hold_several
    }

    /// Whether a file is text that is read line by line, although its first bytes settle the format.
    pub(super) const fn is_read_by_lines(self) -> bool {
        matches!(self, Self::SdfAscii | Self::SigmaSurf)
    }

    /// The format that the first bytes settle.
    pub(super) fn starting(bytes: &[u8]) -> Option<Self> {
        let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        let starts = |row: &&FormatRow| row.starts.iter().any(|start| bytes.starts_with(start));
        ROWS.iter().find(starts).map(|row| row.format)
    }

    /// The format that the extension of `name` suggests, for content that is not text.
    pub(super) fn named(name: &str) -> Option<Self> {
        let extension = extension(name);
        let is_named = |row: &&FormatRow| row.extensions.contains(&extension.as_str());
        ROWS.iter().find(is_named).map(|row| row.format)
    }
}

/// Lower-case extension, empty if there is none.
pub(super) fn extension(name: &str) -> String {
    let file = name.rsplit(['/', '\\']).next().unwrap_or_default();
    let parts = file.rsplit_once('.');
    parts.map_or_else(String::new, |(_, extension)| extension.to_lowercase())
}
