//! Stress under a strip |x| ≤ a that carries a uniform unit pressure or unit traction.
//!
//! The textbook form subtracts angles and logarithms at the two edges, which cancel at large distances.
//! Here each difference is a function of one argument.

use std::f64::consts::PI;

use asperity_core::quantity::Length;
use asperity_core::{DomainError, cite};
use serde::Serialize;

use crate::ContactError;

/// Stress under a strip per unit of pressure or traction on it.
///
/// σ_zz by traction equals τ_xz by pressure, and τ_xz by traction equals σ_xx by pressure.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct StripStress {
    /// A = σ_xx/p = τ_xz/q.
    pub xx_of_pressure: f64,
    /// B = σ_zz/p.
    pub zz_of_pressure: f64,
    /// C = τ_xz/p = σ_zz/q.
    pub xz_of_pressure: f64,
    /// D = σ_xx/q.
    pub xx_of_traction: f64,
}

/// A = −(2δθ + δs)/2π,  B = −(2δθ − δs)/2π,  C = δc/2π,  D = (4·ln(r₁/r₂) − δc)/2π      [Subsurface-1]
///
/// with the angle δθ = atan2(2az, x² − a² + z²) that the strip subtends, r₁,₂² = (x ∓ a)² + z²,
/// δs = 4az(x² − a² − z²)/(r₁r₂)², δc = −8axz²/(r₁r₂)², and
/// ln(r₁/r₂) = −artanh(2ax/(x² + a² + z²)).
///
/// # Errors
/// When a length is not finite, the half width is not positive, the depth is negative, or the
/// point is an edge of the strip on the surface, where the stress is not defined.
///
/// ```
/// use asperity_contact::subsurface::strip_unit;
/// let under = strip_unit("0 mm".parse()?, "0.5 mm".parse()?, "1 mm".parse()?)?;
/// assert!((under.zz_of_pressure + 0.959480673646166).abs() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn strip_unit(
    position: Length,
    depth: Length,
    half_width: Length,
) -> Result<StripStress, ContactError> {
    cite!("Subsurface-1");
    let x = DomainError::finite("position", position)?;
    let z = DomainError::non_negative("depth", depth)?;
    let a = DomainError::positive("half width", half_width)?;
    DomainError::require(
        z > 0.0 || x.abs() != a,
        "position",
        x,
        "m",
        "must not be an edge of the strip on the surface",
    )?;
    // In units of the half width, squares do not overflow at any sensible position.
    Ok(unit(x / a, z / a))
}

/// Stress with lengths in units of the half width; `z` ≥ 0, and the point is not an edge of the strip.
pub(super) fn unit(x: f64, z: f64) -> StripStress {
    let r1_r2_squared = ((x - 1.0).powi(2) + z * z) * ((x + 1.0).powi(2) + z * z);
    // Near the edges (x − 1)(x + 1) is accurate, x² − 1 is not.
    let (outside, z2) = ((x - 1.0) * (x + 1.0), z * z);
    let angle = (2.0 * z).atan2(outside + z2);
    let sine = 4.0 * z * (outside - z2) / r1_r2_squared;
    let cosine = -8.0 * x * z2 / r1_r2_squared;
    let logarithm = -(2.0 * x / (x * x + 1.0 + z2)).atanh();
    StripStress {
        xx_of_pressure: -(2.0 * angle + sine) / (2.0 * PI),
        zz_of_pressure: -(2.0 * angle - sine) / (2.0 * PI),
        xz_of_pressure: cosine / (2.0 * PI),
        xx_of_traction: (4.0 * logarithm - cosine) / (2.0 * PI),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_unit_strip_equals_the_integrated_flamant_solution() {
        // Integrals of Flamant's point-load solution over |x| ≤ 1, recomputed with mpmath;
        // adaptive quadrature agrees to 3e-15.
        for (x, z, expected) in [
            (
                0.0,
                0.5,
                [-0.450_184_855_752_100_9, -0.959_480_673_646_166, 0.0, 0.0],
            ),
            (
                1.3,
                0.2,
                [
                    -0.278_998_228_954_355_83,
                    -0.040_116_513_244_193_98,
                    -0.095_552_686_284_064_74,
                    -1.086_514_015_603_887_8,
                ],
            ),
            (
                -2.0,
                3.0,
                [
                    -0.083_921_640_413_675_14,
                    -0.211_245_594_887_191_4,
                    0.127_323_954_473_516_26,
                    0.059_774_351_931_827_14,
                ],
            ),
        ] {
            let s = unit(x, z);
            let got = [
                s.xx_of_pressure,
                s.zz_of_pressure,
                s.xz_of_pressure,
                s.xx_of_traction,
            ];
            for (got, expected) in got.into_iter().zip(expected) {
                // A few last bits of sums of size 1.
                assert!((got - expected).abs() < 2e-15, "{x} {z}: {got} {expected}");
            }
        }
    }

    #[test]
    fn the_surface_carries_what_is_put_on_it() {
        for (x, carried) in [
            (0.0, 1.0),
            (0.9, 1.0),
            (-0.999, 1.0),
            (1.001, 0.0),
            (-7.0, 0.0),
        ] {
            let s = unit(x, 0.0);
            assert!((s.zz_of_pressure + carried).abs() < 1e-15);
            assert!((s.xx_of_pressure + carried).abs() < 1e-15);
            assert_eq!(s.xz_of_pressure, 0.0);
        }
    }

    #[test]
    fn far_from_the_strip_no_digit_is_lost() {
        // Flamant: σ_zz = −(2/π)·P·z³/r⁴ with P = 2; the next term is (a/r)² = 1e-12 smaller.
        let (x, z) = (6e5, 8e5);
        let flamant = -4.0 / PI * z * z * z / 1e24;
        assert!((unit(x, z).zz_of_pressure / flamant - 1.0).abs() < 1e-11);
        let sliding = -4.0 / PI * x * x * x / 1e24;
        assert!((unit(x, z).xx_of_traction / sliding - 1.0).abs() < 1e-11);
    }

    #[test]
    fn the_edge_on_the_surface_is_an_error() {
        let mm = |v: f64| Length::from_si(v * 1e-3);
        assert!(strip_unit(mm(1.0), mm(0.0), mm(1.0)).is_err());
        assert!(strip_unit(mm(f64::NAN), mm(1.0), mm(1.0)).is_err());
        assert!(strip_unit(mm(0.0), mm(-1.0), mm(1.0)).is_err());
    }
}
