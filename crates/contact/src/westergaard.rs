//! A wavy half-plane pressed on a flat one.
//!
//! Source: Westergaard 1939, Johnson 1985 section 13.2. Plane strain, elastic; the wave is shallow.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | Δ, λ | amplitude and wavelength: the undeformed gap is Δ·(1 − cos(2πx/λ)) | m |
//! | E* | reduced modulus | Pa |
//! | p̄, p* | mean pressure, mean pressure at which the gap closes everywhere | Pa |
//! | b | half width of each contact | m |
//! | ψ = πx/λ, ψ_b = πb/λ | angles | rad |

use std::f64::consts::PI;

use asperity_core::quantity::{Length, Pressure};
use asperity_core::{DomainError, cite};

use crate::error::ContactError;

/// Wave on one half-plane, or on both together.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wave {
    /// Amplitude Δ.
    pub amplitude: Length,
    /// Wavelength λ.
    pub wavelength: Length,
    /// Reduced modulus E*.
    pub modulus: Pressure,
}

impl Wave {
    /// p* = π·E*·Δ/λ                                                             [Westergaard-1]
    ///
    /// # Errors
    /// When amplitude, wavelength or modulus is not positive.
    ///
    /// ```
    /// use asperity_contact::westergaard::Wave;
    /// let wave = Wave { amplitude: "1 um".parse()?, wavelength: "1 mm".parse()?, modulus: "100 GPa".parse()? };
    /// assert!((wave.closing_pressure()?.si() - 314.159_265e6).abs() < 1.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn closing_pressure(&self) -> Result<Pressure, ContactError> {
        cite!("Westergaard-1");
        let amplitude = DomainError::positive("amplitude", self.amplitude)?;
        let wavelength = DomainError::positive("wavelength", self.wavelength)?;
        let modulus = DomainError::positive("reduced modulus", self.modulus)?;
        Ok(Pressure::from_si(PI * modulus * amplitude / wavelength))
    }

    /// sin²(πb/λ) = p̄/p*, so that the share of the surface in contact is 2b/λ    [Westergaard-2]
    ///
    /// # Errors
    /// When the mean pressure is not between 0 and p*, or the wave is not valid.
    pub fn half_width(&self, mean_pressure: Pressure) -> Result<Length, ContactError> {
        cite!("Westergaard-2");
        let angle = self.load_ratio(mean_pressure)?.sqrt().asin();
        Ok(self.wavelength * (angle / PI))
    }

    /// p(x) = (2·p̄·cos ψ/sin²ψ_b)·√(sin²ψ_b − sin²ψ) for |ψ| < ψ_b, else 0     [Westergaard-3]
    ///
    /// # Errors
    /// When the position is not finite, the mean pressure not between 0 and p*, or the wave is not
    /// valid.
    ///
    /// ```
    /// use asperity_contact::westergaard::Wave;
    /// let wave = Wave { amplitude: "1 um".parse()?, wavelength: "1 mm".parse()?, modulus: "100 GPa".parse()? };
    /// let mean = wave.closing_pressure()? * 0.25;
    /// let largest = wave.pressure(mean, "0 mm".parse()?)?;
    /// assert!((largest / mean - 4.0).abs() < 1e-14);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn pressure(
        &self,
        mean_pressure: Pressure,
        position: Length,
    ) -> Result<Pressure, ContactError> {
        cite!("Westergaard-3");
        let ratio = self.load_ratio(mean_pressure)?;
        let x = DomainError::finite("position", position)?;
        let psi = PI * x / self.wavelength.si();
        let below = ratio - psi.sin().powi(2);
        let ordinate = 2.0 * psi.cos().abs() / ratio * below.max(0.0).sqrt();
        Ok(mean_pressure * ordinate)
    }

    /// ḡ = 2·Δ·(½·cos²ψ_b + sin²ψ_b·ln sin ψ_b)                                  [Westergaard-4]
    ///
    /// # Errors
    /// When the mean pressure is not between 0 and p*, or the wave is not valid.
    pub fn mean_gap(&self, mean_pressure: Pressure) -> Result<Length, ContactError> {
        cite!("Westergaard-4");
        let ratio = self.load_ratio(mean_pressure)?;
        Ok(self.amplitude * (2.0 * (0.5 * (1.0 - ratio) + 0.5 * ratio * ratio.ln())))
    }

    /// p̄/p*
    fn load_ratio(&self, mean_pressure: Pressure) -> Result<f64, ContactError> {
        let ratio = mean_pressure / self.closing_pressure()?;
        DomainError::require(
            ratio > 0.0 && ratio < 1.0,
            "mean pressure over closing pressure",
            ratio,
            "-",
            "must lie between 0 and 1, where contact is partial",
        )?;
        Ok(ratio)
    }
}
