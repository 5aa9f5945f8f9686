//! Heights between the points of a periodic profile.

/// Heights of a periodic profile at `count` places from `begin` on, `step` apart, both in its spacings, by the cubic of Catmull
/// and Rom through four points.
///
/// ```
/// use asperity_roughness::generate::stretched;
/// let whole: Vec<f64> = (0..100).map(|i| (f64::from(i) * std::f64::consts::TAU / 100.0).sin()).collect();
/// let part = stretched(&whole, 90.0, 0.5, 40);
/// // Beyond the last point the profile begins again.
/// assert_eq!(part[0], whole[91]);
/// assert_eq!(part[24], whole[3]);
/// let between = (2.5 * std::f64::consts::TAU / 100.0).sin();
/// assert!((part[23] - between).abs() < 1e-5);
/// ```
///
/// # Panics
/// When the profile has no points.
#[must_use]
pub fn stretched(heights: &[f64], begin: f64, step: f64, count: usize) -> Vec<f64> {
    let n = heights.len();
    let at = |i: usize| {
        let x = begin + i as f64 * step;
        let cell = x as usize;
        let first = cell % n;
        let four = match heights.get(first..first + 4) {
            Some(four) => [four[0], four[1], four[2], four[3]],
            None => [0, 1, 2, 3].map(|k| heights[(first + k) % n]),
        };
        between(four, x - cell as f64)
    };
    (0..count).map(at).collect()
}

/// The cubic of Catmull and Rom at `t` from the second to the third of four even values.
fn between([a, b, c, d]: [f64; 4], t: f64) -> f64 {
    let second = 2.0 * a - 5.0 * b + 4.0 * c - d;
    let third = 3.0 * (b - c) + d - a;
    b + 0.5 * t * (c - a + t * (second + t * third))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cubic_through_four_points_of_a_parabola_is_the_parabola() {
        let z = |x: f64| 1.0 + 2.0 * x - 3.0 * x * x;
        let points = [-1.0, 0.0, 1.0, 2.0].map(z);
        for t in [0.0, 0.3, 0.9] {
            assert!((between(points, t) - z(t)).abs() < 1e-14);
        }
    }
}
