//! Circular convolution of functions on a plane grid with kernels that are even in both directions.
//!
//! Rows lie one after the other in memory. The transform across the rows takes the columns in pairs of real
//! values as complex numbers; each of its waves is then convolved along the rows, where the signal may fill a
//! part of the period only, so that no wave of the longer transform is computed for the empty rest of the grid.
//!
//! | symbol | meaning |
//! |---|---|
//! | a, b | two neighbouring columns |
//! | Z, A, B | transforms across the rows: of a + i·b, of a, of b |

use std::sync::Arc;

use asperity_core::numerics::{FourierNumber, vectorised};
use rustfft::num_complex::Complex;
use rustfft::num_traits::Zero;
use rustfft::{Fft, FftNum, FftPlanner};

use super::even_filter::{BufferSizes, Buffers, Convolution, number};
use super::index_ranges::{Run, listed};

/// Pairs of columns that are transformed together: a row of them is a line of the cache.
const PAIRS: usize = 8;

/// A filter of real functions on a plane grid whose symbol is real and even in both wave numbers.
pub(crate) struct PlaneFilter<T: FftNum = f64> {
    columns: usize,
    rows: usize,
    /// Transform along a row of the period, which is at least as long as a row.
    along: Arc<dyn Fft<T>>,
    /// Transform across the rows.
    across: Arc<dyn Fft<T>>,
    /// Symbol over the number of points of the period: for each wave across the rows, to half of them, all waves along a row.
    symbol: Vec<T>,
}

impl<T: FourierNumber> PlaneFilter<T> {
    /// Makes the filter of signals of `rows` rows of `columns` values with the symbol of each wave along a row of `period`
    /// values, to half of them, and of each wave across the rows.
    pub(crate) fn from_symbol(
        [columns, rows]: [usize; 2],
        period: usize,
        symbol: impl Fn(usize, usize) -> f64,
    ) -> Self {
        let scale = 1.0 / (period * rows) as f64;
        let waves = (0..=rows / 2).flat_map(|across| (0..period).map(move |along| (along, across)));
        let value = |(along, across): (usize, usize)| {
            number(scale * symbol(along.min(period - along), across))
        };
        Self {
            columns,
            rows,
            along: T::forward(&mut T::planner(), period),
            across: T::forward(&mut T::planner(), rows),
            symbol: waves.map(value).collect(),
        }
    }
}

impl PlaneFilter<f64> {
    /// Makes the filter with the kernel of each wave across the rows at each lag of the period along a row.
    pub(crate) fn from_kernel(
        shape: [usize; 2],
        period: usize,
        kernel: impl Fn(usize, usize) -> f64,
    ) -> Self {
        let transform = f64::forward(&mut f64::planner(), period);
        let symbols: Vec<Vec<Complex<f64>>> = (0..=shape[1] / 2)
            .map(|across| {
                let value = |lag: usize| Complex::from(kernel(lag.min(period - lag), across));
                let mut wave: Vec<_> = (0..period).map(value).collect();
                transform.process(&mut wave);
                wave
            })
            .collect();
        Self::from_symbol(shape, period, |along, across| symbols[across][along].re)
    }

    /// The same filter without the mean of a signal.
    pub(crate) fn without_mean(mut self) -> Self {
        self.symbol[0] = 0.0;
        self
    }

    /// The same filter in single precision.
    pub(crate) fn single(&self, planner: &mut FftPlanner<f32>) -> PlaneFilter<f32> {
        PlaneFilter {
            columns: self.columns,
            rows: self.rows,
            along: f32::forward(planner, self.along.len()),
            across: f32::forward(planner, self.across.len()),
            symbol: self.symbol.iter().map(|&x| x as f32).collect(),
        }
    }
}

impl<T: FourierNumber> Convolution<T> for PlaneFilter<T> {
    fn points(&self) -> usize {
        self.columns * self.rows
    }

    fn sizes(&self) -> BufferSizes {
        let plans = [&self.along, &self.across].map(|plan| plan.get_inplace_scratch_len());
        BufferSizes {
            signal: self.points(),
            wave: (self.rows / 2 + 1) * self.columns,
            twisted: self.along.len().max(PAIRS * self.rows),
            scratch: plans[0].max(plans[1]),
        }
    }

