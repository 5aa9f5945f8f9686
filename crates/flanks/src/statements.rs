//! Statements about the heights of a trace, by their file or by whoever filtered them.

use asperity_core::quantity::Length;
use asperity_profile_io::Warning;
use asperity_profile_io::read::{FilterState, Reading};
use serde::{Deserialize, Serialize};

/// Statements about the heights of a trace, which its filters follow and which warn the reader of a result.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Statements {
    /// Filters that the heights have been through.
    pub filter_state: FilterState,
    /// Cut-offs λc and λs of the instrument.
    pub cutoffs: [Option<Length>; 2],
    /// Doubts of the reader.
    pub warnings: Vec<Warning>,
}

impl From<&Reading> for Statements {
    fn from(reading: &Reading) -> Self {
        Self {
            filter_state: reading.filter_state,
            cutoffs: [reading.metadata.lambda_c, reading.metadata.lambda_s],
            warnings: reading.warnings.clone(),
        }
    }
}

impl Statements {
    /// Whether the long waves were removed before.
    #[must_use]
    pub fn is_roughness(&self) -> bool {
        self.filter_state == FilterState::Roughness
    }

    /// The same for flanks that are generated like these heights, which the doubts of the reader are not about.
    #[must_use]
    pub fn without_warnings(self) -> Self {
        Self {
            warnings: Vec::new(),
            ..self
        }
    }
}
