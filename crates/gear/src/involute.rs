//! The involute function, its inverse, and the thickness of an involute tooth.
//!
//! Source: ISO 21771:2007.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | α | pressure angle at a point of the involute | rad |
//! | inv α | tan α − α | rad |
//! | s | arc thickness of the tooth in the transverse section | m |
//! | r_b | base radius | m |
//!
//! Limits: 0 ≤ α < π/2. For α below about 10⁻³ the difference tan α − α loses digits.

use asperity_core::DomainError;
use asperity_core::cite;
use asperity_core::quantity::{Angle, Length};

use crate::error::GearError;

/// Maximum number of Newton steps; seven suffice from 0.1° to 89°.
const MAX_ITERATIONS: usize = 50;

/// inv α = tan α − α                                                    [Involute-1]
///
/// # Errors
/// When α is not within 0 ≤ α < π/2.
///
/// ```
/// use asperity_gear::involute::involute;
/// // inv 20° = 0.014904.
/// assert!((involute("20 deg".parse()?)? - 0.014_904_384).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn involute(angle: Angle) -> Result<f64, DomainError> {
    cite!("Involute-1");
    let a = angle.si();
    DomainError::require(
        (0.0..std::f64::consts::FRAC_PI_2).contains(&a),
        "pressure angle",
        a,
        "rad",
        "must be at least 0 and below a right angle",
    )?;
    Ok(a.tan() - a)
}

/// Solution of the inverse involute function with its convergence.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InverseInvolute {
    /// The angle α.
    pub angle: Angle,
    /// tan α − α − inv α \[rad\].
    pub residual: f64,
    /// Number of Newton steps.
    pub iterations: usize,
}

/// α with tan α − α = inv α, by t ← t − (t − arctan t − inv α)·(1 + t²)/t²   [Involute-2]
///
/// Newton's method for t = tan α; t − arctan t is convex, so after the first step the iterates decrease monotonically
/// to the root.
///
/// # Errors
/// When `involute` is negative or not finite.
///
/// ```
/// use asperity_gear::involute::inverse_involute;
/// let solution = inverse_involute(0.014_904_383_867_336_446)?;
/// assert!((solution.angle.si().to_degrees() - 20.0).abs() < 1e-12);
/// # Ok::<(), asperity_gear::GearError>(())
/// ```
pub fn inverse_involute(involute: f64) -> Result<InverseInvolute, GearError> {
    cite!("Involute-2");
    DomainError::require(
        involute.is_finite() && involute >= 0.0,
        "involute function",
        involute,
        "rad",
        "must be finite and not negative",
    )?;
    // t³/3 leads for small angles, t − π/2 for large ones.
    let mut t = (3.0 * involute)
        .cbrt()
        .min(involute + std::f64::consts::FRAC_PI_2);
    let mut residual = 0.0;
    for iterations in 0..=MAX_ITERATIONS {
        residual = t - t.atan() - involute;
        // The residual is only accurate to the rounding errors of its two large terms.
        if residual.abs() <= 2.0 * f64::EPSILON * t {
            return Ok(InverseInvolute {
                angle: Angle::from_si(t.atan()),
                residual,
                iterations,
            });
        }
        t -= residual * (1.0 + t * t) / (t * t);
    }
    Err(GearError::inverse_involute(
        involute,
        residual,
        MAX_ITERATIONS,
    ))
}

/// Reference section of an involute tooth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ToothSection {
    /// Number of teeth z.
    pub teeth: u32,
    /// Profile shift coefficient x, in normal modules.
    pub profile_shift: f64,
    /// Normal pressure angle αₙ.
    pub normal_pressure_angle: Angle,
    /// Transverse pressure angle αₜ.
    pub transverse_pressure_angle: Angle,
    /// Base radius r_b.
    pub base_radius: Length,
}

