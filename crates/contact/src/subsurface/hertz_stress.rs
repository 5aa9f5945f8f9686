//! Stress under a Hertz line contact that may slide, in closed form.
//!
//! McEwen's form after Johnson 1985, eq. 4.49, with full-sliding traction q = μ·p (Johnson 1985,
//! section 7.1). Valid anywhere in the half-plane.

use asperity_core::quantity::{Length, Pressure};
use asperity_core::{DomainError, cite};

use super::point::PlaneStress;
use crate::ContactError;
use crate::hertz_line::HertzLine;

/// Stress at a point under a Hertz contact with traction q(x) = μ·p(x) towards +x.
///
/// ```text
/// σ_xx = −(p₀/b)·(m·(1 + s/d) − 2z + μ·(2x − n·(2 − (z² − m²)/d))),
/// σ_zz = −(p₀/b)·(m·(1 − s/d) + μ·n·(m² − z²)/d),
/// τ_xz = −(p₀/b)·(n·(m² − z²)/d + μ·(m·(1 + s/d) − 2z)),
/// s = z² + n²,  d = m² + n²,
/// m², n² = ½·(√((b² − x² + z²)² + 4x²z²) ± (b² − x² + z²)), n with the sign of x         [Subsurface-2]
/// ```
///
/// `friction` is μ, of either sign.
///
/// # Errors
/// When the half width is not positive, the pressure or the depth is negative, or a number is not
/// finite.
///
/// ```
/// use asperity_contact::{hertz_line::HertzLine, subsurface::hertz_stress};
/// let contact = HertzLine { half_width: "100 um".parse()?, max_pressure: "1 GPa".parse()? };
/// let deepest = hertz_stress(&contact, 0.0, "0 um".parse()?, "78.615 um".parse()?)?;
/// assert!((deepest.max_shear().si() - 0.300283e9).abs() < 1e3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn hertz_stress(
    contact: &HertzLine,
    friction: f64,
    position: Length,
    depth: Length,
) -> Result<PlaneStress, ContactError> {
    cite!("Subsurface-2");
    let b = DomainError::positive("half width", contact.half_width)?;
    let p0 = DomainError::non_negative("largest pressure", contact.max_pressure)?;
    let x = DomainError::finite("position", position)? / b;
    let z = DomainError::non_negative("depth", depth)? / b;
    let mu = DomainError::require(
        friction.is_finite(),
        "friction coefficient",
        friction,
        "-",
        "must be finite",
    )?;
    let [xx, zz, xz, sliding_xx] = unit(x, z);
    let stress = |value: f64| Pressure::from_si(p0 * value);
    Ok(PlaneStress {
        sigma_xx: stress(xx + mu * sliding_xx),
        sigma_zz: stress(zz + mu * xz),
        tau_xz: stress(xz + mu * xx),
    })
}

/// σ_xx, σ_zz, τ_xz of the pressure and σ_xx of the traction, in units of p₀ and b.
fn unit(x: f64, z: f64) -> [f64; 4] {
    let c = (1.0 - x) * (1.0 + x) + z * z;
    let root = c.hypot(2.0 * x * z);
    // Of m and n the larger comes from its sum, the other from m·n = x·z: no cancellation.
    let (m, n) = if c >= 0.0 {
        let m = (0.5 * (root + c)).sqrt();
        (m, if m > 0.0 { x * z / m } else { 0.0 })
    } else {
        let n = (0.5 * (root - c)).sqrt().copysign(x);
        (x * z / n, n)
    };
    let d = m * m + n * n;
    // At the edge of the contact on the surface m = n = d = 0 and every term vanishes.
    let share = |value: f64| if d > 0.0 { value / d } else { 0.0 };
    let (m2, n2, z2) = (m * m, n * n, z * z);
    [
        -(m * (1.0 + share(z2 + n2)) - 2.0 * z),
        -m * (1.0 - share(z2 + n2)),
        -n * share(m2 - z2),
        n * (2.0 - share(z2 - m2)) - 2.0 * x,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn contact() -> HertzLine {
        HertzLine {
            half_width: Length::from_si(1.0),
            max_pressure: Pressure::from_si(1.0),
        }
    }

    fn at(mu: f64, x: f64, z: f64) -> PlaneStress {
        hertz_stress(&contact(), mu, Length::from_si(x), Length::from_si(z)).unwrap()
    }

    #[test]
    fn mises_peaks_on_the_axis_where_johnson_says() {
        // Largest von Mises stress over depth for four Poisson's ratios, recomputed with mpmath.
        for (nu, depth, value, digits) in [
            (0.25, 0.654_778, 0.579_702, 1e-6),
            (0.28, 0.686_211, 0.565_689, 1e-6),
            (0.30, 0.704_291_685, 0.557_516_216_567, 1e-12),
            (0.33, 0.727_610, 0.546_898, 1e-6),
        ] {
            let mises = |z: f64| at(0.0, 0.0, z).von_mises(nu).unwrap().si();
            assert!((mises(depth) - value).abs() < digits, "{nu}");
            assert!(mises(depth) > mises(depth - 1e-3) && mises(depth) > mises(depth + 1e-3));
        }
    }

    #[test]
    fn traction_moves_the_peak_to_the_surface() {
        // ν = 0.3, recomputed on a fine grid: digits of the grid 5e-5, positions 1e-3.
        let mises = |mu, x, z| at(mu, x, z).von_mises(0.3).unwrap().si();
        assert!((mises(0.1, 0.286, 0.669) - 0.565_45).abs() < 2e-5);
        assert!((mises(0.3, 0.287, 0.0) - 0.666_63).abs() < 2e-5);
        assert!((at(0.3, 0.864, 0.380).max_shear().si() - 0.344_88).abs() < 2e-5);
    }

    #[test]
    fn the_surface_carries_the_hertz_pressure_and_traction() {
        for x in [-3.0, -1.0, -0.6, 0.0, 0.8, 1.0, 1.5] {
            let p = f64::max(1.0 - x * x, 0.0).sqrt();
            let s = at(0.2, x, 0.0);
            assert!((s.sigma_zz.si() + p).abs() < 1e-15, "{x}");
            assert!((s.tau_xz.si() + 0.2 * p).abs() < 1e-15, "{x}");
        }
    }

    #[test]
    fn nonsense_is_an_error() {
        let l = Length::from_si;
        assert!(hertz_stress(&contact(), f64::NAN, l(0.0), l(1.0)).is_err());
        assert!(hertz_stress(&contact(), 0.0, l(0.0), l(-1.0)).is_err());
        assert!(hertz_stress(&contact(), 0.0, l(f64::INFINITY), l(1.0)).is_err());
    }
}
