//! Reading and writing of tables.

use std::io::{BufWriter, Write};
use std::path::Path;

use asperity_storage::{cell, check_finite, text_of_cell, whole_file};
use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::error::{ReportError, TableFault};

/// Largest table in bytes that is read back.
const LARGEST: u64 = 1_000_000_000;

/// Writes `rows` with their header; text that a spreadsheet would take for a formula is marked.
///
/// # Errors
/// When a file cannot be written, a number is not finite, or a row cannot be written as CSV.
pub fn write<R: Serialize>(
    file: &Path,
    rows: impl IntoIterator<Item = R>,
) -> Result<(), ReportError> {
    let out = std::fs::File::create(file).map_err(ReportError::io(file))?;
    fill(BufWriter::new(out), file, rows)?;
    Ok(())
}

/// `rows` with their header as text, marked as by [`write()`]; `file` is the name in messages.
///
/// # Errors
/// When a number is not finite, or a row cannot be written as CSV.
pub fn text<R: Serialize>(
    file: &Path,
    rows: impl IntoIterator<Item = R>,
) -> Result<Vec<u8>, ReportError> {
    fill(Vec::new(), file, rows)
}

/// Rows of cells as text, marked as by [`write()`]; `file` is the name in messages.
///
/// # Errors
/// When the rows have different lengths.
pub fn text_of_cells(
    file: &Path,
    rows: impl IntoIterator<Item = Vec<String>>,
) -> Result<Vec<u8>, ReportError> {
    let mut writer = csv::Writer::from_writer(Cells::into(Vec::new()));
    for row in rows {
        writer.write_record(row).map_err(ReportError::csv(file))?;
    }
    finished(writer, file)
}

/// Rows of cells from the text of a table with its header, without the marks of [`write()`].
///
/// # Errors
/// When the text is not a table.
pub fn cells_of_text(table: &[u8]) -> Result<Vec<Vec<String>>, csv::Error> {
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .from_reader(table);
    let text = |cells: csv::StringRecord| {
        cells
            .iter()
            .map(|cell| text_of_cell(cell).to_owned())
            .collect()
    };
    reader.records().map(|row| row.map(text)).collect()
}

fn fill<W: Write, R: Serialize>(
    out: W,
    file: &Path,
    rows: impl IntoIterator<Item = R>,
) -> Result<W, ReportError> {
    let mut writer = csv::Writer::from_writer(Cells::into(out));
    for row in rows {
        check_finite(&row).map_err(ReportError::not_finite(file))?;
        writer.serialize(row).map_err(ReportError::csv(file))?;
    }
    finished(writer, file)
}

fn finished<W: Write>(writer: csv::Writer<Cells<W>>, file: &Path) -> Result<W, ReportError> {
    // Flushes, too.
    let cells = writer
        .into_inner()
        .map_err(|error| ReportError::io(file)(error.into_error()))?;
    Ok(cells.out)
}

/// The cells of a table on their way to `out`: each text that would be a formula is marked ([`cell`]).
struct Cells<W: Write> {
    out: W,
    /// The cell so far, as it is written.
    written: Vec<u8>,
    is_quoted: bool,
}

impl<W: Write> Cells<W> {
    fn into(out: W) -> Self {
        Self {
            out,
            written: Vec::new(),
            is_quoted: false,
        }
    }

    fn end_cell(&mut self) -> std::io::Result<()> {
        let text = String::from_utf8_lossy(&self.written);
        match text.strip_prefix('"') {
            Some(quoted) => write!(self.out, "\"{}", cell(quoted))?,
            None => self.out.write_all(cell(&text).as_bytes())?,
        }
        self.written.clear();
        Ok(())
    }
}

impl<W: Write> Write for Cells<W> {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        for byte in bytes {
            // A quote in a quoted cell is written twice.
            self.is_quoted ^= *byte == b'"';
            if !self.is_quoted && matches!(byte, b',' | b'\n') {
                self.end_cell()?;
                self.out.write_all(&[*byte])?;
            } else {
                self.written.push(*byte);
            }
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> std::io::Result<()> {
        self.out.flush()
    }
}

/// Reads a table of finite numbers.
///
/// # Errors
/// When the file is missing or empty, lacks a column, or has a cell that is not a finite number.
pub fn read<R: Serialize + DeserializeOwned>(file: &Path) -> Result<Vec<R>, ReportError> {
    let bad = |reason| ReportError::BadTable {
        path: file.to_owned(),
        reason,
    };
    let bytes = whole_file(file, LARGEST).map_err(|error| bad(csv::Error::from(error).into()))?;
    let mut reader = csv::Reader::from_reader(bytes.as_slice());
    let rows = reader.deserialize().collect::<Result<Vec<R>, csv::Error>>();
    let rows = rows.map_err(|error| bad(error.into()))?;
    if rows.is_empty() {
        return Err(bad(TableFault::Empty));
    }
    finite(&rows).map_err(bad)?;
    Ok(rows)
}

/// Checks that all numbers of `rows` are finite.
///
/// # Errors
/// Names the first number that is not finite.
pub fn finite<R: Serialize>(rows: &[R]) -> Result<(), TableFault> {
    for (index, row) in rows.iter().enumerate() {
        check_finite(row).map_err(|number| TableFault::NotFinite {
            row: index + 1,
            column: number.path,
        })?;
    }
    Ok(())
}

/// Checks that `rows` form a rectangular field by lines, with one row per \[column, line\].
///
/// # Errors
/// When they do not.
pub fn check_field<R>(rows: &[R], place: impl Fn(&R) -> [f64; 2]) -> Result<(), TableFault> {
    let Some(first) = rows.first().map(&place) else {
        return Ok(());
    };
    let line_of = |row: &R| place(row)[1];
    let across = rows
        .iter()
        .take_while(|row| line_of(row) == first[1])
        .count();
    let is_line = |line: &[R]| {
        line.len() == across
            && line.iter().zip(rows).all(|(row, top)| {
                place(row)[0] == place(top)[0]
                    && line
                        .first()
                        .is_some_and(|first| line_of(first) == line_of(row))
            })
    };
    match across > 0 && rows.chunks(across).all(is_line) {
        true => Ok(()),
        false => Err(TableFault::NotAField),
    }
}
