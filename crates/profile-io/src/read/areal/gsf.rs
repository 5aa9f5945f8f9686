//! Gwyddion Simple Field: lines `name = value`, zeros up to a multiple of four bytes, and heights as `f32`.
//!
//! Layout: section "Gwyddion Simple Field" of the Gwyddion user guide. A height that is not a number is missing.

use std::collections::BTreeMap;

use super::raw::{Layout, Raw, RawNumber};
use super::trace::{Areal, ArealHeights};
use crate::read::damage::damaged;
use crate::read::error::ReadFault;
use crate::read::format::Format;
use crate::read::header;
use crate::read::metadata::{number, short};

const FORMAT: Format = Format::GwyddionSimple;

/// Reads the field.
pub(super) fn read(bytes: Vec<u8>) -> Result<Areal, ReadFault> {
    let end = bytes.iter().position(|byte| *byte == 0);
    let end = end.ok_or_else(|| damaged(FORMAT, "its header has no end", ""))?;
    let header = String::from_utf8_lossy(&bytes[..end]).into_owned();
    let lines = header.lines().filter_map(|line| line.split_once('='));
    let values: BTreeMap<&str, &str> = lines.map(|(k, v)| (k.trim(), v.trim())).collect();
    let unit = |name: &str| values.get(name).copied().filter(|unit| !unit.is_empty());
    let heights = unit("ZUnits").map(|unit| header::unit(unit).ok_or(unit));
    let heights = heights
        .transpose()
        .map_err(|_| ReadFault::no_heights(FORMAT, "no heights in a unit of length"))?;
    let side = |name: &str| values.get(name).and_then(|size| size.parse::<usize>().ok());
    let size = side("XRes").zip(side("YRes"));
    let (columns, rows) = size.ok_or_else(|| damaged(FORMAT, "XRes or YRes is missing", ""))?;
    let lateral = unit("XYUnits").and_then(header::unit);
    let spacing = |name: &str, count: usize| {
        let length = values.get(name).copied().and_then(number).unwrap_or(1.0);
        lateral.map_or(f64::NAN, |unit| unit.metres(length) / count as f64)
    };
    let (dx, dy) = (spacing("XReal", columns), spacing("YReal", rows));
    let title = values.get("Title").and_then(|title| short(title));
    let layout = Layout::packed((end / 4 + 1) * 4, columns, rows, RawNumber::F32);
    let raw = Raw::new(bytes, RawNumber::F32, layout);
    let raw = raw.ok_or_else(|| damaged(FORMAT, "the heights are cut off", ""))?;
    let mut found = Areal::in_own_unit(FORMAT, ArealHeights::Raw(raw), heights).spaced(dx, dy);
    found.metadata.title = title;
    Ok(found)
}
