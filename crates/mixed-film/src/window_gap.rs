//! Mean gap under a window: the film of the inlet is thinner under plateaus than over valleys.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | y | height of both flanks as the inlet leaves them, over their mean lines | m |
//! | ȳ | its mean in the middle .8 of the Hertz contact, the length that the mean gap is of | m |
//! | h̄ | mean gap of the whole trace, h_g Ψ | m |
//! | g | mean gap of the window | m |

use asperity_core::cite;

/// Mean gap under a window whose middle .8 has the mean height `middle` over the mean line, where the mean gap of the whole trace is
/// `gap` \[m\], and its derivatives over both.
///
/// ```text
/// g = (u + √(u² + c² h̄²))/(1 + √(1 + c²)),  u = h̄ − ȳ, c = 0.1                           [Window-gap]
/// ```
///
/// The film that leaves the inlet is h̄ − y, and moves on with the heights y: under plateaus it is thinner than its mean h̄, over valleys
/// thicker. g is h̄ − ȳ within .5 % of h̄ where ȳ is less than half of it either way, and stays above 0 where a middle is higher than h̄.
pub(crate) fn gap_under(gap: f64, middle: f64) -> (f64, [f64; 2]) {
    cite!("Window-gap");
    const THIN: f64 = 0.1;
    let apart = gap - middle;
    let root = apart.hypot(THIN * gap);
    let scale = 1.0 + 1.0_f64.hypot(THIN);
    let by_apart = (1.0 + apart / root) / scale;
    let by_gap = by_apart + THIN * THIN * gap / (root * scale);
    ((apart + root) / scale, [by_gap, -by_apart])
}

/// Points of a window up to `reach` points from its middle, with their weights in a mean over this length: a point at its end counts
/// by the part of its cell within it, so that the mean is steady where the length grows. None of no length.
pub(crate) fn middle_weights(
    points: usize,
    reach: f64,
) -> impl Iterator<Item = (usize, f64)> + Clone {
    let middle = 0.5 * (points as f64 - 1.0);
    let from_middle = move |i: usize| (i as f64 - middle).abs();
    let part = move |i: usize| (reach - from_middle(i) + 0.5).clamp(0.0, 1.0);
    let aside = (middle - reach - 0.5).max(0.0).ceil() as usize;
    let within = aside..if reach > 0.0 { points - aside } else { aside };
    let length: f64 = within.clone().map(part).sum();
    within.map(move |i| (i, part(i) / length))
}

/// Mean height of a window up to `reach` points from its middle, over the mean line of the traces; 0 of no length.
pub(crate) fn middle_height<const N: usize>(heights: [&[f64]; N], reach: f64) -> f64 {
    let weighted = |(i, weight)| weight * heights.iter().map(|of| of[i]).sum::<f64>();
    middle_weights(heights[0].len(), reach).map(weighted).sum()
}

/// Derivative of the mean height over the height at each of `points`.
pub(crate) fn middle_gradient(points: usize, reach: f64) -> Vec<f64> {
    let mut gradient = vec![0.0; points];
    for (i, weight) in middle_weights(points, reach) {
        gradient[i] = weight;
    }
    gradient
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_window_has_the_gap_of_its_middle() {
        // A plateau of 60 points between valleys, under a film that reaches 20 or 40 points from the middle.
        let plateau = |i: usize| {
            if (70..130).contains(&i) {
                0.2e-6
            } else {
                -0.1e-6
            }
        };
        let heights: Vec<f64> = (0..200).map(plateau).collect();
        let gap = |reach| gap_under(1e-6, middle_height([&heights], reach)).0;
        assert!((gap(20.0) / 0.8e-6 - 1.0).abs() < 2e-3);
        let middle = (60.0 * 0.2e-6 - 20.0 * 0.1e-6) / 80.0;
        assert!((gap(40.0) / (1e-6 - middle) - 1.0).abs() < 2e-3);
        // Without a length, and without roughness, it is that of the trace.
        assert_eq!(gap(0.0), 1e-6);
        assert_eq!(gap_under(1e-6, 0.0).0, 1e-6);
    }

    #[test]
    fn the_middle_changes_steadily_with_its_length_and_not_with_a_slope() {
        for points in [200, 201] {
            let slope: Vec<f64> = (0..points)
                .map(|i| i as f64 - 0.5 * (points - 1) as f64)
                .collect();
            let bend: Vec<f64> = slope.iter().map(|x| x * x).collect();
            let mut before = middle_height([&bend], 0.1);
            for k in 2..900 {
                let reach = 0.1 * f64::from(k);
                assert!(middle_height([&slope], reach).abs() < 1e-9);
                let middle = middle_height([&bend], reach);
                assert!(
                    middle >= before && middle - before < 0.2 * (reach + 1.0),
                    "{reach}"
                );
                before = middle;
            }
        }
    }

    #[test]
    fn the_gap_stays_open_and_has_its_slopes() {
        let mut before = f64::INFINITY;
        for k in -30..60 {
            let (gap, middle) = (0.7, 0.05 * f64::from(k));
            let (found, [by_gap, by_middle]) = gap_under(gap, middle);
            assert!(found > 0.0 && found < before);
            before = found;
            let at = |gap, middle| gap_under(gap, middle).0;
            let step = 1e-5;
            let of_gap = (at(gap + step, middle) - at(gap - step, middle)) / (2.0 * step);
            let of_middle = (at(gap, middle + step) - at(gap, middle - step)) / (2.0 * step);
            assert!((by_gap - of_gap).abs() < 1e-8 && (by_middle - of_middle).abs() < 1e-8);
            if middle.abs() < 0.5 * gap {
                assert!((found - (gap - middle)).abs() < 0.005 * gap);
            }
        }
        let heights: Vec<f64> = (0..50).map(|i| f64::from(i * i % 17)).collect();
        let gradient = middle_gradient(50, 12.3);
        let product: f64 = gradient.iter().zip(&heights).map(|(a, b)| a * b).sum();
        assert!((product - middle_height([&heights], 12.3)).abs() < 1e-12);
    }
}
