//! Circular convolution with an even kernel, in place, with cached plan and buffers.
//!
//! Pairs of real values are transformed as complex numbers, and the spectrum of the real signal is
//! never formed: separating it, multiplying by the symbol and joining it again is one linear
//! combination of a wave and its mirror image. A signal that fills only half of the period is split
//! further: y = ½·(f ∗ x + g ⋆ x), where f ∗ x has half the period and g ⋆ x changes its sign from
//! one half period to the next. Both take transforms of a quarter of the period, which need less time
//! and a third of the memory of one transform of the zero-padded period.
//!
//! | symbol | meaning |
//! |---|---|
//! | x, y | signal, filtered signal |
//! | m, h | half the period if the signal fills only half, else the period; pairs in m |
//! | Zₖ | transform of the pairs z_j = x₂ⱼ + i·x₂ⱼ₊₁ |
//! | s, S, D | symbol, ½·(s_k ± s_h₋ₖ) |
//! | θ, ω | 2πk/m, exp(−iπ/m) |

use std::f64::consts::TAU;
use std::sync::Arc;

use asperity_core::numerics::{FourierNumber, vectorised};
use rustfft::num_complex::Complex;
use rustfft::num_traits::Zero;
use rustfft::{Fft, FftNum, FftPlanner};

use super::index_ranges::Run;

/// A filter of real signals whose kernel is even, so that its symbol is real.
pub(crate) struct EvenFilter<T: FftNum = f64> {
    pub(super) points: usize,
    /// m
    pub(super) length: usize,
    /// Plan of both transforms: the inverse is the forward transform of the conjugate.
    pub(super) plan: Arc<dyn Fft<T>>,
    /// S − D·sin θ of each wave.
    pub(super) direct: Vec<T>,
    /// D·cos θ of the first half of the waves; the mirror images have the same value. Empty if m is odd
    /// and the values are not paired.
    pub(super) crossed: Vec<T>,
    /// For a signal that fills half of its period.
    pub(super) alternating: Option<Alternating<T>>,
}

/// Alternating part of a kernel, which changes its sign after half the period: the transform of
/// c_j = (x_j − i·x_{j+h})·ω^j holds the waves 4k + 1 of the period 2m, and the other odd waves are
/// their mirror images.
pub(super) struct Alternating<T: FftNum> {
    /// ω^j
    pub(super) twist: Vec<Complex<T>>,
    pub(super) symbol: Vec<T>,
}

/// Memory of the transforms, shared by filters that are applied one after the other.
#[derive(Default)]
pub(crate) struct Buffers<T: FftNum = f64> {
    pub(super) signal: Vec<T>,
    pub(super) wave: Vec<Complex<T>>,
    pub(super) twisted: Vec<Complex<T>>,
    pub(super) scratch: Vec<Complex<T>>,
}

impl<T: FftNum> Buffers<T> {
    /// Enlarges the buffers to the size that a filter needs.
    pub(crate) fn reserve(&mut self, filter: &impl Convolution<T>) {
        let sizes = filter.sizes();
        grow(&mut self.signal, sizes.signal);
        grow(&mut self.wave, sizes.wave);
        grow(&mut self.twisted, sizes.twisted);
        grow(&mut self.scratch, sizes.scratch);
    }

    /// The first `points` values: input and result of a filter.
    pub(crate) fn signal(&mut self, points: usize) -> &mut [T] {
        &mut self.signal[..points]
    }
}

/// Number of values of each buffer.
pub(crate) struct BufferSizes {
    pub(super) signal: usize,
    pub(super) wave: usize,
    pub(super) twisted: usize,
    pub(super) scratch: usize,
}

/// Product of a grid function with a symmetric kernel.
pub(crate) trait Convolution<T: FftNum> {
    /// Number of values of a grid function.
    fn points(&self) -> usize;

    /// Buffers that a product needs.
    fn sizes(&self) -> BufferSizes;

    /// Filters a signal that is zero outside of `runs`: the signal of the buffers begins with the values
    /// of the runs, one run after the other, and holds the whole result afterwards.
    fn filter_runs(&self, buffers: &mut Buffers<T>, factor: T, runs: &[Run]);

