//! Elastic and thermal constants of the gear materials.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | E | Young's modulus | Pa |
//! | ν | Poisson's ratio | - |
//! | E* | reduced modulus of a pair | Pa |

use serde::{Deserialize, Serialize};

use crate::error::DomainError;
use crate::quantity::{Density, Pressure, SpecificHeat, ThermalConductivity};

/// A body's elastic and thermal constants.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Material {
    /// Young's modulus E.
    pub young: Pressure,
    /// Poisson's ratio ν.
    pub poisson: f64,
    /// Elastic limit in uniaxial tension (yield strength).
    pub elastic_limit: Pressure,
    /// Density.
    pub density: Density,
    /// Thermal conductivity.
    pub conductivity: ThermalConductivity,
    /// Specific heat capacity.
    pub heat_capacity: SpecificHeat,
}

impl Material {
    /// Plane-strain compliance (1 − ν²)/E \[1/Pa\].
    ///
    /// # Errors
    /// When E is not positive or ν is outside −1 < ν ≤ 0.5.
    pub fn compliance(&self) -> Result<f64, DomainError> {
        let young = DomainError::positive("Young's modulus", self.young)?;
        let poisson = DomainError::require(
            self.poisson > -1.0 && self.poisson <= 0.5,
            "Poisson's ratio",
            self.poisson,
            "-",
            "must lie above -1 and not above 0.5",
        )?;
        Ok((1.0 - poisson * poisson) / young)
    }
}

/// 1/E* = (1 − ν₁²)/E₁ + (1 − ν₂²)/E₂, E′ = 2 E*                             [E-star]
///
/// # Errors
/// When a modulus is not positive or a Poisson's ratio is outside −1 < ν ≤ 0.5.
///
/// ```
/// use asperity_core::material::{Material, reduced_modulus};
/// let steel = Material {
///     young: "210 GPa".parse()?, poisson: 0.3, elastic_limit: "235 MPa".parse()?,
///     density: "7830 kg/m3".parse()?, conductivity: "45 W/(m K)".parse()?, heat_capacity: "465 J/(kg K)".parse()?,
/// };
/// assert!((reduced_modulus(&steel, &steel)?.si() - 115.384615e9).abs() < 1e3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn reduced_modulus(first: &Material, second: &Material) -> Result<Pressure, DomainError> {
    crate::cite!("E-star");
    Ok(Pressure::from_si(
        1.0 / (first.compliance()? + second.compliance()?),
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steel_on_steel_has_the_reduced_modulus_of_the_reference_case() {
        let steel = Material {
            young: Pressure::from_si(210e9),
            poisson: 0.3,
            elastic_limit: Pressure::from_si(235e6),
            density: Density::from_si(7830.0),
            conductivity: ThermalConductivity::from_si(45.0),
            heat_capacity: SpecificHeat::from_si(465.0),
        };
        let modulus = reduced_modulus(&steel, &steel).unwrap().si();
        assert!((modulus / 115.384_615_384_615_37e9 - 1.0).abs() < 1e-15);
        assert!(
            reduced_modulus(
                &Material {
                    poisson: 0.7,
                    ..steel
                },
                &steel
            )
            .is_err()
        );
    }
}
