//! Record of the surrogates of a flank without a trace.

use serde::{Deserialize, Serialize};

/// Surrogates of a flank: generated profiles with its stated roughness values.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct SurrogateRecord {
    /// Number of profiles.
    pub count: usize,
    /// Their finishes.
    pub finishes: Vec<String>,
    /// Mean of their Ra \[µm\].
    pub ra_um: f64,
    /// Mean of their Rz \[µm\].
    pub rz_um: f64,
    /// Mean of their Rpk \[µm\].
    pub rpk_um: f64,
    /// Shortest and longest cut-off λs \[µm\].
    pub lambda_s_um: [f64; 2],
}
