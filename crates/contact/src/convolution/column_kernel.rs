//! Construction of filters from the values of their kernel, and in single precision.

use std::f64::consts::{PI, TAU};

use asperity_core::numerics::FourierNumber;
use rustfft::FftPlanner;
use rustfft::num_complex::Complex;

use super::even_filter::{Alternating, Buffers, EvenFilter, fast_length, turns};

impl EvenFilter<f64> {
    /// Makes the filter with the kernel `column[k]` at distance k in either direction, without
    /// periodicity: the signal is embedded in a period of at least twice its length.
    pub(crate) fn from_column(
        planner: &mut FftPlanner<f64>,
        column: &[f64],
        buffers: &mut Buffers,
    ) -> Self {
        let length = fast_length(column.len());
        let mut filter = Self::empty(planner, column.len(), length);
        let value = |lag: usize| column.get(lag).copied().unwrap_or(0.0);
        let folded = |lag: usize| value(lag) + if lag > 0 { value(length - lag) } else { 0.0 };
        filter.set_spectrum(folded, 0.5, buffers);
        filter.alternating = Some(filter.alternate(
            |lag| value(lag) - if lag > 0 { value(length - lag) } else { 0.0 },
            buffers,
        ));
        filter
    }

    /// Makes the filter with the periodic and even kernel `column`.
    pub(crate) fn from_period(
        planner: &mut FftPlanner<f64>,
        column: &[f64],
        buffers: &mut Buffers,
    ) -> Self {
        let mut filter = Self::empty(planner, column.len(), column.len());
        filter.set_spectrum(|lag| column[lag], 1.0, buffers);
        filter
    }

    /// Sets the symbol to the transform of an even kernel of the period m, times `share`.
    ///
    /// The transform of pairs of values gives the symbol of the period m from one of length m/2.
    fn set_spectrum(&mut self, kernel: impl Fn(usize) -> f64, share: f64, buffers: &mut Buffers) {
        buffers.reserve(self);
        let waves = self.plan.len();
        let paired = waves < self.length;
        let wave = &mut buffers.wave[..waves];
        for (j, z) in wave.iter_mut().enumerate() {
            *z = if paired {
                Complex::new(kernel(2 * j), kernel(2 * j + 1))
            } else {
                Complex::new(kernel(j), 0.0)
            };
        }
        self.plan.process_with_scratch(wave, &mut buffers.scratch);
        if !paired {
            let symbol: Vec<f64> = wave.iter().map(|z| z.re).collect();
            self.set_symbol(|k| symbol[k], share);
            return;
        }
        let mut symbol = vec![0.0; waves + 1];
        for (k, turn) in turns(waves / 2 + 1, TAU / self.length as f64)
            .iter()
            .enumerate()
        {
            let (z, mirror) = (wave[k], wave[(waves - k) % waves]);
            // E + exp(−iθ)·O, the transforms of the even and odd values; the sum is real.
            let even = 0.5 * (z.re + mirror.re);
            let (re, im) = (0.5 * (z.im + mirror.im), 0.5 * (mirror.re - z.re));
            symbol[k] = even + turn.re * re + turn.im * im;
            symbol[waves - k] = even - turn.re * re - turn.im * im;
        }
        self.set_symbol(|k| symbol[k], share);
    }

    /// Alternating part of a kernel of the period 2m: `kernel` is its value at each distance minus the
    /// value m further.
    fn alternate(&self, kernel: impl Fn(usize) -> f64, buffers: &mut Buffers) -> Alternating<f64> {
        let waves = self.plan.len();
        let twist = turns(waves, -PI / self.length as f64);
        let wave = &mut buffers.wave[..waves];
        for (j, (c, w)) in wave.iter_mut().zip(&twist).enumerate() {
            *c = Complex::new(kernel(j), -kernel(j + waves)) * w;
        }
        self.plan.process_with_scratch(wave, &mut buffers.scratch);
        // Half, as y is half of the sum of both parts, and the factor of the inverse transform.
        let scale = 0.5 / waves as f64;
        Alternating {
            symbol: wave.iter().map(|c| scale * c.re).collect(),
            twist,
        }
    }

    /// The same filter in single precision.
    pub(crate) fn single(&self, planner: &mut FftPlanner<f32>) -> EvenFilter<f32> {
        let single = |values: &[f64]| values.iter().map(|&x| x as f32).collect();
        let alternating = self.alternating.as_ref().map(|part| Alternating {
            twist: part
                .twist
                .iter()
                .map(|w| Complex::new(w.re as f32, w.im as f32))
                .collect(),
            symbol: single(&part.symbol),
        });
        EvenFilter {
            points: self.points,
            length: self.length,
            plan: f32::forward(planner, self.plan.len()),
            direct: single(&self.direct),
            crossed: single(&self.crossed),
            alternating,
        }
    }

    /// The same filter without the mean of a signal.
    pub(crate) fn without_mean(mut self) -> Self {
        if self.crossed.is_empty() {
            self.direct[0] = 0.0;
            return self;
        }
        // Setting s₀ = 0 lowers both S and D by half of it.
        let half = 0.5 * (self.direct[0] + self.crossed[0]);
        self.direct[0] -= half;
        self.crossed[0] -= half;
        self
    }
}
