//! Tables with the errors of this crate.

use crate::error;
use asperity::core::nearest_name;
use asperity_core::Fault;
use asperity_table::{Row, RowFault, Table};

/// The table in `text`, named `name` in messages.
pub(crate) fn read(name: &str, text: &str) -> Result<Table, Fault> {
    Table::read(text).map_err(|source| error::ragged(name, source))
}

/// Columns of `table` that are not `known`, each with the one of the `needed` names, which the table lacks, that it is most like.
pub(crate) fn misspelt(table: &Table, needed: &[&str], known: &[&str]) -> Vec<String> {
    let unknown = table.names().iter();
    let unknown = unknown.filter(|name| !known.contains(&name.as_str()));
    let unknown: Vec<String> = unknown.cloned().collect();
    let missing = needed.iter().filter(|name| !table.has(name));
    let named = missing.filter_map(|name| {
        let seen = nearest_name(name, &unknown)?;
        Some(format!("column {seen} is not known; write {name}"))
    });
    named.collect()
}

/// A value of every row of `table`, which has rows.
pub(crate) fn all<T>(
    name: &str,
    table: &Table,
    value: impl Fn(Row<'_>) -> Result<T, RowFault>,
) -> Result<Vec<T>, Fault> {
    let file = name.to_owned();
    match table.all(value) {
        Ok(values) if values.is_empty() => Err(error::column(file, "the table has no rows")),
        Ok(values) => Ok(values),
        Err(faults) => Err(error::rows(&file, &faults)),
    }
}
