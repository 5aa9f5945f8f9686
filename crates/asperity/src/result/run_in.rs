//! Running-in in a result.

use serde::{Deserialize, Serialize};

/// Flanks after a number of engagements of a tooth of the pinion in the plastic stage of running-in.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct RunInStep {
    /// Engagements of a tooth of the pinion; one of the wheel has had z₁/z₂ as many.
    pub engagements: f64,
    /// Plastic work of a contact, mean since the step before \[J/m\].
    pub plastic_work_j_per_m: f64,
    /// Height removed from pinion and wheel, mean over the traces \[nm\].
    pub removed_nm: [f64; 2],
    /// Roughness of both flanks.
    #[serde(flatten)]
    pub heights: FlankHeights,
}

/// Roughness of both flanks.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct FlankHeights {
    /// Rq of pinion and wheel \[µm\].
    pub rq_um: [f64; 2],
    /// Rpk of pinion and wheel \[µm\].
    pub rpk_um: [f64; 2],
}