    fn filter_runs(&self, buffers: &mut Buffers<T>, factor: T, runs: &[Run]) {
        let (columns, waves) = (self.columns, self.rows / 2 + 1);
        let signal = &mut buffers.signal[..columns * self.rows];
        let spectrum = &mut buffers.wave[..columns * waves];
        spread(signal, runs);
        let scratch = &mut buffers.scratch[..self.across.get_inplace_scratch_len()];
        for first in (0..columns).step_by(2 * PAIRS) {
            let width = (2 * PAIRS).min(columns - first);
            let block = &mut buffers.twisted[..width.div_ceil(2) * self.rows];
            vectorised(
                #[inline(always)]
                || self.load(block, signal, factor, first..first + width),
            );
            self.across.process_with_scratch(block, scratch);
            vectorised(
                #[inline(always)]
                || self.part(block, spectrum, first..first + width),
            );
        }
        let period = self.along.len();
        let scratch = &mut buffers.scratch[..self.along.get_inplace_scratch_len()];
        let line = &mut buffers.twisted[..period];
        let symbols = self.symbol.chunks_exact(period);
        for (wave, symbol) in spectrum.chunks_exact_mut(columns).zip(symbols) {
            line[..columns].copy_from_slice(wave);
            line[columns..].fill(Complex::zero());
            self.along.process_with_scratch(line, scratch);
            vectorised(
                #[inline(always)]
                || {
                    for (z, &symbol) in line.iter_mut().zip(symbol) {
                        *z = z.conj().scale(symbol);
                    }
                },
            );
            self.along.process_with_scratch(line, scratch);
            // The inverse is the forward transform of the conjugate; the conjugate of the result is taken by `join`.
            wave.copy_from_slice(&line[..columns]);
        }
        let scratch = &mut buffers.scratch[..self.across.get_inplace_scratch_len()];
        for first in (0..columns).step_by(2 * PAIRS) {
            let width = (2 * PAIRS).min(columns - first);
            let block = &mut buffers.twisted[..width.div_ceil(2) * self.rows];
            vectorised(
                #[inline(always)]
                || self.join(block, spectrum, first..first + width),
            );
            self.across.process_with_scratch(block, scratch);
            vectorised(
                #[inline(always)]
                || self.unload(block, signal, first..first + width),
            );
        }
    }
}

impl<T: FourierNumber> PlaneFilter<T> {
    /// Writes the columns of the signal to pairs, one pair after the other.
    #[inline(always)]
    fn load(
        &self,
        block: &mut [Complex<T>],
        signal: &[T],
        factor: T,
        columns: std::ops::Range<usize>,
    ) {
        for (row, values) in signal.chunks_exact(self.columns).enumerate() {
            for (pair, values) in values[columns.clone()].chunks(2).enumerate() {
                let second = values.get(1).copied().unwrap_or_else(T::zero);
                block[pair * self.rows + row] = Complex::new(factor * values[0], factor * second);
            }
        }
    }

    /// A = ½·(Z_k + conj Z₋ₖ), B = −½·i·(Z_k − conj Z₋ₖ)
    #[inline(always)]
    fn part(
        &self,
        block: &[Complex<T>],
        spectrum: &mut [Complex<T>],
        columns: std::ops::Range<usize>,
    ) {
        let half = number::<T>(0.5);
        for (k, waves) in spectrum.chunks_exact_mut(self.columns).enumerate() {
            let mirror = (self.rows - k) % self.rows;
            let pairs = block.chunks_exact(self.rows);
            for (to, of_pair) in waves[columns.clone()].chunks_mut(2).zip(pairs) {
                let (z, w) = (of_pair[k], of_pair[mirror].conj());
                let difference = z - w;
                to[0] = (z + w).scale(half);
                if let Some(second) = to.get_mut(1) {
                    *second = Complex::new(half * difference.im, -(half * difference.re));
                }
            }
        }
    }

    /// conj Z_k = conj A − i·conj B, conj Z₋ₖ = A − i·B, from the conjugates of A and B.
    #[inline(always)]
    fn join(
        &self,
        block: &mut [Complex<T>],
        spectrum: &[Complex<T>],
        columns: std::ops::Range<usize>,
    ) {
        for (k, waves) in spectrum.chunks_exact(self.columns).enumerate() {
            let mirror = (self.rows - k) % self.rows;
            let pairs = block.chunks_exact_mut(self.rows);
            for (from, to) in waves[columns.clone()].chunks(2).zip(pairs) {
                let second = from.get(1).copied().unwrap_or_else(Complex::zero);
                let (a, b) = (from[0].conj(), second.conj());
                to[mirror] = Complex::new(a.re + b.im, a.im - b.re);
                to[k] = Complex::new(a.re - b.im, -(a.im + b.re));
            }
        }
    }

    #[inline(always)]
    fn unload(&self, block: &[Complex<T>], signal: &mut [T], columns: std::ops::Range<usize>) {
        for (row, values) in signal.chunks_exact_mut(self.columns).enumerate() {
            for (pair, values) in values[columns.clone()].chunks_mut(2).enumerate() {
                let z = block[pair * self.rows + row];
                values[0] = z.re;
                if let Some(second) = values.get_mut(1) {
                    *second = -z.im;
                }
            }
        }
    }
}

/// Moves the values of the runs, with which `signal` begins, to their places; the other values become zero.
fn spread<T: FftNum>(signal: &mut [T], runs: &[Run]) {
    let mut end = listed(runs);
    let mut free = signal.len();
    for run in runs.iter().rev() {
        let range = run.range();
        signal[range.end..free].fill(T::zero());
        signal.copy_within(end - run.points()..end, range.start);
        end -= run.points();
        free = range.start;
    }
    signal[..free].fill(T::zero());
}
