//! Dialect that a file seems to have if many of its rows have like faults.

use std::fmt;

use asperity_core::remedy::{Remedy, Setting, Value};

/// Remedy for numbers with thousands separators.
pub(super) const WITHOUT_THOUSANDS: &str = "export the numbers without thousands separators";

/// Dialect that a file seems to have if many of its rows have like faults.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum FileDialect {
    /// Missing heights have this mark.
    Mark(String),
    /// Numbers are followed by this unit.
    Unit(String),
    /// A column, from 1, has text; these two have numbers, if there are two.
    Text {
        /// The column with text.
        column: usize,
        /// Columns with numbers.
        numbers: Option<[usize; 2]>,
    },
    /// Another table begins.
    Tables,
    /// Rows have different numbers of cells.
    Ragged,
    /// Numbers have thousands separators.
    Thousands,
    /// The rows have another decimal sign or separator; the remedy of the first says which.
    Sign,
}

impl fmt::Display for FileDialect {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Mark(mark) => write!(f, "the file seems to mark missing points with \"{mark}\""),
            Self::Unit(unit) => write!(f, "the numbers seem to be followed by the unit \"{unit}\""),
            Self::Text { column, .. } => write!(f, "column {column} seems to hold text"),
            Self::Tables => write!(f, "another table seems to begin here"),
            Self::Ragged => write!(
                f,
                "the file seems to have cells with its separator in them, thousands separators for example"
            ),
            Self::Thousands => write!(f, "the numbers seem to have thousands separators"),
            Self::Sign => write!(f, "the rows seem to have another decimal sign or separator"),
        }
    }
}

impl FileDialect {
    /// The remedy; `single` is the remedy of a single fault, in the text of an instrument or in a table.
    pub(super) fn remedy(&self, single: Remedy, is_of_instrument: bool) -> Remedy {
        match self {
            Self::Mark(_) => Remedy::act("write NaN instead of the mark"),
            Self::Unit(unit) if is_of_instrument => {
                Remedy::act(format!("remove \"{unit}\" from all heights"))
            }
            Self::Unit(unit) => Remedy::act(format!(
                "remove \"{unit}\" from all rows and write it in the line of names, as z [{unit}]"
            )),
            Self::Text { numbers, .. } => match numbers {
                Some([x, z]) => {
                    Remedy::set(Setting::Columns, Value::Like(format!("{x},{z}").into()))
                }
                None => Remedy::act("export the position and the height as numbers"),
            },
            Self::Tables => Remedy::act("export one table to a file, or delete the others"),
            Self::Thousands => Remedy::act(WITHOUT_THOUSANDS),
            Self::Ragged => Remedy::act("export with ';' or a tab between the columns"),
            Self::Sign => single,
        }
    }
}
