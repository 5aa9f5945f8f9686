//! From rows to an even grid: direction, spacing, evenness, gaps.
//!
//! The spacing is (x_last − x_first)/(n − 1). The mean or median of single differences is wrong
//! by the rounding of x: a trace with dx = 0.0996 um written to 0.1 um has a median of 0.1 um.

use serde::{Deserialize, Serialize};

use super::error::ReadError;
use super::options::{Gaps, Uneven};
use crate::warning::Warning;

/// Fewest points of a profile; below it no roughness parameter means anything.
pub(super) const FEWEST_POINTS: usize = 100;

/// Share of points that may be missing and interpolated: beyond it the filters see mostly lines.
const MOST_MISSING: f64 = 0.1;

/// Distance from an even grid, in spacings, that rounding of x does not explain but scanners do.
const UNEVENNESS: f64 = 0.25;
/// Distance from an even grid, in spacings, from which slopes are off by some per cent.
const NOTICEABLE: f64 = 0.02;
/// Steps that are longer than this many spacings are no unevenness but missing points.
const LONGEST_STEP: f64 = 10.0;

/// Origin of the spacing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum SpacingSource {
    /// (x_last − x_first)/(n − 1) of the x column.
    XColumn,
    /// Stated by the user.
    Stated,
    /// Written in the header of the file.
    Header,
    /// The first line of the file, in um, as NPL text profiles have it.
    FirstLine,
    /// Evaluation length of the measuring conditions over the number of points.
    EvaluationLength,
}

/// The mean spacing of a column of x, and whether x falls along the file.
pub(super) struct Spacing {
    pub mean: f64,
    pub falls: bool,
    /// Where rounding does not explain it and it is noticeable.
    pub unevenness: Option<Unevenness>,
}

/// Deviation of a column of x from an even grid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Unevenness {
    /// Largest distance of a point from the grid over the spacing.
    pub off: f64,
    /// Largest difference of a step from the spacing over the spacing.
    pub slopes: f64,
}

/// Finds the line number and text of a row, counted from 0 as in the file.
pub(super) type Place<'a> = dyn FnMut(usize) -> Result<(usize, String), ReadError> + 'a;

/// Refuses fewer points than make a profile.
pub(super) fn enough(file: &str, points: usize) -> Result<(), ReadError> {
    if points >= FEWEST_POINTS {
        return Ok(());
    }
    Err(ReadError::TooFewPoints {
        file: file.to_owned(),
        points,
        needed: FEWEST_POINTS,
    })
}

/// Checks order and evenness of x; the mean spacing in its unit. An x that falls is turned round.
pub(super) fn spacing(
    file: &str,
    x: &mut [f64],
    allowed: Uneven,
    place: &mut Place<'_>,
) -> Result<Spacing, ReadError> {
    let (first, last) = (x[0], x[x.len() - 1]);
    let falls = last < first;
    let mut pairs = x.windows(2);
    let turn = match falls {
        false => pairs.position(|pair| pair[1] < pair[0]),
        true => pairs.position(|pair| pair[1] > pair[0]),
    };
    // A trace that ends where it started rises by this reckoning, and turns somewhere.
    let stands = (last == first).then_some(0);
    if let Some(at) = turn.or(stands) {
        return Err(ReadError::NotMonotone {
            file: file.to_owned(),
            line: place(at + 1)?.0,
            previous: x[at],
            next: x[at + 1],
        });
    }
    if falls {
        x.reverse();
    }
    let mean = (x[x.len() - 1] - x[0]) / (x.len() - 1) as f64;
    let (at, off) = match lost_rows(x) {
        Some(lost) => lost,
        None => {
            let (at, off) = farthest(x, mean);
            // Two ends and one point, each rounded by half the smallest step seen in the column.
            let rounded = off > NOTICEABLE * mean && off <= resolution(x);
            if rounded || off <= UNEVENNESS * mean && allowed == Uneven::Refuse {
                let noticeable = !rounded && off > NOTICEABLE * mean;
                return Ok(Spacing {
                    mean,
                    falls,
                    unevenness: noticeable.then(|| unevenness(x, off, mean)),
                });
            }
            (at, off)
        }
    };
    let longest = x
        .windows(2)
        .map(|pair| pair[1] - pair[0])
        .fold(0.0, f64::max);
    if allowed == Uneven::Resample && longest <= LONGEST_STEP * mean {
        return Ok(Spacing {
            mean,
            falls,
            unevenness: (off > NOTICEABLE * mean).then(|| unevenness(x, off, mean)),
        });
    }
    Err(ReadError::UnevenSpacing {
        file: file.to_owned(),
        line: place(if falls { x.len() - 1 - at } else { at })?.0,
        x: x[at],
        off: off / mean,
        spacing: mean,
    })
}

/// The point farthest from an even grid, and how far it is.
fn farthest(x: &[f64], mean: f64) -> (usize, f64) {
    let off = |at: usize, x_at: f64| (x_at - x[0] - mean * at as f64).abs();
    let offs = x.iter().enumerate().map(|(at, x_at)| (at, off(at, *x_at)));
    offs.max_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or((0, 0.0))
}

fn unevenness(x: &[f64], off: f64, mean: f64) -> Unevenness {
    let steps = x.windows(2).map(|pair| (pair[1] - pair[0]) / mean);
    Unevenness {
        off: off / mean,
        slopes: steps.fold(0.0, |most, step| f64::max(most, (step - 1.0).abs())),
    }
}

