//! Cascadic multigrid (Bornemann and Deuflhard 1996): grids of half as many cells each, transfer
//! between them, and the window of a grid that is in contact.
//!
//! The solution on a grid of half as many cells is in contact at nearly the same places as on the finer
//! one. With free ends only these and a margin are solved; the rest of the grid is certified afterwards.

/// Fewest cells of a coarser grid. A grid of this size is cheap to solve from a uniform pressure, so
/// another coarser one would save nothing.
const MIN_CELLS: usize = 128;
/// Margin on either side of a window, relative to the width of the contact: room for points that
/// come into contact only on the finer grid.
const MARGIN: f64 = 0.1;
/// Least margin in cells, for a contact of few cells.
const MIN_MARGIN_CELLS: usize = 16;
/// Largest window relative to the grid. A larger one costs more for its certificate on the whole grid
/// than it saves.
const MAX_WINDOW_SHARE: f64 = 0.75;

/// Cells of the grids from `points` down to about 128, each half of the one before, rounded up.
pub(crate) fn grids(points: usize) -> Vec<usize> {
    let coarser = |&n: &usize| Some(n.div_ceil(2)).filter(|&half| half >= MIN_CELLS);
    std::iter::successors(Some(points), coarser).collect()
}

/// Restricts a gap to half as many cells: means of pairs; an odd last value stays.
pub(crate) fn restrict(fine: &[f64]) -> Vec<f64> {
    fine.chunks(2)
        .map(|pair| pair.iter().sum::<f64>() / pair.len() as f64)
        .collect()
}

/// Most patches of a smooth contact. Such a contact converges in few iterations, so that a more accurate
/// start pays.
const MAX_SMOOTH_PATCHES: usize = 4;

/// Whether the points `touches` form few patches: the finer grid then starts with linear pressure within
/// each coarse cell ([`prolong_slopes`]).
pub(crate) fn is_smooth(touches: &[usize]) -> bool {
    let ends = touches.windows(2).filter(|pair| pair[1] > pair[0] + 1);
    ends.count() < MAX_SMOOTH_PATCHES
}

/// Interpolates a pressure to `points` half cells with the slope between the neighbours of each cell.
/// A cell at an edge of a patch has no slope: its neighbour outside says nothing about the pressure inside.
pub(crate) fn prolong_slopes(coarse: &[f64], points: usize) -> Vec<f64> {
    let at = |i: usize| coarse.get(i).copied().unwrap_or(0.0);
    let halves = |(i, &p): (usize, &f64)| {
        let (before, after) = (at(i.wrapping_sub(1)), at(i + 1));
        let inside = before > 0.0 && p > 0.0 && after > 0.0;
        // A quarter of the slope per coarse cell, and never below zero.
        let step = ((after - before) / 8.0).clamp(-p, p);
        if inside { [p - step, p + step] } else { [p, p] }
    };
    coarse
        .iter()
        .enumerate()
        .flat_map(halves)
        .take(points)
        .collect()
}

/// Interpolates a pressure to `points` half cells, constant over each coarse cell.
pub(crate) fn prolong(coarse: &[f64], points: usize) -> Vec<f64> {
    coarse.iter().flat_map(|&p| [p, p]).take(points).collect()
}

/// Lengths of windows, times a power of two: five per octave. All have fast transforms, and they are few
/// enough to cache the plans of all.
const LENGTHS: [usize; 5] = [8, 9, 10, 12, 15];

/// Smallest length of a window of at least `least` cells.
fn window_length(least: usize) -> usize {
    let lengths = LENGTHS.map(|length| length * least.div_ceil(length).next_power_of_two());
    lengths.into_iter().fold(usize::MAX, usize::min)
}

/// Range of cells that is solved.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Window {
    pub(crate) first: usize,
    pub(crate) points: usize,
}

impl Window {
    /// Window of all `points` cells.
    pub(crate) fn whole(points: usize) -> Self {
        Self { first: 0, points }
    }

    /// Window from the first to the last cell of `touches`, with a margin and enlarged to a length of
    /// [`LENGTHS`]; the whole grid if that is most of it or nothing is in contact.
    pub(crate) fn around(points: usize, touches: &[usize]) -> Self {
        let (Some(&first), Some(&last)) = (touches.first(), touches.last()) else {
            return Self::whole(points);
        };
        let width = last - first + 1;
        let margin = ((MARGIN * width as f64).ceil() as usize).max(MIN_MARGIN_CELLS);
        let wide = window_length(width + 2 * margin);
        if wide as f64 > MAX_WINDOW_SHARE * points as f64 {
            return Self::whole(points);
        }
        let centred = (first + last + 1).saturating_sub(wide) / 2;
        Self {
            first: centred.min(points - wide),
            points: wide,
        }
    }

    pub(crate) fn range(&self) -> std::ops::Range<usize> {
        self.first..self.first + self.points
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_window_holds_the_contact_and_its_margin_within_the_grid() {
        for (points, low, high) in [
            (10_000, 4_000, 5_000),
            (10_000, 0, 10),
            (10_000, 9_990, 9_999),
        ] {
            let window = Window::around(points, &[low, high]);
            assert!(window.range().end <= points && window.points < points / 5);
            assert!(window.first <= low.saturating_sub(MIN_MARGIN_CELLS));
            assert!(window.range().end >= (high + 1 + MIN_MARGIN_CELLS).min(points));
        }
        assert_eq!(Window::around(100, &[0, 89]), Window::whole(100));
        assert_eq!(Window::around(100, &[]), Window::whole(100));
    }

    #[test]
    fn grids_halve_down_to_about_the_coarsest() {
        assert_eq!(grids(2_000), [2_000, 1_000, 500, 250]);
        assert_eq!(grids(257), [257, 129]);
        assert_eq!(grids(7), [7]);
        assert_eq!(prolong(&restrict(&[1.0, 3.0, 5.0]), 3), [2.0, 2.0, 5.0]);
    }

    #[test]
    fn slopes_are_carried_to_the_finer_grid_within_a_patch() {
        let fine = prolong_slopes(&[0.0, 8.0, 16.0, 8.0, 0.0, 4.0], 11);
        let expected = [0.0, 0.0, 8.0, 8.0, 16.0, 16.0, 8.0, 8.0, 0.0, 0.0, 4.0];
        assert_eq!(fine, expected);
        let slope = prolong_slopes(&[1.0, 9.0, 17.0], 6);
        assert_eq!(slope, [1.0, 1.0, 7.0, 11.0, 17.0, 17.0]);
        assert!(is_smooth(&[3, 4, 5, 9, 10]) && is_smooth(&[]));
        assert!(!is_smooth(&[1, 3, 5, 7, 9]));
    }
}
