//! One mesh position: the inputs of the friction laws.
//!
//! | symbol | field | unit |
//! |---|---|---|
//! | w | `load` | N/m |
//! | R | `radius` | m |
//! | V_e = (u₁ + u₂)/2 | `entrainment` | m/s |
//! | V_s = u₁ − u₂ | `sliding` | m/s |
//! | p₀ | `max_pressure` | Pa |
//! | η₀, ν | `viscosity`, `kinematic_viscosity` | Pa s, m²/s |
//! | S = √(Rq₁² + Rq₂²) | `combined_roughness` | m |
//! | (Ra₁ + Ra₂)/2 | `mean_ra` | m |
//! | Rz₁ + Rz₂ | `sum_rz` | m |
//!
//! A law reads only what it needs; nothing else is checked.

use asperity_core::DomainError;
use asperity_core::quantity::{
    DynamicViscosity, KinematicViscosity, Length, LineLoad, Pressure, PressureViscosity, Speed,
};
use serde::Serialize;

use crate::error::FrictionError;

/// One mesh position with its film and the roughness of the pair.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct FrictionConditions {
    /// Load per length of contact line w.
    pub load: LineLoad,
    /// Relative radius of curvature R.
    pub radius: Length,
    /// Mean surface speed V_e = (u₁ + u₂)/2.
    pub entrainment: Speed,
    /// Sliding speed V_s = u₁ − u₂, of either sign.
    pub sliding: Speed,
    /// Maximum Hertz pressure p₀.
    pub max_pressure: Pressure,
    /// Viscosity η₀ at the bulk temperature and ambient pressure.
    pub viscosity: DynamicViscosity,
    /// Viscosity in the film, at the mean Hertz pressure π p₀/4
    /// (see [`asperity_oil`]); `eyring` reads it.
    pub contact_viscosity: DynamicViscosity,
    /// Kinematic viscosity ν at the bulk temperature.
    pub kinematic_viscosity: KinematicViscosity,
    /// Pressure-viscosity coefficient α.
    pub pressure_viscosity: PressureViscosity,
    /// Central film thickness, with the thermal reduction in use.
    pub central_film: Length,
    /// Minimum film thickness, with the thermal reduction in use.
    pub minimum_film: Length,
    /// Combined root-mean-square roughness S = √(Rq₁² + Rq₂²).
    pub combined_roughness: Length,
    /// Mean arithmetic roughness (Ra₁ + Ra₂)/2.
    pub mean_ra: Length,
    /// Sum of the maximum heights Rz₁ + Rz₂.
    pub sum_rz: Length,
    /// Coefficient of boundary friction of the pair.
    pub boundary_coefficient: f64,
    /// Inputs of the whole-mesh laws of ISO/TR 14179.
    pub mesh: MeshConditions,
}

/// Gear-level inputs of the laws that give one coefficient for the whole mesh.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct MeshConditions {
    /// Transverse base force over face width F_bt/b.
    pub base_line_load: LineLoad,
    /// Sum of the surface speeds at the pitch point v_ΣC.
    pub sum_speed: Speed,
    /// Relative radius of curvature at the pitch point ρ_redC.
    pub reduced_radius: Length,
    /// Lubricant factor X_L of [`iso_14179_2`](crate::iso_14179_2).
    pub lubricant_factor: f64,
    /// Load intensity K = F_t/(b d_w1) · (u + 1)/u.
    pub load_intensity: Pressure,
    /// Pitch line speed v_t.
    pub pitch_line_speed: Speed,
}

impl FrictionConditions {
    /// Slide-to-roll ratio SRR = V_s/V_e.
    ///
    /// # Errors
    /// When V_e is not finite and positive or V_s not finite.
    pub fn slide_to_roll(&self) -> Result<f64, FrictionError> {
        let v_e = DomainError::positive("entrainment speed", self.entrainment)?;
        let v_s = DomainError::finite("sliding speed", self.sliding)?;
        Ok(v_s / v_e)
    }
}
