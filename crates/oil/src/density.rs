//! Density over temperature and pressure.
//!
//! Over temperature the density falls linearly from a known value; the thermal expansion of the
//! base oils is taken from the gear oils of Fernandes, Martins and Seabra (2013). Over
//! pressure Dowson and Higginson's form, which ends at 1.353 times the ambient density.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | ρ_r | density at the temperature T_r, usually 15 °C | kg/m³ |
//! | ε | thermal expansion, relative to ρ_r | 1/K |
//! | ρ₀ | density at ambient pressure | kg/m³ |
//! | p | pressure | Pa |

use serde::{Deserialize, Serialize};

use asperity_core::quantity::{Density, PerKelvin, Pressure, Temperature};
use asperity_core::{DomainError, cite};

/// Coefficient of the numerator (Dowson and Higginson 1966) \[1/Pa\].
const DOWSON_HIGGINSON_RISE: f64 = 0.6e-9;
/// Coefficient of the denominator (Dowson and Higginson 1966) \[1/Pa\].
const DOWSON_HIGGINSON_BEND: f64 = 1.7e-9;

/// Density of an oil at ambient pressure as a line over temperature.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct DensityLine {
    /// Density ρ_r.
    pub density: Density,
    /// Temperature T_r it holds at.
    pub temperature: Temperature,
    /// Thermal expansion ε.
    pub expansion: PerKelvin,
}

impl DensityLine {
    /// ρ(T) = ρ_r·(1 − ε·(T − T_r))                                             [Density-1]
    ///
    /// # Errors
    /// When ρ_r or a temperature is not positive, ε is negative, or the line has fallen to zero.
    ///
    /// ```
    /// use asperity_oil::DensityLine;
    /// let oil = DensityLine { density: "900 kg/m3".parse()?, temperature: "15 °C".parse()?, expansion: "5.8e-4 1/K".parse()? };
    /// assert!((oil.at("65 °C".parse()?)?.si() - 873.9).abs() < 1e-9);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn at(&self, temperature: Temperature) -> Result<Density, DomainError> {
        cite!("Density-1");
        let rho = DomainError::positive("density", self.density)?;
        Ok(Density::from_si(rho * self.remainder(temperature)?))
    }

    /// −(dρ/dT)/ρ = ε/(1 − ε·(T − T_r)).
    ///
    /// # Errors
    /// As for [`at`](Self::at).
    pub fn temperature_coefficient(
        &self,
        temperature: Temperature,
    ) -> Result<PerKelvin, DomainError> {
        Ok(self.expansion / self.remainder(temperature)?)
    }

    /// 1 − ε·(T − T_r), positive.
    fn remainder(&self, temperature: Temperature) -> Result<f64, DomainError> {
        let t = DomainError::positive("temperature", temperature)?;
        let reference = DomainError::positive("temperature of the density", self.temperature)?;
        let epsilon = DomainError::non_negative("thermal expansion", self.expansion)?;
        let remainder = 1.0 - epsilon * (t - reference);
        DomainError::require(
            remainder > 0.0,
            "temperature",
            t,
            "K",
            "is beyond the line of the thermal expansion",
        )?;
        Ok(remainder)
    }
}

/// ρ(p) = ρ₀·(1 + 0.6·10⁻⁹·p/(1 + 1.7·10⁻⁹·p))                                 [Density-2]
///
/// # Errors
/// When the density is not positive or the pressure is negative.
///
/// ```
/// use asperity_oil::dowson_higginson_density;
/// let rho = dowson_higginson_density("998 kg/m3".parse()?, "0.6 GPa".parse()?)?;
/// assert!((rho.si() - 1175.861386).abs() < 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn dowson_higginson_density(
    density: Density,
    pressure: Pressure,
) -> Result<Density, DomainError> {
    cite!("Density-2");
    let rho0 = DomainError::positive("density", density)?;
    let p = DomainError::non_negative("pressure", pressure)?;
    let relative = DensityLaw::DowsonHigginson.relative(1.0).at(p)[0];
    Ok(Density::from_si(rho0 * relative))
}

/// Density over pressure, by name.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum DensityLaw {
    /// The same density at every pressure.
    Incompressible,
    /// ρ = ρ₀·(1 + 0.6·10⁻⁹·p/(1 + 1.7·10⁻⁹·p)).
    DowsonHigginson,
}

impl DensityLaw {
    /// The law over the pressure in units of `unit` \[Pa\].
    ///
    /// ```
    /// use asperity_oil::DensityLaw;
    /// let [relative, _] = DensityLaw::DowsonHigginson.relative(1e9).at(1.0);
    /// assert!((relative - 1.2222).abs() < 1e-4);
    /// ```
    #[must_use]
    pub fn relative(self, unit: f64) -> RelativeDensity {
        match self {
            Self::Incompressible => RelativeDensity {
                rise: 0.0,
                bend: 0.0,
            },
            Self::DowsonHigginson => RelativeDensity {
                rise: DOWSON_HIGGINSON_RISE * unit,
                bend: DOWSON_HIGGINSON_BEND * unit,
            },
        }
    }
}

/// Relative density ρ/ρ₀ over a scaled pressure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RelativeDensity {
    rise: f64,
    bend: f64,
}

impl RelativeDensity {
    /// ρ/ρ₀ and its slope; a negative pressure counts as zero.
    #[inline]
    #[must_use]
    pub fn at(&self, pressure: f64) -> [f64; 2] {
        let p = pressure.max(0.0);
        let below = 1.0 + self.bend * p;
        [1.0 + self.rise * p / below, self.rise / (below * below)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dowson_higginson_hits_the_reference_case_and_its_limit() {
        // The paper's oil at 0.6 GPa, recomputed independently in double precision.
        let rho = |p| {
            dowson_higginson_density(Density::from_si(998.0), Pressure::from_si(p))
                .unwrap()
                .si()
        };
        assert!((rho(0.6e9) / 1_175.861_386_138_613_9 - 1.0).abs() < 1e-14);
        assert_eq!(rho(0.0), 998.0);
        assert!((rho(1e15) / 998.0 - (1.0 + 0.6 / 1.7)).abs() < 1e-6);
    }

    #[test]
    fn density_falls_linearly_and_its_coefficient_is_its_slope() {
        let oil = DensityLine {
            density: Density::from_si(882.0),
            temperature: Temperature::from_si(288.15),
            expansion: PerKelvin::from_si(5.8e-4),
        };
        let at = |t| oil.at(Temperature::from_si(t)).unwrap().si();
        assert!((at(388.15) / 882.0 - (1.0 - 0.058)).abs() < 1e-15);
        let slope = -(at(351.0) - at(349.0)) / 2.0 / at(350.0);
        let beta = oil.temperature_coefficient(Temperature::from_si(350.0));
        // A line has no truncation error: round-off only.
        assert!((beta.unwrap().si() - slope).abs() < 1e-15);
        assert!(oil.at(Temperature::from_si(5000.0)).is_err());
    }
}