    /// Filters `signal` times `factor` into the signal of the buffers.
    fn filter(&self, buffers: &mut Buffers<T>, factor: T, signal: &[T]) {
        let whole = Run::new(0, self.points());
        buffers.signal(self.points()).copy_from_slice(signal);
        self.filter_runs(buffers, factor, &[whole]);
    }
}

impl<T: FourierNumber> Convolution<T> for EvenFilter<T> {
    fn points(&self) -> usize {
        self.points
    }

    fn sizes(&self) -> BufferSizes {
        let waves = self.plan.len();
        BufferSizes {
            signal: self.points,
            wave: waves,
            twisted: self.alternating.as_ref().map_or(0, |_| waves),
            scratch: self.plan.get_inplace_scratch_len(),
        }
    }

    fn filter_runs(&self, buffers: &mut Buffers<T>, factor: T, runs: &[Run]) {
        self.convolve(buffers, factor, runs.iter().copied());
    }
}

fn grow<T: Clone + Zero>(buffer: &mut Vec<T>, length: usize) {
    if buffer.len() < length {
        *buffer = vec![T::zero(); length];
    }
}

/// Smallest even length of at least `at_least` with a fast transform of pairs.
///
/// Lengths have the factors 2, 3 and 5, and the product of the odd factors is at most the root of the
/// length: larger odd factors cost more than the values they save. 5000 = 8·5⁴ pairs take a quarter
/// longer than 5120.
pub(crate) fn fast_length(at_least: usize) -> usize {
    let pairs = at_least.div_ceil(2).max(1);
    let mut best = pairs.next_power_of_two();
    let mut fives = 1;
    while fives * fives <= 2 * best {
        let mut odd = fives;
        while odd * odd <= 2 * best {
            let length = odd * pairs.div_ceil(odd).next_power_of_two();
            if odd * odd <= 2 * length {
                best = best.min(length);
            }
            odd *= 3;
        }
        fives *= 5;
    }
    2 * best
}

pub(super) fn number<T: FftNum>(value: f64) -> T {
    T::from_f64(value).unwrap_or_else(T::zero)
}

impl<T: FourierNumber> EvenFilter<T> {
    /// Makes the filter of signals of `points` values that multiplies wave k of the period `length` by
    /// `symbol(k)`.
    pub(crate) fn from_symbol(
        planner: &mut FftPlanner<T>,
        points: usize,
        length: usize,
        symbol: impl Fn(usize) -> f64,
    ) -> Self {
        let mut filter = Self::empty(planner, points, length);
        filter.set_symbol(symbol, 1.0);
        filter
    }

    pub(super) fn empty(planner: &mut FftPlanner<T>, points: usize, length: usize) -> Self {
        let paired = length.is_multiple_of(2);
        Self {
            points,
            length,
            plan: T::forward(planner, if paired { length / 2 } else { length }),
            direct: vec![],
            crossed: vec![],
            alternating: None,
        }
    }

    /// Sets the symbol of the period m, times `share`.
    pub(super) fn set_symbol(&mut self, symbol: impl Fn(usize) -> f64, share: f64) {
        let waves = self.plan.len();
        let scale = share / waves as f64;
        if waves == self.length {
            let value = |k: usize| number(scale * symbol(k.min(waves - k)));
            self.direct = (0..waves).map(value).collect();
            return;
        }
        self.direct = vec![T::zero(); waves];
        self.crossed.clear();
        let turns = turns(waves / 2 + 1, TAU / self.length as f64);
        for (k, turn) in turns.iter().enumerate() {
            let (s, mirror) = (scale * symbol(k), scale * symbol(waves - k));
            let (half_sum, half_difference) = (0.5 * (s + mirror), 0.5 * (s - mirror));
            self.direct[(waves - k) % waves] = number(half_sum + half_difference * turn.im);
            self.direct[k] = number(half_sum - half_difference * turn.im);
            self.crossed.push(number(half_difference * turn.re));
        }
    }

