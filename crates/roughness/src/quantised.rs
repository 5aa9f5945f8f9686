//! Heights that an instrument counted in steps, on the material ratio curve.
//!
//! On a staircase many windows of 40 % fall by equally many steps, and the first of them (ISO 13565-2) lies high on
//! the curve where the slope is not the least: Rk of Gaussian heights comes out 16 % too large at a step of
//! Rq/2 and 36 % at Rq. So the points of a step are spread evenly over it, as rounding gathered them.

use asperity_core::cite;

/// Fewest levels; two heights of a grating are no rounding.
const FEWEST_LEVELS: usize = 8;
/// Part of a step by which a level may be off its place.
const OFF: f64 = 1e-3;

/// s_j = s + q (½ − (j + ½)/n) for the n points j of a step of height s                [Rk-3]
///
/// The heights `s` \[m\] in falling order, changed where all of them are multiples of a step q and points share
/// levels; they stay in order.
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

/// The step of which all differences of `s` are multiples, where there is one and points share levels.
fn step(s: &[f64]) -> Option<f64> {
    let gaps = || {
        s.windows(2)
            .map(|pair| pair[0] - pair[1])
            .filter(|gap| *gap > 0.0)
    };
    let levels = gaps().count() + 1;
    if levels < FEWEST_LEVELS || levels == s.len() {
        return None;
    }
    let step = gaps().fold(f64::INFINITY, f64::min);
    let multiple = |gap: f64| {
        let steps = gap / step;
        (steps - steps.round()).abs() <= OFF * steps.round()
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
