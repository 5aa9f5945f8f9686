//! From rows to an even grid: direction, spacing, evenness, gaps.
//!
//! The spacing is (x_last − x_first)/(n − 1). The mean or median of single differences is wrong
//! by the rounding of x: a trace with dx = 0.0996 um written to 0.1 um has a median of 0.1 um.

use std::ops::Range;

use serde::{Deserialize, Serialize};

use super::error::ReadFault;
use super::options::{FEWEST_POINTS, Gaps, ReadOptions, TraceLine};
use crate::warning::Warning;

/// Maximum fraction of missing points that may be interpolated.
const MOST_MISSING: f64 = 0.1;
/// Largest share of the points of a row of a surface that is bridged. A scan lacks points on steep parts of most rows.
const MOST_BRIDGED: f64 = 0.25;

/// Maximum distance from an even grid, in spacings, of slightly uneven points, as of scanners.
const UNEVENNESS: f64 = 0.25;
/// Distance from an even grid, in spacings, from which slopes are off by some per cent.
const NOTICEABLE: f64 = 0.02;

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
    /// The first line of the file, in um, as in NPL text profiles.
    FirstLine,
    /// Evaluation length of the measuring conditions over the number of points.
    EvaluationLength,
}

/// Mean spacing and direction of a column of x.
pub(super) struct Spacing {
    pub mean: f64,
    pub falls: bool,
    /// Unevenness, if it is noticeable and not due to rounding.
    pub unevenness: Option<Unevenness>,
}

/// Deviation of positions from an even grid with the same number of points and the same ends.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[non_exhaustive]
pub struct Unevenness {
    /// Line of the point farthest from the grid, or after the first lost row, from 1.
    pub line: usize,
    /// Its x in the unit of the file.
    pub x: f64,
    /// Its distance from the grid over the spacing.
    pub off: f64,
    /// Largest difference of a step from the spacing, over the spacing.
    pub slopes: f64,
    /// Whether x has constant steps except for jumps over lost rows.
    pub lost_rows: bool,
}

impl Unevenness {
    /// Whether the points may be treated as even, with errors of the slopes of some per cent.
    pub fn is_slight(&self) -> bool {
        self.off <= UNEVENNESS && !self.lost_rows
    }
}

/// Returns the line number and text of a row, counted from 0 in the order of the file.
pub(super) type GridPlace<'a> = dyn FnMut(usize) -> Result<(usize, String), ReadFault> + 'a;

/// Returns an error for fewer points than a profile requires.
pub(super) fn enough(points: usize) -> Result<(), ReadFault> {
    if points >= FEWEST_POINTS {
        return Ok(());
    }
    Err(ReadFault::too_few_points(points))
}

/// Returns an error for lines of a surface with fewer points, which names the lines across if they have enough.
pub(super) fn enough_of_line(
    points: usize,
    across: usize,
    line: TraceLine,
) -> Result<(), ReadFault> {
    let other = match line {
        TraceLine::Row => TraceLine::Column,
        TraceLine::Column => TraceLine::Row,
        TraceLine::Mean => TraceLine::MeanColumn,
        TraceLine::MeanColumn => TraceLine::Mean,
    };
    if points < FEWEST_POINTS && across >= FEWEST_POINTS {
        Err(ReadFault::lines_too_short(points, other))
    } else {
        Ok(())
    }
}

/// The row asked for, from 0, of `rows` profiles of `points` points each; a single one needs not be asked for.
pub(super) fn chosen_row(
    row: Option<usize>,
    rows: usize,
    points: usize,
) -> Result<usize, ReadFault> {
    let asked = row.unwrap_or(usize::from(rows == 1));
    let at = asked.checked_sub(1).filter(|at| *at < rows);
    at.ok_or_else(|| ReadFault::several_profiles(rows, points, row))
}

/// Checks order and evenness of x and returns its spacing. A descending x is reversed.
pub(super) fn spacing(x: &mut [f64], place: &mut GridPlace<'_>) -> Result<Spacing, ReadFault> {
    let (first, last) = (x[0], x[x.len() - 1]);
    let falls = last < first;
    let mut pairs = x.windows(2);
    let turn = if falls {
        pairs.position(|pair| pair[1] > pair[0])
    } else {
        pairs.position(|pair| pair[1] < pair[0])
    };
    // A trace that ends at its start must change its direction.
    let is_closed = (last == first).then_some(0);
    if let Some(at) = turn.or(is_closed) {
        return Err(not_monotone(x, at, place(at + 1)?.0));
    }
    if falls {
        x.reverse();
    }
    let row = |at: usize| if falls { x.len() - 1 - at } else { at };
    let unevenness = match unevenness(x) {
        Some((at, found)) => {
            // Equal neighbours are permitted only due to rounding, not in an uneven trace.
            if let Some(at) = x.windows(2).position(|pair| pair[0] == pair[1]) {
                return Err(not_monotone(x, at, place(row(at + 1))?.0));
            }
            let line = place(row(at))?.0;
            Some(Unevenness { line, ..found })
        }
        None => None,
    };
    Ok(Spacing {
        mean: (x[x.len() - 1] - x[0]) / (x.len() - 1) as f64,
        falls,
        unevenness,
    })
}

