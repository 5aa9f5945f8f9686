//! Measured surfaces: heights on an even grid, with missing points.

use std::ops::Range;

use asperity_core::quantity::Length;
use serde::Serialize;

use super::error::{ReadError, ReadFault};
use super::format::Format;
use super::found::Found;
use super::grid::{self, SpacingSource};
use super::layout::TableLayout;
use super::lengths::Lengths;
use super::metadata::Metadata;
use super::options::{Axis, Encoding, LengthUnit, ReadOptions, TraceLine, TraceRange};
use super::reading::Reading;
use crate::warning::Warning;

/// Facts about a file for the traces of its surface.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct SurfaceFacts {
    /// Unit of the heights in the file.
    pub z_unit: Option<LengthUnit>,
    /// Whether the header scaled the lengths.
    pub is_scaled: bool,
    pub encoding: Option<Encoding>,
    pub table: Option<TableLayout>,
    /// Distance of the points of a row in the file.
    pub spacing: Option<Length>,
    /// Length of a row in a unit that is not known.
    pub length_without_unit: Option<f64>,
}

/// A measured surface. The heights are not serialised.
///
/// ```
/// use asperity_profile_io::read::{ReadOptions, read_surface_bytes};
/// let row = |y: i32| (0..120).map(|x| format!("{}", x % 7 + y)).collect::<Vec<_>>().join(" ");
/// let text = format!("{}\n{}\n", row(0), row(1));
/// let options = ReadOptions { z_unit: Some("um".parse()?), ..ReadOptions::default() };
/// let surface = read_surface_bytes("matrix.txt", text.as_bytes(), &options)?;
/// assert_eq!((surface.columns, surface.rows), (120, 2));
/// assert_eq!(surface.row(1).unwrap()[..3], [1e-6, 2e-6, 3e-6]);
/// assert_eq!(surface.dx, None);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Surface {
    /// Name of the file.
    pub name: String,
    /// Format of the file.
    pub format: Format,
    /// Number of points of a row.
    pub columns: usize,
    /// Number of rows.
    pub rows: usize,
    /// Heights `[m]` out of the material, row by row; NaN where `mask` is false.
    #[serde(skip)]
    pub z: Vec<f64>,
    /// Whether a point has a height.
    #[serde(skip)]
    pub mask: Vec<bool>,
    /// Distance between the points of a row, if known.
    pub dx: Option<Length>,
    /// Distance between the rows, if known.
    pub dy: Option<Length>,
    /// Metadata of the file.
    pub metadata: Metadata,
    /// Warnings.
    pub warnings: Vec<Warning>,
    #[serde(skip)]
    pub(super) facts: SurfaceFacts,
}

impl Surface {
    /// The surface of heights `z` \[m\]; values that are not finite are missing.
    pub(super) fn new(
        name: &str,
        format: Format,
        mut z: Vec<f64>,
        columns: usize,
        [dx, dy]: [Option<Length>; 2],
        metadata: Metadata,
        warnings: Vec<Warning>,
    ) -> Self {
        let mask: Vec<bool> = z.iter().map(|z| z.is_finite()).collect();
        z.iter_mut()
            .filter(|z| !z.is_finite())
            .for_each(|z| *z = f64::NAN);
        Self {
            name: name.to_owned(),
            format,
            columns,
            rows: z.len() / columns.max(1),
            z,
            mask,
            dx,
            dy,
            metadata,
            warnings,
            facts: SurfaceFacts::default(),
        }
    }

