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

/// Interval between two neighbours of ascending nodes, and a place in it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NodeInterval {
    /// Index of the lower node.
    pub low: usize,
    /// Index of the upper node, equal to `low` for a single node.
    pub high: usize,
    /// Fraction of the interval below the place, 0 to 1; −∞ before the first node, ∞ beyond the last, NaN for a place
    /// that is not a number.
    pub part: f64,
}

impl NodeInterval {
    /// Interval of the ascending `nodes` that holds `place`; `position` is the position of a node. Without nodes its
    /// part is infinite.
    ///
    /// ```
    /// use asperity_core::numerics::NodeInterval;
    /// let interval = NodeInterval::from_nodes(&[1.0, 3.0, 7.0], |node| *node, 4.0);
    /// assert_eq!((interval.low, interval.high, interval.part), (1, 2, 0.25));
    /// assert_eq!(interval.mean(|k| [0.0, 8.0, 16.0][k]), 10.0);
    /// ```
    pub fn from_nodes<N>(nodes: &[N], position: impl Fn(&N) -> f64, place: f64) -> Self {
        let above = nodes.partition_point(|node| position(node) <= place);
        let last = nodes.len().saturating_sub(1);
        let high = above.clamp(last.min(1), last);
        let low = high.saturating_sub(1);
        let part = if place.is_nan() {
            f64::NAN
        } else if above == 0 {
            f64::NEG_INFINITY
        } else if above < nodes.len() {
            let from = position(&nodes[low]);
            (place - from) / (position(&nodes[high]) - from)
        } else if position(&nodes[last]) == place {
            1.0
        } else {
            f64::INFINITY
        };
        Self { low, high, part }
    }

    /// The interval, unless its place is outside of the nodes.
    #[must_use]
    pub fn inside(self) -> Option<Self> {
        (0.0..=1.0).contains(&self.part).then_some(self)
    }

    /// The place moved to the nearest node if it is outside of them.
    #[must_use]
    pub fn held(self) -> Self {
        Self {
            part: self.part.clamp(0.0, 1.0),
            ..self
        }
    }

    /// Linear interpolation of the `value`s of the nodes at a place within them.
    pub fn mean(self, value: impl Fn(usize) -> f64) -> f64 {
        (1.0 - self.part) * value(self.low) + self.part * value(self.high)
    }
}

#[cfg(test)]
mod tests {
    use super::{NodeInterval, Point, interpolate};

    #[test]
    fn a_place_outside_of_the_nodes_is_held_or_refused_and_nan_stays_nan() {
        let nodes = [1.0, 3.0, 4.0];
        let at = |place| NodeInterval::from_nodes(&nodes, |node| *node, place);
        let value = |place: f64| at(place).held().mean(|k| [2.0, 6.0, 0.0][k]);
        assert_eq!(
            [0.0, 1.0, 2.0, 3.0, 3.5, 4.0, 9.0].map(value),
            [2.0, 2.0, 4.0, 6.0, 3.0, 0.0, 0.0]
        );
        let is_inside = |place: f64| at(place).inside().is_some();
        assert_eq!(
            [0.9, 1.0, 3.0, 4.0, 4.1, f64::NAN].map(is_inside),
            [false, true, true, true, false, false]
        );
        assert!(value(f64::NAN).is_nan());
        let single = |place| NodeInterval::from_nodes(&[5.0], |node| *node, place);
        assert_eq!(
            [4.0, 5.0, 6.0].map(|place| single(place).held().mean(|k| [8.0][k])),
            [8.0; 3]
        );
        assert_eq!(
            [4.0, 5.0, 6.0].map(|place| single(place).inside().is_some()),
            [false, true, false]
        );
        assert_eq!(
            NodeInterval::from_nodes::<f64>(&[], |node| *node, 1.0).inside(),
            None
        );
    }

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
