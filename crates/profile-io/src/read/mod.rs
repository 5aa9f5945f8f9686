//! Reading measured profiles from files, with a record of assumptions.
//!
//! The format of a file is recognised ([`Format`]), its text decoded ([`Encoding`]), its dialect detected
//! ([`Dialect`]), and its table read and given spacing and units. Statements in [`ReadOptions`] override the content of
//! the file. A [`Trace`] may have uneven points; a [`Reading`] has an even grid. Nothing is repaired silently:
//! assumptions are [`Warning`](crate::Warning)s, and an unreadable file is an error with its line and a remedy.
//!
//! | quantity | rule |
//! |---|---|
//! | spacing dx | (x_last − x_first)/(n − 1), or as stated |
//! | units | as stated, or from the header, or the only possible ones, or an error |
//! | missing heights | an error, or interpolated on request |
//! | sign of the heights | out of the material; values that the file names depths or distances from a sensor are turned, others as stated |
//!
//! The time is linear in the length of the file. Only this module opens files.

mod areal;
mod conditions;
mod cut;
mod damage;
mod decimal;
mod delimited;
mod dialect;
mod encoding;
mod error;
mod file_dialect;
mod first_look;
mod format;
mod found;
mod grid;
mod header;
mod header_values;
mod layout;
mod lengths;
mod mahr;
mod matrix;
pub(crate) mod metadata;
mod natural_spline;
pub(crate) mod options;
#[cfg_attr(not(feature = "packed"), path = "refused.rs")]
mod packed;
mod plain_row;
mod points;
mod ptb;
mod reading;
mod recognise;
mod resample;
mod roll_length;
mod rows;
mod sdf;
mod sdf_mark;
mod seems;
mod sigmasurf;
mod single_column;
mod smd;
mod stated_count;
pub mod steepness;
mod surface;
mod surfcom;
mod table;
mod taylor_hobson;
mod text;
mod trace;
mod units;

use std::io::{Cursor, Read, Seek};
use std::path::Path;

pub use conditions::conditions_of;
pub use cut::TraceCut;
pub use error::{CellRemedy, ReadError, ReadFault};
pub use format::Format;
pub use grid::{SpacingSource, Unevenness};
pub use header::FilterState;
pub use layout::{Dialect, TableLayout};
pub use metadata::{Metadata, PrintedParameter};
pub use options::{
    Abscissa, Axis, Columns, DecimalSign, Encoding, Gaps, LengthUnit, ReadOptions, Separator,
    TraceLine, TraceRange, Uneven, UnknownChoice,
};
pub use reading::{Reading, ReadingRecord};
pub use resample::Resampled;
pub use surface::Surface;
pub use trace::{Positions, Trace};

use areal::trace::Areal;
use asperity_storage::regular_file;
use found::Found;
use text::{Head, Start, Stream, TextSource};

/// Maximum size of a file in bytes: two hundred million points of text.
const MOST_BYTES: u64 = 4 << 30;
/// Maximum size of standard input in bytes.
const MOST_HELD: u64 = 1 << 30;
/// The path that means standard input.
const STANDARD_INPUT: &str = "-";

/// Reads the profile in the file at `path`; `-` is standard input, of which at most a gigabyte is held.
///
/// # Errors
/// When the file cannot be opened, its format is not supported, or it has no usable profile; [`ReadFault`] lists the
/// reasons.
///
/// ```
/// use asperity_profile_io::read::{ReadOptions, read};
/// let missing = read("no such file.csv".as_ref(), &ReadOptions::default());
/// assert_eq!(missing.map_err(|error| error.code()), Err(asperity_core::Code::E103));
/// ```
pub fn read(path: &Path, options: &ReadOptions) -> Result<Reading, ReadError> {
    read_trace(path, options)?.reading(options.uneven)
}

/// Reads the trace in the file at `path`, with points that may be uneven; `-` is standard input.
///
/// # Errors
/// As [`read`], except that uneven points are not an error.
pub fn read_trace(path: &Path, options: &ReadOptions) -> Result<Trace, ReadError> {
    let name = path.display().to_string();
    let mut stream = open(path).map_err(|fault| fault.in_file(&name))?;
    let conditions = surfcom::conditions_beside(path);
    trace_in(&name, &mut *stream, conditions.as_deref(), options)
}

