//! A surface of a file, and the extraction of its traces.

use asperity_core::numerics::range;

use super::raw::Raw;
use crate::read::error::ReadFault;
use crate::read::format::Format;
use crate::read::found::{Found, unit_overridden};
use crate::read::grid::{SpacingSource, chosen_row};
use crate::read::layout::TableLayout;
use crate::read::metadata::Metadata;
use crate::read::options::{Axis, Encoding, LengthUnit, ReadOptions, TraceLine};
use crate::read::surface::{Surface, SurfaceFacts};
use crate::read::units;
use crate::warning::Warning;

/// Heights of a surface, or of a profile with one row.
#[derive(Debug, Clone)]
pub(crate) enum Heights {
    /// Bytes of the file, decoded on request.
    Raw(Raw),
    /// Row by row; NaN for missing heights.
    Values { values: Vec<f64>, columns: usize },
}

impl Heights {
    fn size(&self) -> [usize; 2] {
        match self {
            Self::Raw(raw) => raw.size(),
            Self::Values { values, columns } => [*columns, values.len() / (*columns).max(1)],
        }
    }

    fn height(&self, column: usize, row: usize) -> f64 {
        match self {
            Self::Raw(raw) => raw.height(column, row),
            Self::Values { values, columns } => {
                let height = values.get(row * columns + column);
                height.copied().unwrap_or(f64::NAN)
            }
        }
    }
}

/// Unit of the heights in a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum HeightUnit {
    /// Not stated.
    Unstated,
    /// The numbers are in metres.
    Metres,
    /// The numbers were converted to metres by scales of the header.
    Scaled,
}

/// Content of a file of an areal format.
#[derive(Debug, Clone)]
pub(crate) struct Areal {
    pub format: Format,
    pub heights: Heights,
    /// Spacings along rows and between rows \[m\], if stated.
    pub spacings: [Option<f64>; 2],
    pub unit: HeightUnit,
    pub metadata: Metadata,
    pub warnings: Vec<Warning>,
    /// Encoding of a text.
    pub encoding: Option<Encoding>,
    /// Layout of a text, and the unit of its heights.
    pub table: Option<(TableLayout, Option<LengthUnit>)>,
}

impl Areal {
    /// Heights scaled to metres by the header, without other facts.
    pub(crate) fn new(format: Format, heights: Heights) -> Self {
        Self {
            format,
            heights,
            spacings: [None; 2],
            unit: HeightUnit::Scaled,
            metadata: Metadata::default(),
            warnings: Vec::new(),
            encoding: None,
            table: None,
        }
    }

    /// The surface with spacings \[m\]; invalid spacings are omitted.
    pub(crate) fn spaced(self, dx: f64, dy: f64) -> Self {
        let real = |dx: f64| (dx.is_finite() && dx > 0.0).then_some(dx);
        Self {
            spacings: [real(dx), real(dy)],
            ..self
        }
    }

    /// The trace requested by `options`.
    pub(crate) fn trace(mut self, options: &ReadOptions) -> Result<Found, ReadFault> {
        let [columns, rows] = self.heights.size();
        let (across, points) = match options.line {
            TraceLine::Row | TraceLine::Mean => (rows, columns),
            TraceLine::Column | TraceLine::MeanColumn => (columns, rows),
        };
        let at = |point: usize, line: usize| match options.line {
            TraceLine::Row | TraceLine::Mean => self.heights.height(point, line),
            TraceLine::Column | TraceLine::MeanColumn => self.heights.height(line, point),
        };
        let heights: Vec<f64> = match options.line {
            TraceLine::Mean | TraceLine::MeanColumn => {
                let mean = |point| mean((0..across).map(|line| at(point, line)));
                (0..points).map(mean).collect()
            }
            TraceLine::Row | TraceLine::Column => {
                let line = chosen_row(options.row, across, points)?;
                (0..points).map(|point| at(point, line)).collect()
            }
        };
        if options.line.is_mean() && across > 1 {
            self.warnings.push(Warning::MeanLine { lines: across });
        }
        let axis = usize::from(matches!(
            options.line,
            TraceLine::Column | TraceLine::MeanColumn
        ));
        let spacing = self.spacings[axis].map(|dx| (dx, SpacingSource::Header));
        let z_unit = match self.unit {
            HeightUnit::Metres | HeightUnit::Scaled => LengthUnit::Metre,
            HeightUnit::Unstated => units::of_heights(self.format, &heights, options)?,
        };
        Ok(Found {
            spacing,
            z_unit,
            scaled: self.unit == HeightUnit::Scaled,
            metadata: self.metadata,
            warnings: self.warnings,
            ..Found::new(self.format, heights)
        })
    }

    /// The whole surface.
    pub(crate) fn surface(
        mut self,
        file: &str,
        options: &ReadOptions,
    ) -> Result<Surface, ReadFault> {
        let [columns, rows] = self.heights.size();
        let axis = Axis::Height;
        let unit = match (self.unit, options.z_unit) {
            (HeightUnit::Metres | HeightUnit::Scaled, None) => LengthUnit::Metre,
            (HeightUnit::Scaled, Some(stated)) => {
                self.warnings.push(Warning::UnitNotUsed { axis, stated });
                LengthUnit::Metre
            }
            (HeightUnit::Metres, Some(stated)) => {
                let overridden = unit_overridden(axis, stated, LengthUnit::Metre);
                self.warnings.extend(overridden);
                stated
            }
            (HeightUnit::Unstated, Some(stated)) => stated,
            (HeightUnit::Unstated, None) => {
                return Err(ReadFault::no_unit(axis, span(&self.heights)));
            }
        };
        let mut z = Vec::with_capacity(columns.saturating_mul(rows));
        for row in 0..rows {
            z.extend((0..columns).map(|column| unit.metres(self.heights.height(column, row))));
        }
        let spacings = match options.dx {
            Some(dx) => [Some(dx.si()), self.spacings[1]],
            None => self.spacings,
        };
        let surface = Surface::new(
            file,
            self.format,
            z,
            columns,
            spacings,
            self.metadata,
            self.warnings,
        );
        let (table, of_table) = self.table.unzip();
        Ok(Surface {
            facts: SurfaceFacts {
                z_unit: Some(options.z_unit.or(of_table.flatten()).unwrap_or(unit)),
                is_scaled: self.unit == HeightUnit::Scaled,
                encoding: self.encoding,
                table,
                spacing: self.spacings[0],
            },
            ..surface
        })
    }
}

/// Mean of the known heights; NaN without known heights.
fn mean(heights: impl Iterator<Item = f64>) -> f64 {
    let known = heights.filter(|z| z.is_finite());
    let (sum, count) = known.fold((0.0, 0_u64), |(sum, count), z| (sum + z, count + 1));
    sum / count as f64
}

/// Difference of the highest and lowest height, in the unit of the file.
fn span(heights: &Heights) -> f64 {
    let [columns, rows] = heights.size();
    let all = (0..rows).flat_map(|row| (0..columns).map(move |column| (column, row)));
    let all = all.map(|(column, row)| heights.height(column, row));
    let [low, high] = range(all.filter(|z| z.is_finite()));
    high - low
}
