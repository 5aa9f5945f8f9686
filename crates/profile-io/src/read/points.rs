//! Points x, y, z as text: a single line of points, or the lines of a grid, along either coordinate first.

use super::areal::trace::{Areal, ArealHeights};
use super::dialect::Sniffed;
use super::error::ReadFault;
use super::format::Format;
use super::grid::{self, chosen_row};
use super::header::{Label, Role};
use super::lengths::Lengths;
use super::options::{LengthUnit, ReadOptions};
use super::rows::{self, Rows};
use super::table::Chosen;
use super::text::{Line, TextSource};

/// Largest difference of a coordinate from its value in the first line, in steps, due to rounding.
const SAME: f64 = 0.25;

/// The columns of x, y and z of a table, counted from 0: as labelled, or of three columns in this order.
pub(super) fn columns(labels: &[Label], options: &ReadOptions) -> Option<[usize; 3]> {
    if labels.len() < 3 || options.columns.is_some() {
        return None;
    }
    let with = |role| labels.iter().position(|label| label.role == Some(role));
    if labels.iter().all(|label| label.role.is_none()) {
        return (labels.len() == 3).then_some([0, 1, 2]);
    }
    Some([with(Role::X)?, with(Role::Y)?, with(Role::Z)?])
}

/// Points on lines with the same number of points.
pub(super) struct Points {
    /// Coordinates of the points of a line.
    along: Vec<f64>,
    /// Coordinates of the lines.
    across: Vec<f64>,
    /// Heights, line by line.
    heights: Vec<f64>,
    /// Whether the lines run along x.
    along_x: bool,
    /// Whether points of the grid are left out of the file.
    has_holes: bool,
}

/// A trace of points, with the number of rows of the table above its first point.
pub(super) struct PointTrace {
    pub rows: Rows,
    pub before: usize,
    /// Whether its points are successive rows of the table.
    pub is_listed: bool,
}

