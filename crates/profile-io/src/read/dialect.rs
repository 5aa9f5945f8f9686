//! Detection of separators, decimal sign and first row of a table.
//!
//! Every dialect is tried on a sample of lines from the head of the file; the one with the most rows of numbers is
//! chosen. Two dialects can have the same number of rows only if a comma may be either sign; then the first column of
//! the right one increases.

use super::decimal;
use super::layout::Dialect;
use super::options::{Columns, DecimalSign, Separator};
use super::text::Line;

/// A detected dialect.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Sniffed {
    pub dialect: Dialect,
    /// Number of columns of most rows.
    pub columns: usize,
    /// Index of the first line of the table; earlier lines are the header.
    pub first: usize,
    /// Number of rows of numbers in the sample.
    score: usize,
}

/// Possible dialects. Of two with the same rows the earlier one is chosen: a tab before blanks, a point before a comma
/// for rows of whole numbers.
const CANDIDATES: [(Separator, DecimalSign); 9] = [
    (Separator::Semicolon, DecimalSign::Point),
    (Separator::Semicolon, DecimalSign::Comma),
    (Separator::Tab, DecimalSign::Point),
    (Separator::Tab, DecimalSign::Comma),
    (Separator::Comma, DecimalSign::Point),
    (Separator::Blank, DecimalSign::Point),
    (Separator::Blank, DecimalSign::Comma),
    (Separator::None, DecimalSign::Point),
    (Separator::None, DecimalSign::Comma),
];

/// Marks of instruments and programs for a missing height, in every format of text.
const MISSING: &[&str] = &[
    "nan",
    "-nan",
    "nan(ind)",
    "-nan(ind)",
    "1.#qnan",
    "-1.#ind",
    "inf",
    "-inf",
    "+inf",
    "infinity",
    "-infinity",
    "bad",
    "na",
    "n/a",
    "n.a.",
    "null",
    "none",
    "-",
    "--",
    "---",
    "*",
    "**",
    "***",
    "*****",
    "#n/a",
    "void",
    "no data",
    "no_data",
    "nodata",
    "no value",
    "missing",
    "invalid",
    "masked",
    "undefined",
    "ungültig",
    "fehlt",
    "",
];

/// Length of the longest of them.
const LONGEST_MISSING: usize = 9;

/// Maximum length of a number in characters.
pub(super) const LONGEST_NUMBER: usize = 64;
/// Least number of numbers of a row with a word.
const FEWEST_AMONG_WORDS: usize = 8;
/// Maximum number of columns; profiles have two to some dozens.
const MOST_COLUMNS: usize = 1 << 16;

/// Content of a cell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum DialectCell {
    Number(f64),
    Missing,
    Other,
}

impl Dialect {
    /// The trimmed cells of a line, including empty ones at its end, which may be missing heights.
    pub(super) fn cells(self, line: &str) -> impl Iterator<Item = &str> {
        let mut rest = Some(line);
        std::iter::from_fn(move || {
            let text = rest?;
            if self.separator == Separator::Blank {
                let text = text.trim_start();
                let end = match text {
                    "" => return None,
                    _ => end_of_word(text),
                };
                rest = Some(&text[end..]);
                return Some(trim_cell(&text[..end]));
            }
            let cut = sign(self.separator).and_then(|sign| {
                let quoted = end_of_quotes(text);
                Some(quoted + text[quoted..].find(sign)?)
            });
            rest = cut.map(|at| &text[at + 1..]);
            Some(trim_cell(&text[..cut.unwrap_or(text.len())]))
        })
    }

    /// The cells of a line, of which the words of a mark of several words, between blanks, are one.
    pub(super) fn joined(self, line: &str) -> impl Iterator<Item = &str> {
        let mut before = None;
        self.cells(line).filter(move |cell| {
            let word = is_word(cell) && self.cell(cell) == DialectCell::Other;
            let word = (word && self.separator == Separator::Blank).then_some(*cell);
            let goes_on = word.is_some() && before.is_some() && word != before;
            before = word;
            !goes_on
        })
    }

    /// Content of `cell`; a number must be written in digits with this dialect's decimal sign.
    pub(super) fn cell(self, cell: &str) -> DialectCell {
        match self.number(cell) {
            Some(value) if value.is_finite() => DialectCell::Number(value),
            Some(_) => DialectCell::Missing,
            None if is_missing(cell) => DialectCell::Missing,
            None => DialectCell::Other,
        }
    }

    fn number(self, cell: &str) -> Option<f64> {
        if cell.len() > LONGEST_NUMBER {
            return None;
        }
        let plain = match (self.decimal, cell.strip_prefix('−')) {
            (DecimalSign::Point, None) => decimal::whole(cell, b'.'),
            (DecimalSign::Point, Some(rest)) => decimal::whole(rest, b'.').map(|value| -value),
            (DecimalSign::Comma, _) => decimal::whole(cell, b','),
        };
        plain.or_else(|| self.grouped(cell).filter(|(_, certain)| *certain)?.0)
    }