fn not_monotone(x: &[f64], at: usize, line: usize) -> ReadFault {
    ReadFault::not_monotone(line, x[at], x[at + 1])
}

/// The point with the largest deviation of an ascending x from an even grid; `None` if the deviation is due to rounding
/// or not noticeable. The line is set by the caller.
pub(super) fn unevenness(x: &[f64]) -> Option<(usize, Unevenness)> {
    let mean = (x[x.len() - 1] - x[0]) / (x.len() - 1) as f64;
    let steps = || x.windows(2).map(|pair| pair[1] - pair[0]);
    let larger = |most: f64, value: f64| if value > most { value } else { most };
    // Lost rows cause a step of at least 1.5 mean steps; only then are they searched for.
    let lost = if steps().fold(0.0, larger) > 1.5 * mean {
        lost_rows(x)
    } else {
        None
    };
    let grid = |at: usize| x[0] + mean * at as f64;
    let offs = x.iter().enumerate().map(|(at, x)| (x - grid(at)).abs());
    if lost.is_none() && offs.fold(0.0, larger) <= NOTICEABLE * mean {
        return None;
    }
    let (at, off) = lost.unwrap_or_else(|| farthest(x, mean));
    // Two ends and one point, each rounded by half the resolution of the column.
    (lost.is_some() || off > resolution(x)).then(|| {
        let slopes = steps().map(|step| (step / mean - 1.0).abs());
        let found = Unevenness {
            line: 1,
            x: x[at],
            off: off / mean,
            slopes: slopes.fold(0.0, larger),
            lost_rows: lost.is_some(),
        };
        (at, found)
    })
}

/// The point farthest from an even grid, and its distance.
fn farthest(x: &[f64], mean: f64) -> (usize, f64) {
    let off = |at: usize, x_at: f64| (x_at - x[0] - mean * at as f64).abs();
    let offs = x.iter().enumerate().map(|(at, x_at)| (at, off(at, *x_at)));
    offs.max_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or((0, 0.0))
}

