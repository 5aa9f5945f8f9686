//! A scan of a flank before it is prepared: its spikes, and the rows that represent it.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | ρ_k | correlation of the heights of rows k apart | - |
//! | N, n | rows of the scan, and rows that are computed | - |
//! | v_n | variance of the mean loss of n rows over the variance between single rows | - |

use asperity_core::quantity::Length;
use asperity_core::{Profile, cite};
use asperity_roughness::lay::bridged;
use asperity_roughness::outliers::{Outliers, replace};
use asperity_roughness::surface_preparation::PreparedSurface;
use asperity_roughness::{RoughnessError, Warning};

/// Error of the mean loss of the rows over the error of the mean loss of all rows.
const ERROR_OF_ALL: f64 = 1.1;
/// Most rows of a flank: of both they make 64 pairs.
const MOST_ROWS: usize = 8;
/// Least rows where one does not represent the scan: an error of fewer has too few degrees of freedom.
const LEAST_ROWS: usize = 4;
/// Most rows and points of a row that are correlated.
const CORRELATED: [usize; 2] = [256, 2048];

/// Replaces spikes in the heights `z` by straight lines, row by row; missing heights stay so. The warning about them, if there are any.
///
/// # Errors
/// When `deviations` is not positive, or a row is too short.
pub fn without_spikes(
    z: &mut [f64],
    columns: usize,
    spacing: Length,
    deviations: f64,
) -> Result<Option<Warning>, RoughnessError> {
    let (mut points, mut longest, mut farthest) = (0, 0, Length::default());
    for row in z.chunks_exact_mut(columns.max(1)) {
        let Some(known) = bridged(row) else { continue };
        let known = Profile::new(spacing, known)?;
        let (cleaned, record) = replace(&known, Outliers::beyond(deviations))?;
        for (z, cleaned) in row.iter_mut().zip(cleaned.heights()) {
            if z.is_finite() {
                *z = *cleaned;
            }
        }
        points += record.replaced;
        longest = longest.max(record.longest);
        if record.farthest > farthest {
            farthest = record.farthest;
        }
    }
    Ok((points > 0).then_some(Warning::OutliersReplaced {
        points,
        longest,
        farthest,
    }))
}

/// Least number of rows, spread evenly, whose mean loss has an error of at most 1.1 times the error of the mean loss of all rows: 1,
/// or 4 to 8. Where 8 are too few, 8 with a larger error.
///
/// ```text
/// v_n = (1/n²) Σ_ij ρ_|i−j|²,  v_n ≤ 1.1² v_N                                               [Scan-rows]
/// ```
///
/// The loss of a row does not depend on the sign of its heights, so losses of two rows correlate as the squares of their heights.
///
/// ```
/// use asperity_core::quantity::Length;
/// use asperity_flanks::scan::rows_needed;
/// use asperity_roughness::preparation::Preparation;
/// use asperity_roughness::surface_preparation::prepare_surface;
/// let rows = |turn: f64| -> Result<usize, asperity_roughness::RoughnessError> {
///     let height = |k: usize| 1e-7 * ((k % 1200) as f64 * 0.3 + turn * ((k / 1200) as f64).powi(2)).sin();
///     let z: Vec<f64> = (0..1200 * 40).map(height).collect();
///     let surface = prepare_surface(&z, 1200, [Length::from_si(1e-6); 2], &Preparation::default())?;
///     Ok(rows_needed(&surface))
/// };
/// // Straight ridges, and rows that do not resemble each other.
/// assert_eq!((rows(0.0)?, rows(2.0)?), (1, 8));
/// # Ok::<(), asperity_roughness::RoughnessError>(())
/// ```
#[must_use]
pub fn rows_needed(surface: &PreparedSurface) -> usize {
    cite!("Scan-rows");
    let squares = squares_of_correlation(surface);
    let n = squares.len();
    let variance = |rows: &[usize]| {
        let pairs = rows
            .iter()
            .flat_map(|i| rows.iter().map(|j| squares[i.abs_diff(*j)]));
        pairs.sum::<f64>() / (rows.len() * rows.len()) as f64
    };
    let all: Vec<usize> = (0..n).collect();
    let most = ERROR_OF_ALL.powi(2) * variance(&all);
    let is_enough = |count: &usize| {
        let rows: Vec<usize> = (0..*count).map(|k| middle(k, *count, n)).collect();
        variance(&rows) <= most
    };
    let mut counts = std::iter::once(1).chain(LEAST_ROWS..MOST_ROWS);
    counts.find(is_enough).unwrap_or(MOST_ROWS).min(n)
}

/// Row in the middle of part `k` of `count` equal parts of `rows`, from 0.
#[must_use]
pub fn middle(k: usize, count: usize, rows: usize) -> usize {
    (2 * k + 1) * rows / (2 * count)
}

/// ρ_k² of rows k apart, of evenly chosen rows of a large surface.
fn squares_of_correlation(surface: &PreparedSurface) -> Vec<f64> {
    let stride = |count: usize, most: usize| count.div_ceil(most).max(1);
    let steps = [
        stride(surface.rows(), CORRELATED[0]),
        stride(surface.columns, CORRELATED[1]),
    ];
    let row = |k: usize| surface.row(k).iter().step_by(steps[1]).copied();
    let rows = (0..surface.rows()).step_by(steps[0]).map(row);
    let rows: Vec<Vec<f64>> = rows.map(Iterator::collect).collect();
    let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let n = rows.len();
    let mean = |k: usize| {
        let pairs = rows.iter().zip(&rows[k..]);
        pairs.map(|(a, b)| product(a, b)).sum::<f64>() / (n - k) as f64
    };
    let square = mean(0);
    let of = |k: usize| {
        if square > 0.0 {
            (mean(k) / square).clamp(-1.0, 1.0).powi(2)
        } else {
            1.0
        }
    };
    (0..n).map(of).collect()
}