    /// The row that `options` name, as [`read`](super::read) reads it. With [`Gaps::Interpolate`](super::Gaps) up to a quarter of
    /// its points in the range may lack a height, else none; bridges at the ends are level.
    ///
    /// # Errors
    /// When no row of several is named, the row does not exist, or it cannot be read as a profile.
    ///
    /// ```
    /// use asperity_profile_io::read::{ReadOptions, read_surface_bytes};
    /// let row = |y: i32| (0..120).map(|x| format!("{}", (x % 7 + y) % 5)).collect::<Vec<_>>().join(" ");
    /// let text = format!("{}\n{}\n", row(0), row(1));
    /// let options = ReadOptions { z_unit: Some("um".parse()?), dx: Some("1 um".parse()?), ..ReadOptions::default() };
    /// let surface = read_surface_bytes("matrix.txt", text.as_bytes(), &options)?;
    /// let second = surface.reading(&ReadOptions { row: Some(2), ..options.clone() })?;
    /// assert_eq!(second.profile.heights()[..3], [1e-6, 2e-6, 3e-6]);
    /// assert!(surface.reading(&options).is_err());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn reading(&self, options: &ReadOptions) -> Result<Reading, ReadError> {
        let row = grid::chosen_row(options.row, self.rows, self.columns).and_then(|row| {
            grid::enough_of_line(self.columns, self.rows, TraceLine::Row).map(|()| row)
        });
        let row = row.map_err(|fault| fault.in_file(&self.name))?;
        let known = self.row(row).unwrap_or_default();
        let row = grid::bridged(known, self.points_in(options.range), options);
        let (heights, bridged) = row.map_err(|fault| fault.in_file(&self.name))?;
        let facts = &self.facts;
        let source = match self.format {
            Format::PointText => SpacingSource::XColumn,
            _ => SpacingSource::Header,
        };
        if let (Some(length), None) = (facts.length_without_unit, options.dx) {
            return Err(ReadFault::no_unit(Axis::Trace, length).in_file(&self.name));
        }
        // A stated spacing has been compared with the file's.
        let spacing = facts.spacing.filter(|_| options.dx.is_none());
        let found = Found {
            spacing: spacing.map(|dx| (Lengths::Metres(dx.si()), source)),
            metadata: self.metadata.clone(),
            warnings: self.warnings.clone(),
            encoding: facts.encoding,
            table: facts.table,
            ..Found::new(self.format, Lengths::Metres(heights))
        };
        // The units of the file are applied.
        let of_row = ReadOptions {
            x_unit: None,
            z_unit: None,
            ..options.clone()
        };
        let trace = found.finish(&self.name, &of_row).and_then(|mut trace| {
            trace.z_unit = facts.z_unit.unwrap_or(trace.z_unit);
            trace.scaled = facts.is_scaled;
            trace.gaps_filled += bridged;
            match options.range {
                Some(range) => trace.within(range),
                None => Ok(trace),
            }
        });
        let trace = trace.map_err(|fault| fault.in_file(&self.name))?;
        trace.reading(options.uneven)
    }

    /// Points of each row in a range along the rows; all of them without one.
    #[must_use]
    pub fn points_in(&self, range: Option<TraceRange>) -> Range<usize> {
        let (Some(range), Some(dx)) = (range, self.dx) else {
            return 0..self.columns;
        };
        let at = |end: Length| (end / dx).clamp(0.0, self.columns as f64);
        // Rounding errors must not move an end that is at a point.
        const SLACK: f64 = 1e-6;
        let first = ((at(range.from) - SLACK).ceil() as usize).min(self.columns);
        let end = (at(range.to) + SLACK).floor() as usize + 1;
        first..end.clamp(first, self.columns)
    }

    /// Number of points with a height in each row, of those in `points`.
    pub fn measured_in(&self, points: Range<usize>) -> impl Iterator<Item = usize> {
        let rows = self.mask.chunks_exact(self.columns.max(1));
        rows.map(move |row| row[points.clone()].iter().filter(|known| **known).count())
    }

    /// Heights `[m]` of a row, counted from 0; `None` if the row does not exist.
    pub fn row(&self, row: usize) -> Option<&[f64]> {
        let first = row.checked_mul(self.columns)?;
        self.z.get(first..first.checked_add(self.columns)?)
    }

    /// Heights `[m]` of a column, counted from 0; `None` if the column does not exist.
    pub fn column(&self, column: usize) -> Option<Vec<f64>> {
        let inside = column < self.columns;
        inside.then(|| {
            self.z
                .iter()
                .skip(column)
                .step_by(self.columns)
                .copied()
                .collect()
        })
    }

    /// Heights `[m]` column by column.
    #[must_use]
    pub fn by_columns(&self) -> Vec<f64> {
        let columns = (0..self.columns).filter_map(|column| self.column(column));
        columns.flatten().collect()
    }

    /// Number of points with a height.
    pub fn measured(&self) -> usize {
        self.mask.iter().filter(|known| **known).count()
    }
}
