//! Refusals of a build without the feature `case-files` instead of reading texts.

use std::borrow::Cow;

use crate::input::case_input::CaseInput;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// The table of a name in an equation; the keys of the table are not known here.
pub(crate) fn key_of(table: &'static str, _: &str) -> Cow<'static, str> {
    table.into()
}

/// The message about a key that is missing in `table`.
pub(crate) fn missing_key(_: &str, key: &str) -> String {
    format!("missing key \"{key}\"")
}

/// Whether a case whose meshes have names has the key: the keys of every mesh are listed here.
pub(crate) fn is_key_of_named_meshes(_: &str) -> bool {
    true
}

impl CaseInput {
    /// Reads the case in a stored result: for `#[serde(deserialize_with)]`.
    ///
    /// # Errors
    /// When a value is missing or of the wrong kind.
    pub fn stored<'de, D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        Self::deserialize(from)
    }

    /// Writes the case into a stored result: for `#[serde(serialize_with)]`.
    ///
    /// # Errors
    /// When the format cannot write a value.
    pub fn store<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        self.serialize(to)
    }
}
