//! Faults of rows that belong to the file, distinguished from a single wrong line by the following rows.

use asperity_core::RepeatedFault;

use super::damage::{height, not_a_number};
use super::dialect::{DialectCell, Sniffed, is_word};
use super::error::{CellRemedy, ReadFault};
use super::format::Format;
use super::layout::Dialect;
use super::options::LengthUnit;
use super::seems::FileDialect;
use super::text::TextLines;

/// A faulty row, as its fault is compared with others.
#[derive(PartialEq)]
enum DialectKind {
    /// The cell of this column is not a number.
    Cell(usize),
    /// The row has this number of cells.
    Width(usize),
}

/// The fault at the line `number` with `text`, together with the like faults of the `lines` after it: ten or more, or several
/// lines in a row without a row of the table, are a fault of the file.
pub(super) fn of_file(
    fault: ReadFault,
    number: usize,
    text: &str,
    lines: &mut TextLines<'_, '_>,
    sniffed: &Sniffed,
) -> Result<ReadFault, ReadFault> {
    let dialect = sniffed.dialect;
    let Some((kind, cell)) = kind(&fault, text, sniffed) else {
        return Ok(fault);
    };
    let mut faults = RepeatedFault::default();
    faults.add(number, text);
    let mut marks = Marks::from_cell(cell);
    let is_number = |cell: &str| matches!(dialect.cell(cell), DialectCell::Number(_));
    let is_text = !dialect.cells(text).any(is_number);
    // A shorter line that begins with a word is the head of another table, not a row with a fault.
    let begins_with_word = dialect.cells(text).next().is_some_and(|cell| {
        is_word(cell) && dialect.cells(text).count() < sniffed.columns && !is_number(cell)
    });
    // Lines at the fault that are no rows, and whether rows follow them.
    let (mut block, mut follows) = (1, false);
    while let Some(line) = lines.next()? {
        if line.is_blank() {
            continue;
        }
        let cells: Vec<&str> = dialect.cells(line.text).collect();
        let is_height = |cell: &&str| dialect.cell(cell) != DialectCell::Other || is_word(cell);
        let is_row = cells.len() == sniffed.columns
            && cells.iter().any(|cell| is_number(cell))
            && cells.iter().all(is_height);
        match is_row {
            true => follows = true,
            false if !follows => block += 1,
            false => {}
        }
        let like = match kind {
            DialectKind::Cell(at) => cells
                .get(at)
                .filter(|cell| dialect.cell(cell) == DialectCell::Other),
            DialectKind::Width(width) => cells.first().filter(|_| cells.len() == width),
        };
        if let Some(cell) = like {
            faults.add(line.number, line.text);
            marks.add(cell);
        }
    }
    /// Lines of a header between two tables.
    const HEADER: usize = 2;
    let seems = match (&kind, &fault) {
        _ if follows && begins_with_word => FileDialect::Tables,
        (kind, _)
            if follows && block >= HEADER && (is_text || matches!(kind, DialectKind::Width(_))) =>
        {
            FileDialect::Tables
        }
        _ if !faults.is_dialect() => return Ok(fault),
        (DialectKind::Width(_), _) if !follows => FileDialect::Tables,
        (DialectKind::Width(_), _) => FileDialect::Ragged,
        (
            _,
            ReadFault::UnreadableNumber {
                remedy: CellRemedy::Decimal(_) | CellRemedy::Separator,
                ..
            },
        ) => FileDialect::Sign,
        (
            _,
            ReadFault::UnreadableNumber {
                remedy: CellRemedy::Thousands,
                ..
            },
        ) => FileDialect::Thousands,
        (DialectKind::Cell(at), _) => marks.seem(*at, text, dialect),
    };
    let remedy = seems.remedy(fault.remedy(), false);
    Ok(fault.of_file(&faults, &seems, remedy))
}

/// The kind of a fault of a row with `text`, and its cell; `None` for other faults.
fn kind<'t>(fault: &ReadFault, text: &'t str, sniffed: &Sniffed) -> Option<(DialectKind, &'t str)> {
    match fault {
        ReadFault::UnreadableNumber { .. } => {
            let is_text = |cell: &str| sniffed.dialect.cell(cell) == DialectCell::Other;
            let mut cells = sniffed.dialect.cells(text).enumerate();
            let (at, cell) = cells.find(|(_, cell)| is_text(cell))?;
            Some((DialectKind::Cell(at), cell))
        }
        ReadFault::RaggedRow { found, .. } => Some((DialectKind::Width(*found), "")),
        _ => None,
    }
}

