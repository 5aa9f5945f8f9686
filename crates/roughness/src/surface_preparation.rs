//! Preparation of a measured surface: form, noise and waviness removed in both directions.
//!
//! The recipe is the one of traces. Along the rows, the direction of rolling, a surface without change across is prepared as each of
//! its rows is ([`prepare`](crate::preparation::prepare)). Offsets between rows, which a trace loses with its mean line, remain: a
//! wave that is long along the rows and short across them is roughness.
//!
//! Source: ISO 16610-61, quoted from public programs; the standard was not available.

use asperity_core::cite;
use asperity_core::quantity::Length;
use asperity_core::{DomainError, Profile};
use serde::Serialize;

use crate::areal::HeightGrid;
use crate::error::{NOISE_CUTOFF, RoughnessError};
use crate::form::{self, Form};
use crate::gaussian_filter::{Ends, mean_line};
use crate::lay::bridged;
use crate::preparation::Preparation;
use crate::resampling::respaced;

/// Largest share of missing points that are bridged.
const MOST_MISSING: f64 = 0.25;
/// Least rows of a surface.
const LEAST_ROWS: usize = 4;

/// Heights of a prepared surface, row by row.
#[derive(Debug, Clone, PartialEq)]
pub struct PreparedSurface {
    /// Heights \[m\], row by row.
    pub heights: Vec<f64>,
    /// Points of a row.
    pub columns: usize,
    /// Distance of the points of a row, and of the rows.
    pub spacings: [Length; 2],
    /// Record of the preparation.
    pub record: SurfaceRecord,
}

/// Record of the preparation of a surface.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct SurfaceRecord {
    /// Recipe of the preparation.
    pub recipe: Preparation,
    /// Points of a row, and rows, before.
    pub points_before: [usize; 2],
    /// Points of a row, and rows, after.
    pub points_after: [usize; 2],
    /// Points dropped at each end of a row.
    pub dropped_each_end: usize,
    /// Share of the points that had no height and were bridged.
    pub bridged: f64,
    /// Whether the rows span the cut-off λ_c, so that it filters across them. Of a narrower surface only straight lines are removed
    /// across the rows.
    pub is_filtered_across: bool,
}

impl PreparedSurface {
    /// Number of rows.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.heights.len() / self.columns
    }

    /// The heights of row `k`.
    #[must_use]
    pub fn row(&self, k: usize) -> &[f64] {
        &self.heights[k * self.columns..(k + 1) * self.columns]
    }

    /// The surface with other distances of its points and rows, [`respaced`] in both directions.
    ///
    /// # Errors
    /// When a distance is not positive, or a row would have too many points.
    pub fn respaced(self, spacings: [Length; 2]) -> Result<Self, DomainError> {
        let given = SurfaceLines {
            heights: self.heights,
            length: self.columns,
        };
        let rows = given.respaced(self.spacings[0], spacings[0])?;
        let made = if self.spacings[1] == spacings[1] {
            rows
        } else {
            rows.turned()
                .respaced(self.spacings[1], spacings[1])?
                .turned()
        };
        Ok(Self {
            heights: made.heights,
            columns: made.length,
            spacings,
            record: self.record,
        })
    }
}

