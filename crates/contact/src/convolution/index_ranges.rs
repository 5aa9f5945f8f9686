//! Ranges of neighbouring grid points.
//!
//! A rough contact covers a small part of its grid in patches. Arrays of listed points hold the values
//! run after run, so that loops over them access contiguous memory.

use std::ops::Range;

/// Range of neighbouring grid points, from `first` to before `end`.
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

    /// Appends a point that lies behind all runs.
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

/// Index ranges of each run in arrays of all points and in arrays of listed points.
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

/// Appends the points `first` + k for each bit k of `bits`, which lie behind all runs.
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
}
