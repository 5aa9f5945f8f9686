//! Lengths as a file has them: in metres already, or numbers whose unit is still to be applied.

use super::error::ReadFault;
use super::options::{Axis, LengthUnit};
use crate::warning::Warning;

/// Lengths along an axis of a file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Lengths<T> {
    /// Metres, scaled by the file: no unit can be applied to them.
    Metres(T),
    /// Numbers of the file, with the unit that it states for them.
    Numbers(T, Option<LengthUnit>),
}

impl<T> Lengths<T> {
    /// Numbers in a unit of the file.
    pub(crate) fn new(numbers: T, unit: LengthUnit) -> Self {
        Self::Numbers(numbers, Some(unit))
    }

    /// Whether the file scaled them to metres.
    pub(crate) fn are_metres(&self) -> bool {
        matches!(self, Self::Metres(_))
    }

    /// The numbers or metres.
    pub(crate) fn values(&self) -> &T {
        let (Self::Metres(values) | Self::Numbers(values, _)) = self;
        values
    }

    /// The numbers or metres, to be changed.
    pub(crate) fn values_mut(&mut self) -> &mut T {
        let (Self::Metres(values) | Self::Numbers(values, _)) = self;
        values
    }

    /// The numbers or metres, without their kind.
    pub(crate) fn into_values(self) -> T {
        let (Self::Metres(values) | Self::Numbers(values, _)) = self;
        values
    }

    /// Other lengths of the same kind.
    pub(crate) fn with<U>(&self, values: U) -> Lengths<U> {
        match self {
            Self::Metres(_) => Lengths::Metres(values),
            Self::Numbers(_, unit) => Lengths::Numbers(values, *unit),
        }
    }

    /// The values with their unit: metres, or as `stated`, of the file, or of `other` if neither states one. A stated unit that
    /// differs from the unit of the file is a warning.
    pub(crate) fn in_unit(
        self,
        axis: Axis,
        stated: Option<LengthUnit>,
        warnings: &mut Vec<Warning>,
        other: impl FnOnce(&T, &mut Vec<Warning>) -> Result<LengthUnit, ReadFault>,
    ) -> Result<(T, LengthUnit), ReadFault> {
        Ok(match (self, stated) {
            (Self::Metres(values), stated) => {
                warnings.extend(stated.map(|stated| Warning::UnitNotUsed { axis, stated }));
                (values, LengthUnit::Metre)
            }
            (Self::Numbers(values, found), Some(stated)) => {
                warnings.extend(found.and_then(|found| unit_overridden(axis, stated, found)));
                (values, stated)
            }
            (Self::Numbers(values, Some(found)), None) => (values, found),
            (Self::Numbers(values, None), None) => {
                let unit = other(&values, warnings)?;
                (values, unit)
            }
        })
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
