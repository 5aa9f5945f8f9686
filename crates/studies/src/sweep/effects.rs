//! Effects of the inputs on a result: by a linear regression on all inputs, and Sobol's indices of a sample of Saltelli.
//!
//! ```text
//! y = ȳ + Σ b_i (x_i − x̄_i)                      change = b_i (x_i,high − x_i,low)
//! S_i  = mean(f_B (f_ABi − f_A))/V        S_Ti = mean((f_A − f_ABi)²)/(2V)
//! ```
//!
//! Source: Saltelli and others 2010, Computer Physics Communications 181, table 2 (b, f), as coded in SALib; V is the
//! variance of f over A and B. Intervals are percentiles of resampled points (bootstrap).

use asperity_core::numerics::Z_95;
use asperity_core::{Estimate, EstimateKeys, estimate_keys};
use nalgebra::{DMatrix, DVector};
use serde::Serialize;

use super::draws::{random_of, uniform};

estimate_keys! {
    Difference: "difference" "quantiles";
    First: "first" "first_interval";
    Total: "total" "total_interval";
}

/// Effect of an input, all others at their means.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Effect {
    /// Result at the mean of the lowest quarter of the input, or without the choice.
    pub low: f64,
    /// Result at the mean of the highest quarter, or with the choice.
    pub high: f64,
    /// Values of the input there; none of a choice.
    pub between: Option<[f64; 2]>,
    /// Difference between the two with its 5 % and 95 % quantiles.
    #[serde(flatten, serialize_with = "Difference::serialize")]
    pub difference: Estimate,
    /// Correlation of input and result.
    pub correlation: f64,
}

/// An input with its value in every case.
#[derive(Debug, Clone, PartialEq)]
pub struct Regressor {
    /// Its name.
    pub name: String,
    /// Its values; of a choice 1 in the cases that have it, and 0 in the others.
    pub values: Vec<f64>,
    /// Whether it is a choice.
    pub is_choice: bool,
}

/// Sobol's indices of an input, each with its 95 % interval.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Indices {
    /// Share of the variance due to the input without interactions.
    #[serde(flatten, serialize_with = "First::serialize")]
    pub first: Estimate,
    /// Share of the variance due to the input and its interactions.
    #[serde(flatten, serialize_with = "Total::serialize")]
    pub total: Estimate,
}

/// Number of bootstrap samples.
const RESAMPLINGS: usize = 1000;
/// Quantiles at the ends of the intervals.
const ENDS: [f64; 2] = [0.025, 0.975];

/// Fewest cases of a regression.
const FEWEST: usize = 8;

/// Effects of `inputs` on a result `y` by one linear regression on all of them; `None` for an input that is constant, and
/// for all inputs if there are fewer than eight cases, not more cases than inputs, or inputs that depend on each other.
#[must_use]
pub fn effects(inputs: &[Regressor], y: &[f64]) -> Vec<Option<Effect>> {
    let n = y.len();
    let moments = inputs
        .iter()
        .map(|input| mean_and_square(input.values.iter().copied()));
    let moments: Vec<(f64, f64)> = moments.collect();
    let varied: Vec<usize> = (0..inputs.len()).filter(|i| moments[*i].1 > 0.0).collect();
    let none = || vec![None; inputs.len()];
    let (mean, square) = mean_and_square(y.iter().copied());
    if n < FEWEST || n < varied.len() + 2 || square.is_nan() || square <= 0.0 {
        return none();
    }
    // Standardised, so that the pivots tell whether inputs depend on each other.
    let x = |i: usize, k: usize| (inputs[i].values[k] - moments[i].0) / moments[i].1.sqrt();
    let product = |of: &dyn Fn(usize) -> f64| (0..n).map(of).sum::<f64>() / n as f64;
    let normal = DMatrix::from_fn(varied.len(), varied.len(), |i, j| {
        product(&|k| x(varied[i], k) * x(varied[j], k))
    });
    let Some(inverse) = inverse(normal) else {
        return none();
    };
    let right = DVector::from_fn(varied.len(), |i, _| {
        product(&|k| x(varied[i], k) * (y[k] - mean))
    });
    let slopes = &inverse * &right;
    let explained = slopes.dot(&right);
    let left = (square - explained).max(0.0) / (n - varied.len() - 1) as f64;
    let mut found = none();
    for (at, &i) in varied.iter().enumerate() {
        let between = ends(&inputs[i]);
        let ends = between.map(|x| (x - moments[i].0) / moments[i].1.sqrt());
        let [low, high] = ends.map(|x| mean + slopes[at] * x);
        let error = (left * inverse[(at, at)]).sqrt() * (ends[1] - ends[0]);
        found[i] = Some(Effect {
            low,
            high,
            between: (!inputs[i].is_choice).then_some(between),
            difference: Estimate::new(high - low, [-Z_95, Z_95].map(|z| high - low + z * error)),
            correlation: right[at] / square.sqrt(),
        });
    }
    found
}

