//! Weighted local parabolas at every point of a trace, for the robust filter.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | s_k | weights of the positions, symmetric, k = −m .. m | - |
//! | δ | weights of the points | - |
//! | S_j, T_j | Σ s_k δ_i+k uʲ and Σ s_k δ_i+k z_i+k uʲ, u = k/m | -, m |
//!
//! The sums are convolutions by fast Fourier transform in blocks that fit into the cache and overlap by m points: n log
//! m operations, ten real transforms per block. A symmetric kernel has a real transform and an antisymmetric kernel an
//! imaginary one, so one number per frequency is stored.

use std::sync::Arc;

use asperity_core::numerics::real_transforms;
use realfft::num_complex::Complex;
use realfft::{ComplexToReal, RealToComplex};

use crate::blocks::Blocks;

/// Minimum determinant for a parabola, relative to its change by an error of the full sums K₀, K₂, K₄: the transforms
/// are accurate to about 10⁻¹⁵ of the full sums, which leaves three digits.
const MIN_DETERMINANT: f64 = 1e-12;

/// The weighted points around a point do not define a parabola.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct NoParabola {
    /// Index of the point.
    pub at: usize,
}

/// Weighted local parabolas of traces of one length.
pub(crate) struct LocalParabolas {
    n: usize,
    m: usize,
    /// New points per block.
    step: usize,
    forward: Arc<dyn RealToComplex<f64>>,
    inverse: Arc<dyn ComplexToReal<f64>>,
    /// Transforms of s_k uʲ, j = 0 .. 4: real for even j, imaginary for odd.
    kernels: [Vec<f64>; 5],
    /// K₀, K₂, K₄: S₀, S₂, S₄ with unit weights δ, away from the ends.
    full: [f64; 3],
    signal: Vec<f64>,
    scratch: Vec<Complex<f64>>,
    product: Vec<Complex<f64>>,
    /// Transforms of δ and δ z.
    spectra: [Vec<Complex<f64>>; 2],
    /// S₀ .. S₄ and T₀ .. T₂ of a block.
    sums: [Vec<f64>; 8],
}

impl LocalParabolas {
    /// For traces of `n` points and `weights` s₀ .. s_m of one side, m < n.
    pub(crate) fn new(n: usize, weights: &[f64]) -> Self {
        let m = weights.len() - 1;
        let Blocks { length, step } = Blocks::new(n, m);
        let (forward, inverse) = real_transforms(length);
        let scratch = forward.get_scratch_len().max(inverse.get_scratch_len());
        let spectrum = forward.make_output_vec();
        let mut parabolas = Self {
            n,
            m,
            step,
            kernels: Default::default(),
            full: [0, 2, 4].map(|power| full_sum(weights, power)),
            signal: forward.make_input_vec(),
            scratch: vec![Complex::default(); scratch],
            product: spectrum.clone(),
            spectra: [spectrum.clone(), spectrum],
            sums: std::array::from_fn(|_| inverse.make_output_vec()),
            forward,
            inverse,
        };
        parabolas.kernels = [0, 1, 2, 3, 4].map(|power| parabolas.kernel(weights, power));
        parabolas
    }

    fn kernel(&mut self, weights: &[f64], power: i32) -> Vec<f64> {
        let length = self.signal.len();
        let even = power % 2 == 0;
        self.signal.fill(0.0);
        for (k, weight) in weights.iter().enumerate() {
            let u = k as f64 / self.m as f64;
            let value = weight * u.powi(power) / length as f64;
            // The sum at point i uses i + k: the kernel is reversed.
            self.signal[(length - k) % length] = value;
            self.signal[k] = if even || k == 0 { value } else { -value };
        }
        self.transform(0);
        let part = |c: &Complex<f64>| if even { c.re } else { c.im };
        self.spectra[0].iter().map(part).collect()
    }

    /// Heights of the local parabolas at their centres, for `weighted` = δ z with the weights δ.
    pub(crate) fn heights(
        &mut self,
        weights: &[f64],
        weighted: &[f64],
        heights: &mut [f64],
    ) -> Result<(), NoParabola> {
        for start in (0..self.n).step_by(self.step) {
            let end = (start + self.step).min(self.n);
            self.place(weights, start);
            self.transform(0);
            self.place(weighted, start);
            self.transform(1);
            for (sum, (spectrum, kernel)) in [
                (0, 0),
                (0, 1),
                (0, 2),
                (0, 3),
                (0, 4),
                (1, 0),
                (1, 1),
                (1, 2),
            ]
            .into_iter()
            .enumerate()
            {
                self.convolve(spectrum, kernel, sum);
            }
            solve(&self.sums, self.full, &mut heights[start..end])
                .map_err(|NoParabola { at }| NoParabola { at: start + at })?;
        }
        Ok(())
    }

    /// Copies the block from `start` into the signal, with the preceding points at the end of the signal.
    fn place(&mut self, x: &[f64], start: usize) {
        let (n, m, length) = (self.n, self.m, self.signal.len());
        let before = start.min(m);
        let after = (start + self.step + m).min(n) - start;
        self.signal[..after].copy_from_slice(&x[start..start + after]);
        self.signal[after..length - before].fill(0.0);
        self.signal[length - before..].copy_from_slice(&x[start - before..start]);
    }

    fn transform(&mut self, spectrum: usize) {
        let (signal, scratch) = (&mut self.signal, &mut self.scratch);
        let out = &mut self.spectra[spectrum];
        let done = self.forward.process_with_scratch(signal, out, scratch);
        debug_assert!(done.is_ok(), "buffers are made by the plan");
    }

