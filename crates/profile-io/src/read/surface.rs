//! Measured surfaces: heights on an even grid, with missing points.

use asperity_core::quantity::Length;
use serde::Serialize;

use super::format::Format;
use super::metadata::Metadata;
use crate::warning::Warning;

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
}

impl Surface {
    /// The surface of heights `z` \[m\]; values that are not finite are missing.
    pub(super) fn new(
        name: &str,
        format: Format,
        mut z: Vec<f64>,
        columns: usize,
        spacings: [Option<f64>; 2],
        metadata: Metadata,
        warnings: Vec<Warning>,
    ) -> Self {
        let mask: Vec<bool> = z.iter().map(|z| z.is_finite()).collect();
        z.iter_mut()
            .filter(|z| !z.is_finite())
            .for_each(|z| *z = f64::NAN);
        let [dx, dy] = spacings.map(|spacing| spacing.map(Length::from_si));
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
        }
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
