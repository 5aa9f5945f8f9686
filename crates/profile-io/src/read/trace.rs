//! The common end of all instrument readers: overrides, gaps, checks, and the [`Reading`].

use asperity_core::Profile;
use asperity_core::quantity::Length;

use super::error::{ReadError, SpacingHint};
use super::format::Format;
use super::grid::{self, SpacingSource};
use super::header::FilterState;
use super::layout::TableLayout;
use super::metadata::Metadata;
use super::options::{Axis, Encoding, LengthUnit, ReadOptions};
use super::reading::Reading;
use crate::warning::Warning;

/// Findings of a reader of an instrument's format.
pub(super) struct Trace {
    pub format: Format,
    /// Heights in `z_unit`, NaN where there is none.
    pub heights: Vec<f64>,
    pub z_unit: LengthUnit,
    /// Spacing in `x_unit` and how it was found.
    pub spacing: Option<(f64, SpacingSource)>,
    pub x_unit: LengthUnit,
    /// Whether factors of the header made the lengths what they are, so that a stated unit fits none of them.
    pub scaled: bool,
    pub filter_state: FilterState,
    pub metadata: Metadata,
    pub warnings: Vec<Warning>,
    pub encoding: Option<Encoding>,
    pub table: Option<TableLayout>,
    /// Line of the first height in the file; 1 where there are no lines.
    pub first_line: usize,
}

impl Trace {
    /// Heights and spacing in metres, nothing else known.
    pub(super) fn new(format: Format, heights: Vec<f64>) -> Self {
        Self {
            format,
            heights,
            z_unit: LengthUnit::Metre,
            spacing: None,
            x_unit: LengthUnit::Metre,
            scaled: false,
            filter_state: FilterState::Unknown,
            metadata: Metadata::default(),
            warnings: Vec::new(),
            encoding: None,
            table: None,
            first_line: 1,
        }
    }

    /// The reading, with what the user states put over what the file says.
    pub(super) fn finish(self, file: &str, options: &ReadOptions) -> Result<Reading, ReadError> {
        grid::enough(file, self.heights.len())?;
        let mut warnings = self.warnings;
        let stated = options.dx;
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
        let x_unit = match (stated, self.spacing) {
            (None, Some(_)) => unit(Axis::Trace, options.x_unit, self.x_unit),
            _ => options.x_unit.unwrap_or(self.x_unit),
        };
        let (spacing, spacing_source) = match (stated, self.spacing) {
            (Some(dx), column) => {
                let column = column.map(|(dx, _)| Length::from_si(x_unit.metres(dx)));
                warnings.extend(column.and_then(|column| overridden(dx, column)));
                (dx, SpacingSource::Stated)
            }
            (None, Some((dx, source))) => (Length::from_si(x_unit.metres(dx)), source),
            (None, None) => {
                return Err(ReadError::NoSpacing {
                    file: file.to_owned(),
                    hint: SpacingHint::None,
                });
            }
        };
        check_spacing(file, spacing)?;
        let first_line = self.first_line;
        let mut place = |row| Ok((first_line + row, "missing".to_owned()));
        let (heights, gaps_filled) =
            grid::heights(file, self.heights, options.gaps, &mut place, &mut warnings)?;
        let profile = profile(file, heights, spacing, z_unit)?;
        if self.filter_state == FilterState::Roughness {
            warnings.push(Warning::AlreadyFiltered);
        }
        Ok(Reading {
            name: file.to_owned(),
            format: self.format,
            encoding: self.encoding,
            table: self.table,
            x_unit: stated.is_none().then_some(x_unit),
            z_unit,
            spacing: profile.spacing(),
            spacing_source,
            length: profile.length(),
            filter_state: self.filter_state,
            points: profile.len(),
            gaps_filled,
            metadata: self.metadata,
            warnings,
            profile,
        }
        .checked(self.scaled))
    }
}

/// The warning that a stated unit differs from the one that the file states.
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

/// The warning that a stated spacing differs from the one in the file.
pub(super) fn overridden(stated: Length, column: Length) -> Option<Warning> {
    const DIFFERS: f64 = 0.01;
    let differs = (column / stated - 1.0).abs() > DIFFERS;
    differs.then_some(Warning::SpacingOverridden { stated, column })
}

/// Refuses spacings that no stylus or optical instrument has: a file in other units than it says.
fn check_spacing(file: &str, spacing: Length) -> Result<(), ReadError> {
    const FINEST: f64 = 1e-11;
    const COARSEST: f64 = 1e-2;
    if (FINEST..=COARSEST).contains(&spacing.si()) {
        return Ok(());
    }
    Err(ReadError::Impossible {
        file: file.to_owned(),
        what: "the spacing",
        value: spacing.si(),
        unit: LengthUnit::Metre,
    })
}

/// The profile of `heights` in `unit`.
pub(super) fn profile(
    file: &str,
    mut heights: Vec<f64>,
    spacing: Length,
    unit: LengthUnit,
) -> Result<Profile, ReadError> {
    heights.iter_mut().for_each(|z| *z = unit.metres(*z));
    Profile::new(spacing, heights).map_err(|error| ReadError::Impossible {
        file: file.to_owned(),
        what: error.name,
        value: error.value,
        unit: LengthUnit::Metre,
    })
}
