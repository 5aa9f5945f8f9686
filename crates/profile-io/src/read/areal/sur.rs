//! Digital Surf SUR and PRO: the exchange format of MountainsMap.
//!
//! A header of 512 bytes, a comment, a private zone, and whole numbers of 16 or 32 bits; `DSCOMPRESSED` files hold them
//! as zlib streams. A height is number · spacing of z in its step unit. Layout: the readers of Gwyddion (surffile.c),
//! SurfaceTopography, surfalize and RosettaSciIO. These disagree on the offset of the heights, which is ignored because
//! a trace has no absolute height.

use super::bytes::{little, part, text};
use super::held::most_unpacked;
use super::raw::{Layout, Missing, Raw, RawNumber, Unit};
use super::trace::{Areal, ArealHeights};
use crate::read::damage::damaged;
use crate::read::error::ReadFault;
use crate::read::format::Format;
use crate::read::metadata::short;
use crate::read::options::{Axis, LengthUnit};
use crate::read::packed::inflated;
use crate::warning::Warning;

const FORMAT: Format = Format::DigitalSurf;
const HEADER: usize = 512;
const COMPRESSED: &[u8] = b"DSCOMPRESSED";

/// Unsupported kinds of content, by their number.
const OTHERS: &[(i16, &str)] = &[
    (3, "a binary image"),
    (5, "a series of surfaces"),
    (6, "a meridian disc"),
    (7, "a profile of several layers"),
    (8, "a surface of several layers"),
    (9, "a parallel disc"),
    (10, "an image of intensities"),
    (12, "a colour image"),
    (13, "a coloured surface of an old kind"),
    (14, "a force curve"),
    (15, "a series of force curves"),
    (17, "a contour"),
    (18, "a series of colour images"),
    (20, "a spectrum"),
    (21, "a map of spectra"),
];
const PROFILE: i16 = 1;
const SURFACE: i16 = 2;
const PROFILES: i16 = 4;
/// A surface before its intensities.
const WITH_INTENSITY: i16 = 11;
/// A surface before its colours and intensities.
const WITH_COLOUR: i16 = 16;

/// One object: its matrix and the byte after it.
struct SurObject {
    raw: Raw,
    end: usize,
}

/// Reads the first surface or the profiles of a file.
pub(super) fn read(bytes: &[u8]) -> Result<Areal, ReadFault> {
    let fault = |what, seen: &str| damaged(FORMAT, what, seen);
    let kind: i16 = field(bytes, 0, 18)?;
    if let Some((_, content)) = OTHERS.iter().find(|(number, _)| *number == kind) {
        return Err(ReadFault::no_heights(FORMAT, content));
    }
    if ![PROFILE, SURFACE, PROFILES, WITH_INTENSITY, WITH_COLOUR].contains(&kind) {
        return Err(fault(
            "the kind of its content is not known",
            &kind.to_string(),
        ));
    }
    let order: i16 = field(bytes, 0, 12)?;
    if order != 0 {
        return Err(fault(
            "its numbers are not in the order of a PC",
            &order.to_string(),
        ));
    }
    let objects = field::<u16>(bytes, 0, 14)?.max(1);
    let first = object(bytes, 0)?;
    let dx = spacing(bytes, 120, 180)?;
    let dy = match first.raw.size()[1] {
        1 => f64::NAN,
        _ => spacing(bytes, 124, 196)?,
    };
    let heights = match kind {
        PROFILES if objects > 1 => series(bytes, first, objects)?,
        _ => ArealHeights::Raw(first.raw),
    };
    let mut found = Areal::new(FORMAT, heights).spaced(dx, dy);
    found.metadata.title = text(bytes, 20, 30).as_deref().and_then(short);
    found.metadata.date = date(bytes);
    if field::<i16>(bytes, 0, 288)? != 0 {
        found.warnings.push(Warning::Replica);
    }
    Ok(found)
}

fn field<T: super::bytes::PlainBytes>(
    bytes: &[u8],
    start: usize,
    at: usize,
) -> Result<T, ReadFault> {
    let found = start.checked_add(at).and_then(|at| little(bytes, at));
    found.ok_or_else(|| damaged(FORMAT, "the header is cut off", ""))
}

