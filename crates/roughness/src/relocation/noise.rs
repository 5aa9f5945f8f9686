//! Noise of the match: its autocovariance in the valleys, its effect on a sum, and made noise of this kind.

use asperity_core::cite;
use asperity_core::numerics::{good_fft_length, real_transforms};
use realfft::num_complex::Complex;
use std::f64::consts::TAU;

use crate::generate::Random;

/// Longest lag \[m\] and in lengths of the overlap.
const LONGEST: f64 = 100e-6;
const LONGEST_SHARE: f64 = 0.1;
/// Least variance over the variance without correlation.
const LEAST_SHARE: f64 = 0.25;

/// Autocovariance of the noise.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Noise {
    /// γ at each lag, tapered \[m²\].
    covariance: Vec<f64>,
}

impl Noise {
    /// ```text
    /// γ_k = (1 − k/K) ⟨r_i r_i+k⟩                                                                [Relocation-3]
    /// ```
    ///
    /// Over the pairs of residuals r of the match that count, which are in the valleys and no outliers, `dx` apart.
    pub(super) fn new(residuals: &[f64], counts: &[bool], dx: f64) -> Self {
        cite!("Relocation-3");
        let n = residuals.len();
        let longest = (LONGEST / dx).min(LONGEST_SHARE * n as f64).max(1.0) as usize;
        let weights: Vec<f64> = counts
            .iter()
            .map(|counts| f64::from(u8::from(*counts)))
            .collect();
        let product: Vec<f64> = residuals.iter().zip(&weights).map(|(r, w)| r * w).collect();
        let lag = |k: usize| {
            let sum: f64 = product.iter().zip(&product[k..]).map(|(a, b)| a * b).sum();
            let norm: f64 = weights.iter().zip(&weights[k..]).map(|(a, b)| a * b).sum();
            let taper = 1.0 - k as f64 / longest as f64;
            if norm > 0.0 { taper * sum / norm } else { 0.0 }
        };
        Self {
            covariance: (0..longest).map(lag).collect(),
        }
    }

    /// Standard deviation \[m\].
    pub(crate) fn deviation(&self) -> f64 {
        self.covariance[0].max(0.0).sqrt()
    }

    /// Variance of Σ a_i n_i; errors of the covariance may not lower it below a part of the variance without correlation.
    pub(super) fn variance(&self, a: &[f64]) -> f64 {
        let sum = |k: usize| -> f64 { a.iter().zip(&a[k..]).map(|(x, y)| x * y).sum() };
        let lags = self.covariance.iter().enumerate().skip(1);
        let white = self.covariance[0] * sum(0);
        let rest: f64 = lags.map(|(k, covariance)| 2.0 * covariance * sum(k)).sum();
        (white + rest).max(LEAST_SHARE * white)
    }

    /// Noise of this kind at `points` points.
    pub(crate) fn made(&self, points: usize, random: &mut Random) -> Vec<f64> {
        let length = good_fft_length(points + 2 * self.covariance.len());
        let (forward, inverse) = real_transforms(length);
        let mut row = vec![0.0; length];
        for (k, covariance) in self.covariance.iter().enumerate() {
            row[k] = *covariance;
            row[(length - k) % length] = *covariance;
        }
        let mut lines = forward.make_output_vec();
        let done = forward.process(&mut row, &mut lines);
        debug_assert!(done.is_ok(), "buffers are made by the plan");
        let last = lines.len() - 1;
        for (k, line) in lines.iter_mut().enumerate() {
            // A density below zero is an error of the estimate.
            let amplitude = (line.re.max(0.0) / length as f64).sqrt();
            let phase = TAU * random.uniform();
            *line = if k == 0 || k == last {
                Complex::new(amplitude * (2.0_f64).sqrt() * phase.cos(), 0.0)
            } else {
                Complex::from_polar(amplitude, phase)
            };
        }
        let mut noise = inverse.make_output_vec();
        let done = inverse.process(&mut lines, &mut noise);
        debug_assert!(done.is_ok(), "buffers are made by the plan");
        noise.truncate(points);
        noise
    }
}
