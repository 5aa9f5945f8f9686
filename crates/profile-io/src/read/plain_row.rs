//! Fast reading of plain rows: digits, signs, separators and blanks.
//!
//! Plain rows are read from bytes in a single pass. Other rows (quotes, words for missing heights, characters beyond
//! ASCII, too few or too many columns) are read by [`rows::row`](super::rows::row).

use super::decimal;
use super::dialect::LONGEST_NUMBER;
use super::layout::Dialect;
use super::options::{DecimalSign, Separator};
use super::table::Chosen;
use super::text::TextLines;

/// Role of a column.
#[derive(Clone, Copy, PartialEq)]
enum Use {
    X,
    Z,
    Valid,
    None,
}

/// Layout of plain rows, in bytes.
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

    /// x and height of the first line of `lines`, if it is a plain row, and the remaining lines.
    #[inline]
    pub(super) fn row<'l>(&self, lines: &'l [u8]) -> Option<(f64, f64, &'l [u8])> {
        if let [Use::X, Use::Z] = self.columns[..]
            && let Some(pair) = self.pair(lines)
        {
            return Some(pair);
        }
        let (mut x, mut z, mut valid) = (f64::NAN, f64::NAN, 1.0);
        let mut rest = self.after_blanks(lines);
        for (column, used) in self.columns.iter().enumerate() {
            if column > 0 {
                rest = self.next_cell(rest)?;
            }
            if *used == Use::None {
                rest = self.after_cell(rest)?;
                continue;
            }
            let (value, after) = decimal::prefix(rest, self.point)?;
            if !value.is_finite() || rest.len() - after.len() > LONGEST_NUMBER {
                return None;
            }
            match used {
                Use::X => x = value,
                Use::Z => z = value,
                _ => valid = value,
            }
            rest = after;
        }
        rest = self.after_blanks(rest);
        // Empty cells at the end.
        while let Some(after) = self.after_separator(rest) {
            rest = self.after_blanks(after);
        }
        let height = if valid == 0.0 { f64::NAN } else { z };
        match rest {
            [end, after @ ..] if *end == self.end => Some((x, height, after)),
            _ => None,
        }
    }

    /// x and height of a row with only these and a single separator, as in most files.
    #[inline]
    fn pair<'l>(&self, lines: &'l [u8]) -> Option<(f64, f64, &'l [u8])> {
        let (x, rest) = decimal::prefix(lines, self.point)?;
        let [separator, cell @ ..] = rest else {
            return None;
        };
        let (z, after) = decimal::prefix(cell, self.point)?;
        let longest = (lines.len() - rest.len()).max(cell.len() - after.len());
        let fits = *separator == self.separator && longest <= LONGEST_NUMBER;
        let rest = past_end(after, self.end)?;
        (fits && x.is_finite() && z.is_finite()).then_some((x, z, rest))
    }

    /// Rest after the blanks at the start of `rest`.
    #[inline]
    fn after_blanks<'l>(&self, mut rest: &'l [u8]) -> &'l [u8] {
        while let [byte @ (b' ' | b'\t' | b'\r'), after @ ..] = rest
            && *byte != self.end
            && (*byte != self.separator || self.separator == b' ')
        {
            rest = after;
        }
        rest
    }

    /// Rest after the separator at the start of `rest`; blanks are not separators here.
    #[inline]
    fn after_separator<'l>(&self, rest: &'l [u8]) -> Option<&'l [u8]> {
        match rest {
            [byte, after @ ..] if *byte == self.separator && *byte != b' ' => Some(after),
            _ => None,
        }
    }

    /// The next cell, if `rest` starts with a separator.
    #[inline]
    fn next_cell<'l>(&self, rest: &'l [u8]) -> Option<&'l [u8]> {
        let next = self.after_blanks(rest);
        if self.separator == b' ' {
            let goes_on = next.first().is_some_and(|byte| *byte > b' ');
            return (goes_on && next.len() < rest.len()).then_some(next);
        }
        self.after_separator(next)
            .map(|cell| self.after_blanks(cell))
    }

    /// Rest after an unused cell; `None` for characters beyond ASCII.
    fn after_cell<'l>(&self, rest: &'l [u8]) -> Option<&'l [u8]> {
        let ends = |byte: &u8| *byte == self.separator || !byte.is_ascii_graphic();
        rest.get(rest.iter().position(ends)?..)
    }
}

