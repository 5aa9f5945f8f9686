//! Wyko and Veeco OPD: a directory of blocks, one of them the heights in wavelengths.
//!
//! Layout: Gwyddion opdfile.c, SurfaceTopography, surfalize. The heights are stored column by column, each from its
//! lower end. A height is number · Wavelength / Mult in nanometres, the spacing `Pixel_size` in millimetres, between
//! rows times `Aspect`. Whole numbers from 32766 and floats from 1e38 up are missing heights.

use super::bytes::{little, text};
use super::raw::{Layout, Missing, Raw, RawNumber, Unit};
use super::trace::{Areal, ArealHeights};
use crate::read::damage::damaged;
use crate::read::error::ReadFault;
use crate::read::format::Format;
use crate::read::metadata::short;

const FORMAT: Format = Format::Opd;
/// Bytes before the directory, and of an entry.
const START: usize = 2;
const ENTRY: usize = 24;
/// Maximum number of entries; real files have a thousand.
const MOST_ENTRIES: usize = 100_000;
/// Names of the block of heights, in the order of preference.
const HEIGHTS: [&str; 5] = ["RAW_DATA", "RAW DATA", "OPD", "Raw", "SAMPLE_DATA"];
/// Kinds of block.
const ARRAY: u16 = 3;
const SHORT: u16 = 6;
const FLOAT: u16 = 7;
/// Numbers from here up are missing heights.
const BAD_SHORT: f64 = 32766.0;
const BAD_FLOAT: f64 = 1e38_f32 as f64;

struct OpdBlock {
    name: String,
    kind: u16,
    first: usize,
    size: usize,
}

/// Reads the heights.
pub(super) fn read(bytes: Vec<u8>) -> Result<Areal, ReadFault> {
    let fault = |what, seen: &str| damaged(FORMAT, what, seen);
    let blocks = blocks(&bytes).ok_or_else(|| fault("the directory of blocks is cut off", ""))?;
    let block = |name: &str| {
        blocks
            .iter()
            .find(|block| block.name == name && block.size > 0)
    };
    let float = |name: &str| {
        let found = block(name).filter(|block| block.kind == FLOAT)?;
        little::<f32>(&bytes, found.first).map(f64::from)
    };
    let heights = HEIGHTS
        .iter()
        .find_map(|name| block(name).filter(|block| block.kind == ARRAY));
    let Some(heights) = heights else {
        return Err(ReadFault::no_heights(FORMAT, "no block of heights"));
    };
    let count = |at| little::<u16>(&bytes, heights.first + at).map(usize::from);
    let [Some(columns), Some(rows), Some(width)] = [count(0), count(2), count(4)] else {
        return Err(fault("the block of heights is cut off", ""));
    };
    let (number, missing) = match width {
        2 => (RawNumber::I16, BAD_SHORT),
        4 => (RawNumber::F32, BAD_FLOAT),
        _ => {
            return Err(fault(
                "the width of its numbers is not known",
                &width.to_string(),
            ));
        }
    };
    let stated = columns
        .saturating_mul(rows)
        .saturating_mul(width)
        .saturating_add(6);
    if stated > heights.size {
        return Err(fault("the block of heights is smaller than its matrix", ""));
    }
    let wavelength = float("Wavelength").ok_or_else(|| fault("Wavelength is missing", ""))?;
    let mult = block("Mult").filter(|block| block.kind == SHORT);
    let mult = mult.and_then(|block| little::<u16>(&bytes, block.first));
    let mult = mult.filter(|mult| *mult > 0).map_or(1.0, f64::from);
    let pixel = float("Pixel_size").unwrap_or(f64::NAN) / 1e3;
    let aspect = float("Aspect").unwrap_or(1.0);
    let said = |name| block(name).and_then(|block| text(&bytes, block.first, block.size.min(80)));
    let (title, date) = (said("Title"), said("Date"));
    let column = (rows * width) as i64;
    let layout = Layout {
        first: heights.first + 6 + (rows.saturating_sub(1)) * width,
        columns,
        rows,
        steps: [column, -(width as i64)],
    };
    let raw = Raw::new(bytes, number, layout);
    let mut raw = raw.ok_or_else(|| fault("the heights are cut off", ""))?;
    raw.missing = Missing::AtLeast(missing);
    (raw.scale, raw.unit) = (wavelength / mult, Unit::NANOMETRE);
    let mut found = Areal::new(FORMAT, ArealHeights::Raw(raw)).spaced(pixel, pixel * aspect);
    found.metadata.title = title.as_deref().and_then(short);
    found.metadata.date = date.as_deref().and_then(short);
    found.metadata.instrument = Some("Wyko".into());
    Ok(found)
}

/// The blocks of the directory; `None` if it or one of them is truncated.
fn blocks(bytes: &[u8]) -> Option<Vec<OpdBlock>> {
    let entry = |at: usize| {
        let start = START + at * ENTRY;
        let size: i32 = little(bytes, start + 18)?;
        Some((
            text(bytes, start, 16)?,
            little::<u16>(bytes, start + 16)?,
            usize::try_from(size).unwrap_or(0),
        ))
    };
    let (_, _, listed) = entry(0)?;
    let count = listed / ENTRY;
    if count > MOST_ENTRIES {
        return None;
    }
    let mut first = START + listed;
    let mut blocks = Vec::new();
    for at in 1..count {
        let (name, kind, size) = entry(at)?;
        blocks.push(OpdBlock {
            name,
            kind,
            first,
            size,
        });
        first = first.checked_add(size).filter(|end| *end <= bytes.len())?;
    }
    Some(blocks)
}
