//! Chebyshev interpolation of a smooth function of one variable.

/// Coefficients below this share of the largest are rounding.
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
        (low, high): (f64, f64),
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

    /// The interpolant at x, which is moved into the interval.
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_smooth_function_is_met_to_the_last_digits() {
        let exact = |x: f64| (1.3 * x).sin() + 1.0 / (2.0 + x);
        let fit = Chebyshev::fit((0.0, 1.5), 25, |x| Ok::<_, ()>(exact(x))).unwrap();
        for k in 0..=30 {
            let x = 0.05 * f64::from(k);
            assert!((fit.at(x) - exact(x)).abs() < 1e-14, "{x}");
        }
        assert_eq!(fit.at(7.0), fit.at(1.5));
    }
}
