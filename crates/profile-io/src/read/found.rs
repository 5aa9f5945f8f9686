//! The common end of all instrument readers: overrides, gaps, checks, and the [`Trace`].

use asperity_core::quantity::Length;

use super::error::{ReadFault, SpacingHint};
use super::format::Format;
use super::grid::{self, SpacingSource};
use super::header::FilterState;
use super::layout::TableLayout;
use super::lengths::Lengths;
use super::metadata::Metadata;
use super::options::{Axis, Encoding, LengthUnit, ReadOptions};
use super::trace::{Positions, Trace, own};
use super::units;
use crate::warning::Warning;

/// Content of a file, as returned by the reader of an instrument format.
pub(super) struct Found {
    pub format: Format,
    /// Heights; NaN for a missing height.
    pub heights: Lengths<Vec<f64>>,
    /// Individual positions; they override `spacing`.
    pub x: Option<Lengths<Vec<f64>>>,
    /// Spacing with its origin.
    pub spacing: Option<(Lengths<f64>, SpacingSource)>,
    pub filter_state: FilterState,
    pub metadata: Metadata,
    pub warnings: Vec<Warning>,
    pub encoding: Option<Encoding>,
    pub table: Option<TableLayout>,
    /// Word instead of the first missing height, if no line has its own height.
    pub mark: Option<String>,
    /// Line of the first height in the file, if each height has its line.
    pub first_line: Option<usize>,
}

impl Found {
    /// Heights without other facts.
    pub(super) fn new(format: Format, heights: Lengths<Vec<f64>>) -> Self {
        Self {
            format,
            heights,
            x: None,
            spacing: None,
            filter_state: FilterState::Unknown,
            metadata: Metadata::default(),
            warnings: Vec::new(),
            encoding: None,
            table: None,
            mark: None,
            first_line: None,
        }
    }

    /// The trace; statements of the user override statements of the file.
    pub(super) fn finish(self, file: &str, options: &ReadOptions) -> Result<Trace, ReadFault> {
        grid::enough(self.heights.values().len())?;
        let mut warnings = self.warnings;
        let (stated, mut heights) = (options.spacing(), self.heights);
        let scaled = heights.are_metres();
        if let Lengths::Numbers(numbers, _) = &mut heights {
            grid::unmark(numbers);
        }
        let first_line = self.first_line;
        let count = heights.values().len();
        let mut x = self.x.filter(|_| stated.is_none());
        let column = match &mut x {
            Some(x) => Some(grid::spacing(x.values_mut(), &mut |row| {
                Ok((first_line.unwrap_or(1) + row, String::new()))
            })?),
            None => None,
        };
        let falls = column.as_ref().is_some_and(|column| column.falls);
        if falls {
            heights.values_mut().reverse();
            warnings.push(Warning::Reversed);
        }
        let found = match (&column, &x) {
            (Some(column), Some(x)) => Some((x.with(column.mean), SpacingSource::XColumn)),
            _ => self.spacing,
        };
        let no_spacing = || ReadFault::no_spacing(SpacingHint::None);
        let in_metres = |dx: Lengths<f64>, warnings: &mut Vec<Warning>| {
            let none = |_: &f64, _: &mut Vec<Warning>| Err(no_spacing());
            let (dx, unit) = dx.in_unit(Axis::Trace, options.x_unit, warnings, none)?;
            Ok::<_, ReadFault>((Length::from_si(unit.metres(dx)), unit))
        };
        let (spacing, x_unit, spacing_source) = match (stated, found) {
            (Some(dx), found) => {
                let found = found.and_then(|(dx, _)| in_metres(dx, &mut Vec::new()).ok());
                warnings.extend(found.and_then(|(found, _)| overridden(dx, found)));
                (dx, None, SpacingSource::Stated)
            }
            (None, Some((dx, source))) => {
                let (dx, unit) = in_metres(dx, &mut warnings)?;
                (dx, Some(unit), source)
            }
            (None, None) => return Err(no_spacing()),
        };
        check_spacing(spacing)?;
        let only_possible = |z: &Vec<f64>, warnings: &mut Vec<Warning>| {
            units::of_heights(z, spacing.si(), warnings)
        };
        let (mut heights, z_unit) =
            heights.in_unit(Axis::Height, options.z_unit, &mut warnings, only_possible)?;
        let mut x = x.map(Lengths::into_values);
        let unevenness = column.and_then(|column| column.unevenness);
        let mut left_out = 0;
        if let (Some(x), Some(_)) = (&mut x, unevenness) {
            left_out = grid::leave_out(x, &mut heights, options.gaps, &mut warnings)?;
        }
        let first = |row: usize| {
            let row = if falls { count - 1 - row } else { row };
            Ok(match first_line {
                Some(line) => (Some(line + row), "is marked as missing".to_owned()),
                None => (None, grid::node(row, options, self.mark.as_deref())),
            })
        };
        let (heights, filled) = grid::heights(heights, options.gaps, first, &mut warnings)?;
        let positions = match (x, x_unit, unevenness) {
            (Some(x), Some(unit), Some(unevenness)) => own(metres(x, unit)?, unevenness),
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
            x_unit,
            z_unit,
            spacing_source,
            filter_state: self.filter_state,
            gaps_filled: filled + left_out,
            cut: None,
            metadata: self.metadata,
            warnings,
            scaled,
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
