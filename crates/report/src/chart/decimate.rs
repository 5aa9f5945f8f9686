//! Fewer points for display: in each column the lowest and the highest stay, so no peak is lost.

/// `points` along rising x thinned to at most four points in each of `columns` columns: the first, the
/// lowest, the highest and the last, in their order. Shorter rows stay as they are.
///
/// ```
/// use asperity_report::chart::decimated;
/// let spike: Vec<[f64; 2]> = (0..10_000).map(|i| [f64::from(i), if i == 4321 { 9.0 } else { 0.0 }]).collect();
/// let few = decimated(&spike, 100);
/// assert!(few.len() <= 400 && few.contains(&[4321.0, 9.0]));
/// ```
pub fn decimated(points: &[[f64; 2]], columns: usize) -> Vec<[f64; 2]> {
    const POINTS_OF_A_COLUMN: usize = 4;
    if columns == 0 || points.len() <= POINTS_OF_A_COLUMN * columns {
        return points.to_vec();
    }
    let mut few = Vec::with_capacity(POINTS_OF_A_COLUMN * columns);
    for column in 0..columns {
        let from = column * points.len() / columns;
        let to = (column + 1) * points.len() / columns;
        let part = &points[from..to];
        let height = |k: usize| part[k][1];
        let (mut low, mut high) = (0, 0);
        for k in 1..part.len() {
            // Comparisons with a missing value fail and leave it out.
            if height(k) < height(low) || height(low).is_nan() {
                low = k;
            }
            if height(k) > height(high) || height(high).is_nan() {
                high = k;
            }
        }
        let mut kept = [0, low, high, part.len() - 1];
        kept.sort_unstable();
        few.extend(
            kept.iter()
                .enumerate()
                .filter(|(i, k)| *i == 0 || kept[i - 1] != **k)
                .map(|(_, k)| part[*k]),
        );
    }
    few
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn extremes_and_order_survive() {
        let wave = |i: i32| {
            [
                f64::from(i),
                (f64::from(i) * 0.37).sin() * f64::from(i % 911),
            ]
        };
        let points: Vec<[f64; 2]> = (0..100_000).map(wave).collect();
        let few = decimated(&points, 500);
        let extreme = |of: &[[f64; 2]]| {
            of.iter()
                .fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], p| {
                    [a.min(p[1]), b.max(p[1])]
                })
        };
        assert_eq!(extreme(&few), extreme(&points));
        assert!(few.windows(2).all(|pair| pair[0][0] < pair[1][0]));
        assert!(few.len() <= 2000);
    }

    #[test]
    fn short_rows_stay_whole() {
        let points = [[0.0, 1.0], [1.0, f64::NAN], [2.0, 3.0]];
        assert_eq!(decimated(&points, 10).len(), 3);
    }
}