/// The object whose header starts at `start`.
fn object(bytes: &[u8], start: usize) -> Result<SurObject, ReadFault> {
    let fault = |what, seen: &str| damaged(FORMAT, what, seen);
    let read = |at| field::<i32>(bytes, start, at);
    let bits: i16 = field(bytes, start, 98)?;
    let number = match bits {
        16 => RawNumber::I16,
        32 => RawNumber::I32,
        _ => {
            return Err(fault(
                "the width of its numbers is not known",
                &bits.to_string(),
            ));
        }
    };
    let size = |at| read(at).map(|count| usize::try_from(count).unwrap_or(0));
    let (columns, rows): (usize, usize) = (size(108)?, size(112)?);
    let comment = usize::from(field::<u16>(bytes, start, 334)?);
    let private = usize::from(field::<u16>(bytes, start, 336)?);
    let data = start + HEADER + comment + private;
    let length = columns.saturating_mul(rows).saturating_mul(number.width());
    let (matrix, end) = if bytes[start..].starts_with(COMPRESSED) {
        unpacked(bytes, data, length)?
    } else {
        let matrix = part(bytes, data, length).map(<[u8]>::to_vec);
        let matrix = matrix.ok_or_else(|| fault("fewer heights than the header says", ""))?;
        (matrix, data + length)
    };
    let layout = Layout::packed(0, columns, rows, number);
    let raw = Raw::new(matrix, number, layout);
    let mut raw = raw.ok_or_else(|| fault("the matrix has no size, or fewer points", ""))?;
    let special: i16 = field(bytes, start, 86)?;
    if special == 1 {
        raw.missing = Missing::Equal(f64::from(read(100)?) - 2.0);
    }
    raw.scale = f64::from(field::<f32>(bytes, start, 128)?);
    raw.unit = unit(bytes, start + 212, Axis::Height)?;
    Ok(SurObject { raw, end })
}

/// The content of the zlib streams at `at`, of `length` bytes together, and the byte after them.
fn unpacked(bytes: &[u8], at: usize, length: usize) -> Result<(Vec<u8>, usize), ReadFault> {
    let fault = |what| damaged(FORMAT, what, "");
    let most = most_unpacked((bytes.len() as u64).saturating_sub(at as u64));
    if length as u64 > most {
        return Err(ReadFault::too_large(
            "the unpacked matrix",
            length as u64,
            most,
        ));
    }
    let cut = || fault("the list of its streams is cut off");
    let streams: u32 = little(bytes, at).ok_or_else(cut)?;
    // Each stream has an entry of eight bytes in the list.
    let list = (streams as usize).checked_mul(8).ok_or_else(cut)?;
    let list = part(bytes, at + 4, list).ok_or_else(cut)?;
    let mut next = at + 4 + list.len();
    let mut matrix = Vec::new();
    for entry in list.chunks_exact(8) {
        let packed = little::<u32>(entry, 4).unwrap_or(0) as usize;
        let stream = part(bytes, next, packed).ok_or_else(|| fault("a stream is cut off"))?;
        let content = inflated(FORMAT, stream, length as u64)?;
        next += packed;
        matrix.extend(content);
        if matrix.len() > length {
            return Err(fault("more heights than the header says"));
        }
    }
    if matrix.len() != length {
        return Err(fault("fewer heights than the header says"));
    }
    Ok((matrix, next))
}

/// A series of profiles, each with its header.
fn series(bytes: &[u8], first: SurObject, objects: u16) -> Result<ArealHeights, ReadFault> {
    let columns = first.raw.size()[0];
    let mut values = Vec::new();
    let mut object_at = first;
    for remaining in (0..objects).rev() {
        let [points, rows] = object_at.raw.size();
        if points != columns || rows != 1 {
            return Err(damaged(FORMAT, "its profiles differ in length", ""));
        }
        values.extend((0..columns).map(|column| object_at.raw.height(column, 0)));
        if remaining > 0 {
            object_at = object(bytes, object_at.end)?;
        }
    }
    Ok(ArealHeights::Values { values, columns })
}

/// The spacing \[m\] at `at`, in the unit with its name at `name`.
fn spacing(bytes: &[u8], at: usize, name: usize) -> Result<f64, ReadFault> {
    let value = f64::from(field::<f32>(bytes, 0, at)?);
    Ok(unit(bytes, name, Axis::Trace)?.metres(value))
}

/// The unit with its name at `at`.
fn unit(bytes: &[u8], at: usize, axis: Axis) -> Result<Unit, ReadFault> {
    let name = text(bytes, at, 16).unwrap_or_default();
    let known = name.parse::<LengthUnit>().ok();
    let known = known.or((name == "in").then_some(LengthUnit::Inch));
    Ok(match known {
        Some(LengthUnit::Metre) => Unit::METRE,
        Some(LengthUnit::Millimetre) => Unit::part(1e3),
        Some(LengthUnit::Micrometre) => Unit::MICROMETRE,
        Some(LengthUnit::Nanometre) => Unit::NANOMETRE,
        Some(LengthUnit::Angstrom) => Unit::part(1e10),
        Some(LengthUnit::Inch) => Unit {
            times: 25.4,
            over: 1e3,
        },
        Some(LengthUnit::Mil) => Unit {
            times: 25.4,
            over: 1e6,
        },
        Some(LengthUnit::Microinch) => Unit {
            times: 25.4,
            over: 1e9,
        },
        None if name == "pm" => Unit::PICOMETRE,
        None => {
            return Err(ReadFault::unknown_unit(
                axis,
                &crate::read::error::shortened(&name),
            ));
        }
    })
}

/// Date of the measurement, if stated.
fn date(bytes: &[u8]) -> Option<String> {
    let number = |at| little::<i16>(bytes, at);
    let (day, month, year) = (number(312)?, number(314)?, number(316)?);
    let sound = (1..=31).contains(&day) && (1..=12).contains(&month) && year > 1900;
    sound.then(|| format!("{year:04}-{month:02}-{day:02}"))
}
