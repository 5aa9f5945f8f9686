//! Spectral moments, slopes, curvatures and the power spectral density of a profile.
//!
//! Source: Nayak 1971 (moments), Chetwynd 1978 (7-point slope); Welch 1967 for the window.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | m₀, m₂, m₄ | mean squares of height, slope, curvature | m², -, 1/m² |
//! | f | spatial frequency | 1/m |
//! | C(f) | one-sided power spectral density | m³ |
//!
//! Without a λ_s filter m₄ increases without bound as the spacing decreases: moments are stated with λ_s and dx. They
//! are not computed from a periodogram without a window, whose leakage would make m₄ up to three times too large.

use std::f64::consts::{PI, TAU};

use asperity_core::cite;
use asperity_core::numerics::{real_transforms, sum};
use asperity_core::quantity::Length;
use asperity_core::{DomainError, Profile};
use serde::{Deserialize, Serialize};

use crate::error::RoughnessError;

/// Mean squares of a profile and its derivatives.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct SpectralMoments {
    /// Mean square height about the mean `[m²]`.
    pub m0: f64,
    /// Mean square slope, 7-point.
    pub m2: f64,
    /// Mean square curvature, 3-point [1/m²].
    pub m4: f64,
    /// Spacing of the derivatives.
    pub spacing: Length,
}

/// z′ᵢ = (zᵢ₊₃ − 9 zᵢ₊₂ + 45 zᵢ₊₁ − 45 zᵢ₋₁ + 9 zᵢ₋₂ − zᵢ₋₃)/(60 dx)              [Slope-1]
///
/// Slopes of `heights` `[m]` at `dx` `[m]`, without the three points at each end; empty for fewer than 7 points.
///
/// ```
/// let slopes = asperity_roughness::spectral::slopes(&[0.0, 2.0, 4.0, 6.0, 8.0, 10.0, 12.0], 1.0);
/// assert_eq!(slopes, [2.0]);
/// ```
pub fn slopes(heights: &[f64], dx: f64) -> Vec<f64> {
    cite!("Slope-1");
    each_slope(heights, dx).collect()
}

/// Iterator over the slopes.
pub(crate) fn each_slope(heights: &[f64], dx: f64) -> impl Iterator<Item = f64> {
    cite!("Slope-1");
    let slope =
        move |z: &[f64]| (z[6] - z[0] - 9.0 * (z[5] - z[1]) + 45.0 * (z[4] - z[2])) / (60.0 * dx);
    heights.windows(7).map(slope)
}

/// m₀ = ⟨z²⟩,  m₂ = ⟨z′²⟩ (7-point),  m₄ = ⟨z″²⟩ (3-point)                        [Moment-1]
///
/// # Errors
/// When the profile has fewer than seven points.
///
/// ```
/// use asperity_core::{Profile, quantity::Length};
/// use asperity_roughness::spectral::moments;
/// let k = 2.0 * std::f64::consts::PI / 100e-6;
/// let wave = |i: usize| 1e-6 * (k * 1e-6 * i as f64).sin();
/// let profile = Profile::new(Length::from_si(1e-6), (0..10_000).map(wave).collect())?;
/// let moments = moments(&profile)?;
/// assert!((moments.m2 / (0.5e-12 * k * k) - 1.0).abs() < 1e-3);
/// # Ok::<(), asperity_roughness::RoughnessError>(())
/// ```
pub fn moments(profile: &Profile) -> Result<SpectralMoments, RoughnessError> {
    cite!("Moment-1");
    const MIN_POINTS: usize = 7;
    let (z, dx) = (profile.heights(), profile.spacing().si());
    RoughnessError::at_least(z.len(), MIN_POINTS, "spectral moments")?;
    let mean = sum(z, |z| z) / z.len() as f64;
    let curvature = |z: &[f64]| (z[0] - 2.0 * z[1] + z[2]) / (dx * dx);
    Ok(SpectralMoments {
        m0: sum(z, |z| (z - mean).powi(2)) / z.len() as f64,
        m2: mean_square(each_slope(z, dx)),
        m4: mean_square(z.windows(3).map(curvature)),
        spacing: profile.spacing(),
    })
}

/// ⟨v²⟩; 0 for no values.
pub(crate) fn mean_square(values: impl Iterator<Item = f64>) -> f64 {
    let (sum, count) = values.fold((0.0, 0_usize), |(sum, count), v| (sum + v * v, count + 1));
    sum / count.max(1) as f64
}

