//! Tables of a result in their files.

use crate::error;
use std::io::BufWriter;
use std::path::Path;

use asperity_core::Fault;
use asperity_storage::whole_file;
use asperity_table::own::{self, OwnFault};
use serde::Serialize;
use serde::de::DeserializeOwned;

/// Largest table in bytes that is read back.
const LARGEST: u64 = 1_000_000_000;

/// Writes `rows` with their header.
///
/// # Errors
/// When a file cannot be written, a number is not finite, or a row cannot be written as CSV.
pub fn write<R: Serialize>(file: &Path, rows: impl IntoIterator<Item = R>) -> Result<(), Fault> {
    let out = std::fs::File::create(file).map_err(error::io(file))?;
    own::write(BufWriter::new(out), rows).map_err(error::unwritten(file))?;
    Ok(())
}

/// `rows` with their header as text; `file` is the name in messages.
///
/// # Errors
/// When a number is not finite, or a row cannot be written as CSV.
pub fn text<R: Serialize>(
    file: &Path,
    rows: impl IntoIterator<Item = R>,
) -> Result<Vec<u8>, Fault> {
    own::write(Vec::new(), rows).map_err(error::unwritten(file))
}

/// Rows of cells as text; `file` is the name in messages.
///
/// # Errors
/// When the rows have different lengths.
pub fn text_of_cells(
    file: &Path,
    rows: impl IntoIterator<Item = Vec<String>>,
) -> Result<Vec<u8>, Fault> {
    own::text_of_cells(rows).map_err(|error| error::unwritten(file)(error.into()))
}

/// Reads a table of finite numbers.
///
/// # Errors
/// When the file is missing or empty, lacks a column, or has a cell that is not a finite number.
pub fn read<R: Serialize + DeserializeOwned>(file: &Path) -> Result<Vec<R>, Fault> {
    let bytes = whole_file(file, LARGEST).map_err(|error| OwnFault::Unreadable(error.into()));
    let rows = bytes.and_then(|bytes| own::rows(&bytes));
    rows.map_err(|reason| error::bad_table(file, reason))
}

/// Checks that `rows` form a rectangular field by lines, with one row per \[column, line\].
///
/// # Errors
/// When they do not.
pub(crate) fn check_field<R>(rows: &[R], place: impl Fn(&R) -> [f64; 2]) -> Result<(), OwnFault> {
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
    if across > 0 && rows.chunks(across).all(is_line) {
        Ok(())
    } else {
        Err(OwnFault::NotAField)
    }
}
