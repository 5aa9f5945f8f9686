//! Errors of the presets.

/// Errors of the presets and their files.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PresetError {
    /// A name that no preset has.
    #[error("there are no {kind} named \"{name}\"; there are: {}", .known.join(", "))]
    Unknown {
        /// Kind of preset, in the plural: gears or steels.
        kind: &'static str,
        /// The requested name.
        name: String,
        /// The names there are.
        known: Vec<String>,
    },
    /// A data file that cannot be read.
    #[error("the file {file} of the presets cannot be read: {reason}")]
    File {
        /// The file.
        file: &'static str,
        /// Cause.
        reason: String,
    },
    /// A number whose source is not in the list of sources.
    #[error("{preset}: {key} has the source \"{source_key}\", which is not in the list of sources")]
    NoSource {
        /// Name of the preset.
        preset: String,
        /// The number.
        key: &'static str,
        /// The key of the source.
        source_key: String,
    },
    /// A number that claims to be known without a source but the choice of this project.
    #[error("{preset}: {key} is of certainty {certainty}, but has no source of its own")]
    OwnChoice {
        /// Name of the preset.
        preset: String,
        /// The number.
        key: &'static str,
        /// Its certainty.
        certainty: &'static str,
    },
}
