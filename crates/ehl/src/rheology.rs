//! Viscosity, density and shear law of the oil in the film.
//!
//! Roelands' exponent is free here: the slope α at ambient pressure and the bend z are given apart,
//! whereas `asperity_oil::roelands` derives z from α and η₀.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | η₀, α | viscosity at ambient pressure, its logarithmic slope there | Pa s, 1/Pa |
//! | z, p_r | Roelands' exponent and pressure, 1/p_r = 5.1·10⁻⁹ 1/Pa | -, Pa |
//! | τ₀, G, n | Eyring stress; modulus and exponent of Carreau's law | Pa, Pa, - |

use asperity_core::quantity::{DynamicViscosity, Pressure, PressureViscosity};
use asperity_core::{DomainError, cite};
use serde::{Deserialize, Serialize};

/// Roelands' constant 1/p_r (Roelands 1966) \[1/Pa\].
const ROELANDS_PER_PASCAL: f64 = 5.1e-9;
/// Coefficient of the numerator of the density (Dowson and Higginson 1966) \[1/Pa\].
const DENSITY_RISE: f64 = 0.6e-9;
/// Coefficient of the denominator of the density (Dowson and Higginson 1966) \[1/Pa\].
const DENSITY_BEND: f64 = 1.7e-9;

/// Law of viscosity against pressure.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ViscosityLaw {
    /// The same viscosity at every pressure.
    Isoviscous,
    /// η = η₀·exp(α·p).
    Barus,
    /// ln(η/η₀) = (α·p_r/z)·((1 + p/p_r)^z − 1) with a free exponent z.
    Roelands {
        /// Exponent z, 0 < z ≤ 1.
        exponent: f64,
    },
}

/// Density over pressure.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum DensityLaw {
    /// The same density at every pressure.
    Incompressible,
    /// ρ = ρ₀·(1 + 0.6·10⁻⁹·p/(1 + 1.7·10⁻⁹·p)).
    DowsonHigginson,
}

/// Shear thinning of the film by the sliding of the surfaces.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ShearLaw {
    /// Stress in proportion to the shear rate.
    Newtonian,
    /// τ = τ₀·arsinh(η·γ/τ₀).
    Eyring {
        /// Eyring stress τ₀.
        stress: Pressure,
    },
    /// τ = η·γ·(1 + (η·γ/G)²)^((n − 1)/2).
    Carreau {
        /// Modulus G.
        modulus: Pressure,
        /// Exponent n, 0 < n ≤ 1.
        exponent: f64,
    },
}

/// Oil of a lubricated contact at the temperature of its inlet.
///
/// ```
/// use asperity_ehl::{DensityLaw, Oil, ShearLaw, ViscosityLaw};
/// let oil = Oil {
///     viscosity: "10 mPa s".parse()?,
///     pressure_viscosity: "18 1/GPa".parse()?,
///     viscosity_law: ViscosityLaw::Roelands { exponent: 0.6 },
///     density_law: DensityLaw::DowsonHigginson,
///     shear_law: ShearLaw::Eyring { stress: "5 MPa".parse()? },
/// };
/// assert!((oil.relative_viscosity("1 GPa".parse()?)?.ln() - 11.526).abs() < 1e-3);
/// assert!((oil.relative_density("1 GPa".parse()?)? - 1.2222).abs() < 1e-4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Oil {
    /// Viscosity η₀ at ambient pressure.
    pub viscosity: DynamicViscosity,
    /// Pressure-viscosity coefficient α; unused by an isoviscous oil.
    pub pressure_viscosity: PressureViscosity,
    /// Law of viscosity against pressure.
    pub viscosity_law: ViscosityLaw,
    /// Density over pressure.
    pub density_law: DensityLaw,
    /// Shear thinning.
    pub shear_law: ShearLaw,
}

impl Oil {
    /// Checks every constant of the oil.
    ///
    /// # Errors
    /// When a constant is outside its domain.
    pub fn validate(&self) -> Result<(), DomainError> {
        DomainError::positive("viscosity", self.viscosity)?;
        if self.viscosity_law != ViscosityLaw::Isoviscous {
            DomainError::positive("pressure-viscosity coefficient", self.pressure_viscosity)?;
        }
        if let ViscosityLaw::Roelands { exponent } = self.viscosity_law {
            within_unit("Roelands' exponent", exponent)?;
        }
        match self.shear_law {
            ShearLaw::Newtonian => {}
            ShearLaw::Eyring { stress } => {
                DomainError::positive("Eyring stress", stress)?;
            }
            ShearLaw::Carreau { modulus, exponent } => {
                DomainError::positive("modulus of Carreau's law", modulus)?;
                within_unit("exponent of Carreau's law", exponent)?;
            }
        }
        Ok(())
    }

