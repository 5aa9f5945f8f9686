//! Code V interferograms, as interferometers export them: `GRD columns rows SUR WVL wavelength SSZ scale NDA mark`, and numbers.
//!
//! Layout as its public reader states it (Gwyddion codevfile.c). A height is number · wavelength \[µm\] / scale, for a surface and
//! a wavefront. The file has no width of a pixel.

use super::trace::{Areal, ArealHeights};
use crate::read::damage::{damaged, miscounted};
use crate::read::error::ReadFault;
use crate::read::format::Format;
use crate::read::metadata::{number, short};

const FORMAT: Format = Format::CodeV;
/// Mark of a missing height, if none is stated.
const MISSING: f64 = 32767.0;

/// Whether the bytes start with remarks, a title, and the line of a grid.
pub(crate) fn recognised(bytes: &[u8]) -> bool {
    let lines = bytes.split(|byte| *byte == b'\n');
    let mut lines = lines.skip_while(|line| line.starts_with(b"!"));
    lines.nth(1).is_some_and(|line| line.starts_with(b"GRD "))
}

/// Reads the grid.
pub(super) fn read(bytes: &[u8]) -> Result<Areal, ReadFault> {
    let text = String::from_utf8_lossy(bytes);
    let mut lines = text.lines().skip_while(|line| line.starts_with('!'));
    let title = lines.next().and_then(short);
    let grid = lines.next().unwrap_or_default();
    let words: Vec<&str> = grid.split_whitespace().collect();
    let after = |name: &str, nth: usize| {
        let at = words.iter().position(|word| *word == name)?;
        number(words.get(at + nth)?)
    };
    let broken = || damaged(FORMAT, "its line GRD cannot be read", grid);
    if !["SUR", "WFR"].iter().any(|kind| words.contains(kind)) {
        return Err(ReadFault::no_heights(
            FORMAT,
            "neither a surface nor a wavefront",
        ));
    }
    let sizes = after("GRD", 1).zip(after("GRD", 2));
    let (columns, rows) = sizes.ok_or_else(broken)?;
    let scale = after("WVL", 1)
        .zip(after("SSZ", 1))
        .filter(|(_, size)| *size != 0.0);
    let (wavelength, size) = scale.ok_or_else(broken)?;
    let mark = after("NDA", 1).unwrap_or(MISSING);
    let numbers = lines.flat_map(str::split_whitespace).map_while(number);
    let height = |value: f64| {
        if value == mark {
            f64::NAN
        } else {
            value * wavelength / size / 1e6
        }
    };
    let values: Vec<f64> = numbers.map(height).collect();
    if !(columns >= 1.0 && columns * rows == values.len() as f64) {
        return Err(miscounted(FORMAT, values.len(), columns * rows));
    }
    let columns = columns as usize;
    let mut found = Areal::new(FORMAT, ArealHeights::Values { values, columns });
    found.metadata.title = title;
    Ok(found)
}
