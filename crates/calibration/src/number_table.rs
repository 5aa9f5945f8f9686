//! Text tables with a header: rows of numbers and words, with the line of each for messages.

use crate::error::{CalibrationError, RowFault};

/// Table of a text file, separated by commas, semicolons (with decimal commas) or tabs.
///
/// The header is not case-sensitive. Lines that begin with `#` are comments.
pub(crate) struct NumberTable {
    /// Names of the columns in lower case.
    pub names: Vec<String>,
    lines: Vec<usize>,
    records: Vec<csv::StringRecord>,
    has_decimal_comma: bool,
}

impl NumberTable {
    /// Reads the table in `text`, named `name` in messages.
    ///
    /// # Errors
    /// When a row has another number of cells than the header.
    pub fn read(name: &str, text: &str) -> Result<Self, CalibrationError> {
        let text = text.trim_start_matches('\u{feff}');
        let header = text
            .lines()
            .find(|line| !line.starts_with('#') && !line.trim().is_empty());
        let header = header.unwrap_or_default();
        let separator = [b';', b'\t', b',']
            .into_iter()
            .find(|sign| header.contains(char::from(*sign)));
        let mut reader = csv::ReaderBuilder::new()
            .comment(Some(b'#'))
            .delimiter(separator.unwrap_or(b','))
            .trim(csv::Trim::All)
            .from_reader(text.as_bytes());
        let unread = |source| CalibrationError::Csv {
            file: name.to_owned(),
            source,
        };
        let names = reader.headers().map_err(unread)?.iter();
        let names = names.map(str::to_lowercase).collect();
        let begins = Lines::new(text);
        let (mut lines, mut records) = (Vec::new(), Vec::new());
        for record in reader.records() {
            let record = record.map_err(unread)?;
            let place = record.position();
            lines.push(place.map_or(0, |place| begins.of(place.byte() as usize)));
            records.push(record);
        }
        Ok(Self {
            names,
            lines,
            records,
            has_decimal_comma: separator == Some(b';'),
        })
    }

    /// Whether there is a column of this name.
    pub fn has(&self, column: &str) -> bool {
        self.names.iter().any(|name| name == column)
    }

    /// The rows.
    pub fn rows(&self) -> impl Iterator<Item = NumberRow<'_>> {
        let rows = self.lines.iter().zip(&self.records);
        rows.map(|(line, record)| NumberRow {
            line: *line,
            record,
            table: self,
        })
    }

    /// A value of every row, or the faults of all rows that have none.
    ///
    /// # Errors
    /// When a row is not valid, or there is no row.
    pub fn all<T>(
        &self,
        name: &str,
        value: impl Fn(NumberRow<'_>) -> Result<T, RowFault>,
    ) -> Result<Vec<T>, CalibrationError> {
        let (mut values, mut faults) = (Vec::new(), Vec::new());
        for row in self.rows() {
            match value(row) {
                Ok(value) => values.push(value),
                Err(fault) => faults.push(fault),
            }
        }
        if !faults.is_empty() {
            return Err(CalibrationError::Rows {
                file: name.to_owned(),
                faults,
            });
        }
        if values.is_empty() {
            return Err(CalibrationError::Column {
                file: name.to_owned(),
                rule: "the table has no rows".to_owned(),
            });
        }
        Ok(values)
    }
}

/// Row of a table.
#[derive(Clone, Copy)]
pub(crate) struct NumberRow<'a> {
    /// Its line, from 1.
    pub line: usize,
    record: &'a csv::StringRecord,
    table: &'a NumberTable,
}

impl NumberRow<'_> {
    /// Whether the table has a column of this name.
    pub fn has(&self, column: &str) -> bool {
        self.table.has(column)
    }

    /// Text of a cell; `None` if it is empty or has no column.
    pub fn text(&self, column: &str) -> Option<String> {
        let index = self.table.names.iter().position(|name| name == column);
        let cell = index.and_then(|k| self.record.get(k));
        cell.filter(|text| !text.is_empty()).map(str::to_owned)
    }

    /// Fault of a cell.
    pub fn fault(&self, column: &'static str, rule: impl Into<String>) -> RowFault {
        RowFault {
            line: self.line,
            column,
            rule: rule.into(),
        }
    }

    /// Number of a cell, which must not be empty.
    ///
    /// # Errors
    /// When the cell is empty or not a finite number.
    pub fn number(&self, column: &'static str) -> Result<f64, RowFault> {
        let number = self.optional(column)?;
        number.ok_or_else(|| self.fault(column, "is missing"))
    }

    /// Number of a cell; `None` if it is empty or has no column.
    ///
    /// # Errors
    /// When the cell is not a finite number.
    pub fn optional(&self, column: &'static str) -> Result<Option<f64>, RowFault> {
        let Some(cell) = self.text(column) else {
            return Ok(None);
        };
        let plain = match self.table.has_decimal_comma {
            true => cell.replace(',', "."),
            false => cell.clone(),
        };
        let value = plain.parse::<f64>().ok().filter(|value| value.is_finite());
        let fault = || self.fault(column, format!("{cell:?} is not a finite number"));
        value.ok_or_else(fault).map(Some)
    }
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

    /// Line number of a row whose reader position is `byte`, possibly at a blank line before the row.
    fn of(&self, byte: usize) -> usize {
        let first = self
            .0
            .partition_point(|(begin, _)| *begin <= byte)
            .saturating_sub(1);
        let is_row = |(_, line): &&(usize, &str)| !line.trim().is_empty() && !line.starts_with('#');
        let skipped = self.0[first..]
            .iter()
            .take_while(|line| !is_row(line))
            .count();
        1 + first + skipped
    }
}
