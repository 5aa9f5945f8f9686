//! Runs of neighbouring points, and passes over them with the widest vectors of the machine.
//!
//! A rough contact covers a small part of its grid in patches. Arrays that hold values of listed
//! points only hold them run after run, so that every pass goes over neighbours.

use std::ops::Range;

/// Neighbouring points from the first to before the end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Run {
    first: u32,
    end: u32,
}

impl Run {
    pub(crate) fn new(first: usize, end: usize) -> Self {
        Self {
            first: first as u32,
            end: end as u32,
        }
    }

    /// Adds a point behind all that `runs` holds.
    pub(crate) fn push(runs: &mut Vec<Self>, point: usize) {
        match runs.last_mut() {
            Some(last) if last.end as usize == point => last.end += 1,
            _ => runs.push(Self::new(point, point + 1)),
        }
    }

    pub(crate) fn range(self) -> Range<usize> {
        self.first as usize..self.end as usize
    }

    pub(crate) fn points(self) -> usize {
        (self.end - self.first) as usize
    }
}

/// Each run as places in arrays of all points, and in arrays of listed points only.
#[inline(always)]
pub(crate) fn parts(runs: &[Run]) -> impl Iterator<Item = (Range<usize>, Range<usize>)> + Clone {
    let mut listed = 0;
    runs.iter().map(move |run| {
        let begin = listed;
        listed += run.points();
        (run.range(), begin..listed)
    })
}

/// Number of points in all runs.
pub(crate) fn listed(runs: &[Run]) -> usize {
    runs.iter().map(|run| run.points()).sum()
}

/// Adds the points `first` + k for each bit k of `bits`, behind all that `runs` holds.
pub(crate) fn extend(runs: &mut Vec<Run>, first: usize, mut bits: u64) {
    let mut place = first as u32;
    while bits != 0 {
        let gap = bits.trailing_zeros();
        bits >>= gap;
        place += gap;
        let length = bits.trailing_ones();
        bits = bits.checked_shr(length).unwrap_or(0);
        match runs.last_mut() {
            Some(last) if last.end == place => last.end += length,
            _ => runs.push(Run {
                first: place,
                end: place + length,
            }),
        }
        place += length;
    }
}

/// Sums taken side by side, so that they fill a vector.
const LANES: usize = 8;

/// `K` sums (or least values) of what a pass makes of its points, in an order that does not depend
/// on the machine.
pub(crate) struct Lanes<const K: usize>([[f64; K]; LANES]);

impl<const K: usize> Lanes<K> {
    pub(crate) fn new(initial: [f64; K]) -> Self {
        Self([initial; LANES])
    }

    /// Takes in the values of `N` arrays of the same length, point by point.
    #[inline(always)]
    pub(crate) fn fold<const N: usize>(
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

    /// All lanes in one.
    pub(crate) fn reduce(self, join: impl Fn([f64; K], [f64; K]) -> [f64; K]) -> [f64; K] {
        let [first, others @ ..] = self.0;
        others.into_iter().fold(first, join)
    }

    /// All lanes in one, added up.
    pub(crate) fn total(self) -> [f64; K] {
        self.reduce(|a, b| std::array::from_fn(|k| a[k] + b[k]))
    }
}

/// Runs a pass compiled for the widest vectors that this machine has. Every machine gives the same
/// result: the order of the operations does not change.
#[inline(always)]
pub(crate) fn vectorised<R>(pass: impl FnOnce() -> R) -> R {
    pulp::Arch::new().dispatch(pass)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bits_become_runs_that_join_over_blocks() {
        let mut runs = vec![];
        extend(&mut runs, 0, 0b1011 | 1 << 63);
        extend(&mut runs, 64, u64::MAX);
        extend(&mut runs, 128, 0);
        extend(&mut runs, 192, 0b10);
        let expected = [(0, 2), (3, 4), (63, 128), (193, 194)].map(|(a, b)| Run::new(a, b));
        assert_eq!(runs, expected);
        assert_eq!(listed(&runs), 2 + 1 + 65 + 1);
        let places: Vec<_> = parts(&runs).map(|(_, listed)| listed).collect();
        assert_eq!(places, [0..2, 2..3, 3..68, 68..69]);
    }

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
