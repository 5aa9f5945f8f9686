//! Determination of units by elimination, for files that state none.
//!
//! Exports without units come in metres, millimetres or micrometres for both columns, or in millimetres along and
//! micrometres up. A file is read without a stated unit only if exactly one of these gives a possible stylus trace.
//! Nanometres are never assumed, and if heights in nanometres are possible too, no unit is assumed.

use super::error::ReadFault;
use super::options::{Axis, LengthUnit};
use crate::warning::Warning;

use LengthUnit::{Metre, Micrometre, Millimetre, Nanometre};

/// Minimum length of a trace `[m]`: step profilers scan some tens of micrometres.
const SHORTEST: f64 = 25e-6;
/// Maximum length of a trace `[m]`: drive length of common contour instruments.
const LONGEST: f64 = 0.2;
/// Minimum height span `[m]` if the trace is in the same unit: an atomic step of some layers.
const SMALLEST: f64 = 1e-9;
/// Minimum height span `[m]` if the heights have a finer unit than the trace, or there is no x: superfinished flanks
/// (Ra 0.02 um) span more than this.
const SMALLEST_ALONE: f64 = 0.1e-6;
/// Maximum height span `[m]`: range of roughness pick-ups, including form.
const LARGEST: f64 = 1e-3;
/// Maximum ratio of height span to length of a flank.
const STEEPEST: f64 = 0.5;

/// Range of the root mean square slope of a trace.
const SLOPES: std::ops::RangeInclusive<f64> = 0.0..=2.0;
/// Minimum root mean square slope of heights in nanometres: the slope of a mirror.
const LEAST_SLOPE: f64 = 1e-3;

/// Usual units of x and height in files without units.
const USUAL: [(LengthUnit, LengthUnit); 4] = [
    (Metre, Metre),
    (Millimetre, Millimetre),
    (Micrometre, Micrometre),
    (Millimetre, Micrometre),
];

/// Extent of a trace in the units of its file; the length is in metres if the spacing is stated.
#[derive(Debug, Clone, Copy)]
pub(super) struct Extent {
    /// Length of the x column.
    pub length: f64,
    /// Difference of the highest and lowest height.
    pub span: f64,
    /// Root mean square slope in the units of the file.
    pub slope: f64,
}

impl Extent {
    /// Whether the slopes are possible with heights in `z` and lengths in `x`.
    fn has_possible_slopes(self, x: LengthUnit, z: LengthUnit) -> bool {
        SLOPES.contains(&(self.slope * z.metres(1.0) / x.metres(1.0)))
    }

    /// Whether the trace is possible with heights in nanometres and lengths in `x`.
    fn may_be_nanometres(self, x: LengthUnit) -> bool {
        (SMALLEST_ALONE..=LARGEST).contains(&Nanometre.metres(self.span))
            && self.slope * Nanometre.metres(1.0) / x.metres(1.0) >= LEAST_SLOPE
            && self.has_possible_slopes(x, Nanometre)
    }
}

/// The only possible pair of units that agrees with the stated units.
pub(super) fn pair(
    extent: Extent,
    x: Option<LengthUnit>,
    z: Option<LengthUnit>,
) -> Option<(LengthUnit, LengthUnit)> {
    let possible = |&(x, z): &(LengthUnit, LengthUnit)| {
        let (length, span) = (x.metres(extent.length), z.metres(extent.span));
        let smallest = if x == z { SMALLEST } else { SMALLEST_ALONE };
        (SHORTEST..=LONGEST).contains(&length)
            && (smallest..=LARGEST).contains(&span)
            && span <= STEEPEST * length
            && extent.has_possible_slopes(x, z)
    };
    let certain = |units: &(LengthUnit, LengthUnit)| !extent.may_be_nanometres(units.0);
    match (x, z) {
        (Some(x), Some(z)) => Some((x, z)),
        (None, None) => only(USUAL.into_iter().filter(possible)).filter(certain),
        (Some(x), None) => only(
            [Metre, Millimetre, Micrometre]
                .map(|z| (x, z))
                .into_iter()
                .filter(possible),
        )
        .filter(certain),
        (None, Some(z)) => {
            let lengths = |x: &LengthUnit| (SHORTEST..=LONGEST).contains(&x.metres(extent.length));
            only([Metre, Millimetre, Micrometre].into_iter().filter(lengths)).map(|x| (x, z))
        }
    }
}

/// The only possible unit of heights over a trace whose length is in metres.
pub(super) fn heights_only(extent: Extent) -> Option<LengthUnit> {
    let possible = |unit: &LengthUnit| {
        let span = unit.metres(extent.span);
        (SMALLEST_ALONE..=LARGEST).contains(&span)
            && span <= STEEPEST * extent.length
            && extent.has_possible_slopes(Metre, *unit)
    };
    only([Metre, Millimetre, Micrometre].into_iter().filter(possible))
        .filter(|_| !extent.may_be_nanometres(Metre))
}

/// The only possible unit of heights that are `dx` \[m\] apart, with a warning; any unit if all heights are missing.
pub(super) fn of_heights(
    heights: &[f64],
    dx: f64,
    warnings: &mut Vec<Warning>,
) -> Result<LengthUnit, ReadFault> {
    let known: Vec<f64> = heights.iter().copied().filter(|z| z.is_finite()).collect();
    if known.is_empty() {
        return Ok(Metre);
    }
    let (low, high) = asperity_core::numerics::extremes(&known);
    let squares = known.windows(2).map(|pair| (pair[1] - pair[0]).powi(2));
    let step = (squares.sum::<f64>() / known.len() as f64).sqrt();
    let extent = Extent {
        length: dx * (heights.len() - 1) as f64,
        span: high - low,
        slope: step / dx,
    };
    let axis = Axis::Height;
    let unit = heights_only(extent).ok_or_else(|| ReadFault::no_unit(axis, extent.span))?;
    warnings.push(Warning::UnitAssumed { axis, unit });
    Ok(unit)
}

fn only<T>(mut candidates: impl Iterator<Item = T>) -> Option<T> {
    let first = candidates.next()?;
    candidates.next().is_none().then_some(first)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_unit_is_assumed_only_when_it_is_the_only_possible_one() {
        let pair = |length, span| {
            let slope = 5.0 * span / length;
            pair(
                Extent {
                    length,
                    span,
                    slope,
                },
                None,
                None,
            )
        };
        assert_eq!(pair(0.9956, 0.05), Some((Millimetre, Millimetre)));
        assert_eq!(pair(4.0, 5.0), Some((Millimetre, Micrometre)));
        assert_eq!(pair(4000.0, 5.0), Some((Micrometre, Micrometre)));
        assert_eq!(pair(5e-5, 1.3e-8), Some((Metre, Metre)));
        // 0.8 may be 0.8 mm of form or 0.8 um of roughness; 4312 may be nanometres of either.
        assert_eq!(pair(4.0, 0.8), None);
        assert_eq!(pair(4.0, 4312.0), None);
    }

    #[test]
    fn slopes_tell_nanometres_from_micrometres() {
        let pair = |slope| {
            let extent = Extent {
                length: 4.0,
                span: 900.0,
                slope,
            };
            pair(extent, Some(Millimetre), None)
        };
        // 0.9 mm of form with a slope of 0.5, or 0.9 um of roughness with one of 0.0005.
        assert_eq!(pair(500.0), Some((Millimetre, Micrometre)));
        // A slope of 100 is none; one of 0.1 is that of a flank in nanometres, which are not assumed.
        assert_eq!(pair(1e5), None);
    }
}