impl SpectralMoments {
    /// α = m₀ m₄/m₂²                                                          `[Nayak-2]`
    ///
    /// Bandwidth: 1 for a single wave, larger for a profile with many length scales. `None` for a profile without
    /// slope.
    ///
    /// ```
    /// use asperity_core::{Profile, quantity::Length};
    /// let wave = |i: usize| 1e-6 * (i as f64 / 100.0 * std::f64::consts::TAU).sin();
    /// let profile = Profile::new(Length::from_si(1e-6), (0..10_000).map(wave).collect())?;
    /// let moments = asperity_roughness::spectral::moments(&profile)?;
    /// // ⟨sin²⟩ ⟨sin²⟩/⟨cos²⟩² = 1 for one wave of even height.
    /// assert!((moments.bandwidth().unwrap() - 1.0).abs() < 1e-3);
    /// # Ok::<(), asperity_roughness::RoughnessError>(())
    /// ```
    pub fn bandwidth(&self) -> Option<f64> {
        cite!("Nayak-2");
        Some(self.m0 * self.m4 / (self.m2 * self.m2)).filter(|alpha| alpha.is_finite())
    }
}

/// A one-sided power spectral density.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct PowerSpectrum {
    /// Step of the spatial frequency [1/m]; entry k of `density` is at k times the step.
    pub frequency_step: f64,
    /// C(f) `[m³]`; its integral over f from 0 is the windowed mean square height.
    pub density: Vec<f64>,
}

/// C(f_k) = 2 dx |Σ h_i (z_i − ⟨z⟩) e^(−2πi f_k x_i)|²/Σ h_i²,  f_k = k/(N dx)               [PSD-1]
///
/// One-sided: the ends k = 0 and, for even N, k = N/2 are not doubled. h is the Hann window,
/// h_i = ½ (1 − cos 2πi/(N − 1)).
///
/// # Errors
/// When the profile has fewer than four points.
///
/// ```
/// use asperity_core::{Profile, quantity::Length};
/// use asperity_roughness::spectral::power_spectrum;
/// let wave = |i: usize| 1e-6 * (i as f64 / 50.0 * std::f64::consts::TAU).sin();
/// let profile = Profile::new(Length::from_si(1e-6), (0..1000).map(wave).collect())?;
/// let spectrum = power_spectrum(&profile)?;
/// let power: f64 = spectrum.density.iter().sum::<f64>() * spectrum.frequency_step;
/// assert!((power / 0.5e-12 - 1.0).abs() < 1e-4);
/// # Ok::<(), asperity_roughness::RoughnessError>(())
/// ```
pub fn power_spectrum(profile: &Profile) -> Result<PowerSpectrum, RoughnessError> {
    cite!("PSD-1");
    const MIN_POINTS: usize = 4;
    let (n, dx) = (profile.len(), profile.spacing().si());
    RoughnessError::at_least(n, MIN_POINTS, "a spectrum")?;
    let window = |i: usize| 0.5 * (1.0 - (TAU * i as f64 / (n - 1) as f64).cos());
    let (plan, _) = real_transforms(n);
    // The window would leak a mean height into the longest waves.
    let mean = profile.heights().iter().sum::<f64>() / n as f64;
    let centred = profile.heights().iter().map(|z| z - mean).enumerate();
    let mut signal: Vec<f64> = centred.map(|(i, z)| window(i) * z).collect();
    let mut spectrum = plan.make_output_vec();
    let done = plan.process(&mut signal, &mut spectrum);
    debug_assert!(done.is_ok(), "buffers are made by the plan");
    // Σ h² of a Hann window with zeros at its ends.
    let squares = 0.375 * (n - 1) as f64;
    let density = spectrum.iter().enumerate().map(|(k, value)| {
        let sides = if k == 0 || 2 * k == n { 1.0 } else { 2.0 };
        sides * dx * value.norm_sqr() / squares
    });
    Ok(PowerSpectrum {
        density: density.collect(),
        frequency_step: 1.0 / (n as f64 * dx),
    })
}

/// κ_s = √(π m₄/2)                                                            [Nayak-1]
///
/// Mean curvature [1/m] of the summits of a Gaussian profile with fourth moment `m4` [1/m²].
///
/// # Errors
/// When m₄ is negative or not finite.
///
/// ```
/// let curvature = asperity_roughness::spectral::gaussian_summit_curvature(2.0 / std::f64::consts::PI)?;
/// assert!((curvature - 1.0).abs() < 1e-15);
/// # Ok::<(), asperity_core::DomainError>(())
/// ```
pub fn gaussian_summit_curvature(m4: f64) -> Result<f64, DomainError> {
    cite!("Nayak-1");
    let m4 = DomainError::require(
        m4.is_finite() && m4 >= 0.0,
        "m4",
        m4,
        "1/m2",
        "must be finite and not negative",
    )?;
    Ok((0.5 * PI * m4).sqrt())
}
