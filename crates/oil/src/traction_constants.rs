//! Constants of an oil for film friction besides its viscosity; symbols as in `rheology`.

use asperity_core::DomainError;
use asperity_core::quantity::{PerKelvin, Pressure, ThermalConductivity};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::{BaseOil, LubricantError, ShearLaw, ShearLawName};

/// Limiting shear stress τ_L0 at ambient pressure (judgement).
pub const AMBIENT_LIMIT: Pressure = Pressure::from_si(2e6);

/// Constants of the Carreau-Yasuda law; no source states them for gear oils, the defaults are judgement.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct CarreauConstants {
    /// Critical stress G_c.
    pub critical_stress: Pressure,
    /// Exponent n.
    pub exponent: f64,
    /// Sharpness a of the transition.
    pub sharpness: f64,
}

impl Default for CarreauConstants {
    fn default() -> Self {
        Self {
            critical_stress: Pressure::from_si(5e6),
            exponent: 0.4,
            sharpness: 2.0,
        }
    }
}

/// Properties of an oil for film friction besides its viscosity.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TractionConstants {
    /// Limiting shear stress over pressure Λ at 90 °C.
    pub limiting_shear: f64,
    /// Fall b_L of ln Λ with temperature.
    pub limiting_shear_fall: PerKelvin,
    /// Limiting shear stress τ_L0 at ambient pressure.
    pub ambient_limit: Pressure,
    /// Eyring stress τ₀.
    pub eyring_stress: Pressure,
    /// Carreau-Yasuda constants.
    pub carreau: CarreauConstants,
    /// Thermal conductivity k at ambient pressure.
    pub conductivity: ThermalConductivity,
    /// Coefficient c₁ in k(p) \[1/GPa\].
    pub conductivity_rise: f64,
    /// Coefficient c₂ in k(p) \[1/GPa\].
    pub conductivity_bend: f64,
    /// Exponent t with which α follows the viscosity over temperature.
    pub gold_exponent: f64,
}

impl TractionConstants {
    /// The constants of a base oil.
    ///
    /// # Errors
    /// As [`BaseOil::data`].
    pub fn of(family: BaseOil) -> Result<Self, LubricantError> {
        let data = family.data()?;
        Ok(Self {
            limiting_shear: data.limiting_shear.value,
            limiting_shear_fall: PerKelvin::from_si(0.0),
            ambient_limit: AMBIENT_LIMIT,
            eyring_stress: Pressure::from_si(data.eyring_stress.value),
            carreau: CarreauConstants::default(),
            conductivity: ThermalConductivity::from_si(data.conductivity.value),
            conductivity_rise: data.conductivity_rise.value,
            conductivity_bend: data.conductivity_bend.value,
            gold_exponent: family.gold_constants()[1],
        })
    }

    /// The shear law of this name with its constants; Carreau's with the sharpness 2.
    #[must_use]
    pub fn shear_law(&self, name: ShearLawName) -> ShearLaw {
        match name {
            ShearLawName::Newton => ShearLaw::Newtonian,
            ShearLawName::Eyring => ShearLaw::Eyring {
                stress: self.eyring_stress,
            },
            ShearLawName::Carreau => ShearLaw::Carreau {
                modulus: self.carreau.critical_stress,
                exponent: self.carreau.exponent,
            },
        }
    }

    pub(crate) fn validate(&self) -> Result<(), DomainError> {
        DomainError::non_negative("fall of the limiting shear", self.limiting_shear_fall)?;
        DomainError::non_negative("limiting shear stress at p = 0", self.ambient_limit)?;
        DomainError::positive("Eyring stress", self.eyring_stress)?;
        DomainError::positive("critical stress", self.carreau.critical_stress)?;
        DomainError::positive("oil conductivity", self.conductivity)?;
        let rule = "must be finite and greater than zero";
        for (name, value) in [
            ("limiting shear stress over pressure", self.limiting_shear),
            ("Carreau exponent", self.carreau.exponent),
            ("Carreau sharpness", self.carreau.sharpness),
        ] {
            DomainError::require(value.is_finite() && value > 0.0, name, value, "-", rule)?;
        }
        let rule = "must be finite and not negative";
        for (name, value) in [
            ("conductivity rise c1", self.conductivity_rise),
            ("conductivity bend c2", self.conductivity_bend),
            ("Gold exponent t", self.gold_exponent),
        ] {
            DomainError::require(value.is_finite() && value >= 0.0, name, value, "-", rule)?;
        }
        Ok(())
    }
}