    fn convolve(&mut self, spectrum: usize, power: usize, sum: usize) {
        let values = self.spectra[spectrum].iter().zip(&self.kernels[power]);
        if power.is_multiple_of(2) {
            for (out, (value, kernel)) in self.product.iter_mut().zip(values) {
                *out = value * kernel;
            }
        } else {
            for (out, (value, kernel)) in self.product.iter_mut().zip(values) {
                *out = Complex::new(-value.im * kernel, value.re * kernel);
            }
        }
        // The first and last coefficient of a real signal are real.
        self.product[0].im = 0.0;
        if let Some(last) = self.product.last_mut() {
            last.im = 0.0;
        }
        let (product, scratch) = (&mut self.product, &mut self.scratch);
        let out = &mut self.sums[sum];
        let done = self.inverse.process_with_scratch(product, out, scratch);
        debug_assert!(done.is_ok(), "buffers are made by the plan");
    }
}

/// Σ s_k uʲ over k = −m .. m, for even j.
fn full_sum(weights: &[f64], power: i32) -> f64 {
    let m = (weights.len() - 1) as f64;
    let terms = weights.iter().enumerate().skip(1);
    let side: f64 = terms.map(|(k, s)| s * (k as f64 / m).powi(power)).sum();
    2.0 * side + if power == 0 { weights[0] } else { 0.0 }
}

/// The first unknown of S (a b c)ᵀ = T at every point, by Cramer's rule.
fn solve(
    sums: &[Vec<f64>; 8],
    [k0, k2, k4]: [f64; 3],
    heights: &mut [f64],
) -> Result<(), NoParabola> {
    let count = heights.len();
    let [s0, s1, s2, s3, s4, t0, t1, t2] = sums.each_ref().map(|sum| &sum[..count]);
    let mut supported = true;
    let determined = |i: usize| {
        let others = [[s1[i], s2[i]], [s2[i], s3[i]], [s3[i], s4[i]]];
        let determinant = determinant([s0[i], s1[i], s2[i]], others);
        let height = self::determinant([t0[i], t1[i], t2[i]], others) / determinant;
        let error = k0 * s2[i] * s4[i] + s0[i] * k2 * s4[i] + s0[i] * s2[i] * k4;
        let supported = error > 0.0 && s0[i] > 0.0 && determinant > MIN_DETERMINANT * error;
        (height, supported)
    };
    for (i, height) in heights.iter_mut().enumerate() {
        let (solution, is_supported) = determined(i);
        *height = solution;
        supported &= is_supported;
    }
    if supported {
        return Ok(());
    }
    let at = (0..count).find(|&i| !determined(i).1);
    Err(NoParabola {
        at: at.unwrap_or(0),
    })
}

/// The determinant of three rows, each its `first` element and the two `others`.
fn determinant(first: [f64; 3], others: [[f64; 2]; 3]) -> f64 {
    let [[b0, c0], [b1, c1], [b2, c2]] = others;
    let [minor, of_b, of_c] = [
        b1 * c2 - b2 * c1,
        first[1] * c2 - first[2] * c1,
        first[1] * b2 - first[2] * b1,
    ];
    first[0] * minor - b0 * of_b + c0 * of_c
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bell(m: usize) -> Vec<f64> {
        (0..=m)
            .map(|k| (-8.0 * (k as f64 / m as f64).powi(2)).exp())
            .collect()
    }

    #[test]
    fn parabolas_in_blocks_are_those_of_direct_sums() {
        // 20 000 points make three blocks of 8192, with a reach of 40 over every border.
        let (n, s) = (20_000, bell(40));
        let z: Vec<f64> = (0..n)
            .map(|i| ((i * 37) % 101) as f64 / 50.0 - 1.0)
            .collect();
        let delta: Vec<f64> = (0..n).map(|i| ((i * i) % 7) as f64 / 6.0).collect();
        let weighted: Vec<f64> = z.iter().zip(&delta).map(|(z, delta)| z * delta).collect();
        let mut fast = vec![0.0; n];
        let mut parabolas = LocalParabolas::new(n, &s);
        assert!(parabolas.step < n);
        parabolas.heights(&delta, &weighted, &mut fast).unwrap();
        for i in (0..n).step_by(61).chain([n - 1]) {
            let (mut sums, mut products) = ([0.0; 5], [0.0; 3]);
            for j in i.saturating_sub(40)..(i + 41).min(n) {
                let u = (j as f64 - i as f64) / 40.0;
                let weight = s[i.abs_diff(j)] * delta[j];
                for (power, sum) in sums.iter_mut().enumerate() {
                    *sum += weight * u.powi(power as i32);
                }
                for (power, product) in products.iter_mut().enumerate() {
                    *product += weight * z[j] * u.powi(power as i32);
                }
            }
            let mut slow = [0.0];
            let all = sums.into_iter().chain(products).map(|sum| vec![sum]);
            let all: Vec<Vec<f64>> = all.collect();
            solve(&all.try_into().unwrap(), parabolas.full, &mut slow).unwrap();
            // Heights of size one, determinants a hundredth of their terms at the ends.
            assert!(
                (fast[i] - slow[0]).abs() < 1e-11,
                "{i}: {} {}",
                fast[i],
                slow[0]
            );
        }
    }

    #[test]
    fn a_gap_wider_than_the_weights_is_found_where_it_starts() {
        let (n, s) = (1000, bell(40));
        let delta: Vec<f64> = (0..n)
            .map(|i| if (300..600).contains(&i) { 0.0 } else { 1.0 })
            .collect();
        let mut heights = vec![0.0; n];
        let found = LocalParabolas::new(n, &s).heights(&delta, &delta, &mut heights);
        // Past 337 fewer than three points are in reach, and three far ones are no basis either.
        let at = found.unwrap_err().at;
        assert!((325..=338).contains(&at), "{at}");
    }
}
