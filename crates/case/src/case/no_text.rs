//! Refusals of a build without the feature `case-files` in place of reading texts.

use std::borrow::Cow;
use std::path::Path;
use std::sync::Arc;

use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::error::CaseError;
use super::files::{FileSums, Files, OIL_FILE};
use super::input::CaseInput;
use super::oil_file::OilFile;
use super::section::Section;
use super::source::Source;

/// The table of a name in an equation; the keys of the table are not known here.
pub(super) fn key_of(table: &'static str, _: &str) -> Cow<'static, str> {
    table.into()
}

/// The message about a key that is missing in `table`.
pub(super) fn missing_key(_: &str, key: &str) -> String {
    format!("missing key \"{key}\"")
}

/// Whether a case whose meshes have names has the key: the keys of every mesh are listed here.
pub(super) fn is_key_of_named_meshes(_: &str) -> bool {
    true
}

/// Refuses an oil file.
pub(super) fn oil_file(
    name: Option<&Path>,
    source: &Source,
    _: &Files,
) -> Result<(Option<Arc<OilFile>>, Arc<FileSums>), CaseError> {
    match name {
        None => Ok((None, Arc::default())),
        Some(_) => {
            let message = "is read only by a build with feature case-files";
            Err(Section::of(source, OIL_FILE).value("", message))
        }
    }
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
