#![doc = include_str!("../README.md")]

pub mod own;

use std::borrow::Cow;
use std::cell::Cell;

use asperity_core::message::{Warning, columns_not_read};
use asperity_core::{Code, RepeatedFault};
use csv::ReaderBuilder;

/// Rule that a cell with another text than a number violates.
const NO_NUMBER: &str = "is not a finite number";

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
#[error(
    "line {line} has {cells} cells, the header {columns}{}",
    like.as_ref().map_or(String::new(), |like| format!("; {like}; the file seems to hold another table, or its names are not in one line"))
)]
pub struct Ragged {
    /// Its line, from 1.
    pub line: usize,
    /// Its number of cells.
    pub cells: usize,
    /// The number of columns.
    pub columns: usize,
    /// Rows with the same number of cells, if ten or more.
    pub like: Option<RepeatedFault>,
}

/// A table with a header.
#[derive(Debug, Clone)]
pub struct Table {
    /// The header as it is written.
    heads: csv::StringRecord,
    names: Vec<String>,
    /// Whether a cell of each column was read.
    is_read: Vec<Cell<bool>>,
    /// Line and cells of every row.
    rows: Vec<(usize, csv::StringRecord)>,
    has_decimal_comma: bool,
}

impl Table {
    /// Reads the table in `text`.
    ///
    /// Columns are separated by semicolons, tabs, commas or blanks. A title above the names is left out, and units in a line
    /// below the names belong to them.
    ///
    /// # Errors
    /// When a row has another number of cells than the header. Empty cells at the end of a row may be left out, in all rows
    /// or with their separators, and may be more.
    pub fn read(text: &str) -> Result<Self, Ragged> {
        Self::named(text, None)
    }

    /// Reads the table in `text`, whose columns have these `names`: instead of its own, or if it has none. A column named
    /// `-` is left out.
    ///
    /// # Errors
    /// As [`read`](Self::read).
    pub fn named(text: &str, names: Option<&[String]>) -> Result<Self, Ragged> {
        let text = text.trim_start_matches('\u{feff}');
        let separator = separator(text);
        let mut rows = records(text, separator);
        let is_names = |row: &csv::StringRecord| !is_numbers(row);
        if names.is_none()
            && let [(_, title), (_, header), ..] = rows.as_slice()
            && filled(title) == 1
            && filled(header) > 1
            && is_names(title)
            && header.iter().all(|cell| !is_number(cell))
        {
            rows.remove(0);
        }
        let header = match rows.first() {
            Some((_, first)) if names.is_none() || is_names(first) => Some(rows.remove(0).1),
            _ => None,
        };
        let mut heads = match names {
            Some(names) => csv::StringRecord::from(names.to_vec()),
            None => header.unwrap_or_default(),
        };
        if let [(_, units), (_, values), ..] = rows.as_slice()
            && filled(units) > 0
            && !units.iter().any(is_number)
            && values.iter().any(is_number)
            && units.iter().all(is_unit)
        {
            if names.is_none() {
                heads = with_units(&heads, units);
            }
            rows.remove(0);
        }
        let columns = filled(&heads);
        // All of several rows may lack the cells of the last columns, and their separators.
        let widest = rows.iter().map(|(_, row)| row.len()).max();
        let widest = widest.filter(|_| rows.len() > 1).unwrap_or(columns);
        let cells = |row: &csv::StringRecord| filled(row).max(row.len().min(columns));
        let is_ragged =
            |row: &csv::StringRecord| filled(row) > columns || row.len() < columns.min(widest);
        if let Some((line, row)) = rows.iter().find(|(_, row)| is_ragged(row)) {
            let mut like = RepeatedFault::default();
            let same = |other: &csv::StringRecord| is_ragged(other) && cells(other) == cells(row);
            for (line, other) in rows.iter().filter(|(_, other)| same(other)) {
                like.add(*line, &Vec::from_iter(other).join(" "));
            }
            return Err(Ragged {
                line: *line,
                cells: cells(row),
                columns,
                like: Some(like).filter(RepeatedFault::is_dialect),
            });
        }
        let mut names: Vec<String> = heads.iter().map(name).collect();
        names.truncate(columns);
        let cells = || rows.iter().flat_map(|(_, record)| record);
        let has_point = cells().any(|cell| cell.contains('.') && number(cell, false).is_some());
        Ok(Self {
            heads,
            is_read: vec![Cell::new(false); names.len()],
            names,
            rows,
            has_decimal_comma: separator != Some(',') && !has_point,
        })
    }

