//! Viscosity over temperature at ambient pressure, and its slope.
//!
//! Three laws: ASTM D341 through the viscosities at 40 °C and 100 °C (the data sheet), Vogel's
//! with three constants, and Reynolds' exponential through one given viscosity and slope. Each
//! gives its temperature coefficient β in closed form; nothing is differenced.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | T | temperature | K |
//! | ν | kinematic viscosity; in the ASTM formula the number in mm²/s | m²/s |
//! | η | dynamic viscosity | Pa s |
//! | A, B | ASTM constants | - |
//! | K, b, θ | Vogel's constants | Pa s, K, K |
//! | β | −(dν/dT)/ν or −(dη/dT)/η | 1/K |

use std::f64::consts::LN_10;

use serde::{Deserialize, Serialize};

use asperity_core::quantity::{DynamicViscosity, KinematicViscosity, PerKelvin, Temperature};
use asperity_core::{Checked, DomainError, FittedRange, cite};

/// Additive constant of ASTM D341 for viscosities above 2 mm²/s.
const ASTM_C: f64 = 0.7;
/// mm²/s in a m²/s: the unit of the ASTM formula.
const MM2_PER_M2: f64 = 1e6;
/// The two temperatures of a data sheet, 40 °C and 100 °C \[K\].
const DATA_SHEET: [Temperature; 2] = [Temperature::from_si(313.15), Temperature::from_si(373.15)];
/// Range of the short form of ASTM D341 (constant 0.7).
const ASTM_RANGE: FittedRange =
    FittedRange::new("kinematic viscosity", 2.0, 2e7, "mm2/s", "ASTM D341");
/// Range of Reynolds' exponential around its temperature. Own choice: over 20 K it departs from
/// ASTM D341 by a tenth for an ISO VG 100 mineral oil at 60 °C.
const REYNOLDS_RANGE: FittedRange = FittedRange::new(
    "distance from the temperature of the given viscosity",
    -20.0,
    20.0,
    "K",
    "the exponential viscosity law",
);

/// The ASTM D341 law of one oil: log₁₀ log₁₀ (ν + 0.7) = A − B·log₁₀ T.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct AstmD341 {
    /// Constant A.
    pub a: f64,
    /// Constant B, the steepness.
    pub b: f64,
}

