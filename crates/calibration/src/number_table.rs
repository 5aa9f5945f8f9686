//! Tables with the errors of this crate.

use asperity_table::{Row, RowFault, Table};

use crate::error::CalibrationError;

/// The table in `text`, named `name` in messages.
pub(crate) fn read(name: &str, text: &str) -> Result<Table, CalibrationError> {
    Table::read(text).map_err(|source| CalibrationError::Ragged {
        file: name.to_owned(),
        source,
    })
}

/// A value of every row of `table`, which has rows.
pub(crate) fn all<T>(
    (name, table): (&str, &Table),
    value: impl Fn(Row<'_>) -> Result<T, RowFault>,
) -> Result<Vec<T>, CalibrationError> {
    let file = name.to_owned();
    match table.all(value) {
        Ok(values) if values.is_empty() => Err(CalibrationError::Column {
            file,
            rule: "the table has no rows".to_owned(),
        }),
        Ok(values) => Ok(values),
        Err(faults) => Err(CalibrationError::Rows { file, faults }),
    }
}
