//! Reading and writing of tables whose rows are types.

use std::path::Path;

use asperity_storage::{check_finite, whole_file};
use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::error::{ReportError, TableFault};

/// Bytes of the largest table that is read back.
const LARGEST: u64 = 1_000_000_000;

/// Row of a table that is read back.
pub trait Row: Serialize + DeserializeOwned {
    /// Names and values of its numbers.
    fn numbers(&self) -> Vec<(&'static str, f64)>;
}

/// Declares a row type with its columns, all of them numbers.
macro_rules! row {
    ($(#[$doc:meta])* $name:ident { $($(#[$field_doc:meta])* $field:ident),+ $(,)? }) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
        pub struct $name { $($(#[$field_doc])* pub $field: f64),+ }

        impl $crate::tables::csv_table::Row for $name {
            fn numbers(&self) -> Vec<(&'static str, f64)> {
                vec![$((stringify!($field), self.$field)),+]
            }
        }
    };
}
pub(crate) use row;

/// Writes `rows` with their header.
///
/// # Errors
/// When the system refuses, a number is not finite, or a row is no row of CSV.
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

/// `rows` with their header, as text; `file` is the name in messages.
///
/// # Errors
/// When a number is not finite, or a row is no row of CSV.
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

/// Reads a table whose every number must be finite.
///
/// # Errors
/// When the file is missing, empty, lacks a column or holds anything that is not a finite number.
pub fn read<R: Row>(file: &Path) -> Result<Vec<R>, ReportError> {
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

/// Whether every number of `rows` is finite.
///
/// # Errors
/// With the first that is not.
pub fn finite<R: Row>(rows: &[R]) -> Result<(), TableFault> {
    for (index, row) in rows.iter().enumerate() {
        if let Some((column, _)) = row.numbers().into_iter().find(|(_, v)| !v.is_finite()) {
            return Err(TableFault::NotFinite {
                row: index + 1,
                column,
            });
        }
    }
    Ok(())
}

/// Whether `rows` are a field, line by line: at every \[column, line\] of a rectangle there is one row.
///
/// # Errors
/// When they are not.
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
