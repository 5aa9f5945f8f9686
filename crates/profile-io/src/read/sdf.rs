//! SDF as text (ISO 25178-71, EUNA 15178, "BCR").
//!
//! A header of `name = value` lines, `*`, the heights in any number per line, `*`, a trailer. A height is value ·
//! Zscale metres; `BAD`, or in the proposal BCR the largest number of the type, marks a missing height. Of several rows the
//! requested one is read.

use super::areal::trace::{Areal, ArealHeights};
use super::damage::{damaged, height, miscounted};
use super::error::ReadFault;
use super::file_dialect::BadHeights;
use super::format::Format;
use super::found::Found;
use super::grid::{SpacingSource, chosen_row};
use super::lengths::Lengths;
use super::metadata::{Metadata, number, short};
use super::options::ReadOptions;
use super::plain_row::take_numbers;
use super::sdf_mark;
use super::text::TextSource;

const FORMAT: Format = Format::SdfAscii;

#[derive(Default)]
struct SdfHeader {
    points: Option<u64>,
    profiles: Option<u64>,
    x_scale: Option<f64>,
    y_scale: Option<f64>,
    z_scale: Option<f64>,
    compressed: bool,
    is_proposal: bool,
    kind: Option<usize>,
    metadata: Metadata,
}

impl SdfHeader {
    fn take(&mut self, line: &str) {
        let Some((key, value)) = line.split_once('=') else {
            self.is_proposal |= line.starts_with("aBCR");
            return;
        };
        let value = value.trim();
        match key.trim().to_ascii_lowercase().as_str() {
            "manufacid" => self.metadata.instrument = short(value),
            "createdate" => self.metadata.date = short(value),
            "numpoints" => self.points = value.parse().ok(),
            "numprofiles" => self.profiles = value.parse().ok(),
            "xscale" => self.x_scale = number(value).filter(|scale| *scale > 0.0),
            "yscale" => self.y_scale = number(value).filter(|scale| *scale > 0.0),
            "zscale" => self.z_scale = number(value).filter(|scale| *scale != 0.0),
            "datatype" => self.kind = value.parse().ok(),
            "compression" => self.compressed = number(value).is_some_and(|kind| kind != 0.0),
            _ => {}
        }
    }
}

/// Reads a profile of an SDF text file.
pub(super) fn read(text: &mut TextSource<'_>, options: &ReadOptions) -> Result<Found, ReadFault> {
    let (header, first_line, heights) = matrix(text, Some(options.row))?;
    Ok(Found {
        spacing: header
            .x_scale
            .map(|dx| (Lengths::Metres(dx), SpacingSource::Header)),
        metadata: header.metadata,
        first_line: Some(first_line),
        ..Found::new(FORMAT, Lengths::Metres(heights))
    })
}

/// Reads all profiles of an SDF text file.
pub(super) fn surface(text: &mut TextSource<'_>) -> Result<Areal, ReadFault> {
    let (header, _, values) = matrix(text, None)?;
    let columns = header.points.unwrap_or(0) as usize;
    Ok(Areal {
        spacings: [header.x_scale, header.y_scale].map(|step| step.map(Lengths::Metres)),
        metadata: header.metadata,
        ..Areal::new(FORMAT, ArealHeights::Values { values, columns })
    })
}

/// Header, first line of the heights, and the heights \[m\] of one profile (counted from 1) or of all profiles.
fn matrix(
    text: &mut TextSource<'_>,
    row: Option<Option<usize>>,
) -> Result<(SdfHeader, usize, Vec<f64>), ReadFault> {
    let mut header = SdfHeader::default();
    let mut lines = text.lines()?;
    let mut first_line = 1;
    while let Some(line) = lines.next()? {
        first_line = line.number + 1;
        if line.text.trim() == "*" {
            break;
        }
        header.take(line.text);
    }
    let missing = |what| damaged(FORMAT, what, "");
    let points = header.points.filter(|n| *n > 0);
    let points = points.ok_or_else(|| missing("NumPoints is missing"))?;
    let z_scale = header.z_scale.ok_or_else(|| missing("Zscale is missing"))?;
    if header.compressed {
        return Err(missing("the heights are compressed"));
    }
    let rows = header.profiles.unwrap_or(1).max(1);
    let (first, wanted) = match row {
        Some(row) => {
            let row = chosen_row(row, rows as usize, points as usize)? as u64;
            (row.saturating_mul(points), points)
        }
        None => (0, points.saturating_mul(rows)),
    };
    let mut heights = Vec::new();
    let mut passed = 0_u64;
    'data: while let Some(line) = lines.next()? {
        for field in line.text.split_whitespace() {
            if field == "*" || passed >= first.saturating_add(wanted) {
                break 'data;
            }
            if passed >= first {
                let Some(height) = height(field) else {
                    let bad = BadHeights::new(FORMAT, field, (line.number, line.text));
                    return Err(bad.in_all(&mut lines, |line| line));
                };
                heights.push(height);
            }
            passed += 1;
        }
        if passed >= first {
            let left = wanted - heights.len() as u64;
            let before = heights.len();
            take_numbers(&mut lines, left as usize, &mut heights);
            passed += (heights.len() - before) as u64;
        }
    }
    if heights.len() as u64 != wanted {
        return Err(miscounted(FORMAT, heights.len(), wanted));
    }
    let marked = header.kind.filter(|_| header.is_proposal);
    let between = marked.map(|kind| sdf_mark::between(kind, true));
    heights.iter_mut().for_each(|z| {
        *z = match between {
            Some([below, above]) if *z <= below || *z >= above => f64::NAN,
            _ => *z * z_scale,
        }
    });
    Ok((header, first_line, heights))
}