    fn convolve(
        &self,
        buffers: &mut Buffers<T>,
        factor: T,
        runs: impl Iterator<Item = Run> + Clone,
    ) {
        let waves = self.plan.len();
        let signal = &mut buffers.signal[..self.points];
        let wave = &mut buffers.wave[..waves];
        let scratch = &mut buffers.scratch[..self.plan.get_inplace_scratch_len()];
        if waves == self.length {
            wave.fill(Complex::zero())
        } else {
            clear_gaps(wave, runs.clone(), 2)
        }
        let Some(alternating) = &self.alternating else {
            vectorised(
                #[inline(always)]
                || {
                    for_values(runs, signal, |run, values| {
                        self.load(wave, factor, run, values)
                    });
                },
            );
            self.plan.process_with_scratch(wave, scratch);
            vectorised(
                #[inline(always)]
                || self.multiply(wave),
            );
            self.plan.process_with_scratch(wave, scratch);
            vectorised(
                #[inline(always)]
                || self.unload(wave, signal),
            );
            return;
        };
        let twisted = &mut buffers.twisted[..waves];
        clear_gaps(twisted, runs.clone(), 1);
        vectorised(
            #[inline(always)]
            || {
                for_values(runs, signal, |run, values| {
                    self.load(wave, factor, run, values);
                    alternating.load(twisted, factor, run, values);
                });
            },
        );
        self.plan.process_with_scratch(twisted, scratch);
        vectorised(
            #[inline(always)]
            || alternating.multiply(twisted),
        );
        self.plan.process_with_scratch(twisted, scratch);
        self.plan.process_with_scratch(wave, scratch);
        vectorised(
            #[inline(always)]
            || self.multiply(wave),
        );
        self.plan.process_with_scratch(wave, scratch);
        vectorised(
            #[inline(always)]
            || {
                self.unload(wave, signal);
                alternating.unload(twisted, signal);
            },
        );
    }

    /// Writes the values of a run to their pairs.
    #[inline(always)]
    fn load(&self, wave: &mut [Complex<T>], factor: T, run: Run, values: &[T]) {
        let (mut place, mut values) = (run.range().start, values);
        if wave.len() == self.length {
            for (z, &x) in wave[place..].iter_mut().zip(values) {
                z.re = factor * x;
            }
            return;
        }
        if place % 2 == 1
            && let Some((&first, rest)) = values.split_first()
        {
            wave[place / 2].im = factor * first;
            place += 1;
            values = rest;
        }
        let pairs = values.chunks_exact(2);
        if let Some(&last) = pairs.remainder().first() {
            wave[(place + values.len()) / 2].re = factor * last;
        }
        for (z, pair) in wave[place / 2..].iter_mut().zip(pairs) {
            *z = Complex::new(factor * pair[0], factor * pair[1]);
        }
    }

    /// Z'ₖ = (S − D·sin θ)·Zₖ + i·D·cos θ·conj(Z_h₋ₖ), conjugate.
    #[inline(always)]
    fn multiply(&self, wave: &mut [Complex<T>]) {
        if self.crossed.is_empty() {
            for (z, &symbol) in wave.iter_mut().zip(&self.direct) {
                *z = z.conj().scale(symbol);
            }
            return;
        }
        let mixed = |a: T, z: Complex<T>, b: T, mirror: Complex<T>| {
            Complex::new(a * z.re + b * mirror.im, -(a * z.im + b * mirror.re))
        };
        wave[0] = mixed(self.direct[0], wave[0], self.crossed[0], wave[0]);
        let middle = wave.len() / 2;
        if middle > 0 && wave.len().is_multiple_of(2) {
            let (a, b) = (self.direct[middle], self.crossed[middle]);
            wave[middle] = mixed(a, wave[middle], b, wave[middle]);
        }
        let (low, high) = wave[1..].split_at_mut(middle);
        let (low_direct, high_direct) = self.direct[1..].split_at(middle);
        let waves = low.iter_mut().zip(high.iter_mut().rev());
        let symbols = low_direct.iter().zip(high_direct.iter().rev());
        for (((z, mirror), (&a, &mirror_a)), &b) in waves.zip(symbols).zip(&self.crossed[1..]) {
            (*z, *mirror) = (mixed(a, *z, b, *mirror), mixed(mirror_a, *mirror, b, *z));
        }
    }

