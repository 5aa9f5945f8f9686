//! The micropitting rating in a result.

use serde::{Deserialize, Serialize};

/// The rating: smallest film over roughness, and every place.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct MicropittingReport {
    /// Smallest λ_GF.
    pub lambda_min: f64,
    /// Its place, 0 at A and 1 at E.
    pub path_fraction: f64,
    /// The same place on both flanks, in words.
    pub place: String,
    /// Properties of gears and operation outside the scope of the specification.
    pub outside: Vec<String>,
    /// Product of the load factors on the load, as the user states it.
    pub load_factor: f64,
    /// Permissible λ_GFP of the user's.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub permissible: Option<f64>,
    /// S_λ = λ_GF,min/λ_GFP, where the user states that.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub safety: Option<f64>,
    /// Ra of pinion and wheel \[µm\].
    pub ra_um: [f64; 2],
    /// Every place, from A to E.
    pub cells: Vec<MicropittingCell>,
}

/// A place on the path of contact.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct MicropittingCell {
    /// Its place, 0 at A and 1 at E.
    pub path_fraction: f64,
    /// Hertz pressure with the load factors \[MPa\].
    pub pressure_mpa: f64,
    /// Flash temperature by the specification's formula \[K\].
    pub flash_k: f64,
    /// Film thickness h \[µm\].
    pub film_um: f64,
    /// λ_GF.
    pub lambda: f64,
    /// The same film over the composite Rq of the windows in contact, for wavelengths below 0.08 mm; `None` without traces.
    pub lambda_short: Option<f64>,
    /// Share of the load on touching asperities.
    pub solid_share: f64,
    /// Pressure that 99 % of the touching points stay below, at the first offset \[MPa\]; none at A and E and where
    /// nothing touches.
    pub solid_pressure_99_mpa: Option<f64>,
    /// Share of the nominal contact at the flow pressure of the softer flank, at the first offset; none at A and E.
    pub flowing_area: Option<f64>,
}