/// Reads the trace in `bytes`, the content of a file called `name`, with points that may be uneven.
///
/// # Errors
/// As [`read_trace`], except that nothing is opened.
pub fn read_trace_bytes(
    name: &str,
    bytes: &[u8],
    options: &ReadOptions,
) -> Result<Trace, ReadError> {
    trace_in(name, &mut Cursor::new(bytes), None, options)
}

/// Reads the surface in the file at `path`; `-` is standard input. A profile is a surface of one row.
///
/// # Errors
/// As [`read`], and for formats without surfaces. Missing points and few points are not errors.
pub fn read_surface(path: &Path, options: &ReadOptions) -> Result<Surface, ReadError> {
    let name = path.display().to_string();
    let surface = open(path).and_then(|mut stream| surface_of(&name, &mut *stream, options));
    surface.map_err(|fault| fault.in_file(&name))
}

/// Reads the surface in `bytes`, the content of a file called `name`.
///
/// # Errors
/// As [`read_surface`], except that nothing is opened.
pub fn read_surface_bytes(
    name: &str,
    bytes: &[u8],
    options: &ReadOptions,
) -> Result<Surface, ReadError> {
    surface_of(name, &mut Cursor::new(bytes), options).map_err(|fault| fault.in_file(name))
}

/// Reads the surface in `stream`, in any format.
fn surface_of(
    name: &str,
    stream: &mut dyn Stream,
    options: &ReadOptions,
) -> Result<Surface, ReadFault> {
    let start = Start::read(stream)?;
    not_larger(start.size, MOST_BYTES)?;
    if let Some(bytes) = recognise::recoded(stream, &start)? {
        return surface_of(name, &mut Cursor::new(bytes), options);
    }
    let format = format_of(name, stream, &start);
    if let Some(format) = format
        && let Some(found) = packed::surface(name, format, stream, &start, options)?
    {
        return turned_surface(found, name, options);
    }
    let found = match format {
        None | Some(Format::SdfAscii) => {
            let (head, mut text) = TextSource::new(name, stream, &start, options.encoding);
            match recognise::of_text(name, &head) {
                Some(Format::SdfAscii) => Areal {
                    encoding: Some(text.encoding),
                    ..sdf::surface(&mut text)?
                },
                Some(format) => return Err(refused(format)),
                None if !encoding::is_text(&head.text) => {
                    let format = Format::named(name).unwrap_or(Format::UnknownBinary);
                    return Err(refused(format));
                }
                None => Areal {
                    encoding: Some(text.encoding),
                    ..delimited::surface(&head, &mut text, options)?
                },
            }
        }
        Some(format) => areal::read(format, stream, start.size)?.ok_or_else(|| refused(format))?,
    };
    turned_surface(found, name, options)
}

/// The surface with heights out of the material.
fn turned_surface(found: Areal, name: &str, options: &ReadOptions) -> Result<Surface, ReadFault> {
    let mut surface = found.surface(name, options)?;
    found::turn(&mut surface.z, &mut surface.warnings, options.invert);
    Ok(surface)
}

/// The format identified by the first bytes, or by the members of an archive.
fn format_of(name: &str, stream: &mut dyn Stream, start: &Start) -> Option<Format> {
    let zipped = start.bytes.starts_with(recognise::ZIP);
    match recognise::by_magic(name, &start.bytes) {
        Some(Format::Archive) if zipped => Some(packed::content(stream, start.size)),
        None if areal::is_plu(&start.bytes) => Some(Format::SensofarPlu),
        None if areal::is_code_v(&start.bytes) => Some(Format::CodeV),
        format => format,
    }
}

/// Opens a file for repeated reading; standard input is stored in memory.
fn open(path: &Path) -> Result<Box<dyn Stream>, ReadFault> {
    if path == Path::new(STANDARD_INPUT) {
        return held(std::io::stdin().lock());
    }
    let file = regular_file(path).map_err(|source| {
        let is_odd = source.kind() == std::io::ErrorKind::Other;
        let advised = |source| format!("{source}; pass - and pipe it into standard input");
        if is_odd {
            std::io::Error::other(advised(source))
        } else {
            source
        }
    })?;
    Ok(Box::new(file))
}

