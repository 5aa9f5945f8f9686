//! Tables with the errors of this crate.

use crate::error;
use asperity_core::Fault;
use asperity_table::{Row, RowFault, Table};

/// The table in `text`, named `name` in messages.
pub(crate) fn read(name: &str, text: &str) -> Result<Table, Fault> {
    Table::read(text).map_err(|source| error::ragged(name, source))
}

/// A value of every row of `table`, which has rows.
pub(crate) fn all<T>(
    (name, table): (&str, &Table),
    value: impl Fn(Row<'_>) -> Result<T, RowFault>,
) -> Result<Vec<T>, Fault> {
    let file = name.to_owned();
    match table.all(value) {
        Ok(values) if values.is_empty() => Err(error::column(file, "the table has no rows")),
        Ok(values) => Ok(values),
        Err(faults) => Err(error::rows(&file, &faults)),
    }
}