/// s = 2 r·(π/(2 z) + 2 x tan αₙ/z + inv αₜ − inv α_r), cos α_r = r_b/r      [Involute-3]
///
/// Thickness of a tooth at the radius r; zero or negative beyond the intersection of its flanks.
///
/// # Errors
/// When r is below the base radius, a number is not finite, or the tooth has z = 0.
///
/// ```
/// use asperity_core::quantity::{Angle, Length};
/// use asperity_gear::involute::{ToothSection, tooth_thickness};
/// let angle = Angle::from_si(20f64.to_radians());
/// let tooth = ToothSection {
///     teeth: 20, profile_shift: 0.0, normal_pressure_angle: angle, transverse_pressure_angle: angle,
///     base_radius: Length::from_si(0.010 * angle.si().cos()),
/// };
/// // At the pitch circle the tooth is half a pitch thick: π m/2 with m = 1 mm.
/// let s = tooth_thickness(&tooth, Length::from_si(0.010))?;
/// assert!((s.si() - 0.5e-3 * std::f64::consts::PI).abs() < 1e-15);
/// # Ok::<(), asperity_core::DomainError>(())
/// ```
pub fn tooth_thickness(tooth: &ToothSection, radius: Length) -> Result<Length, DomainError> {
    cite!("Involute-3");
    let r = DomainError::positive("radius", radius)?;
    let angle = half_angle(tooth, radius)?;
    Ok(Length::from_si(2.0 * r * angle))
}

/// Half the angular thickness of a tooth at `radius` \[rad\], the bracket of `[Involute-3]`.
pub(crate) fn half_angle(tooth: &ToothSection, radius: Length) -> Result<f64, DomainError> {
    let x = tooth.profile_shift;
    DomainError::require(x.is_finite(), "profile shift", x, "-", "must be finite")?;
    let z = f64::from(tooth.teeth);
    DomainError::require(z > 0.0, "teeth", z, "-", "must be at least 1")?;
    let cosine = DomainError::positive("base radius", tooth.base_radius)?
        / DomainError::positive("radius", radius)?;
    DomainError::require(
        cosine <= 1.0,
        "radius",
        radius.si(),
        "m",
        "must not be below the base radius",
    )?;
    let here = involute(Angle::from_si(cosine.acos()))?;
    let reference = involute(tooth.transverse_pressure_angle)?;
    Ok(std::f64::consts::FRAC_PI_2 / z
        + 2.0 * x * tooth.normal_pressure_angle.si().tan() / z
        + reference
        - here)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_involute_of_twenty_degrees_is_the_tabulated_one() {
        // 30-digit evaluation of tan(π/9) − π/9.
        let value = involute(Angle::from_si(20f64.to_radians())).unwrap();
        assert!((value - 0.014_904_383_867_336_446).abs() < 1e-16);
    }

    #[test]
    fn the_inverse_undoes_the_involute_in_a_few_steps() {
        for degrees in [0.1, 1.0, 14.5, 20.0, 28.0, 45.0, 60.0, 80.0, 89.0] {
            let angle = f64::to_radians(degrees);
            let found = inverse_involute(angle.tan() - angle).unwrap();
            // The rounding of tan α − α, ε·α, is divided by its slope, tan² α.
            let tolerance = 4.0 * f64::EPSILON * (1.0 + angle / angle.tan().powi(2));
            assert!(
                (found.angle.si() - angle).abs() < tolerance,
                "{degrees}: {found:?}"
            );
            assert!(found.iterations <= 7, "{degrees}: {found:?}");
        }
        assert_eq!(inverse_involute(0.0).unwrap().angle.si(), 0.0);
    }

    #[test]
    fn what_is_no_involute_is_refused() {
        assert!(inverse_involute(-1e-9).is_err());
        assert!(inverse_involute(f64::NAN).is_err());
        assert!(involute(Angle::from_si(-0.1)).is_err());
        assert!(involute(Angle::from_si(1.6)).is_err());
    }

    #[test]
    fn a_tooth_is_thinner_towards_its_tip_and_pointed_beyond() {
        let angle = Angle::from_si(20f64.to_radians());
        let tooth = ToothSection {
            teeth: 16,
            profile_shift: 0.6,
            normal_pressure_angle: angle,
            transverse_pressure_angle: angle,
            base_radius: Length::from_si(8e-3 * angle.si().cos()),
        };
        let thickness = |r: f64| tooth_thickness(&tooth, Length::from_si(r)).unwrap().si();
        assert!(thickness(8e-3) > thickness(9e-3) && thickness(9e-3) > 0.0);
        assert!(thickness(10.5e-3) < 0.0);
        assert!(tooth_thickness(&tooth, Length::from_si(7e-3)).is_err());
    }
}
