//! Mean, median, standard deviation and order of a few values.

/// Mean of equally weighted values.
pub fn mean(values: impl IntoIterator<Item = f64>) -> f64 {
    let (sum, count) = values
        .into_iter()
        .fold((0.0, 0.0), |(sum, count), value| (sum + value, count + 1.0));
    sum / count
}

/// Median, of an even number of values the mean of the two in the middle; `None` without values.
pub fn median(values: impl IntoIterator<Item = f64>) -> Option<f64> {
    median_in_place(&mut values.into_iter().collect::<Vec<_>>())
}

/// [`median`], which changes the order of the values.
pub fn median_in_place(values: &mut [f64]) -> Option<f64> {
    let middle = values.len() / 2;
    if values.is_empty() {
        return None;
    }
    let is_even = values.len().is_multiple_of(2);
    let (lower, &mut upper, _) = values.select_nth_unstable_by(middle, f64::total_cmp);
    let below = lower.iter().copied().max_by(f64::total_cmp);
    Some(
        below
            .filter(|_| is_even)
            .map_or(upper, |below| 0.5 * (below + upper)),
    )
}

/// Sample standard deviation; none for fewer than two values.
pub fn deviation(values: &[f64]) -> Option<f64> {
    let n = values.len();
    if n < 2 {
        return None;
    }
    let middle = mean(values.iter().copied());
    let squares: f64 = values.iter().map(|value| (value - middle).powi(2)).sum();
    Some((squares / (n - 1) as f64).sqrt())
}

/// Pearson's correlation of lists of equal length; `None` if one of them is constant.
///
/// ```
/// use asperity_core::numerics::correlation;
/// assert_eq!(correlation(&[1.0, 2.0, 3.0], &[-2.0, -4.0, -6.0]), Some(-1.0));
/// assert_eq!(correlation(&[1.0, 2.0], &[3.0, 3.0]), None);
/// ```
pub fn correlation(a: &[f64], b: &[f64]) -> Option<f64> {
    let [of_a, of_b] = [a, b].map(|values| mean(values.iter().copied()));
    let sum = |x: &[f64], y: &[f64], (of_x, of_y): (f64, f64)| -> f64 {
        x.iter().zip(y).map(|(x, y)| (x - of_x) * (y - of_y)).sum()
    };
    let squares = sum(a, a, (of_a, of_a)) * sum(b, b, (of_b, of_b));
    (squares > 0.0).then(|| (sum(a, b, (of_a, of_b)) / squares.sqrt()).clamp(-1.0, 1.0))
}

/// The values in ascending order, without repetitions.
///
/// ```
/// use asperity_core::numerics::distinct;
/// assert_eq!(distinct([2.0, -1.0, 2.0]), [-1.0, 2.0]);
/// ```
pub fn distinct(values: impl IntoIterator<Item = f64>) -> Vec<f64> {
    let mut values: Vec<f64> = values.into_iter().collect();
    values.sort_by(f64::total_cmp);
    values.dedup();
    values
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn medians_and_deviations_of_few_values() {
        assert_eq!(median([]), None);
        assert_eq!(median([4.0, 1.0, 8.0]), Some(4.0));
        assert_eq!(median([8.0, 1.0, 4.0, 2.0]), Some(3.0));
        assert_eq!(deviation(&[1.0]), None);
        assert_eq!(deviation(&[1.0, 4.0, 7.0]), Some(3.0));
    }
}
