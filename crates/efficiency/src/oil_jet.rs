//! Loss of an oil jet: the oil is brought to the speed of the pitch circle.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | ρ | density of the oil | kg/m³ |
//! | Q | flow of the jet | m³/s |
//! | v_t, v_j | speeds of the pitch circle and of the jet | m/s |
//!
//! Source: Ariura, Ueno, Sunaga and Sunamoto 1973, as quoted in later papers; it is the momentum balance of the oil. The jet
//! is directed against the motion of the teeth, which is the upper bound of its momentum loss. Oil squeezed out of the
//! mesh is not included.

use asperity_core::quantity::{Density, Power, Speed, VolumeFlow};
use asperity_core::{DomainError, cite};

use crate::error::EfficiencyError;

/// Power that accelerates the oil of a jet to the pitch circle speed.
///
/// ```text
/// P = ρ Q v_t (v_t + v_j)                                                             [Jet-1]
/// ```
///
/// # Errors
/// When the density is not positive, or flow or a speed is negative.
///
/// ```
/// use asperity_efficiency::oil_jet::jet_power;
/// let power = jet_power(
///     "820 kg/m3".parse()?, "2.5 l/min".parse()?, "20 m/s".parse()?, "0.4 m/s".parse()?,
/// )?;
/// assert!((power.si() - 13.94).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn jet_power(
    density: Density,
    flow: VolumeFlow,
    pitch_speed: Speed,
    jet_speed: Speed,
) -> Result<Power, EfficiencyError> {
    cite!("Jet-1");
    let rho = DomainError::positive("density", density)?;
    let q = DomainError::non_negative("flow", flow)?;
    let v_t = DomainError::non_negative("pitch speed", pitch_speed)?;
    let v_j = DomainError::non_negative("jet speed", jet_speed)?;
    Ok(Power::from_si(rho * q * v_t * (v_t + v_j)))
}