    #[inline(always)]
    fn unload(&self, wave: &[Complex<T>], signal: &mut [T]) {
        if wave.len() == self.length {
            for (y, z) in signal.iter_mut().zip(wave) {
                *y = z.re;
            }
            return;
        }
        let mut pairs = signal.chunks_exact_mut(2);
        for (pair, z) in (&mut pairs).zip(wave) {
            pair[0] = z.re;
            pair[1] = -z.im;
        }
        if let Some(last) = pairs.into_remainder().first_mut() {
            *last = wave[self.points / 2].re;
        }
    }
}

/// exp(i·k·`angle`) for k below `count`, as products of √`count` fine and coarse turns: accurate to a
/// unit in the last place, with few sines and cosines.
pub(super) fn turns(count: usize, angle: f64) -> Vec<Complex<f64>> {
    let block = (count as f64).sqrt().ceil().max(1.0) as usize;
    let fine: Vec<_> = (0..block).map(|k| Complex::cis(angle * k as f64)).collect();
    let coarse = (0..count.div_ceil(block)).map(|k| Complex::cis(angle * (k * block) as f64));
    let blocks = coarse.flat_map(|turn| fine.iter().map(move |small| turn * small));
    blocks.take(count).collect()
}

/// Zeroes the elements of `width` points each that no run fills completely.
fn clear_gaps<T: FftNum>(places: &mut [Complex<T>], runs: impl Iterator<Item = Run>, width: usize) {
    let mut filled = 0;
    for run in runs {
        let range = run.range();
        let next = range.start.div_ceil(width).min(places.len());
        places[filled..next].fill(Complex::zero());
        filled = (range.end / width).min(places.len());
    }
    places[filled..].fill(Complex::zero());
}

/// Calls `each` with every run and its values, which are contiguous in `signal`.
#[inline(always)]
fn for_values<T>(runs: impl Iterator<Item = Run>, signal: &[T], mut each: impl FnMut(Run, &[T])) {
    let mut rest = signal;
    for run in runs {
        let (values, others) = rest.split_at(run.points());
        each(run, values);
        rest = others;
    }
}

impl<T: FftNum> Alternating<T> {
    #[inline(always)]
    fn load(&self, twisted: &mut [Complex<T>], factor: T, run: Run, values: &[T]) {
        let half = twisted.len();
        let (first, end) = (run.range().start, run.range().end);
        let split = half.clamp(first, end);
        let (early, late) = values.split_at(split - first);
        let places = twisted[first.min(half)..].iter_mut();
        for ((c, w), &x) in places.zip(&self.twist[first.min(half)..]).zip(early) {
            *c = w.scale(factor * x);
        }
        if late.is_empty() {
            return;
        }
        let places = twisted[split - half..].iter_mut();
        for ((c, w), &x) in places.zip(&self.twist[split - half..]).zip(late) {
            let x = factor * x;
            *c = Complex::new(c.re + x * w.im, c.im - x * w.re);
        }
    }

    #[inline(always)]
    fn multiply(&self, twisted: &mut [Complex<T>]) {
        for (c, &symbol) in twisted.iter_mut().zip(&self.symbol) {
            *c = c.conj().scale(symbol);
        }
    }

    #[inline(always)]
    fn unload(&self, twisted: &[Complex<T>], signal: &mut [T]) {
        let half = twisted.len().min(signal.len());
        let (early, late) = signal.split_at_mut(half);
        let turned = || twisted.iter().zip(&self.twist);
        for (y, (c, w)) in early.iter_mut().zip(turned()) {
            *y = *y + c.re * w.re - c.im * w.im;
        }
        for (y, (c, w)) in late.iter_mut().zip(turned()) {
            *y = *y + c.re * w.im + c.im * w.re;
        }
    }
}
