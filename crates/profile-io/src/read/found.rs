//! The common end of all instrument readers: overrides, gaps, checks, and the [`Trace`].

use asperity_core::quantity::Length;

use super::error::{ReadFault, SpacingHint};
use super::format::Format;
use super::grid::{self, SpacingSource};
use super::header::FilterState;
use super::layout::TableLayout;
use super::metadata::Metadata;
use super::options::{Axis, Encoding, LengthUnit, ReadOptions};
use super::trace::{Positions, Trace, own};
use crate::warning::Warning;

/// Content of a file, as returned by the reader of an instrument format.
pub(super) struct Found {
    pub format: Format,
    /// Heights in `z_unit`; NaN for a missing height.
    pub heights: Vec<f64>,
    pub z_unit: LengthUnit,
    /// Individual positions in `x_unit`; they override `spacing`.
    pub x: Option<Vec<f64>>,
    /// Spacing in `x_unit` with its origin.
    pub spacing: Option<(f64, SpacingSource)>,
    pub x_unit: LengthUnit,
    /// Whether the lengths were scaled by factors of the header, so that a stated unit does not apply.
    pub scaled: bool,
    pub filter_state: FilterState,
    pub metadata: Metadata,
    pub warnings: Vec<Warning>,
    pub encoding: Option<Encoding>,
    pub table: Option<TableLayout>,
    /// Line of the first height in the file, if each height has its line.
    pub first_line: Option<usize>,
}

impl Found {
    /// Heights and spacing in metres without other facts.
    pub(super) fn new(format: Format, heights: Vec<f64>) -> Self {
        Self {
            format,
            heights,
            z_unit: LengthUnit::Metre,
            x: None,
            spacing: None,
            x_unit: LengthUnit::Metre,
            scaled: false,
            filter_state: FilterState::Unknown,
            metadata: Metadata::default(),
            warnings: Vec::new(),
            encoding: None,
            table: None,
            first_line: None,
        }
    }

    /// The trace; statements of the user override statements of the file.
    pub(super) fn finish(self, file: &str, options: &ReadOptions) -> Result<Trace, ReadFault> {
        grid::enough(self.heights.len())?;
        let mut warnings = self.warnings;
        let (stated, mut heights) = (options.dx, self.heights);
        if !self.scaled {
            grid::unmark(&mut heights);
        }
        let first_line = self.first_line;
        let count = heights.len();
        let mut x = self.x.filter(|_| stated.is_none());
        let column = match &mut x {
            Some(x) => Some(grid::spacing(x, &mut |row| {
                Ok((first_line.unwrap_or(1) + row, String::new()))
            })?),
            None => None,
        };
        let falls = column.as_ref().is_some_and(|column| column.falls);
        if falls {
            heights.reverse();
            warnings.push(Warning::Reversed);
        }
        let found = match &column {
            Some(column) => Some((column.mean, SpacingSource::XColumn)),
            None => self.spacing,
        };
        let mut unit = |axis, stated: Option<LengthUnit>, found| match stated {
            Some(stated) if self.scaled => {
                warnings.push(Warning::UnitNotUsed { axis, stated });
                found
            }
            Some(stated) => {
                warnings.extend(unit_overridden(axis, stated, found));
                stated
            }
            None => found,
        };
        let z_unit = unit(Axis::Height, options.z_unit, self.z_unit);
        let x_unit = match (stated, found) {
            (None, Some(_)) => unit(Axis::Trace, options.x_unit, self.x_unit),
            _ => options.x_unit.unwrap_or(self.x_unit),
        };
        let (spacing, spacing_source) = match (stated, found) {
            (Some(dx), column) => {
                let column = column.map(|(dx, _)| Length::from_si(x_unit.metres(dx)));
                warnings.extend(column.and_then(|column| overridden(dx, column)));
                (dx, SpacingSource::Stated)
            }
            (None, Some((dx, source))) => (Length::from_si(x_unit.metres(dx)), source),
            (None, None) => {
                return Err(ReadFault::no_spacing(SpacingHint::None));
            }
        };
        check_spacing(spacing)?;
        let unevenness = column.and_then(|column| column.unevenness);
        let mut left_out = 0;
        if let (Some(x), Some(_)) = (&mut x, unevenness) {
            left_out = grid::leave_out(x, &mut heights, options.gaps, &mut warnings)?;
        }
        let first = |row: usize| {
            let row = if falls { count - 1 - row } else { row };
            Ok(match first_line {
                Some(line) => (Some(line + row), "reads \"missing\"".to_owned()),
                None => (None, grid::node(row, options)),
            })
        };
        let (heights, filled) = grid::heights(heights, options.gaps, first, &mut warnings)?;
        let positions = match (x, unevenness) {
            (Some(x), Some(unevenness)) => own(metres(x, x_unit)?, unevenness),
            _ => Positions::Even { spacing },
        };
        if self.filter_state == FilterState::Roughness {
            warnings.push(Warning::AlreadyFiltered);
        }
        Ok(Trace {
            name: file.to_owned(),
            positions,
            heights: metres(heights, z_unit)?,
            format: self.format,
            encoding: self.encoding,
            table: self.table,
            x_unit: stated.is_none().then_some(x_unit),
            z_unit,
            spacing_source,
            filter_state: self.filter_state,
            gaps_filled: filled + left_out,
            cut: None,
            metadata: self.metadata,
            warnings,
            scaled: self.scaled,
            roll: None,
        })
    }
}

/// Turns values that grow into the material: as stated, or those that the file names depths. The stated sign holds for a
/// replica, too.
pub(super) fn turn(values: &mut [f64], warnings: &mut Vec<Warning>, stated: Option<bool>) {
    if stated.is_some() {
        warnings.retain(|w| !matches!(w, Warning::Replica | Warning::DepthsTurned));
    }
    if stated.unwrap_or_else(|| warnings.contains(&Warning::DepthsTurned)) {
        values.iter_mut().for_each(|value| *value = -*value);
    }
}

/// Warning that a stated unit differs from the unit of the file.
pub(super) fn unit_overridden(
    axis: Axis,
    stated: LengthUnit,
    found: LengthUnit,
) -> Option<Warning> {
    (stated != found).then_some(Warning::UnitOverridden {
        axis,
        stated,
        found,
    })
}

/// Warning that a stated spacing differs from the spacing of the file.
pub(super) fn overridden(stated: Length, column: Length) -> Option<Warning> {
    const DIFFERS: f64 = 0.01;
    let differs = (column / stated - 1.0).abs() > DIFFERS;
    differs.then_some(Warning::SpacingOverridden { stated, column })
}

/// Returns an error for impossible spacings, which indicate a wrong unit.
fn check_spacing(spacing: Length) -> Result<(), ReadFault> {
    const FINEST: f64 = 1e-11;
    const COARSEST: f64 = 1e-2;
    if (FINEST..=COARSEST).contains(&spacing.si()) {
        return Ok(());
    }
    Err(ReadFault::impossible(
        "the spacing",
        spacing.si(),
        LengthUnit::Metre,
    ))
}

/// `values` of `unit` in metres.
pub(super) fn metres(mut values: Vec<f64>, unit: LengthUnit) -> Result<Vec<f64>, ReadFault> {
    values
        .iter_mut()
        .for_each(|value| *value = unit.metres(*value));
    match values.iter().find(|value| !value.is_finite()) {
        None => Ok(values),
        Some(&value) => Err(ReadFault::impossible(
            "a position or height",
            value,
            LengthUnit::Metre,
        )),
    }
}