/// Common text and unit of faulty cells.
struct Marks {
    /// The text of all of them.
    same: Option<String>,
    /// The letters after the number of all of them.
    unit: Option<String>,
}

impl Marks {
    fn from_cell(cell: &str) -> Self {
        Self {
            same: Some(cell.to_owned()),
            unit: unit_after(cell).map(str::to_owned),
        }
    }

    fn add(&mut self, cell: &str) {
        self.same = self.same.take().filter(|text| text == cell);
        let unit = self.unit.take();
        self.unit = unit.filter(|unit| unit_after(cell) == Some(unit));
    }

    /// The content that column `at`, from 0, seems to have.
    fn seem(&self, at: usize, text: &str, dialect: Dialect) -> FileDialect {
        if let Some(unit) = &self.unit {
            return FileDialect::Unit(unit.clone());
        }
        if let Some(mark) = &self.same {
            return FileDialect::Mark(mark.clone());
        }
        let is_number = |cell: &str| matches!(dialect.cell(cell), DialectCell::Number(_));
        let cells = dialect.cells(text).enumerate();
        let mut numbers = cells
            .filter(|(_, cell)| is_number(cell))
            .map(|(at, _)| at + 1);
        FileDialect::Text {
            column: at + 1,
            numbers: numbers.next().zip(numbers.next()).map(|(x, z)| [x, z]),
        }
    }
}

/// The letters after the number at the start of `cell`.
fn unit_after(cell: &str) -> Option<&str> {
    let number = |c: char| c.is_ascii_digit() || "+-.,eE ".contains(c);
    let unit = cell.trim_start_matches(number);
    let has_digit = cell[..cell.len() - unit.len()].contains(|c: char| c.is_ascii_digit());
    (has_digit && !unit.is_empty() && unit.chars().all(|c| c.is_alphabetic() || c == '°'))
        .then_some(unit)
}

/// Heights of an instrument's text that are not numbers, of one kind.
pub(super) struct BadHeights {
    first: ReadFault,
    seems: FileDialect,
    faults: RepeatedFault,
}

impl BadHeights {
    /// The height `field` in the line `number` with `text`.
    pub(super) fn new(format: Format, field: &str, (number, text): (usize, &str)) -> Self {
        let mut faults = RepeatedFault::default();
        faults.add(number, text);
        Self {
            first: not_a_number(format, field),
            seems: seems(field.trim()),
            faults,
        }
    }

    /// Adds the line `number` with `text`, if one of its heights is of this kind.
    pub(super) fn add(&mut self, number: usize, text: &str) {
        let mut fields = std::iter::once(text.trim()).chain(text.split_whitespace());
        if fields.any(|field| height(field).is_none() && seems(field) == self.seems) {
            self.faults.add(number, text);
        }
    }

    /// The fault together with the like ones of the remaining `lines`: ten or more are a fault of the file.
    pub(super) fn in_all(
        mut self,
        lines: &mut TextLines<'_, '_>,
        heights: impl Fn(&str) -> &str,
    ) -> ReadFault {
        loop {
            match lines.next() {
                Ok(Some(line)) => self.add(line.number, heights(line.text)),
                Ok(None) => return self.fault(),
                Err(fault) => return fault,
            }
        }
    }

    /// The fault together with the like ones that were added.
    pub(super) fn fault(self) -> ReadFault {
        if !self.faults.is_dialect() {
            return self.first;
        }
        let remedy = self.seems.remedy(self.first.remedy(), true);
        self.first.of_file(&self.faults, &self.seems, remedy)
    }
}

/// The dialect that a file seems to have if many of its heights are like `field`.
fn seems(field: &str) -> FileDialect {
    let is_unit = || field.parse::<LengthUnit>().is_ok().then_some(field);
    if let Some(unit) = unit_after(field).or_else(is_unit) {
        return FileDialect::Unit(unit.to_owned());
    }
    match height(field.trim_matches([',', ';'])) {
        Some(_) => FileDialect::Sign,
        None => FileDialect::Mark(field.to_owned()),
    }
}
