//! Dimensionless laws of the oil on the scales of a contact, and its thinning by the sliding.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | φ | fluidity η₀/η | - |
//! | τ₀, G, n | Eyring stress; modulus and exponent of Carreau's law | Pa, Pa, - |
//! | y | shear rate of the sliding, Δu·η₀/(h·τ₀) or Δu·η₀/(h·G) | - |

use asperity_core::cite;

use crate::dimensionless::Scales;
use crate::rheology::{Density, Oil, ShearLaw, Viscosity};

/// Shear thinning by sliding over the scaled film.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Thinning {
    None,
    Eyring { rate: f64 },
    Carreau { rate: f64, exponent: f64 },
}

impl Thinning {
    /// Fluidity that the pressure gradient sees across a film sheared at a rate y, and its slopes over
    /// φ and y.
    ///
    /// The Poiseuille flow is a small disturbance of the shear by sliding, in the same direction, so
    /// it sees the tangent viscosity dτ/dγ.
    ///
    /// ```text
    /// 1/(dτ/dγ) = √(φ² + y²)                                               [Tangent-Eyring]
    /// 1/(dτ/dγ) = φⁿ·(φ² + y²)^((3 − n)/2)/(φ² + n·y²)                     [Tangent-Carreau]
    /// ```
    pub(crate) fn fluidity(self, phi: f64, film: f64) -> TangentFluidity {
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

/// Fluidity with its slopes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct TangentFluidity {
    pub(crate) value: f64,
    pub(crate) by_fluidity: f64,
    pub(crate) by_film: f64,
}

/// Dimensionless laws of one problem: P = p/p₀, H = h·R/a².
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Fluid {
    pub(crate) viscosity: Viscosity,
    pub(crate) density: Density,
    pub(crate) thinning: Thinning,
    /// λ of the Reynolds equation.
    pub(crate) speed: f64,
}

impl Fluid {
    /// The laws of `oil` on the scales of a contact.
    pub(crate) fn new(oil: &Oil, scales: &Scales) -> Self {
        let p_0 = scales.max_pressure.si();
        let sheared =
            |stress: f64| oil.viscosity.si() * scales.sliding.abs() / (scales.film * stress);
        let thinning = match oil.shear_law {
            _ if scales.sliding == 0.0 => Thinning::None,
            ShearLaw::Newtonian => Thinning::None,
            ShearLaw::Eyring { stress } => {
                cite!("Tangent-Eyring");
                Thinning::Eyring {
                    rate: sheared(stress.si()),
                }
            }
            ShearLaw::Carreau { modulus, exponent } => {
                cite!("Tangent-Carreau");
                Thinning::Carreau {
                    rate: sheared(modulus.si()),
                    exponent,
                }
            }
        };
        Self {
            viscosity: oil.viscosity_of(p_0),
            density: oil.density_of(p_0),
            thinning,
            speed: scales.speed,
        }
    }

    /// The same oil without shear thinning.
    pub(crate) fn newtonian(self) -> Self {
        Self {
            thinning: Thinning::None,
            ..self
        }
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
    fn the_fluidity_of_a_sliding_film_is_that_of_the_tangent() {
        // dτ/dγ by differences, with η = 1/φ and γ = y·τ₀.
        let phi = 0.03;
        for y in [0.001, 0.03, 0.4] {
            let eyring = slope(|g| (g / phi).asinh(), y);
            let found = Thinning::Eyring { rate: y }.fluidity(phi, 1.0).value;
            assert!((found * eyring - 1.0).abs() < 1e-7, "{y}");
            let carreau = slope(|g| g / phi * (1.0 + (g / phi).powi(2)).powf(-0.275), y);
            let law = Thinning::Carreau {
                rate: y,
                exponent: 0.45,
            };
            assert!(
                (law.fluidity(phi, 1.0).value * carreau - 1.0).abs() < 1e-7,
                "{y}"
            );
            let unthinned = Thinning::Carreau {
                rate: y,
                exponent: 1.0,
            };
            assert!((unthinned.fluidity(phi, 1.0).value / phi - 1.0).abs() < 1e-14);
        }
    }

    #[test]
    fn slopes_of_the_fluidity_are_its_differences() {
        let laws = [
            Thinning::None,
            Thinning::Eyring { rate: 0.02 },
            Thinning::Carreau {
                rate: 0.02,
                exponent: 0.45,
            },
        ];
        for law in laws {
            let (phi, film) = (0.3, 0.07);
            let found = law.fluidity(phi, film);
            let by_fluidity = slope(|f| law.fluidity(f, film).value, phi);
            let by_film = slope(|h| law.fluidity(phi, h).value, film);
            assert!((found.by_fluidity / by_fluidity - 1.0).abs() < 1e-7);
            assert!((found.by_film - by_film).abs() < 1e-7 * found.value / film);
        }
    }
}
