//! Viscosity over pressure.
//!
//! Barus' exponential is right in slope at zero pressure and far too steep beyond about half a
//! gigapascal; Roelands' form bends it over. Both have the same slope α at zero pressure.
//! Roelands' exponent follows from α and η₀ ([`roelands_exponent`]), or is given
//! ([`PressureViscosityLaw::Roelands`]).
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | η₀ | viscosity at ambient pressure | Pa s |
//! | α | pressure-viscosity coefficient, d(ln η)/dp at p = 0 | 1/Pa |
//! | p | pressure | Pa |
//! | Z, z | Roelands' exponent from α and η₀, and given | - |
//! | p_r | Roelands' pressure, 1/p_r = 5.1·10⁻⁹ 1/Pa | Pa |
//! | T, T₀ | temperature, and where η₀ and α hold | K |
//! | β | −(dη/dT)/η at T₀ and ambient pressure | 1/K |

use asperity_core::quantity::{
    DynamicViscosity, PerKelvin, Pressure, PressureViscosity, Temperature,
};
use asperity_core::{Checked, DomainError, FittedRange, cite};
use serde::{Deserialize, Serialize};

/// Roelands' constant 1/p_r = 5.1·10⁻⁹ 1/Pa (Roelands 1966).
pub(crate) const ROELANDS_PER_PASCAL: f64 = 5.1e-9;
/// Roelands' constant −ln η_r with η_r = 6.31·10⁻⁵ Pa s (Roelands 1966).
pub(crate) const ROELANDS_LOG: f64 = 9.67;
/// Temperature at which Roelands' law ends (Roelands 1966) \[K\].
const ROELANDS_ZERO: f64 = 138.0;
/// Largest exponent α·p of Barus' law below a limiting shear stress: beyond it the shear stress is the limit.
pub const LARGEST_BARUS_EXPONENT: f64 = 40.0;
/// Range in which Barus' law has no serious error (Stachowiak and Batchelor 2014).
const BARUS_RANGE: FittedRange = FittedRange::new("pressure", 0.0, 0.5, "GPa", "Barus");
const PASCAL_PER_GPA: f64 = 1e9;

/// η(p) = η₀·exp(α·p)                                                        [Barus-1]
///
/// Pressures above 0.5 GPa are noted: there the law overrates the viscosity by decades.
///
/// # Errors
/// When the viscosity or α is not positive, the pressure is negative, or η(p) is not finite.
///
/// ```
/// use asperity_oil::barus;
/// let eta = barus("97.5 mPa s".parse()?, "2e-8 1/Pa".parse()?, "0.6 GPa".parse()?)?;
/// assert!((eta.value.si() - 15_868.592).abs() < 1e-3 && eta.outside.len() == 1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn barus(
    viscosity: DynamicViscosity,
    pressure_viscosity: PressureViscosity,
    pressure: Pressure,
) -> Result<Checked<DynamicViscosity>, DomainError> {
    cite!("Barus-1");
    let eta0 = DomainError::positive("viscosity", viscosity)?;
    let alpha = DomainError::positive("pressure-viscosity coefficient", pressure_viscosity)?;
    let p = DomainError::non_negative("pressure", pressure)?;
    let mut outside = Vec::new();
    BARUS_RANGE.check(p / PASCAL_PER_GPA, &mut outside);
    Ok(Checked {
        value: finite(eta0 * (alpha * p).exp(), p)?,
        outside,
    })
}

/// Z = α/(5.1·10⁻⁹·(ln η₀ + 9.67))                                           [Roelands-1]
///
/// # Errors
/// When α is not positive, or the viscosity is not above 6.31·10⁻⁵ Pa s, where the form ends.
///
/// ```
/// use asperity_oil::roelands_exponent;
/// let z = roelands_exponent("97.5 mPa s".parse()?, "2e-8 1/Pa".parse()?)?;
/// assert!((z - 0.5341210521410198).abs() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn roelands_exponent(
    viscosity: DynamicViscosity,
    pressure_viscosity: PressureViscosity,
) -> Result<f64, DomainError> {
    cite!("Roelands-1");
    let alpha = DomainError::positive("pressure-viscosity coefficient", pressure_viscosity)?;
    Ok(alpha / (ROELANDS_PER_PASCAL * roelands_log(viscosity)?))
}

