//! Cascadic multigrid (Bornemann and Deuflhard 1996): grids of half as many cells each, transfer
//! between them, and the window of a grid that is in contact.
//!
//! The solution on a grid of half as many cells is in contact at nearly the same places as on the finer
//! one. With free ends only these and a margin are solved; the rest of the grid is certified afterwards.

use std::borrow::Cow;

use crate::cells::Cells;

/// Fewest cells of a coarser grid. A grid of this size is cheap to solve from a uniform pressure, so
/// another coarser one would save nothing.
const MIN_CELLS: usize = 128;
/// Fewest columns of a coarser grid of a patch.
const MIN_COLUMNS: usize = 16;
/// Margin on either side of a window, relative to the width of the contact: room for points that
/// come into contact only on the finer grid.
const MARGIN: f64 = 0.1;
/// Least margin in cells, for a contact of few cells.
const MIN_MARGIN_CELLS: usize = 16;
/// Largest window relative to the grid. A larger one costs more for its certificate on the whole grid
/// than it saves.
const MAX_WINDOW_SHARE: f64 = 0.75;

/// Grids from the finest down to about 128 cells, each with half of the cells of the one before in each direction, rounded
/// up.
pub(crate) fn grids(finest: Cells) -> Vec<Cells> {
    let coarser = |fine: &Cells| {
        let [columns, rows] = [fine.columns, fine.rows].map(|n| n.div_ceil(2));
        // The period along the lead stays, also where an odd number is rounded up.
        let aspect = fine.aspect * fine.rows as f64 / (2 * rows) as f64;
        let half = Cells {
            columns,
            rows,
            aspect,
        };
        Some(half).filter(|half| half.points() >= MIN_CELLS && columns >= MIN_COLUMNS)
    };
    std::iter::successors(Some(finest), coarser).collect()
}

/// Restricts a gap to half as many cells in each direction: means of pairs; an odd last value stays.
pub(crate) fn restrict(fine: &[f64], columns: usize) -> Vec<f64> {
    let halved = |row: &[f64]| -> Vec<f64> {
        row.chunks(2)
            .map(|pair| pair.iter().sum::<f64>() / pair.len() as f64)
            .collect()
    };
    let pairs = fine.chunks(2 * columns).map(|pair| {
        let mut rows = pair.chunks_exact(columns).map(halved);
        let first = rows.next().unwrap_or_default();
        match rows.next() {
            Some(second) => first
                .iter()
                .zip(second)
                .map(|(a, b)| 0.5 * (a + b))
                .collect(),
            None => first,
        }
    });
    pairs.collect::<Vec<_>>().concat()
}

/// Most patches of a smooth contact. Such a contact converges in few iterations, so that a more accurate
/// start pays.
const MAX_SMOOTH_PATCHES: usize = 4;

/// Whether the points `touches` form few patches a row: the finer grid then starts with linear pressure within
/// each coarse cell ([`prolong_slopes`]).
pub(crate) fn is_smooth(touches: &[usize], rows: usize) -> bool {
    let ends = touches.windows(2).filter(|pair| pair[1] > pair[0] + 1);
    ends.count() < MAX_SMOOTH_PATCHES * rows
}

