#![doc = include_str!("../README.md")]

pub mod own;

use std::borrow::Cow;

/// A row that is not valid.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{line}: {column}: {rule}")]
pub struct RowFault {
    /// Its line, from 1.
    pub line: usize,
    /// Its column.
    pub column: Cow<'static, str>,
    /// The value and the rule that it violates.
    pub rule: String,
}

/// A row with another number of cells than the header.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("line {line} has {cells} cells, the header {columns}")]
pub struct Ragged {
    /// Its line, from 1.
    pub line: usize,
    /// Its number of cells.
    pub cells: usize,
    /// The number of columns.
    pub columns: usize,
}

/// A table with a header.
#[derive(Debug, Clone)]
pub struct Table {
    /// The header as it is written.
    heads: csv::StringRecord,
    names: Vec<String>,
    /// Line and cells of every row.
    rows: Vec<(usize, csv::StringRecord)>,
    has_decimal_comma: bool,
}

impl Table {
    /// Reads the table in `text`.
    ///
    /// # Errors
    /// When a row has another number of cells than the header. Empty cells at the end of a row may be left out, and may be more.
    pub fn read(text: &str) -> Result<Self, Ragged> {
        let text = text.trim_start_matches('\u{feff}');
        let is_row = |line: &&str| !line.starts_with('#') && !line.trim().is_empty();
        let header = text.lines().find(is_row).unwrap_or_default();
        let separator = [';', '\t', ',']
            .into_iter()
            .find(|sign| header.contains(*sign))
            .unwrap_or(',');
        let mut reader = csv::ReaderBuilder::new()
            .comment(Some(b'#'))
            .delimiter(separator as u8)
            .trim(csv::Trim::All)
            .flexible(true)
            .has_headers(false)
            .from_reader(text.as_bytes());
        let begins = Lines::new(text);
        // A text can always be split into cells: it is valid UTF-8, and its rows may have any length.
        let records = reader.records().filter_map(Result::ok);
        let is_filled = |record: &csv::StringRecord| record.iter().any(|cell| !cell.is_empty());
        let mut records = records.filter(is_filled).map(|record| {
            let begin = record.position().map_or(0, |place| place.byte() as usize);
            (begins.of(begin), record)
        });
        let header = records.next();
        let names = header
            .iter()
            .flat_map(|(_, record)| record.iter().map(name));
        let mut names: Vec<String> = names.collect();
        let filled = |cells: &mut dyn Iterator<Item = &str>| {
            let last = cells
                .enumerate()
                .filter(|(_, cell)| !cell.is_empty())
                .last();
            last.map_or(0, |(at, _)| at + 1)
        };
        let columns = filled(&mut names.iter().map(String::as_str));
        names.truncate(columns);
        let rows: Vec<(usize, csv::StringRecord)> = records.collect();
        for (line, record) in &rows {
            let cells = filled(&mut record.iter());
            // A row that is cut off has lost cells; one with all its separators may end with empty cells.
            if cells > columns || record.len() < columns {
                return Err(Ragged {
                    line: *line,
                    cells: cells.max(record.len().min(columns)),
                    columns,
                });
            }
        }
        let cells = || rows.iter().flat_map(|(_, record)| record);
        let has_point = cells().any(|cell| cell.contains('.') && number(cell, false).is_some());
        Ok(Self {
            heads: header.map(|(_, record)| record).unwrap_or_default(),
            names,
            rows,
            has_decimal_comma: separator != ',' && !has_point,
        })
    }

    /// The names of the columns as they are written.
    pub fn heads(&self) -> impl Iterator<Item = &str> {
        self.heads.iter().take(self.names.len())
    }

    /// Names of the columns: lower case, a unit in brackets behind `_`.
    #[must_use]
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// Whether there is a column of this name.
    #[must_use]
    pub fn has(&self, column: &str) -> bool {
        self.names.iter().any(|name| name == column)
    }

    /// The rows.
    pub fn rows(&self) -> impl ExactSizeIterator<Item = Row<'_>> {
        self.rows.iter().map(|(line, record)| Row {
            line: *line,
            record,
            table: self,
        })
    }

    /// A value of every row.
    ///
    /// # Errors
    /// The faults of all rows that have none.
    pub fn all<T>(
        &self,
        value: impl Fn(Row<'_>) -> Result<T, RowFault>,
    ) -> Result<Vec<T>, Vec<RowFault>> {
        let (mut values, mut faults) = (Vec::new(), Vec::new());
        for row in self.rows() {
            match value(row) {
                Ok(value) => values.push(value),
                Err(fault) => faults.push(fault),
            }
        }
        match faults.is_empty() {
            true => Ok(values),
            false => Err(faults),
        }
    }
}

