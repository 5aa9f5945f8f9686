//! Removal of the form of a flank.
//!
//! Source: least-squares fits; with orthogonal polynomials on an even grid each coefficient is a projection, so the fit
//! needs no system of equations.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | t | position on the trace, −1 at its start and 1 at its end | - |
//! | z | height | m |
//! | c_k | coefficient of the polynomial of degree k | m |
//! | R | radius of the circle | m |

use asperity_core::cite;
use asperity_core::quantity::Length;
use asperity_core::{DomainError, Profile};
use serde::de::IntoDeserializer;
use serde::{Deserialize, Serialize};

use crate::error::RoughnessError;

/// Maximum degree of a fitted polynomial.
const MAX_DEGREE: usize = 2;

/// The form to remove.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
#[non_exhaustive]
pub enum Form {
    /// No removal, not even of the mean height.
    None,
    /// The mean height (degree 0).
    Mean,
    /// The least-squares line (degree 1).
    #[default]
    Level,
    /// The least-squares parabola (degree 2), for flanks with crowning.
    Poly2,
    /// The least-squares circle, for strongly curved traces.
    Circle,
}

impl std::str::FromStr for Form {
    type Err = serde::de::value::Error;

    fn from_str(name: &str) -> Result<Self, Self::Err> {
        Self::deserialize(name.into_deserializer())
    }
}

/// A polynomial of degree two or less in the orthogonal basis 1, t, t² − ⟨t²⟩.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct Polynomial {
    /// Coefficients c₀, c₁, c₂ `[m]`; those above the degree are zero.
    pub coefficients: [f64; 3],
    /// Number of points of the grid.
    pub points: usize,
}

impl Polynomial {
    /// One polynomial of the basis, times `coefficient` `[m]`.
    pub(crate) fn of_power(power: usize, coefficient: f64, points: usize) -> Self {
        let mut coefficients = [0.0; 3];
        coefficients[power] = coefficient;
        Self {
            coefficients,
            points,
        }
    }

    /// Height at point `i` `[m]`.
    pub fn at(&self, i: usize) -> f64 {
        let [c0, c1, c2] = self.coefficients;
        let t = position(i, self.points);
        c0 + c1 * t + c2 * (t * t - mean_square(self.points))
    }

    /// Height of the parabola between its apex and the ends, |c₂| `[m]`.
    pub fn sag(&self) -> Length {
        Length::from_si(self.coefficients[2].abs())
    }
}

fn position(i: usize, n: usize) -> f64 {
    if n < 2 {
        0.0
    } else {
        (2 * i) as f64 / (n - 1) as f64 - 1.0
    }
}

/// ⟨t²⟩ = (n + 1)/(3 (n − 1)) over n even points from −1 to 1.
fn mean_square(n: usize) -> f64 {
    if n < 2 {
        0.0
    } else {
        (n + 1) as f64 / (3 * (n - 1)) as f64
    }
}

/// min over c of Σ (zᵢ − Σₖ cₖ pₖ(tᵢ))², pₖ orthogonal                           [Form-1]
///
/// c_k = Σ zᵢ pₖ(tᵢ) / Σ pₖ(tᵢ)²; `degree` is 0, 1 or 2.
///
/// # Errors
/// When the degree is above 2, or the number of points does not exceed the degree.
///
/// ```
/// use asperity_roughness::form::fit;
/// let line = fit(&[1.0, 3.0, 5.0], 1)?;
/// assert!((line.at(0) - 1.0).abs() < 1e-15 && (line.at(2) - 5.0).abs() < 1e-15);
/// # Ok::<(), asperity_roughness::RoughnessError>(())
/// ```
pub fn fit(heights: &[f64], degree: usize) -> Result<Polynomial, RoughnessError> {
    cite!("Form-1");
    let n = heights.len();
    DomainError::require(
        degree <= MAX_DEGREE,
        "degree",
        degree as f64,
        "-",
        "must be 0, 1 or 2",
    )?;
    RoughnessError::at_least(n, degree + 1, "fitting the form")?;
    let square = mean_square(n);
    let basis = |k: usize, t: f64| match k {
        0 => 1.0,
        1 => t,
        _ => t * t - square,
    };
    let mut coefficients = [0.0; 3];
    // Projecting the residual preserves the accuracy of small terms with a large offset.
    let mean = heights.iter().sum::<f64>() / n as f64;
    coefficients[0] = mean + heights.iter().map(|z| z - mean).sum::<f64>() / n as f64;
    for k in 1..=degree {
        let (mut product, mut norm) = (0.0, 0.0);
        for (i, z) in heights.iter().enumerate() {
            let p = basis(k, position(i, n));
            product += (z - coefficients[0]) * p;
            norm += p * p;
        }
        coefficients[k] = product / norm;
    }
    Ok(Polynomial {
        coefficients,
        points: n,
    })
}

