//! Hertz line contact of two parallel elastic cylinders.
//!
//! Source: K. L. Johnson, *Contact Mechanics* (1985), section 4.2(c) and, for the approach,
//! section 5.6. Valid while the half width stays small against the radii and both bodies stay
//! elastic; the stress inside the bodies is in [`subsurface`](crate::subsurface).
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | w | load per length of contact line | N/m |
//! | R | relative radius of curvature, 1/R = 1/R₁ + 1/R₂ | m |
//! | E* | reduced modulus, 1/E* = Σ (1 − νᵢ²)/Eᵢ | Pa |
//! | b | half width of the contact | m |
//! | p₀ | largest pressure | Pa |
//! | p̄ | mean pressure over the contact | Pa |
//! | D | distance of the datum of the approach | m |
//! | δ | approach of the two bodies | m |

use std::f64::consts::{FRAC_PI_4, PI};

use asperity_core::quantity::{Length, LineLoad, Pressure};
use asperity_core::{DomainError, cite};
use serde::Serialize;

use crate::ContactError;

/// b = √(4·w·R / (π·E*))                                                     [Hertz-1]
///
/// # Errors
/// When the load is negative, or the radius or the modulus is not positive.
///
/// ```
/// use asperity_contact::hertz_line::half_width;
/// let b = half_width("113.409 N/mm".parse()?, "11.6269 mm".parse()?, "115.385 GPa".parse()?)?;
/// assert!((b.si() - 120.62e-6).abs() < 0.01e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn half_width(
    load: LineLoad,
    radius: Length,
    modulus: Pressure,
) -> Result<Length, ContactError> {
    cite!("Hertz-1");
    let (w, r, e) = domain(load, radius, modulus)?;
    Ok(Length::from_si((4.0 * w * r / (PI * e)).sqrt()))
}

/// p₀ = √(w·E* / (π·R)) = 2·w/(π·b)                                          [Hertz-2]
///
/// # Errors
/// When the load is negative, or the radius or the modulus is not positive.
///
/// ```
/// use asperity_contact::hertz_line::max_pressure;
/// let p0 = max_pressure("113.409 N/mm".parse()?, "11.6269 mm".parse()?, "115.385 GPa".parse()?)?;
/// assert!((p0.si() - 598.54e6).abs() < 0.01e6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn max_pressure(
    load: LineLoad,
    radius: Length,
    modulus: Pressure,
) -> Result<Pressure, ContactError> {
    cite!("Hertz-2");
    let (w, r, e) = domain(load, radius, modulus)?;
    Ok(Pressure::from_si((w * e / (PI * r)).sqrt()))
}

/// δ(D) = w/(π·E*)·(2·ln(2·D/b) + 1)                                         [Hertz-4]
///
/// The approach of a line contact is defined only against a `datum`: δ is the displacement of the
/// centre, both bodies together, relative to surface points at the distance D from it. It is
/// zero without load.
///
/// # Errors
/// When the load is negative, the radius or the modulus is not positive, or the datum lies within
/// the contact (D < b).
///
/// ```
/// use asperity_contact::hertz_line::approach;
/// let delta = approach("300 N/mm".parse()?, "3 mm".parse()?, "115.384615385 GPa".parse()?, "1.2 mm".parse()?)?;
/// assert!((delta.si() - 6.09366e-6).abs() < 1e-11);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn approach(
    load: LineLoad,
    radius: Length,
    modulus: Pressure,
    datum: Length,
) -> Result<Length, ContactError> {
    cite!("Hertz-4");
    let (w, _, e) = domain(load, radius, modulus)?;
    let b = half_width(load, radius, modulus)?.si();
    let d = DomainError::positive("datum distance", datum)?;
    DomainError::require(
        d >= b,
        "datum distance",
        d,
        "m",
        "must not lie within the contact",
    )?;
    if w == 0.0 {
        return Ok(Length::from_si(0.0));
    }
    Ok(Length::from_si(
        w / (PI * e) * (2.0 * (2.0 * d / b).ln() + 1.0),
    ))
}

fn domain(
    load: LineLoad,
    radius: Length,
    modulus: Pressure,
) -> Result<(f64, f64, f64), DomainError> {
    Ok((
        DomainError::non_negative("line load", load)?,
        DomainError::positive("relative radius", radius)?,
        DomainError::positive("reduced modulus", modulus)?,
    ))
}

