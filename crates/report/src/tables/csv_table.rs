//! Reading and writing of typed tables.

use std::path::Path;

use asperity_storage::{check_finite, whole_file};
use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::error::{ReportError, TableFault};

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
    fill(
        csv::Writer::from_path(file).map_err(ReportError::csv(file))?,
        file,
        rows,
    )?;
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
    let writer = fill(csv::Writer::from_writer(Vec::new()), file, rows)?;
    writer
        .into_inner()
        .map_err(|error| ReportError::io(file)(error.into_error()))
}

fn fill<W: std::io::Write, R: Serialize>(
    mut writer: csv::Writer<W>,
    file: &Path,
    rows: impl IntoIterator<Item = R>,
) -> Result<csv::Writer<W>, ReportError> {
    for row in rows {
        check_finite(&row).map_err(ReportError::not_finite(file))?;
        writer.serialize(row).map_err(ReportError::csv(file))?;
    }
    writer.flush().map_err(ReportError::io(file))?;
    Ok(writer)
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
