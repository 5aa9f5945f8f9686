//! A matrix of heights as text: one trace per row, without x and labels.

use super::areal::trace::{Areal, ArealHeights};
use super::damage::miscounted;
use super::dialect::{DialectCell, Sniffed, is_word};
use super::error::ReadFault;
use super::file_dialect::of_file;
use super::format::Format;
use super::found::Found;
use super::grid::{self, SpacingSource};
use super::header::{self, Label};
use super::header_values::HeaderValues;
use super::layout::TableLayout;
use super::lengths::Lengths;
use super::options::{self, Axis, Columns, ReadOptions};
use super::text::{Line, TextSource};
use super::{stated_count, table};
use crate::warning::Warning;

const FORMAT: Format = Format::TextMatrix;

/// Whether a table with these labels is a matrix: as its header says, or with at least as many columns as a profile has
/// points, without names or with numbers in them, and not requested by `options`.
pub(super) fn is_matrix(labels: &[Label], values: &HeaderValues, options: &ReadOptions) -> bool {
    (labels.len() >= options::FEWEST_POINTS || values.are_of_matrix(labels.len()))
        && options.columns.is_none()
        && (labels.iter().all(|label| label.role.is_none()) || are_numbered(labels))
}

/// Whether the labels behind the first one are a name with numbers that rise by one: "POS = 0", "POS = 1".
fn are_numbered(labels: &[Label]) -> bool {
    let parts = |label: &Label| {
        let name = label.text.trim_end_matches(|c: char| c.is_ascii_digit());
        let number: u64 = label.text[name.len()..].parse().ok()?;
        Some((name.to_owned(), number))
    };
    let numbered: Option<Vec<_>> = labels.iter().skip(1).map(parts).collect();
    let follows = |pair: &[(String, u64)]| {
        pair[0].0 == pair[1].0 && pair[1].1.checked_sub(1) == Some(pair[0].1)
    };
    numbered.is_some_and(|all| all.len() > 1 && all.windows(2).all(follows))
}

/// A matrix in a file.
pub(super) struct HeightMatrix<'a, 'l> {
    /// Lines of the head.
    head: &'a [Line<'l>],
    /// Number of the first line of the table.
    first: usize,
    sniffed: &'a Sniffed,
    /// Number of columns before the heights.
    numbering: usize,
    values: &'a HeaderValues,
}