/// Hertz line contact: the two numbers that determine its pressure and its stresses.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct HertzLine {
    /// Half width b.
    pub half_width: Length,
    /// Largest pressure p₀, at the middle.
    pub max_pressure: Pressure,
}

impl HertzLine {
    /// Computes the contact of a line load and a relative radius: [`half_width`] and [`max_pressure`].
    ///
    /// # Errors
    /// When the load is negative, or the radius or the modulus is not positive.
    ///
    /// ```
    /// use asperity_contact::hertz_line::HertzLine;
    /// let contact = HertzLine::new("113.409 N/mm".parse()?, "11.6269 mm".parse()?, "115.385 GPa".parse()?)?;
    /// let w = contact.load().si();
    /// assert!((w - 113_409.0).abs() < 1e-6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(load: LineLoad, radius: Length, modulus: Pressure) -> Result<Self, ContactError> {
        Ok(Self {
            half_width: half_width(load, radius, modulus)?,
            max_pressure: max_pressure(load, radius, modulus)?,
        })
    }

    /// p(x) = p₀·√(1 − x²/b²) for |x| < b, else 0                               [Hertz-3]
    ///
    /// # Errors
    /// When the position is not finite.
    ///
    /// ```
    /// use asperity_contact::hertz_line::HertzLine;
    /// let contact = HertzLine { half_width: "100 um".parse()?, max_pressure: "1 GPa".parse()? };
    /// assert_eq!(contact.pressure("60 um".parse()?)?, "0.8 GPa".parse()?);
    /// assert_eq!(contact.pressure("101 um".parse()?)?, "0 Pa".parse()?);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn pressure(&self, position: Length) -> Result<Pressure, ContactError> {
        cite!("Hertz-3");
        let x = DomainError::finite("position", position)?;
        let b = self.half_width.si();
        let ordinate = if x.abs() < b {
            // Near the edge (b − x)(b + x) is accurate, b² − x² is not.
            ((b - x) * (b + x)).sqrt() / b
        } else {
            0.0
        };
        Ok(self.max_pressure * ordinate)
    }

    /// p̄ = (π/4)·p₀, the load over the width 2 b.
    pub fn mean_pressure(&self) -> Pressure {
        self.max_pressure * FRAC_PI_4
    }

    /// w = (π/2)·p₀·b, the integral of the pressure.
    pub fn load(&self) -> LineLoad {
        LineLoad::from_si(0.5 * PI * self.max_pressure.si() * self.half_width.si())
    }

    /// u(x) = (b² − x²)/(2·R) for |x| < b, else 0                               [Hertz-5]
    ///
    /// Displacement of both bodies together, measured from the edge of the contact so that it
    /// depends on no datum; R is the `radius` of the contact.
    ///
    /// # Errors
    /// When the position is not finite or the radius is not positive.
    ///
    /// ```
    /// use asperity_contact::hertz_line::HertzLine;
    /// let contact = HertzLine { half_width: "100 um".parse()?, max_pressure: "1 GPa".parse()? };
    /// let u = contact.displacement_from_edge("0 um".parse()?, "10 mm".parse()?)?;
    /// assert!((u.si() - 0.5e-6).abs() < 1e-18);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn displacement_from_edge(
        &self,
        position: Length,
        radius: Length,
    ) -> Result<Length, ContactError> {
        cite!("Hertz-5");
        let x = DomainError::finite("position", position)?;
        let r = DomainError::positive("relative radius", radius)?;
        let b = self.half_width.si();
        Ok(Length::from_si((b * b - x * x).max(0.0) / (2.0 * r)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(load: f64, radius: f64, modulus: f64) -> HertzLine {
        HertzLine::new(
            LineLoad::from_si(load),
            Length::from_si(radius),
            Pressure::from_si(modulus),
        )
        .unwrap()
    }

    #[test]
    fn the_reference_pitch_point_has_its_half_width_and_pressure() {
        // Pitch point of the paper's Table 2, recomputed independently in double precision.
        let contact = line(
            113_408.970_605_022_56,
            11.626_875_546_138_667e-3,
            115.384_615_384_615_37e9,
        );
        // The same arithmetic in another order: a few last bits.
        assert!((contact.half_width.si() / 120.624_721_060_867_3e-6 - 1.0).abs() < 1e-14);
        assert!((contact.max_pressure.si() / 598.537_285_027_833_1e6 - 1.0).abs() < 1e-14);
    }

    #[test]
    fn the_approach_of_the_benchmark_cylinder_is_reproduced() {
        // R 3 mm, 3e5 N/m, datum 1.2 mm: recomputed independently to 12 digits.
        let (w, r, e) = (3e5, 3e-3, 115_384_615_385.0);
        let delta = approach(
            LineLoad::from_si(w),
            Length::from_si(r),
            Pressure::from_si(e),
            Length::from_si(1.2e-3),
        );
        assert!((delta.unwrap().si() / 6.093_664_560_36e-6 - 1.0).abs() < 1e-11);
        let contact = line(w, r, e);
        assert!((contact.half_width.si() / 9.965_574_970_33e-5 - 1.0).abs() < 1e-11);
        assert!((contact.max_pressure.si() / 1_916_456_725.06 - 1.0).abs() < 1e-11);
    }

    #[test]
    fn the_pressure_carries_the_load() {
        let contact = line(2e5, 5e-3, 115e9);
        let n = 20_000;
        let dx = 2.0 * contact.half_width.si() / f64::from(n);
        let sum: f64 = (0..n)
            .map(|i| -contact.half_width.si() + (f64::from(i) + 0.5) * dx)
            .map(|x| contact.pressure(Length::from_si(x)).unwrap().si() * dx)
            .sum();
        // Midpoint rule on a root: error O(n^-3/2) = 4e-7.
        assert!((sum / 2e5 - 1.0).abs() < 1e-6);
        let mean = contact.mean_pressure().si() * 2.0 * contact.half_width.si();
        assert!((mean / 2e5 - 1.0).abs() < 1e-14);
    }

    #[test]
    fn the_energy_from_the_edge_is_the_sum_of_pressure_times_displacement() {
        let (contact, radius) = (line(2e5, 5e-3, 115e9), Length::from_si(5e-3));
        let n = 2000;
        let dx = 2.0 * contact.half_width.si() / f64::from(n);
        let sum: f64 = (0..n)
            .map(|i| Length::from_si((f64::from(i) + 0.5) * dx - contact.half_width.si()))
            .map(|x| {
                let u = contact.displacement_from_edge(x, radius).unwrap().si();
                0.5 * contact.pressure(x).unwrap().si() * u * dx
            })
            .sum();
        // E = ½·∫ p·u dx = 3·w·b²/(16·R)
        let energy = 3.0 * 2e5 * contact.half_width.si().powi(2) / (16.0 * 5e-3);
        // Midpoint rule on (1 − x²)^(3/2): error O(n^-5/2) = 5e-9.
        assert!((sum / energy - 1.0).abs() < 2e-8);
        let outside = contact.displacement_from_edge(contact.half_width * 1.5, radius);
        assert_eq!(outside.unwrap().si(), 0.0);
    }

    #[test]
    fn width_and_pressure_scale_with_the_root_of_the_load() {
        let (one, four) = (line(1e5, 1e-2, 115e9), line(4e5, 1e-2, 115e9));
        assert!((four.half_width / one.half_width - 2.0).abs() < 1e-15);
        assert!((four.max_pressure / one.max_pressure - 2.0).abs() < 1e-15);
    }

    #[test]
    fn no_load_is_a_limit_and_nonsense_is_an_error() {
        let none = line(0.0, 1e-2, 115e9);
        assert_eq!(none.pressure(Length::from_si(0.0)).unwrap().si(), 0.0);
        let bad = |w, r, e, d| {
            approach(
                LineLoad::from_si(w),
                Length::from_si(r),
                Pressure::from_si(e),
                Length::from_si(d),
            )
        };
        assert_eq!(bad(0.0, 1e-2, 115e9, 1e-3).unwrap().si(), 0.0);
        assert!(bad(f64::NAN, 1e-2, 115e9, 1e-3).is_err());
        assert!(bad(1e5, 0.0, 115e9, 1e-3).is_err());
        assert!(bad(1e5, 1e-2, f64::INFINITY, 1e-3).is_err());
        assert!(bad(1e5, 1e-2, 115e9, 1e-6).is_err());
        assert!(none.pressure(Length::from_si(f64::NAN)).is_err());
    }
}
