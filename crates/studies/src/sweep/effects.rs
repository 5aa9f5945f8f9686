//! Effects of the inputs on a result: main effects, and Sobol's indices of a sample of Saltelli.
//!
//! ```text
//! S_i  = mean(f_B (f_ABi − f_A))/V        S_Ti = mean((f_A − f_ABi)²)/(2V)
//! ```
//!
//! Source: Saltelli and others 2010, Computer Physics Communications 181, table 2 (b, f), as coded in SALib; V is the
//! variance of f over A and B. Intervals are percentiles of resampled points (bootstrap).

use asperity_core::numerics::Z_95;
use serde::Serialize;

use super::draws::{random_of, uniform};

/// Main effect of an input.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Effect {
    /// Mean of the result in the lowest quarter of the input.
    pub low: f64,
    /// Mean of the result in the highest quarter.
    pub high: f64,
    /// Difference between the two.
    pub difference: f64,
    /// Its 5 % and 95 % quantiles.
    pub quantiles: [f64; 2],
    /// Correlation of input and result.
    pub correlation: f64,
}

impl Effect {
    /// The difference with its quantiles as text.
    pub(super) fn text(&self) -> String {
        let [low, high] = self.quantiles;
        format!("{:+.3e} ({low:+.1e}..{high:+.1e})", self.difference)
    }
}

/// Sobol's indices of an input, each with its 95 % interval.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Indices {
    /// Share of the variance due to the input without interactions.
    pub first: f64,
    /// Its interval.
    pub first_interval: [f64; 2],
    /// Share of the variance due to the input and its interactions.
    pub total: f64,
    /// Its interval.
    pub total_interval: [f64; 2],
}

/// Number of bootstrap samples.
const RESAMPLINGS: usize = 1000;
/// Quantiles at the ends of the intervals.
const ENDS: [f64; 2] = [0.025, 0.975];

/// Main effect of an input `x` on a result `y`; `None` for fewer than eight points or if either is constant.
#[must_use]
pub fn effects(x: &[f64], y: &[f64]) -> Option<Effect> {
    let n = x.len().min(y.len());
    if n < 8 {
        return None;
    }
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by(|&a, &b| x[a].total_cmp(&x[b]));
    let quarter = n / 4;
    let (low, low_square) = mean_and_square(order[..quarter].iter().map(|k| y[*k]));
    let (high, high_square) = mean_and_square(order[n - quarter..].iter().map(|k| y[*k]));
    let error = ((low_square + high_square) / (quarter as f64 - 1.0).max(1.0)).sqrt();
    let (mx, sx) = mean_and_square(x[..n].iter().copied());
    let (my, sy) = mean_and_square(y[..n].iter().copied());
    let product = (0..n).map(|k| (x[k] - mx) * (y[k] - my)).sum::<f64>() / n as f64;
    (sx > 0.0 && sy > 0.0).then(|| Effect {
        low,
        high,
        difference: high - low,
        quantiles: [-Z_95, Z_95].map(|z| high - low + z * error),
        correlation: product / (sx * sy).sqrt(),
    })
}

/// Mean and mean square deviation.
fn mean_and_square(values: impl Iterator<Item = f64> + Clone) -> (f64, f64) {
    let n = values.clone().count() as f64;
    let mean = values.clone().sum::<f64>() / n;
    (mean, values.map(|v| (v - mean).powi(2)).sum::<f64>() / n)
}

/// Sobol's indices of the inputs from the results of a sample of Saltelli: blocks `a`, `b`, and for each input the block A
/// with that input from B. `None` if a block has fewer than four points or the result is constant.
///
/// ```
/// use asperity_studies::sweep::{Draws, Method, sobol_indices};
/// // f = x + 2 y: shares of the variance 1/5 and 4/5.
/// let draws = Draws::new(Method::Sobol, 1024, 4, 1);
/// let f = |x: f64, y: f64| x + 2.0 * y;
/// let of = |x: usize, y: usize| -> Vec<f64> { (0..1024).map(|k| f(draws.at(k, x), draws.at(k, y))).collect() };
/// let found = sobol_indices(&of(0, 1), &of(2, 3), &[of(2, 1), of(0, 3)], 1).unwrap();
/// assert!((found[0].first - 0.2).abs() < 0.02 && (found[1].total - 0.8).abs() < 0.02);
/// ```
#[must_use]
pub fn sobol_indices(a: &[f64], b: &[f64], mixed: &[Vec<f64>], seed: u64) -> Option<Vec<Indices>> {
    let n = a.len();
    if n < 4 || b.len() != n || mixed.iter().any(|block| block.len() != n) {
        return None;
    }
    let whole: Vec<usize> = (0..n).collect();
    let point = estimates(a, b, mixed, &whole)?;
    let mut random = random_of(seed);
    let mut resampled: Vec<Vec<[f64; 2]>> = vec![Vec::with_capacity(RESAMPLINGS); mixed.len()];
    for _ in 0..RESAMPLINGS {
        let drawn: Vec<usize> = (0..n)
            .map(|_| ((uniform(&mut random) * n as f64) as usize).min(n - 1))
            .collect();
        if let Some(estimates) = estimates(a, b, mixed, &drawn) {
            for (samples, estimate) in resampled.iter_mut().zip(estimates) {
                samples.push(estimate);
            }
        }
    }
    let of = |(point, resampled): (&[f64; 2], &Vec<[f64; 2]>)| Indices {
        first: point[0],
        first_interval: interval(resampled, 0),
        total: point[1],
        total_interval: interval(resampled, 1),
    };
    Some(point.iter().zip(&resampled).map(of).collect())
}

