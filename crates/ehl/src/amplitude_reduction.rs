//! Remaining amplitude of waves that pass through a lubricated line contact in pure rolling.
//!
//! Small waves of one length and any contact fall on one curve over ∇. Source of the curve: Venner,
//! Couhier, Lubrecht, Greenwood 1997; its constants are from memory, source not reached, and agree
//! with this solver within 10 % for ∇ from 2 to 8 (at 14 they read a fifth low).

use asperity_core::quantity::Length;
use asperity_core::{DomainError, cite};

use crate::dimensionless::Scales;
use crate::error::EhlError;

/// ∇ = (λ/a)·M^(3/4)·L^(−1/2) of a wave of the length λ.
///
/// # Errors
/// When the wavelength is not positive or the oil is isoviscous.
pub fn wave_parameter(wavelength: Length, scales: &Scales) -> Result<f64, EhlError> {
    let wave = DomainError::positive("wavelength", wavelength)? / scales.half_width.si();
    let l = DomainError::require(
        scales.moes_lubricant > 0.0,
        "Moes' lubricant parameter",
        scales.moes_lubricant,
        "-",
        "must be positive",
    )?;
    Ok(wave * scales.moes_load.powf(0.75) / l.sqrt())
}

/// A_d/A_i = 1/(1 + 0.125·∇ + 0.04·∇²)                            `[Amplitude-reduction]`
///
/// ```
/// use asperity_ehl::amplitude_reduction::remaining_amplitude;
/// assert_eq!(remaining_amplitude(0.0), 1.0);
/// assert!((remaining_amplitude(3.51) - 0.518).abs() < 1e-3);
/// ```
pub fn remaining_amplitude(wave_parameter: f64) -> f64 {
    cite!("Amplitude-reduction");
    1.0 / (1.0 + wave_parameter * (0.125 + 0.04 * wave_parameter))
}
