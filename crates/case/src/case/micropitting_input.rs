//! Keys of the micropitting rating.

use asperity_core::quantity::Length;
use serde::{Deserialize, Serialize};

/// Local specific film thickness of the micropitting rating of ISO/TS 6336-22, compared with the measured flanks at the same
/// places; computed if this table is stated.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct MicropittingInput {
    /// Product of the load factors K_A K_v K_γ on the load over the flanks; default 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub load_factor: Option<f64>,
    /// Permissible specific film thickness λ_GFP from your own tests; without it there is no safety factor.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub permissible: Option<f64>,
    /// Ra of pinion and wheel by which the film is divided; default that of the prepared traces.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ra: Option<[Length; 2]>,
}
