//! Shear stress of an oil against its shear rate, at one pressure and one temperature.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | η, γ | viscosity, shear rate | Pa s, 1/s |
//! | τ₀ | Eyring stress | Pa |
//! | G, n | modulus and exponent of Carreau's law | Pa, - |
//! | τ_E, τ_L | stress without a limit, limiting stress | Pa |
//! | φ | fluidity η₀/η | - |
//! | y | shear rate of the sliding, Δu·η₀/(h·τ₀) or Δu·η₀/(h·G) | - |

use asperity_core::numerics::elementary::{exp, ln, ln_1p};
use asperity_core::quantity::Pressure;
use asperity_core::{DomainError, cite};
use serde::{Deserialize, Serialize};

/// Power m with which the stress approaches its limit (assumed).
pub const LIMIT_POWER: f64 = 4.0;

/// Name of a shear law; the oil gives its constants ([`TractionConstants::shear_law`](crate::TractionConstants::shear_law)).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
#[non_exhaustive]
pub enum ShearLawName {
    /// τ_E = τ₀ arsinh(η γ/τ₀).
    #[default]
    Eyring,
    /// τ_E = η γ (1 + (η γ/G)^a)^((n − 1)/a).
    Carreau,
    /// τ_E = η γ.
    Newton,
}

impl ShearLawName {
    /// Every shear law.
    pub const ALL: &[Self] = &[Self::Eyring, Self::Carreau, Self::Newton];

    /// The name in a case file.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Eyring => "eyring",
            Self::Carreau => "carreau",
            Self::Newton => "newton",
        }
    }
}

/// Shear law with its constants.
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

impl ShearLaw {
    /// Checks the constants.
    ///
    /// # Errors
    /// When a constant is outside its domain.
    pub fn validate(self) -> Result<(), DomainError> {
        match self {
            Self::Newtonian => {}
            Self::Eyring { stress } => {
                DomainError::positive("Eyring stress", stress)?;
            }
            Self::Carreau { modulus, exponent } => {
                DomainError::positive("modulus of Carreau's law", modulus)?;
                DomainError::require(
                    exponent > 0.0 && exponent <= 1.0,
                    "exponent of Carreau's law",
                    exponent,
                    "-",
                    "must lie above 0 and not above 1",
                )?;
            }
        }
        Ok(())
    }

    /// Shear stress \[Pa\] at a viscosity \[Pa s\] and a shear rate \[1/s\].
    ///
    /// ```
    /// use asperity_oil::ShearLaw;
    /// let law = ShearLaw::Eyring { stress: "5 MPa".parse()? };
    /// assert!((law.stress(10.0, 1e6) / (5e6 * 2f64.asinh()) - 1.0).abs() < 1e-15);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[inline]
    #[must_use]
    pub fn stress(self, viscosity: f64, shear_rate: f64) -> f64 {
        let newtonian = viscosity * shear_rate;
        match self {
            Self::Newtonian => newtonian,
            Self::Eyring { stress } => stress.si() * (newtonian / stress.si()).asinh(),
            Self::Carreau { modulus, exponent } => {
                let ratio = newtonian / modulus.si();
                newtonian * (1.0 + ratio * ratio).powf(0.5 * (exponent - 1.0))
            }
        }
    }

    /// Shear thinning of a film by its sliding, where `rate` gives y·h from the stress τ₀ or G \[Pa\].
    #[must_use]
    pub fn thinning(self, rate: impl Fn(f64) -> f64) -> ShearThinning {
        match self {
            Self::Newtonian => ShearThinning::None,
            Self::Eyring { stress } => {
                cite!("Tangent-Eyring");
                ShearThinning::Eyring {
                    rate: rate(stress.si()),
                }
            }
            Self::Carreau { modulus, exponent } => {
                cite!("Tangent-Carreau");
                ShearThinning::Carreau {
                    rate: rate(modulus.si()),
                    exponent,
                }
            }
        }
    }
}

