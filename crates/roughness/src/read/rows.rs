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

/// What a column is read for.
#[derive(Clone, Copy, PartialEq)]
enum Use {
    X,
    Z,
    Valid,
    None,
}

/// How plain rows are written, in bytes.
struct Plain {
    columns: Vec<Use>,
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
        let used = |at| match Some(at) {
            column if column == chosen.x => Use::X,
            column if column == chosen.valid => Use::Valid,
            Some(z) if z == chosen.z => Use::Z,
            _ => Use::None,
        };
        Self {
            columns: (0..chosen.count).map(used).collect(),
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
    #[inline]
    fn row(&self, lines: &[u8]) -> Option<(f64, f64, usize)> {
        let (mut x, mut z, mut valid) = (f64::NAN, f64::NAN, 1.0);
        let mut at = self.after_blanks(lines, 0);
        for (column, used) in self.columns.iter().enumerate() {
            if column > 0 {
                at = self.after_separator(lines, at)?;
            }
            if *used == Use::None {
                at = self.after_cell(lines, at)?;
            } else {
                let (value, length) = self.number(lines.get(at..)?)?;
                match used {
                    Use::X => x = value,
                    Use::Z => z = value,
                    _ => valid = value,
                }
                at += length;
            }
            at = self.after_blanks(lines, at);
        }
        // Empty cells at the end.
        while lines.get(at) == Some(&self.separator) {
            at = self.after_blanks(lines, at + 1);
        }
        let height = if valid == 0.0 { f64::NAN } else { z };
        (lines.get(at) == Some(&self.end)).then_some((x, height, at + 1))
    }

    #[inline]
    fn number(&self, bytes: &[u8]) -> Option<(f64, usize)> {
        let (value, used) = decimal::prefix(bytes, self.point)?;
        let half = self.point == b',' && bytes[used - 1] == b',';
        (value.is_finite() && used <= LONGEST_NUMBER && !half).then_some((value, used))
    }

    /// The place after a cell that is not read; blanks beyond ASCII are left to the reading cell by cell.
    fn after_cell(&self, lines: &[u8], at: usize) -> Option<usize> {
        let ends = |byte: &u8| *byte == self.separator || !byte.is_ascii_graphic();
        Some(at + lines.get(at..)?.iter().position(ends)?)
    }

    /// The place of the first byte from `at` on that is no blank.
    #[inline]
    fn after_blanks(&self, lines: &[u8], mut at: usize) -> usize {
        while let Some(byte) = lines.get(at)
            && *byte <= b' '
            && matches!(byte, b' ' | b'\t' | b'\r')
            && *byte != self.end
            && (*byte != self.separator || self.separator == b' ')
        {
            at += 1;
        }
        at
    }

    /// The place of the next cell, when a separator stands at `at` or blanks that separate before it.
    #[inline]
    fn after_separator(&self, lines: &[u8], at: usize) -> Option<usize> {
        if self.separator == b' ' {
            let (before, cell) = (lines.get(at.checked_sub(1)?)?, lines.get(at)?);
            return (*before <= b' ' && *cell > b' ').then_some(at);
        }
        (lines.get(at) == Some(&self.separator)).then(|| self.after_blanks(lines, at + 1))
    }
}

#[cfg(test)]
mod tests {
    use super::super::text::Head;
    use super::*;
    use proptest::prelude::*;

    const SEPARATORS: [Separator; 5] = [
        Separator::Semicolon,
        Separator::Tab,
        Separator::Comma,
        Separator::Blank,
        Separator::None,
    ];

    fn any_layout() -> impl Strategy<Value = (Dialect, Chosen)> {
        let decimal = prop_oneof![Just(DecimalSign::Point), Just(DecimalSign::Comma)];
        let column = prop::option::of(0..3_usize);
        (0..5_usize, decimal, column.clone(), 0..3_usize, column).prop_map(
            |(separator, decimal, x, z, valid)| {
                // A comma is one of the two, never both.
                let separator = SEPARATORS[separator];
                let decimal = match separator {
                    Separator::Comma => DecimalSign::Point,
                    _ => decimal,
                };
                let dialect = Dialect { separator, decimal };
                // Where nothing separates there is one column.
                let several = dialect.separator != Separator::None;
                let z = if several { z } else { 0 };
                let x = x.filter(|at| several && *at != z);
                let valid = valid.filter(|at| several && *at != z && Some(*at) != x);
                let used = [x, valid, Some(z)].into_iter().flatten().max();
                let count = used.map_or(1, |last| last + 1);
                (dialect, Chosen { x, z, valid, count })
            },
        )
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(20_000))]

        #[test]
        fn a_plain_row_reads_as_it_does_cell_by_cell(
            cells in prop::collection::vec("[ \t]{0,2}(-?[0-9]{1,3}([.,][0-9]{0,5})?|[-+0-9.,eE \t\r\"aN°\u{a0}]{0,6})", 1..5),
            between in "[;,\t ]",
            end in prop_oneof![Just("\n"), Just("\r\n"), Just(";\n"), Just("\r")],
            (dialect, chosen) in any_layout(),
        ) {
            let line = cells.join(&between) + end;
            let plain = Plain::new(dialect, chosen, end.as_bytes()[end.len() - 1]);
            let head = Head::of(&line);
            let lines: Vec<_> = head.lines().collect();
            if let Some((x, z, used)) = plain.row(line.as_bytes())
                && used == line.len()
            {
                let by_cells = row("a.csv", &lines, &lines[0], dialect, chosen);
                let (expected_x, expected_z) = by_cells.map_err(|error| TestCaseError::fail(error.to_string()))?;
                prop_assert_eq!((x.to_bits(), z.to_bits()), (expected_x.to_bits(), expected_z.to_bits()));
            }
        }
    }

    #[test]
    fn rows_of_the_usual_dialects_are_plain() {
        for (separator, decimal, text) in [
            (Separator::Semicolon, DecimalSign::Comma, "0,5;-1,25\r\n"),
            (Separator::Comma, DecimalSign::Point, "0.5, -1.25,\n"),
            (Separator::Tab, DecimalSign::Point, "5e-1\t-1.25e+00\n"),
            (Separator::Blank, DecimalSign::Point, "  0.5   -1.25  \n"),
        ] {
            let chosen = Chosen {
                x: Some(0),
                z: 1,
                valid: None,
                count: 2,
            };
            let plain = Plain::new(Dialect { separator, decimal }, chosen, b'\n');
            assert_eq!(
                plain.row(text.as_bytes()),
                Some((0.5, -1.25, text.len())),
                "{text:?}"
            );
        }
    }
}