/// The points of a table; `None` if they are on no grid.
pub(super) fn read(
    text: &mut TextSource<'_>,
    first: usize,
    head: &[Line<'_>],
    sniffed: &Sniffed,
    [x, y, z]: [usize; 3],
) -> Result<Option<Points>, ReadFault> {
    let chosen = |x, z| Chosen {
        x: Some(x),
        z,
        valid: None,
        count: sniffed.columns,
    };
    let with_z = rows::read(text, first, head, sniffed, chosen(x, z))?;
    let with_y = rows::read(text, first, head, sniffed, chosen(x, y))?;
    let (Some(x), y, z) = (with_z.x, with_y.z, with_z.z) else {
        return Ok(None);
    };
    if x.len() != y.len() || y.iter().any(|y| y.is_nan()) {
        return Ok(None);
    }
    let complete = Points::from_coordinates(&x, &y, &z, true)
        .or_else(|| Points::from_coordinates(&y, &x, &z, false));
    if complete.is_some() {
        return Ok(complete);
    }
    match Points::with_holes(&x, &y, &z) {
        Ok(points) => Ok(points),
        Err(row) => Err(ReadFault::repeated_point(
            rows::place(text, first, row)?.0,
            x[row],
            y[row],
        )),
    }
}

/// Nodes of a coordinate: `count` of them, `step` apart.
struct Nodes {
    first: f64,
    step: f64,
    count: usize,
}

impl Nodes {
    /// The even nodes that `values` are on, each up to rounding; `None` if there are none.
    fn from_values(values: &[f64]) -> Option<Self> {
        let mut sorted = values.to_vec();
        sorted.sort_by(f64::total_cmp);
        sorted.dedup();
        let (first, last) = (*sorted.first()?, *sorted.last()?);
        // Single nodes may have no point at all, most have.
        let mut steps: Vec<f64> = sorted.windows(2).map(|pair| pair[1] - pair[0]).collect();
        steps.sort_by(f64::total_cmp);
        let intervals = ((last - first) / steps.get(steps.len() / 2)?).round();
        let nodes = Self {
            first,
            step: (last - first) / intervals,
            count: intervals as usize + 1,
        };
        let is_near = |x: &f64| (x - nodes.at(nodes.nearest(*x))).abs() <= SAME * nodes.step;
        sorted.iter().all(is_near).then_some(nodes)
    }

    fn nearest(&self, x: f64) -> usize {
        ((x - self.first) / self.step).round() as usize
    }

    fn at(&self, node: usize) -> f64 {
        self.first + self.step * node as f64
    }
}

impl Points {
    /// The grid in which `along` changes from point to point, and `across` from line to line.
    fn from_coordinates(along: &[f64], across: &[f64], z: &[f64], along_x: bool) -> Option<Self> {
        let first = *across.first()?;
        let line = across.iter().take_while(|y| **y == first).count();
        if line < 2 || !along.len().is_multiple_of(line) {
            return None;
        }
        let points = &along[..line];
        let step = (points[line - 1] - points[0]) / (line - 1) as f64;
        let is_line = |(along, across): (&[f64], &[f64])| {
            let same = |(a, b): (&f64, &f64)| (a - b).abs() <= SAME * step.abs();
            along.iter().zip(points).all(same) && across.iter().all(|y| *y == across[0])
        };
        let lines = || along.chunks(line).zip(across.chunks(line));
        let across: Vec<f64> = across.iter().step_by(line).copied().collect();
        // A line that goes back begins another scan.
        let mut steps = across.windows(2).map(|pair| pair[1] - pair[0]);
        let is_rising = across.first() < across.last();
        let goes_on = steps.all(|step| step != 0.0 && (step > 0.0) == is_rising);
        (step != 0.0 && goes_on && lines().all(is_line)).then(|| Self {
            along: points.to_vec(),
            across,
            heights: z.to_vec(),
            along_x,
            has_holes: false,
        })
    }

    /// The grid of points of which some are left out, by rounding of their coordinates: fewer than half of its nodes may lack
    /// a point. A second point on a node is returned as an error.
    fn with_holes(x: &[f64], y: &[f64], z: &[f64]) -> Result<Option<Self>, usize> {
        let Some((columns, rows)) = Nodes::from_values(x).zip(Nodes::from_values(y)) else {
            return Ok(None);
        };
        let count = columns.count.saturating_mul(rows.count);
        if rows.count < 2 || columns.count < 2 || count > 2 * x.len() {
            return Ok(None);
        }
        let mut heights = vec![f64::NAN; count];
        let mut is_taken = vec![false; count];
        for (row, ((x, y), z)) in x.iter().zip(y).zip(z).enumerate() {
            let node = rows.nearest(*y) * columns.count + columns.nearest(*x);
            if std::mem::replace(&mut is_taken[node], true) {
                return Err(row);
            }
            heights[node] = *z;
        }
        let along = |nodes: &Nodes| (0..nodes.count).map(|node| nodes.at(node)).collect();
        Ok(Some(Self {
            along: along(&columns),
            across: along(&rows),
            heights,
            along_x: true,
            has_holes: true,
        }))
    }

    /// Whether the coordinates are numbers of pixels: whole, and both in steps of one.
    pub(super) fn are_pixels(&self) -> bool {
        let counts = |values: &[f64]| {
            values.iter().all(|value| value.fract() == 0.0)
                && values
                    .windows(2)
                    .all(|pair| (pair[1] - pair[0]).abs() == 1.0)
        };
        self.lines() > 1 && counts(&self.along) && counts(&self.across)
    }

    /// Number of lines.
    pub(super) fn lines(&self) -> usize {
        self.across.len()
    }

    /// Whether the trace requested by `options` runs along y.
    pub(super) fn runs_along_y(&self, options: &ReadOptions) -> bool {
        match self.lines() {
            1 => !self.along_x,
            _ => options.line.is_along_y(),
        }
    }

    /// Height of point `i` of line `line`.
    fn height(&self, i: usize, line: usize) -> f64 {
        self.heights[line * self.along.len() + i]
    }

    /// The trace requested by `options`: rows run along x.
    pub(super) fn trace(&self, options: &ReadOptions) -> Result<PointTrace, ReadFault> {
        let as_stored = self.runs_along_y(options) != self.along_x;
        let (x, count) = if as_stored {
            (&self.along, self.lines())
        } else {
            (&self.across, self.along.len())
        };
        let at = |i: usize, line: usize| {
            if as_stored {
                self.height(i, line)
            } else {
                self.height(line, i)
            }
        };
        let (z, before): (Vec<f64>, usize) = if options.line.is_mean() {
            let there = |i| {
                (0..count)
                    .map(move |line| at(i, line))
                    .filter(|z| !z.is_nan())
            };
            let mean = |i| there(i).sum::<f64>() / there(i).count() as f64;
            ((0..x.len()).map(mean).collect(), 0)
        } else {
            let line = chosen_row(options.row, count, x.len())?;
            let before = if as_stored { line * x.len() } else { 0 };
            ((0..x.len()).map(|i| at(i, line)).collect(), before)
        };
        Ok(PointTrace {
            rows: Rows {
                x: Some(x.clone()),
                z,
                empty: 0,
            },
            before,
            is_listed: as_stored && !self.has_holes && !options.line.is_mean(),
        })
    }

    /// The surface, with the units that the file states.
    pub(super) fn surface(
        &self,
        x_unit: Option<LengthUnit>,
        y_unit: Option<LengthUnit>,
        z_unit: Option<LengthUnit>,
    ) -> Areal {
        let (x, y) = if self.along_x {
            (&self.along, &self.across)
        } else {
            (&self.across, &self.along)
        };
        let height = |row: usize, column: usize| {
            if self.along_x {
                self.height(column, row)
            } else {
                self.height(row, column)
            }
        };
        let columns = x.len();
        let values = (0..y.len()).flat_map(|row| (0..columns).map(move |column| (row, column)));
        let mut values: Vec<f64> = values.map(|(row, column)| height(row, column)).collect();
        grid::unmark(&mut values);
        let step = |x: &[f64], unit| {
            let step = (x[x.len() - 1] - x[0]).abs() / (x.len().max(2) - 1) as f64;
            (step > 0.0).then_some(Lengths::Numbers(step, unit))
        };
        let heights = Lengths::Numbers(ArealHeights::Values { values, columns }, z_unit);
        Areal {
            spacings: [step(x, x_unit), step(y, y_unit)],
            ..Areal::from_heights(Format::PointText, heights)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::options::TraceLine;
    use super::*;

    #[test]
    fn points_with_holes_are_on_a_grid_by_rounding_and_the_others_are_missing() {
        let nodes = (0..4).flat_map(|row| (0..6).map(move |column| (column, row)));
        let there = nodes.filter(|node| ![(0, 0), (3, 2), (5, 2), (5, 3)].contains(node));
        // Steps of 1/3, printed with two decimals, and of 2.
        let printed = |x: f64| (100.0 * x).round() / 100.0;
        let points: Vec<[f64; 3]> = there
            .map(|(c, r)| {
                [
                    printed(f64::from(c) / 3.0),
                    f64::from(2 * r),
                    f64::from(10 * r + c),
                ]
            })
            .collect();
        let [x, y, z] = [0, 1, 2].map(|k| points.iter().map(|p| p[k]).collect::<Vec<_>>());
        let found = Points::with_holes(&x, &y, &z).unwrap().unwrap();
        assert_eq!((found.along.len(), found.lines()), (6, 4));
        assert_eq!((found.height(2, 2), found.height(4, 3)), (22.0, 34.0));
        for (column, row) in [(0, 0), (3, 2), (5, 2), (5, 3)] {
            assert!(found.height(column, row).is_nan());
        }
        // The mean of a column is over the points that are there.
        let mean = ReadOptions {
            line: TraceLine::Mean,
            ..ReadOptions::default()
        };
        let trace = found.trace(&mean).unwrap().rows;
        assert_eq!(
            trace.z,
            [20.0, 16.0, 17.0, (3.0 + 13.0 + 33.0) / 3.0, 19.0, 10.0]
        );
        // Twice a point, or scattered points: no grid.
        let twice = |values: &[f64]| [values, &values[..1]].concat();
        let second = Points::with_holes(&twice(&x), &twice(&y), &twice(&z));
        assert_eq!(second.err(), Some(x.len()));
        let scattered: Vec<f64> = x.iter().map(|x| x + 0.1 * (7.0 * x).sin()).collect();
        assert!(matches!(Points::with_holes(&scattered, &y, &z), Ok(None)));
    }

    #[test]
    fn lines_along_either_coordinate_are_found_and_others_are_none() {
        let x = [0.0, 1.0, 2.01, 0.0, 1.0, 2.0];
        let y = [5.0, 5.0, 5.0, 7.0, 7.0, 7.0];
        let z = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0];
        let rows = Points::from_coordinates(&x, &y, &z, true).unwrap();
        assert_eq!((rows.lines(), rows.along_x), (2, true));
        assert!(Points::from_coordinates(&y, &x, &z, false).is_none());
        let second = ReadOptions {
            row: Some(2),
            ..ReadOptions::default()
        };
        let trace = rows.trace(&second).unwrap();
        assert_eq!((trace.rows.z, trace.before), (vec![4.0, 5.0, 6.0], 3));
        let column = ReadOptions {
            line: TraceLine::Column,
            ..second
        };
        assert_eq!(rows.trace(&column).unwrap().rows.z, [2.0, 5.0]);
        assert!(rows.trace(&ReadOptions::default()).is_err());
        let scattered = [5.0, 5.0, 5.0, 7.0, 7.0, 8.0];
        assert!(Points::from_coordinates(&x, &scattered, &z, true).is_none());
    }
}
