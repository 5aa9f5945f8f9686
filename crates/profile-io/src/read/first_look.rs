//! Detection of the dialect of a table, and errors of texts without a table.

use super::dialect::{self, Sniffed};
use super::error::{ReadFault, shortened};
use super::layout::Dialect;
use super::options::ReadOptions;
use super::table;
use super::text::{Line, TextSource};

/// The error for a file without a row of numbers.
pub(super) fn no_data(text: &mut TextSource<'_>) -> Result<ReadFault, ReadFault> {
    let (mut count, mut first) = (0, None);
    let mut lines = text.lines()?;
    while let Some(line) = lines.next()? {
        if !line.is_blank() {
            count += 1;
            first.get_or_insert_with(|| shortened(line.text));
        }
    }
    Ok(ReadFault::no_data(count, first.as_deref()))
}

/// The dialect; `None` if no line is a row of numbers in any dialect.
pub(super) fn sniff(
    lines: &[Line<'_>],
    options: &ReadOptions,
) -> Result<Option<Sniffed>, ReadFault> {
    let stated = dialect::StatedDialect {
        separator: options.separator,
        decimal: options.decimal,
        columns: options.columns,
    };
    if let Some(sniffed) = dialect::sniff(lines, stated) {
        return Ok(Some(sniffed));
    }
    let free = dialect::sniff(
        lines,
        dialect::StatedDialect {
            columns: options.columns,
            ..Default::default()
        },
    );
    let Some(free) = free else {
        return Ok(None);
    };
    // The file is a table, but not in the stated dialect: show the first cell that fails.
    let used = Dialect {
        separator: options.separator.unwrap_or(free.dialect.separator),
        decimal: options.decimal.unwrap_or(free.dialect.decimal),
    };
    let line = &lines[free.first];
    let mut cells = used.cells(line.text);
    match cells.find(|cell| used.cell(cell) == dialect::DialectCell::Other) {
        Some(cell) => Err(table::unreadable(lines, line, cell, used)),
        None => Err(ReadFault::separator_does_not_fit(used.separator)),
    }
}