/// Shear thinning by sliding over the scaled film.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ShearThinning {
    /// No thinning: Newton's law, or no sliding.
    None,
    /// Eyring's law.
    Eyring {
        /// y·h of the scaled film h.
        rate: f64,
    },
    /// Carreau's law.
    Carreau {
        /// y·h of the scaled film h.
        rate: f64,
        /// Exponent n.
        exponent: f64,
    },
}

/// Fluidity with its slopes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TangentFluidity {
    /// Fluidity.
    pub value: f64,
    /// Slope over the fluidity φ without sliding.
    pub by_fluidity: f64,
    /// Slope over the film.
    pub by_film: f64,
}

impl ShearThinning {
    /// Fluidity that the pressure gradient sees across a film sheared at a rate y, and its slopes over
    /// φ and the film.
    ///
    /// The Poiseuille flow is a small disturbance of the shear by sliding, in the same direction, so
    /// it sees the tangent viscosity dτ/dγ.
    ///
    /// ```text
    /// 1/(dτ/dγ) = √(φ² + y²)                                               [Tangent-Eyring]
    /// 1/(dτ/dγ) = φⁿ·(φ² + y²)^((3 − n)/2)/(φ² + n·y²)                     [Tangent-Carreau]
    /// ```
    #[inline]
    #[must_use]
    pub fn fluidity(self, phi: f64, film: f64) -> TangentFluidity {
        match self {
            Self::None => TangentFluidity {
                value: phi,
                by_fluidity: 1.0,
                by_film: 0.0,
            },
            Self::Eyring { rate } => {
                let y = rate / film;
                let value = phi.hypot(y);
                TangentFluidity {
                    value,
                    by_fluidity: phi / value,
                    by_film: -y * y / (value * film),
                }
            }
            Self::Carreau { rate, exponent } => {
                let (n, y) = (exponent, rate / film);
                let (square, mixed) = (phi * phi + y * y, phi * phi + n * y * y);
                let value = phi.powf(n) * square.powf(0.5 * (3.0 - n)) / mixed;
                let by_fluidity = value * (n / phi + (3.0 - n) * phi / square - 2.0 * phi / mixed);
                let by_rate = value * y * ((3.0 - n) / square - 2.0 * n / mixed);
                TangentFluidity {
                    value,
                    by_fluidity,
                    by_film: -by_rate * y / film,
                }
            }
        }
    }
}

/// Stress below a limit, τ = τ_E (1 + (τ_E/τ_L)⁴)^(−1/4): [`limited_stress_by`] with the power [`LIMIT_POWER`].
///
/// ```
/// use asperity_oil::limited_stress;
/// let [stress, slope] = limited_stress([5e6, 1.0], [50e6, 0.0]);
/// assert!((stress / 5e6 - 1.0).abs() < 1e-4 && slope > 0.999);
/// assert_eq!(limited_stress([5e6, 1.0], [0.0, 0.0]), [0.0, 0.0]);
/// ```
#[inline(always)]
#[must_use]
pub fn limited_stress(free: [f64; 2], limit: [f64; 2]) -> [f64; 2] {
    limited_stress_by(LIMIT_POWER, free, limit)
}

/// Stress below a limit, τ = τ_E (1 + (τ_E/τ_L)^m)^(−1/m) with the power m.
///
/// Both stresses with their slopes over some variable, and so is the result. The smaller stress is the factor in front, so
/// that no power overflows. A limit that is not positive gives 0.
#[inline(always)]
#[must_use]
pub fn limited_stress_by(
    power: f64,
    [free, free_slope]: [f64; 2],
    [limit, limit_slope]: [f64; 2],
) -> [f64; 2] {
    // Selections instead of branches: a loop over many compiles to lanes.
    let is_free = free < limit;
    let (small, large) = (free.min(limit), free.max(limit));
    let by_small = if is_free { free_slope } else { limit_slope };
    let by_large = if is_free { limit_slope } else { free_slope };
    let ratio = small / large;
    let (raised, root) = raised(ratio, power);
    let share = 1.0 / (root * (1.0 + raised));
    let [stress, slope] = [small / root, share * (by_small + raised * ratio * by_large)];
    if limit > 0.0 {
        [stress, slope]
    } else {
        [0.0, 0.0]
    }
}