/// Interpolates a pressure to a finer grid row by row, by `along`; the rows of a pair are the same.
pub(crate) fn prolong_rows(
    coarse: (&[f64], Cells),
    fine: Cells,
    along: fn(&[f64], usize) -> Vec<f64>,
) -> Vec<f64> {
    let (pressure, cells) = coarse;
    let rows = pressure.chunks_exact(cells.columns);
    let pairs = rows.flat_map(|row| {
        let finer = along(row, fine.columns);
        // A line has no second row.
        [finer.clone(), finer]
    });
    pairs.take(fine.rows).collect::<Vec<_>>().concat()
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

    /// Window from the first to the last column of the `touches` in contact, with a margin and enlarged to a length of
    /// [`LENGTHS`]; the whole grid if that is most of it or nothing is in contact.
    pub(crate) fn around(cells: Cells, touches: &[usize]) -> Self {
        let points = cells.columns;
        let ends = match cells.rows {
            1 => touches.first().zip(touches.last()).map(|(a, b)| [*a, *b]),
            _ => {
                let columns = touches.iter().map(|place| [place % points; 2]);
                columns.reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])])
            }
        };
        let Some([first, last]) = ends else {
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

    /// The window as a grid of its own.
    pub(crate) fn of(&self, grid: Cells) -> Cells {
        Cells {
            columns: self.points,
            ..grid
        }
    }

    /// The columns of the window from rows of `columns` values.
    pub(crate) fn cut<'a>(&self, values: &'a [f64], columns: usize) -> Cow<'a, [f64]> {
        if columns == self.points {
            return Cow::Borrowed(values);
        }
        if columns == values.len() {
            return Cow::Borrowed(&values[self.range()]);
        }
        let rows = values.chunks_exact(columns);
        Cow::Owned(rows.flat_map(|row| &row[self.range()]).copied().collect())
    }

    /// Writes the columns of the window to rows of `columns` values; the others become zero.
    pub(crate) fn paste(&self, from: &[f64], values: &mut [f64], columns: usize) {
        values.fill(0.0);
        let rows = values.chunks_exact_mut(columns);
        for (row, from) in rows.zip(from.chunks_exact(self.points)) {
            row[self.range()].copy_from_slice(from);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(columns: usize) -> Cells {
        Cells {
            columns,
            rows: 1,
            aspect: 0.0,
        }
    }

    #[test]
    fn a_window_holds_the_contact_and_its_margin_within_the_grid() {
        for (points, low, high) in [
            (10_000, 4_000, 5_000),
            (10_000, 0, 10),
            (10_000, 9_990, 9_999),
        ] {
            let window = Window::around(line(points), &[low, high]);
            assert!(window.range().end <= points && window.points < points / 5);
            assert!(window.first <= low.saturating_sub(MIN_MARGIN_CELLS));
            assert!(window.range().end >= (high + 1 + MIN_MARGIN_CELLS).min(points));
        }
        assert_eq!(Window::around(line(100), &[0, 89]), Window::whole(100));
        assert_eq!(Window::around(line(100), &[]), Window::whole(100));
    }

    #[test]
    fn grids_halve_down_to_about_the_coarsest() {
        let columns = |points| -> Vec<usize> {
            grids(line(points))
                .iter()
                .map(|grid| grid.columns)
                .collect()
        };
        assert_eq!(columns(2_000), [2_000, 1_000, 500, 250]);
        assert_eq!(columns(257), [257, 129]);
        assert_eq!(columns(7), [7]);
        assert_eq!(prolong(&restrict(&[1.0, 3.0, 5.0], 3), 3), [2.0, 2.0, 5.0]);
        let patch = Cells {
            columns: 64,
            rows: 21,
            aspect: 2.0,
        };
        let coarse = *grids(patch).last().unwrap();
        assert_eq!(coarse.shape(), [32, 11]);
        // The period along the lead over the length of a row stays.
        assert!((coarse.aspect * 11.0 / 32.0 - 2.0 * 21.0 / 64.0).abs() < 1e-12);
        let halved = restrict(&[1.0, 3.0, 5.0, 5.0, 7.0, 9.0, 2.0, 4.0, 6.0], 3);
        assert_eq!(halved, [4.0, 7.0, 3.0, 6.0]);
        let [coarse, fine] = [(2, 2), (3, 3)].map(|(columns, rows)| Cells {
            columns,
            rows,
            aspect: 1.0,
        });
        let finer = prolong_rows((&halved, coarse), fine, prolong);
        assert_eq!(finer, [4.0, 4.0, 7.0, 4.0, 4.0, 7.0, 3.0, 3.0, 6.0]);
    }

    #[test]
    fn slopes_are_carried_to_the_finer_grid_within_a_patch() {
        let fine = prolong_slopes(&[0.0, 8.0, 16.0, 8.0, 0.0, 4.0], 11);
        let expected = [0.0, 0.0, 8.0, 8.0, 16.0, 16.0, 8.0, 8.0, 0.0, 0.0, 4.0];
        assert_eq!(fine, expected);
        let slope = prolong_slopes(&[1.0, 9.0, 17.0], 6);
        assert_eq!(slope, [1.0, 1.0, 7.0, 11.0, 17.0, 17.0]);
        assert!(is_smooth(&[3, 4, 5, 9, 10], 1) && is_smooth(&[], 1));
        assert!(!is_smooth(&[1, 3, 5, 7, 9], 1));
    }
}
