//! Both flanks as measured surfaces that are repeated along the lead, from which patches are cut.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | n, o | rows of a surface, and rows that its ends overlap by | - |
//! | w | weight of the beginning of the surface | - |
//! | ρ | correlation of both ends | - |

use asperity_core::profile::mirrored_indices;
use asperity_core::quantity::Length;
use asperity_core::{DomainError, Profile, cite};
use asperity_roughness::resampling::respaced;
use asperity_roughness::surface_preparation::PreparedSurface;

use crate::window_pair::Window;

/// Most rows of a sheet: of a wider surface the middle. A patch of more costs in proportion, and its load scatters by less than a
/// hundredth.
const MOST_ROWS: usize = 256;
/// Part of its rows by which the ends of a surface overlap.
const OVERLAP: usize = 8;
/// Least rows that a sheet is made of.
const LEAST_ROWS: usize = 16;

/// Prepared surfaces of pinion and wheel with the same distances of points and rows, and the same number of rows.
#[derive(Debug, Clone, PartialEq)]
pub struct Sheets {
    heights: [Vec<f64>; 2],
    columns: [usize; 2],
    rows: usize,
    spacings: [Length; 2],
}

impl Sheets {
    /// Two surfaces with points `along` apart, and rows as near as the rows of the finer one, but not nearer than `along`.
    ///
    /// # Errors
    /// When a surface has fewer than 16 rows at this distance, or cannot be resampled.
    pub fn of(surfaces: [&PreparedSurface; 2], along: Length) -> Result<Self, DomainError> {
        let finer = surfaces
            .map(|surface| surface.spacings[1].si())
            .into_iter()
            .fold(f64::INFINITY, f64::min);
        let across = Length::from_si(finer.max(along.si()));
        let [first, second] = surfaces;
        let made = [
            Grid::of(first, [along, across])?,
            Grid::of(second, [along, across])?,
        ];
        let rows = made
            .iter()
            .map(Grid::rows)
            .fold(MOST_ROWS + MOST_ROWS / (OVERLAP - 1), usize::min);
        let rule = "must be at least 16 at the spacing of patches; scan a wider part of the flank";
        DomainError::require(
            rows >= LEAST_ROWS,
            "rows of the surface",
            rows as f64,
            "-",
            rule,
        )?;
        let repeated = made.each_ref().map(|grid| grid.repeated(rows));
        Ok(Self {
            rows: repeated[0].len() / made[0].columns,
            heights: repeated,
            columns: made.each_ref().map(|grid| grid.columns),
            spacings: [along, across],
        })
    }

    /// The surfaces with all heights multiplied by `factor`.
    #[must_use]
    pub fn times(&self, factor: f64) -> Self {
        let times = |heights: &Vec<f64>| heights.iter().map(|z| factor * z).collect();
        Self {
            heights: self.heights.each_ref().map(times),
            ..self.clone()
        }
    }

    /// Rows of both sheets.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Distance of the points of a row, and of the rows.
    #[must_use]
    pub fn spacings(&self) -> [Length; 2] {
        self.spacings
    }

    /// Heights \[m\] of pinion or wheel, row by row, and the points of a row.
    #[must_use]
    pub fn of_body(&self, body: usize) -> (&[f64], usize) {
        (&self.heights[body], self.columns[body])
    }

    /// The patch around the middles of a window of traces with points `spacing` apart, at least as long as the window; the wheel's
    /// rows begin at the part `place` of all rows.
    #[must_use]
    pub fn patch(&self, window: &Window, spacing: Length, place: f64) -> PatchPlace {
        let ratio = spacing / self.spacings[0];
        let half = (window.points / 2) as isize;
        let reach = (half as f64 * ratio).ceil() as isize;
        let start = |start: isize| ((start + half) as f64 * ratio).round() as isize - reach;
        PatchPlace {
            starts: window.starts.map(start),
            points: (2 * reach + 1) as usize,
            shift: (place * self.rows as f64) as usize % self.rows,
        }
    }

