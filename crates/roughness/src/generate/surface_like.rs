//! A surface like a trace: its heights and its autocorrelation along the rows, and a stated lay.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | ρ, w | autocorrelation of the trace, and its lag window, 0 beyond a quarter of the trace | - |
//! | γ | lay: 1 isotropic, small for ridges that are long across the rows | - |
//! | H | distribution of the heights of the trace | m |
//! | W | transform of white noise | - |

use std::f64::consts::PI;

use asperity_core::numerics::good_fft_length;
use asperity_core::quantity::Length;
use asperity_core::{DomainError, Profile, cite};
use realfft::num_complex::Complex;

use super::fitted::{distribution, heights};
use super::fitted_surface::Area;
use crate::areal::transform;
use crate::autocorrelation::autocorrelation;
use crate::error::RoughnessError;

/// Most points of a row before it repeats.
const MOST_COLUMNS: usize = 8192;
/// Part of the trace over which its autocorrelation is used.
const LAGS: usize = 4;
/// Number of times that spectrum and heights are imposed in turn.
const ROUNDS: usize = 4;
/// Number of heights at each end of the distribution, which has each of them, and between the ends.
const TAIL: usize = 4096;
const INNER: usize = 1 << 16;

/// Heights \[m\] of `rows` rows as long as `trace`, a distance `apart`, row by row. They repeat along the lead.
///
/// ```text
/// ρ(x, y) = w(r) ρ(r),  r² = x² + γ² y²;  Z ← |W| √S Z/|Z|,  z ← H⁻¹(rank z)                   [Trace-area]
/// ```
///
/// S is the transform of ρ(x, y), negative parts left out; both steps in turn.
///
/// # Errors
/// When the trace is flat, or γ is not within 0 to 1.
///
/// ```
/// use asperity_core::quantity::Length;
/// use asperity_roughness::generate::{SelfAffine, surface_like};
/// let um = |x: f64| Length::from_si(1e-6 * x);
/// let recipe = SelfAffine {
///     points: 2000, spacing: um(1.0), rq: um(0.3), hurst: 0.8, roll_off: um(40.0), short_cut: um(5.0), seed: 7,
/// };
/// let trace = recipe.generate()?;
/// let made = surface_like(&trace, 32, um(1.0), 1.0, 1)?;
/// let square = made.iter().map(|z| z * z).sum::<f64>() / made.len() as f64;
/// assert_eq!(made.len(), 32 * 2000);
/// assert!((square.sqrt() / 0.3e-6 - 1.0).abs() < 0.01);
/// # Ok::<(), asperity_roughness::RoughnessError>(())
/// ```
pub fn surface_like(
    trace: &Profile,
    rows: usize,
    apart: Length,
    lay: f64,
    seed: u64,
) -> Result<Vec<f64>, RoughnessError> {
    cite!("Trace-area");
    let rule = "must lie between 0 (ridges across the face) and 1 (isotropic)";
    DomainError::require((0.0..=1.0).contains(&lay), "lay", lay, "-", rule)?;
    let points = trace.len();
    let width = good_fft_length(points).min(MOST_COLUMNS);
    let correlation = autocorrelation(trace.heights())?;
    let most = (points / LAGS).min(width / 2).max(1);
    let at = |lag: f64| {
        let k = lag as usize;
        if k + 1 >= most {
            return 0.0;
        }
        let part = lag - k as f64;
        let window = 0.5 * (1.0 + (PI * lag / most as f64).cos());
        window * (correlation[k] * (1.0 - part) + correlation[k + 1] * part)
    };
    let nearest = |k: usize, n: usize| k.min(n - k) as f64;
    let across = lay * (apart / trace.spacing());
    let mut cells: Vec<Complex<f64>> = (0..width * rows)
        .map(|k| {
            let [x, y] = [nearest(k % width, width), nearest(k / width, rows)];
            Complex::new(at(x.hypot(across * y)), 0.0)
        })
        .collect();
    transform(&mut cells, width, rows);
    let roots: Vec<f64> = cells.iter().map(|cell| cell.re.max(0.0).sqrt()).collect();
    let mut area = Area::of_noise([width, rows], seed);
    let amplitudes: Vec<f64> = area
        .cells
        .iter()
        .zip(&roots)
        .map(|(cell, root)| cell.norm() * root)
        .collect();
    let list = distribution(trace.heights().to_vec(), TAIL, INNER);
    let targets = heights("heights", &list, width * rows)?;
    area.impose(&amplitudes, &targets, ROUNDS);
    let cells = area.cells;
    let row = |y: usize| {
        let row = cells[y * width..(y + 1) * width].iter();
        row.cycle().take(points).map(|cell| cell.re)
    };
    Ok((0..rows).flat_map(row).collect())
}
