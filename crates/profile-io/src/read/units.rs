//! Units by elimination, for files that state none.
//!
//! Exports without units come in metres, millimetres or micrometres for both columns, or in
//! millimetres along and micrometres up. A file is read without a stated unit only when exactly one
//! of these makes a possible stylus trace; nanometres are never assumed.

use super::options::LengthUnit;

use LengthUnit::{Metre, Micrometre, Millimetre};

/// Shortest trace `[m]`: step profilers scan some tens of micrometres.
const SHORTEST: f64 = 25e-6;
/// Longest trace `[m]`: drive length of common contour instruments.
const LONGEST: f64 = 0.2;
/// Smallest height span `[m]` when the trace is in the same unit: an atomic step of some layers.
const SMALLEST: f64 = 1e-9;
/// Smallest height span `[m]` when the heights would have a finer unit than the trace, or stand alone:
/// superfinished flanks (Ra 0.02 um) span more than this.
const SMALLEST_ALONE: f64 = 0.1e-6;
/// Largest height span `[m]`: range of roughness pick-ups, form included.
const LARGEST: f64 = 1e-3;
/// Steepest overall aspect, span over length: a trace that rises by more is no flank.
const STEEPEST: f64 = 0.5;

/// The units in which files are written that do not say so, along and up.
const USUAL: [(LengthUnit, LengthUnit); 4] = [
    (Metre, Metre),
    (Millimetre, Millimetre),
    (Micrometre, Micrometre),
    (Millimetre, Micrometre),
];

/// A trace in the units of its file; the length is in metres when it is known otherwise.
#[derive(Debug, Clone, Copy)]
pub(super) struct Extent {
    /// Length of the x column.
    pub length: f64,
    /// Highest minus lowest height.
    pub span: f64,
}

/// The only possible pair of units, of those that agree with what is stated.
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
    };
    match (x, z) {
        (Some(x), Some(z)) => Some((x, z)),
        (None, None) => only(USUAL.into_iter().filter(possible)),
        (Some(x), None) => only(
            [Metre, Millimetre, Micrometre]
                .map(|z| (x, z))
                .into_iter()
                .filter(possible),
        ),
        (None, Some(z)) => {
            let lengths = |x: &LengthUnit| (SHORTEST..=LONGEST).contains(&x.metres(extent.length));
            only([Metre, Millimetre, Micrometre].into_iter().filter(lengths)).map(|x| (x, z))
        }
    }
}

/// The only possible unit of heights over a trace of `length` `[m]`.
pub(super) fn heights_only(span: f64, length: f64) -> Option<LengthUnit> {
    let possible = |unit: &LengthUnit| {
        let span = unit.metres(span);
        (SMALLEST_ALONE..=LARGEST).contains(&span) && span <= STEEPEST * length
    };
    only([Metre, Millimetre, Micrometre].into_iter().filter(possible))
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
        let pair = |length, span| pair(Extent { length, span }, None, None);
        assert_eq!(pair(0.9956, 0.05), Some((Millimetre, Millimetre)));
        assert_eq!(pair(4.0, 5.0), Some((Millimetre, Micrometre)));
        assert_eq!(pair(4000.0, 5.0), Some((Micrometre, Micrometre)));
        assert_eq!(pair(5e-5, 1.3e-8), Some((Metre, Metre)));
        // 0.8 may be 0.8 mm of form or 0.8 um of roughness; 4312 may be nanometres of either.
        assert_eq!(pair(4.0, 0.8), None);
        assert_eq!(pair(4.0, 4312.0), None);
    }
}
