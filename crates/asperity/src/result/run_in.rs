//! Running-in in a result.

use serde::{Deserialize, Serialize};

/// One cycle of running-in.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct RunInCycle {
    /// Number of the cycle from 1.
    pub cycle: usize,
    /// Contacts in it.
    pub passes: usize,
    /// Mean plastic work of a contact \[J/m\].
    pub plastic_work_j_per_m: f64,
    /// Rq of pinion and wheel after it \[µm\].
    pub rq_um: [f64; 2],
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
