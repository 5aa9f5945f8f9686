//! Median, quantiles and spread of draws.

use asperity_core::{Estimate, EstimateKeys, estimate_keys};
use serde::{Deserialize, Serialize};

/// Probabilities of the lower quantile, the median and the upper quantile.
pub const PROBABILITIES: [f64; 3] = [0.05, 0.5, 0.95];

/// Probabilities of the ends of an interval.
pub const ENDS: [f64; 2] = [PROBABILITIES[0], PROBABILITIES[2]];

estimate_keys! {
    /// Keys of a median of drawn losses.
    pub Watts: "median_w" "quantiles_w";
}

/// The median of `values` with their 5 % and 95 % quantiles.
#[must_use]
pub fn median_with_ends(values: &[f64]) -> Estimate {
    let [low, value, high] = sorted_quantiles(values, PROBABILITIES);
    Estimate { value, low, high }
}

/// Median, 5 % and 95 % quantiles of drawn losses, and the standard deviation of their logarithms.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Quantiles {
    /// Median with 5 % and 95 % quantiles \[W\].
    #[serde(flatten, with = "Watts")]
    pub drawn: Estimate,
    /// Standard deviation of the logarithm.
    pub sd_ln: f64,
}

impl Quantiles {
    /// Of drawn losses, interpolated between order statistics.
    ///
    /// ```
    /// use asperity_uncertainty::Quantiles;
    /// let found = Quantiles::from_draws(&(0..=20).map(|k| 100.0 + f64::from(k)).collect::<Vec<_>>());
    /// assert_eq!((found.drawn.value, found.drawn.ends()), (110.0, [101.0, 119.0]));
    /// ```
    #[must_use]
    pub fn from_draws(draws: &[f64]) -> Self {
        let logs: Vec<f64> = draws.iter().map(|loss| loss.ln()).collect();
        let n = logs.len() as f64;
        let mean = logs.iter().sum::<f64>() / n;
        let squares: f64 = logs.iter().map(|log| (log - mean).powi(2)).sum();
        Self {
            drawn: median_with_ends(draws),
            sd_ln: (squares / (n - 1.0).max(1.0)).sqrt(),
        }
    }
}

/// Quantiles of `values` at `probabilities`, interpolated between order statistics; not numbers of no values.
pub fn sorted_quantiles<const N: usize>(values: &[f64], probabilities: [f64; N]) -> [f64; N] {
    let Some(last) = values.len().checked_sub(1) else {
        return [f64::NAN; N];
    };
    let mut values = values.to_vec();
    probabilities.map(|probability| {
        let place = probability * last as f64;
        let k = (place as usize).min(last.saturating_sub(1));
        // Two order statistics, without sorting all draws.
        let (_, low, above) = values.select_nth_unstable_by(k, f64::total_cmp);
        let low = *low;
        let high = above.iter().copied().min_by(f64::total_cmp);
        // Equal neighbours give their value to the last digit.
        low + (place - k as f64) * (high.unwrap_or(low) - low)
    })
}
