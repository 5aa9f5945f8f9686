//! Paths of drawings in their shortest form: steps in tenths of a unit.

use std::fmt::Write as _;

/// A coordinate in tenths of a unit of the drawing.
pub(super) fn in_tenths(coordinate: f64) -> i64 {
    (10.0 * coordinate).round() as i64
}

/// Appends the step from `before` to `at`, or the beginning of a path there. Differences between points take half the text of
/// coordinates.
pub(super) fn step(d: &mut String, before: Option<[i64; 2]>, at: [i64; 2]) {
    let (command, from) = before.map_or(('M', [0, 0]), |before| ('l', before));
    let [x, y] = [0, 1].map(|k| tenths(at[k] - from[k]));
    let between = if y.starts_with('-') { "" } else { " " };
    let _ = write!(d, "{command}{x}{between}{y}");
}

/// Appends a filled polygon. Points at the same tenth are one, and a polygon of fewer than three is not visible.
pub(super) fn polygon(d: &mut String, places: impl IntoIterator<Item = [f64; 2]>) {
    let mut points: Vec<[i64; 2]> = places
        .into_iter()
        .map(|place| place.map(in_tenths))
        .collect();
    points.dedup();
    if points.first() == points.last() {
        points.pop();
    }
    if points.len() < 3 {
        return;
    }
    let mut before = None;
    for point in points {
        step(d, before, point);
        before = Some(point);
    }
    d.push('z');
}

/// Appends a filled rectangle.
pub(super) fn block(d: &mut String, x: [f64; 2], y: [f64; 2]) {
    let [from, to] = [0, 1].map(|k| [x[k], y[k]].map(in_tenths));
    step(d, None, from);
    let [wide, high] = [0, 1].map(|k| to[k] - from[k]);
    let _ = write!(d, "h{}v{}h{}z", tenths(wide), tenths(high), tenths(-wide));
}

/// A number of tenths in the shortest form of a path: 14 is "1.4", -3 "-.3", 20 "2".
fn tenths(count: i64) -> String {
    let sign = if count < 0 { "-" } else { "" };
    let (whole, tenth) = (count.abs() / 10, count.abs() % 10);
    match (whole, tenth) {
        (whole, 0) => format!("{sign}{whole}"),
        (0, tenth) => format!("{sign}.{tenth}"),
        (whole, tenth) => format!("{sign}{whole}.{tenth}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_polygon_has_its_distinct_points_and_one_without_an_area_has_none() {
        assert_eq!([-13, -3, 0, 20].map(tenths), ["-1.3", "-.3", "0", "2"]);
        let drawn = |places: &[[f64; 2]]| {
            let mut d = String::new();
            polygon(&mut d, places.iter().copied());
            d
        };
        let corner = [[1.0, 2.0], [1.0, 2.04], [3.0, 2.0], [1.5, 1.0], [1.0, 2.0]];
        assert_eq!(drawn(&corner), "M1 2l2 0l-1.5-1z");
        assert_eq!(drawn(&[[1.0, 2.0], [1.04, 2.0], [5.0, 2.0]]), "");
        let mut d = String::new();
        block(&mut d, [1.0, 4.0], [2.0, 1.5]);
        assert_eq!(d, "M1 2h3v-.5h-3z");
    }
}
