//! Thinning of rows for display: the lowest and the highest value of every drawn column remain in each bin of the axis.

use std::ops::Range;

use asperity_core::numerics::{extreme_places, range};

/// Number of bins of a chart along its horizontal axis: about one per pixel of a curve.
pub(crate) const BINS: usize = 350;

/// Thins `rows` to the ends and, in each of `bins` equal parts of the range of `coordinate`, the rows where one of `columns` is
/// lowest, highest, or first undefined: extremes and gaps of every curve remain.
///
/// Consecutive rows in one bin form a group, so rows need not be ordered. Input with at most two rows per bin is
/// returned unchanged.
///
/// ```
/// use asperity_report::thin;
/// let spike: Vec<[f64; 2]> = (0..10_000).map(|i| [f64::from(i), if i == 4321 { 9.0 } else { 0.0 }]).collect();
/// let few = thin(&spike, 100, |row| row[0], |row| [row[1]]);
/// assert!(few.len() <= 202 && few.contains(&[4321.0, 9.0]));
/// ```
pub fn thin<R: Copy, const N: usize>(
    rows: &[R],
    bins: usize,
    coordinate: impl Fn(&R) -> f64,
    columns: impl Fn(&R) -> [f64; N],
) -> Vec<R> {
    let count = rows.len();
    if count <= 2 * bins {
        return rows.to_vec();
    }
    let at = |i: usize| coordinate(&rows[i]);
    let bin = bin_of((0..count).map(at), bins);
    let mut selected = vec![0, count - 1];
    let (mut from, mut cells) = (0, Vec::new());
    while from < count {
        // Consecutive rows in one bin.
        let here = bin(at(from));
        let end = (from + 1..count).find(|i| bin(at(*i)) != here);
        let end = end.unwrap_or(count);
        for column in 0..N {
            cells.clear();
            cells.extend(rows[from..end].iter().map(|row| columns(row)[column]));
            selected.extend(extreme_places(&cells).into_iter().map(|k| from + k));
        }
        from = end;
    }
    in_order(selected).map(|i| rows[i]).collect()
}

/// Places of the rows that [`thin`] leaves of `count` rows whose coordinate rises with their place: `places` gives the places of a range
/// at which a column is lowest, highest or first undefined. A long table is never in memory.
pub(crate) fn thin_rising(
    count: usize,
    bins: usize,
    coordinate: impl Fn(usize) -> f64,
    places: impl Fn(Range<usize>) -> Vec<usize>,
) -> Vec<usize> {
    if count <= 2 * bins {
        return (0..count).collect();
    }
    let bin = bin_of([0, count - 1].map(&coordinate).into_iter(), bins);
    let mut selected = vec![0, count - 1];
    let mut from = 0;
    while from < count {
        let here = bin(coordinate(from));
        let (mut inside, mut end) = (from, count);
        while end - inside > 1 {
            let middle = inside.midpoint(end);
            if bin(coordinate(middle)) == here {
                inside = middle
            } else {
                end = middle
            }
        }
        selected.extend(places(from..end));
        from = end;
    }
    in_order(selected).collect()
}

/// Number of the bin of a coordinate, of `bins` equal parts of the range of `all` that are defined.
fn bin_of(all: impl Iterator<Item = f64>, bins: usize) -> impl Fn(f64) -> usize {
    let [low, high] = range(all.filter(|at| at.is_finite()));
    // The cast saturates, and an undefined coordinate is in the first bin.
    move |at| (((at - low) / (high - low) * bins as f64) as usize).min(bins - 1)
}

fn in_order(mut places: Vec<usize>) -> impl Iterator<Item = usize> {
    places.sort_unstable();
    places.dedup();
    places.into_iter()
}

#[cfg(test)]
mod tests {
    use super::thin;

    fn wave(i: u32) -> [f64; 3] {
        let x = f64::from(i);
        [x, (0.37 * x).sin() * f64::from(i % 911), (0.11 * x).cos()]
    }

    fn few(rows: &[[f64; 3]], bins: usize) -> Vec<[f64; 3]> {
        thin(rows, bins, |row| row[0], |row| [row[1], row[2]])
    }

    fn extremes(rows: &[[f64; 3]], column: usize) -> [f64; 2] {
        super::range(rows.iter().map(|row| row[column]))
    }

    #[test]
    fn the_extremes_of_every_column_in_every_bin_the_ends_and_the_order_stay() {
        let rows: Vec<[f64; 3]> = (0..100_000).map(wave).collect();
        let thinned = few(&rows, 100);
        assert!(thinned.len() <= 2 + 4 * 100);
        assert!(thinned.windows(2).all(|pair| pair[0][0] < pair[1][0]));
        assert_eq!(
            [thinned[0], thinned[thinned.len() - 1]],
            [rows[0], rows[99_999]]
        );
        for column in [1, 2] {
            for bin in rows.chunks(20_000) {
                let within =
                    |row: &&[f64; 3]| bin[0][0] <= row[0] && row[0] <= bin[bin.len() - 1][0];
                let here: Vec<[f64; 3]> = thinned.iter().filter(within).copied().collect();
                assert_eq!(extremes(&here, column), extremes(bin, column));
            }
        }
    }

    #[test]
    fn bins_are_equal_parts_of_the_axis_and_not_of_the_rows() {
        // Over a logarithmic axis half of the rows lie in the last of three decades.
        let rows: Vec<[f64; 3]> = (1..1000).map(wave).collect();
        let thinned = thin(&rows, 100, |row| row[0].ln(), |row| [row[1]]);
        let first: Vec<f64> = thinned.iter().map(|row| row[0]).take(8).collect();
        assert_eq!(first, [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0]);
        assert!(thinned.len() < 200);
    }

    #[test]
    fn a_gap_stays_a_gap_and_short_tables_stay_whole() {
        let mut rows: Vec<[f64; 3]> = (0..10_000).map(wave).collect();
        rows.iter_mut()
            .skip(4000)
            .take(2000)
            .for_each(|row| row[1] = f64::NAN);
        let thinned = few(&rows, 50);
        let undefined = thinned.iter().filter(|row| row[1].is_nan()).count();
        assert!((10..60).contains(&undefined), "{undefined}");
        assert_eq!(extremes(&thinned, 1), extremes(&rows, 1));
        assert_eq!(few(&rows[..10], 5).len(), 10);
        // Places that are all equal, or undefined, are one bin.
        let same = thin(&rows, 5, |_| 1.0, |row| [row[1]]);
        let none = thin(&rows, 5, |_| f64::NAN, |row| [row[1]]);
        assert_eq!([same.len(), none.len()], [5, 5]);
    }
}
