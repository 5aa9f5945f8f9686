//! The rows of a table as columns of numbers, every cell checked.
//!
//! Most rows are plain: digits, signs and separators. They are taken from the bytes of whole blocks of
//! lines. The first line of a block and every row that is not plain (blanks inside, quotes, words for
//! missing heights, errors) is read cell by cell, which gives the same numbers for plain rows too.

use super::decimal;
use super::dialect::{Cell, Dialect, LONGEST_NUMBER, Sniffed};
use super::error::ReadError;
use super::options::{DecimalSign, Separator};
use super::table::{self, Chosen};
use super::text::{Line, Text};

/// The columns that are read, in the units of the file.
#[derive(Debug, Default, PartialEq)]
pub(super) struct Rows {
    /// When the table has such a column.
    pub x: Option<Vec<f64>>,
    /// NaN where there is no height.
    pub z: Vec<f64>,
}

/// All rows from the line `first` on, or the error for the first cell that does not read.
/// `head` is what an error is explained with.
pub(super) fn read(
    text: &mut Text<'_>,
    first: usize,
    head: &[Line<'_>],
    sniffed: &Sniffed,
    chosen: Chosen,
) -> Result<Rows, ReadError> {
    let file = text.file;
    let plain = Plain::new(sniffed.dialect, chosen, text.line_end());
    let mut rows = Rows {
        x: chosen.x.map(|_| Vec::new()),
        z: Vec::new(),
    };
    let mut lines = text.lines()?;
    while let Some(line) = lines.next()? {
        if line.number < first || line.is_blank() {
            continue;
        }
        let (x, z) = row(file, head, &line, sniffed.dialect, chosen)?;
        rows.push(x, z);
        let (passed, bytes) = plain.take(lines.at_hand(), &mut rows);
        lines.pass(passed, bytes);
    }
    Ok(rows)
}

/// Line number and text of a row of the table that starts at line `first`, by another look at the file.
pub(super) fn place(
    text: &mut Text<'_>,
    first: usize,
    row: usize,
) -> Result<(usize, String), ReadError> {
    let mut before = row;
    let mut lines = text.lines()?;
    while let Some(line) = lines.next()? {
        if line.number < first || line.is_blank() {
            continue;
        }
        if before == 0 {
            return Ok((line.number, table::shortened(line.text)));
        }
        before -= 1;
    }
    // The file has changed since: its first line is as good as any.
    Ok((first, String::new()))
}

impl Rows {
    fn push(&mut self, x: f64, z: f64) {
        if let Some(column) = &mut self.x {
            column.push(x);
        }
        self.z.push(z);
    }
}

/// x and height of any row; x is NaN when there is no column, the height when it is missing.
fn row(
    file: &str,
    head: &[Line<'_>],
    line: &Line<'_>,
    dialect: Dialect,
    chosen: Chosen,
) -> Result<(f64, f64), ReadError> {
    let (mut x_cell, mut z_cell, mut valid_cell) = ("", "", "");
    let (mut count, mut filled) = (0, 0);
    for cell in dialect.cells(line.text) {
        match Some(count) {
            at if at == chosen.x => x_cell = cell,
            at if at == chosen.valid => valid_cell = cell,
            Some(at) if at == chosen.z => z_cell = cell,
            _ => {}
        }
        count += 1;
        if !cell.is_empty() {
            filled = count;
        }
    }
    let unreadable = |cell| table::unreadable(file, head, line, cell, dialect);
    let number = |cell| match dialect.cell(cell) {
        Cell::Number(value) => Ok(value),
        Cell::Missing => Ok(f64::NAN),
        Cell::Other => Err(unreadable(cell)),
    };
    // The cells are read before they are counted: a text line is reported by its text.
    let x = match chosen.x {
        Some(_) => Some(number(x_cell)?),
        None => None,
    };
    let z = number(z_cell)?;
    if count < chosen.count || filled > chosen.count {
        return Err(table::ragged(file, line, count.max(filled), chosen.count));
    }
    // A row without x cannot be placed, so it cannot be a gap to fill either.
    if x.is_some_and(f64::is_nan) {
        return Err(unreadable(x_cell));
    }
    let valid = chosen.valid.is_none() || dialect.cell(valid_cell) != Cell::Number(0.0);
    Ok((x.unwrap_or(f64::NAN), if valid { z } else { f64::NAN }))
}

/// How plain rows are written, in bytes.
struct Plain {
    chosen: Chosen,
    /// Between columns; a blank where any run of blanks and tabs is.
    separator: u8,
    point: u8,
    end: u8,
}

impl Plain {
    fn new(dialect: Dialect, chosen: Chosen, end: u8) -> Self {
        let separator = match dialect.separator {
            Separator::Semicolon => b';',
            Separator::Tab => b'\t',
            Separator::Comma => b',',
            Separator::Blank | Separator::None => b' ',
        };
        let point = match dialect.decimal {
            DecimalSign::Point => b'.',
            DecimalSign::Comma => b',',
        };
        Self {
            chosen,
            separator,
            point,
            end,
        }
    }

    /// Adds the plain rows at the start of `lines` to `rows`; the number of lines and of bytes they take.
    fn take(&self, lines: &[u8], rows: &mut Rows) -> (usize, usize) {
        let (mut passed, mut bytes) = (0, 0);
        while let Some((x, z, used)) = self.row(&lines[bytes..]) {
            rows.push(x, z);
            passed += 1;
            bytes += used;
        }
        (passed, bytes)
    }

    /// x, height and length in bytes of the line that `lines` starts with, if it is a plain row.
    fn row(&self, lines: &[u8]) -> Option<(f64, f64, usize)> {
        let (mut x, mut z, mut valid) = (f64::NAN, f64::NAN, true);
        let mut at = self.after_blanks(lines, 0);
        for column in 0..self.chosen.count {
            if column > 0 {
                at = self.after_separator(lines, at)?;
            }
            let (is_x, is_z) = (self.chosen.x == Some(column), self.chosen.z == column);
            let is_valid = self.chosen.valid == Some(column);
            if is_x || is_z || is_valid {
                let (value, used) = self.number(lines.get(at..)?)?;
                at += used;
                if is_x {
                    x = value;
                } else if is_z {
                    z = value;
                } else {
                    valid = value != 0.0;
                }
            } else {
                // Blanks beyond ASCII are left to the reading cell by cell.
                let ends = |byte: &u8| *byte == self.separator || !byte.is_ascii_graphic();
                at += lines.get(at..)?.iter().position(ends)?;
            }
            at = self.after_blanks(lines, at);
        }
        // Empty cells at the end.
        while lines.get(at) == Some(&self.separator) {
            at = self.after_blanks(lines, at + 1);
        }
        let height = if valid { z } else { f64::NAN };
        (lines.get(at) == Some(&self.end)).then_some((x, height, at + 1))
    }

    fn number(&self, bytes: &[u8]) -> Option<(f64, usize)> {
        let (value, used) = decimal::prefix(bytes, self.point)?;
        let half = self.point == b',' && bytes[used - 1] == b',';
        (value.is_finite() && used <= LONGEST_NUMBER && !half).then_some((value, used))
    }

    /// The place of the first byte from `at` on that is no blank.
    fn after_blanks(&self, lines: &[u8], mut at: usize) -> usize {
        while let Some(byte @ (b' ' | b'\t' | b'\r')) = lines.get(at)
            && *byte != self.end
            && (*byte != self.separator || self.separator == b' ')
        {
            at += 1;
        }
        at
    }

    /// The place of the next cell, when a separator stands at `at` or blanks that separate before it.
    fn after_separator(&self, lines: &[u8], at: usize) -> Option<usize> {
        if self.separator == b' ' {
            let (before, cell) = (lines.get(at.checked_sub(1)?)?, lines.get(at)?);
            return (*before <= b' ' && *cell > b' ').then_some(at);
        }
        (lines.get(at) == Some(&self.separator)).then(|| self.after_blanks(lines, at + 1))
    }
}
