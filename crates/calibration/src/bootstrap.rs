//! Bootstrap over groups: scatter of an estimate when whole assemblies are resampled.

use asperity_core::cite;
use chacha20::ChaCha8Rng;
use rand_core::{Rng, SeedableRng};

/// Estimates from `draws` samples of `groups` groups, drawn with replacement. Samples without an estimate are
/// omitted.
///
/// ```text
/// θ*_b = θ(g_1 .. g_G),  g_k even over 1 .. G                                  [Group-bootstrap]
/// ```
///
/// The same seed gives the same samples. Few groups have few distinct samples: two groups have three.
#[must_use]
pub fn bootstrap<T>(
    groups: usize,
    draws: usize,
    seed: u64,
    mut estimate: impl FnMut(&[usize]) -> Option<T>,
) -> Vec<T> {
    cite!("Group-bootstrap");
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let mut sample = vec![0; groups];
    let mut estimates = Vec::with_capacity(draws);
    for _ in 0..draws {
        for group in &mut sample {
            *group = below(&mut random, groups);
        }
        estimates.extend(estimate(&sample));
    }
    estimates
}

/// A uniform random number below `count`.
fn below(random: &mut ChaCha8Rng, count: usize) -> usize {
    const STEPS: f64 = (1_u64 << 53) as f64;
    let even = (random.next_u64() >> 11) as f64 / STEPS;
    ((even * count as f64) as usize).min(count.saturating_sub(1))
}

/// Ends of the middle `share` of the values, interpolated; `None` without values.
#[must_use]
pub fn middle(values: &[f64], share: f64) -> Option<[f64; 2]> {
    let mut values = values.to_vec();
    values.sort_by(f64::total_cmp);
    let last = values.len().checked_sub(1)?;
    let quantile = |p: f64| {
        let position = p * last as f64;
        let k = (position as usize).min(last.saturating_sub(1));
        values[k] + (position - k as f64) * (values[(k + 1).min(last)] - values[k])
    };
    Some([0.5 - 0.5 * share, 0.5 + 0.5 * share].map(quantile))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_bootstrap_of_a_mean_has_its_standard_error() {
        let values: Vec<f64> = (0..20).map(|k| f64::from(k * k % 23)).collect();
        let n = values.len() as f64;
        let mean = values.iter().sum::<f64>() / n;
        let variance = values.iter().map(|v| (v - mean) * (v - mean)).sum::<f64>() / n;
        let means = bootstrap(20, 4000, 1, |sample| {
            Some(sample.iter().map(|k| values[*k]).sum::<f64>() / n)
        });
        let count = means.len() as f64;
        let estimates = means.iter().sum::<f64>() / count;
        let spread = (means
            .iter()
            .map(|m| (m - estimates) * (m - estimates))
            .sum::<f64>()
            / count)
            .sqrt();
        // s/√n; 4000 draws know it to 1/√8000 = 1.1 %, three times that is allowed.
        let error = (variance / n).sqrt();
        assert!((spread / error - 1.0).abs() < 0.034, "{spread} {error}");
        assert!((estimates - mean).abs() < 4.0 * error / count.sqrt());
        let [low, high] = middle(&means, 0.95).unwrap();
        assert!(((high - low) / (2.0 * 1.96 * error) - 1.0).abs() < 0.06);
    }

    #[test]
    fn two_groups_have_three_samples() {
        let mut samples = bootstrap(2, 100, 7, |sample| Some(sample.iter().sum::<usize>()));
        samples.sort_unstable();
        samples.dedup();
        assert_eq!(samples, [0, 1, 2]);
        assert_eq!(bootstrap(3, 10, 7, |_| None::<f64>), Vec::<f64>::new());
        assert_eq!(middle(&[], 0.95), None);
        assert_eq!(middle(&[4.0], 0.95), Some([4.0, 4.0]));
    }
}