/// η(p) = η₀·exp((ln η₀ + 9.67)·((1 + 5.1·10⁻⁹·p)^Z − 1))                      [Roelands-2]
///
/// # Errors
/// When α is not positive, the pressure is negative, the viscosity is not above
/// 6.31·10⁻⁵ Pa s, or η(p) is not finite.
///
/// ```
/// use asperity_oil::roelands;
/// let eta = roelands("97.5 mPa s".parse()?, "2e-8 1/Pa".parse()?, "0.6 GPa".parse()?)?;
/// assert!((eta.si() - 346.676).abs() < 1e-3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn roelands(
    viscosity: DynamicViscosity,
    pressure_viscosity: PressureViscosity,
    pressure: Pressure,
) -> Result<DynamicViscosity, DomainError> {
    cite!("Roelands-2");
    let p = DomainError::non_negative("pressure", pressure)?;
    let z = roelands_exponent(viscosity, pressure_viscosity)?;
    finite(
        viscosity.si() * (roelands_log(viscosity)? * roelands_growth(z, p)).exp(),
        p,
    )
}

/// (1 + 5.1·10⁻⁹·p)^Z − 1, through `ln_1p` and `exp_m1`: no digit is lost at small pressures.
pub(crate) fn roelands_growth(exponent: f64, pressure: f64) -> f64 {
    (exponent * (ROELANDS_PER_PASCAL * pressure).ln_1p()).exp_m1()
}

/// ln η₀ + 9.67, which must be positive.
fn roelands_log(viscosity: DynamicViscosity) -> Result<f64, DomainError> {
    let eta0 = DomainError::positive("viscosity", viscosity)?;
    let log = eta0.ln() + ROELANDS_LOG;
    DomainError::require(
        log > 0.0,
        "viscosity",
        eta0,
        "Pa s",
        "must be above 6.31e-5 Pa s for Roelands' law",
    )?;
    Ok(log)
}

fn finite(viscosity: f64, pressure: f64) -> Result<DynamicViscosity, DomainError> {
    DomainError::require(
        viscosity.is_finite(),
        "pressure",
        pressure,
        "Pa",
        "is too high for a finite viscosity",
    )?;
    Ok(DynamicViscosity::from_si(viscosity))
}

/// Law of viscosity against pressure in the film.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
#[non_exhaustive]
pub enum PressureLaw {
    /// η = η₀ exp(min(α p, 40)).
    #[default]
    Barus,
    /// Roelands, with the exponent that gives α at ambient pressure.
    Roelands,
}

impl PressureLaw {
    /// The name in a case file.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Barus => "barus",
            Self::Roelands => "roelands",
        }
    }
}

/// Pressure-viscosity law with its constants, except α.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum PressureViscosityLaw {
    /// The same viscosity at every pressure.
    Isoviscous,
    /// η = η₀·exp(α·p).
    Barus,
    /// ln(η/η₀) = (α·p_r/z)·((1 + p/p_r)^z − 1) with a given exponent z.
    Roelands {
        /// Exponent z, 0 < z ≤ 1.
        exponent: f64,
    },
}

impl PressureViscosityLaw {
    /// Checks α, which an isoviscous oil does not use, and the exponent.
    ///
    /// # Errors
    /// When a constant is outside its domain.
    pub fn validate(self, pressure_viscosity: PressureViscosity) -> Result<(), DomainError> {
        if self != Self::Isoviscous {
            DomainError::positive("pressure-viscosity coefficient", pressure_viscosity)?;
        }
        if let Self::Roelands { exponent } = self {
            DomainError::require(
                exponent > 0.0 && exponent <= 1.0,
                "Roelands' exponent",
                exponent,
                "-",
                "must lie above 0 and not above 1",
            )?;
        }
        Ok(())
    }

