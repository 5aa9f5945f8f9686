//! The sources of the presets.

use serde::{Deserialize, Serialize};

use super::error::PresetError;

/// Key of what has no source but the choice of this project.
pub const OWN_CHOICE: &str = "own_choice";

const FILE: &str = "sources.json";

/// A source of numbers.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PresetSource {
    /// Short key, `author_year`.
    pub key: String,
    /// Full reference.
    pub text: String,
}

/// Every source of the presets.
///
/// # Errors
/// When the data file cannot be read; a test reads it.
pub fn sources() -> Result<Vec<PresetSource>, PresetError> {
    serde_json::from_str(include_str!("../../data/presets/sources.json")).map_err(|error| {
        PresetError::File {
            file: FILE,
            reason: error.to_string(),
        }
    })
}