/// Rest after the line end at the start of `rest`, which may be preceded by a CR.
#[inline]
pub(super) fn past_end(rest: &[u8], end: u8) -> Option<&[u8]> {
    match rest {
        [byte, after @ ..] | [b'\r', byte, after @ ..] if *byte == end => Some(after),
        _ => None,
    }
}

/// Reads buffered lines that contain a single number with a decimal point, at most `most` of them, into `numbers`.
/// Other lines are read one by one, with the same results.
pub(super) fn take_numbers(lines: &mut TextLines<'_, '_>, most: usize, numbers: &mut Vec<f64>) {
    let (count, bytes) = numbers_at_start(lines.at_hand(), lines.end(), most, numbers);
    lines.pass(count, bytes.len());
}

/// Appends the numbers of such lines at the start of `lines`; returns their count and bytes.
pub(super) fn numbers_at_start<'l>(
    lines: &'l [u8],
    end: u8,
    most: usize,
    numbers: &mut Vec<f64>,
) -> (usize, &'l [u8]) {
    let (mut rest, mut count) = (lines, 0);
    while count < most
        && let Some((number, after)) = decimal::prefix(rest, b'.')
        && number.is_finite()
    {
        let Some(after) = past_end(after, end) else {
            break;
        };
        rest = after;
        numbers.push(number);
        count += 1;
    }
    (count, &lines[..lines.len() - rest.len()])
}

#[cfg(test)]
mod tests {
    use super::super::rows::{Words, row};
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
        #![proptest_config(ProptestConfig::with_cases(4_000))]

        #[test]
        fn a_plain_row_reads_as_it_does_cell_by_cell(
            cells in prop::collection::vec("[ \t]{0,2}(-?[0-9]{1,3}([.,][0-9]{0,5})?|[-+0-9.,eE \t\r\"aN°\u{a0}]{0,6})", 1..5),
            between in "[;,\t ]",
            end in prop_oneof![Just("\n"), Just("\r\n"), Just(";\n"), Just("\r")],
            (dialect, chosen) in any_layout(),
        ) {
            let line = cells.join(&between) + end;
            let plain = Plain::new(dialect, chosen, end.as_bytes()[end.len() - 1]);
            let head = Head::from_text(&line);
            let lines: Vec<_> = head.lines().collect();
            if let Some((x, z, [])) = plain.row(line.as_bytes()) {
                let by_cells = row(&lines, &lines[0], dialect, chosen, &mut Words::default());
                let (expected_x, expected_z) = by_cells.map_err(|error| TestCaseError::fail(error.to_string()))?;
                prop_assert_eq!((x.to_bits(), z.to_bits()), (expected_x.to_bits(), expected_z.to_bits()));
            }
        }
    }

    #[test]
    fn numbers_are_taken_up_to_the_first_line_that_is_more_than_one() {
        let take = |lines: &str, most: usize| {
            let mut numbers = vec![];
            let (count, bytes) = numbers_at_start(lines.as_bytes(), b'\n', most, &mut numbers);
            assert_eq!(count, numbers.len());
            (numbers, bytes.len())
        };
        assert_eq!(take("1.5\n-2e-1\r\n3 \n4\n", 9), (vec![1.5, -0.2], 11));
        assert_eq!(take("1\n2\n3\n", 2), (vec![1.0, 2.0], 4));
        for none in [
            "", "1,5\n", "\n1\n", "NaN\n", "1e999\n", "1", "1\r", "1\u{3}\n", "1 2\n",
        ] {
            assert_eq!(take(none, 9), (vec![], 0), "{none:?}");
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
                Some((0.5, -1.25, [].as_slice())),
                "{text:?}"
            );
        }
    }
}