/// Prepares heights \[m\], row by row with NaN where there is none: removes the form and filters them in both directions with the
/// Gaussian filter.
///
/// ```text
/// P = S_x S_y (z − form; λ_s),  R = P − W_x W_y P,  W = w̄(·; λ_c)                  [Prep-4]
/// ```
///
/// The form is the polynomial of the recipe along the rows, with its degree in both directions together. λ_s does not filter across
/// rows that are farther apart. With [`Ends::Cut`] half a λ_c is dropped at both ends of the rows; across them lines are fitted up to
/// the edges, as surfaces are often narrow.
///
/// # Errors
/// When there are fewer than four rows, more than a quarter of the points are missing, or the recipe does not fit the rows.
///
/// ```
/// use asperity_core::quantity::Length;
/// use asperity_roughness::preparation::Preparation;
/// use asperity_roughness::surface_preparation::prepare_surface;
/// let [columns, rows] = [1200, 40];
/// let tilted = |k: usize| 1e-9 * (k % columns) as f64 - 3e-9 * (k / columns) as f64;
/// let z: Vec<f64> = (0..columns * rows).map(tilted).collect();
/// let plane = prepare_surface(&z, columns, [Length::from_si(1e-6); 2], &Preparation::default())?;
/// assert_eq!(plane.record.points_after, [950, 40]);
/// assert!(plane.heights.iter().all(|z| z.abs() < 1e-16));
/// # Ok::<(), asperity_roughness::RoughnessError>(())
/// ```
pub fn prepare_surface(
    z: &[f64],
    columns: usize,
    spacings: [Length; 2],
    recipe: &Preparation,
) -> Result<PreparedSurface, RoughnessError> {
    cite!("Prep-4");
    let [dx, dy] = spacings;
    DomainError::positive("distance of the rows", dy)?;
    let rows = z.len().checked_div(columns).unwrap_or(0);
    RoughnessError::at_least(rows, LEAST_ROWS, "a surface across its rows")?;
    let z = &z[..rows * columns];
    let missing = z.iter().filter(|z| !z.is_finite()).count() as f64 / z.len() as f64;
    let rule = "must not exceed a quarter; measure again, or take a range with heights";
    let fits = missing <= MOST_MISSING;
    DomainError::require(fits, "share of missing points", missing, "-", rule)?;
    let is_levelled = missing > 0.0 && !matches!(recipe.form, Form::None | Form::Mean);
    let mut grid = SurfaceLines {
        // Bridges at the ends of rows are level: the surface must be, too.
        heights: if is_levelled {
            filled(HeightGrid::level(z, columns, spacings)?.heights(), columns)
        } else {
            filled(z, columns)
        },
        length: columns,
    };
    remove_form(&mut grid, dx, recipe.form)?;
    if let Some(lambda_s) = recipe.lambda_s {
        let longest = recipe.lambda_c.map_or(f64::INFINITY, Length::si);
        let rule = "must be shorter than the cut-off lambda_c and not shorter than the spacing";
        let fits = lambda_s.si() < longest && lambda_s >= dx;
        DomainError::require(fits, NOISE_CUTOFF, lambda_s.si(), "m", rule)?;
        grid = grid.smoothed(dx, lambda_s, recipe.ends)?;
        if lambda_s > dy && (rows - 1) as f64 * dy.si() > lambda_s.si() {
            grid = grid.turned().smoothed(dy, lambda_s, Ends::Reg1)?.turned();
        }
    }
    let mut dropped = 0;
    let mut is_filtered_across = false;
    if let Some(lambda_c) = recipe.lambda_c {
        let width = (rows - 1) as f64 * dy.si();
        is_filtered_across = width >= lambda_c.si() && lambda_c >= dy;
        let wavy = grid.smoothed(dx, lambda_c, recipe.ends)?.turned();
        let wavy = if is_filtered_across {
            wavy.smoothed(dy, lambda_c, Ends::Reg1)?
        } else {
            wavy.each(straight)?
        };
        let wavy = wavy.turned();
        for (z, wave) in grid.heights.iter_mut().zip(&wavy.heights) {
            *z -= wave;
        }
        if recipe.ends == Ends::Cut {
            dropped = (0.5 * lambda_c.si() / dx.si()).round() as usize;
            grid = grid.cut(dropped, (lambda_c / dx).floor() as usize, dx, lambda_c)?;
        }
    }
    Ok(PreparedSurface {
        record: SurfaceRecord {
            recipe: *recipe,
            points_before: [columns, rows],
            points_after: [grid.length, rows],
            dropped_each_end: dropped,
            bridged: missing,
            is_filtered_across,
        },
        columns: grid.length,
        heights: grid.heights,
        spacings,
    })
}

/// Heights line by line.
struct SurfaceLines {
    heights: Vec<f64>,
    length: usize,
}

impl SurfaceLines {
    fn lines(&self) -> impl Iterator<Item = &[f64]> {
        self.heights.chunks_exact(self.length)
    }

    fn turned(&self) -> Self {
        let lines = self.heights.len() / self.length;
        let mut heights = Vec::with_capacity(self.heights.len());
        for at in 0..self.length {
            heights.extend((0..lines).map(|line| self.heights[line * self.length + at]));
        }
        Self {
            heights,
            length: lines,
        }
    }

    /// Every line replaced by `change` of it, to lines of equal length.
    fn each<E>(&self, change: impl Fn(&[f64]) -> Result<Vec<f64>, E>) -> Result<Self, E> {
        let mut heights = Vec::with_capacity(self.heights.len());
        let mut length = self.length;
        for line in self.lines() {
            let line = change(line)?;
            length = line.len();
            heights.extend(line);
        }
        Ok(Self { heights, length })
    }