    /// Whether a cell is a number with thousands separators, or another one with three decimals.
    pub(super) fn may_be_grouped(self, cell: &str) -> bool {
        self.grouped(cell).is_some()
    }

    /// The number in a cell with thousands separators, and whether it can be no other: it has decimals or several separators, or
    /// a separator that is not a decimal sign.
    fn grouped(self, cell: &str) -> Option<(Option<f64>, bool)> {
        const SEPARATORS: [char; 7] = [',', '.', '\'', '’', ' ', '\u{a0}', '\u{202f}'];
        let point = match self.decimal {
            DecimalSign::Point => '.',
            DecimalSign::Comma => ',',
        };
        let is_separator = |c: &char| SEPARATORS.contains(c) && *c != point;
        let separator = cell.chars().find(is_separator)?;
        let (whole, decimals) = cell.split_once(point).unwrap_or((cell, ""));
        let mut groups = whole.split(separator);
        let first = groups.next()?.trim_start_matches(['+', '-']);
        let are_digits = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
        let fits = matches!(first.len(), 1..=3)
            && !first.starts_with('0')
            && are_digits(first)
            && are_digits(decimals)
            && groups
                .clone()
                .all(|group| group.len() == 3 && are_digits(group));
        let certain =
            !decimals.is_empty() || groups.count() > 1 || ![',', '.'].contains(&separator);
        let plain = cell.replace(separator, "").replace(point, ".");
        fits.then(|| (decimal::whole(&plain, b'.'), certain))
    }

    /// Number of columns if the line is a row of numbers; if `columns` is stated, these must be numbers.
    fn row(self, line: &str, columns: Option<Columns>) -> Option<usize> {
        let mut cells = self.cells(line).take(MOST_COLUMNS);
        if let Some(Columns { x, z }) = columns {
            let cells: Vec<&str> = cells.collect();
            let filled = cells.iter().rposition(|cell| !cell.is_empty())? + 1;
            let is_number = |column: usize| {
                let cell = cells.get(column.checked_sub(1)?)?;
                (self.cell(cell) != DialectCell::Other).then_some(())
            };
            is_number(z)?;
            if let Some(x) = x {
                is_number(x)?;
            }
            return Some(filled);
        }
        // Lines are tried in all dialects: most end at their first cell.
        let (mut numbers, mut words, mut filled, mut count) = (0, 0, 0, 0);
        cells.try_for_each(|cell| {
            count += 1;
            if cell.is_empty() {
                return Some(());
            }
            filled = count;
            match self.cell(cell) {
                DialectCell::Number(_) => numbers += 1,
                DialectCell::Missing => {}
                // The first cell of a row may be its name.
                DialectCell::Other if is_word(cell) && count > 1 => words += 1,
                DialectCell::Other => return None,
            }
            Some(())
        })?;
        // Words among many numbers are marks of missing heights.
        let least = if words == 0 {
            1
        } else {
            FEWEST_AMONG_WORDS.max(4 * words)
        };
        (numbers >= least).then_some(filled)
    }
}

/// End of the quotes at the start of `text`, in which a separator belongs to the cell.
fn end_of_quotes(text: &str) -> usize {
    let start = text.len() - text.trim_start().len();
    let inside = text[start..].strip_prefix('"');
    inside
        .and_then(|inside| inside.find('"'))
        .map_or(0, |length| start + length + 2)
}

/// End of the cell at the start of `text`, between blanks: a word, or a mark for a missing height of several words.
fn end_of_word(text: &str) -> usize {
    let word = text.find(char::is_whitespace).unwrap_or(text.len());
    // Nearly all cells are numbers.
    if !text.starts_with(|c: char| c.is_ascii_alphabetic()) {
        return word;
    }
    let words = MISSING.iter().filter(|mark| mark.contains(' '));
    let is_there = |mark: &&&str| {
        let start = text.get(..mark.len());
        start.is_some_and(|start| start.eq_ignore_ascii_case(mark))
            && text[mark.len()..]
                .chars()
                .next()
                .is_none_or(char::is_whitespace)
    };
    words
        .copied()
        .find(|mark| is_there(&mark))
        .map_or(word, str::len)
}

/// The sign between two cells, if it is one.
fn sign(separator: Separator) -> Option<char> {
    match separator {
        Separator::Semicolon => Some(';'),
        Separator::Tab => Some('\t'),
        Separator::Comma => Some(','),
        Separator::Blank | Separator::None => None,
    }
}

/// Whether `cell` is a mark for a missing height.
pub(super) fn is_missing(cell: &str) -> bool {
    cell.len() <= LONGEST_MISSING && MISSING.iter().any(|mark| mark.eq_ignore_ascii_case(cell))
}