/// The first jump over one or more rows in an x with otherwise constant steps. In a coarsely rounded x it could not be
/// distinguished from rounding.
fn lost_rows(x: &[f64]) -> Option<(usize, f64)> {
    const SAME: f64 = 1e-6;
    const MOSTLY: f64 = 0.9;
    const JUMP: f64 = 1.9;
    let step = |pair: &[f64]| pair[1] - pair[0];
    let is_same = |step: f64, typical: f64| (step - typical).abs() <= SAME * typical;
    // Majority vote: the most frequent step, if it has a majority.
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
        // Decimal numbers are represented in binary with an error of a few units in the last place.
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

/// Replaces marks for missing heights by NaN: the ends of the range of 32-bit integers, which no height reaches, and the
/// smallest of them with its decimal point moved, such as -2147.483648, whose ten digits no height has by chance.
pub(super) fn unmark(heights: &mut [f64]) {
    const LARGEST: f64 = i32::MAX as f64;
    const SMALLEST: f64 = i32::MIN as f64;
    // The division of one exact number by another is the number that the digits are read as.
    let moved: [f64; 9] = std::array::from_fn(|k| SMALLEST / 10_f64.powi(k as i32 + 1));
    let is_marked = |z: &f64| z.abs() >= LARGEST || *z <= moved[8] && moved.contains(z);
    let marked = heights.iter_mut().filter(|z| is_marked(z));
    marked.for_each(|z| *z = f64::NAN);
}

/// Whether x just counts the points, from 0 or 1.
pub(super) fn counts_points(x: &[f64]) -> bool {
    matches!(x.first(), Some(0.0 | 1.0)) && x.windows(2).all(|pair| pair[1] == pair[0] + 1.0)
}

/// The point `at`, from 0, of the trace that `options` ask for, in words: a missing point that no line of the file has, with the
/// word that the file has instead of its height.
pub(super) fn node(at: usize, options: &ReadOptions, mark: Option<&str>) -> String {
    let point = at + 1;
    let place = match (options.line, options.row) {
        (TraceLine::Row, Some(row)) => format!("is column {point} of row {row}"),
        (TraceLine::Column, Some(column)) => format!("is row {point} of column {column}"),
        _ => format!("is point {point}"),
    };
    match mark {
        Some(mark) => format!("{place}, \"{mark}\""),
        None => place,
    }
}

/// Fills gaps in heights, where missing heights are not finite; returns the heights and the number of filled points. A refusal
/// names the line and the words that `first` has for the first gap.
pub(super) fn heights(
    z: Vec<f64>,
    gaps: Gaps,
    first: impl FnOnce(usize) -> Result<(Option<usize>, String), ReadFault>,
    warnings: &mut Vec<Warning>,
) -> Result<(Vec<f64>, usize), ReadFault> {
    let Some(gap) = z.iter().position(|z| !z.is_finite()) else {
        return Ok((z, 0));
    };
    let missing = z.iter().filter(|z| !z.is_finite()).count();
    // Missing points at the ends are cut off, not filled.
    let known = z.iter().position(|z| z.is_finite()).unwrap_or(z.len());
    let end = z
        .iter()
        .rposition(|z| z.is_finite())
        .map_or(known, |at| at + 1);
    let inner = z[known..end].iter().filter(|z| !z.is_finite()).count();
    let fillable = known < end && fillable(inner, end - known);
    if gaps == Gaps::Refuse || !fillable {
        let (line, first) = first(gap)?;
        return Err(ReadFault::missing_points(
            line,
            &first,
            [missing, z.len()],
            fillable,
        ));
    }
    let (filled, longest, heights) = interpolate(&z);
    enough(heights.len())?;
    warnings.push(Warning::GapsFilled {
        filled,
        longest,
        cut: missing - filled,
    });
    Ok((heights, filled))
}

/// Heights with bridges over missing ones, level at the ends, so that every row keeps its places; and the number of points bridged
/// among those that are used. Refused if more than a quarter of these is missing, or one with [`Gaps::Refuse`].
pub(super) fn bridged(
    z: &[f64],
    used: Range<usize>,
    options: &ReadOptions,
) -> Result<(Vec<f64>, usize), ReadFault> {
    let (_, _, inner) = interpolate(z);
    let of_used = &z[used.clone()];
    let missing = of_used.iter().filter(|z| !z.is_finite()).count();
    let known = z.iter().position(|z| z.is_finite()).unwrap_or(0);
    let fillable = missing as f64 <= MOST_BRIDGED * of_used.len() as f64;
    let is_refused = missing > 0 && (options.gaps == Gaps::Refuse || !fillable);
    let (Some(&first), Some(&last), false) = (inner.first(), inner.last(), is_refused) else {
        let gap = of_used.iter().position(|z| !z.is_finite()).unwrap_or(0);
        let first = node(used.start + gap, options, None);
        return Err(ReadFault::missing_points(
            None,
            &first,
            [missing, of_used.len()],
            fillable && !inner.is_empty(),
        ));
    };
    let mut heights = vec![first; known];
    heights.extend(inner);
    heights.resize(z.len(), last);
    Ok((heights, missing))
}

/// Removes missing points from a trace with individual positions, if they may be interpolated; returns their number.
pub(super) fn leave_out(
    x: &mut Vec<f64>,
    z: &mut Vec<f64>,
    gaps: Gaps,
    warnings: &mut Vec<Warning>,
) -> Result<usize, ReadFault> {
    let known: Vec<bool> = z.iter().map(|z| z.is_finite()).collect();
    let missing = known.iter().filter(|known| !**known).count();
    if missing == 0 || gaps == Gaps::Refuse || !fillable(missing, z.len()) {
        return Ok(0);
    }
    let mut keep = known.iter();
    x.retain(|_| keep.next().copied().unwrap_or(false));
    z.retain(|z| z.is_finite());
    enough(z.len())?;
    let runs = known.split(|known| *known).map(<[bool]>::len);
    warnings.push(Warning::GapsFilled {
        filled: missing,
        longest: runs.max().unwrap_or(0),
        cut: 0,
    });
    Ok(missing)
}

/// Whether the number of missing points is small enough for interpolation.
fn fillable(missing: usize, points: usize) -> bool {
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
    fn inner_gaps_are_bridged_and_outer_ones_cut() {
        let none = f64::NAN;
        let z = [none, 1.0, none, none, 4.0, none];
        assert_eq!(interpolate(&z), (2, 2, vec![1.0, 2.0, 3.0, 4.0]));
        let of = |z: &[f64], used: Range<usize>, gaps: Gaps| {
            let options = ReadOptions {
                gaps,
                ..ReadOptions::default()
            };
            bridged(z, used, &options).map_err(|fault| fault.in_file("a.sur").to_string())
        };
        // Points that are not used are bridged and do not count.
        let row = vec![1.0, 1.0, 2.0, 3.0, 4.0, 4.0];
        for gaps in [Gaps::Interpolate, Gaps::Refuse] {
            assert_eq!(of(&z, 1..2, gaps), Ok((row.clone(), 0)));
            let all = "4 of 6 points have no height, the first is point 1: too many";
            assert!(of(&z, 0..6, gaps).unwrap_err().contains(all));
        }
        let z = [1.0, none, 3.0, 4.0, none];
        let row = vec![1.0, 2.0, 3.0, 4.0, 4.0];
        assert_eq!(of(&z, 0..4, Gaps::Interpolate), Ok((row, 1)));
        let refused = of(&z, 0..4, Gaps::Refuse).unwrap_err();
        assert!(
            refused.contains("1 of 4 points have no height, the first is point 2")
                && !refused.contains("too many"),
            "{refused}"
        );
    }
}