    /// All lines with points at another distance.
    fn respaced(self, from: Length, to: Length) -> Result<Self, DomainError> {
        if from == to {
            return Ok(self);
        }
        self.each(|line| {
            let line = Profile::new(from, line.to_vec())?;
            Ok(respaced(&line, to)?.into_heights())
        })
    }

    /// Mean lines of all lines.
    fn smoothed(
        &self,
        spacing: Length,
        cutoff: Length,
        ends: Ends,
    ) -> Result<Self, RoughnessError> {
        self.each(|line| mean_line(&Profile::new(spacing, line.to_vec())?, cutoff, ends))
    }

    /// The lines without `dropped` points at each end, of which at least `least` must remain.
    fn cut(
        &self,
        dropped: usize,
        least: usize,
        spacing: Length,
        lambda_c: Length,
    ) -> Result<Self, RoughnessError> {
        let length = self.length.saturating_sub(2 * dropped);
        if length < least.max(1) {
            return Err(RoughnessError::TooShort {
                length: spacing * (self.length - 1) as f64,
                needed: lambda_c * 2.0,
                purpose: "one cut-off after dropping half a cut-off at both ends",
            });
        }
        let kept = self
            .lines()
            .flat_map(|line| &line[dropped..dropped + length]);
        Ok(Self {
            heights: kept.copied().collect(),
            length,
        })
    }
}

/// Missing heights bridged along the rows; a row without half of its heights is bridged between its neighbours.
fn filled(z: &[f64], columns: usize) -> Vec<f64> {
    let rows: Vec<Option<Vec<f64>>> = z.chunks_exact(columns).map(bridged).collect();
    let known: Vec<usize> = (0..rows.len()).filter(|k| rows[*k].is_some()).collect();
    let mut heights = Vec::with_capacity(z.len());
    for (k, row) in rows.iter().enumerate() {
        if let Some(row) = row {
            heights.extend(row);
            continue;
        }
        let after = known.partition_point(|known| *known < k);
        let [below, above] =
            [after.saturating_sub(1), after.min(known.len() - 1)].map(|at| known[at]);
        let part = if above > below {
            ((k as f64 - below as f64) / (above - below) as f64).clamp(0.0, 1.0)
        } else {
            0.0
        };
        let ends = [below, above].map(|at| rows[at].as_deref().unwrap_or_default());
        let between = ends[0].iter().zip(ends[1]);
        heights.extend(between.map(|(a, b)| a + part * (b - a)));
    }
    heights
}

/// The least-squares line through heights, at their places.
fn straight(line: &[f64]) -> Result<Vec<f64>, RoughnessError> {
    let fitted = form::fit(line, 1)?;
    Ok((0..line.len()).map(|i| fitted.at(i)).collect())
}

/// Removes the form: the products of orthogonal polynomials along and across the rows whose degrees add up to its degree at most; a
/// circle from the mean of the rows first.
fn remove_form(grid: &mut SurfaceLines, dx: Length, form: Form) -> Result<(), RoughnessError> {
    let degree = match form {
        Form::None => return Ok(()),
        Form::Mean => 0,
        Form::Level => 1,
        Form::Poly2 | Form::Circle => 2,
    };
    let rows = grid.heights.len() / grid.length;
    if form == Form::Circle {
        let mut mean = vec![0.0; grid.length];
        for row in grid.lines() {
            for (sum, z) in mean.iter_mut().zip(row) {
                *sum += z / rows as f64;
            }
        }
        let mean = Profile::new(dx, mean)?;
        let left = form::remove(&mean, form)?;
        let arc = mean.heights().iter().zip(left.heights());
        let arc: Vec<f64> = arc.map(|(z, left)| z - left).collect();
        for row in grid.heights.chunks_exact_mut(grid.length) {
            row.iter_mut().zip(&arc).for_each(|(z, arc)| *z -= arc);
        }
    }
    // Coefficients of the rows are fitted across the rows: the basis is orthogonal in both directions.
    let fitted = grid.lines().map(|row| form::fit(row, degree));
    let fitted = fitted.collect::<Result<Vec<_>, _>>()?;
    for power in 0..=degree {
        let across: Vec<f64> = fitted.iter().map(|row| row.coefficients[power]).collect();
        let across = form::fit(&across, degree - power)?;
        for (k, row) in grid.heights.chunks_exact_mut(grid.length).enumerate() {
            let alone = form::Polynomial::of_power(power, across.at(k), row.len());
            for (i, z) in row.iter_mut().enumerate() {
                *z -= alone.at(i);
            }
        }
    }
    Ok(())
}