impl AstmD341 {
    /// B = (Y₁ − Y₂)/(log₁₀ T₂ − log₁₀ T₁),  A = Y₁ + B·log₁₀ T₁,  Yᵢ = log₁₀ log₁₀ (νᵢ + 0.7)   [ASTM-1]
    ///
    /// with T₁ = 40 °C and T₂ = 100 °C.
    ///
    /// # Errors
    /// When a viscosity is not above 0.3 mm²/s, where the formula ends, or does not fall with
    /// temperature.
    ///
    /// ```
    /// use asperity_oil::AstmD341;
    /// let law = AstmD341::from_data_sheet("100 mm2/s".parse()?, "11.2 mm2/s".parse()?)?;
    /// assert!((law.a - 9.154816).abs() < 1e-6 && (law.b - 3.547278).abs() < 1e-6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn from_data_sheet(
        at_40: KinematicViscosity,
        at_100: KinematicViscosity,
    ) -> Result<Self, DomainError> {
        cite!("ASTM-1");
        let y1 = ordinate("viscosity at 40 °C", at_40)?;
        let y2 = ordinate("viscosity at 100 °C", at_100)?;
        DomainError::require(
            at_40 > at_100,
            "viscosity at 100 °C",
            at_100.si() * MM2_PER_M2,
            "mm2/s",
            "must be below the viscosity at 40 °C",
        )?;
        let [t1, t2] = DATA_SHEET.map(|t| t.si().log10());
        let b = (y1 - y2) / (t2 - t1);
        Ok(Self { a: y1 + b * t1, b })
    }

    /// ν(T) = 10^10^(A − B·log₁₀ T) − 0.7  mm²/s                                  [ASTM-2]
    ///
    /// A viscosity outside 2 to 2·10⁷ mm²/s is noted.
    ///
    /// # Errors
    /// When the temperature is not positive, or so low that the viscosity has no finite value.
    ///
    /// ```
    /// use asperity_oil::AstmD341;
    /// let law = AstmD341::from_data_sheet("100 mm2/s".parse()?, "11.2 mm2/s".parse()?)?;
    /// let nu = law.kinematic_viscosity("60 °C".parse()?)?.value;
    /// assert!((nu.si() - 39.859e-6).abs() < 1e-9);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn kinematic_viscosity(
        &self,
        temperature: Temperature,
    ) -> Result<Checked<KinematicViscosity>, DomainError> {
        Ok(self.viscosity_and_exponent(temperature)?.0)
    }

    /// β_ν(T) = −(dν/dT)/ν = B·(ν + 0.7)·ln(ν + 0.7)/(ν·T)                        [ASTM-3]
    ///
    /// # Errors
    /// As for [`kinematic_viscosity`](Self::kinematic_viscosity).
    ///
    /// ```
    /// use asperity_oil::AstmD341;
    /// let law = AstmD341::from_data_sheet("100 mm2/s".parse()?, "11.2 mm2/s".parse()?)?;
    /// assert!((law.temperature_coefficient("60 °C".parse()?)?.si() - 0.0401).abs() < 1e-4);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn temperature_coefficient(
        &self,
        temperature: Temperature,
    ) -> Result<PerKelvin, DomainError> {
        Ok(self.viscosity_and_slope(temperature)?.1)
    }

    /// ν and β_ν.
    pub(crate) fn viscosity_and_slope(
        &self,
        temperature: Temperature,
    ) -> Result<(Checked<KinematicViscosity>, PerKelvin), DomainError> {
        cite!("ASTM-3");
        let (viscosity, exponent) = self.viscosity_and_exponent(temperature)?;
        let nu = viscosity.value.si() * MM2_PER_M2;
        let slope = self.b * (nu + ASTM_C) * (LN_10 * exponent) / (nu * temperature.si());
        Ok((viscosity, PerKelvin::from_si(slope)))
    }

    /// ν and log₁₀ (ν + 0.7).
    fn viscosity_and_exponent(
        &self,
        temperature: Temperature,
    ) -> Result<(Checked<KinematicViscosity>, f64), DomainError> {
        cite!("ASTM-2");
        let t = DomainError::positive("temperature", temperature)?;
        let exponent = 10f64.powf(self.a - self.b * t.log10());
        let nu = 10f64.powf(exponent) - ASTM_C;
        DomainError::require(
            nu.is_finite(),
            "temperature",
            t,
            "K",
            "is too low for a finite viscosity",
        )?;
        let mut outside = Vec::new();
        ASTM_RANGE.check(nu, &mut outside);
        let value = KinematicViscosity::from_si(nu / MM2_PER_M2);
        Ok((Checked { value, outside }, exponent))
    }
}

/// Y = log₁₀ log₁₀ (ν + 0.7), defined above 0.3 mm²/s.
fn ordinate(name: &'static str, viscosity: KinematicViscosity) -> Result<f64, DomainError> {
    let nu = viscosity.si() * MM2_PER_M2;
    DomainError::require(
        nu.is_finite() && nu > 1.0 - ASTM_C,
        name,
        nu,
        "mm2/s",
        "must be finite and above 0.3 mm2/s",
    )?;
    Ok((nu + ASTM_C).log10().log10())
}

/// Vogel's law of one oil: η = K·exp(b/(T − θ)).
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Vogel {
    /// Limit K of the viscosity at high temperature.
    pub limit_viscosity: DynamicViscosity,
    /// Constant b \[K\].
    pub slope_kelvin: f64,
    /// Temperature θ of the pole, where the oil would freeze \[K\]; zero is Andrade's law.
    pub pole_kelvin: f64,
}

