//! Shear stress under the middle of the contact, the paper's subsurface check.
//!
//! The paper prints one formula with its maximum "at z = a, 20.7 %". When evaluated, the maximum is
//! 0.30028 p₀ at z = 0.78615 b under a Hertz contact and p/π at z = a under a uniformly loaded strip.

use std::f64::consts::PI;

use asperity_core::quantity::{Length, Pressure};
use asperity_core::{DomainError, cite};

use crate::ContactError;
use crate::hertz_line::HertzLine;

/// Depth of the largest shear stress under a Hertz contact, in half widths: √((√5 − 1)/2).
pub const HERTZ_SHEAR_DEPTH: f64 = 0.786_151_377_757_423_3;

/// τ₁(z) = (p₀/b)·(z − z²/√(b² + z²))                                        `[P5]`
///
/// the largest shear stress in the plane on the axis of a Hertz contact; its maximum is
/// 0.300283 p₀ at the depth [`HERTZ_SHEAR_DEPTH`]·b.
///
/// # Errors
/// When the half width is not positive, or the pressure or the depth is negative.
///
/// ```
/// use asperity_contact::{hertz_line::HertzLine, subsurface::{HERTZ_SHEAR_DEPTH, hertz_axis_shear}};
/// let contact = HertzLine { half_width: "100 um".parse()?, max_pressure: "1 GPa".parse()? };
/// let tau = hertz_axis_shear(&contact, contact.half_width * HERTZ_SHEAR_DEPTH)?;
/// assert!((tau.si() - 0.300283106e9).abs() < 1.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn hertz_axis_shear(contact: &HertzLine, depth: Length) -> Result<Pressure, ContactError> {
    cite!("P5");
    let b = DomainError::positive("half width", contact.half_width)?;
    let p0 = DomainError::non_negative("largest pressure", contact.max_pressure)?;
    let z = DomainError::non_negative("depth", depth)?;
    let root = b.hypot(z);
    // z − z²/√(b² + z²) without the difference, which cancels at large depths.
    Ok(Pressure::from_si(p0 * (z / root) * (b / (root + z))))
}

/// τ₁(z) = (2·p/π)·a·z/(a² + z²)                                             `[P5]`
///
/// the largest shear stress in the plane under the middle of a uniformly loaded strip; its
/// maximum is p/π at z = a.
///
/// # Errors
/// When the half width is not positive, or the pressure or the depth is negative.
///
/// ```
/// use asperity_contact::subsurface::strip_axis_shear;
/// let tau = strip_axis_shear("1 GPa".parse()?, "1 mm".parse()?, "1 mm".parse()?)?;
/// assert!((tau.si() - 1e9 / std::f64::consts::PI).abs() < 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn strip_axis_shear(
    pressure: Pressure,
    half_width: Length,
    depth: Length,
) -> Result<Pressure, ContactError> {
    cite!("P5");
    let p = DomainError::non_negative("pressure", pressure)?;
    let a = DomainError::positive("half width", half_width)?;
    let z = DomainError::non_negative("depth", depth)?;
    let root = a.hypot(z);
    Ok(Pressure::from_si(2.0 * p / PI * (a / root) * (z / root)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::subsurface::{hertz_stress, strip_unit};

    fn contact() -> HertzLine {
        HertzLine {
            half_width: Length::from_si(1.0),
            max_pressure: Pressure::from_si(1.0),
        }
    }

    fn hertz(z: f64) -> f64 {
        hertz_axis_shear(&contact(), Length::from_si(z))
            .unwrap()
            .si()
    }

    #[test]
    fn shear_under_hertz_peaks_at_0_786_half_widths_and_not_at_one() {
        let exact_depth = ((5f64.sqrt() - 1.0) / 2.0).sqrt();
        assert!((HERTZ_SHEAR_DEPTH - exact_depth).abs() < 1e-15);
        // Maximum recomputed with mpmath.
        assert!((hertz(exact_depth) - 0.300_283_106_001).abs() < 1e-12);
        assert!(hertz(exact_depth) > hertz(exact_depth * 1.001));
        assert!(hertz(exact_depth) > hertz(exact_depth * 0.999));
        // The value at z = a; divided by √2 it is the 20.7 % that the paper prints.
        assert!((hertz(1.0) - (1.0 - 0.5f64.sqrt())).abs() < 1e-15);
        assert!((hertz(1.0) * 0.5f64.sqrt() - 0.207_106_781_186_547_57).abs() < 1e-15);
    }

    #[test]
    fn the_axis_forms_agree_with_the_whole_fields() {
        for z in [0.0, 0.1, 0.7, 1.0, 3.0, 50.0] {
            let depth = Length::from_si(z);
            let field = hertz_stress(&contact(), 0.0, Length::from_si(0.0), depth).unwrap();
            assert!((field.max_shear().si() - hertz(z)).abs() < 1e-14, "{z}");
            let strip = strip_unit(Length::from_si(0.0), depth, Length::from_si(1.0)).unwrap();
            let of_strip = 0.5 * (strip.xx_of_pressure - strip.zz_of_pressure).abs();
            let axis = strip_axis_shear(Pressure::from_si(1.0), Length::from_si(1.0), depth);
            assert!((axis.unwrap().si() - of_strip).abs() < 1e-15, "{z}");
        }
    }
}
