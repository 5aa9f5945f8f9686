//! Layout of a text table: separator, decimal sign and columns.

use serde::{Deserialize, Serialize};

use super::options::{Columns, DecimalSign, Separator};

/// Dialect of a table of numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Dialect {
    /// Separator of the columns.
    pub separator: Separator,
    /// Decimal sign.
    pub decimal: DecimalSign,
}

impl std::fmt::Display for Dialect {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self.separator {
            Separator::Semicolon => "';'",
            Separator::Tab => "tabs",
            Separator::Comma => "','",
            Separator::Blank => "blanks",
            Separator::None => "one column",
        })?;
        write!(f, " with decimal {}", self.decimal)
    }
}

/// Dialect of a text table.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct TableLayout {
    /// Separator of the columns.
    pub separator: Separator,
    /// The decimal sign.
    pub decimal: DecimalSign,
    /// Columns that are read.
    pub columns: Columns,
}
