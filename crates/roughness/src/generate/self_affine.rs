//! Self-affine profiles with a roll-off.
//!
//! Source: Jacobs, Junge, Pastewka 2017 (spectra of rough surfaces), random phases.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | C(q) | power spectral density of the profile | m³ |
//! | q | wave number 2π/λ | 1/m |
//! | H | Hurst exponent, 0 < H < 1 | - |
//! | λ_r, λ_s | wavelengths of roll-off and short cut-off | m |

use std::f64::consts::TAU;

use asperity_core::cite;
use asperity_core::numerics::real_transforms;
use asperity_core::quantity::Length;
use asperity_core::{DomainError, Profile};
use realfft::num_complex::Complex;
use serde::{Deserialize, Serialize};

use super::random::Random;
use super::scaling::{check_points, scaled};

/// Amplitudes of the waves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
#[non_exhaustive]
pub enum Amplitudes {
    /// Exactly √C, so that every line of the spectrum follows the recipe.
    #[default]
    Fixed,
    /// √C times a Rayleigh-distributed number, as on a finite length of a Gaussian surface.
    Random,
}

/// Recipe of a self-affine profile. The profile is periodic over its length.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct SelfAffine {
    /// Number of points.
    pub points: usize,
    /// Distance between points.
    pub spacing: Length,
    /// Root mean square height.
    pub rq: Length,
    /// Hurst exponent.
    pub hurst: f64,
    /// Wavelength above which the spectrum is flat.
    pub roll_off: Length,
    /// Wavelength below which the spectrum is zero; at least two spacings.
    pub short_cut: Length,
    /// Seed of the random phases.
    pub seed: u64,
}

impl SelfAffine {
    /// C(q) = C₀ for q < q_r,  C₀ (q/q_r)^−(1+2H) for q_r ≤ q ≤ q_s,  0 above      [Affine-1]
    ///
    /// Random phases, C₀ such that the root mean square height is Rq.
    ///
    /// # Errors
    /// When H is not within 0 .. 1, a length is not positive, or no wave fits between the length of
    /// the profile and the short cut-off.
    ///
    /// ```
    /// use asperity_core::quantity::Length;
    /// use asperity_roughness::generate::SelfAffine;
    /// let recipe = SelfAffine {
    ///     points: 4096, spacing: Length::from_si(0.5e-6), rq: Length::from_si(0.3e-6), hurst: 0.8,
    ///     roll_off: Length::from_si(100e-6), short_cut: Length::from_si(5e-6), seed: 7,
    /// };
    /// let profile = recipe.generate()?;
    /// let square: f64 = profile.heights().iter().map(|z| z * z).sum::<f64>() / 4096.0;
    /// assert!((square.sqrt() - 0.3e-6).abs() < 1e-18);
    /// assert_eq!(profile, recipe.generate()?);
    /// # Ok::<(), asperity_core::DomainError>(())
    /// ```
    pub fn generate(&self) -> Result<Profile, DomainError> {
        cite!("Affine-1");
        self.generate_with(Amplitudes::Fixed)
    }

    /// As [`generate`](Self::generate), with a choice of amplitudes.
    ///
    /// # Errors
    /// As [`generate`](Self::generate).
    pub fn generate_with(&self, amplitudes: Amplitudes) -> Result<Profile, DomainError> {
        cite!("Affine-1");
        let n = check_points(self.points)?;
        let dx = DomainError::positive("spacing", self.spacing)?;
        let h = DomainError::require(
            self.hurst > 0.0 && self.hurst < 1.0,
            "hurst",
            self.hurst,
            "-",
            "must lie between 0 and 1",
        )?;
        let roll_off = DomainError::positive("roll-off", self.roll_off)?;
        let short_cut = DomainError::positive("short cut-off", self.short_cut)?;
        DomainError::require(
            short_cut >= 2.0 * dx,
            "short cut-off",
            short_cut,
            "m",
            "must be at least two spacings",
        )?;
        DomainError::require(
            n as f64 * dx >= short_cut,
            "length",
            n as f64 * dx,
            "m",
            "must not be shorter than the short cut-off",
        )?;
        let (q_r, q_s) = (TAU / roll_off, TAU / short_cut);
        let (_, plan) = real_transforms(n);
        let mut spectrum = plan.make_input_vec();
        let mut random = Random::new(self.seed);
        for (k, value) in spectrum.iter_mut().enumerate() {
            let phase = TAU * random.uniform();
            let q = TAU * k as f64 / (n as f64 * dx);
            // The wave at half the sampling frequency has no independent phase.
            if k == 0 || 2 * k >= n || q > q_s * (1.0 + f64::EPSILON) {
                continue;
            }
            let density = (q / q_r).max(1.0).powf(-(1.0 + 2.0 * h));
            let amplitude = match amplitudes {
                Amplitudes::Fixed => density.sqrt(),
                // Rayleigh distribution: magnitude of two normal numbers.
                Amplitudes::Random => (-density * (1.0 - random.uniform()).ln()).sqrt(),
            };
            *value = Complex::from_polar(amplitude, phase);
        }
        let mut heights = plan.make_output_vec();
        let done = plan.process(&mut spectrum, &mut heights);
        debug_assert!(done.is_ok(), "buffers are made by the plan");
        scaled(self.spacing, heights, self.rq)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spectral::power_spectrum;

    #[test]
    fn the_spectrum_falls_with_the_hurst_exponent_between_its_cut_offs() {
        let recipe = SelfAffine {
            points: 1 << 16,
            spacing: Length::from_si(0.5e-6),
            rq: Length::from_si(0.3e-6),
            hurst: 0.8,
            roll_off: Length::from_si(200e-6),
            short_cut: Length::from_si(4e-6),
            seed: 11,
        };
        let found = power_spectrum(&recipe.generate().unwrap()).unwrap();
        let power = |wavelength: f64| {
            let k = (1.0 / wavelength / found.frequency_step) as usize;
            let band = &found.density[k * 9 / 10..k * 11 / 10];
            band.iter().sum::<f64>() / band.len() as f64
        };
        // Means over a band of some hundred lines with phases at random: within ten percent.
        let slope = (power(8e-6) / power(80e-6)).log10();
        assert!((slope + 2.6).abs() < 0.1, "{slope}");
        assert!((power(400e-6) / power(1000e-6) - 1.0).abs() < 0.5);
        assert!(power(3e-6) < 1e-6 * power(5e-6));
    }
}
