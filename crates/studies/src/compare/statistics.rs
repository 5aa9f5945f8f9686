//! Spearman's rank correlation.

/// Spearman's ρ of pairs: the correlation of their ranks, with mean ranks for ties; NaN if either value is constant.
///
/// ```
/// use asperity_studies::compare::rank_correlation;
/// assert_eq!(rank_correlation(&[[1.0, 10.0], [2.0, 11.0], [3.0, 90.0]]), 1.0);
/// ```
pub fn rank_correlation(pairs: &[[f64; 2]]) -> f64 {
    let ranks = [0, 1].map(|side| ranks(&pairs.iter().map(|pair| pair[side]).collect::<Vec<_>>()));
    let middle = 0.5 * (pairs.len() as f64 + 1.0);
    let sum = |a: &[f64], b: &[f64]| -> f64 {
        a.iter()
            .zip(b)
            .map(|(a, b)| (a - middle) * (b - middle))
            .sum()
    };
    let [x, y] = &ranks;
    sum(x, y) / (sum(x, x) * sum(y, y)).sqrt()
}

fn ranks(values: &[f64]) -> Vec<f64> {
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|a, b| values[*a].total_cmp(&values[*b]));
    let mut ranks = vec![0.0; values.len()];
    let mut start = 0;
    while start < order.len() {
        let same = |k: &usize| values[order[*k]] == values[order[start]];
        let end = (start..order.len()).take_while(same).count() + start;
        let mean = 0.5 * ((start + 1) + end) as f64;
        for &index in &order[start..end] {
            ranks[index] = mean;
        }
        start = end;
    }
    ranks
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ties_share_their_rank() {
        assert_eq!(ranks(&[3.0, 1.0, 3.0, 2.0]), [3.5, 1.0, 3.5, 2.0]);
        assert!(rank_correlation(&[[1.0, 5.0], [2.0, 5.0]]).is_nan());
        assert_eq!(
            rank_correlation(&[[1.0, 3.0], [2.0, 2.0], [3.0, 1.0]]),
            -1.0
        );
    }
}
