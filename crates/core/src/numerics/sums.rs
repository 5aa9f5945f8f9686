//! Sums and extremes of long slices, in parts that the processor works at once.

/// Independent running sums and extremes: an addition takes four cycles, but four can run at once.
const LANES: usize = 8;

/// Lowest and highest value; (∞, −∞) for none.
///
/// ```
/// use asperity_core::numerics::extremes;
/// assert_eq!(extremes(&[2.0, -1.0, 0.5]), (-1.0, 2.0));
/// ```
pub fn extremes(z: &[f64]) -> (f64, f64) {
    let (groups, rest) = z.as_chunks::<LANES>();
    let mut lanes = [(f64::INFINITY, f64::NEG_INFINITY); LANES];
    // Plain comparisons, which the processor has as one instruction.
    let widened = |(low, high): (f64, f64), z: f64| {
        (
            if z < low { z } else { low },
            if z > high { z } else { high },
        )
    };
    for group in groups {
        for (lane, z) in lanes.iter_mut().zip(group) {
            *lane = widened(*lane, *z);
        }
    }
    let all = lanes
        .into_iter()
        .reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)));
    let all = all.unwrap_or((f64::INFINITY, f64::NEG_INFINITY));
    rest.iter().fold(all, |all, z| widened(all, *z))
}

/// Lowest and highest of `values`, of which those that are not numbers do not count; \[∞, −∞\] for none.
///
/// ```
/// use asperity_core::numerics::range;
/// assert_eq!(range([2.0, f64::NAN, -1.0]), [-1.0, 2.0]);
/// ```
pub fn range(values: impl IntoIterator<Item = f64>) -> [f64; 2] {
    let none = [f64::INFINITY, f64::NEG_INFINITY];
    let wider = |[low, high]: [f64; 2], value| [low.min(value), high.max(value)];
    values.into_iter().fold(none, wider)
}

/// Adds `factor` times `values` to `sums`.
///
/// ```
/// let mut sums = [1.0, 2.0];
/// asperity_core::numerics::add_times(&mut sums, 2.0, &[3.0, 0.5]);
/// assert_eq!(sums, [7.0, 3.0]);
/// ```
pub fn add_times(sums: &mut [f64], factor: f64, values: &[f64]) {
    for (sum, value) in sums.iter_mut().zip(values) {
        *sum += factor * value;
    }
}

/// Σ f(z) in eight running parts, which do not wait for each other.
///
/// ```
/// use asperity_core::numerics::sum;
/// assert_eq!(sum(&[3.0, -4.0], |z| z * z), 25.0);
/// ```
pub fn sum(z: &[f64], f: impl Fn(f64) -> f64) -> f64 {
    let (groups, rest) = z.as_chunks::<LANES>();
    let mut parts = [0.0; LANES];
    for group in groups {
        for (part, z) in parts.iter_mut().zip(group) {
            *part += f(*z);
        }
    }
    parts.iter().sum::<f64>() + rest.iter().map(|z| f(*z)).sum::<f64>()
}

/// Places of the first lowest, the last highest and the first undefined of `values`, as far as there are any.
///
/// ```
/// use asperity_core::numerics::extreme_places;
/// assert_eq!(extreme_places(&[2.0, 1.0, f64::NAN, 3.0, 1.0, 3.0]), [1, 5, 2]);
/// assert_eq!(extreme_places(&[f64::NAN; 2]), [0]);
/// assert!(extreme_places(&[]).is_empty());
/// ```
#[must_use]
pub fn extreme_places(values: &[f64]) -> Vec<usize> {
    let (mut lowest, mut highest, mut undefined) = (None, None, None);
    let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
    for (k, &value) in values.iter().enumerate() {
        if !value.is_finite() {
            undefined.get_or_insert(k);
            continue;
        }
        if value < least || lowest.is_none() {
            (least, lowest) = (value, Some(k));
        }
        if value >= most {
            (most, highest) = (value, Some(k));
        }
    }
    lowest.into_iter().chain(highest).chain(undefined).collect()
}

/// Σ a b of two slices of one length in eight running parts.
///
/// ```
/// use asperity_core::numerics::dot;
/// assert_eq!(dot(&[1.0, 2.0], &[3.0, -1.0]), 1.0);
/// ```
#[inline(always)]
pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    let (a_parts, b_parts) = (a.chunks_exact(LANES), b.chunks_exact(LANES));
    let rest = a_parts.remainder().iter().zip(b_parts.remainder());
    let mut sums = [0.0; LANES];
    for (a, b) in a_parts.clone().zip(b_parts.clone()) {
        for (lane, sum) in sums.iter_mut().enumerate() {
            *sum += a[lane] * b[lane];
        }
    }
    sums.iter().sum::<f64>() + rest.map(|(a, b)| a * b).sum::<f64>()
}
