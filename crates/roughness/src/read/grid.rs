//! From rows to an even grid: direction, spacing, evenness, gaps.
//!
//! The spacing is (x_last − x_first)/(n − 1). The mean or median of single differences is wrong
//! by the rounding of x: a trace with dx = 0.0996 um written to 0.1 um has a median of 0.1 um.

use serde::Serialize;

use super::error::ReadError;
use super::options::Gaps;
use super::table::Row;
use crate::Warning;

/// Fewest points of a profile; below it no roughness parameter means anything.
pub(super) const FEWEST_POINTS: usize = 100;

/// Share of points that may be missing and interpolated: beyond it the filters see mostly lines.
const MOST_MISSING: f64 = 0.1;

/// Distance from an even grid, in spacings, that rounding of x does not explain but scanners do.
const UNEVENNESS: f64 = 0.25;

/// How the spacing was found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
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

/// Checks number, order and evenness; the mean spacing in the unit of x, rising x. `None` without x.
pub(super) fn spacing(
    file: &str,
    rows: &mut [Row],
    warnings: &mut Vec<Warning>,
) -> Result<Option<f64>, ReadError> {
    if rows.len() < FEWEST_POINTS {
        return Err(ReadError::TooFewPoints {
            file: file.to_owned(),
            points: rows.len(),
            needed: FEWEST_POINTS,
        });
    }
    let xs = |rows: &[Row]| -> Option<Vec<f64>> { rows.iter().map(|row| row.x).collect() };
    let Some(mut x) = xs(rows) else {
        return Ok(None);
    };
    let rises = x[x.len() - 1] >= x[0];
    let turn = x.windows(2).position(|pair| {
        if rises {
            pair[1] < pair[0]
        } else {
            pair[1] > pair[0]
        }
    });
    // A trace that ends where it started rises by this reckoning, and turns somewhere.
    let stands = (x[x.len() - 1] == x[0]).then_some(0);
    if let Some(at) = turn.or(stands) {
        return Err(ReadError::NotMonotone {
            file: file.to_owned(),
            line: rows[at + 1].line,
            previous: x[at],
            next: x[at + 1],
        });
    }
    if !rises {
        rows.reverse();
        x.reverse();
        warnings.push(Warning::Reversed);
    }
    let mean = (x[x.len() - 1] - x[0]) / (x.len() - 1) as f64;
    check_even(file, rows, &x, mean)?;
    Ok(Some(mean))
}

fn check_even(file: &str, rows: &[Row], x: &[f64], mean: f64) -> Result<(), ReadError> {
    let uneven = |at: usize, off: f64| ReadError::UnevenSpacing {
        file: file.to_owned(),
        line: rows[at].line,
        x: x[at],
        off: off / mean,
        spacing: mean,
    };
    if let Some((at, jump)) = lost_rows(x) {
        return Err(uneven(at, jump));
    }
    let off = |at: usize| (x[at] - x[0] - mean * at as f64).abs();
    let worst = (0..x.len())
        .max_by(|&a, &b| off(a).total_cmp(&off(b)))
        .unwrap_or_default();
    // Two ends and one point, each rounded by half the smallest step seen in the column.
    let allowed = (UNEVENNESS * mean).max(resolution(x));
    if off(worst) <= allowed {
        return Ok(());
    }
    Err(uneven(worst, off(worst)))
}

/// The first jump over one or more rows in an x that otherwise steps by one and the same amount.
/// On a coarsely rounded x it would pass for rounding.
fn lost_rows(x: &[f64]) -> Option<(usize, f64)> {
    const SAME: f64 = 1e-6;
    const MOSTLY: f64 = 0.9;
    const JUMP: f64 = 1.9;
    let mut steps: Vec<f64> = x.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let middle = steps.len() / 2;
    let (_, &mut typical, _) = steps.select_nth_unstable_by(middle, f64::total_cmp);
    let same = steps
        .iter()
        .filter(|step| (*step - typical).abs() <= SAME * typical)
        .count();
    if (same as f64) < MOSTLY * steps.len() as f64 {
        return None;
    }
    let at = x
        .windows(2)
        .position(|pair| pair[1] - pair[0] > JUMP * typical)?;
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
pub(super) fn counts_points(rows: &[Row]) -> bool {
    let first = rows.first().and_then(|row| row.x);
    matches!(first, Some(0.0 | 1.0))
        && rows
            .windows(2)
            .all(|pair| matches!((pair[0].x, pair[1].x), (Some(a), Some(b)) if b == a + 1.0))
}

/// Heights in the unit of the file, without gaps.
pub(super) fn heights(
    file: &str,
    rows: &[Row],
    gaps: Gaps,
    text_of: impl Fn(usize) -> String,
    warnings: &mut Vec<Warning>,
) -> Result<(Vec<f64>, usize), ReadError> {
    let missing = rows.iter().filter(|row| row.z.is_none()).count();
    let Some(gap) = rows.iter().find(|row| row.z.is_none()) else {
        return Ok((rows.iter().filter_map(|row| row.z).collect(), 0));
    };
    let fillable = missing as f64 <= MOST_MISSING * rows.len() as f64;
    if gaps == Gaps::Refuse || !fillable {
        return Err(ReadError::MissingPoints {
            file: file.to_owned(),
            line: gap.line,
            text: text_of(gap.line),
            missing,
            points: rows.len(),
            fillable,
        });
    }
    let (filled, longest, heights) = interpolate(rows);
    if heights.len() < FEWEST_POINTS {
        return Err(ReadError::TooFewPoints {
            file: file.to_owned(),
            points: heights.len(),
            needed: FEWEST_POINTS,
        });
    }
    warnings.push(Warning::GapsFilled {
        filled,
        longest,
        cut: missing - filled,
    });
    Ok((heights, filled))
}

/// Points filled, the longest run of them, and the heights between the outermost known ones.
fn interpolate(rows: &[Row]) -> (usize, usize, Vec<f64>) {
    let mut heights: Vec<f64> = Vec::with_capacity(rows.len());
    let (mut filled, mut longest, mut run) = (0, 0, 0);
    for row in rows {
        let Some(z) = row.z else {
            run += 1;
            continue;
        };
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
        let row = |z: Option<f64>| Row {
            line: 1,
            x: None,
            z,
        };
        let rows = [None, Some(1.0), None, None, Some(4.0), None].map(row);
        assert_eq!(interpolate(&rows), (2, 2, vec![1.0, 2.0, 3.0, 4.0]));
    }
}
