//! Reading measured profiles from files, with everything that was found or assumed.
//!
//! A file is recognised ([`Format`]), decoded ([`Encoding`]), its dialect is sniffed ([`Dialect`]),
//! its table read, put on an even grid and given units. What the user states in [`ReadOptions`]
//! wins over what the file looks like. Nothing is repaired in silence: a file is read as it stands,
//! with [`Warning`]s for what was assumed, or refused with the line and a remedy.
//!
//! | quantity | rule |
//! |---|---|
//! | spacing dx | (x_last − x_first)/(n − 1), or as stated |
//! | units | as stated, else from the header, else the only possible ones, else refused |
//! | missing heights | refused, or interpolated on request |
//!
//! Reading is linear in the length of the file. This is the only module of the crate that opens files.

mod archive;
mod delimited;
mod dialect;
mod encoding;
mod error;
mod format;
mod grid;
mod header;
mod mahr;
mod metadata;
mod mitutoyo;
mod options;
mod ptb;
mod sdf;
mod sigmasurf;
mod single_column;
mod smd;
mod surfcom;
mod table;
mod taylor_hobson;
mod trace;
mod units;
mod x3p;
mod xml;

use std::borrow::Cow;
use std::io::Read as _;
use std::path::{Path, PathBuf};

use asperity_core::Profile;
use asperity_core::quantity::Length;
use serde::Serialize;

pub use dialect::Dialect;
pub use error::{FirstLine, ReadError, SpacingHint};
pub use format::Format;
pub use grid::SpacingSource;
pub use header::FilterState;
pub use metadata::{Metadata, PrintedParameter};
pub use options::{
    Axis, Columns, DecimalSign, Encoding, Gaps, LengthUnit, ReadOptions, Separator, UnknownChoice,
};

use crate::Warning;
use trace::Trace;

/// Bytes of the largest file read: fifty million points of text.
const MOST_BYTES: u64 = 4 << 30;
/// Bytes of the largest file of measuring conditions.
const MOST_CONDITIONS: u64 = 1 << 20;

/// How a table of text is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct TableLayout {
    /// What separates the columns.
    pub separator: Separator,
    /// The decimal sign.
    pub decimal: DecimalSign,
    /// Columns read.
    pub columns: Columns,
}

/// A profile with all that was found out about its file. Serialises without the heights, as the echo.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Reading {
    /// Name of the file as given.
    pub name: String,
    /// The profile, heights as in the file (no offset, form or tilt removed).
    #[serde(skip)]
    pub profile: Profile,
    /// Format of the file.
    pub format: Format,
    /// Character encoding; none for binary formats.
    pub encoding: Option<Encoding>,
    /// How the table is written; none for formats that are no table.
    pub table: Option<TableLayout>,
    /// Unit of x; none when the spacing was stated and no x column was needed.
    pub x_unit: Option<LengthUnit>,
    /// Unit of the heights in the file.
    pub z_unit: LengthUnit,
    /// Distance between points.
    pub spacing: Length,
    /// How the spacing was found.
    pub spacing_source: SpacingSource,
    /// Length of the trace, (n − 1)·dx.
    pub length: Length,
    /// Whether the file says its heights are filtered.
    pub filter_state: FilterState,
    /// Number of points n.
    pub points: usize,
    /// Points that were interpolated on request.
    pub gaps_filled: usize,
    /// What the file says beside the heights.
    pub metadata: Metadata,
    /// What the user should know.
    pub warnings: Vec<Warning>,
}

/// Reads the profile in the file at `path`.
///
/// # Errors
/// When the file cannot be opened, is in a format that is not read, or holds no usable profile;
/// [`ReadError`] lists the reasons.
///
/// ```
/// use asperity_roughness::read::{ReadOptions, read};
/// let missing = read("no such file.csv".as_ref(), &ReadOptions::default());
/// assert_eq!(missing.map_err(|error| error.code()), Err("E103"));
/// ```
pub fn read(path: &Path, options: &ReadOptions) -> Result<Reading, ReadError> {
    let name = path.display().to_string();
    let bytes = load(path, &name, MOST_BYTES)?;
    let conditions = beside(path).and_then(|path| load(&path, &name, MOST_CONDITIONS).ok());
    read_with_conditions(&name, &bytes, conditions.as_deref(), options)
}

/// The bytes of a file that is no larger than `most`.
fn load(path: &Path, name: &str, most: u64) -> Result<Vec<u8>, ReadError> {
    let unreadable = |source| ReadError::NotReadable {
        file: name.to_owned(),
        source,
    };
    let file = std::fs::File::open(path).map_err(unreadable)?;
    let too_large = |bytes| ReadError::TooLarge {
        file: name.to_owned(),
        what: "the file",
        bytes,
        most,
    };
    // Said beforehand by files; a pipe is measured as it comes.
    let stated = file.metadata().map_or(0, |metadata| metadata.len());
    if stated > most {
        return Err(too_large(stated));
    }
    let mut bytes = Vec::new();
    file.take(most + 1)
        .read_to_end(&mut bytes)
        .map_err(unreadable)?;
    if bytes.len() as u64 > most {
        return Err(too_large(bytes.len() as u64));
    }
    Ok(bytes)
}