/// Whether `cell` is a word or sign without a digit, which is a mark of a missing height where a height is expected.
pub(super) fn is_word(cell: &str) -> bool {
    const LONGEST: usize = 24;
    cell.len() <= LONGEST && !cell.contains(|c: char| c.is_numeric())
}

fn trim_cell(cell: &str) -> &str {
    let cell = cell.trim();
    let quoted = cell
        .strip_prefix('"')
        .and_then(|rest| rest.strip_suffix('"'));
    quoted.map_or(cell, str::trim)
}

/// Stated parts of the dialect.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct StatedDialect {
    pub separator: Option<Separator>,
    pub decimal: Option<DecimalSign>,
    pub columns: Option<Columns>,
}

/// The dialect with the most rows of numbers; `None` if there are none.
pub(super) fn sniff(lines: &[Line<'_>], stated: StatedDialect) -> Option<Sniffed> {
    let occurs = |sign: char| lines.iter().any(|line| line.text.contains(sign));
    let fits = |(separator, decimal): &(Separator, DecimalSign)| {
        let is_possible = match stated.separator {
            Some(stated) => stated == *separator,
            None => sign(*separator).is_none_or(occurs),
        };
        is_possible && stated.decimal.is_none_or(|d| d == *decimal)
    };
    let mut best: Option<Sniffed> = None;
    for (separator, decimal) in CANDIDATES.into_iter().filter(fits) {
        let dialect = Dialect { separator, decimal };
        let Some(sniffed) = try_dialect(lines, dialect, stated) else {
            continue;
        };
        let better = match &best {
            None => true,
            Some(other) if sniffed.score == other.score => comma_is_decimal(lines, other, dialect),
            Some(other) => sniffed.score > other.score,
        };
        if better {
            best = Some(sniffed);
        }
    }
    best
}

/// Whether rows like "0,27" are a number and not two columns, whose x would not increase.
fn comma_is_decimal(lines: &[Line<'_>], as_columns: &Sniffed, other: Dialect) -> bool {
    if as_columns.dialect.separator != Separator::Comma || other.decimal != DecimalSign::Comma {
        return false;
    }
    let mut last = f64::NEG_INFINITY;
    lines[as_columns.first..].iter().any(|line| {
        let dialect = as_columns.dialect;
        let first = dialect.cells(line.text).next();
        let Some(DialectCell::Number(x)) = first.map(|cell| dialect.cell(cell)) else {
            return false;
        };
        let falls = x <= last;
        last = x;
        falls
    })
}

fn try_dialect(lines: &[Line<'_>], dialect: Dialect, stated: StatedDialect) -> Option<Sniffed> {
    const SAMPLE: usize = 400;
    let step = lines.len().div_ceil(SAMPLE).max(1);
    let widths: Vec<usize> = lines
        .iter()
        .step_by(step)
        .filter_map(|line| dialect.row(line.text, stated.columns))
        .collect();
    let mut counts = std::collections::BTreeMap::new();
    for &width in &widths {
        *counts.entry(width).or_insert(0_usize) += 1;
    }
    let (&columns, &score) = counts
        .iter()
        .max_by_key(|&(width, count)| (*count, *width))?;
    if columns < 2
        && dialect.separator != Separator::None
        && stated.separator != Some(dialect.separator)
    {
        return None;
    }
    let first = first_row(lines, dialect, columns, stated.columns)?;
    let first = first_marked(lines, dialect, columns, first);
    Some(Sniffed {
        dialect,
        columns,
        first,
        score,
    })
}

/// The first row of the usual width that is followed by another one or is the last line.
fn first_row(
    lines: &[Line<'_>],
    dialect: Dialect,
    columns: usize,
    stated: Option<Columns>,
) -> Option<usize> {
    let is_row = |line: &Line<'_>| dialect.row(line.text, stated) == Some(columns);
    // The header of a LabVIEW measurement file (lvm) holds numbers; this line ends it.
    const END_OF_HEADER: &str = "***End_of_Header***";
    let ends = |line: &Line<'_>| line.text.starts_with(END_OF_HEADER);
    let begin = lines.iter().rposition(ends).map_or(0, |at| at + 1);
    let mut previous = false;
    for (at, line) in lines.iter().enumerate().skip(begin) {
        let row = is_row(line);
        if row && previous {
            return Some(at - 1);
        }
        previous = row;
    }
    previous.then(|| lines.len() - 1)
}

/// The first of the rows above the row `first` in which a word that occurs again is instead of a number.
fn first_marked(lines: &[Line<'_>], dialect: Dialect, columns: usize, first: usize) -> usize {
    let occurs_again = |word: &&str| {
        let cells = lines.iter().flat_map(|line| dialect.cells(line.text));
        cells.filter(|cell| cell == word).nth(1).is_some()
    };
    let is_marked = |line: &&Line<'_>| {
        let cells: Vec<&str> = dialect.joined(line.text).collect();
        let (others, numbers): (Vec<&str>, Vec<&str>) = cells
            .iter()
            .filter(|cell| dialect.cell(cell) != DialectCell::Missing)
            .partition(|cell| dialect.cell(cell) == DialectCell::Other);
        cells.len() == columns
            && !numbers.is_empty()
            && others
                .iter()
                .all(|cell| is_word(cell) && occurs_again(cell))
    };
    let above = lines[..first].iter().rev();
    first - above.take_while(is_marked).count()
}

#[cfg(test)]
mod tests {
    use super::super::text::Head;
    use super::*;

    fn sniff_text(text: &str) -> Option<(Dialect, usize, usize)> {
        let head = Head::from_text(text);
        let lines: Vec<_> = head.lines().collect();
        sniff(&lines, StatedDialect::default()).map(|s| (s.dialect, s.columns, s.first))
    }

    #[test]
    fn each_dialect_is_told_from_the_others() {
        use DecimalSign::{Comma as C, Point as P};
        for (text, separator, decimal, columns) in [
            ("0;1\n1;2", Separator::Semicolon, P, 2),
            ("0,5;1,2\n0,6;1,3", Separator::Semicolon, C, 2),
            ("0.5\t1.2\n0.6\t1.3", Separator::Tab, P, 2),
            ("0,5\t1,2\n0,6\t1,3", Separator::Tab, C, 2),
            ("0.5,1.2\n0.6,1.3", Separator::Comma, P, 2),
            ("0.5, 1.2,\n0.6, 1.3,", Separator::Comma, P, 2),
            ("0.5  1.2   \n0.6  1.3  ", Separator::Blank, P, 2),
            ("0,5 1,2\n0,6 1,3", Separator::Blank, C, 2),
            ("0.5\n0.6", Separator::None, P, 1),
            ("0,5\n0,6", Separator::None, C, 1),
            ("1,5\n2,6\n3,1", Separator::Comma, P, 2),
        ] {
            let dialect = Dialect { separator, decimal };
            assert_eq!(sniff_text(text), Some((dialect, columns, 0)), "{text:?}");
        }
        assert_eq!(
            sniff_text("x in um;z\n0,5;1,2\n0,6;NaN").map(|s| s.2),
            Some(1)
        );
        assert_eq!(sniff_text("no numbers\nat all"), None);
        let lvm = "X0\t0.0\t0.0\nDelta_X\t1.0\t1.0\n***End_of_Header***\t\t\nX\tA\tB\n0.0\t1.0\t2.0\n0.1\t1.1\t2.1";
        assert_eq!(sniff_text(lvm).map(|s| s.2), Some(4));
    }

    #[test]
    fn numbers_are_digits_and_missing_heights_are_words() {
        let point = Dialect {
            separator: Separator::Tab,
            decimal: DecimalSign::Point,
        };
        let comma = Dialect {
            decimal: DecimalSign::Comma,
            ..point
        };
        assert_eq!(point.cell("-1.5e-3"), DialectCell::Number(-1.5e-3));
        assert_eq!(point.cell("−1.5"), DialectCell::Number(-1.5));
        assert_eq!(comma.cell("-0,5"), DialectCell::Number(-0.5));
        assert_eq!(comma.cell("1,234,5"), DialectCell::Other);
        assert_eq!(point.cell("0,5"), DialectCell::Other);
        for missing in MISSING.iter().chain(&["NaN", "Bad", "1e999"]) {
            assert_eq!(point.cell(missing), DialectCell::Missing, "{missing}");
        }
        // Thousands separators, where they can be nothing else.
        for (dialect, number, value) in [
            (point, "1,234.5", 1234.5),
            (point, "-12,345,678", -12_345_678.0),
            (point, "1'234", 1234.0),
            (point, "1\u{2019}234.25", 1234.25),
            (comma, "1.234,5", 1234.5),
            (comma, "1 234,5", 1234.5),
            (comma, "1\u{a0}234\u{a0}567", 1_234_567.0),
            (comma, "1\u{202f}234,5", 1234.5),
        ] {
            assert_eq!(dialect.cell(number), DialectCell::Number(value), "{number}");
        }
        for (dialect, doubtful) in [(point, "1,234"), (comma, "1.234")] {
            assert_eq!(dialect.cell(doubtful), DialectCell::Other);
            assert!(dialect.may_be_grouped(doubtful));
        }
        for other in [
            "0,234.5",
            "1,23.5",
            "12,3456.0",
            "1,234.5e3",
            ",234.5",
            "1,,234.5",
        ] {
            assert_eq!(point.cell(other), DialectCell::Other, "{other}");
        }
    }
}