/// Removes the form from a profile.
///
/// # Errors
/// When the profile has too few points for the fit, or the circle does not converge.
///
/// ```
/// use asperity_core::{Profile, quantity::Length};
/// use asperity_roughness::form::{Form, remove};
/// let tilted = Profile::new(Length::from_si(1e-6), (0..100).map(|i| 0.1 + 1e-9 * i as f64).collect())?;
/// let level = remove(&tilted, Form::Level)?;
/// assert!(level.heights().iter().all(|z| z.abs() < 1e-16));
/// # Ok::<(), asperity_roughness::RoughnessError>(())
/// ```
pub fn remove(profile: &Profile, form: Form) -> Result<Profile, RoughnessError> {
    let z = profile.heights();
    let residual = match form {
        Form::None => return Ok(profile.clone()),
        Form::Mean | Form::Level | Form::Poly2 => {
            let degree = match form {
                Form::Mean => 0,
                Form::Level => 1,
                _ => 2,
            };
            let fitted = fit(z, degree)?;
            z.iter()
                .enumerate()
                .map(|(i, z)| z - fitted.at(i))
                .collect()
        }
        Form::Circle => circle_residual(profile)?,
    };
    Ok(Profile::new(profile.spacing(), residual)?)
}

/// z(x) = c₀ + c₁ x ± (√(R² − x²) − R), fitted to the heights by Gauss-Newton       [Form-2]
///
/// x is measured from the middle of the trace, the curvature κ = ±1/R is the unknown, and
/// √(R² − x²) − R = −κ x²/(1 + √(1 − κ² x²)), which also holds for a flat trace.
fn circle_residual(profile: &Profile) -> Result<Vec<f64>, RoughnessError> {
    cite!("Form-2");
    const MAX_ITERATIONS: usize = 50;
    // Convergence criterion: relative change of the curvature.
    const TOLERANCE: f64 = 1e-12;
    let z = profile.heights();
    let parabola = fit(z, 2)?;
    let half = 0.5 * profile.length().si();
    let mut curvature = -2.0 * parabola.coefficients[2] / (half * half);
    // The smallest circle that spans the trace.
    let steepest = 0.999 / half;
    let mut residual = 1.0;
    for _ in 0..MAX_ITERATIONS {
        curvature = curvature.clamp(-steepest, steepest);
        let (arc, slope) = arc_and_slope(z.len(), half, curvature);
        // Offset and tilt are linear and fitted exactly; only the curvature is iterated.
        let rest: Vec<f64> = z.iter().zip(&arc).map(|(z, arc)| z - arc).collect();
        let line = fit(&rest, 1)?;
        let tangent = fit(&slope, 1)?;
        let (mut product, mut norm) = (0.0, 0.0);
        for (i, (rest, slope)) in rest.iter().zip(&slope).enumerate() {
            let s = slope - tangent.at(i);
            product += (rest - line.at(i)) * s;
            norm += s * s;
        }
        let step = if norm > 0.0 { product / norm } else { 0.0 };
        residual = step.abs() / curvature.abs().max(f64::MIN_POSITIVE);
        curvature += step;
        // On a flat trace a step has converged if it changes no height by more than its rounding error.
        let moved = step.abs() * half * half;
        let scale = z.iter().fold(0.0_f64, |m, z| m.max(z.abs()));
        if residual < TOLERANCE || moved <= f64::EPSILON * scale {
            return Ok(rest
                .iter()
                .enumerate()
                .map(|(i, rest)| rest - line.at(i))
                .collect());
        }
    }
    Err(RoughnessError::NotConverged {
        what: "the circle fit",
        iterations: MAX_ITERATIONS,
        residual,
    })
}

/// Heights of the arc above its apex, and their derivatives with respect to the curvature.
fn arc_and_slope(n: usize, half: f64, curvature: f64) -> (Vec<f64>, Vec<f64>) {
    (0..n)
        .map(|i| {
            let x = half * position(i, n);
            let root = (1.0 - (curvature * x).powi(2)).sqrt();
            let arc = -curvature * x * x / (1.0 + root);
            (arc, -x * x / (root * (1.0 + root)))
        })
        .unzip()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_polynomial_is_removed_to_the_last_digits() {
        let z = |i: usize| 0.1066 + 3e-8 * i as f64 - 2e-11 * (i * i) as f64;
        let spacing = Length::from_si(0.5e-6);
        let profile = Profile::new(spacing, (0..5000).map(z).collect()).unwrap();
        let left = remove(&profile, Form::Poly2).unwrap();
        let largest = left.heights().iter().fold(0.0_f64, |m, z| m.max(z.abs()));
        // Heights of 0.1 m carry an error of 1.4e-17 each.
        assert!(largest < 1e-15, "{largest:e}");
    }

    #[test]
    fn a_degree_above_two_is_refused() {
        assert!(fit(&[1.0; 20], 2).is_ok());
        assert!(matches!(fit(&[1.0; 20], 3), Err(RoughnessError::Domain(_))));
    }

    #[test]
    fn a_steep_circle_is_removed_where_a_parabola_is_not() {
        let radius = 2e-3_f64;
        let z = |i: usize| {
            let x = (i as f64 - 1000.0) * 1e-6;
            0.3e-3 + 0.05 * x + (radius * radius - x * x).sqrt()
        };
        let profile = Profile::new(Length::from_si(1e-6), (0..2001).map(z).collect()).unwrap();
        let largest = |form| {
            let left = remove(&profile, form).unwrap();
            left.heights().iter().fold(0.0_f64, |m, z| m.max(z.abs()))
        };
        assert!(largest(Form::Circle) < 1e-15, "{:e}", largest(Form::Circle));
        assert!(largest(Form::Poly2) > 1e-6);
    }
}
