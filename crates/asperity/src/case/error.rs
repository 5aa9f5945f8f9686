//! What can be wrong with a case file, each with a code, a place and a remedy.

use asperity_core::DomainError;
use asperity_roughness::read::ReadError;

use super::source::Place;

/// A case that cannot be run.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum CaseError {
    /// The file cannot be opened.
    #[error("{file}: cannot be read: {reason}")]
    Open {
        /// Name of the file.
        file: String,
        /// What the system says.
        reason: std::io::Error,
    },
    /// Not TOML, or not JSON.
    #[error("{place}: {message}")]
    Syntax {
        /// Where.
        place: Place,
        /// What the parser says.
        message: String,
    },
    /// A key the case file does not know.
    #[error("{place}: unknown key \"{key}\"{}", did_you_mean(nearest.as_deref()))]
    UnknownKey {
        /// Where.
        place: Place,
        /// The key, with its table.
        key: String,
        /// The known key most like it.
        nearest: Option<String>,
    },
    /// A value that cannot be read, or a key that is missing.
    #[error("{place}: {}{message}", key.as_ref().map(|k| format!("{k}: ")).unwrap_or_default())]
    Value {
        /// Where.
        place: Place,
        /// The key, with its table.
        key: Option<String>,
        /// What was seen and what was expected.
        message: String,
    },
    /// Keys that exclude or need each other.
    #[error("{place}: {key}: {rule}")]
    Conflict {
        /// Where.
        place: Place,
        /// The key, with its table.
        key: &'static str,
        /// What must hold.
        rule: &'static str,
    },
    /// A number outside its domain.
    #[error("{place}: {key}: {source}")]
    Domain {
        /// Where.
        place: Place,
        /// The key, with its table.
        key: &'static str,
        /// The number and the rule.
        source: DomainError,
    },
    /// A gear pair that cannot mesh.
    #[error("{place}: {source}")]
    Gears {
        /// Where.
        place: Place,
        /// The reason.
        source: asperity_gear::GearError,
    },
    /// A lubricant that lacks something or cannot be.
    #[error("{place}: {source}")]
    Lubricant {
        /// Where.
        place: Place,
        /// The reason.
        source: asperity_core::lubricant::LubricantError,
    },
    /// A trace that cannot be opened.
    #[error("{file}: cannot be opened: {reason}")]
    OpenProfile {
        /// Name of the file.
        file: String,
        /// What the system says.
        reason: std::io::Error,
    },
    /// A profile that cannot be read.
    #[error(transparent)]
    Profile(#[from] ReadError),
    /// A profile that cannot be prepared.
    #[error("{file}: {source}")]
    Preparation {
        /// Name of the profile's file.
        file: String,
        /// The reason.
        source: asperity_roughness::RoughnessError,
    },
}

fn did_you_mean(nearest: Option<&str>) -> String {
    nearest
        .map(|key| format!(". Did you mean \"{key}\"?"))
        .unwrap_or_default()
}

impl CaseError {
    /// Stable code of the message.
    pub fn code(&self) -> &'static str {
        use asperity_core::lubricant::LubricantError;
        match self {
            Self::Open { .. } => "E201",
            Self::Syntax { .. } => "E202",
            Self::UnknownKey { .. } => "E203",
            Self::Value { .. } => "E204",
            Self::Conflict { .. } => "E205",
            Self::Gears { .. } => "E206",
            Self::Lubricant {
                source: LubricantError::ImplausiblePressureViscosity { .. },
                ..
            } => "E207",
            Self::Lubricant { .. } => "E208",
            Self::Domain { .. } => "E209",
            Self::OpenProfile { .. } => "E103",
            Self::Profile(error) => error.code(),
            Self::Preparation { .. } => "E110",
        }
    }

    /// Where in the case file, when the error is about a place in it.
    pub fn place(&self) -> Option<&Place> {
        match self {
            Self::Syntax { place, .. }
            | Self::UnknownKey { place, .. }
            | Self::Value { place, .. }
            | Self::Conflict { place, .. }
            | Self::Domain { place, .. }
            | Self::Gears { place, .. }
            | Self::Lubricant { place, .. } => Some(place),
            Self::Open { .. }
            | Self::OpenProfile { .. }
            | Self::Profile(_)
            | Self::Preparation { .. } => None,
        }
    }
}
