//! Measured surfaces: heights over an even grid, with the points that have none.

use asperity_core::quantity::Length;
use serde::Serialize;

use super::format::Format;
use super::metadata::Metadata;
use crate::warning::Warning;

/// A measured surface. Serialises without the heights.
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
    /// Name of the file as given.
    pub name: String,
    /// Format of the file.
    pub format: Format,
    /// Points of a row.
    pub columns: usize,
    /// Rows.
    pub rows: usize,
    /// Heights `[m]` out of the material, row by row; NaN where `mask` is false.
    #[serde(skip)]
    pub z: Vec<f64>,
    /// Whether a point has a height.
    #[serde(skip)]
    pub mask: Vec<bool>,
    /// Distance of the points of a row, where it is known.
    pub dx: Option<Length>,
    /// Distance of the rows, where it is known.
    pub dy: Option<Length>,
    /// Statements of the file beside the heights.
    pub metadata: Metadata,
    /// Warnings.
    pub warnings: Vec<Warning>,
}

impl Surface {
    /// The surface of heights `z` \[m\]; those that are not finite are none.
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

    /// Heights `[m]` of a row, counted from 0; none where there is no such row.
    pub fn row(&self, row: usize) -> Option<&[f64]> {
        let first = row.checked_mul(self.columns)?;
        self.z.get(first..first.checked_add(self.columns)?)
    }

    /// Heights `[m]` of a column, counted from 0; none where there is no such column.
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

    /// Points that have a height.
    pub fn measured(&self) -> usize {
        self.mask.iter().filter(|known| **known).count()
    }
}
