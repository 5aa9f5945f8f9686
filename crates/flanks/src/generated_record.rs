//! Record of a flank that was generated like measured traces.

use asperity_roughness::generate::{Method, Piece, state_words};
use serde::{Deserialize, Serialize};

/// Generation of a flank.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct GeneratedRecord {
    /// The measured traces.
    pub like: Vec<MeasuredTrace>,
    /// The traces of their places after a test.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub after: Vec<MeasuredTrace>,
    /// State from before the test, 0, to after it, 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub state: Option<f64>,
    /// Engagements of a tooth after which they are.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub engagements: Option<f64>,
    /// Pieces of them, or their spectrum and heights.
    pub method: Method,
    /// The pieces in order.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub pieces: Vec<Piece>,
    /// Seed of all flanks.
    pub seed: u32,
    /// Number of the flank, from 1, and number of all.
    pub number: [usize; 2],
}

/// A measured trace that others were generated like.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MeasuredTrace {
    /// Its file, as the case names it.
    pub file: String,
    /// SHA-256 of the file.
    pub sha256: String,
    /// Engagements of a tooth until it was measured.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub engagements: Option<f64>,
}

impl std::fmt::Display for GeneratedRecord {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let [number, all] = self.number;
        let traces = match self.like.len() {
            1 => "one trace".to_owned(),
            several => format!("{several} traces"),
        };
        write!(f, "generated from {traces}")?;
        if let Some(words) = state_words(self.state, self.engagements) {
            write!(f, " {words}")?;
        }
        write!(f, ", flank {number} of {all}, seed {}", self.seed)
    }
}
