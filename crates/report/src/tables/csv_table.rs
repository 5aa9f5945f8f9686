//! Reading and writing of tables whose rows are types.

use std::path::Path;

use asperity_storage::check_finite;
use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::error::{ReportError, TableFault};

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
    let mut reader = csv::Reader::from_path(file).map_err(|error| bad(error.into()))?;
    let mut rows = Vec::new();
    for (index, row) in reader.deserialize().enumerate() {
        let row: R = row.map_err(|error: csv::Error| bad(error.into()))?;
        if let Some((column, _)) = row.numbers().into_iter().find(|(_, v)| !v.is_finite()) {
            return Err(bad(TableFault::NotFinite {
                row: index + 1,
                column,
            }));
        }
        rows.push(row);
    }
    if rows.is_empty() {
        return Err(bad(TableFault::Empty));
    }
    Ok(rows)
}
