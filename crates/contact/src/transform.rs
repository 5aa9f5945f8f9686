//! Circular convolution with an even kernel, in place, with plan and buffers kept.

use std::sync::Arc;

use realfft::num_complex::Complex;
use realfft::num_traits::Zero;
use realfft::{ComplexToReal, FftNum, RealFftPlanner, RealToComplex};

/// A filter of real signals whose kernel is even, so that its symbol is real.
pub(crate) struct EvenFilter<T: FftNum = f64> {
    points: usize,
    length: usize,
    symbol: Vec<T>,
    forward: Arc<dyn RealToComplex<T>>,
    inverse: Arc<dyn ComplexToReal<T>>,
}

/// Memory for the transforms of all filters that are used one after the other.
#[derive(Default)]
pub(crate) struct Buffers<T: FftNum = f64> {
    padded: Vec<T>,
    spectrum: Vec<Complex<T>>,
    scratch: Vec<Complex<T>>,
}

impl<T: FftNum> Buffers<T> {
    /// Makes room for a filter, which then needs no memory of its own.
    pub(crate) fn reserve(&mut self, filter: &EvenFilter<T>) {
        let scratch = filter.forward.get_scratch_len();
        let scratch = scratch.max(filter.inverse.get_scratch_len());
        grow(&mut self.padded, filter.length);
        grow(&mut self.spectrum, filter.symbol.len());
        grow(&mut self.scratch, scratch);
    }

    /// The first `points` values: what is filtered, and the result.
    pub(crate) fn signal(&mut self, points: usize) -> &mut [T] {
        &mut self.padded[..points]
    }
}

fn grow<T: Clone + Zero>(buffer: &mut Vec<T>, length: usize) {
    if buffer.len() < length {
        *buffer = vec![T::zero(); length];
    }
}

impl<T: FftNum> EvenFilter<T> {
    /// The filter of signals of `points` values that multiplies wave k of the period `length` by
    /// `symbol(k)`.
    pub(crate) fn from_symbol(
        planner: &mut RealFftPlanner<T>,
        points: usize,
        length: usize,
        symbol: impl Fn(usize) -> f64,
    ) -> Self {
        let scale = 1.0 / length as f64;
        let symbol = |k| T::from_f64(scale * symbol(k)).unwrap_or_else(T::zero);
        Self {
            points,
            length,
            symbol: (0..=length / 2).map(symbol).collect(),
            forward: planner.plan_fft_forward(length),
            inverse: planner.plan_fft_inverse(length),
        }
    }

    pub(crate) fn points(&self) -> usize {
        self.points
    }

    /// Puts `factor` times the filtered `signal` into the buffers' signal.
    pub(crate) fn filter(&self, buffers: &mut Buffers<T>, factor: T, signal: &[T]) {
        buffers.padded[..self.points].copy_from_slice(signal);
        buffers.padded[self.points..self.length].fill(T::zero());
        self.convolve(buffers, factor);
    }

    /// The same for a signal that is zero but for `values` at the places `list`.
    pub(crate) fn filter_sparse(
        &self,
        buffers: &mut Buffers<T>,
        factor: T,
        list: &[u32],
        values: impl Iterator<Item = T>,
    ) {
        buffers.padded[..self.length].fill(T::zero());
        for (&i, value) in list.iter().zip(values) {
            buffers.padded[i as usize] = value;
        }
        self.convolve(buffers, factor);
    }

    fn convolve(&self, buffers: &mut Buffers<T>, factor: T) {
        self.transform(buffers);
        let spectrum = &mut buffers.spectrum[..self.symbol.len()];
        for (wave, &symbol) in spectrum.iter_mut().zip(&self.symbol) {
            *wave = wave.scale(factor * symbol);
        }
        // The inverse insists on what is true but for round-off: real ends of the spectrum.
        spectrum[0].im = T::zero();
        if let Some(last) = spectrum.last_mut()
            && self.length.is_multiple_of(2)
        {
            last.im = T::zero();
        }
        let scratch = self.inverse.get_scratch_len();
        let done = self.inverse.process_with_scratch(
            spectrum,
            &mut buffers.padded[..self.length],
            &mut buffers.scratch[..scratch],
        );
        debug_assert!(done.is_ok(), "buffers fit the plan");
    }

    fn transform(&self, buffers: &mut Buffers<T>) {
        let scratch = self.forward.get_scratch_len();
        let done = self.forward.process_with_scratch(
            &mut buffers.padded[..self.length],
            &mut buffers.spectrum[..self.symbol.len()],
            &mut buffers.scratch[..scratch],
        );
        debug_assert!(done.is_ok(), "buffers fit the plan");
    }
}

impl EvenFilter<f64> {
    /// The filter with the kernel `column[k]` at distance k in either direction, of a period
    /// `length` that is at least 2·`column.len()` − 1, or `column.len()` when the column itself
    /// is periodic and even.
    pub(crate) fn from_column(
        planner: &mut RealFftPlanner<f64>,
        column: &[f64],
        length: usize,
        buffers: &mut Buffers,
    ) -> Self {
        let mut filter = Self::from_symbol(planner, column.len(), length, |_| 0.0);
        buffers.reserve(&filter);
        buffers.padded[..length].fill(0.0);
        for (lag, &value) in column.iter().enumerate() {
            buffers.padded[lag] = value;
            buffers.padded[(length - lag) % length] = value;
        }
        filter.transform(buffers);
        let scale = 1.0 / length as f64;
        for (symbol, wave) in filter.symbol.iter_mut().zip(&buffers.spectrum) {
            *symbol = scale * wave.re;
        }
        filter
    }

    /// The same filter without the mean of a signal.
    pub(crate) fn without_mean(mut self) -> Self {
        self.symbol[0] = 0.0;
        self
    }
}
