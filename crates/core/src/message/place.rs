//! Places in a case, as messages name them.

use std::ops::Range;

use serde::Serialize;

/// Name of a case that was not read from a file.
pub const IN_MEMORY: &str = "case";

/// A place in a case.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Place {
    /// Name of the file as the user gave it; `case` for one that was built in memory.
    pub file: String,
    /// Path of the key, as `gears.module`, if the place is of one.
    pub key: Option<String>,
    /// Line, counted from 1; `None` if there is no text or its format has no lines.
    pub line: Option<usize>,
    /// Column in characters, counted from 1; `None` as for the line.
    pub column: Option<usize>,
    /// Byte range in the text; `None` as for the line.
    pub span: Option<Range<usize>>,
    /// Mesh of a gear train, in which its gears are called pinion and wheel.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mesh: Option<String>,
}

impl Place {
    /// The place with this key.
    #[must_use]
    pub fn about(self, key: &str) -> Self {
        Self {
            key: Some(key.to_owned()),
            ..self
        }
    }
}

impl std::fmt::Display for Place {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.line {
            Some(line) => write!(f, "{}:{line}", self.file)?,
            None => write!(f, "{}", self.file)?,
        }
        match &self.mesh {
            Some(mesh) => write!(f, " ({mesh})"),
            None => Ok(()),
        }
    }
}
