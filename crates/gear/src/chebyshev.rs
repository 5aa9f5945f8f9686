//! Chebyshev interpolation of a smooth function of one variable.

/// Relative size below which coefficients are rounding errors.
const NEGLIGIBLE: f64 = 1e-14;

/// Σ c_k T_k(x) on an interval.
#[derive(Debug, Clone)]
pub(crate) struct Chebyshev {
    coefficients: Vec<f64>,
    low: f64,
    high: f64,
}

impl Chebyshev {
    /// Interpolates `function` at `count` Chebyshev points of the first kind.
    pub(crate) fn fit<E>(
        [low, high]: [f64; 2],
        count: usize,
        mut function: impl FnMut(f64) -> Result<f64, E>,
    ) -> Result<Self, E> {
        let n = count as f64;
        let angles: Vec<f64> = (0..count)
            .map(|k| std::f64::consts::PI * (k as f64 + 0.5) / n)
            .collect();
        let values = angles
            .iter()
            .map(|angle| function(0.5 * (low + high) + 0.5 * (high - low) * angle.cos()))
            .collect::<Result<Vec<f64>, E>>()?;
        let mut coefficients: Vec<f64> = (0..count)
            .map(|k| {
                let sum: f64 = (angles.iter().zip(&values))
                    .map(|(angle, value)| value * (k as f64 * angle).cos())
                    .sum();
                sum * if k == 0 { 1.0 } else { 2.0 } / n
            })
            .collect();
        let largest = coefficients.iter().fold(0.0f64, |max, c| max.max(c.abs()));
        while coefficients.len() > 1
            && coefficients
                .last()
                .is_some_and(|c| c.abs() < NEGLIGIBLE * largest)
        {
            coefficients.pop();
        }
        Ok(Self {
            coefficients,
            low,
            high,
        })
    }

    /// Value of the interpolant at x, clamped to the interval.
    pub(crate) fn at(&self, x: f64) -> f64 {
        let t =
            (2.0 * x.clamp(self.low, self.high) - self.low - self.high) / (self.high - self.low);
        let (mut newer, mut older) = (0.0, 0.0);
        for &c in self.coefficients.iter().skip(1).rev() {
            (newer, older) = (c + 2.0 * t * newer - older, newer);
        }
        self.coefficients.first().copied().unwrap_or(0.0) + t * newer - older
    }
}

/// Intervals of a [`SmoothTable`].
const INTERVALS: usize = 256;

/// A smooth function at even steps with cubic interpolation, for many quick evaluations.
#[derive(Debug, Clone)]
pub(crate) struct SmoothTable {
    values: Vec<f64>,
    low: f64,
    per_unit: f64,
}

impl SmoothTable {
    pub(crate) fn new(source: &Chebyshev) -> Self {
        let width = source.high - source.low;
        let step = width / INTERVALS as f64;
        Self {
            values: (0..=INTERVALS)
                .map(|k| source.at(source.low + step * k as f64))
                .collect(),
            low: source.low,
            per_unit: 1.0 / step,
        }
    }

    /// Interpolated value at x, clamped to the interval.
    pub(crate) fn at(&self, x: f64) -> f64 {
        let place = ((x - self.low) * self.per_unit).clamp(0.0, INTERVALS as f64);
        let first = (place as usize).clamp(1, INTERVALS - 2) - 1;
        let t = place - (first + 1) as f64;
        let Some(&[a, b, c, d]) = self.values.get(first..first + 4) else {
            return f64::NAN;
        };
        // Lagrange's polynomial through −1, 0, 1, 2.
        let (before, after, far) = (t + 1.0, t - 1.0, t - 2.0);
        (d * before - a * far) * t * after / 6.0 + (b * after - c * t) * before * far / 2.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_smooth_function_is_met_to_the_last_digits() {
        let exact = |x: f64| (1.3 * x).sin() + 1.0 / (2.0 + x);
        let fit = Chebyshev::fit([0.0, 1.5], 25, |x| Ok::<_, ()>(exact(x))).unwrap();
        for k in 0..=30 {
            let x = 0.05 * f64::from(k);
            assert!((fit.at(x) - exact(x)).abs() < 1e-14, "{x}");
        }
        assert_eq!(fit.at(7.0), fit.at(1.5));
    }

    #[test]
    fn a_table_loses_nine_digits_at_most() {
        let exact = |x: f64| (1.3 * x).sin() + 1.0 / (2.0 + x);
        let fit = Chebyshev::fit([0.0, 1.5], 25, |x| Ok::<_, ()>(exact(x))).unwrap();
        let table = SmoothTable::new(&fit);
        for k in 0..=1000 {
            let x = 0.0015 * f64::from(k);
            assert!((table.at(x) - exact(x)).abs() < 1e-9, "{x}");
        }
        assert_eq!(table.at(7.0), table.at(1.5));
    }
}