/// Heights `z` at the positions `x` on an even grid of as many points, by straight lines.
pub(super) fn resampled(x: &[f64], z: &[f64]) -> Vec<f64> {
    let last = x.len() - 1;
    let spacing = (x[last] - x[0]) / last as f64;
    let mut at = 0;
    let value = |i: usize| {
        let position = x[0] + spacing * i as f64;
        while at + 1 < last && x[at + 1] <= position {
            at += 1;
        }
        let step = x[at + 1] - x[at];
        let share = if step > 0.0 {
            (position - x[at]) / step
        } else {
            0.0
        };
        z[at] + (z[at + 1] - z[at]) * share.clamp(0.0, 1.0)
    };
    (0..=last).map(value).collect()
}

/// The first jump over one or more rows in an x that otherwise steps by one and the same amount.
/// On a coarsely rounded x it would pass for rounding.
fn lost_rows(x: &[f64]) -> Option<(usize, f64)> {
    const SAME: f64 = 1e-6;
    const MOSTLY: f64 = 0.9;
    const JUMP: f64 = 1.9;
    let step = |pair: &[f64]| pair[1] - pair[0];
    let is_same = |step: f64, typical: f64| (step - typical).abs() <= SAME * typical;
    // The amount that most steps have, if one has a majority: each other amount takes one vote away.
    let vote = |(typical, votes): (f64, usize), step: f64| match votes {
        0 => (step, 1),
        _ if is_same(step, typical) => (typical, votes + 1),
        _ => (typical, votes - 1),
    };
    let (typical, _) = x.windows(2).map(step).fold((0.0, 0), vote);
    let same = x
        .windows(2)
        .filter(|pair| is_same(step(pair), typical))
        .count();
    if (same as f64) < MOSTLY * (x.len() - 1) as f64 {
        return None;
    }
    let at = x.windows(2).position(|pair| step(pair) > JUMP * typical)?;
    Some((at + 1, x[at + 1] - x[at] - typical))
}

/// The step to which x seems rounded: the largest power of ten that divides every x.
fn resolution(x: &[f64]) -> f64 {
    const FINEST: i32 = -13;
    let largest = x.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    if largest == 0.0 {
        return 0.0;
    }
    let mut step = 10f64.powi(largest.log10().floor() as i32);
    let finest = largest * 10f64.powi(FINEST);
    while step > finest {
        // Written decimals come back from binary to within a few units in the last place.
        let divides = |v: &f64| {
            let steps = v / step;
            (steps - steps.round()).abs() <= 4.0 * f64::EPSILON * steps.abs().max(1.0)
        };
        if x.iter().all(divides) {
            return step;
        }
        step /= 10.0;
    }
    0.0
}

/// Whether x just counts the points, from 0 or 1.
pub(super) fn counts_points(x: &[f64]) -> bool {
    matches!(x.first(), Some(0.0 | 1.0)) && x.windows(2).all(|pair| pair[1] == pair[0] + 1.0)
}

/// Heights in the unit of the file, of which those that are not finite are missing, without gaps; with
/// them the number filled.
pub(super) fn heights(
    file: &str,
    z: Vec<f64>,
    gaps: Gaps,
    place: &mut Place<'_>,
    warnings: &mut Vec<Warning>,
) -> Result<(Vec<f64>, usize), ReadError> {
    let Some(gap) = z.iter().position(|z| !z.is_finite()) else {
        return Ok((z, 0));
    };
    let missing = z.iter().filter(|z| !z.is_finite()).count();
    let fillable = fillable(missing, z.len());
    if gaps == Gaps::Refuse || !fillable {
        let (line, text) = place(gap)?;
        return Err(ReadError::MissingPoints {
            file: file.to_owned(),
            line,
            text,
            missing,
            points: z.len(),
            fillable,
        });
    }
    let (filled, longest, heights) = interpolate(&z);
    enough(file, heights.len())?;
    warnings.push(Warning::GapsFilled {
        filled,
        longest,
        cut: missing - filled,
    });
    Ok((heights, filled))
}

/// Whether so few of the points are missing that they may be interpolated.
pub(super) fn fillable(missing: usize, points: usize) -> bool {
    missing as f64 <= MOST_MISSING * points as f64
}

/// Points filled, the longest run of them, and the heights between the outermost known ones.
fn interpolate(z: &[f64]) -> (usize, usize, Vec<f64>) {
    let mut heights: Vec<f64> = Vec::with_capacity(z.len());
    let (mut filled, mut longest, mut run) = (0, 0, 0);
    for &z in z {
        if !z.is_finite() {
            run += 1;
            continue;
        }
        if let Some(&before) = heights.last() {
            let steps = (run + 1) as f64;
            heights.extend((1..=run).map(|k| before + (z - before) * k as f64 / steps));
            filled += run;
            longest = longest.max(run);
        }
        run = 0;
        heights.push(z);
    }
    (filled, longest, heights)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_resolution_of_x_is_that_of_its_decimals() {
        assert_eq!(resolution(&[0.0, 0.0001, 0.000_2, 0.9956]), 1e-4);
        assert_eq!(resolution(&[0.0, 10.0, 20.0]), 10.0);
        assert_eq!(resolution(&[0.0, 0.0]), 0.0);
        assert!(resolution(&[0.0, std::f64::consts::PI]) < 1e-12);
    }

    #[test]
    fn an_uneven_trace_is_resampled_by_straight_lines() {
        let x = [0.0, 1.0, 2.5, 3.0, 4.0];
        let z = x.map(|x| 2.0 * x + 1.0);
        assert_eq!(resampled(&x, &z), [1.0, 3.0, 5.0, 7.0, 9.0]);
    }

    #[test]
    fn inner_gaps_are_bridged_and_outer_ones_cut() {
        let none = f64::NAN;
        let z = [none, 1.0, none, none, 4.0, none];
        assert_eq!(interpolate(&z), (2, 2, vec![1.0, 2.0, 3.0, 4.0]));
    }
}