/// Means of the lowest and of the highest quarter of an input; 0 and 1 of a choice.
fn ends(input: &Regressor) -> [f64; 2] {
    if input.is_choice {
        return [0.0, 1.0];
    }
    let mut sorted = input.values.clone();
    sorted.sort_by(f64::total_cmp);
    let quarter = (sorted.len() / 4).max(1);
    let mean = |part: &[f64]| part.iter().sum::<f64>() / part.len() as f64;
    [
        mean(&sorted[..quarter]),
        mean(&sorted[sorted.len() - quarter..]),
    ]
}

/// Inverse of a correlation matrix; `None` if it is singular.
fn inverse(matrix: DMatrix<f64>) -> Option<DMatrix<f64>> {
    /// Smallest pivot of inputs that do not depend on each other.
    const LEAST: f64 = 1e-9;
    let factor = matrix.cholesky()?;
    let least = factor.l_dirty().diagonal().min();
    (least * least >= LEAST).then(|| factor.inverse())
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
/// assert!((found[0].first.value - 0.2).abs() < 0.02 && (found[1].total.value - 0.8).abs() < 0.02);
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
        first: Estimate::new(point[0], interval(resampled, 0)),
        total: Estimate::new(point[1], interval(resampled, 1)),
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
                for (inside, index) in inside.iter_mut().zip([index.first, index.total]) {
                    *inside += usize::from(index.contains(exact));
                    assert!((index.value - exact).abs() < 0.05);
                }
            }
        }
        // 95 % of 30 intervals hold the exact value on average; a quasi-random sample does better.
        assert!(inside[0] >= 27 && inside[1] >= 27, "{inside:?}");
    }

    #[test]
    fn effects_of_a_linear_function_are_those_of_its_slopes_also_where_inputs_move_together() {
        let input = |name: &str, is_choice, of: fn(usize) -> f64| Regressor {
            name: name.to_owned(),
            values: (0..100).map(of).collect(),
            is_choice,
        };
        let inputs = [
            input("axis", false, |k| k as f64),
            // Correlated with the axis, and without an effect of its own.
            input("other", false, |k| k as f64 + (k * 7 % 10) as f64),
            input("finish", true, |k| f64::from(u8::from(k % 3 == 0))),
            input("constant", false, |_| 1.0),
        ];
        let y: Vec<f64> = (0..100)
            .map(|k| 5.0 - 2.0 * inputs[0].values[k] + 30.0 * inputs[2].values[k])
            .collect();
        let found = effects(&inputs, &y);
        let difference = |i: usize| found[i].unwrap().difference.value;
        assert!((difference(0) + 150.0).abs() < 1e-9, "{found:?}");
        assert!(difference(1).abs() < 1e-9 && (difference(2) - 30.0).abs() < 1e-9);
        assert!(found[3].is_none() && found[1].unwrap().correlation < -0.9);
        let same = [inputs[0].clone(), inputs[0].clone()];
        assert_eq!(effects(&same, &y), [None, None]);
        assert_eq!(effects(&inputs, &[1.0; 100]), [None; 4]);
    }
}
