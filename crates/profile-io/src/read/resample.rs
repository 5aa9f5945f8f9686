//! Resampling of uneven points to an even grid, with the resulting change of the heights.

use asperity_core::Profile;
use asperity_core::quantity::Length;

/// Interpolation between points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Between {
    /// Straight lines.
    Lines,
    /// The natural cubic spline, for points of involutes, whose spacing varies along the trace: straight lines would
    /// flatten short waves.
    Spline,
}

/// A trace on an even grid, with the distances of the original points from the lines between its points.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Resampled {
    /// The trace from its first point on.
    pub profile: Profile,
    /// Root mean square of the differences.
    pub rms: Length,
    /// The largest difference.
    pub most: Length,
}

/// Heights in `intervals` steps of `spacing` from the first of the ascending `x`, ending at the last or before it.
pub(super) fn on_grid(
    x: &[f64],
    z: &[f64],
    spacing: f64,
    intervals: usize,
    between: Between,
) -> Vec<f64> {
    let positions = (0..=intervals).map(|i| x[0] + spacing * i as f64);
    match between {
        Between::Lines => on_lines(positions, x, z),
        Between::Spline => super::natural_spline::at_rising(positions, x, z),
    }
}

/// Heights at ascending `positions` by linear interpolation, constant beyond the last point.
fn on_lines(positions: impl Iterator<Item = f64>, x: &[f64], z: &[f64]) -> Vec<f64> {
    let last = x.len() - 1;
    let mut at = 0;
    let value = |position: f64| {
        while at + 1 < last && x[at + 1] <= position {
            at += 1;
        }
        let share = (position - x[at]) / (x[at + 1] - x[at]);
        z[at] + (z[at + 1] - z[at]) * share.clamp(0.0, 1.0)
    };
    positions.map(value).collect()
}

/// Root mean square and largest distance of the points from the lines between even `heights`; points beyond the last of
/// these are omitted.
pub(super) fn change(x: &[f64], z: &[f64], spacing: f64, heights: &[f64]) -> (f64, f64) {
    let last = heights.len() - 1;
    let (mut squares, mut most, mut count) = (0.0, 0.0_f64, 0_usize);
    for (x_at, z_at) in x.iter().zip(z) {
        let steps = (x_at - x[0]) / spacing;
        let at = (steps as usize).min(last.saturating_sub(1));
        let share = steps - at as f64;
        if share > 1.0 + 1e-9 {
            break;
        }
        let line = heights[at] + (heights[last.min(at + 1)] - heights[at]) * share;
        squares += (line - z_at).powi(2);
        most = most.max((line - z_at).abs());
        count += 1;
    }
    ((squares / count.max(1) as f64).sqrt(), most)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_uneven_trace_is_resampled_by_straight_lines() {
        let x = [0.0, 1.0, 2.5, 3.0, 4.0];
        let z = x.map(|x| 2.0 * x + 1.0);
        let even = on_grid(&x, &z, 1.0, 4, Between::Lines);
        assert_eq!(even, [1.0, 3.0, 5.0, 7.0, 9.0]);
        assert_eq!(change(&x, &z, 1.0, &even), (0.0, 0.0));
    }

    #[test]
    fn the_change_is_the_distance_of_the_points_from_the_new_lines() {
        // The tip at 2.5 is cut off: the line from (2, 0.5) to (3, 0.5) passes half below it.
        let (x, z) = (
            [0.0, 1.0, 1.5, 2.5, 3.5, 4.0],
            [0.0, 0.0, 0.0, 1.0, 0.0, 0.0],
        );
        let even = on_grid(&x, &z, 1.0, 4, Between::Lines);
        assert_eq!(even, [0.0, 0.0, 0.5, 0.5, 0.0]);
        let (rms, most) = change(&x, &z, 1.0, &even);
        // Differences 0.25 at 1.5, −0.5 at 2.5, 0.25 at 3.5.
        assert_eq!(most, 0.5);
        assert!((rms - ((0.0625 + 0.25 + 0.0625) / 6.0_f64).sqrt()).abs() < 1e-15);
    }
}