/// Row of a table.
#[derive(Debug, Clone, Copy)]
pub struct Row<'a> {
    /// Its line, from 1.
    pub line: usize,
    record: &'a csv::StringRecord,
    table: &'a Table,
}

impl<'a> Row<'a> {
    /// Whether the table has a column of this name.
    #[must_use]
    pub fn has(&self, column: &str) -> bool {
        self.table.has(column)
    }

    fn cell(&self, index: usize) -> Option<&'a str> {
        self.record.get(index).filter(|text| !text.is_empty())
    }

    /// Text of a cell; `None` if it is empty or has no column.
    #[must_use]
    pub fn text(&self, column: &str) -> Option<&'a str> {
        let index = self.table.names.iter().position(|name| name == column);
        self.cell(index?)
    }

    /// Fault of a cell.
    pub fn fault(&self, column: impl Into<Cow<'static, str>>, rule: impl Into<String>) -> RowFault {
        RowFault {
            line: self.line,
            column: column.into(),
            rule: rule.into(),
        }
    }

    /// Number of a cell, which must not be empty.
    ///
    /// # Errors
    /// When the cell is empty or not a finite number.
    pub fn number(&self, column: &str) -> Result<f64, RowFault> {
        let number = self.optional(column)?;
        number.ok_or_else(|| self.fault(column.to_owned(), "is missing"))
    }

    /// Number of a cell; `None` if it is empty or has no column.
    ///
    /// # Errors
    /// When the cell is not a finite number.
    pub fn optional(&self, column: &str) -> Result<Option<f64>, RowFault> {
        let cell = self.text(column);
        cell.map(|cell| self.parsed(column, cell)).transpose()
    }

    /// The numbers of all columns, in their order.
    ///
    /// # Errors
    /// When a cell is empty or not a finite number.
    pub fn numbers(&self) -> Result<Vec<f64>, RowFault> {
        let number = |(index, name): (usize, &String)| match self.cell(index) {
            Some(cell) => self.parsed(name, cell),
            None => Err(self.fault(name.clone(), "is missing")),
        };
        self.table.names.iter().enumerate().map(number).collect()
    }

    fn parsed(&self, column: &str, cell: &str) -> Result<f64, RowFault> {
        let fault = || {
            let rule = format!("{cell:?} is not a finite number");
            self.fault(column.to_owned(), rule)
        };
        number(cell, self.table.has_decimal_comma).ok_or_else(fault)
    }
}

/// The finite number in `cell`.
fn number(cell: &str, has_decimal_comma: bool) -> Option<f64> {
    let plain = match has_decimal_comma {
        true => Cow::Owned(cell.replace(',', ".")),
        false => Cow::Borrowed(cell),
    };
    plain.parse::<f64>().ok().filter(|value| value.is_finite())
}

/// The name of a column: `Speed [km/h]` is `speed_km_h`, `Flank state` is `flank_state`.
fn name(cell: &str) -> String {
    let lower = cell.to_lowercase();
    let Some((quantity, unit)) = lower.split_once(['[', '(']) else {
        return lower.replace(' ', "_");
    };
    let unit = unit.trim_end_matches([']', ')', ' ']);
    let unit = unit
        .replace('%', "percent")
        .replace("1/min", "rpm")
        .replace("n m", "nm")
        .replace("n·m", "nm")
        .replace('°', "");
    let words = format!("{quantity} {unit}");
    let words = words.split(|c: char| !c.is_alphanumeric());
    let name: Vec<&str> = words.filter(|word| !word.is_empty()).collect();
    name.join("_")
}

/// Byte offset and text of every line.
struct Lines<'a>(Vec<(usize, &'a str)>);

impl<'a> Lines<'a> {
    fn new(text: &'a str) -> Self {
        let mut begin = 0;
        let line = |line: &'a str| {
            let here = begin;
            begin += line.len();
            (here, line)
        };
        Self(text.split_inclusive('\n').map(line).collect())
    }

    /// Line number of a row whose reader position is `byte`, possibly at the end of the line before the row or at blank lines.
    fn of(&self, byte: usize) -> usize {
        let before = self.0.partition_point(|(begin, _)| *begin <= byte);
        let first = before.saturating_sub(1);
        let is_ended = |(begin, line): &(usize, &str)| {
            let rest = line.get(byte - begin..);
            rest.is_some_and(|rest| rest.trim().is_empty())
        };
        let first = first + usize::from(self.0.get(first).is_some_and(is_ended));
        let is_row = |(_, line): &&(usize, &str)| !line.trim().is_empty() && !line.starts_with('#');
        let skipped = self.0[first..].iter().take_while(|line| !is_row(line));
        1 + first + skipped.count()
    }
}
