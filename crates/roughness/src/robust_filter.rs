//! Robust Gaussian filter for flanks with pits, scratches or steps.
//!
//! Source: ISO 16610-31 (local quadratic regression with Tukey's biweight).
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | s_k | weights exp(−π (k dx/(γ λ_c))²), γ = 0.7309134, k = −m .. m | - |
//! | m | number of weights on either side, ⌈γ/α λ_c/dx⌉ | - |
//! | δ | Tukey's weight of a point | - |
//! | r | distance from the mean line | m |
//! | c | distance beyond which a point has zero weight | m |
//! | u | position k/m | - |
//!
//! The linear filter follows a pit and creates false shoulders next to it; a 10 um pit changes Rpk from 0.4 um to 1.0
//! um. An iteration takes ten real transforms and a 3 × 3 system per point.
//!
//! Details that no available source defines follow an independent computation, whose lines and numbers of iterations
//! are reproduced: the weights end at exp(−π/α²) = 6.6·10⁻⁷ like the weights of the linear filter at ±λ_c, the first
//! iteration is unweighted, c is updated in every iteration from its line, and the line of the iteration in which c
//! converges is the result. Weights that end at ±λ_c would change the line by 0.5 to 5 % of Rq.
//!
//! On a trace across a feature as wide as λ_c and much deeper than the roughness the iteration may not converge: the
//! line within the feature depends on a few points, and a change of the heights by 10⁻¹⁸ m grows to micrometres in 100
//! iterations. Such a trace is an error, because its robust line is not defined.

use std::f64::consts::PI;

use asperity_core::cancel::checkpoint;
use asperity_core::cite;
use asperity_core::quantity::Length;
use asperity_core::{DomainError, Profile};
use serde::{Deserialize, Serialize};

use crate::error::RoughnessError;
use crate::gaussian_filter::{SUPPORT, alpha};
use crate::local_parabolas::LocalParabolas;

/// Name of the filter in an error.
pub const ROBUST_FILTER: &str = "the robust filter";
/// γ of ISO 16610-31, for which the quadratic regression transmits half the amplitude at λ_c: the root of
/// (1 + πγ²) exp(−πγ²) = ½.
const GAMMA: f64 = 0.730_913_428_094_675_9;
/// c = 4.4478 median|r|: three standard deviations of Gaussian residuals (ISO 16610-31).
const SCALE: f64 = 4.4478;
/// Convergence criterion: relative change of c.
const TOLERANCE: f64 = 1e-8;
/// Rounding errors of the transforms, relative to the heights.
const ROUNDING: f64 = 1e-13;
/// Maximum number of iterations; flanks take 14 to 33, a trace across a wear track took 84.
const MAX_ITERATIONS: usize = 100;

/// A mean line without outliers, with its convergence.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct RobustLine {
    /// Heights of the line \[m\], one per point of the profile.
    pub heights: Vec<f64>,
    /// Convergence of the iteration.
    pub evidence: RobustEvidence,
}

/// Convergence of the iteration of a robust mean line.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct RobustEvidence {
    /// Distance from the line beyond which points are ignored.
    pub outlier_distance: Length,
    /// Fraction of the points that are ignored.
    pub ignored: f64,
    /// Number of iterations.
    pub iterations: usize,
    /// Last relative change of the outlier distance.
    pub residual: f64,
}

