//! Fewer rows for display: in each group the lowest and the highest of every column stay.

use std::collections::BTreeSet;

/// At most `most` of `rows`, in their order: the ends of every group and where one of `columns` is lowest
/// or highest in it.
pub fn thin<R: Copy>(rows: &[R], columns: &[fn(&R) -> f64], most: usize) -> Vec<R> {
    let of_a_group = 2 + 2 * columns.len();
    let groups = (most / of_a_group).max(1);
    if rows.len() <= groups * of_a_group {
        return rows.to_vec();
    }
    let mut kept = BTreeSet::new();
    for group in 0..groups {
        let range = group * rows.len() / groups..(group + 1) * rows.len() / groups;
        kept.extend([range.start, range.end - 1]);
        for value in columns {
            // A value that is not there is neither lowest nor highest.
            let known = || range.clone().filter(|k| value(&rows[*k]).is_finite());
            let compare = |a: &usize, b: &usize| value(&rows[*a]).total_cmp(&value(&rows[*b]));
            kept.extend(known().min_by(compare));
            kept.extend(known().max_by(compare));
        }
    }
    kept.into_iter().map(|k| rows[k]).collect()
}

#[cfg(test)]
mod tests {
    use super::thin;

    #[test]
    fn extremes_ends_and_order_survive() {
        let wave = |i: u32| {
            [
                f64::from(i),
                (f64::from(i) * 0.37).sin() * f64::from(i % 911),
            ]
        };
        let rows: Vec<[f64; 2]> = (0..100_000).map(wave).collect();
        let few = thin(&rows, &[|row| row[1]], 400);
        assert!(few.len() <= 400 && few.windows(2).all(|pair| pair[0][0] < pair[1][0]));
        let largest = |rows: &[[f64; 2]]| rows.iter().map(|row| row[1]).fold(f64::MIN, f64::max);
        assert_eq!(largest(&few), largest(&rows));
        assert_eq!(
            (few[0], few[few.len() - 1]),
            (rows[0], rows[rows.len() - 1])
        );
        assert_eq!(thin(&rows[..10], &[|row| row[1]], 400).len(), 10);
    }
}
