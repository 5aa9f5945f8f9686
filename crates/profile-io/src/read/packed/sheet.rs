//! The sheet of a workbook, and the longest table of numbers in it.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use crate::read::metadata;
use crate::read::options::FEWEST_POINTS;

/// Maximum number of columns of a sheet that are read.
pub(super) const MOST_COLUMNS: usize = 2000;
/// Maximum number of rows of a sheet: that of the programs.
pub(super) const MOST_ROWS: usize = 1 << 20;
/// Maximum number of cells of a sheet.
const MOST_CELLS: usize = 50_000_000;
/// Maximum number of shared texts.
pub(super) const MOST_TEXTS: usize = 100_000;
/// Maximum number of texts of a sheet.
const MOST_LABELS: usize = 5000;
/// A column belongs to a table if it has at least this part of the numbers of its longest column.
const MOSTLY: f64 = 0.9;

/// One sheet: its texts and its numbers, with row and column from 0.
#[derive(Default)]
pub(super) struct Sheet {
    /// Texts in reading order.
    pub labels: Vec<(usize, usize, String)>,
    /// Numbers by column, in the order of the rows.
    columns: BTreeMap<usize, Vec<(usize, f64)>>,
    cells: usize,
}

/// Table of a sheet.
pub(super) struct SheetBlock {
    columns: Vec<usize>,
    /// First row of the table and the row after its last.
    first: usize,
    end: usize,
    /// Number of rows with numbers.
    pub rows: usize,
}

impl Sheet {
    pub(super) fn label(&mut self, row: usize, column: usize, text: &str) {
        let text = text.trim();
        if !text.is_empty() && self.labels.len() < MOST_LABELS {
            self.labels.push((row, column, text.to_owned()));
        }
    }

    pub(super) fn number(&mut self, row: usize, column: usize, value: &str) {
        self.value(row, column, metadata::number(value));
    }

    pub(super) fn value(&mut self, row: usize, column: usize, value: Option<f64>) {
        if let Some(number) = value.filter(|number| number.is_finite())
            && column < MOST_COLUMNS
            && row < MOST_ROWS
        {
            self.cells += 1;
            self.columns.entry(column).or_default().push((row, number));
        }
    }

    /// Whether the sheet has the maximum number of cells.
    pub(super) fn is_full(&self) -> bool {
        self.cells >= MOST_CELLS
    }

    /// All cells as text with tabs, one line a row; `None` if fewer than two rows have two numbers, or there are too many cells.
    pub(super) fn table(&self) -> Option<String> {
        let mut rows: BTreeMap<usize, BTreeMap<usize, String>> = BTreeMap::new();
        for (row, column, label) in &self.labels {
            let label = label.replace(['\t', '\n', '\r', '"'], " ");
            rows.entry(*row).or_default().insert(*column, label);
        }
        for (column, cells) in &self.columns {
            for (row, value) in cells {
                let row = rows.entry(*row).or_default();
                row.insert(*column, value.to_string());
            }
        }
        let has_numbers = |row: &&BTreeMap<_, String>| {
            let numbers = row.values().filter_map(|cell| metadata::number(cell));
            numbers.count() > 1
        };
        let columns = || rows.values().flat_map(BTreeMap::keys).copied();
        let (first, last) = (columns().min()?, columns().max()?);
        let is_table = rows.values().filter(has_numbers).count() > 1;
        let fits = self.labels.len() < MOST_LABELS && rows.len() * (last + 1) <= MOST_CELLS;
        (is_table && fits).then(|| {
            let mut text = String::new();
            let mut line = 0;
            for (row, cells) in &rows {
                text.extend(std::iter::repeat_n('\n', row - line));
                line = *row;
                let mut place = first;
                for (column, cell) in cells {
                    text.extend(std::iter::repeat_n('\t', column - place));
                    place = *column;
                    text.push_str(cell);
                }
                text.extend(std::iter::repeat_n('\t', last - place));
            }
            text + "\n"
        })
    }

    /// The longest columns of numbers; `None` if they are too short for a profile.
    pub(super) fn block(&self) -> Option<SheetBlock> {
        let longest = self.columns.values().map(Vec::len).max()?;
        if longest < FEWEST_POINTS {
            return None;
        }
        let is_long = |cells: &&Vec<_>| cells.len() as f64 >= MOSTLY * longest as f64;
        let long = || self.columns.iter().filter(|(_, cells)| is_long(cells));
        // A number above the table is not its first row: all columns have one there.
        let first = long()
            .filter_map(|(_, cells)| cells.first())
            .map(|cell| cell.0);
        let last = long()
            .filter_map(|(_, cells)| cells.last())
            .map(|cell| cell.0);
        Some(SheetBlock {
            columns: long().map(|(column, _)| *column).collect(),
            first: first.max()?,
            end: last.max()? + 1,
            rows: longest,
        })
    }

    /// The table as text with tabs, one line a row, under the labels above it.
    pub(super) fn text(&self, block: &SheetBlock, units: Option<&str>) -> String {
        let mut above: BTreeMap<usize, BTreeMap<usize, String>> = BTreeMap::new();
        if units.is_none() {
            let labels = self.labels.iter().filter(|(row, ..)| *row < block.first);
            for (row, column, label) in labels {
                let label = label.replace(['\t', '\n', '\r'], " ");
                above.entry(*row).or_default().insert(*column, label);
            }
            for (column, cells) in &self.columns {
                for (row, value) in cells.iter().filter(|(row, _)| *row < block.first) {
                    let line = above.entry(*row).or_default();
                    line.insert(*column, value.to_string());
                }
            }
        }
        let mut lines = vec![String::new(); block.end];
        for (row, cells) in above {
            let label = |column: &usize| cells.get(column).map_or("", String::as_str);
            lines[row] = match row + 1 == block.first {
                true => block
                    .columns
                    .iter()
                    .map(label)
                    .collect::<Vec<_>>()
                    .join("\t"),
                // A name with its value, or a remark.
                false => format!("# {}", cells.into_values().collect::<Vec<_>>().join("\t")),
            };
        }
        let mut cells: Vec<_> = block
            .columns
            .iter()
            .map(|column| self.columns[column].iter().peekable())
            .collect();
        for (row, line) in lines.iter_mut().enumerate().skip(block.first) {
            let mut is_empty = true;
            for (at, column) in cells.iter_mut().enumerate() {
                while column.next_if(|cell| cell.0 < row).is_some() {}
                if at > 0 {
                    line.push('\t');
                }
                if let Some((_, value)) = column.next_if(|cell| cell.0 == row) {
                    // Writing into a string cannot fail.
                    let _ = write!(line, "{value}");
                    is_empty = false;
                }
            }
            if is_empty {
                line.clear();
            }
        }
        let text = lines.join("\n");
        match units {
            // The labels take the place of the row above, or of a line of their own.
            Some(units) if block.first == 0 => format!("{units}\n{text}\n"),
            Some(units) => format!("{units}{text}\n"),
            None => text + "\n",
        }
    }
}