/// First and total index of every input over the points `at`.
fn estimates(a: &[f64], b: &[f64], mixed: &[Vec<f64>], at: &[usize]) -> Option<Vec<[f64; 2]>> {
    let n = at.len() as f64;
    let both = at.iter().flat_map(|k| [a[*k], b[*k]]);
    let (mean, variance) = mean_and_square(both);
    if variance.is_nan() || variance <= 0.0 {
        return None;
    }
    let of = |block: &Vec<f64>| {
        // Centred: the estimate of the first index scatters with the mean.
        let first = at
            .iter()
            .map(|k| (b[*k] - mean) * (block[*k] - a[*k]))
            .sum::<f64>();
        let total = at.iter().map(|k| (a[*k] - block[*k]).powi(2)).sum::<f64>();
        [first / n / variance, 0.5 * total / n / variance]
    };
    Some(mixed.iter().map(of).collect())
}

fn interval(values: &[[f64; 2]], which: usize) -> [f64; 2] {
    let mut values: Vec<f64> = values.iter().map(|pair| pair[which]).collect();
    values.sort_by(f64::total_cmp);
    ENDS.map(|end| {
        let at = (end * values.len() as f64) as usize;
        values
            .get(at.min(values.len().saturating_sub(1)))
            .copied()
            .unwrap_or(f64::NAN)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sweep::{Draws, Method};

    #[test]
    fn indices_of_a_linear_function_lie_in_their_intervals() {
        // f = 3 x + 2 y + z over even inputs: 9/14, 4/14, 1/14, without interactions.
        let weights = [3.0, 2.0, 1.0];
        let n = 256;
        let mut inside = [0; 2];
        for seed in 0..10 {
            let draws = Draws::new(Method::Sobol, n, 6, seed);
            let of = |block: Option<usize>, k: usize| -> f64 {
                let value = |i: usize| match block {
                    Some(other) if other == i || other == 3 => draws.at(k, 3 + i),
                    _ => draws.at(k, i),
                };
                (0..3).map(|i| weights[i] * value(i)).sum()
            };
            let all = |block: Option<usize>| (0..n).map(|k| of(block, k)).collect::<Vec<f64>>();
            let mixed: Vec<Vec<f64>> = (0..3).map(|i| all(Some(i))).collect();
            let values = sobol_indices(&all(None), &all(Some(3)), &mixed, seed).unwrap();
            for (i, index) in values.iter().enumerate() {
                let exact = weights[i] * weights[i] / 14.0;
                let lies = |[low, high]: [f64; 2]| usize::from((low..=high).contains(&exact));
                inside[0] += lies(index.first_interval);
                inside[1] += lies(index.total_interval);
                assert!((index.first - exact).abs() < 0.05 && (index.total - exact).abs() < 0.05);
            }
        }
        // 95 % of 30 intervals hold the exact value on average; a quasi-random sample does better.
        assert!(inside[0] >= 27 && inside[1] >= 27, "{inside:?}");
    }

    #[test]
    fn an_effect_is_that_of_the_quarters() {
        let x: Vec<f64> = (0..100).map(f64::from).collect();
        let y: Vec<f64> = x.iter().map(|x| 5.0 - 2.0 * x).collect();
        let values = effects(&x, &y).unwrap();
        assert_eq!(values.difference, -150.0);
        assert!((values.correlation + 1.0).abs() < 1e-12);
        assert_eq!(effects(&x, &vec![1.0; 100]), None);
    }
}