    /// Sums z₁ + z₂ \[m\] of both flanks in a patch, row by row; the flanks are mirrored beyond the ends of their rows.
    #[must_use]
    pub fn composite(&self, place: PatchPlace) -> Vec<f64> {
        let PatchPlace {
            starts,
            points,
            shift,
        } = place;
        let places = [0, 1].map(|body: usize| -> Vec<usize> {
            mirrored_indices(self.columns[body], starts[body], points).collect()
        });
        let mut sums = Vec::with_capacity(self.rows * points);
        for row in 0..self.rows {
            let [first, second] = [row, (row + shift) % self.rows];
            let first = &self.heights[0][first * self.columns[0]..][..self.columns[0]];
            let second = &self.heights[1][second * self.columns[1]..][..self.columns[1]];
            let both = places[0].iter().zip(&places[1]);
            sums.extend(both.map(|(i, j)| first[*i] + second[*j]));
        }
        sums
    }
}

/// Place of a patch on both sheets.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PatchPlace {
    /// First points of the patch in the rows of pinion and wheel; negative beyond the ends of the rows.
    pub starts: [isize; 2],
    /// Points of the patch in a row, an odd number.
    pub points: usize,
    /// Row of the wheel that meets the first row of the pinion.
    pub shift: usize,
}

/// Heights row by row.
struct Grid {
    heights: Vec<f64>,
    columns: usize,
}

impl Grid {
    /// A surface with other distances of its points and rows.
    fn of(surface: &PreparedSurface, [along, across]: [Length; 2]) -> Result<Self, DomainError> {
        let given = Self {
            heights: surface.heights.clone(),
            columns: surface.columns,
        };
        let given = given.respaced(surface.spacings[0], along)?;
        let turned = given.turned().respaced(surface.spacings[1], across)?;
        Ok(turned.turned())
    }

    fn rows(&self) -> usize {
        self.heights.len() / self.columns
    }

    fn respaced(self, from: Length, to: Length) -> Result<Self, DomainError> {
        if from == to {
            return Ok(self);
        }
        let mut heights = Vec::new();
        let mut columns = 0;
        for row in self.heights.chunks_exact(self.columns) {
            let row = respaced(&Profile::new(from, row.to_vec())?, to)?;
            columns = row.len();
            heights.extend(row.heights());
        }
        Ok(Self { heights, columns })
    }

    fn turned(&self) -> Self {
        let rows = self.rows();
        let mut heights = Vec::with_capacity(self.heights.len());
        for column in 0..self.columns {
            heights.extend((0..rows).map(|row| self.heights[row * self.columns + column]));
        }
        Self {
            heights,
            columns: rows,
        }
    }

    /// The middle `n` rows, without those by which both ends overlap, so that the last row is followed by the first.
    ///
    /// ```text
    /// z = (w z_begin + (1 − w) z_end)/√(w² + (1 − w)² + 2 w (1 − w) ρ),  w = (j + 1)/(o + 1)           [Sheet]
    /// ```
    ///
    /// The root keeps the variance of ends that are unrelated (ρ = 0), and ridges that run on from one end to the other (ρ = 1).
    fn repeated(&self, n: usize) -> Vec<f64> {
        cite!("Sheet");
        let first = (self.rows() - n) / 2;
        let part = &self.heights[first * self.columns..(first + n) * self.columns];
        let overlap = n / OVERLAP;
        let mut kept = part[..(n - overlap) * self.columns].to_vec();
        let (begin, end) = (
            &part[..overlap * self.columns],
            &part[(n - overlap) * self.columns..],
        );
        let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let both = (product(begin, begin) * product(end, end)).sqrt();
        let correlation = match both > 0.0 {
            true => (product(begin, end) / both).clamp(0.0, 1.0),
            false => 1.0,
        };
        for j in 0..overlap {
            let w = (j + 1) as f64 / (overlap + 1) as f64;
            let rest = 1.0 - w;
            let scale = (w * w + rest * rest + 2.0 * w * rest * correlation).sqrt();
            let row = j * self.columns..(j + 1) * self.columns;
            let ends = begin[row.clone()].iter().zip(&end[row.clone()]);
            for (z, (begin, end)) in kept[row].iter_mut().zip(ends) {
                *z = (w * begin + rest * end) / scale;
            }
        }
        kept
    }
}
