//! Sums over arrays in vector lanes.

/// Partial sums that are added in parallel: a vector of 512 bits.
const LANES: usize = 8;

/// `K` sums (or extreme values) over points, in an order that does not depend on the machine.
///
/// ```
/// use asperity_core::numerics::Lanes;
/// let mut lanes = Lanes::new([0.0, f64::NEG_INFINITY]);
/// lanes.fold([&[1.0, 2.0, 5.0], &[3.0, 2.0, 1.0]], |[sum, most], [x, y]| [sum + x * y, most.max(x)]);
/// assert_eq!(lanes.reduce(|a, b| [a[0] + b[0], a[1].max(b[1])]), [12.0, 5.0]);
/// ```
#[derive(Debug, Clone)]
pub struct Lanes<const K: usize>([[f64; K]; LANES]);

impl<const K: usize> Lanes<K> {
    /// Sums that begin with `initial` in every lane.
    #[must_use]
    pub fn new(initial: [f64; K]) -> Self {
        Self([initial; LANES])
    }

    /// Adds the points of `N` arrays of the same length by `step`.
    #[inline(always)]
    pub fn fold<const N: usize>(
        &mut self,
        arrays: [&[f64]; N],
        step: impl Fn([f64; K], [f64; N]) -> [f64; K],
    ) {
        let blocks = arrays.map(|array| array.as_chunks::<LANES>());
        let count = blocks
            .iter()
            .map(|(chunks, _)| chunks.len())
            .min()
            .unwrap_or(0);
        for block in 0..count {
            let values = blocks.map(|(chunks, _)| &chunks[block]);
            for (lane, sums) in self.0.iter_mut().enumerate() {
                *sums = step(*sums, values.map(|value| value[lane]));
            }
        }
        let rest = blocks.map(|(_, rest)| rest);
        let least = rest.iter().map(|values| values.len()).min().unwrap_or(0);
        for (lane, sums) in self.0.iter_mut().enumerate().take(least) {
            *sums = step(*sums, rest.map(|values| values[lane]));
        }
    }

    /// Combines the lanes by `join`.
    #[must_use]
    pub fn reduce(self, join: impl Fn([f64; K], [f64; K]) -> [f64; K]) -> [f64; K] {
        let [first, others @ ..] = self.0;
        others.into_iter().fold(first, join)
    }

    /// Adds the lanes.
    #[must_use]
    pub fn total(self) -> [f64; K] {
        self.reduce(|a, b| std::array::from_fn(|k| a[k] + b[k]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lanes_sum_every_point_once() {
        for points in [0, 1, 7, 8, 9, 40, 43] {
            let values: Vec<f64> = (0..points).map(f64::from).collect();
            let mut lanes = Lanes::new([0.0; 2]);
            lanes.fold([&values, &values], |[a, b], [x, y]| [a + x, b + x * y]);
            let n = f64::from(points);
            let squares = (n - 1.0) * n * (2.0 * n - 1.0) / 6.0;
            assert_eq!(lanes.total(), [n * (n - 1.0) / 2.0, squares]);
        }
    }
}
