//! Choice of the columns of a detected table, and errors of cells and rows.

use super::dialect::{DialectCell, Sniffed, StatedDialect, sniff};
use super::error::{CellRemedy, ReadFault, shortened};
use super::header::{self, Label, Role};
use super::layout::Dialect;
use super::options::{Columns, DecimalSign, ReadOptions, Separator};
use super::text::Line;

/// Columns counted from 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Chosen {
    pub x: Option<usize>,
    pub z: usize,
    /// Column in which 0 marks a missing height.
    pub valid: Option<usize>,
    /// Number of columns of the table.
    pub count: usize,
}

impl Chosen {
    pub(super) fn columns(self) -> Columns {
        Columns {
            x: self.x.map(|x| x + 1),
            z: self.z + 1,
        }
    }
}

/// Most labels of a message.
const SHOWN: usize = 12;

/// Columns of x, height and validity: as stated, as labelled, or the two of a table with two columns.
pub(super) fn choose(
    count: usize,
    labels: &[Label],
    options: &ReadOptions,
) -> Result<Chosen, ReadFault> {
    let unclear = || {
        let texts = labels.iter().map(|label| shortened(&label.text));
        let texts = texts.filter(|text| !text.is_empty()).take(SHOWN);
        ReadFault::columns_unclear(count, &texts.collect::<Vec<_>>())
    };
    let with = |role: Role| {
        let is = |label: &Label| match label.role {
            Some(Role::Roll(_)) => role == Role::X,
            found => found == Some(role),
        };
        labels.iter().position(is)
    };
    let valid = with(Role::Valid);
    if let Some(Columns { x, z }) = options.columns {
        let inside = |column: usize| {
            column
                .checked_sub(1)
                .filter(|at| *at < count)
                .ok_or_else(unclear)
        };
        let (x, z) = (x.map(inside).transpose()?, inside(z)?);
        let valid = valid.filter(|at| *at != z && Some(*at) != x);
        return if x == Some(z) {
            Err(unclear())
        } else {
            Ok(Chosen { x, z, valid, count })
        };
    }
    let free = |at: &usize| !matches!(labels[*at].role, Some(Role::Valid | Role::Index));
    let z = with(Role::Z)
        .or_else(|| with(Role::Y))
        .or_else(|| match (count, with(Role::X)) {
            (1, _) => Some(0),
            (2, Some(x)) => Some(1 - x).filter(free),
            (2, None) => Some(1).filter(free),
            (_, Some(x)) => only_other_length(labels, x).filter(free),
            _ => None,
        });
    let z = z.ok_or_else(unclear)?;
    // A line of conditions above a single column may have the name of a position.
    let x = with(Role::X).filter(|x| *x != z);
    let x = x.or_else(|| (count == 2).then(|| 1 - z).filter(free));
    if x.is_none() && count > 2 && options.dx.is_none() {
        return Err(unclear());
    }
    Ok(Chosen { x, z, valid, count })
}

/// The only other column than `x` whose label states a unit of length.
fn only_other_length(labels: &[Label], x: usize) -> Option<usize> {
    let is_length =
        |at: &usize| *at != x && matches!(labels[*at].unit, Some(header::StatedHeader::Length(_)));
    let mut lengths = (0..labels.len()).filter(is_length);
    lengths.next().filter(|_| lengths.next().is_none())
}

/// Returns an error for a table with a damaged first row, which would be taken for a header and lost, or with thousands
/// separators from a row on.
///
/// All cells of a row start like numbers, unlike the cells of a header; a single number above several columns is a
/// count.
pub(super) fn check_line_above(lines: &[Line<'_>], sniffed: &Sniffed) -> Result<(), ReadFault> {
    let Some(line) = sniffed.first.checked_sub(1).map(|above| &lines[above]) else {
        return Ok(());
    };
    let cells: Vec<&str> = sniffed.dialect.cells(line.text).collect();
    let filled = cells.iter().rposition(|cell| !cell.is_empty());
    let filled = filled.map_or(0, |last| last + 1);
    let cells = &cells[..filled];
    let starts = |cell: &&str| cell.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c));
    if (filled == 1 && sniffed.columns > 1) || !cells.iter().all(starts) {
        return Ok(());
    }
    // From "980 0.5" to "1 000 0.5".
    let below: Vec<&str> = sniffed.dialect.cells(lines[sniffed.first].text).collect();
    let are_digits = |cell: &str| cell.bytes().all(|byte| byte.is_ascii_digit());
    if let [whole, group, ..] = below[..]
        && below.len() == filled + 1
        && group.len() == 3
        && are_digits(group)
        && are_digits(whole)
    {
        let row = &lines[sniffed.first];
        return Err(ReadFault::UnreadableNumber {
            line: row.number,
            text: shortened(row.text),
            dialect: sniffed.dialect,
            remedy: CellRemedy::Thousands,
        });
    }
    let damaged = cells
        .iter()
        .find(|cell| sniffed.dialect.cell(cell) == DialectCell::Other);
    match damaged {
        Some(cell) => Err(unreadable(lines, line, cell, sniffed.dialect)),
        None => Err(ragged(line, filled, sniffed.columns)),
    }
}

/// The error for a row with more or fewer columns than the table.
pub(super) fn ragged(line: &Line<'_>, found: usize, expected: usize) -> ReadFault {
    ReadFault::RaggedRow {
        line: line.number,
        text: shortened(line.text),
        found,
        expected,
    }
}

/// The error for a cell, with the dialect detected without statements of the user.
pub(super) fn unreadable(
    lines: &[Line<'_>],
    line: &Line<'_>,
    cell: &str,
    used: Dialect,
) -> ReadFault {
    let free = sniff(lines, StatedDialect::default()).map_or(used, |found| found.dialect);
    let other = Dialect {
        decimal: match used.decimal {
            DecimalSign::Point => DecimalSign::Comma,
            DecimalSign::Comma => DecimalSign::Point,
        },
        ..used
    };
    let other_decimal = matches!(other.cell(cell), DialectCell::Number(_));
    let (dialect, remedy) = match (other_decimal, other.decimal) {
        (true, DecimalSign::Comma) if free.decimal == DecimalSign::Comma => {
            (free, CellRemedy::Decimal(DecimalSign::Comma))
        }
        (true, DecimalSign::Point) if free.decimal == DecimalSign::Point => {
            (free, CellRemedy::Decimal(DecimalSign::Point))
        }
        _ if free.separator != used.separator => (free, CellRemedy::Separator),
        _ if used.may_be_grouped(cell) => (used, CellRemedy::Thousands),
        _ => (free, CellRemedy::Line),
    };
    ReadFault::UnreadableNumber {
        line: line.number,
        text: shortened(cell),
        dialect,
        remedy,
    }
}

/// Returns an error for tables like "0,0005,0,2796", where commas may be separators and decimal signs.
pub(super) fn check_commas(table: &[Line<'_>], sniffed: &Sniffed) -> Result<(), ReadFault> {
    let suspicious = sniffed.dialect.separator == Separator::Comma
        && sniffed.columns >= 4
        && sniffed.columns.is_multiple_of(2)
        && !table.iter().any(|line| line.text.contains('.'));
    match table.first() {
        Some(line) if suspicious => Err(ReadFault::ambiguous_comma(
            line.number,
            &shortened(line.text),
        )),
        _ => Ok(()),
    }
}
