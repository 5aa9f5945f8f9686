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
//! Records end with `EOR`, the file with `EOF`. There is no public definition; the layout is that of
//! NPL's published example.

use super::archive::damaged;
use super::error::ReadError;
use super::format::Format;
use super::grid::SpacingSource;
use super::metadata::{Metadata, number, short};
use super::options::LengthUnit;
use super::trace::Trace;

const FORMAT: Format = Format::TaylorHobsonPrf;

struct Axis {
    points: usize,
    unit: LengthUnit,
    factor: f64,
}

/// Reads a text `.prf`.
pub(super) fn read(file: &str, text: &str) -> Result<Trace, ReadError> {
    let (mut record, mut first_line) = (1, 1);
    let (mut x, mut z, mut spacing) = (None, None, None);
    let mut metadata = Metadata::default();
    let mut heights: Vec<f64> = Vec::new();
    for (at, line) in text.lines().enumerate() {
        let fields: Vec<&str> = line.split_whitespace().collect();
        match (record, fields.first()) {
            (_, None) => {}
            (_, Some(&"EOF")) => break,
            (_, Some(&"EOR")) => {
                record += 1;
                first_line = at + 2;
            }
            (1, Some(&"CX")) => x = Some(axis(file, line)?),
            (1, Some(&"CZ")) => z = Some(axis(file, line)?),
            (1, Some(first)) => {
                if fields.last() == Some(&"PRF") {
                    metadata.title = short(first);
                }
            }
            (2, Some(&"SPACING")) => spacing = fields.get(2).and_then(|dx| number(dx)),
            (2, Some(&"STYLUS_RADIUS")) => {
                let radius = fields.get(1).zip(fields.get(2));
                let radius =
                    radius.and_then(|(r, unit)| super::metadata::length(&format!("{r} {unit}")));
                metadata.stylus_radius = radius.filter(|radius| radius.si() > 0.0);
            }
            (2, Some(&"MAP")) => check_map(file, line)?,
            (2, Some(&"COMMENT")) => metadata.title = short(line.trim_start_matches("COMMENT")),
            (2, Some(_)) => {}
            (3, Some(_)) => {
                for field in fields {
                    let value = number(field);
                    heights
                        .push(value.ok_or_else(|| {
                            damaged(file, FORMAT, "a height is no number", field)
                        })?);
                }
            }
            (_, Some(_)) => {}
        }
        if record > 3 {
            break;
        }
    }
    let first_line = first_line.saturating_sub(if record > 3 { heights.len() + 1 } else { 0 });
    let axes = x.zip(z);
    let (x, z) = axes.ok_or_else(|| damaged(file, FORMAT, "an axis CX or CZ is missing", ""))?;
    if heights.len() != z.points {
        let seen = format!("{} of {}", heights.len(), z.points);
        let what = "the number of heights is not that of the header";
        return Err(damaged(file, FORMAT, what, &seen));
    }
    heights.iter_mut().for_each(|h| *h *= z.factor);
    let dx = spacing.map(|dx| dx * x.factor).filter(|dx| *dx > 0.0);
    Ok(Trace {
        z_unit: z.unit,
        x_unit: x.unit,
        spacing: dx.map(|dx| (dx, SpacingSource::Header)),
        metadata,
        first_line: first_line.max(1),
        ..Trace::new(FORMAT, heights)
    })
}

fn axis(file: &str, line: &str) -> Result<Axis, ReadError> {
    let broken = || damaged(file, FORMAT, "an axis line cannot be read", line);
    let fields: Vec<&str> = line.split_whitespace().collect();
    let field = |at: usize| fields.get(at).copied().unwrap_or_default();
    let points = number(field(2)).filter(|n| *n >= 1.0 && *n < 1e9);
    Ok(Axis {
        points: points.ok_or_else(broken)? as usize,
        unit: field(3).parse().map_err(|_| broken())?,
        factor: number(field(4)).filter(|f| *f != 0.0).ok_or_else(broken)?,
    })
}

/// Refuses a map of the heights that would change them: its rule is not public.
fn check_map(file: &str, line: &str) -> Result<(), ReadError> {
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
        file,
        FORMAT,
        "the heights are mapped, which is not read",
        line,
    ))
}