/// Stores a stream in memory so that it can be read again.
fn held(from: impl Read) -> Result<Box<dyn Stream>, ReadFault> {
    let mut bytes = Vec::new();
    from.take(MOST_HELD + 1).read_to_end(&mut bytes)?;
    not_larger(bytes.len() as u64, MOST_HELD)?;
    Ok(Box::new(Cursor::new(bytes)))
}

fn not_larger(bytes: u64, most: u64) -> Result<(), ReadFault> {
    if bytes <= most {
        return Ok(());
    }
    Err(ReadFault::too_large("the file", bytes, most))
}

/// Reads the profile in `bytes`, the content of a file called `name`.
///
/// # Errors
/// As [`read`], except that nothing is opened.
///
/// ```
/// use asperity_profile_io::read::{LengthUnit, ReadOptions, read_bytes};
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
    read_stream(name, Cursor::new(bytes), options)
}

/// Reads the profile in `stream`, from its start, as a file called `name`. The stream is read in chunks, and again if
/// required; text is never stored as a whole.
///
/// # Errors
/// As [`read`], except that nothing is opened.
///
/// ```
/// use asperity_profile_io::read::{ReadOptions, read_bytes, read_stream};
/// let text: String = (0..200).map(|i| format!("{};{}.25\n", i, i % 7)).collect();
/// let file = format!("x [um];z [um]\n{text}");
/// let stream = std::io::Cursor::new(&file);
/// let options = ReadOptions::default();
/// let reading = read_stream("flank.csv", stream, &options)?;
/// assert_eq!(reading, read_bytes("flank.csv", file.as_bytes(), &options)?);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn read_stream(
    name: &str,
    mut stream: impl Read + Seek,
    options: &ReadOptions,
) -> Result<Reading, ReadError> {
    trace_in(name, &mut stream, None, options)?.reading(options.uneven)
}

/// Reads the profile in `bytes` with the content of its file of measuring conditions (Surfcom `.tx3`).
///
/// # Errors
/// As [`read_bytes`].
///
/// ```
/// use asperity_profile_io::read::{ReadOptions, read_with_conditions};
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
    trace_in(name, &mut Cursor::new(bytes), conditions, options)?.reading(options.uneven)
}

/// The text of a table in `bytes`: text in the encoding of its mark, in UTF-16, UTF-8 or Windows-1252, or all cells of a
/// workbook whose numbers are on one sheet, separated by tabs.
///
/// # Errors
/// When it is a workbook with numbers on several sheets, a MATLAB file, or another file that is not text.
///
/// ```
/// use asperity_profile_io::read::table_text;
/// assert_eq!(table_text("a.csv", b"T [\xb0C]\n1\n")?, "T [\u{b0}C]\n1\n");
/// let matlab = table_text("a.mat", b"MATLAB 5.0 MAT-file\0").unwrap_err();
/// assert_eq!(matlab.code(), "E108");
/// # Ok::<(), asperity_profile_io::read::ReadError>(())
/// ```
pub fn table_text(name: &str, bytes: &[u8]) -> Result<String, ReadError> {
    let known = encoding::by_mark(bytes);
    let encoding = known.unwrap_or_else(|| encoding::guess(bytes, true));
    let text = encoding.text(bytes);
    if encoding::is_text(&text) {
        return Ok(text);
    }
    table_of(name, bytes).map_err(|fault| fault.in_file(name))
}

/// The text of the table in `bytes`, which are not text.
fn table_of(name: &str, bytes: &[u8]) -> Result<String, ReadFault> {
    let mut stream = Cursor::new(bytes);
    let start = Start::read(&mut stream)?;
    let format = format_of(name, &mut stream, &start);
    let format = format.or_else(|| Format::named(name));
    let format = format.unwrap_or(Format::UnknownBinary);
    let table = packed::table(format, &mut stream, &start)?;
    table.ok_or_else(|| ReadFault::not_table(format))
}