/// The measuring conditions that lie beside a Surfcom profile.
fn beside(path: &Path) -> Option<PathBuf> {
    let extension = path.extension()?.to_str()?;
    let conditions = match extension {
        "tx1" | "tx2" => "tx3",
        "TX1" | "TX2" => "TX3",
        _ => return None,
    };
    Some(path.with_extension(conditions))
}

/// Reads the profile in `bytes`, the content of a file called `name`.
///
/// # Errors
/// As [`read`], except that nothing is opened.
///
/// ```
/// use asperity_roughness::read::{LengthUnit, ReadOptions, read_bytes};
/// let mut text = String::from("Weg [mm];Höhe [µm]\r\n");
/// for i in 0..200 {
///     text += &format!("{},{:04};0,{}\r\n", i / 2000, 5 * i % 10000, i % 7);
/// }
/// let reading = read_bytes("flank.csv", text.as_bytes(), &ReadOptions::default())?;
/// assert_eq!(reading.points, 200);
/// assert_eq!(reading.spacing, "0.5 um".parse()?);
/// assert_eq!(reading.z_unit, LengthUnit::Micrometre);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn read_bytes(name: &str, bytes: &[u8], options: &ReadOptions) -> Result<Reading, ReadError> {
    read_with_conditions(name, bytes, None, options)
}

/// As [`read_bytes`], with the content of the file of measuring conditions (Surfcom `.tx3`) beside it.
///
/// # Errors
/// As [`read_bytes`].
///
/// ```
/// use asperity_roughness::read::{ReadOptions, read_with_conditions};
/// let heights: String = (0..200).map(|i| format!("{}.5\n", i % 7)).collect();
/// let profile = format!("10.00000\n200\n{heights}");
/// let conditions = "Evaluation length\t0.1000000mm\n";
/// let options = ReadOptions::default();
/// let reading = read_with_conditions("a.tx1", profile.as_bytes(), Some(conditions.as_bytes()), &options)?;
/// assert_eq!(reading.spacing, "0.5 um".parse()?);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn read_with_conditions(
    name: &str,
    bytes: &[u8],
    conditions: Option<&[u8]>,
    options: &ReadOptions,
) -> Result<Reading, ReadError> {
    let refused = |format| ReadError::FormatNotRead {
        file: name.to_owned(),
        format,
    };
    match format::by_magic(name, bytes) {
        Some(Format::X3p) => return x3p::read(name, bytes, options)?.finish(name, options),
        Some(Format::Excel) if bytes.starts_with(format::ZIP) => {
            return mitutoyo::read(name, bytes)?.finish(name, options);
        }
        None | Some(Format::SdfAscii | Format::SigmaSurf) => {}
        Some(format) => return Err(refused(format)),
    }
    let (text, encoding) = encoding::decode(bytes, options.encoding);
    let text = text.trim_end_matches(['\0', '\u{1a}']);
    let smd = smd::recognised(bytes);
    if !smd && !encoding::is_text(text) {
        return Err(refused(
            format::by_extension(name).unwrap_or(Format::UnknownBinary),
        ));
    }
    let text = with_newlines(text);
    let conditions = conditions.map(|bytes| encoding::decode(bytes, options.encoding).0);
    let format = if smd {
        Some(Format::Smd)
    } else {
        format::of_text(name, &text)
    };
    let found: Trace = match format {
        Some(Format::Smd) => smd::read(name, &text)?,
        Some(Format::SdfAscii) => sdf::read(name, &text, options)?,
        Some(Format::SigmaSurf) => sigmasurf::read(name, &text)?,
        Some(Format::MahrText) => mahr::read(name, &text)?,
        Some(Format::TaylorHobsonPrf) => taylor_hobson::read(name, &text)?,
        Some(Format::PtbPr) => ptb::read(name, &text)?,
        Some(Format::SurfcomText) => surfcom::read(name, &text, conditions.as_deref(), options)?,
        Some(format) => return Err(refused(format)),
        None => return delimited::read(name, &text, encoding, options),
    };
    let found = Trace {
        encoding: Some(encoding),
        ..found
    };
    found.finish(name, options)
}

/// The text with LF at the end of its lines, where it has CR alone.
fn with_newlines(text: &str) -> Cow<'_, str> {
    if text.contains('\n') || !text.contains('\r') {
        Cow::Borrowed(text)
    } else {
        Cow::Owned(text.replace('\r', "\n"))
    }
}
