//! A Hertz line contact under a tangential load that it holds.
//!
//! Source: Cattaneo 1938 and Mindlin 1949 after Johnson 1985, section 7.2. Similar materials, normal
//! load first and constant.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | b, p₀ | half width and largest pressure of the Hertz contact | m, Pa |
//! | c | half width of the stick zone in the middle | m |
//! | W, Q | normal and tangential load per metre of face width | N/m |
//! | μ | friction coefficient | - |

use asperity_core::quantity::{Length, LineLoad, Pressure};
use asperity_core::{DomainError, cite};

use crate::error::ContactError;
use crate::hertz_line::HertzLine;

/// c = b·√(1 − |Q|/(μ·W))                                                         [Mindlin-1]
///
/// # Errors
/// When the friction coefficient or the Hertz contact is not positive, or the tangential load
/// exceeds what friction holds.
///
/// ```
/// use asperity_contact::{friction::stick_half_width, hertz_line::HertzLine};
/// let contact = HertzLine { half_width: "100 um".parse()?, max_pressure: "1 GPa".parse()? };
/// let most = 0.1 * contact.load().si();
/// let c = stick_half_width(&contact, 0.1, asperity_core::quantity::LineLoad::from_si(0.75 * most))?;
/// assert!((c.si() - 50e-6).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn stick_half_width(
    contact: &HertzLine,
    friction: f64,
    tangential: LineLoad,
) -> Result<Length, ContactError> {
    cite!("Mindlin-1");
    let b = DomainError::positive("half width", contact.half_width)?;
    let held = held(contact, friction, tangential)?;
    Ok(Length::from_si(b * (1.0 - held).sqrt()))
}

/// q(x) = ±μ·p₀·[√(1 − x²/b²) − (c/b)·√(1 − x²/c²)], the second root where |x| < c   [Mindlin-2]
///
/// The sign is that of the tangential load.
///
/// # Errors
/// As [`stick_half_width`]; and when the position is not finite.
///
/// ```
/// use asperity_contact::{friction::mindlin_traction, hertz_line::HertzLine};
/// let contact = HertzLine { half_width: "100 um".parse()?, max_pressure: "1 GPa".parse()? };
/// let load = asperity_core::quantity::LineLoad::from_si(0.075 * contact.load().si());
/// let middle = mindlin_traction(&contact, 0.1, load, "0 um".parse()?)?;
/// assert!((middle.si() - 0.05e9).abs() < 1e-3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn mindlin_traction(
    contact: &HertzLine,
    friction: f64,
    tangential: LineLoad,
    position: Length,
) -> Result<Pressure, ContactError> {
    cite!("Mindlin-2");
    let c = stick_half_width(contact, friction, tangential)?;
    let slip = contact.pressure(position)?;
    let stick = stick_pressure(contact, c, position)?;
    Ok((slip - stick) * friction.copysign(tangential.si()))
}

/// (c/b)·p₀·√(1 − x²/c²): the Hertz pressure on the stick zone.
pub(super) fn stick_pressure(
    contact: &HertzLine,
    stick: Length,
    position: Length,
) -> Result<Pressure, ContactError> {
    if stick.si() == 0.0 {
        return Ok(Pressure::from_si(0.0));
    }
    let core = HertzLine {
        half_width: stick,
        max_pressure: contact.max_pressure * (stick / contact.half_width),
    };
    core.pressure(position)
}

/// |Q|/(μ·W), at most 1.
pub(super) fn held(
    contact: &HertzLine,
    friction: f64,
    tangential: LineLoad,
) -> Result<f64, ContactError> {
    DomainError::positive("largest pressure", contact.max_pressure)?;
    super::sliding::check_friction(friction)?;
    let most = friction * contact.load().si();
    let q = DomainError::finite("tangential load", tangential)?;
    DomainError::require(
        q.abs() <= most,
        "tangential load",
        q,
        "N/m",
        "must not exceed friction times the normal load: lower it or raise the friction",
    )?;
    Ok(q.abs() / most)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn contact() -> HertzLine {
        HertzLine {
            half_width: Length::from_si(1e-4),
            max_pressure: Pressure::from_si(1e9),
        }
    }

    #[test]
    fn the_traction_carries_the_tangential_load_and_nowhere_exceeds_friction() {
        let contact = contact();
        for share in [-1.0, -0.3, 0.5, 0.99] {
            let load = contact.load() * (0.2 * share);
            let points = 40_000_u32;
            let dx = 2e-4 / f64::from(points);
            let mut sum = 0.0;
            for i in 0..points {
                let x = Length::from_si((f64::from(i) + 0.5) * dx - 1e-4);
                let q = mindlin_traction(&contact, 0.2, load, x).unwrap().si();
                assert!(q * share >= 0.0);
                assert!(q.abs() <= 0.2 * contact.pressure(x).unwrap().si() * (1.0 + 1e-12));
                sum += q * dx;
            }
            // The midpoint rule at two square roots: n^-1.5.
            assert!((sum / load.si() - 1.0).abs() < 1e-6, "{share}");
        }
        assert!(
            mindlin_traction(&contact, 0.2, contact.load() * 0.21, Length::from_si(0.0)).is_err()
        );
        assert!(stick_half_width(&contact, 0.0, LineLoad::from_si(0.0)).is_err());
        assert!(stick_half_width(&contact, 0.2, LineLoad::from_si(f64::NAN)).is_err());
    }
}
