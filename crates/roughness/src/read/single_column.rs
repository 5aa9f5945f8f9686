//! One column of heights under header numbers: NPL and Surfcom text profiles.
//!
//! Both start with numbers that are no heights. NPL text gives the spacing in um on line 1. Surfcom
//! gives the nominal length in mm on line 1 and the number of points on line 2; the nominal length
//! also stands there when the trace was aborted, so no spacing is derived from it.
//!
//! A first line that is a header number is told by its decimals: instruments write all heights with
//! the same number of them.

use asperity_core::quantity::Length;

use super::ReadOptions;
use super::dialect::Line;
use super::error::{ReadError, SpacingHint};
use super::format::Format;
use super::grid;
use super::options::LengthUnit;
use super::table::Row;

/// What a file turned out to be, and the unit its format prescribes for heights.
pub(super) struct Special {
    pub format: Format,
    pub unit: Option<LengthUnit>,
}

impl Special {
    /// Plain delimited text, which prescribes nothing.
    pub(super) fn delimited() -> Self {
        Self {
            format: Format::DelimitedText,
            unit: None,
        }
    }
}

/// Takes header numbers off heights without x, or refuses when there is no spacing.
pub(super) fn interpret(
    file: &str,
    rows: &mut Vec<Row>,
    table: &[Line<'_>],
    options: &ReadOptions,
) -> Result<Special, ReadError> {
    let (Some(first), Some(second)) = (rows.first().copied(), rows.get(1).copied()) else {
        return Ok(Special::delimited());
    };
    let no_spacing = |hint| ReadError::NoSpacing {
        file: file.to_owned(),
        hint,
    };
    let points = rows.len() - 2;
    if let (Some(length), true) = (first.z, second.z == Some(points as f64)) {
        let length = Length::from_si(LengthUnit::Millimetre.metres(length));
        options
            .dx
            .ok_or_else(|| no_spacing(SpacingHint::NominalLength { length, points }))?;
        rows.drain(..2);
        return Ok(Special {
            format: Format::SurfcomText,
            unit: Some(LengthUnit::Micrometre),
        });
    }
    if rows.len() < grid::FEWEST_POINTS {
        return Ok(Special::delimited());
    }
    let header_number = first.z.filter(|_| first_is_written_unlike_the_rest(table));
    match (options.dx, header_number) {
        (Some(_), None) => Ok(Special::delimited()),
        (None, None) => Err(no_spacing(SpacingHint::None)),
        (Some(dx), Some(value)) if agrees(LengthUnit::Micrometre.metres(value), dx.si()) => {
            rows.remove(0);
            Ok(Special {
                format: Format::NplText,
                unit: Some(LengthUnit::Micrometre),
            })
        }
        (_, Some(value)) => Err(no_spacing(SpacingHint::FirstLine(value))),
    }
}

/// Equal to the four digits a header may have.
fn agrees(value: f64, expected: f64) -> bool {
    const DIGITS: f64 = 1e-4;
    (value - expected).abs() <= DIGITS * expected.abs()
}

fn first_is_written_unlike_the_rest(table: &[Line<'_>]) -> bool {
    let decimals = |line: &Line<'_>| {
        let text = line.text.trim();
        text.rfind(['.', ',']).map_or(0, |at| text.len() - at - 1)
    };
    let Some((first, rest)) = table.split_first() else {
        return false;
    };
    let usual = rest.first().map(decimals);
    usual.is_some_and(|usual| {
        decimals(first) != usual && rest.iter().all(|line| decimals(line) == usual)
    })
}
