//! A flat strip pressed on a half-plane.
//!
//! Source: Johnson 1985, section 2.8 (a). The pressure is singular at the edges.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | W | load per metre of face width | N/m |
//! | b | half width of the strip | m |
//! | E* | reduced modulus | Pa |
//! | D | datum distance | m |

use std::f64::consts::PI;

use asperity_core::quantity::{Length, LineLoad, Pressure};
use asperity_core::{DomainError, cite};

use crate::error::ContactError;

/// p(x) = W/(π·√(b² − x²)) for |x| < b                                              [Punch-1]
///
/// # Errors
/// When the load is negative, the half width not positive, or the position not under the strip.
///
/// ```
/// use asperity_contact::flat_punch::pressure;
/// let middle = pressure("1 N/mm".parse()?, "1 mm".parse()?, "0 mm".parse()?)?;
/// assert!((middle.si() - 1e6 / std::f64::consts::PI).abs() < 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn pressure(
    load: LineLoad,
    half_width: Length,
    position: Length,
) -> Result<Pressure, ContactError> {
    cite!("Punch-1");
    let w = DomainError::non_negative("load", load)?;
    let b = DomainError::positive("half width", half_width)?;
    let x = position.si();
    DomainError::require(x.abs() < b, "position", x, "m", "must lie under the strip")?;
    Ok(Pressure::from_si(w / (PI * ((b - x) * (b + x)).sqrt())))
}

/// δ(D) = (2·W/(π·E*))·ln(2·D/b)                                                    [Punch-2]
///
/// # Errors
/// When the load is negative, or modulus, half width or datum distance is not positive.
///
/// ```
/// use asperity_contact::flat_punch::approach;
/// let delta = approach("300 N/mm".parse()?, "0.1 mm".parse()?, "115 GPa".parse()?, "1 mm".parse()?)?;
/// assert!((delta.si() - 4.9752e-6).abs() < 1e-10);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn approach(
    load: LineLoad,
    half_width: Length,
    modulus: Pressure,
    datum: Length,
) -> Result<Length, ContactError> {
    cite!("Punch-2");
    let w = DomainError::non_negative("load", load)?;
    let b = DomainError::positive("half width", half_width)?;
    let e = DomainError::positive("reduced modulus", modulus)?;
    let d = DomainError::positive("datum distance", datum)?;
    Ok(Length::from_si(2.0 * w / (PI * e) * (2.0 * d / b).ln()))
}