    /// Whether the first line has names: it is not a row of numbers.
    #[must_use]
    pub fn has_names(&self) -> bool {
        !is_numbers(&self.heads)
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

    /// The warning that names the columns with cells of which none was read, if there are any; `table` says in words which table it
    /// is. Columns named `-` were left out on purpose.
    ///
    /// ```
    /// use asperity_table::Table;
    /// let table = Table::read("time_s,gear,empty,Remark\n0,1,,a\n1,1,,b\n").unwrap();
    /// table.values(|row| row.number("time_s")).unwrap();
    /// let warning = table.unread("trip.csv").unwrap().to_string();
    /// assert_eq!(warning, "W454 columns of trip.csv that are not read: gear, Remark");
    /// ```
    #[must_use]
    pub fn unread(&self, table: &str) -> Option<Warning> {
        let has_cells = |at: usize| {
            let mut cells = self.rows.iter().filter_map(|(_, row)| row.get(at));
            cells.any(|cell| !cell.is_empty())
        };
        let is_unread =
            |at: &usize| self.names[*at] != "-" && !self.is_read[*at].get() && has_cells(*at);
        let head = |at: usize| match self.heads.get(at).unwrap_or_default() {
            "" => format!("number {}", at + 1),
            head => head.to_owned(),
        };
        let unread = (0..self.names.len()).filter(is_unread).map(head);
        let unread: Vec<String> = unread.collect();
        (!unread.is_empty()).then(|| Warning::new(Code::W454, columns_not_read(table, &unread)))
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
        if faults.is_empty() {
            Ok(values)
        } else {
            Err(self.together(faults))
        }
    }

    /// A value of every row.
    ///
    /// # Errors
    /// The fault of the first row that has none.
    pub fn values<T>(
        &self,
        value: impl Fn(Row<'_>) -> Result<T, RowFault>,
    ) -> Result<Vec<T>, RowFault> {
        self.all(value).map_err(|mut faults| faults.swap_remove(0))
    }

    /// The faults; ten or more of one column are a single fault.
    fn together(&self, faults: Vec<RowFault>) -> Vec<RowFault> {
        let mut found: Vec<(RowFault, RepeatedFault)> = Vec::new();
        let mut single = Vec::new();
        for fault in faults {
            let known = found
                .iter()
                .position(|(first, _)| first.column == fault.column);
            let at = known.unwrap_or_else(|| {
                found.push((fault.clone(), RepeatedFault::default()));
                found.len() - 1
            });
            let row = self
                .rows
                .binary_search_by_key(&fault.line, |(line, _)| *line);
            let text = row.map_or(String::new(), |row| {
                Vec::from_iter(&self.rows[row].1).join(" ")
            });
            found[at].1.add(fault.line, &text);
            single.push((at, fault));
        }
        let is_of_file = |at: usize| found[at].1.is_dialect();
        let mut faults: Vec<RowFault> = single
            .into_iter()
            .filter(|(at, _)| !is_of_file(*at))
            .map(|(_, fault)| fault)
            .collect();
        let of_file = found.iter().filter(|(_, like)| like.is_dialect());
        faults.extend(of_file.map(|(first, like)| RowFault {
            rule: format!(
                "{}; {like}; {}",
                first.rule,
                if first.rule.ends_with(NO_NUMBER) {
                    "export the column as numbers alone, without units or words in its cells"
                } else {
                    "the column seems to hold something else, or to have another unit"
                }
            ),
            ..first.clone()
        }));
        faults.sort_by_key(|fault| fault.line);
        faults
    }
}

/// The sign between the columns of the table in `text`; `None` for blanks.
fn separator(text: &str) -> Option<char> {
    /// Lines that are examined: a title, names, units, and rows.
    const LINES: usize = 6;
    let is_row = |line: &&str| !line.starts_with('#') && !line.trim().is_empty();
    let lines: Vec<&str> = text.lines().filter(is_row).take(LINES).collect();
    let last = lines.last().copied().unwrap_or_default();
    let sign = [';', '\t', ',']
        .into_iter()
        .find(|sign| last.contains(*sign));
    let words = last.split_whitespace();
    let is_blank = words.clone().count() > 1 && words.clone().all(is_number);
    match (sign, is_blank) {
        (Some(','), true) if !words.clone().any(|word| word.ends_with(',')) => None,
        (None, true) => None,
        (sign, _) => Some(sign.unwrap_or(',')),
    }
}

/// A reader of cells, with the header as the first row.
fn cells() -> ReaderBuilder {
    let mut reader = ReaderBuilder::new();
    reader.has_headers(false);
    reader
}

/// The rows of the table in `text` that are not empty, with their lines.
fn records(text: &str, separator: Option<char>) -> Vec<(usize, csv::StringRecord)> {
    let Some(separator) = separator else {
        let is_row = |(_, line): &(usize, &str)| !line.starts_with('#') && !line.trim().is_empty();
        let lines = text.lines().enumerate().filter(is_row);
        let record = |(at, line): (usize, &str)| (at + 1, line.split_whitespace().collect());
        return lines.map(record).collect();
    };
    let mut reader = cells()
        .comment(Some(b'#'))
        .delimiter(separator as u8)
        .trim(csv::Trim::All)
        .flexible(true)
        .from_reader(text.as_bytes());
    let begins = RowLines::new(text);
    // A text can always be split into cells: it is valid UTF-8, and its rows may have any length.
    let records = reader.records().filter_map(Result::ok);
    let records = records.filter(|record| filled(record) > 0).map(|record| {
        let begin = record.position().map_or(0, |place| place.byte() as usize);
        (begins.of(begin), record)
    });
    records.collect()
}

/// Number of cells up to the last that is not empty.
fn filled(row: &csv::StringRecord) -> usize {
    let filled = row.iter().enumerate().filter(|(_, cell)| !cell.is_empty());
    filled.last().map_or(0, |(at, _)| at + 1)
}

/// Whether `cell` is a number, with a decimal point or comma.
fn is_number(cell: &str) -> bool {
    number(cell, true).is_some()
}

/// Whether all cells of a row are numbers.
fn is_numbers(row: &csv::StringRecord) -> bool {
    filled(row) > 0 && row.iter().take(filled(row)).all(is_number)
}

/// Whether `cell` is a unit, in brackets or not, or empty.
fn is_unit(cell: &str) -> bool {
    /// Units of measured quantities, in lower case.
    const UNITS: [&str; 39] = [
        "", "-", "%", "s", "sec", "ms", "min", "h", "rpm", "1/min", "u/min", "min-1", "rad/s",
        "nm", "n m", "n*m", "n·m", "n", "kn", "w", "kw", "km/h", "m/s", "mm/s", "mph", "m", "mm",
        "um", "µm", "g", "c", "°c", "degc", "deg", "bar", "pa", "kpa", "mpa", "gpa",
    ];
    let bare = cell.trim_matches(['[', ']', '(', ')']).to_lowercase();
    UNITS.contains(&bare.as_str()) || cell.starts_with(['[', '('])
}

/// The names with the units below them in brackets, those that have none.
fn with_units(heads: &csv::StringRecord, units: &csv::StringRecord) -> csv::StringRecord {
    let unit = |at: usize| units.get(at).filter(|unit| !unit.is_empty());
    let head = |(at, head): (usize, &str)| match unit(at) {
        Some(unit) if !head.contains(['[', '(']) => {
            format!("{head} [{}]", unit.trim_matches(['[', ']', '(', ')']))
        }
        _ => head.to_owned(),
    };
    heads.iter().enumerate().map(head).collect()
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
        self.table.is_read.get(index)?.set(true);
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
            let rule = format!("{cell:?} {NO_NUMBER}");
            self.fault(column.to_owned(), rule)
        };
        number(cell, self.table.has_decimal_comma).ok_or_else(fault)
    }
}

/// The finite number in `cell`.
fn number(cell: &str, has_decimal_comma: bool) -> Option<f64> {
    let plain = if has_decimal_comma {
        Cow::Owned(cell.replace(',', "."))
    } else {
        Cow::Borrowed(cell)
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
struct RowLines<'a>(Vec<(usize, &'a str)>);

impl<'a> RowLines<'a> {
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
