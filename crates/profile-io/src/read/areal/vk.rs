//! Keyence VK3, VK4, and VK6 and VK7, which contain a VK4 in a zip after a picture.
//!
//! Layout: "VK4 file format" (OSTI 1419732) as its public readers state it (Gwyddion keyence.c,
//! SurfaceTopography, surfalize). A table of offsets, measuring conditions, and the height image: width, height,
//! bits, compression, bytes, range, a palette of 768 bytes, whole numbers. Lengths are in picometres.

use super::bytes::little;
use super::held::whole;
use super::raw::{Layout, Raw, RawNumber, Unit};
use super::trace::{Areal, ArealHeights};
use crate::read::damage::damaged;
use crate::read::error::ReadFault;
use crate::read::format::Format;
use crate::read::packed::member;
use crate::read::text::Stream;

const FORMAT: Format = Format::KeyenceVk;
/// The member of a VK6 or VK7 that is a VK4.
const MEMBER: &str = "Vk4File";
/// Entries of the table: offsets of the measuring conditions and of the height image.
const CONDITIONS: usize = 12;
const HEIGHTS: usize = 36;
/// Bytes between the head of an image and its numbers.
const PALETTE: usize = 768;
const IMAGE_HEAD: usize = 28;
/// Offsets in the measuring conditions.
const X_LENGTH: usize = 168;
const Y_LENGTH: usize = 172;
const Z_LENGTH: usize = 176;

/// Reads the height image.
pub(super) fn read(stream: &mut dyn Stream, size: u64) -> Result<Areal, ReadFault> {
    let mut mark = [0; 4];
    let read = stream.rewind().and_then(|()| stream.read_exact(&mut mark));
    if read.is_err() {
        return Err(damaged(FORMAT, "it is cut off", ""));
    }
    if mark.starts_with(b"VK3_") || mark.starts_with(b"VK4_") {
        return image(whole(stream, size)?);
    }
    image(member(FORMAT, stream, size, MEMBER)?)
}

fn image(bytes: Vec<u8>) -> Result<Areal, ReadFault> {
    let fault = |what, seen: &str| damaged(FORMAT, what, seen);
    let cut = || fault("its tables are cut off", "");
    let at = |start: usize, place: usize| {
        let found = start
            .checked_add(place)
            .and_then(|at| little::<u32>(&bytes, at));
        found.ok_or_else(cut)
    };
    let conditions = at(0, CONDITIONS)? as usize;
    let image = at(0, HEIGHTS)? as usize;
    if image == 0 {
        return Err(ReadFault::no_heights(FORMAT, "pictures alone"));
    }
    let (columns, rows) = (at(image, 0)? as usize, at(image, 4)? as usize);
    let bits = at(image, 8)?;
    let number = match bits {
        8 => RawNumber::U8,
        16 => RawNumber::U16,
        32 => RawNumber::U32,
        _ => {
            return Err(fault(
                "the width of its numbers is not known",
                &bits.to_string(),
            ));
        }
    };
    if at(image, 12)? != 0 {
        return Err(fault("the height image is compressed", ""));
    }
    let stated = at(image, 16)? as usize;
    if columns
        .checked_mul(rows)
        .and_then(|n| n.checked_mul(number.width()))
        != Some(stated)
    {
        return Err(fault(
            "the height image has not the bytes that it states",
            "",
        ));
    }
    let lengths = [X_LENGTH, Y_LENGTH, Z_LENGTH].map(|place| at(conditions, place));
    let [x, y, z] = lengths;
    let (x, y, z) = (f64::from(x?), f64::from(y?), f64::from(z?));
    let date = [4, 8, 12].map(|place| at(conditions, place).unwrap_or(0));
    let first = image.saturating_add(IMAGE_HEAD + PALETTE);
    let raw = Raw::new(bytes, number, Layout::packed(first, columns, rows, number));
    let mut raw = raw.ok_or_else(|| fault("the height image is cut off", ""))?;
    (raw.scale, raw.unit) = (z, Unit::PICOMETRE);
    let [dx, dy] = [x, y].map(|length| Unit::PICOMETRE.metres(length));
    let mut found = Areal::new(FORMAT, ArealHeights::Raw(raw)).spaced(dx, dy);
    found.metadata.instrument = Some("Keyence VK".into());
    if let [year @ 1990..=2200, month @ 1..=12, day @ 1..=31] = date {
        found.metadata.date = Some(format!("{year:04}-{month:02}-{day:02}"));
    }
    Ok(found)
}