    /// η(p)/η₀ without shear.
    ///
    /// # Errors
    /// When a constant is outside its domain or the pressure is negative.
    pub fn relative_viscosity(&self, pressure: Pressure) -> Result<f64, DomainError> {
        self.validate()?;
        let p = DomainError::non_negative("pressure", pressure)?;
        Ok(self.viscosity_of(1.0).log(p).0.exp())
    }

    /// ρ(p)/ρ₀.
    ///
    /// # Errors
    /// When the pressure is negative.
    pub fn relative_density(&self, pressure: Pressure) -> Result<f64, DomainError> {
        let p = DomainError::non_negative("pressure", pressure)?;
        Ok(self.density_of(1.0).relative(p).0)
    }

    /// Viscosity law over the pressure in units of `unit`.
    ///
    /// ```text
    /// ln(η/η₀) = (α·p_r/z)·((1 + p/p_r)^z − 1)                            [Roelands-free]
    /// ```
    pub(crate) fn viscosity_of(&self, unit: f64) -> Viscosity {
        let slope = self.pressure_viscosity.si() * unit;
        match self.viscosity_law {
            ViscosityLaw::Isoviscous => Viscosity::Constant,
            ViscosityLaw::Barus => Viscosity::Exponential { slope },
            ViscosityLaw::Roelands { exponent } => {
                cite!("Roelands-free");
                Viscosity::Power {
                    slope,
                    bend: ROELANDS_PER_PASCAL * unit,
                    exponent,
                }
            }
        }
    }

    /// Density law over the pressure in units of `unit`.
    pub(crate) fn density_of(&self, unit: f64) -> Density {
        match self.density_law {
            DensityLaw::Incompressible => Density {
                rise: 0.0,
                bend: 0.0,
            },
            DensityLaw::DowsonHigginson => Density {
                rise: DENSITY_RISE * unit,
                bend: DENSITY_BEND * unit,
            },
        }
    }
}

fn within_unit(name: &'static str, value: f64) -> Result<f64, DomainError> {
    DomainError::require(
        value > 0.0 && value <= 1.0,
        name,
        value,
        "-",
        "must lie above 0 and not above 1",
    )
}

/// Logarithm of the relative viscosity over a scaled pressure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Viscosity {
    Constant,
    Exponential {
        slope: f64,
    },
    Power {
        slope: f64,
        bend: f64,
        exponent: f64,
    },
}

impl Viscosity {
    /// ln(η/η₀) and its slope; a negative pressure counts as zero.
    pub(crate) fn log(&self, pressure: f64) -> (f64, f64) {
        let p = pressure.max(0.0);
        match *self {
            Self::Constant => (0.0, 0.0),
            Self::Exponential { slope } => (slope * p, slope),
            Self::Power {
                slope,
                bend,
                exponent,
            } => {
                let base = 1.0 + bend * p;
                let power = base.powf(exponent - 1.0);
                let log = slope / (bend * exponent) * (power * base - 1.0);
                (log, slope * power)
            }
        }
    }
}

/// Relative density over a scaled pressure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Density {
    rise: f64,
    bend: f64,
}

impl Density {
    /// ρ/ρ₀ and its slope; a negative pressure counts as zero.
    pub(crate) fn relative(&self, pressure: f64) -> (f64, f64) {
        let p = pressure.max(0.0);
        let below = 1.0 + self.bend * p;
        (1.0 + self.rise * p / below, self.rise / (below * below))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn slope(function: impl Fn(f64) -> f64, at: f64) -> f64 {
        let step = 1e-6 * at.abs();
        (function(at + step) - function(at - step)) / (2.0 * step)
    }

    #[test]
    fn roelands_with_free_exponent_starts_with_alpha_and_tends_to_barus() {
        let law = |exponent| Viscosity::Power {
            slope: 21.6,
            bend: 6.12,
            exponent,
        };
        assert!((law(0.6).log(1e-9).0 / 21.6e-9 - 1.0).abs() < 1e-6);
        assert!((law(1.0).log(0.7).0 - 21.6 * 0.7).abs() < 1e-12);
        // 1.2 GPa, α 18 1/GPa, z 0.6: 21.6/(6.12·0.6)·(7.12^0.6 − 1).
        assert!((law(0.6).log(1.0).0 - 13.2179).abs() < 1e-3);
        for exponent in [0.4, 0.6, 0.9] {
            let law = law(exponent);
            assert!((law.log(0.8).1 / slope(|p| law.log(p).0, 0.8) - 1.0).abs() < 1e-8);
        }
    }
}