/// r^m and (1 + r^m)^(1/m); the power 4 without a logarithm.
#[inline(always)]
fn raised(ratio: f64, power: f64) -> (f64, f64) {
    if power == LIMIT_POWER {
        let raised = (ratio * ratio) * (ratio * ratio);
        return (raised, (1.0 + raised).sqrt().sqrt());
    }
    let raised = exp(power * ln(ratio.max(f64::MIN_POSITIVE)));
    (raised, exp(ln_1p(raised) / power))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn slope(function: impl Fn(f64) -> f64, at: f64) -> f64 {
        let step = 1e-6 * at.abs();
        (function(at + step) - function(at - step)) / (2.0 * step)
    }

    #[test]
    fn the_fluidity_of_a_sliding_film_is_that_of_the_tangent() {
        // dτ/dγ by differences, with η = 1/φ and γ = y·τ₀.
        let phi = 0.03;
        let eyring = ShearLaw::Eyring {
            stress: Pressure::from_si(1.0),
        };
        let carreau = |exponent| ShearLaw::Carreau {
            modulus: Pressure::from_si(1.0),
            exponent,
        };
        for y in [0.001, 0.03, 0.4] {
            for law in [eyring, carreau(0.45)] {
                let tangent = slope(|g| law.stress(1.0 / phi, g), y);
                let fluidity = law.thinning(|_| y).fluidity(phi, 1.0).value;
                assert!((fluidity * tangent - 1.0).abs() < 1e-7, "{y}");
            }
            let unthinned = carreau(1.0).thinning(|_| y).fluidity(phi, 1.0).value;
            assert!((unthinned / phi - 1.0).abs() < 1e-14);
        }
    }

    #[test]
    fn slopes_of_the_fluidity_are_its_differences() {
        let laws = [
            ShearThinning::None,
            ShearThinning::Eyring { rate: 0.02 },
            ShearThinning::Carreau {
                rate: 0.02,
                exponent: 0.45,
            },
        ];
        for law in laws {
            let (phi, film) = (0.3, 0.07);
            let tangent = law.fluidity(phi, film);
            let by_fluidity = slope(|f| law.fluidity(f, film).value, phi);
            let by_film = slope(|h| law.fluidity(phi, h).value, film);
            assert!((tangent.by_fluidity / by_fluidity - 1.0).abs() < 1e-7);
            assert!((tangent.by_film - by_film).abs() < 1e-7 * tangent.value / film);
        }
    }

    #[test]
    fn slopes_of_the_limited_stress_are_its_differences() {
        for (free, limit) in [(3e6, 50e6), (49e6, 50e6), (51e6, 50e6), (4e8, 50e6)] {
            let by_free = slope(|free| limited_stress([free, 0.0], [limit, 0.0])[0], free);
            let by_limit = slope(|limit| limited_stress([free, 0.0], [limit, 0.0])[0], limit);
            assert!((limited_stress([free, 1.0], [limit, 0.0])[1] - by_free).abs() < 1e-7);
            assert!((limited_stress([free, 0.0], [limit, 1.0])[1] - by_limit).abs() < 1e-7);
            for power in [2.0, 5.5] {
                let by = |free, limit| limited_stress_by(power, free, limit);
                let by_free = slope(|free| by([free, 0.0], [limit, 0.0])[0], free);
                let by_limit = slope(|limit| by([free, 0.0], [limit, 0.0])[0], limit);
                assert!((by([free, 1.0], [limit, 0.0])[1] - by_free).abs() < 1e-7);
                assert!((by([free, 0.0], [limit, 1.0])[1] - by_limit).abs() < 1e-7);
            }
            // Both ways to the power 4 agree.
            let near = limited_stress_by(4.0 * (1.0 + f64::EPSILON), [free, 0.0], [limit, 0.0])[0];
            assert!((limited_stress([free, 0.0], [limit, 0.0])[0] / near - 1.0).abs() < 1e-14);
        }
    }
}
