//! Circular convolution with an even kernel, in place, with plan and buffers kept.

use std::sync::Arc;

use realfft::num_complex::Complex;
use realfft::{ComplexToReal, RealFftPlanner, RealToComplex};

/// A filter of real signals whose kernel is even, so that its symbol is real.
///
/// Write [`signal`](Self::signal), call [`apply`](Self::apply), read the result from `signal`.
pub(crate) struct EvenFilter {
    points: usize,
    symbol: Vec<f64>,
    forward: Arc<dyn RealToComplex<f64>>,
    inverse: Arc<dyn ComplexToReal<f64>>,
    padded: Vec<f64>,
    spectrum: Vec<Complex<f64>>,
    scratch: Vec<Complex<f64>>,
}

impl EvenFilter {
    /// The filter of signals of `points` values that multiplies wave k of the period `length` by
    /// `symbol(k)`.
    pub(crate) fn from_symbol(
        planner: &mut RealFftPlanner<f64>,
        points: usize,
        length: usize,
        symbol: impl Fn(usize) -> f64,
    ) -> Self {
        let forward = planner.plan_fft_forward(length);
        let inverse = planner.plan_fft_inverse(length);
        let padded = forward.make_input_vec();
        let spectrum = forward.make_output_vec();
        let scratch_length = forward.get_scratch_len().max(inverse.get_scratch_len());
        let scale = 1.0 / length as f64;
        Self {
            points,
            symbol: (0..spectrum.len()).map(|k| scale * symbol(k)).collect(),
            forward,
            inverse,
            padded,
            spectrum,
            scratch: vec![Complex::default(); scratch_length],
        }
    }

    /// The filter with the kernel `column[k]` at distance k in either direction, of a period
    /// `length` that is at least 2·`column.len()` − 1, or `column.len()` when the column itself
    /// is periodic and even.
    pub(crate) fn from_column(
        planner: &mut RealFftPlanner<f64>,
        column: &[f64],
        length: usize,
    ) -> Self {
        let mut filter = Self::from_symbol(planner, column.len(), length, |_| 0.0);
        for (lag, &value) in column.iter().enumerate() {
            filter.padded[lag] = value;
            filter.padded[(length - lag) % length] = value;
        }
        filter.transform();
        let scale = 1.0 / length as f64;
        for (symbol, wave) in filter.symbol.iter_mut().zip(&filter.spectrum) {
            *symbol = scale * wave.re;
        }
        filter
    }

    /// The same filter without the mean of a signal.
    pub(crate) fn without_mean(mut self) -> Self {
        self.symbol[0] = 0.0;
        self
    }

    pub(crate) fn points(&self) -> usize {
        self.points
    }

    pub(crate) fn signal(&mut self) -> &mut [f64] {
        &mut self.padded[..self.points]
    }

    /// Replaces the signal by `factor` times the filtered signal.
    pub(crate) fn apply(&mut self, factor: f64) {
        self.padded[self.points..].fill(0.0);
        self.transform();
        for (wave, symbol) in self.spectrum.iter_mut().zip(&self.symbol) {
            *wave *= factor * symbol;
        }
        // The inverse insists on what is true but for round-off: real ends of the spectrum.
        self.spectrum[0].im = 0.0;
        if let Some(last) = self.spectrum.last_mut()
            && self.padded.len().is_multiple_of(2)
        {
            last.im = 0.0;
        }
        let done = self.inverse.process_with_scratch(
            &mut self.spectrum,
            &mut self.padded,
            &mut self.scratch,
        );
        debug_assert!(done.is_ok(), "buffers are made by the plan");
    }

    fn transform(&mut self) {
        let done = self.forward.process_with_scratch(
            &mut self.padded,
            &mut self.spectrum,
            &mut self.scratch,
        );
        debug_assert!(done.is_ok(), "buffers are made by the plan");
    }
}
