//! Sensofar PLU: a date, a comment, a calibration, and heights in micrometres as floats.
//!
//! Layout: Gwyddion sensofar.c and SurfaceTopography. The header has 500 bytes; then come rows, columns and the heights
//! of the first layer. 1000001 is a missing height. The format has no magic number: the header starts with a date such
//! as `Fri Mar 10 16:35:59 2023` and a zero.

use super::bytes::{little, text};
use super::raw::{Layout, Missing, Raw, RawNumber, Unit};
use super::trace::{Areal, ArealHeights};
use crate::read::damage::damaged;
use crate::read::error::ReadFault;
use crate::read::format::Format;
use crate::read::metadata::short;

const FORMAT: Format = Format::SensofarPlu;
const DATE: usize = 24;
const HEADER: usize = 500;
/// Offsets in the header.
const COMMENT: usize = 132;
const X_PIXEL: usize = 404;
const Y_PIXEL: usize = 408;
const KIND: usize = 428;
/// Kinds of measurement.
const IMAGE: u32 = 0;
const PROFILE: u32 = 1;
const TOPOGRAPHY: u32 = 3;
const THICKNESS: u32 = 5;
/// Mark of a missing height.
const NONE: f64 = 1_000_001.0;

/// Whether a file that starts with `head` is a PLU.
pub(crate) fn recognised(head: &[u8]) -> bool {
    const DAYS: [&[u8]; 7] = [b"Mon", b"Tue", b"Wed", b"Thu", b"Fri", b"Sat", b"Sun"];
    let Some(date) = head.get(..=DATE).filter(|_| head.len() > HEADER) else {
        return false;
    };
    let digits = |at: usize, count: usize| date[at..at + count].iter().all(u8::is_ascii_digit);
    DAYS.contains(&&date[..3])
        && date[DATE] == 0
        && [13, 16].into_iter().all(|at| date[at] == b':')
        && digits(11, 2)
        && digits(20, 4)
}

/// Reads the first layer.
pub(super) fn read(bytes: Vec<u8>) -> Result<Areal, ReadFault> {
    let fault = |what, seen: &str| damaged(FORMAT, what, seen);
    let cut = || fault("the header is cut off", "");
    let kind: u32 = little(&bytes, KIND).ok_or_else(cut)?;
    if kind == IMAGE || kind == THICKNESS {
        let content = match kind {
            IMAGE => "a picture",
            _ => "a thickness",
        };
        return Err(ReadFault::no_heights(FORMAT, content));
    }
    if kind != PROFILE && kind != TOPOGRAPHY {
        return Err(fault(
            "the kind of its measurement is not known",
            &kind.to_string(),
        ));
    }
    let count = |at| little::<u32>(&bytes, at).map(|count| count as usize);
    let (rows, columns) = (
        count(HEADER).ok_or_else(cut)?,
        count(HEADER + 4).ok_or_else(cut)?,
    );
    let rows = if kind == PROFILE { 1 } else { rows };
    let pixel = |at| little::<f32>(&bytes, at).map_or(f64::NAN, |pixel| f64::from(pixel.abs()));
    let [dx, dy] = [pixel(X_PIXEL), pixel(Y_PIXEL)].map(|pixel| Unit::MICROMETRE.metres(pixel));
    let date = text(&bytes, 0, DATE);
    let title = text(&bytes, COMMENT, 256);
    let layout = Layout::packed(HEADER + 8, columns, rows, RawNumber::F32);
    let raw = Raw::new(bytes, RawNumber::F32, layout);
    let mut raw = raw.ok_or_else(|| fault("fewer heights than the header says", ""))?;
    (raw.unit, raw.missing) = (Unit::MICROMETRE, Missing::Equal(NONE));
    let mut found = Areal::new(FORMAT, ArealHeights::Raw(raw)).spaced(dx, dy);
    found.metadata.date = date.as_deref().and_then(short);
    found.metadata.title = title.as_deref().and_then(short);
    found.metadata.instrument = Some("Sensofar".into());
    Ok(found)
}
