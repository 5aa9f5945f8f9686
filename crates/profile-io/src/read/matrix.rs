//! A matrix of heights as text: one trace per row, without x and labels.

use super::areal::trace::{Areal, HeightUnit, Heights};
use super::dialect::{Cell, Sniffed};
use super::error::ReadFault;
use super::file_dialect::of_file;
use super::format::Format;
use super::found::Found;
use super::grid::SpacingSource;
use super::header::Label;
use super::header_values::HeaderValues;
use super::layout::TableLayout;
use super::options::{Columns, ReadOptions};
use super::text::{Line, Text};
use super::{grid, options, units};
use super::{stated_count, table};
use crate::warning::Warning;

const FORMAT: Format = Format::TextMatrix;

/// Whether a table with these labels is a matrix: as its header says, or with at least as many columns as a profile has
/// points, without names and not requested by `options`.
pub(super) fn is_matrix(labels: &[Label], values: &HeaderValues, options: &ReadOptions) -> bool {
    (labels.len() >= options::FEWEST_POINTS || (labels.len() > 2 && values.is_of_matrix()))
        && options.columns.is_none()
        && labels.iter().all(|label| label.role.is_none())
}

/// Number of columns before the heights: one if the rows start with their numbers, and their other cells are as many as the
/// header states points.
pub(super) fn numbering(header: &[Line<'_>], table: &[Line<'_>], sniffed: &Sniffed) -> usize {
    let stated = stated_count::points(header).map(|(_, points)| points + 1);
    let number = |line: &Line<'_>| match sniffed
        .dialect
        .cell(sniffed.dialect.cells(line.text).next()?)
    {
        Cell::Number(value) => Some(value),
        _ => None,
    };
    let mut numbered = (1..).zip(table);
    let is_numbered = numbered.all(|(row, line)| number(line) == Some(f64::from(row)));
    usize::from(stated == Some(sniffed.columns) && table.len() > 1 && is_numbered)
}

/// All rows of the matrix that starts at line `first` behind `numbering` columns, in the unit of the file.
pub(super) fn surface(
    text: &mut Text<'_>,
    first: usize,
    head: &[Line<'_>],
    sniffed: &Sniffed,
    numbering: usize,
    header: &HeaderValues,
) -> Result<Areal, ReadFault> {
    let columns = sniffed.columns - numbering;
    let mut values = Vec::new();
    let mut lines = text.lines()?;
    while let Some(line) = lines.next()? {
        if line.number >= first && !line.is_blank() {
            match cells(head, sniffed, &line) {
                Ok(heights) => values.extend(&heights[numbering..]),
                Err(fault) => {
                    let (number, text) = (line.number, line.text.to_owned());
                    return Err(of_file(fault, (number, &text), &mut lines, sniffed)?);
                }
            }
        }
    }
    grid::unmark(&mut values);
    let unit = header.unit()?;
    if let Some(unit) = unit {
        values.iter_mut().for_each(|z| *z = unit.metres(*z));
    }
    Ok(Areal {
        spacings: header.spacings(columns, values.len() / columns.max(1)),
        unit: match unit {
            Some(_) => HeightUnit::Metres,
            None => HeightUnit::Unstated,
        },
        table: Some((layout(sniffed, numbering), unit)),
        ..Areal::new(FORMAT, Heights::Values { values, columns })
    })
}

/// The heights of a line.
fn cells(head: &[Line<'_>], sniffed: &Sniffed, line: &Line<'_>) -> Result<Vec<f64>, ReadFault> {
    let (columns, dialect) = (sniffed.columns, sniffed.dialect);
    let mut heights = Vec::with_capacity(columns);
    for cell in dialect.cells(line.text) {
        heights.push(match dialect.cell(cell) {
            Cell::Number(value) => value,
            Cell::Missing => f64::NAN,
            Cell::Other => return Err(table::unreadable(head, line, cell, dialect)),
        });
    }
    // A separator at the end of each line creates an empty last cell.
    if heights.len() == columns + 1 && heights[columns].is_nan() {
        heights.pop();
    }
    match heights.len() == columns {
        true => Ok(heights),
        false => Err(table::ragged(line, heights.len(), columns)),
    }
}

/// Dialect, and the first column of heights.
fn layout(sniffed: &Sniffed, numbering: usize) -> TableLayout {
    TableLayout {
        separator: sniffed.dialect.separator,
        decimal: sniffed.dialect.decimal,
        columns: Columns {
            x: None,
            z: 1 + numbering,
        },
    }
}

/// The row requested by `options`, of the matrix that starts at line `first` behind `numbering` columns.
pub(super) fn read(
    text: &mut Text<'_>,
    first: usize,
    head: &[Line<'_>],
    sniffed: &Sniffed,
    numbering: usize,
    header: &HeaderValues,
    options: &ReadOptions,
) -> Result<Found, ReadFault> {
    let columns = sniffed.columns - numbering;
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
        let number = line.number;
        chosen = match cells(head, sniffed, &line) {
            Ok(heights) => Some((number, heights[numbering..].to_vec())),
            Err(fault) => {
                let text = line.text.to_owned();
                return Err(of_file(fault, (number, &text), &mut lines, sniffed)?);
            }
        };
    }
    let Some((_, mut heights)) = chosen else {
        return Err(ReadFault::several_profiles(rows, columns, options.row));
    };
    grid::unmark(&mut heights);
    let stated = match options.z_unit {
        None => header.unit()?,
        stated => stated,
    };
    let z_unit = match stated {
        Some(unit) => unit,
        None => units::of_heights(FORMAT, &heights, options)?,
    };
    let assumed = stated.is_none().then_some(Warning::UnitAssumed {
        axis: options::Axis::Height,
        unit: z_unit,
    });
    let [spacing, _] = header.spacings(columns, rows);
    Ok(Found {
        spacing: spacing.map(|dx| (dx, SpacingSource::Header)),
        warnings: assumed.into_iter().collect(),
        z_unit,
        first_line: None,
        table: Some(layout(sniffed, numbering)),
        ..Found::new(FORMAT, heights)
    })
}
