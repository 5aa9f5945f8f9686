//! MATLAB data of level 5: a profile as a vector, a surface as a matrix.
//!
//! The file has neither units nor spacing. Of several arrays the first one named `z`, `heights`, `height`, `profile` or
//! `depth` is read, ignoring case.

use super::bytes::part;
use super::chosen::chosen;
use super::mat_elements::arrays;
use super::raw::{Layout, Raw};
use super::trace::{Areal, ArealHeights};
use crate::read::damage::damaged;
use crate::read::error::ReadFault;
use crate::read::format::Format;
use crate::read::header::is_depth;
use crate::read::lengths::Lengths;
use crate::read::metadata::short;
use crate::warning::Warning;

const FORMAT: Format = Format::Matlab;
/// Version and byte order, at the end of the header.
const LEVEL_5: &[u8] = b"\x00\x01IM";
const LEVEL_7_3: &[u8] = b"\x00\x02IM";

/// Whether the file is of level 7.3, which is HDF5.
pub(super) fn is_hdf5(bytes: &[u8]) -> bool {
    part(bytes, 124, 4) == Some(LEVEL_7_3)
}

/// Reads the heights of a file of level 5.
pub(super) fn read(bytes: &[u8]) -> Result<Areal, ReadFault> {
    let fault = |what, seen: &str| damaged(FORMAT, what, seen);
    match part(bytes, 124, 4) {
        Some(LEVEL_5) => {}
        _ => return Err(fault("only level 5 with the low byte first is read", "")),
    }
    let mut all = arrays(bytes)?;
    all.retain(|array| array.rows.max(array.columns) > 1);
    let all = all.into_iter().map(|array| (array.name.clone(), array));
    let (name, array) = chosen(FORMAT, all.collect())?;
    // A row or column vector is a profile.
    let (columns, rows) = match array.columns {
        1 => (array.rows, 1),
        _ => (array.columns, array.rows),
    };
    let width = array.number.width() as i64;
    let steps = match rows {
        1 => [width, width],
        _ => [width.saturating_mul(rows as i64), width],
    };
    let layout = Layout {
        first: 0,
        columns,
        rows,
        steps,
    };
    let raw = Raw::new(array.data, array.number, layout);
    let raw = raw.ok_or_else(|| fault("an array has fewer numbers than its size", ""))?;
    let numbers = Lengths::Numbers(ArealHeights::Raw(raw), None);
    let mut found = Areal::from_heights(FORMAT, numbers);
    found
        .warnings
        .extend(is_depth(&name).then_some(Warning::DepthsTurned));
    found.metadata.title = short(&name);
    Ok(found)
}
