//! Intervals of a mean by Student's t, and Spearman's rank correlation.
//!
//! The interval of a paired difference is that of the mean of the differences (paired t). Windows that
//! overlap on a short trace are not independent: the interval is then a lower bound, and the run says so.

use serde::Serialize;

/// A mean with its interval.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Interval {
    /// The mean.
    pub mean: f64,
    /// Half the width of the interval; none from a single value.
    pub half_width: Option<f64>,
    /// Values it rests on.
    pub values: usize,
}

impl Interval {
    /// " ± 1.3", or nothing where a single value has no interval.
    pub(super) fn spread(&self) -> String {
        let half = self.half_width.map(|half| format!(" ± {half:.1}"));
        half.unwrap_or_default()
    }
}

/// x̄ ± t(ν, c) s/√n,  ν = n − 1
///
/// Fewer than two values have no half width.
///
/// ```
/// use asperity_studies::compare::paired_interval;
/// let found = paired_interval(&[1.0, 2.0, 3.0, 4.0, 5.0], 0.95);
/// // t(4, 95 %) = 2.7764, s/√n = 0.70711.
/// assert_eq!(found.mean, 3.0);
/// assert!(found.half_width.is_some_and(|half| (half - 1.96324).abs() < 1e-5));
/// assert_eq!(paired_interval(&[1.0], 0.95).half_width, None);
/// ```
pub fn paired_interval(values: &[f64], confidence: f64) -> Interval {
    let n = values.len();
    let mean = values.iter().sum::<f64>() / n as f64;
    if n < 2 {
        return Interval {
            mean,
            half_width: None,
            values: n,
        };
    }
    let square: f64 = values.iter().map(|v| (v - mean).powi(2)).sum();
    let error = (square / ((n - 1) as f64 * n as f64)).sqrt();
    Interval {
        mean,
        half_width: Some(student_t(n - 1, confidence) * error),
        values: n,
    }
}

/// t with A(t | ν) = `confidence`, by bisection.
fn student_t(freedom: usize, confidence: f64) -> f64 {
    /// Halvings of a bracket as wide as f64 can hold down to its last digit.
    const HALVINGS: usize = 200;
    let (mut low, mut high) = (0.0, 1.0);
    while inside(high, freedom) < confidence && high < 1e12 {
        high *= 2.0;
    }
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if inside(middle, freedom) < confidence {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

/// A(t | ν): the share of Student's distribution between −t and t (Abramowitz and Stegun 26.7.3, 26.7.4).
fn inside(t: f64, freedom: usize) -> f64 {
    let theta = (t / (freedom as f64).sqrt()).atan();
    let (sine, cosine) = theta.sin_cos();
    let square = cosine * cosine;
    // 1 + cos²θ·(first) + ... with factors k/(k + 1), up to the power ν − 2 (even) or ν − 3 (odd).
    let series = |first: usize| {
        let (mut term, mut sum, mut k) = (1.0, 1.0, first);
        while k + 2 <= freedom.saturating_sub(1) + usize::from(first == 1) {
            term *= square * k as f64 / (k + 1) as f64;
            sum += term;
            k += 2;
        }
        sum
    };
    if freedom.is_multiple_of(2) {
        return sine * series(1);
    }
    let tail = if freedom > 1 {
        sine * cosine * series(2)
    } else {
        0.0
    };
    2.0 / std::f64::consts::PI * (theta + tail)
}

/// Spearman's ρ of pairs: the correlation of their ranks, ties taking their mean rank; not a number
/// where one of both does not vary.
///
/// ```
/// use asperity_studies::compare::rank_correlation;
/// assert_eq!(rank_correlation(&[[1.0, 10.0], [2.0, 11.0], [3.0, 90.0]]), 1.0);
/// ```
pub fn rank_correlation(pairs: &[[f64; 2]]) -> f64 {
    let ranks = [0, 1].map(|side| ranks(&pairs.iter().map(|pair| pair[side]).collect::<Vec<_>>()));
    let middle = 0.5 * (pairs.len() as f64 + 1.0);
    let sum = |a: &[f64], b: &[f64]| -> f64 {
        a.iter()
            .zip(b)
            .map(|(a, b)| (a - middle) * (b - middle))
            .sum()
    };
    let [x, y] = &ranks;
    sum(x, y) / (sum(x, x) * sum(y, y)).sqrt()
}

fn ranks(values: &[f64]) -> Vec<f64> {
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|a, b| values[*a].total_cmp(&values[*b]));
    let mut ranks = vec![0.0; values.len()];
    let mut start = 0;
    while start < order.len() {
        let same = |k: &usize| values[order[*k]] == values[order[start]];
        let end = (start..order.len()).take_while(same).count() + start;
        let mean = 0.5 * ((start + 1) + end) as f64;
        for &index in &order[start..end] {
            ranks[index] = mean;
        }
        start = end;
    }
    ranks
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn student_t_has_its_tabulated_values() {
        // Abramowitz and Stegun, table 26.10; three decimals are printed there.
        for (freedom, confidence, expected) in [
            (1, 0.95, 12.706),
            (2, 0.95, 4.303),
            (3, 0.95, 3.182),
            (4, 0.95, 2.776),
            (15, 0.95, 2.131),
            (30, 0.99, 2.750),
        ] {
            let found = student_t(freedom, confidence);
            assert!((found - expected).abs() < 6e-4, "{freedom} {found}");
        }
    }

    #[test]
    fn ties_share_their_rank() {
        assert_eq!(ranks(&[3.0, 1.0, 3.0, 2.0]), [3.5, 1.0, 3.5, 2.0]);
        assert!(rank_correlation(&[[1.0, 5.0], [2.0, 5.0]]).is_nan());
        assert_eq!(
            rank_correlation(&[[1.0, 3.0], [2.0, 2.0], [3.0, 1.0]]),
            -1.0
        );
    }
}
