//! Products with symmetric Toeplitz matrices by circulant embedding and real transforms.

use std::sync::Arc;

use asperity_fourier::real_transforms;
use realfft::num_complex::Complex;
use realfft::{ComplexToReal, RealToComplex};

use super::fft_length::good_fft_length;

/// y = T x for a symmetric Toeplitz matrix T, in O(n log n), without allocation per product.
///
/// T is given by its first column c, T_ij = c_|i−j|; entries beyond the column are zero, so a
/// filter kernel is given by its right half. The circulant that embeds T is symmetric, hence its
/// symbol is real: one real number per frequency is stored.
///
/// ```
/// use asperity_core::numerics::SymmetricToeplitz;
/// let mut smooth = SymmetricToeplitz::new(&[0.5, 0.25], 3);
/// let mut out = [0.0; 3];
/// smooth.apply(&[0.0, 4.0, 0.0], &mut out);
/// assert!((out[0] - 1.0).abs() < 1e-15 && (out[1] - 2.0).abs() < 1e-15);
/// ```
pub struct SymmetricToeplitz {
    size: usize,
    symbol: Vec<f64>,
    forward: Arc<dyn RealToComplex<f64>>,
    inverse: Arc<dyn ComplexToReal<f64>>,
    padded: Vec<f64>,
    spectrum: Vec<Complex<f64>>,
    scratch: Vec<Complex<f64>>,
}

impl SymmetricToeplitz {
    /// The `size` × `size` matrix whose first column starts with `first_column`.
    pub fn new(first_column: &[f64], size: usize) -> Self {
        let reach = first_column.len().min(size);
        let length = good_fft_length(size + reach.max(1) - 1);
        let (forward, inverse) = real_transforms(length);
        let mut padded = forward.make_input_vec();
        let mut spectrum = forward.make_output_vec();
        let scratch_length = forward.get_scratch_len().max(inverse.get_scratch_len());
        let mut scratch = vec![Complex::default(); scratch_length];
        for (lag, &value) in first_column[..reach].iter().enumerate() {
            padded[lag] = value;
            padded[(length - lag) % length] = value;
        }
        transform(&*forward, &mut padded, &mut spectrum, &mut scratch);
        let symbol = spectrum.iter().map(|c| c.re / length as f64).collect();
        Self {
            size,
            symbol,
            forward,
            inverse,
            padded,
            spectrum,
            scratch,
        }
    }

    /// Number of rows.
    pub fn size(&self) -> usize {
        self.size
    }

    /// Writes T·`input` into `output`; both have [`size`](Self::size) elements, of which the
    /// common part counts when they do not.
    pub fn apply(&mut self, input: &[f64], output: &mut [f64]) {
        let count = self.size.min(input.len());
        self.padded[..count].copy_from_slice(&input[..count]);
        self.padded[count..].fill(0.0);
        transform(
            &*self.forward,
            &mut self.padded,
            &mut self.spectrum,
            &mut self.scratch,
        );
        for (value, symbol) in self.spectrum.iter_mut().zip(&self.symbol) {
            *value *= symbol;
        }
        // The first and, for even lengths, the last coefficient of a real signal are real.
        self.spectrum[0].im = 0.0;
        if let Some(last) = self.spectrum.last_mut() {
            last.im = 0.0;
        }
        let done = self.inverse.process_with_scratch(
            &mut self.spectrum,
            &mut self.padded,
            &mut self.scratch,
        );
        debug_assert!(done.is_ok(), "buffers are made by the plan");
        let count = self.size.min(output.len());
        output[..count].copy_from_slice(&self.padded[..count]);
    }
}

fn transform(
    plan: &dyn RealToComplex<f64>,
    signal: &mut [f64],
    spectrum: &mut [Complex<f64>],
    scratch: &mut [Complex<f64>],
) {
    let done = plan.process_with_scratch(signal, spectrum, scratch);
    debug_assert!(done.is_ok(), "buffers are made by the plan");
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_fast_product_equals_the_direct_sum() {
        for (size, reach) in [(1, 1), (2, 2), (17, 17), (50, 7), (7, 50)] {
            let column: Vec<f64> = (0..reach).map(|k| 1.0 / (1.0 + k as f64)).collect();
            let input: Vec<f64> = (0..size)
                .map(|i| ((i * 37 + 11) % 17) as f64 - 8.0)
                .collect();
            let mut output = vec![f64::NAN; size];
            SymmetricToeplitz::new(&column, size).apply(&input, &mut output);
            for (row, &fast) in output.iter().enumerate() {
                let direct: f64 = (0..size)
                    .map(|j| column.get(row.abs_diff(j)).unwrap_or(&0.0) * input[j])
                    .sum();
                // Sums of at most 50 terms of size ≤ 8: round-off stays below 1e-13.
                assert!((fast - direct).abs() < 1e-13, "{size} {reach} {row}");
            }
        }
    }
}
