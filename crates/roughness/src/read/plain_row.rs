//! Rows that are plain: digits, signs and separators, with blanks around them.
//!
//! They are read from bytes, without looking for the end of the line first. What is not plain (quotes, words
//! for missing heights, characters beyond ASCII, too few or too many columns) is left to
//! [`rows::row`](super::rows::row).

use super::decimal;
use super::dialect::{Dialect, LONGEST_NUMBER};
use super::options::{DecimalSign, Separator};
use super::table::Chosen;

/// What a column is read for.
#[derive(Clone, Copy, PartialEq)]
enum Use {
    X,
    Z,
    Valid,
    None,
}

/// How plain rows are written, in bytes.
pub(super) struct Plain {
    columns: Vec<Use>,
    /// Between columns; a blank where any run of blanks and tabs is.
    separator: u8,
    point: u8,
    end: u8,
}

impl Plain {
    pub(super) fn new(dialect: Dialect, chosen: Chosen, end: u8) -> Self {
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

    /// x, height and length in bytes of the line that `lines` starts with, if it is a plain row.
    #[inline]
    pub(super) fn row(&self, lines: &[u8]) -> Option<(f64, f64, usize)> {
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
    use super::super::rows::row;
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
