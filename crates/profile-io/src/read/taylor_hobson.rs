//! Text profiles (`.prf`) of Taylor Hobson instruments, as NPL publishes its softgauges.
//!
//! | line | meaning |
//! |---|---|
//! | `1 2` / `SG2004 0.000000e+000 PRF` | version, identification, type |
//! | `CX M 2.240100e+004 MM 1.000000e+000 D` | axis, points, unit, factor, data type |
//! | `CZ M 2.240100e+004 UM 1.000000e-006 L` | heights: whole numbers times the factor, in the unit |
//! | `SPACING CX 2.500000e-004` | in the unit of CX |
//! | `MAP 1.0 CZ CZ 1.0 1.0` | a linear map of the heights; only the identity is read |
//!
//! Records end with `EOR`, the file with `EOF`. There is no public definition; the layout follows NPL's published
//! example.

use super::damage::{damaged, height, miscounted};
use super::error::ReadFault;
use super::file_dialect::BadHeights;
use super::format::Format;
use super::found::Found;
use super::grid::SpacingSource;
use super::lengths::Lengths;
use super::metadata::{Metadata, number, short};
use super::options::LengthUnit;
use super::plain_row::take_numbers;
use super::text::TextSource;

const FORMAT: Format = Format::TaylorHobsonPrf;

struct AxisRecord {
    points: usize,
    unit: LengthUnit,
    factor: f64,
}

/// Records 1 and 2.
#[derive(Default)]
struct Header {
    x: Option<AxisRecord>,
    z: Option<AxisRecord>,
    spacing: Option<f64>,
    metadata: Metadata,
}

impl Header {
    fn take(&mut self, record: usize, line: &str) -> Result<(), ReadFault> {
        let mut fields = line.split_whitespace();
        match (record, fields.next().unwrap_or_default()) {
            (1, "CX") => self.x = Some(axis(line)?),
            (1, "CZ") => self.z = Some(axis(line)?),
            (1, first) if fields.clone().last() == Some("PRF") => {
                self.metadata.title = short(first)
            }
            (2, "SPACING") => self.spacing = fields.nth(1).and_then(number),
            (2, "STYLUS_RADIUS") => {
                let radius = fields.next().zip(fields.next());
                let radius =
                    radius.and_then(|(r, unit)| super::metadata::length(&format!("{r} {unit}")));
                self.metadata.stylus_radius = radius.filter(|radius| radius.si() > 0.0);
            }
            (2, "MAP") => check_map(line)?,
            (2, "COMMENT") => self.metadata.title = short(line.trim_start_matches("COMMENT")),
            _ => {}
        }
        Ok(())
    }
}

/// Reads a text `.prf`.
pub(super) fn read(text: &mut TextSource<'_>) -> Result<Found, ReadFault> {
    let (mut record, mut first_line) = (1, 1);
    let mut header = Header::default();
    let mut heights: Vec<f64> = Vec::new();
    let mut lines = text.lines()?;
    while let Some(line) = lines.next()? {
        match line.text.split_whitespace().next() {
            None => {}
            Some("EOF") => break,
            Some("EOR") if record == 3 => break,
            Some("EOR") => {
                record += 1;
                first_line = line.number + 1;
            }
            Some(_) if record == 3 => {
                for field in line.text.split_whitespace() {
                    let Some(height) = height(field) else {
                        let bad = BadHeights::new(FORMAT, field, (line.number, line.text));
                        return Err(bad.in_all(&mut lines, |line| line));
                    };
                    heights.push(height);
                }
                take_numbers(&mut lines, usize::MAX, &mut heights);
            }
            Some(_) => header.take(record, line.text)?,
        }
    }
    let axes = header.x.zip(header.z);
    let (x, z) = axes.ok_or_else(|| damaged(FORMAT, "an axis CX or CZ is missing", ""))?;
    if heights.len() != z.points {
        return Err(miscounted(FORMAT, heights.len(), z.points));
    }
    heights.iter_mut().for_each(|h| *h *= z.factor);
    let dx = header.spacing.map(|dx| dx * x.factor);
    Ok(Found {
        spacing: dx
            .filter(|dx| *dx > 0.0)
            .map(|dx| (Lengths::new(dx, x.unit), SpacingSource::Header)),
        metadata: header.metadata,
        first_line: Some(first_line),
        ..Found::new(FORMAT, Lengths::new(heights, z.unit))
    })
}

fn axis(line: &str) -> Result<AxisRecord, ReadFault> {
    let broken = || damaged(FORMAT, "an axis line cannot be read", line);
    let fields: Vec<&str> = line.split_whitespace().collect();
    let field = |at: usize| fields.get(at).copied().unwrap_or_default();
    let points = number(field(2)).filter(|n| *n >= 1.0 && *n < 1e9);
    Ok(AxisRecord {
        points: points.ok_or_else(broken)? as usize,
        unit: field(3).parse().map_err(|_| broken())?,
        factor: number(field(4)).filter(|f| *f != 0.0).ok_or_else(broken)?,
    })
}

/// Returns an error for a map that changes the heights, because its rule is not public.
fn check_map(line: &str) -> Result<(), ReadFault> {
    let fields: Vec<&str> = line.split_whitespace().skip(2).collect();
    let is = |at: usize, value: f64| fields.get(at).and_then(|f| number(f)) == Some(value);
    let identity = match fields.get(..2) {
        Some(["CZ", "CZ"]) => is(2, 1.0) && is(3, 1.0),
        Some(["CZ", "CX"]) => is(3, 0.0),
        _ => true,
    };
    if identity {
        return Ok(());
    }
    Err(damaged(
        FORMAT,
        "the heights are mapped, which is not read",
        line,
    ))
}
