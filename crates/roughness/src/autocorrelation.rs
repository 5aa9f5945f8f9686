//! Autocorrelation of the heights of a profile.
//!
//! Source: Bendat and Piersol 2010 (unbiased estimate over the overlap).
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | ρ(τ) | autocorrelation, 1 at τ = 0 | - |
//! | τ | shift along the trace | m |
//!
//! A shift of k points averages the n − k products of the overlap. The estimate is unbiased, and noisy where the
//! overlap is short. The products are computed by fast Fourier transforms; the lengths use only the required number of
//! shifts.

use asperity_core::cite;
use asperity_core::numerics::{good_fft_length, real_transforms, sum};
use asperity_core::quantity::Length;
use asperity_core::{DomainError, Profile};
use realfft::num_complex::Complex;
use serde::{Deserialize, Serialize};

use crate::error::RoughnessError;

/// Autocorrelation lengths of a profile.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct AutocorrelationLengths {
    /// Shortest shift at which ρ falls to 0.2 (Ral of ISO 25178-2, for a profile); `None` if it never does.
    pub to_one_fifth: Option<Length>,
    /// Shortest shift at which ρ falls to 1/e; `None` if it never does.
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
/// let rho = autocorrelation(&wave)?;
/// assert!((rho[25] + 1.0).abs() < 1e-2 && (rho[50] - 1.0).abs() < 1e-2);
/// # Ok::<(), asperity_roughness::RoughnessError>(())
/// ```
pub fn autocorrelation(heights: &[f64]) -> Result<Vec<f64>, RoughnessError> {
    cite!("ACF-1");
    let n = at_least_two(heights)?.len();
    Ok(normalised(&products(&centred(heights)?, n), n))
}

fn at_least_two(heights: &[f64]) -> Result<&[f64], RoughnessError> {
    RoughnessError::at_least(heights.len(), 2, "the autocorrelation")?;
    Ok(heights)
}

/// Heights about their mean.
fn centred(heights: &[f64]) -> Result<Vec<f64>, DomainError> {
    let n = heights.len() as f64;
    let mean = heights.iter().sum::<f64>() / n;
    let z: Vec<f64> = heights.iter().map(|z| z - mean).collect();
    let square = sum(&z, |z| z * z);
    // Rounding errors of the mean are not roughness.
    let rounding = (f64::EPSILON * mean).powi(2) * n;
    DomainError::require(
        square > rounding && square.is_finite(),
        "mean square height",
        square / n,
        "m2",
        "must be positive: a flat profile has no autocorrelation",
    )?;
    Ok(z)
}

/// Σ z_i z_i+k for k = 0 .. `shifts` − 1. The spectra of the blocks are summed before the inverse transform.
fn products(z: &[f64], shifts: usize) -> Vec<f64> {
    // New points per transform, in units of the number of shifts: three of four points are new.
    const STEP: usize = 3;
    let step = (STEP * shifts).min(z.len());
    let length = good_fft_length(step + shifts);
    let (forward, inverse) = real_transforms(length);
    let mut signal = forward.make_input_vec();
    let (mut own, mut reached) = (forward.make_output_vec(), forward.make_output_vec());
    let mut total = vec![Complex::default(); own.len()];
    for start in (0..z.len()).step_by(step) {
        let mut transform = |points: usize, out: &mut [Complex<f64>]| {
            let block = &z[start..(start + points).min(z.len())];
            signal[..block.len()].copy_from_slice(block);
            signal[block.len()..].fill(0.0);
            let done = forward.process(&mut signal, out);
            debug_assert!(done.is_ok(), "buffers are made by the plan");
        };
        transform(step, &mut own);
        if start + step < z.len() {
            transform(step + shifts, &mut reached);
        } else {
            reached.copy_from_slice(&own);
        }
        for (total, (own, reached)) in total.iter_mut().zip(own.iter().zip(&reached)) {
            *total += own.conj() * reached;
        }
    }
    // The first and last coefficient of a real signal are real.
    total[0].im = 0.0;
    if let Some(last) = total.last_mut() {
        last.im = 0.0;
    }
    let done = inverse.process(&mut total, &mut signal);
    debug_assert!(done.is_ok(), "buffers are made by the plan");
    signal.truncate(shifts);
    signal
}

/// Products divided by their overlap of `n` − k points and normalised to 1 at k = 0.
fn normalised(products: &[f64], n: usize) -> Vec<f64> {
    cite!("ACF-1");
    let scale = n as f64 / products[0];
    let over_overlap = |(k, product): (usize, &f64)| product * scale / (n - k) as f64;
    products.iter().enumerate().map(over_overlap).collect()
}

/// Autocorrelation lengths, linear between points.
///
/// ```text
/// smallest τ with ρ(τ) = 0.2 and with ρ(τ) = 1/e                                   [ACF-2]
/// ```
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
/// let length = lengths(&profile)?.to_one_fifth.unwrap();
/// assert!((length.si() / (0.217_95 * 40e-6) - 1.0).abs() < 3e-3);
/// # Ok::<(), asperity_roughness::RoughnessError>(())
/// ```
pub fn lengths(profile: &Profile) -> Result<AutocorrelationLengths, RoughnessError> {
    cite!("ACF-2");
    const ONE_FIFTH: f64 = 0.2;
    // Most profiles are uncorrelated within `FIRST` shifts; few need more than eight times as many.
    const FIRST: usize = 4096;
    const MORE: usize = 8;
    let (n, spacing) = (profile.len(), profile.spacing());
    let z = centred(at_least_two(profile.heights())?)?;
    let mut shifts = FIRST.min(n);
    loop {
        let rho = normalised(&products(&z, shifts), n);
        let to_one_fifth = falls_to(&rho, ONE_FIFTH).map(|points| spacing * points);
        if to_one_fifth.is_some() || shifts == n {
            let to_one_over_e = falls_to(&rho, (-1.0_f64).exp()).map(|points| spacing * points);
            return Ok(AutocorrelationLengths {
                to_one_fifth,
                to_one_over_e,
            });
        }
        shifts = (MORE * shifts).min(n);
    }
}

/// Shift at which ρ first falls to `level`, in points.
fn falls_to(rho: &[f64], level: f64) -> Option<f64> {
    let k = rho
        .windows(2)
        .position(|pair| pair[0] > level && pair[1] <= level)?;
    Some(k as f64 + (rho[k] - level) / (rho[k] - rho[k + 1]))
}
