//! A surface of a file, and the extraction of its traces.

use asperity_core::numerics::range;
use asperity_core::quantity::Length;

use super::raw::Raw;
use crate::read::error::{ReadFault, SpacingHint};
use crate::read::format::Format;
use crate::read::found::{Found, overridden};
use crate::read::grid::{SpacingSource, chosen_row, enough_of_line};
use crate::read::layout::TableLayout;
use crate::read::lengths::Lengths;
use crate::read::metadata::Metadata;
use crate::read::options::{Axis, Encoding, LengthUnit, ReadOptions};
use crate::read::surface::{Surface, SurfaceFacts};
use crate::warning::Warning;

/// Heights of a surface, or of a profile with one row.
#[derive(Debug, Clone)]
pub(crate) enum ArealHeights {
    /// Bytes of the file, decoded on request.
    Raw(Raw),
    /// Row by row; NaN for missing heights.
    Values { values: Vec<f64>, columns: usize },
}

impl ArealHeights {
    fn size(&self) -> [usize; 2] {
        match self {
            Self::Raw(raw) => raw.size(),
            Self::Values { values, columns } => [*columns, values.len() / (*columns).max(1)],
        }
    }

    /// Heights in metres from numbers in `unit`.
    fn times(self, unit: LengthUnit) -> Self {
        let [columns, rows] = self.size();
        let at = |row| (0..columns).map(move |column| (column, row));
        let all = (0..rows).flat_map(at);
        let values = all.map(|(column, row)| unit.metres(self.height(column, row)));
        Self::Values {
            values: values.collect(),
            columns,
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

/// Content of a file of an areal format.
#[derive(Debug, Clone)]
pub(crate) struct Areal {
    pub format: Format,
    pub heights: Lengths<ArealHeights>,
    /// Spacings along rows and between rows, if stated.
    pub spacings: [Option<Lengths<f64>>; 2],
    pub metadata: Metadata,
    pub warnings: Vec<Warning>,
    /// Encoding of a text.
    pub encoding: Option<Encoding>,
    /// Layout of a text.
    pub table: Option<TableLayout>,
}

impl Areal {
    /// Heights scaled to metres by the file, without other facts.
    pub(crate) fn new(format: Format, heights: ArealHeights) -> Self {
        Self::from_heights(format, Lengths::Metres(heights))
    }

    /// Heights that the file scales by its `unit`, or numbers if it states none.
    pub(super) fn in_own_unit(
        format: Format,
        heights: ArealHeights,
        unit: Option<LengthUnit>,
    ) -> Self {
        match unit {
            Some(unit) => Self::new(format, heights.times(unit)),
            None => Self::from_heights(format, Lengths::Numbers(heights, None)),
        }
    }

    /// Heights without other facts.
    pub(crate) fn from_heights(format: Format, heights: Lengths<ArealHeights>) -> Self {
        Self {
            format,
            heights,
            spacings: [None; 2],
            metadata: Metadata::default(),
            warnings: Vec::new(),
            encoding: None,
            table: None,
        }
    }

    /// The surface with spacings \[m\] of the file; invalid spacings are omitted.
    pub(crate) fn spaced(self, dx: f64, dy: f64) -> Self {
        let real = |dx: f64| (dx.is_finite() && dx > 0.0).then_some(Lengths::Metres(dx));
        Self {
            spacings: [real(dx), real(dy)],
            ..self
        }
    }

    /// The trace requested by `options`.
    pub(crate) fn trace(mut self, options: &ReadOptions) -> Result<Found, ReadFault> {
        let surface = self.heights.values();
        let [columns, rows] = surface.size();
        let is_along_y = options.line.is_along_y();
        let (across, points) = if is_along_y {
            (columns, rows)
        } else {
            (rows, columns)
        };
        let at = |point: usize, line: usize| {
            if is_along_y {
                surface.height(line, point)
            } else {
                surface.height(point, line)
            }
        };
        let line = if options.line.is_mean() {
            0
        } else {
            chosen_row(options.row, across, points)?
        };
        enough_of_line(points, across, options.line)?;
        let heights: Vec<f64> = if options.line.is_mean() {
            let mean = |point| mean((0..across).map(|line| at(point, line)));
            (0..points).map(mean).collect()
        } else {
            (0..points).map(|point| at(point, line)).collect()
        };
        if options.line.is_mean() && across > 1 {
            self.warnings.push(Warning::MeanLine { lines: across });
        }
        let spacing = self.spacings[usize::from(is_along_y)];
        Ok(Found {
            spacing: spacing.map(|dx| (dx, SpacingSource::Header)),
            metadata: self.metadata,
            warnings: self.warnings,
            encoding: self.encoding,
            table: self.table,
            ..Found::new(self.format, self.heights.with(heights))
        })
    }

    /// The whole surface.
    pub(crate) fn surface(
        mut self,
        file: &str,
        options: &ReadOptions,
    ) -> Result<Surface, ReadFault> {
        let is_scaled = self.heights.are_metres();
        let warnings = &mut self.warnings;
        let no_unit = |heights: &ArealHeights, _: &mut Vec<Warning>| {
            Err(ReadFault::no_unit(Axis::Height, span(heights)))
        };
        let (heights, unit) =
            self.heights
                .in_unit(Axis::Height, options.z_unit, warnings, no_unit)?;
        let [columns, rows] = heights.size();
        let mut z = Vec::with_capacity(columns.saturating_mul(rows));
        for row in 0..rows {
            z.extend((0..columns).map(|column| unit.metres(heights.height(column, row))));
        }
        // A spacing without a unit is not known.
        let unknown = |_: &f64, _: &mut Vec<Warning>| Err(ReadFault::no_spacing(SpacingHint::None));
        let of_file = |step: Lengths<f64>, seen: &mut Vec<Warning>| {
            let found = step
                .in_unit(Axis::Trace, options.x_unit, seen, unknown)
                .ok();
            found.map(|(step, unit)| Length::from_si(unit.metres(step)))
        };
        let mut seen = Vec::new();
        let length = self.spacings[0].map(|step| step.values() * (columns.max(1) - 1) as f64);
        let found = self.spacings.map(|step| of_file(step?, &mut seen));
        let spacings = [options.dx, options.dy];
        for (stated, found) in spacings.into_iter().zip(found) {
            let both = stated.zip(found);
            warnings.extend(both.and_then(|(stated, found)| overridden(stated, found)));
        }
        seen.dedup();
        warnings.extend(seen);
        let spacings = [0, 1].map(|axis| spacings[axis].or(found[axis]));
        let surface = Surface::new(
            file,
            self.format,
            z,
            columns,
            spacings,
            self.metadata,
            self.warnings,
        );
        Ok(Surface {
            facts: SurfaceFacts {
                z_unit: Some(unit),
                is_scaled,
                encoding: self.encoding,
                table: self.table,
                spacing: found[0],
                length_without_unit: length.filter(|_| found[0].is_none()),
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
fn span(heights: &ArealHeights) -> f64 {
    let [columns, rows] = heights.size();
    let all = (0..rows).flat_map(|row| (0..columns).map(move |column| (column, row)));
    let all = all.map(|(column, row)| heights.height(column, row));
    let [low, high] = range(all.filter(|z| z.is_finite()));
    high - low
}