/// min over a, b, c of Σ s_k δ_i+k (z_i+k − a − b u − c u²)², w̄ᵢ = a,
/// δ = (1 − (r/c)²)² for |r| < c, c = 4.4478 median|r|, repeated until c converges           [Robust-1]
///
/// # Errors
/// When the cut-off is not positive, shorter than two spacings or longer than the profile, when all points around a
/// position are outliers, or when 100 iterations do not suffice, as on a trace across a wide and deep wear track.
///
/// ```
/// use asperity_core::{Profile, quantity::Length};
/// use asperity_roughness::robust_filter::robust_mean_line;
/// // A pit of 10 um in a fine wave does not change the line.
/// let wave = |i: usize| if (980..1020).contains(&i) { -10e-6 } else { 1e-7 * (0.9 * i as f64).sin() };
/// let profile = Profile::new(Length::from_si(1e-6), (0..2000).map(wave).collect())?;
/// let line = robust_mean_line(&profile, Length::from_si(0.25e-3))?;
/// assert!(line.heights[1000].abs() < 1e-8);
/// assert!(line.evidence.iterations < 30);
/// # Ok::<(), asperity_roughness::RoughnessError>(())
/// ```
pub fn robust_mean_line(profile: &Profile, cutoff: Length) -> Result<RobustLine, RoughnessError> {
    cite!("Robust-1");
    let n = profile.len();
    let points_per_cutoff = check(profile, cutoff)?;
    // The offset of a raw trace would cause rounding errors in the transform.
    let offset = profile.heights().iter().sum::<f64>() / n as f64;
    let z: Vec<f64> = profile.heights().iter().map(|z| z - offset).collect();
    // A trace that is a parabola within rounding errors has no outliers.
    let rounding = ROUNDING * z.iter().fold(0.0_f64, |m, z| m.max(z.abs()));
    let mut parabolas = LocalParabolas::new(n, &weights(n, points_per_cutoff));
    let (mut delta, mut weighted, mut line) = (vec![1.0; n], z.clone(), vec![0.0; n]);
    let (mut sizes, mut median) = (vec![0.0; n], Median::default());
    let mut distance = f64::INFINITY;
    let mut residual = f64::INFINITY;
    for iteration in 1..=MAX_ITERATIONS {
        checkpoint()?;
        let done = parabolas.heights(&delta, &weighted, &mut line);
        done.map_err(|place| RoughnessError::NoSupport {
            place: profile.spacing() * place.at as f64,
        })?;
        for (size, (z, w)) in sizes.iter_mut().zip(z.iter().zip(&line)) {
            *size = (z - w).abs();
        }
        let next = SCALE * median.of(&sizes);
        residual = ((next - distance) / next).abs();
        distance = next;
        if residual < TOLERANCE || distance <= rounding {
            let ignored = sizes.iter().filter(|size| **size > distance).count();
            return Ok(RobustLine {
                heights: line.iter().map(|w| w + offset).collect(),
                evidence: RobustEvidence {
                    outlier_distance: Length::from_si(distance),
                    ignored: ignored as f64 / n as f64,
                    iterations: iteration,
                    residual: if distance <= rounding { 0.0 } else { residual },
                },
            });
        }
        for (i, size) in sizes.iter().enumerate() {
            let weight = (1.0 - (size / distance).powi(2)).max(0.0).powi(2);
            delta[i] = weight;
            weighted[i] = weight * z[i];
        }
    }
    Err(RoughnessError::NotConverged {
        what: ROBUST_FILTER,
        iterations: MAX_ITERATIONS,
        residual,
    })
}

/// Weights s₀ .. s_m of one side, at most the length of a trace of `n` points.
fn weights(n: usize, points_per_cutoff: f64) -> Vec<f64> {
    let reach = SUPPORT * GAMMA / alpha() * points_per_cutoff;
    let m = (reach.ceil() as usize).clamp(1, n - 1);
    let weight = |k: usize| (-PI * (k as f64 / (GAMMA * points_per_cutoff)).powi(2)).exp();
    (0..=m).map(weight).collect()
}

/// λ_c/dx; the trace must be long and fine enough for the filter.
fn check(profile: &Profile, cutoff: Length) -> Result<f64, RoughnessError> {
    const RULE: &str = "must be at least two spacings";
    let dx = profile.spacing().si();
    let lc = DomainError::positive("cut-off", cutoff)?;
    DomainError::require(lc >= 2.0 * dx, "cut-off", lc, "m", RULE)?;
    if profile.len() as f64 * dx < lc {
        return Err(RoughnessError::TooShort {
            length: profile.length(),
            needed: cutoff,
            purpose: "the robust Gaussian filter",
        });
    }
    Ok(lc / dx)
}

/// Median of values that change little from call to call.
#[derive(Default)]
struct Median {
    last: f64,
    near: Vec<f64>,
}

impl Median {
    /// The median; for an even number the mean of the two middle values.
    fn of(&mut self, sizes: &[f64]) -> f64 {
        // The median changes by a few per cent between iterations; a wider window would sort more values.
        const WINDOW: f64 = 1.1;
        self.last = self
            .within(sizes, self.last / WINDOW, self.last * WINDOW)
            .or_else(|| self.within(sizes, 0.0, f64::INFINITY))
            .unwrap_or(f64::NAN);
        self.last
    }

    /// The median if it is between `low` and `high`, by selection among the values in this range.
    fn within(&mut self, sizes: &[f64], low: f64, high: f64) -> Option<f64> {
        self.near.resize(sizes.len(), 0.0);
        let (mut below, mut count) = (0, 0);
        for &size in sizes {
            // Unconditional write without a branch: `count` only advances for values in the range.
            self.near[count] = size;
            count += usize::from(size >= low && size <= high);
            below += usize::from(size < low);
        }
        let middle = (sizes.len() / 2).checked_sub(below)?;
        let even = sizes.len().is_multiple_of(2);
        if middle >= count || (even && middle == 0) {
            return None;
        }
        let near = &mut self.near[..count];
        let (lower, &mut upper, _) = near.select_nth_unstable_by(middle, f64::total_cmp);
        Some(if even {
            0.5 * (lower.iter().copied().fold(0.0, f64::max) + upper)
        } else {
            upper
        })
    }
}