impl<'a, 'l> HeightMatrix<'a, 'l> {
    /// The matrix that begins at the line `sniffed.first` of `head`, under a header with `values`.
    pub(super) fn new(
        head: &'a [Line<'l>],
        sniffed: &'a Sniffed,
        labels: &[Label],
        values: &'a HeaderValues,
    ) -> Self {
        let (header, table) = head.split_at(sniffed.first);
        let is_name_of_lines = |label: &Label| !label.text.ends_with(|c: char| c.is_ascii_digit());
        let numbering = if are_numbered(labels) {
            usize::from(labels.first().is_some_and(is_name_of_lines))
        } else {
            numbering(header, table, sniffed)
        };
        Self {
            head,
            first: table.first().map_or(1, |line| line.number),
            sniffed,
            numbering,
            values,
        }
    }

    /// Number of heights of a row.
    fn points(&self) -> usize {
        match self.values.size() {
            Some([columns, _]) if self.is_wrapped() => columns,
            _ => self.sniffed.columns - self.numbering,
        }
    }

    /// Whether the lines are not the rows.
    pub(super) fn is_wrapped(&self) -> bool {
        self.values
            .is_wrapped(self.sniffed.columns - self.numbering)
    }

    /// All rows.
    pub(super) fn surface(
        &self,
        text: &mut TextSource<'_>,
        options: &ReadOptions,
    ) -> Result<Areal, ReadFault> {
        let (columns, (mut values, lines)) = (self.points(), self.rows(text, |_| true, &mut None)?);
        let rows = if self.is_wrapped() {
            values.len() / columns
        } else {
            lines
        };
        if let Some([_, stated]) = self.values.size().filter(|_| self.is_wrapped()) {
            let stated = columns.saturating_mul(stated);
            if values.len() != stated {
                return Err(miscounted(FORMAT, values.len(), stated));
            }
        }
        self.check_rows(rows)?;
        grid::unmark(&mut values);
        let heights = self.lengths(values, options)?;
        let kind = heights.with(());
        let values = heights.into_values();
        let heights = kind.with(ArealHeights::Values { values, columns });
        Ok(Areal {
            spacings: self.spacings(rows),
            warnings: self.fewer()?.into_iter().collect(),
            encoding: Some(text.encoding),
            table: Some(self.layout()),
            ..Areal::from_heights(FORMAT, heights)
        })
    }

    /// The row requested by `options`.
    pub(super) fn read(
        &self,
        text: &mut TextSource<'_>,
        options: &ReadOptions,
    ) -> Result<Found, ReadFault> {
        let mut mark = None;
        let is_wanted = |row| options.row == Some(row);
        let (heights, rows) = self.rows(text, is_wanted, &mut mark)?;
        self.check_rows(rows)?;
        if heights.is_empty() {
            return Err(ReadFault::several_profiles(
                rows,
                self.points(),
                options.row,
            ));
        }
        grid::enough_of_line(self.points(), rows, options.line)?;
        let heights = self.lengths(heights, options)?;
        let [spacing, _] = self.spacings(rows);
        Ok(Found {
            spacing: spacing.map(|dx| (dx, SpacingSource::Header)),
            warnings: self.fewer()?.into_iter().collect(),
            encoding: Some(text.encoding),
            table: Some(self.layout()),
            mark,
            ..Found::new(FORMAT, heights)
        })
    }

    /// The heights with their unit, or in metres if the header has their scale.
    fn lengths(
        &self,
        mut heights: Vec<f64>,
        options: &ReadOptions,
    ) -> Result<Lengths<Vec<f64>>, ReadFault> {
        let Some(scale) = self.values.scale() else {
            let unit = header::unit_of_file(self.values.z_unit.as_ref(), Axis::Height, options)?;
            return Ok(Lengths::Numbers(heights, unit));
        };
        grid::unmark(&mut heights);
        heights.iter_mut().for_each(|height| *height *= scale);
        Ok(Lengths::Metres(heights))
    }

    /// Heights of the rows that `is_wanted`, and the number of all rows; the first word instead of a height is stored.
    fn rows(
        &self,
        text: &mut TextSource<'_>,
        is_wanted: impl Fn(usize) -> bool,
        mark: &mut Option<String>,
    ) -> Result<(Vec<f64>, usize), ReadFault> {
        let (mut heights, mut rows) = (Vec::new(), 0);
        let mut lines = text.lines()?;
        while let Some(line) = lines.next()? {
            if line.number < self.first || line.is_blank() {
                continue;
            }
            rows += 1;
            if !is_wanted(rows) && self.begins_with_number(&line) {
                continue;
            }
            match self.cells(&line, mark) {
                Ok(cells) if is_wanted(rows) => heights.extend(&cells[self.numbering..]),
                Ok(_) => {}
                Err(fault) => {
                    let (number, text) = (line.number, line.text.to_owned());
                    return Err(of_file(fault, number, &text, &mut lines, self.sniffed)?);
                }
            }
        }
        Ok((heights, rows))
    }

    /// Warning of fewer points in a row than the header states; more are an error.
    fn fewer(&self) -> Result<Option<Warning>, ReadFault> {
        stated_count::check(FORMAT, &self.head[..self.sniffed.first], self.points())
    }

    /// Returns an error for more rows than the header states.
    fn check_rows(&self, rows: usize) -> Result<(), ReadFault> {
        let stated = self.values.size().map_or(rows, |[_, stated]| stated);
        if rows > stated {
            Err(miscounted(
                FORMAT,
                rows * self.points(),
                stated * self.points(),
            ))
        } else {
            Ok(())
        }
    }

    /// Whether a line starts as a row.
    fn begins_with_number(&self, line: &Line<'_>) -> bool {
        let dialect = self.sniffed.dialect;
        let first = dialect.cells(line.text).next();
        first.is_some_and(|cell| dialect.cell(cell) != DialectCell::Other)
    }

    /// The heights of a line, in which a word is the mark of a missing one.
    fn cells(&self, line: &Line<'_>, mark: &mut Option<String>) -> Result<Vec<f64>, ReadFault> {
        let (columns, dialect) = (self.sniffed.columns, self.sniffed.dialect);
        let mut heights = Vec::with_capacity(columns);
        for cell in dialect.joined(line.text) {
            heights.push(match dialect.cell(cell) {
                DialectCell::Number(value) => value,
                DialectCell::Missing => f64::NAN,
                DialectCell::Other if is_word(cell) => {
                    mark.get_or_insert_with(|| cell.to_owned());
                    f64::NAN
                }
                DialectCell::Other => {
                    return Err(table::unreadable(self.head, line, cell, dialect));
                }
            });
        }
        // A separator at the end of each line creates an empty last cell.
        if heights.len() == columns + 1 && heights[columns].is_nan() {
            heights.pop();
        }
        if heights.len() == columns || (self.is_wrapped() && heights.len() < columns) {
            Ok(heights)
        } else {
            Err(table::ragged(line, heights.len(), columns))
        }
    }

    /// Spacings of the points of a row and of `rows` rows.
    fn spacings(&self, rows: usize) -> [Option<Lengths<f64>>; 2] {
        let spacings = self.values.spacings(self.points(), rows);
        spacings.map(|step| step.map(Lengths::Metres))
    }

    /// Dialect, and the first column of heights.
    fn layout(&self) -> TableLayout {
        TableLayout {
            separator: self.sniffed.dialect.separator,
            decimal: self.sniffed.dialect.decimal,
            columns: Columns {
                x: None,
                z: 1 + self.numbering,
            },
        }
    }
}

/// Number of columns before the heights: one if the rows start with their numbers, and their other cells are as many as the
/// header states points.
fn numbering(header: &[Line<'_>], table: &[Line<'_>], sniffed: &Sniffed) -> usize {
    let stated = stated_count::points(header).map(|(_, points)| points + 1);
    let number = |line: &Line<'_>| match sniffed
        .dialect
        .cell(sniffed.dialect.cells(line.text).next()?)
    {
        DialectCell::Number(value) => Some(value),
        _ => None,
    };
    let mut numbered = (1..).zip(table);
    let is_numbered = numbered.all(|(row, line)| number(line) == Some(f64::from(row)));
    usize::from(stated == Some(sniffed.columns) && table.len() > 1 && is_numbered)
}
