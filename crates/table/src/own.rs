//! Tables that Asperity wrote itself: one header, decimal points, commas between the cells. They are read as they were written,
//! and nothing is guessed.

use std::io::Write;

use asperity_storage::{NotFinite, cell, check_finite, text_of_cell};
use serde::Serialize;
use serde::de::DeserializeOwned;

/// Fault of a table that was written before.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum OwnFault {
    /// The file cannot be opened or a row cannot be read.
    #[error("{0}")]
    Unreadable(#[from] csv::Error),
    /// The table has no rows.
    #[error("it has no rows")]
    Empty,
    /// A cell is not a finite number.
    #[error("row {row}: {column} is not a finite number")]
    NotFinite {
        /// Row, from 1 below the header.
        row: usize,
        /// Name of the column.
        column: String,
    },
    /// The rows do not form a rectangular field, or the columns differ in length.
    #[error("its rows do not form a field of equally long rows")]
    NotAField,
}

/// Fault of a table that is to be written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Unwritten {
    /// A number is not finite.
    #[error(transparent)]
    NotFinite(#[from] NotFinite),
    /// A row cannot be written as cells, or the system reports an error.
    #[error(transparent)]
    Row(#[from] csv::Error),
}

/// Writes `rows` with their header to `out`; text that a spreadsheet would take for a formula is marked.
///
/// # Errors
/// When a number is not finite, a row cannot be written as cells, or the system reports an error.
pub fn write<W: Write, R: Serialize>(
    mut out: W,
    rows: impl IntoIterator<Item = R>,
) -> Result<W, Unwritten> {
    let mut writer = csv::Writer::from_writer(OwnCells::into(&mut out));
    for row in rows {
        write_row(&mut writer, &row)?;
    }
    finished(writer)?;
    Ok(out)
}

/// Writes a row, not generic: a generic one is compiled for every type of row, for the check, the header and the cells.
fn write_row(
    writer: &mut csv::Writer<OwnCells<'_>>,
    row: &dyn erased_serde::Serialize,
) -> Result<(), Unwritten> {
    check_finite(row)?;
    writer.serialize(row)?;
    Ok(())
}

/// Rows of cells as text, marked as by [`write()`].
///
/// # Errors
/// When the rows have different lengths.
pub fn text_of_cells(rows: impl IntoIterator<Item = Vec<String>>) -> Result<Vec<u8>, csv::Error> {
    let mut text = Vec::new();
    let mut writer = csv::Writer::from_writer(OwnCells::into(&mut text));
    for row in rows {
        writer.write_record(row)?;
    }
    finished(writer)?;
    Ok(text)
}

/// Rows of cells from the text of a table, its header first, without the marks of [`write()`].
///
/// # Errors
/// When the text is not a table.
pub fn cells(table: &[u8]) -> Result<Vec<Vec<String>>, csv::Error> {
    let text = |cells: csv::StringRecord| {
        let texts = cells.iter().map(|cell| text_of_cell(cell).to_owned());
        texts.collect()
    };
    let mut reader = crate::cells().from_reader(table);
    reader.records().map(|row| row.map(text)).collect()
}

/// The rows of a table of finite numbers.
///
/// ```
/// use serde::{Deserialize, Serialize};
///
/// #[derive(Serialize, Deserialize, PartialEq, Debug)]
/// struct Point {
///     x_mm: f64,
///     height_um: f64,
/// }
/// let point = Point { x_mm: 0.5, height_um: -0.25 };
/// let text = asperity_table::own::write(Vec::new(), [&point])?;
/// assert_eq!(text, b"x_mm,height_um\n0.5,-0.25\n");
/// assert_eq!(asperity_table::own::rows::<Point>(&text)?, [point]);
/// assert!(asperity_table::own::rows::<Point>(b"x_mm;height_um\n0,5;-0,25\n").is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// When the table is empty, lacks a column, or has a cell that is not a finite number.
pub fn rows<R: Serialize + DeserializeOwned>(table: &[u8]) -> Result<Vec<R>, OwnFault> {
    let mut reader = crate::cells().from_reader(table);
    let mut records = reader.records();
    let header = records.next().transpose()?.unwrap_or_default();
    let row = |record: Result<csv::StringRecord, csv::Error>| record?.deserialize(Some(&header));
    let rows = records.map(row).collect::<Result<Vec<R>, csv::Error>>()?;
    if rows.is_empty() {
        Err(OwnFault::Empty)
    } else {
        finite(&rows).map(|()| rows)
    }
}

/// Checks that all numbers of `rows` are finite.
///
/// # Errors
/// Names the first number that is not finite.
pub fn finite<R: Serialize>(rows: &[R]) -> Result<(), OwnFault> {
    for (index, row) in rows.iter().enumerate() {
        check_finite(row).map_err(|number| OwnFault::NotFinite {
            row: index + 1,
            column: number.path,
        })?;
    }
    Ok(())
}

fn finished(writer: csv::Writer<OwnCells<'_>>) -> Result<(), csv::Error> {
    // Flushes, too.
    writer.into_inner().map_err(|error| error.into_error())?;
    Ok(())
}

/// The cells of a table on their way to `out`: each text that would be a formula is marked ([`cell`]).
struct OwnCells<'a> {
    out: &'a mut dyn Write,
    /// The cell so far, as it is written.
    written: Vec<u8>,
    is_quoted: bool,
}

impl<'a> OwnCells<'a> {
    fn into(out: &'a mut dyn Write) -> Self {
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

impl Write for OwnCells<'_> {
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
