//! A cylinder that rolls and transmits a tangential load.
//!
//! Source: Carter 1926 after Johnson 1985, section 8.3. Similar materials, steady rolling.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | b, p₀ | half width and largest pressure of the Hertz contact | m, Pa |
//! | c, d = b − c | half width and middle of the stick zone, which touches the leading edge | m |
//! | R | relative radius of curvature | m |
//! | W, Q | normal and tangential load per metre of face width | N/m |
//! | μ, ξ | friction coefficient, creepage | - |

use asperity_core::quantity::{Length, LineLoad, Pressure};
use asperity_core::{DomainError, cite};

use super::mindlin::{held, stick_half_width, stick_pressure};
use crate::error::ContactError;
use crate::hertz_line::HertzLine;

/// q(x) = ±μ·p₀·[√(1 − x²/b²) − (c/b)·√(1 − (x − d)²/c²)], c = b·√(1 − |Q|/(μ·W))    [Carter-1]
///
/// The surface enters the contact at x = +b; the second root holds where |x − d| < c. The sign is
/// that of the tangential load.
///
/// # Errors
/// When the friction coefficient or the Hertz contact is not positive, the tangential load exceeds
/// what friction holds, or the position is not finite.
///
/// ```
/// use asperity_contact::{friction::carter_traction, hertz_line::HertzLine};
/// let contact = HertzLine { half_width: "100 um".parse()?, max_pressure: "1 GPa".parse()? };
/// let load = asperity_core::quantity::LineLoad::from_si(0.075 * contact.load().si());
/// // Half the contact sticks: 0..b. Behind it all friction is used up.
/// let behind = carter_traction(&contact, 0.1, load, "-60 um".parse()?)?;
/// assert!((behind.si() - 0.08e9).abs() < 1e-3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn carter_traction(
    contact: &HertzLine,
    friction: f64,
    tangential: LineLoad,
    position: Length,
) -> Result<Pressure, ContactError> {
    cite!("Carter-1");
    let c = stick_half_width(contact, friction, tangential)?;
    let slip = contact.pressure(position)?;
    let from_middle = position - (contact.half_width - c);
    let stick = stick_pressure(contact, c, from_middle)?;
    Ok((slip - stick) * friction.copysign(tangential.si()))
}

/// ξ = −(±μ·b/R)·[1 − √(1 − |Q|/(μ·W))]                                            [Carter-2]
///
/// # Errors
/// As [`carter_traction`]; and when the radius is not positive.
///
/// ```
/// use asperity_contact::{friction::carter_creepage, hertz_line::HertzLine};
/// let contact = HertzLine { half_width: "100 um".parse()?, max_pressure: "1 GPa".parse()? };
/// let load = asperity_core::quantity::LineLoad::from_si(0.075 * contact.load().si());
/// let creepage = carter_creepage(&contact, 0.1, load, "10 mm".parse()?)?;
/// assert!((creepage + 0.5e-3).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn carter_creepage(
    contact: &HertzLine,
    friction: f64,
    tangential: LineLoad,
    radius: Length,
) -> Result<f64, ContactError> {
    cite!("Carter-2");
    let r = DomainError::positive("relative radius", radius)?;
    let b = DomainError::positive("half width", contact.half_width)?;
    let held = held(contact, friction, tangential)?;
    Ok(-friction.copysign(tangential.si()) * b / r * (1.0 - (1.0 - held).sqrt()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rolling_traction_carries_its_load_and_enters_without_slip() {
        let contact = HertzLine {
            half_width: Length::from_si(1e-4),
            max_pressure: Pressure::from_si(1e9),
        };
        let load = contact.load() * (0.3 * 0.6);
        let points = 40_000_u32;
        let dx = 2e-4 / f64::from(points);
        let position = |i: u32| Length::from_si((f64::from(i) + 0.5) * dx - 1e-4);
        let q = |x| carter_traction(&contact, 0.3, load, x).unwrap().si();
        let sum: f64 = (0..points).map(|i| q(position(i)) * dx).sum();
        // The midpoint rule at two square roots: n^-1.5.
        assert!((sum / load.si() - 1.0).abs() < 1e-6);
        // 1 − √(c/b) of friction at the leading edge, all of it near the trailing one.
        let used = |x: f64| {
            let x = Length::from_si(x);
            q(x) / (0.3 * contact.pressure(x).unwrap().si())
        };
        assert!((used(0.99999e-4) - (1.0 - 0.4f64.sqrt().sqrt())).abs() < 1e-4);
        assert!((used(-0.5e-4) - 1.0).abs() < 1e-12);
    }
}