    /// The law over the pressure in units of `unit` \[Pa\].
    ///
    /// ```text
    /// ln(η/η₀) = (α·p_r/z)·((1 + p/p_r)^z − 1)                            [Roelands-free]
    /// ```
    ///
    /// ```
    /// use asperity_oil::PressureViscosityLaw;
    /// let law = PressureViscosityLaw::Roelands { exponent: 0.6 };
    /// let [log, _] = law.relative("18 1/GPa".parse()?, 1e9).log(1.0);
    /// assert!((log - 11.526).abs() < 1e-3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn relative(self, pressure_viscosity: PressureViscosity, unit: f64) -> RelativeViscosity {
        let slope = pressure_viscosity.si() * unit;
        match self {
            Self::Isoviscous => RelativeViscosity::Constant,
            Self::Barus => RelativeViscosity::Exponential { slope },
            Self::Roelands { exponent } => {
                cite!("Roelands-free");
                RelativeViscosity::Power {
                    slope,
                    bend: ROELANDS_PER_PASCAL * unit,
                    exponent,
                }
            }
        }
    }
}

/// Logarithm of the relative viscosity η/η₀ over a scaled pressure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RelativeViscosity {
    /// ln(η/η₀) = 0.
    Constant,
    /// ln(η/η₀) = slope·p.
    Exponential {
        /// α in units of the pressure.
        slope: f64,
    },
    /// ln(η/η₀) = slope/(bend·exponent)·((1 + bend·p)^exponent − 1).
    Power {
        /// α in units of the pressure.
        slope: f64,
        /// 1/p_r in units of the pressure.
        bend: f64,
        /// Exponent z.
        exponent: f64,
    },
}

impl RelativeViscosity {
    /// ln(η/η₀) and its slope; a negative pressure counts as zero.
    #[inline]
    #[must_use]
    pub fn log(&self, pressure: f64) -> [f64; 2] {
        let p = pressure.max(0.0);
        match *self {
            Self::Constant => [0.0, 0.0],
            Self::Exponential { slope } => [slope * p, slope],
            Self::Power {
                slope,
                bend,
                exponent,
            } => {
                let base = 1.0 + bend * p;
                let power = base.powf(exponent - 1.0);
                let log = slope / (bend * exponent) * (power * base - 1.0);
                [log, slope * power]
            }
        }
    }
}

/// Relative viscosity at temperatures above T₀: Roelands' law over pressure and temperature, or exponential over
/// temperature where the law over pressure is not Roelands'.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HeatedViscosity {
    relative: RelativeViscosity,
    /// T₀ \[K\].
    reference: f64,
    /// β \[1/K\].
    coefficient: f64,
    /// Exponent s; 0 where the law over pressure is not Roelands'.
    exponent: f64,
}

impl HeatedViscosity {
    /// The law with the temperature coefficient β at T₀; `relative` is over the pressure in Pa.
    ///
    /// # Errors
    /// When T₀ is not above 138 K, or β is not positive.
    pub fn new(
        relative: RelativeViscosity,
        reference: Temperature,
        coefficient: PerKelvin,
    ) -> Result<Self, DomainError> {
        cite!("Roelands-thermal");
        let reference = DomainError::positive("bulk temperature", reference)?;
        let coefficient = DomainError::positive("temperature coefficient", coefficient)?;
        DomainError::require(
            reference > ROELANDS_ZERO,
            "bulk temperature",
            reference,
            "K",
            "must be above 138 K for Roelands' law",
        )?;
        // ln(η/η₀) + A scales as ((T − 138)/(T₀ − 138))^−s with s·A = β·(T₀ − 138).
        let exponent = match relative {
            RelativeViscosity::Power {
                slope,
                bend,
                exponent,
            } => coefficient * (reference - ROELANDS_ZERO) / (slope / (bend * exponent)),
            RelativeViscosity::Constant | RelativeViscosity::Exponential { .. } => 0.0,
        };
        Ok(Self {
            relative,
            reference,
            coefficient,
            exponent,
        })
    }

