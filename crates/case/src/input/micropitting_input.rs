//! Keys of the micropitting rating.

use asperity_core::quantity::Length;

use super::rows::table;

table! {
    /// Local specific film thickness of the micropitting rating of ISO/TS 6336-22, compared with the measured flanks at the same
    /// places; computed if this table is stated.
    #[derive(Copy, Default)]
    MicropittingInput;

    /// Product of the load factors K_A K_v K_γ on the load over the flanks; default 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    load_factor: Option<f64> = "" usual [0.8, 4.0] possible [0.05, 50.0];
    /// Permissible specific film thickness λ_GFP from your own tests; without it there is no safety factor.
    #[serde(skip_serializing_if = "Option::is_none")]
    permissible: Option<f64> = "" usual [0.05, 5.0] possible [0.001, 100.0];
    /// Ra of pinion and wheel by which the film is divided; default that of the prepared traces.
    #[serde(skip_serializing_if = "Option::is_none")]
    ra: Option<[Length; 2]> = "um" usual [0.01, 4.0] possible [0.0, 200.0];
}
