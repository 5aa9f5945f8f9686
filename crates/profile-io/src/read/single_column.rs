//! A single column of heights after a header number: NPL text profiles.
//!
//! NPL text states the spacing in um on line 1, and other programs the number of heights, with lines of conditions above or
//! without. Such a first number is recognised by its number of decimals, because instruments write all heights with the same
//! number of decimals.

use asperity_core::numerics::extremes;

use super::damage::damaged;
use super::error::{ReadFault, SpacingHint};
use super::format::Format;
use super::options::{FEWEST_POINTS, LengthUnit, ReadOptions};
use super::text::TextSource;
use crate::warning::Warning;

/// Format of a file and the unit that it prescribes for heights.
pub(super) struct Special {
    pub format: Format,
    pub unit: Option<LengthUnit>,
    /// Spacing [m] stated by the format.
    pub spacing: Option<f64>,
}

impl Special {
    /// Delimited text, which prescribes no unit.
    pub(super) fn delimited() -> Self {
        Self {
            format: Format::DelimitedText,
            unit: None,
            spacing: None,
        }
    }
}

/// Removes the numbers of a header from the begin of `heights`, whose first is at line `first`; an error if there is no
/// spacing, or if lines above them show that the first number is not a height. NPL text profiles have no lines above.
pub(super) fn interpret(
    text: &mut TextSource<'_>,
    first: usize,
    is_headed: bool,
    heights: &mut Vec<f64>,
    options: &ReadOptions,
    warnings: &mut Vec<Warning>,
) -> Result<Special, ReadFault> {
    let no_spacing = ReadFault::no_spacing;
    if heights.len() < FEWEST_POINTS {
        return Ok(Special::delimited());
    }
    let header_number = if first_is_written_unlike_the_rest(text, first)? {
        heights.first().copied().filter(|value| value.is_finite())
    } else {
        None
    };
    let is_count = |value: f64| value == (heights.len() - 1) as f64;
    let header_number = match header_number {
        Some(value) if is_count(value) => {
            heights.remove(0);
            None
        }
        other => other,
    };
    match (options.dx, header_number) {
        (Some(_), None) => Ok(Special::delimited()),
        (None, None) => Err(no_spacing(SpacingHint::None)),
        (Some(dx), Some(value))
            if !is_headed && agrees(LengthUnit::Micrometre.metres(value), dx.si()) =>
        {
            heights.remove(0);
            Ok(Special {
                format: Format::NplText,
                unit: Some(LengthUnit::Micrometre),
                spacing: None,
            })
        }
        (Some(_), Some(value)) => {
            let unlike = |what| damaged(Format::DelimitedText, what, &value.to_string());
            let (low, high) = extremes(&heights[1..]);
            if !is_headed && plausible(value, heights.len()) {
                Err(unlike(
                    "its first number is written unlike the heights and may be another spacing in um than the stated one",
                ))
            } else if (low..=high).contains(&value) {
                Ok(Special::delimited())
            } else {
                Err(unlike(
                    "its first number is written unlike the heights, is outside of their range, and is not their number",
                ))
            }
        }
        (None, Some(_)) if is_headed => Err(no_spacing(SpacingHint::None)),
        (None, Some(value)) if plausible(value, heights.len()) => {
            heights.remove(0);
            warnings.push(Warning::SpacingFromFirstLine { value });
            Ok(Special {
                format: Format::NplText,
                unit: Some(LengthUnit::Micrometre),
                spacing: Some(LengthUnit::Micrometre.metres(value)),
            })
        }
        (_, Some(value)) => Err(no_spacing(SpacingHint::FirstLine(value))),
    }
}

/// Whether a number is a plausible spacing of a trace in um.
fn plausible(value: f64, points: usize) -> bool {
    const SPACINGS: std::ops::RangeInclusive<f64> = 0.005..=20.0;
    const LENGTHS: std::ops::RangeInclusive<f64> = 25.0..=200_000.0;
    SPACINGS.contains(&value) && LENGTHS.contains(&(value * points as f64))
}

/// Whether two values are equal within the four digits of a header.
fn agrees(value: f64, expected: f64) -> bool {
    const DIGITS: f64 = 1e-4;
    (value - expected).abs() <= DIGITS * expected.abs()
}

/// Whether the number of decimals of the first number differs from the next ten thousand numbers, which all have the
/// same.
fn first_is_written_unlike_the_rest(
    text: &mut TextSource<'_>,
    first: usize,
) -> Result<bool, ReadFault> {
    const LOOKED_AT: usize = 10_000;
    let (mut header, mut usual) = (None, None);
    let mut lines = text.lines()?;
    while let Some(line) = lines.next()? {
        if line.number > first + LOOKED_AT {
            break;
        }
        if line.number < first || line.is_blank() {
            continue;
        }
        let text = line.text.trim();
        let decimals = text.rfind(['.', ',']).map_or(0, |at| text.len() - at - 1);
        let header = *header.get_or_insert(decimals);
        if line.number > first && (decimals != *usual.get_or_insert(decimals) || decimals == header)
        {
            return Ok(false);
        }
    }
    Ok(usual.is_some())
}