    /// ln(η/η₀) at a pressure \[Pa\] and a temperature `rise` \[K\] above T₀.
    ///
    /// ```text
    /// ln(η/η₀) + A = A·(1 + p/p_r)^z·((T − 138)/(T₀ − 138))^−s,  A = α·p_r/z       [Roelands-thermal]
    /// ```
    #[must_use]
    pub fn log(&self, pressure: f64, rise: f64) -> f64 {
        let log = self.relative.log(pressure)[0];
        if self.exponent == 0.0 {
            return log - self.coefficient * rise;
        }
        let above_zero = self.reference - ROELANDS_ZERO;
        let base = self.coefficient * above_zero / self.exponent;
        let cooled = ((self.reference + rise - ROELANDS_ZERO) / above_zero).powf(-self.exponent);
        (log + base) * cooled - base
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ETA0: DynamicViscosity = DynamicViscosity::from_si(0.0975);
    const ALPHA: PressureViscosity = PressureViscosity::from_si(2e-8);

    #[test]
    fn roelands_and_barus_hit_the_reference_case() {
        // The paper's oil at 0.6 GPa, recomputed independently in double precision.
        let p = Pressure::from_si(0.6e9);
        let r = roelands(ETA0, ALPHA, p).unwrap().si();
        assert!((r / 346.676_116_367_33 - 1.0).abs() < 1e-12);
        let b = barus(ETA0, ALPHA, p).unwrap().value.si();
        assert!((b / 15_868.592_163_352_881 - 1.0).abs() < 1e-12);
    }

    #[test]
    fn both_laws_start_with_the_slope_alpha() {
        // A second-order term of (α p)² or less remains of the relative slope.
        let p = Pressure::from_si(1e3);
        for eta in [
            roelands(ETA0, ALPHA, p).unwrap(),
            barus(ETA0, ALPHA, p).unwrap().value,
        ] {
            let slope = (eta.si() / ETA0.si()).ln() / p.si();
            assert!((slope / ALPHA.si() - 1.0).abs() < 1e-5);
        }
        let none = Pressure::from_si(0.0);
        assert_eq!(roelands(ETA0, ALPHA, none).unwrap(), ETA0);
        assert_eq!(barus(ETA0, ALPHA, none).unwrap().value, ETA0);
    }

    #[test]
    fn runaway_viscosities_and_nonsense_are_errors() {
        assert!(barus(ETA0, ALPHA, Pressure::from_si(1e12)).is_err());
        assert!(roelands(ETA0, ALPHA, Pressure::from_si(-1.0)).is_err());
        assert!(roelands_exponent(DynamicViscosity::from_si(5e-5), ALPHA).is_err());
        assert!(
            barus(
                ETA0,
                PressureViscosity::from_si(f64::NAN),
                Pressure::from_si(1.0)
            )
            .is_err()
        );
    }

    #[test]
    fn roelands_with_free_exponent_starts_with_alpha_and_tends_to_barus() {
        let law = |exponent| RelativeViscosity::Power {
            slope: 21.6,
            bend: 6.12,
            exponent,
        };
        assert!((law(0.6).log(1e-9)[0] / 21.6e-9 - 1.0).abs() < 1e-6);
        assert!((law(1.0).log(0.7)[0] - 21.6 * 0.7).abs() < 1e-12);
        // 1.2 GPa, α 18 1/GPa, z 0.6: 21.6/(6.12·0.6)·(7.12^0.6 − 1).
        assert!((law(0.6).log(1.0)[0] - 13.2179).abs() < 1e-3);
        for exponent in [0.4, 0.6, 0.9] {
            let law = law(exponent);
            let difference = (law.log(0.8 + 1e-6)[0] - law.log(0.8 - 1e-6)[0]) / 2e-6;
            assert!((law.log(0.8)[1] / difference - 1.0).abs() < 1e-8);
        }
    }

    #[test]
    fn both_forms_of_roelands_law_agree_where_the_exponent_is_that_of_alpha() {
        let exponent = roelands_exponent(ETA0, ALPHA).unwrap();
        let law = PressureViscosityLaw::Roelands { exponent }.relative(ALPHA, 1.0);
        for p in [0.0, 1e6, 0.4e9, 2e9] {
            let law_value = law.log(p)[0];
            let derived = (roelands(ETA0, ALPHA, Pressure::from_si(p)).unwrap() / ETA0).ln();
            // 1 is subtracted from a number close to it.
            assert!(
                (law_value - derived).abs() < 1e-13 * derived.max(10.0),
                "{p}"
            );
        }
    }
}
