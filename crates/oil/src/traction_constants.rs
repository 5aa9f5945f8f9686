//! Constants of an oil for film friction besides its viscosity; symbols as in `rheology`.

use asperity_core::DomainError;
use asperity_core::numerics::elementary::exp;
use asperity_core::quantity::{PerKelvin, Pressure, Temperature, ThermalConductivity};
use serde::{Deserialize, Serialize};

use crate::{BaseOil, LIMIT_POWER, LubricantError, ShearLaw, ShearLawName};

/// Temperature at which Λ of a base oil holds, 90 °C \[K\].
const LIMIT_TEMPERATURE: f64 = 363.15;
/// Limiting shear stress τ_L0 at ambient pressure (assumed).
pub const AMBIENT_LIMIT: Pressure = Pressure::from_si(2e6);

/// 5 % and 95 % quantiles of the limiting shear stress over pressure, over its median (assumed).
pub const LIMITING_SHEAR_BAND: [f64; 2] = [0.87, 1.15];
/// 5 % and 95 % quantiles of a pressure-viscosity coefficient that is estimated, over its median (assumed).
pub const PRESSURE_VISCOSITY_BAND: [f64; 2] = [0.85, 1.18];
/// 5 % and 95 % quantiles of the Eyring stress of an oil without family, over its median (assumed).
const EYRING_STRESS_BAND: [f64; 2] = [0.75, 4.0 / 3.0];
/// Largest fall or rise of ln Λ \[1/K\]: beyond it a film that heats itself may have several temperatures (a rise of
/// 30 K changes Λ by a factor 1.8 here; own choice).
const STEEPEST_FALL: f64 = 0.02;

/// Constants of the Carreau-Yasuda law; no source states them for gear oils, the defaults are assumed.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
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
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct TractionConstants {
    /// Limiting shear stress over pressure Λ at 90 °C.
    pub limiting_shear: f64,
    /// Fall b_L of ln Λ with temperature; a negative one is a rise.
    pub limiting_shear_fall: PerKelvin,
    /// Pressure-viscosity coefficient of the friction over that of the film thickness, f.
    pub pressure_viscosity_factor: f64,
    /// Limiting shear stress τ_L0 at ambient pressure.
    pub ambient_limit: Pressure,
    /// Power m with which the stress approaches its limit.
    pub limit_power: f64,
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

/// 5 % and 95 % quantiles of the Eyring stress \[Pa\] of an oil of this family; of an oil without family about `value`.
///
/// # Errors
/// As [`BaseOil::data`].
///
/// ```
/// use asperity_oil::{BaseOil, eyring_stress_band};
/// assert_eq!(eyring_stress_band(Some(BaseOil::Pao), 4e6)?, [3e6, 5.5e6]);
/// assert_eq!(eyring_stress_band(None, 4e6)?, [3e6, 4e6 * 4.0 / 3.0]);
/// # Ok::<(), asperity_oil::LubricantError>(())
/// ```
pub fn eyring_stress_band(
    base_oil: Option<BaseOil>,
    value: f64,
) -> Result<[f64; 2], LubricantError> {
    let known = match base_oil {
        Some(base_oil) => {
            let stress = &base_oil.data()?.eyring_stress;
            stress.low.zip(stress.high)
        }
        None => None,
    };
    Ok(match known {
        Some((low, high)) => [low, high],
        None => EYRING_STRESS_BAND.map(|factor| factor * value),
    })
}

impl TractionConstants {
    /// The constants of a base oil.
    ///
    /// # Errors
    /// As [`BaseOil::data`].
    pub fn from_family(family: BaseOil) -> Result<Self, LubricantError> {
        let data = family.data()?;
        Ok(Self {
            limiting_shear: data.limiting_shear.value,
            limiting_shear_fall: PerKelvin::from_si(0.0),
            pressure_viscosity_factor: 1.0,
            ambient_limit: AMBIENT_LIMIT,
            limit_power: LIMIT_POWER,
            eyring_stress: Pressure::from_si(data.eyring_stress.value),
            carreau: CarreauConstants::default(),
            conductivity: ThermalConductivity::from_si(data.conductivity.value),
            conductivity_rise: data.conductivity_rise.value,
            conductivity_bend: data.conductivity_bend.value,
            gold_exponent: family.gold_constants()[1],
        })
    }

    /// Limiting shear stress over pressure at a temperature, Λ exp(−b_L (T − 363.15)).
    #[must_use]
    pub fn limiting_shear_at(&self, temperature: Temperature) -> f64 {
        self.limiting_shear_near(temperature.si())
    }

    /// The same at a temperature \[K\].
    #[inline(always)]
    pub(crate) fn limiting_shear_near(&self, temperature: f64) -> f64 {
        let fall = self.limiting_shear_fall.si();
        self.limiting_shear * exp(-fall * (temperature - LIMIT_TEMPERATURE))
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
        let fall = self.limiting_shear_fall.si();
        DomainError::require(
            fall.abs() <= STEEPEST_FALL,
            "fall of the limiting shear",
            fall,
            "1/K",
            "must lie between -0.02 and 0.02: the film would have no single temperature",
        )?;
        DomainError::non_negative("limiting shear stress at p = 0", self.ambient_limit)?;
        DomainError::positive("Eyring stress", self.eyring_stress)?;
        DomainError::positive("critical stress", self.carreau.critical_stress)?;
        DomainError::positive("oil conductivity", self.conductivity)?;
        let rule = "must be finite and greater than zero";
        for (name, value) in [
            ("limiting shear stress over pressure", self.limiting_shear),
            ("pressure-viscosity factor", self.pressure_viscosity_factor),
            ("power of the limit", self.limit_power),
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
