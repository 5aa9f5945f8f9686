//! Hertz contact of two bodies that touch at a point: circle or ellipse with axes along and across the motion.
//!
//! Source: K. L. Johnson, *Contact Mechanics* (1985), section 4.2. The principal directions of both bodies coincide, as
//! on a ball, a barrel or a disc. Valid while the half-axes stay small against the radii and both bodies stay elastic.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | F | load | N |
//! | R_x, R_y | relative radii of curvature along and across the motion | m |
//! | E* | reduced modulus, 1/E* = Σ (1 − νᵢ²)/Eᵢ | Pa |
//! | a, b | half-axes along and across the motion | m |
//! | c, s | longer and shorter half-axis; m₁ = (s/c)² | m |
//! | K, E | complete elliptic integrals of the parameter 1 − m₁ | - |
//! | p₀ | largest pressure | Pa |

use std::f64::consts::PI;

use asperity_core::numerics::{CompleteElliptic, find_root};
use asperity_core::quantity::{Force, Length, Pressure};
use asperity_core::{DomainError, cite};
use serde::Serialize;

use crate::ContactError;

/// Smallest (s/c)² that is searched.
const FLATTEST: f64 = 1e-16;

/// Hertz contact with an elliptical area.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct HertzPoint {
    /// Half-axes a along and b across the motion.
    pub half_axes: [Length; 2],
    /// Largest pressure p₀, at the middle.
    pub max_pressure: Pressure,
}

impl HertzPoint {
    /// Computes the contact of a load and the relative radii along and across the motion.
    ///
    /// ```text
    /// (E/m₁ − K)/(K − E) = larger/smaller of R_x, R_y                          [Hertz-ellipse]
    /// c³ = 3 F E/(2 π E* m₁ (1/(2 R_x) + 1/(2 R_y))),  s = c √m₁,  p₀ = 3 F/(2 π a b)
    /// ```
    ///
    /// Equal radii give the circle a³ = 3 F R/(4 E*).
    ///
    /// # Errors
    /// When a quantity is not positive, or one radius is more than 10⁹ times the other.
    ///
    /// ```
    /// use asperity_contact::hertz_point::HertzPoint;
    /// let ball = HertzPoint::new("30 N".parse()?, ["9.525 mm".parse()?; 2], "115.385 GPa".parse()?)?;
    /// assert!((ball.max_pressure.si() - 0.948e9).abs() < 0.5e6);
    /// assert_eq!(ball.half_axes[0], ball.half_axes[1]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(load: Force, radii: [Length; 2], modulus: Pressure) -> Result<Self, ContactError> {
        cite!("Hertz-ellipse");
        let f = DomainError::positive("load", load)?;
        let x = DomainError::positive("relative radius along the motion", radii[0])?;
        let y = DomainError::positive("relative radius across the motion", radii[1])?;
        let e = DomainError::positive("reduced modulus", modulus)?;
        let (square, integrals) = ellipse(x.max(y) / x.min(y))?;
        let curvature = 0.5 / x + 0.5 / y;
        let long = (1.5 * f * integrals.second / (PI * e * square * curvature)).cbrt();
        let short = long * square.sqrt();
        let half_axes = if x <= y { [short, long] } else { [long, short] };
        Ok(Self {
            half_axes: half_axes.map(Length::from_si),
            max_pressure: Pressure::from_si(1.5 * f / (PI * long * short)),
        })
    }
}

/// (s/c)² of a ratio of radii of at least 1, with the integrals of this ellipse.
fn ellipse(ratio: f64) -> Result<(f64, CompleteElliptic), DomainError> {
    // (E/m₁ − K)/(K − E) = (K − D)/(m₁ D) with D = (K − E)/m, which does not cancel near the circle.
    let excess = |log: f64| {
        let square = log.exp();
        let of = CompleteElliptic::from_complement(square);
        ((of.first - of.difference) / (square * of.difference * ratio)).ln()
    };
    let log = find_root(excess, FLATTEST.ln(), 0.0, 1e-15).map_or(f64::NAN, |root| root.value);
    let rule = "must not be above 1e9";
    DomainError::require(log.is_finite(), "ratio of the radii", ratio, "-", rule)?;
    Ok((log.exp(), CompleteElliptic::from_complement(log.exp())))
}

#[cfg(test)]
mod tests {
    use asperity_core::quantity::LineLoad;

    use super::*;
    use crate::hertz_line;

    fn point(load: f64, radii: [f64; 2]) -> HertzPoint {
        let modulus = Pressure::from_si(210e9 / 2.0 / 0.91);
        HertzPoint::new(Force::from_si(load), radii.map(Length::from_si), modulus).unwrap()
    }

    #[test]
    fn a_circle_has_its_closed_form_and_an_ellipse_tends_to_it() {
        let modulus = 210e9 / 2.0 / 0.91;
        let closed = f64::cbrt(0.75 * 30.0 * 9.525e-3 / modulus);
        let circle = point(30.0, [9.525e-3; 2]);
        assert!((circle.half_axes[0].si() / closed - 1.0).abs() < 1e-15);
        for off in [1e-3, 1e-6, 1e-9] {
            let near = point(30.0, [9.525e-3, 9.525e-3 * (1.0 + off)]);
            // Johnson 4.28: b/a = (R_y/R_x)^(2/3) for nearly equal radii.
            let ratio = (near.half_axes[1] / near.half_axes[0]).ln() / off;
            assert!((ratio - 2.0 / 3.0).abs() < off + 1e-6, "{off}: {ratio}");
        }
    }

    #[test]
    fn ellipses_of_an_independent_computation_lie_along_the_larger_radius() {
        // Bisection of the equation of the half-axes in another program.
        for (load, radii, [a, b], p0) in [
            (
                400.0,
                [0.02, 0.06],
                [3.06392320737e-4, 6.34841865140e-4],
                9.81878934416e8,
            ),
            (
                400.0,
                [0.02, 0.005],
                [4.56733877625e-4, 1.82641947034e-4],
                2.28948405589e9,
            ),
        ] {
            let contact = point(load, radii);
            for (axis, expected) in contact.half_axes.iter().zip([a, b]) {
                assert!((axis.si() / expected - 1.0).abs() < 1e-9);
            }
            assert!((contact.max_pressure.si() / p0 - 1.0).abs() < 1e-9);
            let turned = point(load, [radii[1], radii[0]]);
            assert_eq!(
                turned.half_axes,
                [contact.half_axes[1], contact.half_axes[0]]
            );
        }
    }

    #[test]
    fn a_flat_ellipse_is_a_line_contact_with_the_load_of_its_middle() {
        let modulus = Pressure::from_si(210e9 / 2.0 / 0.91);
        let (load, radius) = (400.0, 0.01);
        let flat = point(load, [radius, 1e6 * radius]);
        // The load per length in the middle is 3 F/(4 b).
        let line = LineLoad::from_si(0.75 * load / flat.half_axes[1].si());
        let width = hertz_line::half_width(line, Length::from_si(radius), modulus).unwrap();
        assert!((flat.half_axes[0] / width - 1.0).abs() < 1e-5);
    }

    #[test]
    fn radii_that_no_ellipse_has_are_refused() {
        let modulus = Pressure::from_si(1e11);
        let radii = [1e-3, 1e15].map(Length::from_si);
        assert!(HertzPoint::new(Force::from_si(1.0), radii, modulus).is_err());
        let radii = [1e-3, -1e-3].map(Length::from_si);
        assert!(HertzPoint::new(Force::from_si(1.0), radii, modulus).is_err());
    }
}