impl Vogel {
    /// η(T) = K·exp(b/(T − θ))                                                   [Vogel-1]
    ///
    /// # Errors
    /// When K or b is not positive, θ is negative, or the temperature is not above θ.
    ///
    /// ```
    /// use asperity_oil::Vogel;
    /// let law = Vogel { limit_viscosity: "0.08686 mPa s".parse()?, slope_kelvin: 890.0, pole_kelvin: 182.0 };
    /// let eta = law.dynamic_viscosity("40 °C".parse()?)?;
    /// assert!((eta.si() - 0.0770).abs() < 1e-4);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn dynamic_viscosity(
        &self,
        temperature: Temperature,
    ) -> Result<DynamicViscosity, DomainError> {
        cite!("Vogel-1");
        let k = DomainError::positive("limit viscosity", self.limit_viscosity)?;
        let distance = self.distance(temperature)?;
        let eta = k * (self.slope_kelvin / distance).exp();
        DomainError::require(
            eta.is_finite(),
            "temperature",
            temperature.si(),
            "K",
            "is too near the pole for a finite viscosity",
        )?;
        Ok(DynamicViscosity::from_si(eta))
    }

    /// β(T) = −(dη/dT)/η = b/(T − θ)²                                            [Vogel-2]
    ///
    /// # Errors
    /// When b is not positive, θ is negative, or the temperature is not above θ.
    ///
    /// ```
    /// use asperity_oil::Vogel;
    /// let law = Vogel { limit_viscosity: "0.08686 mPa s".parse()?, slope_kelvin: 890.0, pole_kelvin: 182.0 };
    /// assert!((law.temperature_coefficient("40 °C".parse()?)?.si() - 0.0517).abs() < 1e-4);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn temperature_coefficient(
        &self,
        temperature: Temperature,
    ) -> Result<PerKelvin, DomainError> {
        cite!("Vogel-2");
        let distance = self.distance(temperature)?;
        Ok(PerKelvin::from_si(
            self.slope_kelvin / (distance * distance),
        ))
    }

    /// T − θ, with everything about b, θ and T checked.
    fn distance(&self, temperature: Temperature) -> Result<f64, DomainError> {
        let t = DomainError::positive("temperature", temperature)?;
        let (b, theta) = (self.slope_kelvin, self.pole_kelvin);
        DomainError::require(
            b.is_finite() && b > 0.0,
            "slope_kelvin",
            b,
            "K",
            "must be finite and greater than zero",
        )?;
        DomainError::require(
            theta.is_finite() && theta >= 0.0,
            "pole_kelvin",
            theta,
            "K",
            "must be finite and not negative",
        )?;
        DomainError::require(
            t > theta,
            "temperature",
            t,
            "K",
            "must lie above the pole of Vogel's law",
        )?;
        Ok(t - theta)
    }
}

/// A viscosity known at one temperature, with its slope there.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct GivenViscosity {
    /// Viscosity η_r.
    pub viscosity: DynamicViscosity,
    /// Temperature T_r at which it was given.
    pub temperature: Temperature,
    /// β = −(dη/dT)/η.
    pub temperature_coefficient: PerKelvin,
}

