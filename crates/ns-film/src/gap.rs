//! Gap between two cylinders: along the film, and over the angle of the paper.
//!
//! Along the film x the gap depends only on the relative radius. The paper uses the angle θ at the
//! centre of cylinder 2; its printed gap holds (to second order in θ) only for equal radii, and
//! otherwise its rise is wrong by the factor r₂/r₁.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | h₀ | gap on the line of centres | m |
//! | h | gap | m |
//! | x | distance from the line of centres | m |
//! | R | relative radius of curvature | m |
//! | r₁, r₂ | radii of the cylinders | m |
//! | θ | angle from the line of centres, at the centre of cylinder 2 | rad |

use asperity_core::DomainError;
use asperity_core::quantity::{Angle, Length};
use serde::{Deserialize, Serialize};

use crate::FilmError;

/// Shape of the gap along the film.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum GapShape {
    /// The parabola h₀ + x²/2R.
    #[default]
    Parabola,
    /// The cylinder h₀ + R − √(R² − x²).
    Cylinder,
}

impl GapShape {
    /// h(x) = h₀ + x²/(2·R), or h₀ + R − √(R² − x²)                             [Gap-1]
    ///
    /// # Errors
    /// When a length is not finite, the gap is negative, the radius is not positive, or x lies
    /// outside the cylinder.
    ///
    /// ```
    /// use asperity_ns_film::gap::GapShape;
    /// let h = GapShape::Parabola.gap("1 um".parse()?, "100 um".parse()?, "10 mm".parse()?)?;
    /// assert!((h.si() - 1.5e-6).abs() < 1e-20);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn gap(self, least: Length, position: Length, radius: Length) -> Result<Length, FilmError> {
        asperity_core::cite!("Gap-1");
        let h0 = DomainError::non_negative("least gap", least)?;
        let (x, r) = self.domain(position, radius)?;
        Ok(Length::from_si(match self {
            Self::Parabola => h0 + x * x / (2.0 * r),
            // R − √(R² − x²) without the difference of two almost equal lengths.
            Self::Cylinder => h0 + x * x / (r + ((r - x) * (r + x)).sqrt()),
        }))
    }

    /// h'(x) = x/R, or x/√(R² − x²)                                             [Gap-2]
    ///
    /// # Errors
    /// When a length is not finite, the radius is not positive, or x is not inside the cylinder.
    ///
    /// ```
    /// use asperity_ns_film::gap::GapShape;
    /// assert_eq!(GapShape::Parabola.slope("100 um".parse()?, "10 mm".parse()?)?, 0.01);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn slope(self, position: Length, radius: Length) -> Result<f64, FilmError> {
        asperity_core::cite!("Gap-2");
        let (x, r) = self.domain(position, radius)?;
        Ok(match self {
            Self::Parabola => x / r,
            Self::Cylinder => x / ((r - x) * (r + x)).sqrt(),
        })
    }

    fn domain(self, position: Length, radius: Length) -> Result<(f64, f64), DomainError> {
        let x = DomainError::finite("position", position)?;
        let r = DomainError::positive("relative radius", radius)?;
        DomainError::require(
            self == Self::Parabola || x.abs() < r,
            "position",
            x,
            "m",
            "must lie inside the cylinder",
        )?;
        Ok((x, r))
    }
}

/// h(θ) = h₀ + (1 − cos θ)·(r₁ + r₂)                                         `[P29]`
///
/// as printed in the paper: for small angles its rise is r₁/r₂ of the rise of [`exact_gap`].
///
/// # Errors
/// When the angle is not finite, the gap is negative, or a radius is not positive.
///
/// ```
/// use asperity_ns_film::gap::paper_gap;
/// let h = paper_gap("1 um".parse()?, "0.01 rad".parse()?, "10 mm".parse()?, "20 mm".parse()?)?;
/// assert!((h.si() - (1e-6 + 1.5e-6)).abs() < 1e-10);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn paper_gap(least: Length, angle: Angle, r1: Length, r2: Length) -> Result<Length, FilmError> {
    asperity_core::cite!("P29");
    let (h0, theta, r1, r2) = domain(least, angle, r1, r2)?;
    Ok(Length::from_si(h0 + paper_rise(theta, r1, r2)))
}

/// Rise \[m\] of [`paper_gap`] from the line of centres, for valid numbers.
pub(crate) fn paper_rise(theta: f64, r1: f64, r2: f64) -> f64 {
    // 1 − cos θ = 2·sin²(θ/2) does not cancel at small angles.
    2.0 * (0.5 * theta).sin().powi(2) * (r1 + r2)
}

/// h(θ) = L·cos θ − √(r₁² − (L·sin θ)²) − r₂,  L = r₁ + r₂ + h₀                    [Gap-3]
///
/// the gap along the ray from the centre of cylinder 2.
///
/// # Errors
/// When the angle is not finite, the gap is negative, a radius is not positive, or the ray misses
/// cylinder 1.
///
/// ```
/// use asperity_ns_film::gap::exact_gap;
/// let h = exact_gap("1 um".parse()?, "0.01 rad".parse()?, "10 mm".parse()?, "20 mm".parse()?)?;
/// assert!((h.si() - (1e-6 + 3.0e-6)).abs() < 1e-8);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn exact_gap(least: Length, angle: Angle, r1: Length, r2: Length) -> Result<Length, FilmError> {
    asperity_core::cite!("Gap-3");
    let (h0, theta, r1, r2) = domain(least, angle, r1, r2)?;
    let l = r1 + r2 + h0;
    let offset = l * theta.sin();
    DomainError::require(
        offset.abs() <= r1 && theta.cos() > 0.0,
        "angle",
        theta,
        "rad",
        "must be small enough for the ray to meet cylinder 1",
    )?;
    // Rationalised: the difference of two lengths near r₁ would lose five digits.
    let rise = h0 * (2.0 * r1 + h0) + 4.0 * l * r2 * (0.5 * theta).sin().powi(2);
    let root = ((r1 - offset) * (r1 + offset)).sqrt();
    Ok(Length::from_si(rise / (l * theta.cos() - r2 + root)))
}

fn domain(
    least: Length,
    angle: Angle,
    r1: Length,
    r2: Length,
) -> Result<(f64, f64, f64, f64), DomainError> {
    Ok((
        DomainError::non_negative("least gap", least)?,
        DomainError::finite("angle", angle)?,
        DomainError::positive("radius 1", r1)?,
        DomainError::positive("radius 2", r2)?,
    ))
}
