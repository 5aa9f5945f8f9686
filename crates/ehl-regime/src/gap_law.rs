//! Law of the mean gap that the inlet of a rough contact supplies.

use serde::{Deserialize, Serialize};

/// Law of the mean gap that the inlet of a rough contact supplies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum GapLaw {
    /// The inlet of a rough contact is longer than that of a smooth one: wavelengths are relative to the length
    /// that belongs to both the smooth film and the mean gap. The smooth film is a gap.
    #[default]
    Inlet,
    /// Wavelengths relative to the smooth inlet; the film thickens as the asperities take load off it.
    Power,
}

impl GapLaw {
    /// Coefficients of ∇ and ∇² in the amplitude of a wave.
    pub(crate) const fn fall(self) -> [f64; 2] {
        match self {
            Self::Inlet => VENNER,
            Self::Power => SOLVER,
        }
    }

    /// Power of the fluid's share of load and stiffness in the supplied gap.
    pub(crate) const fn supply_power(self) -> f64 {
        match self {
            Self::Inlet => 0.0,
            Self::Power => SUPPLY_POWER,
        }
    }
}

/// Venner, Couhier, Lubrecht and Greenwood 1997, equation 5: for amplitude ratios up to ½.
const VENNER: [f64; 2] = [0.17, 0.03];
/// Amplitudes of the transient solver of this project in pure rolling: within 9 % for ∇ below 8, 27 % above.
const SOLVER: [f64; 2] = [0.125, 0.04];
/// Dowson and Higginson's powers of load, −0.13, and stiffness, −0.03.
const SUPPLY_POWER: f64 = -0.16;
