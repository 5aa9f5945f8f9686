//! Zygo text of MetroPro and Mx: a header of lines that ends with `#`, then points or numbers, and `#`.
//!
//! Layout: MetroPro Reference Guide OMP-0347, "ASCII data files". Line 4 of the header has the first column and row of the phase
//! map and their numbers, line 8 interferometric scale factor, wavelength \[m\], obliquity factor and, as its seventh field, the
//! width of a pixel \[m\], which is 0 if it was not calibrated. XYZ has a line `column row height` for each pixel, with heights
//! in micrometres, and `No Data` for a missing one. ASCII has numbers row by row, after the intensities: a height is
//! number · S · W · O / R as in the binary file, with the phase resolution in line 11.

use super::metropro;
use super::trace::{Areal, ArealHeights};
use crate::read::damage::{damaged, height, miscounted};
use crate::read::error::ReadFault;
use crate::read::file_dialect::BadHeights;
use crate::read::format::Format;
use crate::read::metadata::{number, short};

/// Metres in the unit of the heights of points.
const MICROMETRE: f64 = 1e-6;
/// Line of the header, from 0, with the place and the size of the phase map.
const PHASE: usize = 3;
/// Line of the header with the comment.
const COMMENT: usize = 4;
/// Line of the header with the scales, and the field of the camera resolution.
const SCALES: usize = 7;
const RESOLUTION: usize = 6;
/// Line of the header with the processing, and the field of the sign.
const PROCESSING: usize = 10;
const SIGN: usize = 7;
/// Fewest bytes of a number and its separator.
const FEWEST: usize = 2;

/// The lines of the header.
struct ZygoHeader<'a> {
    format: Format,
    lines: Vec<&'a str>,
}

impl ZygoHeader<'_> {
    fn field(&self, line: usize, field: usize) -> Option<&str> {
        self.lines.get(line)?.split_whitespace().nth(field)
    }

    fn whole(&self, line: usize, field: usize) -> Option<usize> {
        self.field(line, field)?.parse().ok()
    }

    fn scale(&self, field: usize) -> Result<f64, ReadFault> {
        let scale = self.field(SCALES, field).and_then(number);
        scale.ok_or_else(|| damaged(self.format, "a scale of the heights is not a number", ""))
    }

    /// Factor from a number of the phase map to metres.
    fn factor(&self) -> Result<f64, ReadFault> {
        let resolution = self.whole(PROCESSING, 0);
        let steps = resolution.and_then(|at| metropro::RESOLUTIONS.get(at));
        let unknown = || damaged(self.format, "the phase resolution is not known", "");
        let factor =
            self.scale(1)? * self.scale(2)? * self.scale(4)? / steps.ok_or_else(unknown)?;
        let is_turned = self.whole(PROCESSING, SIGN).is_some_and(|sign| sign != 0);
        Ok(if is_turned { -factor } else { factor })
    }
}

/// Reads the phase map.
pub(super) fn read(format: Format, bytes: &[u8]) -> Result<Areal, ReadFault> {
    let text = String::from_utf8_lossy(bytes);
    let mut lines = (1..).zip(text.lines().map(str::trim));
    let is_before = |(_, line): &(usize, &str)| *line != "#";
    let header = lines.by_ref().take_while(is_before);
    let header = ZygoHeader {
        format,
        lines: header.map(|(_, line)| line).collect(),
    };
    let size = header.whole(PHASE, 2).zip(header.whole(PHASE, 3));
    let (columns, rows) = size.ok_or_else(|| {
        let seen = header.lines.get(PHASE).copied().unwrap_or_default();
        damaged(format, "the size of the phase map is not stated", seen)
    })?;
    let count = columns.saturating_mul(rows);
    if !(1..=bytes.len() / FEWEST).contains(&count) {
        return Err(damaged(format, "the phase map is empty or cut off", ""));
    }
    let values = match format {
        Format::ZygoXyz => points(&header, columns, rows, lines)?,
        _ => phases(&header, count, lines)?,
    };
    let spacing = header.field(SCALES, RESOLUTION).and_then(number);
    let spacing = spacing.unwrap_or(f64::NAN);
    let heights = ArealHeights::Values { values, columns };
    let mut found = Areal::new(format, heights).spaced(spacing, spacing);
    let comment = header.lines.get(COMMENT);
    found.metadata.title = comment.and_then(|line| short(line.trim_matches('"')));
    found.metadata.instrument = Some("Zygo".into());
    Ok(found)
}

/// Heights \[m\] of points, each with its column and row.
fn points<'a>(
    header: &ZygoHeader<'_>,
    columns: usize,
    rows: usize,
    lines: impl Iterator<Item = (usize, &'a str)>,
) -> Result<Vec<f64>, ReadFault> {
    let format = header.format;
    let [left, top] = [0, 1].map(|field| header.whole(PHASE, field).unwrap_or(0));
    let mut values = vec![f64::NAN; columns * rows];
    let mut bad: Option<BadHeights> = None;
    for (number, line) in lines.take_while(|(_, line)| *line != "#") {
        if line.is_empty() {
            continue;
        }
        let pixel = |text: &str, first: usize, count: usize| {
            let at = text.parse::<usize>().ok()?.checked_sub(first)?;
            (at < count).then_some(at)
        };
        let mut parts = line.splitn(3, char::is_whitespace);
        let mut next = || parts.next().unwrap_or_default().trim();
        let (column, row, text) = (next(), next(), next());
        let at = pixel(column, left, columns).zip(pixel(row, top, rows));
        let outside = || damaged(format, "a point is not on the phase map", line);
        let (column, row) = at.ok_or_else(outside)?;
        match (height(text), &mut bad) {
            (Some(height), _) => values[row * columns + column] = height * MICROMETRE,
            (None, Some(bad)) => bad.add(number, text),
            (None, None) => bad = Some(BadHeights::new(format, text, (number, line))),
        }
    }
    match bad {
        Some(bad) => Err(bad.fault()),
        None => Ok(values),
    }
}

/// Heights \[m\] of the last block of numbers: intensities are before it.
fn phases<'a>(
    header: &ZygoHeader<'_>,
    count: usize,
    lines: impl Iterator<Item = (usize, &'a str)>,
) -> Result<Vec<f64>, ReadFault> {
    let factor = header.factor()?;
    let (mut values, mut is_ended) = (Vec::new(), false);
    for (number, line) in lines {
        if line == "#" {
            is_ended = true;
            continue;
        }
        if std::mem::take(&mut is_ended) && !line.is_empty() {
            values.clear();
        }
        for field in line.split_whitespace() {
            let bad = || BadHeights::new(header.format, field, (number, line)).fault();
            values.push(height(field).ok_or_else(bad)?);
        }
    }
    if values.len() != count {
        return Err(miscounted(header.format, values.len(), count));
    }
    for value in &mut values {
        let is_missing = *value >= metropro::INVALID;
        *value = if is_missing {
            f64::NAN
        } else {
            *value * factor
        };
    }
    Ok(values)
}
