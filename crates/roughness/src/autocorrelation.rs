//! How far the heights of a profile know of each other.
//!
//! Source: Bendat and Piersol 2010 (unbiased estimate over the overlap).
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | ρ(τ) | autocorrelation, 1 at τ = 0 | - |
//! | τ | shift along the trace | m |
//!
//! Over the overlap means that a shift of k points averages n − k products: unbiased, and noisy where
//! little overlaps. All products come from one fast Fourier transform of the padded profile.

use asperity_core::numerics::good_fft_length;
use asperity_core::quantity::Length;
use asperity_core::{DomainError, Profile};
use realfft::RealFftPlanner;
use realfft::num_complex::Complex;
use serde::Serialize;

use crate::RoughnessError;

/// Lengths over which a profile forgets itself.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct AutocorrelationLengths {
    /// Shortest shift at which ρ falls to 0.2 (Ral of ISO 25178-2, in profile); none when it never does.
    pub to_one_fifth: Option<Length>,
    /// Shortest shift at which ρ falls to 1/e; none when it never does.
    pub to_one_over_e: Option<Length>,
}

/// ρ_k = (1/(n − k)) Σ (z_i − ⟨z⟩)(z_{i+k} − ⟨z⟩) / ((1/n) Σ (z_i − ⟨z⟩)²)       `[ACF-1]`
///
/// For all shifts k = 0 .. n − 1, in points.
///
/// # Errors
/// When there are fewer than two points, or the profile is flat.
///
/// ```
/// use asperity_roughness::autocorrelation::autocorrelation;
/// let wave: Vec<f64> = (0..1000).map(|i| (f64::from(i) / 50.0 * std::f64::consts::TAU).sin()).collect();
/// let found = autocorrelation(&wave)?;
/// assert!((found[25] + 1.0).abs() < 1e-2 && (found[50] - 1.0).abs() < 1e-2);
/// # Ok::<(), asperity_roughness::RoughnessError>(())
/// ```
pub fn autocorrelation(heights: &[f64]) -> Result<Vec<f64>, RoughnessError> {
    const LEAST: usize = 2;
    let n = heights.len();
    if n < LEAST {
        return Err(RoughnessError::TooFewPoints {
            points: n,
            needed: LEAST,
            purpose: "the autocorrelation",
        });
    }
    let mean = heights.iter().sum::<f64>() / n as f64;
    let length = good_fft_length(2 * n);
    let mut planner = RealFftPlanner::<f64>::new();
    let (forward, inverse) = (
        planner.plan_fft_forward(length),
        planner.plan_fft_inverse(length),
    );
    let mut signal = forward.make_input_vec();
    for (padded, z) in signal.iter_mut().zip(heights) {
        *padded = z - mean;
    }
    let square: f64 = signal.iter().map(|z| z * z).sum();
    // Rounding of a mean is no roughness.
    let rounding = (f64::EPSILON * mean).powi(2) * n as f64;
    if square <= rounding || !square.is_finite() {
        return Err(DomainError {
            name: "mean square height",
            value: square / n as f64,
            unit: "m2",
            rule: "must be positive: a flat profile has no autocorrelation",
        }
        .into());
    }
    let mut spectrum = forward.make_output_vec();
    let done = forward.process(&mut signal, &mut spectrum);
    debug_assert!(done.is_ok(), "buffers are made by the plan");
    for value in &mut spectrum {
        *value = Complex::new(value.norm_sqr(), 0.0);
    }
    let done = inverse.process(&mut spectrum, &mut signal);
    debug_assert!(done.is_ok(), "buffers are made by the plan");
    let scale = n as f64 / (length as f64 * square);
    let over_overlap = |(k, sum): (usize, &f64)| sum * scale / (n - k) as f64;
    Ok(signal[..n].iter().enumerate().map(over_overlap).collect())
}

/// Shifts at which ρ first falls to 0.2 and to 1/e, linear between points              `[ACF-2]`
///
/// # Errors
/// As [`autocorrelation`].
///
/// ```
/// use asperity_core::{Profile, quantity::Length};
/// use asperity_roughness::autocorrelation::lengths;
/// let wave = |i: usize| 1e-6 * (i as f64 / 400.0 * std::f64::consts::TAU).sin();
/// let profile = Profile::new(Length::from_si(0.1e-6), (0..40_000).map(wave).collect())?;
/// // cos(2π τ/λ) = 0.2 at τ = 0.2180 λ.
/// let found = lengths(&profile)?.to_one_fifth.unwrap();
/// assert!((found.si() / (0.217_95 * 40e-6) - 1.0).abs() < 3e-3);
/// # Ok::<(), asperity_roughness::RoughnessError>(())
/// ```
pub fn lengths(profile: &Profile) -> Result<AutocorrelationLengths, RoughnessError> {
    const ONE_FIFTH: f64 = 0.2;
    let rho = autocorrelation(profile.heights())?;
    let falls_to = |level: f64| {
        let k = rho
            .windows(2)
            .position(|pair| pair[0] > level && pair[1] <= level)?;
        let part = (rho[k] - level) / (rho[k] - rho[k + 1]);
        Some(profile.spacing() * (k as f64 + part))
    };
    Ok(AutocorrelationLengths {
        to_one_fifth: falls_to(ONE_FIFTH),
        to_one_over_e: falls_to((-1.0_f64).exp()),
    })
}
