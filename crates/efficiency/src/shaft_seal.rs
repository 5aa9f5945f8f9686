//! Friction of radial shaft seals.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | d | diameter of the shaft under the lip | mm |
//! | n | rotational speed | 1/min |
//! | P | loss | W |
//!
//! Source: ISO/TR 14179-2, as quoted in open programs. They state neither lip, oil and
//! temperature nor the fitted range, and measured seals scatter widely about the formula.

use asperity_core::quantity::{Length, Torque};
use asperity_core::{DomainError, cite};

use crate::error::EfficiencyError;

/// Loss over d² n \[W min/mm²\] (ISO/TR 14179-2, quoted).
const SEAL: f64 = 7.69e-6;

/// Friction torque of a lip seal at any speed.
///
/// ```text
/// P = 7.69e-6 d² n, d in mm and n in 1/min; M = P/ω                                  [Seal-1]
/// ```
///
/// # Errors
/// When the diameter is not positive.
///
/// ```
/// use asperity_core::quantity::AngularSpeed;
/// use asperity_efficiency::shaft_seal::seal_torque;
/// let torque = seal_torque("40 mm".parse()?)?;
/// let speed: AngularSpeed = "3000 1/min".parse()?;
/// assert!((torque.si() * speed.si() - 36.912).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn seal_torque(diameter: Length) -> Result<Torque, EfficiencyError> {
    cite!("Seal-1");
    /// 1/min in one rad/s.
    const RPM: f64 = 30.0 / std::f64::consts::PI;
    let d = DomainError::positive("diameter", diameter)? * 1e3;
    Ok(Torque::from_si(SEAL * d * d * RPM))
}
