//! Binary SDF (ISO 25178-71, EUNA 15178, "BCR").
//!
//! A header of 81 bytes (85 in version 2, whose counts have 32 bits), then the heights row by row. A height
//! is number · Zscale metres; the smallest number of a type, in the proposal its largest, is a missing height. Layout: ISO 25178-71 as its public
//! readers state it (Gwyddion sdfile.c, SurfaceTopography, surfalize).

use super::bytes::{Cursor, text};
use super::raw::{Layout, Missing, Number, Raw};
use super::trace::{Areal, Heights};
use crate::read::damage::damaged;
use crate::read::error::ReadFault;
use crate::read::format::Format;
use crate::read::metadata::short;

const FORMAT: Format = Format::SdfBinary;
/// Magic number of the version with counts of 32 bits.
const WIDE: &[u8] = b"bISO-2.0";
/// Start of the magic number of the proposal before the standard.
const PROPOSAL: &[u8] = b"bBCR";

/// Storage by the number of the type, and its smallest and largest number.
const TYPES: [(Number, [f64; 2]); 8] = [
    (Number::U8, [0.0, u8::MAX as f64]),
    (Number::U16, [0.0, u16::MAX as f64]),
    (Number::U32, [0.0, u32::MAX as f64]),
    (Number::F32, [f32::MIN as f64, 3.4e38]),
    (Number::I8, [i8::MIN as f64, i8::MAX as f64]),
    (Number::I16, [i16::MIN as f64, i16::MAX as f64]),
    (Number::I32, [i32::MIN as f64, i32::MAX as f64]),
    (Number::F64, [f64::MIN, 1.7e308]),
];

/// Mark of a missing height for a type: its smallest number in ISO 25178-71, its largest in the proposal BCR before the
/// standard, which has unsigned types. No instrument measures the smallest number of a signed type.
pub(in crate::read) fn mark(kind: usize, is_proposal: bool) -> Missing {
    let Some((_, [smallest, largest])) = TYPES.get(kind) else {
        return Missing::None;
    };
    let below = match *smallest < 0.0 {
        true => *smallest,
        false => f64::NEG_INFINITY,
    };
    let above = match is_proposal {
        true => *largest,
        false => f64::INFINITY,
    };
    Missing::Outside(below, above)
}

/// Reads the surface or profile.
pub(super) fn read(bytes: Vec<u8>) -> Result<Areal, ReadFault> {
    let fault = |what, seen: &str| damaged(FORMAT, what, seen);
    let (instrument, date) = (text(&bytes, 8, 10), text(&bytes, 18, 12));
    let (wide, is_proposal) = (bytes.starts_with(WIDE), bytes.starts_with(PROPOSAL));
    let mut header = Cursor {
        bytes: &bytes,
        at: 42,
    };
    let read = header_of(&mut header, wide);
    let ([columns, rows], scales, [compression, kind, _]) =
        read.ok_or_else(|| fault("the header is cut off", ""))?;
    let first = header.at;
    if compression != 0 {
        return Err(fault(
            "the heights are compressed",
            &compression.to_string(),
        ));
    }
    let Some(&(number, _)) = TYPES.get(usize::from(kind)) else {
        return Err(fault(
            "the type of its numbers is not known",
            &kind.to_string(),
        ));
    };
    let raw = Raw::new(bytes, number, Layout::packed(first, columns, rows, number));
    let mut raw = raw.ok_or_else(|| fault("fewer heights than the header says", ""))?;
    (raw.scale, raw.missing) = (scales[2], mark(usize::from(kind), is_proposal));
    let mut found = Areal::new(FORMAT, Heights::Raw(raw)).spaced(scales[0], scales[1]);
    found.metadata.instrument = instrument.as_deref().and_then(short);
    found.metadata.date = date.as_deref().and_then(short);
    Ok(found)
}

type Header = ([usize; 2], [f64; 3], [u8; 3]);

/// Points and profiles; scales of x, y and z; compression, type and check.
fn header_of(header: &mut Cursor<'_>, wide: bool) -> Option<Header> {
    let mut count = || {
        Some(match wide {
            true => header.number::<u32>()? as usize,
            false => usize::from(header.number::<u16>()?),
        })
    };
    let counts = [count()?, count()?];
    let scales = [header.number()?, header.number()?, header.number()?];
    header.number::<f64>()?;
    let kinds = [header.number()?, header.number()?, header.number()?];
    Some((counts, scales, kinds))
}