impl GivenViscosity {
    /// η(T) = η_r·exp(−β·(T − T_r))                                             [Reynolds-eta]
    ///
    /// A temperature more than 20 K away from T_r is noted.
    ///
    /// # Errors
    /// When a viscosity, a temperature or the coefficient is not positive.
    ///
    /// ```
    /// use asperity_oil::GivenViscosity;
    /// let oil = GivenViscosity { viscosity: "97.5 mPa s".parse()?, temperature: "60 °C".parse()?, temperature_coefficient: "0.045 1/K".parse()? };
    /// let warmer = oil.dynamic_viscosity("70 °C".parse()?)?;
    /// assert!((warmer.value.si() - 0.0975 * (-0.45f64).exp()).abs() < 1e-15 && warmer.outside.is_empty());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn dynamic_viscosity(
        &self,
        temperature: Temperature,
    ) -> Result<Checked<DynamicViscosity>, DomainError> {
        cite!("Reynolds-eta");
        let eta = DomainError::positive("viscosity", self.viscosity)?;
        let t = DomainError::positive("temperature", temperature)?;
        let reference =
            DomainError::positive("temperature of the given viscosity", self.temperature)?;
        let beta = DomainError::positive(
            "temperature coefficient -(d eta/dT)/eta",
            self.temperature_coefficient,
        )?;
        let mut outside = Vec::new();
        REYNOLDS_RANGE.check(t - reference, &mut outside);
        let value = eta * (-beta * (t - reference)).exp();
        DomainError::require(
            value.is_finite() && value > 0.0,
            "temperature",
            t,
            "K",
            "is too far from that of the given viscosity",
        )?;
        Ok(Checked {
            value: DynamicViscosity::from_si(value),
            outside,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn vg100() -> AstmD341 {
        AstmD341::from_data_sheet(
            KinematicViscosity::from_si(100e-6),
            KinematicViscosity::from_si(11.2e-6),
        )
        .unwrap()
    }

    #[test]
    fn astm_d341_passes_through_the_data_sheet_and_60_degrees() {
        // A, B and ν(60 °C) recomputed independently in double precision.
        let law = vg100();
        assert!((law.a - 9.154_816_089_649_252).abs() < 1e-12);
        assert!((law.b - 3.547_278_445_429_606).abs() < 1e-12);
        let nu = |t| {
            let checked = law.kinematic_viscosity(Temperature::from_si(t)).unwrap();
            assert!(checked.outside.is_empty());
            checked.value.si() * 1e6
        };
        // The double logarithm costs about three digits of the sixteen.
        assert!((nu(313.15) / 100.0 - 1.0).abs() < 1e-12);
        assert!((nu(373.15) / 11.2 - 1.0).abs() < 1e-12);
        assert!((nu(333.15) / 39.859_219_084_521_17 - 1.0).abs() < 1e-12);
    }

    #[test]
    fn the_temperature_coefficients_are_the_slopes_of_their_laws() {
        let (t, dt) = (Temperature::from_si(345.0), Temperature::from_si(0.01));
        let slope = |eta: &dyn Fn(Temperature) -> f64| {
            -(eta(t + dt) - eta(t - dt)) / (2.0 * dt.si()) / eta(t)
        };
        let astm = vg100();
        let vogel = Vogel {
            limit_viscosity: DynamicViscosity::from_si(86.86e-6),
            slope_kelvin: 890.0,
            pole_kelvin: 182.0,
        };
        let astm_slope = slope(&|t| astm.kinematic_viscosity(t).unwrap().value.si());
        let vogel_slope = slope(&|t| vogel.dynamic_viscosity(t).unwrap().si());
        // Central difference: error β³ dt²/6, about 1e-9, and cancellation 1e-11.
        assert!((astm.temperature_coefficient(t).unwrap().si() - astm_slope).abs() < 1e-8);
        assert!((vogel.temperature_coefficient(t).unwrap().si() - vogel_slope).abs() < 1e-8);
    }

    #[test]
    fn the_exponential_law_stays_within_a_tenth_of_astm_d341_over_20_kelvin() {
        let law = vg100();
        let at = Temperature::from_si(333.15);
        let local = GivenViscosity {
            viscosity: DynamicViscosity::from_si(
                law.kinematic_viscosity(at).unwrap().value.si() * 860.0,
            ),
            temperature: at,
            temperature_coefficient: law.temperature_coefficient(at).unwrap(),
        };
        for shift in [-20.0, 20.0] {
            let t = at + Temperature::from_si(shift);
            let exact = law.kinematic_viscosity(t).unwrap().value.si() * 860.0;
            let carried = local.dynamic_viscosity(t).unwrap();
            assert!(carried.outside.is_empty());
            let departure = (carried.value.si() / exact - 1.0).abs();
            assert!((0.05..0.15).contains(&departure), "{departure}");
        }
        let far = local.dynamic_viscosity(Temperature::from_si(380.0));
        assert_eq!(far.unwrap().outside.len(), 1);
    }

    #[test]
    fn impossible_oils_are_errors() {
        let nu = KinematicViscosity::from_si;
        assert!(AstmD341::from_data_sheet(nu(10e-6), nu(10e-6)).is_err());
        assert!(AstmD341::from_data_sheet(nu(10e-6), nu(0.3e-6)).is_err());
        assert!(AstmD341::from_data_sheet(nu(f64::NAN), nu(5e-6)).is_err());
        assert!(
            vg100()
                .kinematic_viscosity(Temperature::from_si(1.0))
                .is_err()
        );
        let vogel = Vogel {
            limit_viscosity: DynamicViscosity::from_si(1e-4),
            slope_kelvin: 900.0,
            pole_kelvin: 180.0,
        };
        assert!(
            vogel
                .dynamic_viscosity(Temperature::from_si(180.0))
                .is_err()
        );
    }
}
