//! The mesh coefficient of friction of ISO/TR 14179-1.
//!
//! | symbol | meaning | unit in the formula |
//! |---|---|---|
//! | f_m | coefficient of friction of the whole mesh | - |
//! | ν | kinematic viscosity at the sump temperature | mm²/s |
//! | K | load intensity F_t/(b d_w1) · (z₁ + z₂)/z₂ | N/mm² |
//! | V | pitch line speed | m/s |
//!
//! Source: ISO/TR 14179-1:2001 (from AGMA). Range 2 to 25 m/s and 1.4 to 14 N/mm²; outside it
//! the report requires values from experience. The report's text was not available: formula and
//! range are textbook knowledge. The coefficient belongs to the report's own mesh loss
//! P = f_m T₁ n₁ cos²β_w/(9549 M); it is lower than a local one and falls with load.

use asperity_core::quantity::{KinematicViscosity, Pressure, Speed};
use asperity_core::{Checked, DomainError, FittedRange, cite};

use crate::error::FrictionError;

/// ISO/TR 14179-1: powers of ν and K.
const POWERS: (f64, f64) = (-0.223, -0.40);
/// ISO/TR 14179-1: divisor and power of V.
const SPEED: (f64, f64) = (3.239, 0.70);

const NAME: &str = "ISO/TR 14179-1";

/// ISO/TR 14179-1, range of the pitch line speed.
const SPEED_RANGE: FittedRange = FittedRange::new("pitch line speed", 2.0, 25.0, "m/s", NAME);

/// ISO/TR 14179-1, range of the load intensity.
const LOAD_RANGE: FittedRange = FittedRange::new("load intensity K", 1.4, 14.0, "N/mm2", NAME);

/// Mineral gear oils of ISO VG 32 to 1000 at the sump temperature (assumed).
const VISCOSITY_RANGE: FittedRange =
    FittedRange::new("kinematic viscosity", 5.0, 500.0, "mm2/s", NAME);

/// Mesh coefficient of friction of ISO/TR 14179-1.
///
/// ```text
/// f_m = ν^−0.223 K^−0.40/(3.239 V^0.70)                                  [ISO-14179-1]
/// ```
///
/// # Errors
/// When an input is not finite and positive.
///
/// ```
/// use asperity_tribo_friction::iso_14179_1::coefficient;
/// let f_m = coefficient("97.7 mm2/s".parse()?, "3.1096 MPa".parse()?, "11.79 m/s".parse()?)?;
/// assert!((f_m.value - 0.012552).abs() < 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn coefficient(
    kinematic_viscosity: KinematicViscosity,
    load_intensity: Pressure,
    pitch_line_speed: Speed,
) -> Result<Checked<f64>, FrictionError> {
    cite!("ISO-14179-1");
    let nu = DomainError::positive("kinematic viscosity", kinematic_viscosity)? * 1e6;
    let k = DomainError::positive("load intensity K", load_intensity)? * 1e-6;
    let v = DomainError::positive("pitch line speed", pitch_line_speed)?;
    let mut outside = Vec::new();
    SPEED_RANGE.check(v, &mut outside);
    LOAD_RANGE.check(k, &mut outside);
    VISCOSITY_RANGE.check(nu, &mut outside);
    Ok(Checked {
        value: nu.powf(POWERS.0) * k.powf(POWERS.1) / (SPEED.0 * v.powf(SPEED.1)),
        outside,
    })
}
