//! The robust Gaussian filter, for flanks with pits, scratches or steps.
//!
//! Source: ISO 16610-31 (local quadratic regression with Tukey's biweight).
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | s_k | weights exp(−π (k dx/(γ λ_c))²), γ = 0.7309134 | - |
//! | δ | Tukey's weight of a point | - |
//! | r | distance from the mean line | m |
//! | c | distance beyond which a point counts nothing | m |
//! | S_j, T_j | Σ s δ uʲ and Σ s δ z uʲ, u = k/m | -, m |
//!
//! The plain filter is drawn into a pit and raises false shoulders beside it; a 10 um pit makes
//! Rpk 1.0 um of 0.4 um. All sums are convolutions by fast Fourier transform, so a pass costs n log n,
//! and one 3 × 3 system is solved per point.

use std::f64::consts::PI;
use std::sync::Arc;

use asperity_core::numerics::good_fft_length;
use asperity_core::quantity::Length;
use asperity_core::{DomainError, Profile};
use nalgebra::{Matrix3, Vector3};
use realfft::num_complex::Complex;
use realfft::{ComplexToReal, RealFftPlanner, RealToComplex};
use serde::Serialize;

use crate::RoughnessError;

/// γ of ISO 16610-31: the quadratic regression then passes half the amplitude at λ_c.
const GAMMA: f64 = 0.730_913_4;
/// c = 4.4478 median|r|: three standard deviations of Gaussian residuals (ISO 16610-31).
const SCALE: f64 = 4.4478;
/// Relative change of c at which the iteration stops.
const SETTLED: f64 = 1e-8;
/// Residuals below this share of the heights are rounding of the transforms.
const ROUNDING: f64 = 1e-13;
/// Iterations allowed; damaged flanks take 17 to 28.
const MOST: usize = 100;
/// Reach of the weights in cut-offs: beyond it they are below 10⁻⁶ of the middle one, γ √(ln 10⁶/π).
const SUPPORT: f64 = 1.532_8;

/// A mean line that ignores outliers, with the evidence that it settled.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RobustLine {
    /// Heights of the line, one per point of the profile, in metres.
    pub heights: Vec<f64>,
    /// How the iteration ended.
    pub evidence: RobustEvidence,
}

/// How the iteration of a robust mean line ended.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct RobustEvidence {
    /// Distance from the line beyond which points were ignored.
    pub outlier_distance: Length,
    /// Share of the points that were ignored.
    pub ignored: f64,
    /// Iterations made.
    pub iterations: usize,
    /// Last relative change of the outlier distance.
    pub residual: f64,
}