/// The text of the table in the file at `path` of at most `most` bytes, as [`table_text`].
///
/// # Errors
/// When it cannot be read, is larger, or is not text.
pub fn read_table(path: &Path, most: u64) -> Result<String, ReadError> {
    let name = path.display().to_string();
    let bytes = asperity_storage::whole_file(path, most);
    let bytes = bytes.map_err(|source| ReadFault::from(source).in_file(&name))?;
    table_text(&name, &bytes)
}

fn trace_in(
    name: &str,
    stream: &mut dyn Stream,
    conditions: Option<&[u8]>,
    options: &ReadOptions,
) -> Result<Trace, ReadError> {
    let trace = trace_of(name, stream, conditions, options);
    let part = trace.and_then(|mut trace| {
        found::turn(&mut trace.heights, &mut trace.warnings, options.invert);
        match options.range {
            Some(range) => trace.within(range),
            None => Ok(trace),
        }
    });
    part.map_err(|fault| fault.in_file(name))
}

/// Reads the trace in `stream`, in any format.
fn trace_of(
    name: &str,
    stream: &mut dyn Stream,
    conditions: Option<&[u8]>,
    options: &ReadOptions,
) -> Result<Trace, ReadFault> {
    let start = Start::read(stream)?;
    not_larger(start.size, MOST_BYTES)?;
    if let Some(bytes) = recognise::recoded(stream, &start)? {
        return trace_of(name, &mut Cursor::new(bytes), conditions, options);
    }
    let format = format_of(name, stream, &start);
    if let Some(format) = format
        && let Some(found) = packed::trace(name, format, stream, &start, options)?
    {
        return Ok(found);
    }
    if let Some(format) = format.filter(|format| !format.is_read_by_lines()) {
        let found = areal::read(format, stream, start.size)?;
        let found = found.ok_or_else(|| refused(format))?;
        return found.trace(options)?.finish(name, options);
    }
    let (head, mut text) = TextSource::new(name, stream, &start, options.encoding);
    let found = read_text(&start, &head, &mut text, conditions, options);
    if !text.is_malformed() {
        return found;
    }
    // The text is not UTF-8, as its head seemed; then it is in the Windows code page 1252.
    let (head, mut text) = TextSource::new(name, stream, &start, Some(Encoding::Windows1252));
    read_text(&start, &head, &mut text, conditions, options)
}

fn read_text(
    start: &Start,
    head: &Head,
    text: &mut TextSource<'_>,
    conditions: Option<&[u8]>,
    options: &ReadOptions,
) -> Result<Trace, ReadFault> {
    let name = text.file;
    let smd = smd::recognised(&start.bytes);
    if !smd && !encoding::is_text(&head.text) {
        let format = Format::named(name).unwrap_or(Format::UnknownBinary);
        return Err(refused(format));
    }
    let format = if smd {
        Some(Format::Smd)
    } else {
        recognise::of_text(name, head)
    };
    let found = match format {
        Some(Format::Smd) => smd::read(head, text)?,
        Some(Format::SdfAscii) if options.line != TraceLine::Row => {
            sdf::surface(text)?.trace(options)?
        }
        Some(Format::SdfAscii) => sdf::read(text, options)?,
        Some(Format::SigmaSurf) => sigmasurf::read(text)?,
        Some(Format::MahrText) => mahr::read(text)?,
        Some(Format::TaylorHobsonPrf) => taylor_hobson::read(text)?,
        Some(Format::PtbPr) => ptb::read(text)?,
        Some(format) => return Err(refused(format)),
        None if surfcom::recognised(head, text)? => surfcom::read(text, conditions, options)?,
        None => return delimited::read(head, text, options),
    };
    let found = Found {
        encoding: Some(text.encoding),
        ..found
    };
    found.finish(name, options)
}

fn refused(format: Format) -> ReadFault {
    // The format follows only from the name: the content does not start with its mark.
    if format.may_hold_several() {
        return damage::damaged(format, "it does not start as such a file", "");
    }
    ReadFault::format_not_read(format)
}
