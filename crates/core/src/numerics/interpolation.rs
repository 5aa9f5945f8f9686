//! Linear interpolation.

/// Abscissa and value.
type Point = (f64, f64);

/// Linear interpolation at `x` of `points` in ascending order, constant beyond the first and the last; zero without
/// points.
///
/// ```
/// use asperity_core::numerics::interpolate;
/// assert_eq!(interpolate(&[(1.0, 2.0), (3.0, 6.0)], 2.0), 4.0);
/// assert_eq!(interpolate(&[[1.0, 2.0], [3.0, 6.0]], 9.0), 6.0);
/// ```
pub fn interpolate<P: Copy + Into<Point>>(points: &[P], x: f64) -> f64 {
    let point = |k: usize| points.get(k).map(|point| (*point).into());
    let above = points.partition_point(|point| (*point).into().0 <= x);
    let below = above.checked_sub(1).and_then(point);
    interpolate_between(below, point(above), x)
}

/// Linear interpolation at `x` between its neighbours; with a single neighbour its value, without any zero.
pub fn interpolate_between(below: Option<Point>, above: Option<Point>, x: f64) -> f64 {
    match (below, above) {
        (Some((x0, y0)), Some((x1, y1))) => y0 + (y1 - y0) * (x - x0) / (x1 - x0),
        (Some((_, y)), None) | (None, Some((_, y))) => y,
        (None, None) => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::{Point, interpolate};

    #[test]
    fn a_line_is_straight_between_its_points_and_level_beyond() {
        let line = [(1.0, 2.0), (3.0, 6.0), (4.0, 0.0)];
        let at = |x| interpolate(&line, x);
        assert_eq!(
            [
                at(0.0),
                at(1.0),
                at(2.0),
                at(3.0),
                at(3.5),
                at(4.0),
                at(9.0)
            ],
            [2.0, 2.0, 4.0, 6.0, 3.0, 0.0, 0.0]
        );
        assert_eq!(interpolate::<Point>(&[], 1.0), 0.0);
        assert_eq!(interpolate(&[(1.0, 5.0)], 7.0), 5.0);
    }
}