/// min over a, b, c of Σ s_k δ_i+k (z_i+k − a − b u − c u²)², w̄ᵢ = a,
/// δ = (1 − (r/c)²)² for |r| < c, c = 4.4478 median|r|, repeated until c stands           [Robust-1]
///
/// # Errors
/// When the cut-off is not positive, shorter than two spacings or longer than the profile, when all
/// points within reach of a place are outliers, or when 100 iterations do not suffice.
///
/// ```
/// use asperity_core::{Profile, quantity::Length};
/// use asperity_roughness::robust_filter::robust_mean_line;
/// // A pit of 10 um in a fine wave leaves the line where it was.
/// let wave = |i: usize| if (980..1020).contains(&i) { -10e-6 } else { 1e-7 * (0.9 * i as f64).sin() };
/// let profile = Profile::new(Length::from_si(1e-6), (0..2000).map(wave).collect())?;
/// let line = robust_mean_line(&profile, Length::from_si(0.25e-3))?;
/// assert!(line.heights[1000].abs() < 1e-8);
/// assert!(line.evidence.iterations < 30);
/// # Ok::<(), asperity_roughness::RoughnessError>(())
/// ```
pub fn robust_mean_line(profile: &Profile, cutoff: Length) -> Result<RobustLine, RoughnessError> {
    let n = profile.len();
    let points_per_cutoff = check(profile, cutoff)?;
    // The offset of a raw trace would cost digits in the transform.
    let offset = profile.heights().iter().sum::<f64>() / n as f64;
    let z: Vec<f64> = profile.heights().iter().map(|z| z - offset).collect();
    // A trace that is a parabola but for rounding has no outliers to look for.
    let rounding = ROUNDING * z.iter().fold(0.0_f64, |m, z| m.max(z.abs()));
    let regression = Regression::new(n, points_per_cutoff);
    let mut weights = vec![1.0; n];
    let mut distance = f64::INFINITY;
    let mut residual = f64::INFINITY;
    for iteration in 1..=MOST {
        let line = regression.line(&z, &weights, profile.spacing())?;
        let r: Vec<f64> = z.iter().zip(&line).map(|(z, w)| z - w).collect();
        let next = SCALE * median_of_sizes(&r);
        residual = ((next - distance) / next).abs();
        distance = next;
        if residual < SETTLED || distance <= rounding {
            let ignored = r.iter().filter(|r| r.abs() > distance).count();
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
        for (weight, r) in weights.iter_mut().zip(&r) {
            *weight = (1.0 - (r / distance).powi(2)).max(0.0).powi(2);
        }
    }
    Err(RoughnessError::NotConverged {
        what: "the robust filter",
        iterations: MOST,
        residual,
    })
}

/// λ_c/dx, when the trace is long enough and fine enough for it.
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

fn median_of_sizes(r: &[f64]) -> f64 {
    let mut sizes: Vec<f64> = r.iter().map(|r| r.abs()).collect();
    let middle = sizes.len() / 2;
    let even = sizes.len().is_multiple_of(2);
    let (below, &mut upper, _) = sizes.select_nth_unstable_by(middle, f64::total_cmp);
    if even {
        let lower = below.iter().copied().fold(0.0, f64::max);
        0.5 * (lower + upper)
    } else {
        upper
    }
}

/// Weighted local parabolas at all points by transforms.
struct Regression {
    n: usize,
    forward: Arc<dyn RealToComplex<f64>>,
    inverse: Arc<dyn ComplexToReal<f64>>,
    /// Transforms of s_k uʲ, j = 0 .. 4.
    kernels: [Vec<Complex<f64>>; 5],
}

impl Regression {
    fn new(n: usize, points_per_cutoff: f64) -> Self {
        // Weights that reach past both ends of the trace meet no point.
        let m = ((SUPPORT * points_per_cutoff) as usize).clamp(1, n - 1);
        let length = good_fft_length(n + m);
        let mut planner = RealFftPlanner::new();
        let forward = planner.plan_fft_forward(length);
        let inverse = planner.plan_fft_inverse(length);
        let weight = |k: f64| (-PI * (k / (GAMMA * points_per_cutoff)).powi(2)).exp();
        let kernels = [0, 1, 2, 3, 4].map(|power| {
            let mut kernel = forward.make_input_vec();
            for k in 0..=m {
                let u = k as f64 / m as f64;
                let value = weight(k as f64) * u.powi(power) / length as f64;
                // Point i gathers i + k: the kernel runs backwards.
                kernel[(length - k) % length] = value;
                kernel[k] = if power % 2 == 0 || k == 0 {
                    value
                } else {
                    -value
                };
            }
            transformed(&*forward, &mut kernel)
        });
        Self {
            n,
            forward,
            inverse,
            kernels,
        }
    }

    fn line(
        &self,
        z: &[f64],
        weights: &[f64],
        spacing: Length,
    ) -> Result<Vec<f64>, RoughnessError> {
        let weighted: Vec<f64> = z
            .iter()
            .zip(weights)
            .map(|(z, weight)| z * weight)
            .collect();
        let s = self.sums(weights, 5);
        let t = self.sums(&weighted, 3);
        (0..self.n)
            .map(|i| {
                let matrix = Matrix3::from_fn(|row, column| s[row + column][i]);
                let right = Vector3::from_fn(|row, _| t[row][i]);
                let solved = matrix.cholesky().map(|factors| factors.solve(&right)[0]);
                solved.ok_or(RoughnessError::NoSupport {
                    place: spacing * i as f64,
                })
            })
            .collect()
    }

    /// Σ s_k uʲ x_i+k for j = 0 .. `count`.
    fn sums(&self, x: &[f64], count: usize) -> Vec<Vec<f64>> {
        let mut padded = self.forward.make_input_vec();
        padded[..self.n].copy_from_slice(x);
        let spectrum = transformed(&*self.forward, &mut padded);
        let convolved = |kernel: &Vec<Complex<f64>>| {
            let mut product: Vec<_> = spectrum.iter().zip(kernel).map(|(a, b)| a * b).collect();
            // The first and last coefficient of a real signal are real.
            product[0].im = 0.0;
            if let Some(last) = product.last_mut() {
                last.im = 0.0;
            }
            let mut out = self.inverse.make_output_vec();
            let done = self.inverse.process(&mut product, &mut out);
            debug_assert!(done.is_ok(), "buffers are made by the plan");
            out.truncate(self.n);
            out
        };
        self.kernels[..count].iter().map(convolved).collect()
    }
}

fn transformed(plan: &dyn RealToComplex<f64>, signal: &mut [f64]) -> Vec<Complex<f64>> {
    let mut spectrum = plan.make_output_vec();
    let done = plan.process(signal, &mut spectrum);
    debug_assert!(done.is_ok(), "buffers are made by the plan");
    spectrum
}
