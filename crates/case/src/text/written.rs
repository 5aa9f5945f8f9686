//! Values as TOML, through a pointer to their serialisation: the code that writes every key is large, and would be compiled
//! again for each of the serializers of the format.

use erased_serde::Serialize;
use toml::ser::Error;
use toml::{Table, Value};

/// A value of TOML.
pub(crate) fn value(of: &dyn Serialize) -> Result<Value, Error> {
    Value::try_from(of)
}

/// A table of TOML.
pub(crate) fn table(of: &dyn Serialize) -> Result<Table, Error> {
    Table::try_from(of)
}

/// A file of TOML.
pub(crate) fn file(of: &dyn Serialize) -> Result<String, Error> {
    toml::to_string(of)
}

/// A file of TOML with lists over several lines.
pub(crate) fn long_file(of: &dyn Serialize) -> Result<String, Error> {
    toml::to_string_pretty(of)
}
