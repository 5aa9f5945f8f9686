//! A matrix of heights as text: one trace a row, without x and without labels.

use super::archive::damaged;
use super::dialect::{Cell, Sniffed};
use super::error::ReadError;
use super::format::Format;
use super::header::Label;
use super::layout::TableLayout;
use super::options::{Columns, ReadOptions};
use super::table;
use super::text::{Line, Text};
use super::trace::Trace;
use super::units::{self, Extent};
use super::{grid, options};
use crate::warning::Warning;

const FORMAT: Format = Format::TextMatrix;

/// Whether a table of columns with these labels is a matrix: as many columns as a profile has points, and
/// none of them named or asked for.
pub(super) fn is_matrix(labels: &[Label], options: &ReadOptions) -> bool {
    labels.len() >= grid::FEWEST_POINTS
        && options.columns.is_none()
        && labels.iter().all(|label| label.role.is_none())
}

/// The row that `options` ask for, of the matrix that starts at line `first`.
pub(super) fn read(
    text: &mut Text<'_>,
    first: usize,
    head: &[Line<'_>],
    sniffed: &Sniffed,
    options: &ReadOptions,
) -> Result<Trace, ReadError> {
    let file = text.file;
    let (columns, dialect) = (sniffed.columns, sniffed.dialect);
    let (mut rows, mut chosen) = (0, None);
    let mut lines = text.lines()?;
    while let Some(line) = lines.next()? {
        if line.number < first || line.is_blank() {
            continue;
        }
        rows += 1;
        if options.row != Some(rows) {
            continue;
        }
        let mut heights = Vec::with_capacity(columns);
        for cell in dialect.cells(line.text) {
            heights.push(match dialect.cell(cell) {
                Cell::Number(value) => value,
                Cell::Missing => f64::NAN,
                Cell::Other => return Err(table::unreadable(file, head, &line, cell, dialect)),
            });
        }
        // A separator at the end of each line makes an empty last cell.
        if heights.len() == columns + 1 && heights[columns].is_nan() {
            heights.pop();
        }
        if heights.len() != columns {
            return Err(table::ragged(file, &line, heights.len(), columns));
        }
        chosen = Some((line.number, heights));
    }
    let Some((first_line, heights)) = chosen else {
        return Err(ReadError::SeveralProfiles {
            file: file.to_owned(),
            rows,
            points: columns,
            asked: options.row.unwrap_or(0),
        });
    };
    let z_unit = unit(file, &heights, options)?;
    let assumed = options.z_unit.is_none().then_some(Warning::UnitAssumed {
        axis: options::Axis::Height,
        unit: z_unit,
    });
    Ok(Trace {
        warnings: assumed.into_iter().collect(),
        z_unit,
        first_line,
        table: Some(TableLayout {
            separator: dialect.separator,
            decimal: dialect.decimal,
            columns: Columns { x: None, z: 1 },
        }),
        ..Trace::new(FORMAT, heights)
    })
}

/// The unit of the heights: stated, or the only possible one.
fn unit(
    file: &str,
    heights: &[f64],
    options: &ReadOptions,
) -> Result<options::LengthUnit, ReadError> {
    if let Some(unit) = options.z_unit {
        return Ok(unit);
    }
    let known: Vec<f64> = heights.iter().copied().filter(|z| z.is_finite()).collect();
    if known.is_empty() {
        return Err(damaged(file, FORMAT, "the row has no heights", ""));
    }
    let (low, high) = asperity_core::numerics::extremes(&known);
    let span = high - low;
    let dx = options.dx.map_or(f64::NAN, |dx| dx.si());
    let squares = known.windows(2).map(|pair| (pair[1] - pair[0]).powi(2));
    let step = (squares.sum::<f64>() / known.len() as f64).sqrt();
    let extent = Extent {
        length: dx * (heights.len() - 1) as f64,
        span,
        slope: step / dx,
    };
    units::heights_only(extent).ok_or_else(|| ReadError::NoUnit {
        file: file.to_owned(),
        axis: options::Axis::Height,
        span,
    })
}
