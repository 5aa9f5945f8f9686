//! Tables of a result in their files.

use std::io::BufWriter;
use std::path::Path;

use asperity_storage::whole_file;
use asperity_table::own::{self, OwnFault};
use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::error::ReportError;

/// Largest table in bytes that is read back.
const LARGEST: u64 = 1_000_000_000;

/// Writes `rows` with their header.
///
/// # Errors
/// When a file cannot be written, a number is not finite, or a row cannot be written as CSV.
pub fn write<R: Serialize>(
    file: &Path,
    rows: impl IntoIterator<Item = R>,
) -> Result<(), ReportError> {
    let out = std::fs::File::create(file).map_err(ReportError::io(file))?;
    own::write(BufWriter::new(out), rows).map_err(ReportError::unwritten(file))?;
    Ok(())
}

/// `rows` with their header as text; `file` is the name in messages.
///
/// # Errors
/// When a number is not finite, or a row cannot be written as CSV.
pub fn text<R: Serialize>(
    file: &Path,
    rows: impl IntoIterator<Item = R>,
) -> Result<Vec<u8>, ReportError> {
    own::write(Vec::new(), rows).map_err(ReportError::unwritten(file))
}

/// Rows of cells as text; `file` is the name in messages.
///
/// # Errors
/// When the rows have different lengths.
pub fn text_of_cells(
    file: &Path,
    rows: impl IntoIterator<Item = Vec<String>>,
) -> Result<Vec<u8>, ReportError> {
    own::text_of_cells(rows).map_err(|error| ReportError::unwritten(file)(error.into()))
}

/// Reads a table of finite numbers.
///
/// # Errors
/// When the file is missing or empty, lacks a column, or has a cell that is not a finite number.
pub fn read<R: Serialize + DeserializeOwned>(file: &Path) -> Result<Vec<R>, ReportError> {
    let bytes = whole_file(file, LARGEST).map_err(|error| OwnFault::Unreadable(error.into()));
    let rows = bytes.and_then(|bytes| own::rows(&bytes));
    rows.map_err(|reason| ReportError::BadTable {
        path: file.to_owned(),
        reason,
    })
}

/// Checks that `rows` form a rectangular field by lines, with one row per \[column, line\].
///
/// # Errors
/// When they do not.
pub fn check_field<R>(rows: &[R], place: impl Fn(&R) -> [f64; 2]) -> Result<(), OwnFault> {
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
        false => Err(OwnFault::NotAField),
    }
}
