//! Binary SDF (ISO 25178-71, EUNA 15178, "BCR").
//!
//! A header of 81 bytes (85 in version 2, whose counts have 32 bits), then the heights row by row. A height
//! is number · Zscale metres; the smallest number of a type, in the proposal its largest, is a missing height. Layout: ISO 25178-71 as its public
//! readers state it (Gwyddion sdfile.c, SurfaceTopography, surfalize).

use super::bytes::{Cursor, text};
use super::raw::{Layout, Missing, Raw, RawNumber};
use super::trace::{Areal, ArealHeights};
use crate::read::damage::damaged;
use crate::read::error::ReadFault;
use crate::read::format::Format;
use crate::read::metadata::short;
use crate::read::sdf_mark;

const FORMAT: Format = Format::SdfBinary;
/// Magic number of the version with counts of 32 bits.
const WIDE: &[u8] = b"bISO-2.0";
/// Start of the magic number of the proposal before the standard.
const PROPOSAL: &[u8] = b"bBCR";

/// Storage by the number of the type.
const TYPES: [RawNumber; 8] = [
    RawNumber::U8,
    RawNumber::U16,
    RawNumber::U32,
    RawNumber::F32,
    RawNumber::I8,
    RawNumber::I16,
    RawNumber::I32,
    RawNumber::F64,
];

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
    let Some(&number) = TYPES.get(usize::from(kind)) else {
        return Err(fault(
            "the type of its numbers is not known",
            &kind.to_string(),
        ));
    };
    let raw = Raw::new(bytes, number, Layout::packed(first, columns, rows, number));
    let mut raw = raw.ok_or_else(|| fault("fewer heights than the header says", ""))?;
    let [below, above] = sdf_mark::between(usize::from(kind), is_proposal);
    (raw.scale, raw.missing) = (scales[2], Missing::Outside(below, above));
    let mut found = Areal::new(FORMAT, ArealHeights::Raw(raw)).spaced(scales[0], scales[1]);
    found.metadata.instrument = instrument.as_deref().and_then(short);
    found.metadata.date = date.as_deref().and_then(short);
    Ok(found)
}

type SdfBinaryHeader = ([usize; 2], [f64; 3], [u8; 3]);

/// Points and profiles; scales of x, y and z; compression, type and check.
fn header_of(header: &mut Cursor<'_>, wide: bool) -> Option<SdfBinaryHeader> {
    let mut count = || {
        Some(if wide {
            header.number::<u32>()? as usize
        } else {
            usize::from(header.number::<u16>()?)
        })
    };
    let counts = [count()?, count()?];
    let scales = [header.number()?, header.number()?, header.number()?];
    header.number::<f64>()?;
    let kinds = [header.number()?, header.number()?, header.number()?];
    Some((counts, scales, kinds))
}
