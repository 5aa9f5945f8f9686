//! Wyko ASCII of Vision: lines `name type length value`, of which some begin a block of numbers.
//!
//! Layout as its public readers state it (Gwyddion opdfile.c, SurfaceTopography). The second flag of the first line is 1 if the
//! heights are in nanometres; otherwise they are waves, numbers of `Wavelength` \[nm\] over `Mult`. A line of a block is a
//! column of the surface, from its last row to its first, as in the binary file. `Bad` is a missing height.

use std::collections::BTreeMap;

use super::trace::{Areal, ArealHeights};
use crate::read::damage::{damaged, height, miscounted};
use crate::read::error::ReadFault;
use crate::read::file_dialect::BadHeights;
use crate::read::format::Format;
use crate::read::metadata::{number, short};

const FORMAT: Format = Format::WykoText;
/// Names of blocks of heights; others have intensities.
const HEIGHTS: [&str; 4] = ["RAW_DATA", "RAW DATA", "OPD", "SAMPLE_DATA"];

/// Reads the first block of heights.
pub(super) fn read(bytes: &[u8]) -> Result<Areal, ReadFault> {
    let text = String::from_utf8_lossy(bytes);
    let mut lines = (1..).zip(text.lines());
    let first = lines.next().map_or("", |(_, line)| line);
    let flags: Vec<&str> = first.split_whitespace().rev().take(3).collect();
    let mut values: BTreeMap<&str, &str> = BTreeMap::new();
    let is_block = |(_, line): &(usize, &'_ str)| {
        let name = line.split('\t').next().unwrap_or_default().trim();
        HEIGHTS.contains(&name)
    };
    while let Some(line) = lines.next().filter(|line| !is_block(line)) {
        let mut cells = line.1.split('\t').map(str::trim);
        if let (Some(name), Some(value)) = (cells.next(), cells.next_back()) {
            values.insert(name, value);
        }
    }
    let stated = |name: &str| values.get(name).copied().and_then(number);
    let count = |name: &str| stated(name).filter(|count| *count >= 1.0 && count.fract() == 0.0);
    let size = count("X Size").zip(count("Y Size"));
    let (columns, rows) = size.ok_or_else(|| damaged(FORMAT, "X Size or Y Size is missing", ""))?;
    let (columns, rows) = (columns as usize, rows as usize);
    let of_waves = || Some(stated("Wavelength")? / stated("Mult").unwrap_or(1.0));
    let nanometres = match flags.get(1) {
        Some(&"1") => Some(1.0),
        _ => of_waves().filter(|scale| scale.is_finite() && *scale > 0.0),
    };
    let unknown = || {
        damaged(
            FORMAT,
            "Wavelength or Mult is not a length and a number",
            "",
        )
    };
    let nanometres = nanometres.ok_or_else(unknown)?;
    if columns.saturating_mul(rows) > bytes.len() {
        return Err(miscounted(FORMAT, 0, columns.saturating_mul(rows)));
    }
    let mut heights = vec![f64::NAN; columns * rows];
    let mut read = 0;
    for (column, (number, line)) in lines.take(columns).enumerate() {
        for (row, field) in line.split_whitespace().take(rows).enumerate() {
            let bad = || BadHeights::new(FORMAT, field, (number, line)).fault();
            let value = height(field).ok_or_else(bad)?;
            heights[(rows - 1 - row) * columns + column] = value * nanometres / 1e9;
            read += 1;
        }
    }
    if read != heights.len() {
        return Err(miscounted(FORMAT, read, heights.len()));
    }
    let pixel = stated("Pixel_size").unwrap_or(f64::NAN) / 1e3;
    let aspect = stated("Aspect").unwrap_or(1.0);
    let heights = ArealHeights::Values {
        values: heights,
        columns,
    };
    let mut found = Areal::new(FORMAT, heights).spaced(pixel, pixel * aspect);
    found.metadata.title = values.get("Title").and_then(|title| short(title));
    found.metadata.date = values.get("Date").and_then(|date| short(date));
    found.metadata.instrument = Some("Wyko".into());
    Ok(found)
}
