//! Zygo XYZ text: a header of lines that ends with `#`, then a line `column row height` for each pixel, and `#`.
//!
//! Layout: MetroPro Reference Guide OMP-0347, "ASCII XYZ data files". Line 4 of the header has the first column and row of the
//! phase map and their numbers, line 8 as its seventh field the width of a pixel \[m\], which is 0 if it was not calibrated.
//! Heights are in micrometres; `No Data` is a missing one.

use super::trace::{Areal, Heights};
use crate::read::damage::{damaged, height};
use crate::read::error::ReadFault;
use crate::read::file_dialect::BadHeights;
use crate::read::format::Format;
use crate::read::metadata::{number, short};

const FORMAT: Format = Format::ZygoXyz;
/// Metres in the unit of the heights.
const MICROMETRE: f64 = 1e-6;
/// Line of the header, from 0, with the place and the size of the phase map.
const PHASE: usize = 3;
/// Line of the header with the comment.
const COMMENT: usize = 4;
/// Line of the header with the camera resolution, and its field.
const RESOLUTION: (usize, usize) = (7, 6);
/// Fewest bytes of a line: every pixel has one.
const LINE: usize = 6;

/// Reads the phase map.
pub(super) fn read(bytes: &[u8]) -> Result<Areal, ReadFault> {
    let fault = |what, seen: &str| damaged(FORMAT, what, seen);
    let text = String::from_utf8_lossy(bytes);
    let mut lines = (1..).zip(text.lines().map(str::trim));
    let is_before = |(_, line): &(usize, &str)| *line != "#";
    let header = lines.by_ref().take_while(is_before);
    let header: Vec<&str> = header.map(|(_, line)| line).collect();
    let field = |line: usize, field: usize| header.get(line)?.split_whitespace().nth(field);
    let whole = |k: usize| field(PHASE, k).and_then(|text| text.parse::<usize>().ok());
    let place = [whole(0), whole(1), whole(2), whole(3)];
    let [Some(left), Some(top), Some(columns), Some(rows)] = place else {
        let seen = header.get(PHASE).copied().unwrap_or_default();
        return Err(fault("the size of the phase map is not stated", seen));
    };
    let count = columns.saturating_mul(rows);
    if !(1..=bytes.len() / LINE).contains(&count) {
        return Err(fault("the phase map is empty or cut off", ""));
    }
    let mut values = vec![f64::NAN; count];
    let mut bad: Option<BadHeights> = None;
    for (number, line) in lines
        .take_while(is_before)
        .filter(|(_, line)| !line.is_empty())
    {
        let pixel = |text: &str, first: usize, count: usize| {
            let at = text.parse::<usize>().ok()?.checked_sub(first)?;
            (at < count).then_some(at)
        };
        let mut parts = line.splitn(3, char::is_whitespace);
        let mut next = || parts.next().unwrap_or_default().trim();
        let (column, row, text) = (next(), next(), next());
        let at = pixel(column, left, columns).zip(pixel(row, top, rows));
        let (column, row) = at.ok_or_else(|| fault("a point is not on the phase map", line))?;
        match (height(text), &mut bad) {
            (Some(height), _) => values[row * columns + column] = height * MICROMETRE,
            (None, Some(bad)) => bad.add(number, text),
            (None, None) => bad = Some(BadHeights::new(FORMAT, text, (number, line))),
        }
    }
    if let Some(bad) = bad {
        return Err(bad.fault());
    }
    let mut found = Areal::new(FORMAT, Heights::Values { values, columns });
    let (line, k) = RESOLUTION;
    let spacing = field(line, k)
        .and_then(number)
        .filter(|spacing| *spacing > 0.0);
    if let Some(spacing) = spacing {
        found = found.spaced(spacing, spacing);
    }
    let comment = header.get(COMMENT).map(|line| line.trim_matches('"'));
    found.metadata.title = comment.and_then(short);
    found.metadata.instrument = Some("Zygo".into());
    Ok(found)
}
