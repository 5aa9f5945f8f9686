//! Material ratio curve of quantised heights.
//!
//! The curve of quantised heights is a staircase: many windows of 40 % fall by the same number of steps, and the first
//! of them (ISO 13565-2) is high on the curve, where the slope is not the smallest. Rk of Gaussian heights would be 16
//! % too large at a step of Rq/2 and 36 % at Rq. The points of a step are therefore distributed evenly over its height.

use asperity_core::cite;

/// Minimum number of levels: the two heights of a grating are not quantisation.
const MIN_LEVELS: usize = 8;
/// Tolerance of a level, as a fraction of a step.
const LEVEL_TOLERANCE: f64 = 1e-3;

/// s_j = s + q (½ − (j + ½)/n) for the n points j of a step of height s                [Rk-3]
///
/// Distributes the heights `s` \[m\] in descending order if all their differences are multiples of a step q and levels
/// repeat. The order is preserved.
pub(crate) fn spread(mut s: Vec<f64>) -> Vec<f64> {
    let Some(step) = step(&s) else {
        return s;
    };
    cite!("Rk-3");
    let mut first = 0;
    while first < s.len() {
        let level = s[first];
        let same = s[first..].iter().take_while(|z| **z == level).count();
        for (j, z) in s[first..first + same].iter_mut().enumerate() {
            *z = level + step * (0.5 - (j as f64 + 0.5) / same as f64);
        }
        first += same;
    }
    s
}

/// The step of quantised heights: all differences of `s` are multiples of it and levels repeat.
fn step(s: &[f64]) -> Option<f64> {
    let gaps = || {
        s.windows(2)
            .map(|pair| pair[0] - pair[1])
            .filter(|gap| *gap > 0.0)
    };
    let levels = gaps().count() + 1;
    if levels < MIN_LEVELS || levels == s.len() {
        return None;
    }
    let step = gaps().fold(f64::INFINITY, f64::min);
    let multiple = |gap: f64| {
        let steps = gap / step;
        (steps - steps.round()).abs() <= LEVEL_TOLERANCE * steps.round()
    };
    gaps().all(multiple).then_some(step)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_points_of_a_step_are_spread_over_it() {
        let s: Vec<f64> = (0..10)
            .rev()
            .flat_map(|level| [f64::from(level); 2])
            .collect();
        let found = spread(s);
        let even = (0..20).map(|k| 9.25 - 0.5 * f64::from(k));
        assert!(
            found.iter().zip(even).all(|(a, b)| (a - b).abs() < 1e-12),
            "{found:?}"
        );
    }

    #[test]
    fn heights_that_are_no_multiples_of_a_step_stay() {
        let irregular: Vec<f64> = (0..20)
            .rev()
            .map(|i| (f64::from(i / 2)).powf(1.1))
            .collect();
        assert_eq!(spread(irregular.clone()), irregular);
        let grating = vec![1.0, 1.0, 1.0, 0.0, 0.0, 0.0];
        assert_eq!(spread(grating.clone()), grating);
    }
}
