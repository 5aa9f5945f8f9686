//! Linear Gaussian profile filter, with the treatment of the ends of a trace.
//!
//! Source: ISO 16610-21 (weights, 50 % at the cut-off), ISO 16610-28 (ends).
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | λ_c | cut-off | m |
//! | α | √(ln 2/π) | - |
//! | s(x) | weighting function | 1/m |
//! | w_k | sampled weights, k = −m .. m, sum 1 | - |
//!
//! The weights extend to ±1.0 λ_c; with ±0.5 λ_c, which the standard permits, the error of Rq is up to 2.7 %. Sums over
//! many weights are convolutions by fast Fourier transform in blocks: n log m operations.

use std::f64::consts::{LN_2, PI};

use asperity_core::cite;
use asperity_core::numerics::SymmetricToeplitz;
use asperity_core::quantity::Length;
use asperity_core::{DomainError, Profile};
use serde::{Deserialize, Serialize};

use crate::blocks::Blocks;
use crate::error::RoughnessError;

/// Extent of the weights on either side, in cut-offs.
pub const SUPPORT: f64 = 1.0;

/// Treatment of the ends of the trace, where the weights extend beyond it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
#[non_exhaustive]
pub enum Ends {
    /// The remaining weights are normalised, and half a cut-off is dropped at both ends.
    #[default]
    Cut,
    /// The remaining weights are normalised (regression of degree 0).
    Reg0,
    /// A weighted line is fitted (regression of degree 1), which preserves straight lines up to the ends.
    Reg1,
    /// The trace is continued as its mirror image.
    Reflect,
}

/// Points per cut-off λs, which sample the weights of the filter with an error of 0.1 % (the sum of the neglected aliases).
pub(crate) const POINTS_PER_LAMBDA_S: f64 = 5.0;

/// Shortest cut-off λs of points `spacing` apart, five times that, rounded up to 0.1 µm.
#[must_use]
pub fn shortest_noise_cutoff(spacing: Length) -> Length {
    const STEPS_PER_METRE: f64 = 1e7;
    let steps = POINTS_PER_LAMBDA_S * spacing.si() * STEPS_PER_METRE;
    // Round-off adds no step.
    Length::from_si((steps * (1.0 - 1e-9)).ceil() / STEPS_PER_METRE)
}

/// α = √(ln 2/π)                                                            [Gauss-1]
///
/// With this constant the filter transmits half the amplitude at its cut-off.
///
/// ```
/// assert!((asperity_roughness::gaussian_filter::alpha() - 0.469_718_639).abs() < 1e-9);
/// ```
pub fn alpha() -> f64 {
    cite!("Gauss-1");
    (LN_2 / PI).sqrt()
}

/// a(λ) = exp(−π (α λ_c/λ)²)                                                 [Gauss-2]
///
/// Amplitude transmission of a sine of wavelength λ into the mean line: ½ at λ = λ_c, 1 for long waves.
///
/// # Errors
/// When a length is not positive.
///
/// ```
/// use asperity_core::quantity::Length;
/// use asperity_roughness::gaussian_filter::transmission;
/// let cutoff = Length::from_si(0.8e-3);
/// assert!((transmission(cutoff, cutoff)? - 0.5).abs() < 1e-15);
/// # Ok::<(), asperity_core::DomainError>(())
/// ```
pub fn transmission(wavelength: Length, cutoff: Length) -> Result<f64, DomainError> {
    cite!("Gauss-2");
    let (l, lc) = (
        DomainError::positive("wavelength", wavelength)?,
        DomainError::positive("cut-off", cutoff)?,
    );
    Ok((-PI * (alpha() * lc / l).powi(2)).exp())
}

/// s(x) = exp(−π (x/(α λ_c))²)/(α λ_c), sampled: w_k = s(k dx)/Σ s(j dx)          [Gauss-3]
///
/// The weights w₀, w₁ .. w_m of one side, m = ⌈λ_c/dx⌉.
///
/// # Errors
/// When cut-off or spacing is not positive, or the cut-off is shorter than the spacing.
///
/// ```
/// use asperity_core::quantity::Length;
/// use asperity_roughness::gaussian_filter::weights;
/// let w = weights(Length::from_si(0.8e-3), Length::from_si(0.5e-6))?;
/// assert_eq!(w.len(), 1601);
/// assert!((w[0] + 2.0 * w[1..].iter().sum::<f64>() - 1.0).abs() < 1e-14);
/// # Ok::<(), asperity_core::DomainError>(())
/// ```
pub fn weights(cutoff: Length, spacing: Length) -> Result<Vec<f64>, DomainError> {
    cite!("Gauss-3");
    // Rounding errors must not add a weight if the cut-off is a whole number of spacings.
    const ROUNDING: f64 = 1e-9;
    // 10^8 weights need 800 MB, and no trace is that long.
    const MAX_WEIGHTS: f64 = 1e8;
    let dx = DomainError::positive("spacing", spacing)?;
    let lc = DomainError::positive("cut-off", cutoff)?;
    DomainError::require(
        lc >= dx,
        "cut-off",
        lc,
        "m",
        "must not be shorter than the spacing",
    )?;
    DomainError::require(
        lc <= MAX_WEIGHTS * dx,
        "cut-off",
        lc,
        "m",
        "must not exceed 1e8 spacings",
    )?;
    let m = (SUPPORT * lc / dx - ROUNDING).ceil() as usize;
    let width = alpha() * lc;
    let mut w: Vec<f64> = (0..=m)
        .map(|k| (-PI * (k as f64 * dx / width).powi(2)).exp())
        .collect();
    let sum = w[0] + 2.0 * w[1..].iter().sum::<f64>();
    w.iter_mut().for_each(|w| *w /= sum);
    Ok(w)
}

/// The mean line of `profile` at `cutoff` `[m]`, one height per point of the profile.
///
/// ```text
/// w̄ᵢ = Σₖ w_k zᵢ₊ₖ                                                                        [Gauss-4]
/// ```
///
/// `ends` chooses the sum at the ends; [`Ends::Cut`] computes them as [`Ends::Reg0`], and
/// [`prepare`](crate::preparation::prepare) drops them.
///
/// # Errors
/// When the cut-off is not positive, shorter than the spacing or longer than the profile.
///
/// ```
/// use asperity_core::{Profile, quantity::Length};
/// use asperity_roughness::gaussian_filter::{Ends, mean_line};
/// let profile = Profile::new(Length::from_si(1e-6), vec![2e-6; 500])?;
/// let line = mean_line(&profile, Length::from_si(80e-6), Ends::Reg0)?;
/// assert!(line.iter().all(|w| (w - 2e-6).abs() < 1e-18));
/// # Ok::<(), asperity_roughness::RoughnessError>(())
/// ```
pub fn mean_line(
    profile: &Profile,
    cutoff: Length,
    ends: Ends,
) -> Result<Vec<f64>, RoughnessError> {
    cite!("Gauss-4");
    let w = weights(cutoff, profile.spacing())?;
    if profile.len() < w.len() {
        return Err(RoughnessError::TooShort {
            length: profile.length(),
            needed: cutoff,
            purpose: "the Gaussian filter",
        });
    }
    Ok(match ends {
        Ends::Cut | Ends::Reg0 => renormalised(profile.heights(), &w),
        Ends::Reg1 => regressed(profile.heights(), &w),
        Ends::Reflect => reflected(profile.heights(), &w),
    })
}

/// Gradient of a number over the heights of a trace, from its gradient `of_line` over the mean line at each point.
///
/// ```text
/// ∂J/∂z = Wᵀ ∂J/∂w̄,  w̄ = W z                                                                [Gauss-5]
/// ```
///
/// # Errors
/// As [`mean_line`] of a trace with as many points.
///
/// ```
/// use asperity_core::quantity::Length;
/// use asperity_roughness::gaussian_filter::{Ends, mean_line_gradient};
/// // The mean height of the mean line: every height inside the trace counts equally.
/// let [dx, cutoff] = [1e-6, 80e-6].map(Length::from_si);
/// let gradient = mean_line_gradient(&vec![2e-3; 500], dx, cutoff, Ends::Reflect)?;
/// assert!(gradient.iter().all(|g| (g - 2e-3).abs() < 1e-17));
/// # Ok::<(), asperity_roughness::RoughnessError>(())
/// ```
pub fn mean_line_gradient(
    of_line: &[f64],
    spacing: Length,
    cutoff: Length,
    ends: Ends,
) -> Result<Vec<f64>, RoughnessError> {
    cite!("Gauss-5");
    let w = weights(cutoff, spacing)?;
    let (n, m) = (of_line.len(), w.len() - 1);
    if n <= m {
        return Err(RoughnessError::TooShort {
            length: spacing * n.saturating_sub(1) as f64,
            needed: cutoff,
            purpose: "the Gaussian filter",
        });
    }
    let moments = FilterMoments::new(&w, n);
    Ok(match ends {
        Ends::Cut | Ends::Reg0 => {
            let over = of_line.iter().enumerate();
            let over: Vec<f64> = over.map(|(i, g)| g / moments.sum_at(i)).collect();
            convolve(&over, &w)
        }
        Ends::Reg1 => {
            // w̄ᵢ = a T₀ − b T₁ with T₁ = Σ w (x_j − xᵢ) z_j; inside the trace b is zero.
            let x = |i: usize| i as f64 - 0.5 * n as f64;
            let over = of_line.iter().enumerate().map(|(i, g)| {
                let [s0, s1, s2] = moments.at(i);
                let determinant = s0 * s2 - s1 * s1;
                if determinant > 0.0 {
                    (g * s2 / determinant, g * s1 / determinant)
                } else {
                    (g / s0, 0.0)
                }
            });
            let (a, b): (Vec<f64>, Vec<f64>) = over.unzip();
            let own: Vec<f64> = (a.iter().zip(&b).enumerate())
                .map(|(i, (a, b))| a + x(i) * b)
                .collect();
            let levered = convolve(&b, &w).into_iter().enumerate();
            let both = convolve(&own, &w).into_iter().zip(levered);
            both.map(|(own, (i, b))| own - x(i) * b).collect()
        }
        Ends::Reflect => {
            let mut extended = vec![0.0; n + 2 * m];
            extended[m..m + n].copy_from_slice(of_line);
            let sums = convolve(&extended, &w);
            let mut gradient = sums[m..m + n].to_vec();
            for k in 0..m {
                gradient[m - 1 - k] += sums[k];
                gradient[n - 1 - k] += sums[m + n + k];
            }
            gradient
        }
    })
}

/// Σ w_k zᵢ₊ₖ over the points that exist.
fn convolve(z: &[f64], w: &[f64]) -> Vec<f64> {
    convolve_above(z, 0.0, w)
}

/// Σ w_k (zᵢ₊ₖ − z₀) over the points that exist.
fn convolve_above(z: &[f64], offset: f64, w: &[f64]) -> Vec<f64> {
    // A λ_s filter has few weights; up to this number a direct sum is faster than transforms.
    const FEW: usize = 24;
    let (n, m) = (z.len(), w.len() - 1);
    let mut out = vec![0.0; n];
    let above = |z: &[f64]| z.iter().map(|z| z - offset).collect::<Vec<f64>>();
    if m <= FEW {
        summed(&above(z), w, &mut out);
        return out;
    }
    let blocks = Blocks::new(n, m);
    let mut product = SymmetricToeplitz::new(w, blocks.length - m);
    let mut piece = vec![0.0; product.size()];
    // The product pads its input by m zeros, which a block in the middle does not need.
    let step = if blocks.step < n { blocks.step - m } else { n };
    for start in (0..n).step_by(step) {
        let end = (start + step).min(n);
        // The block depends on up to m points before and after it.
        let (from, to) = (start.saturating_sub(m), (end + m).min(n));
        product.apply(&above(&z[from..to]), &mut piece);
        out[start..end].copy_from_slice(&piece[start - from..end - from]);
    }
    out
}

fn summed(z: &[f64], w: &[f64], out: &mut [f64]) {
    // Number of points per pass over the weights, so that they stay in the cache.
    const AT_ONCE: usize = 512;
    let (n, m) = (z.len(), w.len() - 1);
    let at = |i: usize| {
        let pairs = w.iter().enumerate().skip(1).map(|(k, w)| {
            let before = i.checked_sub(k).map_or(0.0, |j| z[j]);
            w * (before + z.get(i + k).copied().unwrap_or(0.0))
        });
        w[0] * z[i] + pairs.sum::<f64>()
    };
    let inside = m.min(n)..n.saturating_sub(m).max(m.min(n));
    for i in (0..inside.start).chain(inside.end..n) {
        out[i] = at(i);
    }
    for start in inside.clone().step_by(AT_ONCE) {
        let count = AT_ONCE.min(inside.end - start);
        let out = &mut out[start..start + count];
        for (out, z) in out.iter_mut().zip(&z[start..]) {
            *out = w[0] * z;
        }
        for (k, w) in w.iter().enumerate().skip(1) {
            let (before, after) = (&z[start - k..], &z[start + k..]);
            for (out, (a, b)) in out.iter_mut().zip(before.iter().zip(after)) {
                *out += w * (a + b);
            }
        }
    }
}

/// Moments Σ w kʲ of the weights over the existing points around point i.
struct FilterMoments<'a> {
    w: &'a [f64],
    /// Prefix sums of w_k, k w_k, k² w_k over k = 1 .. m.
    sums: [Vec<f64>; 3],
    n: usize,
}

impl<'a> FilterMoments<'a> {
    fn new(w: &'a [f64], n: usize) -> Self {
        let sums = [0, 1, 2].map(|power| {
            let mut total = 0.0;
            let terms = w.iter().enumerate().map(|(k, w)| {
                total += if k == 0 {
                    0.0
                } else {
                    w * (k as f64).powi(power)
                };
                total
            });
            terms.collect()
        });
        Self { w, sums, n }
    }

    /// S₀ at point `i`.
    fn sum_at(&self, i: usize) -> f64 {
        let m = self.w.len() - 1;
        let (before, after) = (i.min(m), (self.n - 1 - i).min(m));
        self.w[0] + self.sums[0][before] + self.sums[0][after]
    }

    /// S₀, S₁, S₂ at point `i`.
    fn at(&self, i: usize) -> [f64; 3] {
        let m = self.w.len() - 1;
        let (before, after) = (i.min(m), (self.n - 1 - i).min(m));
        let sum = |power: usize, reach: usize| self.sums[power][reach];
        [
            self.sum_at(i),
            sum(1, after) - sum(1, before),
            sum(2, after) + sum(2, before),
        ]
    }
}

fn renormalised(z: &[f64], w: &[f64]) -> Vec<f64> {
    // The offset of a raw trace, up to 0.1 m, would cause rounding errors in the transform.
    let offset = z.iter().sum::<f64>() / z.len() as f64;
    let moments = FilterMoments::new(w, z.len());
    let mut line = convolve_above(z, offset, w);
    for (i, w) in line.iter_mut().enumerate() {
        *w = offset + *w / moments.sum_at(i);
    }
    line
}

/// Mean line by regression of degree 1. Inside the trace S₁ = 0 and the regression equals the weighted mean, so only
/// the ends are computed again.
fn regressed(z: &[f64], w: &[f64]) -> Vec<f64> {
    let mut line = renormalised(z, w);
    let (n, m) = (z.len(), w.len() - 1);
    let reach = (2 * m).min(n);
    let corrected = regressed_start(&z[..reach], w, n);
    let count = m.min(n);
    line[..count].copy_from_slice(&corrected[..count]);
    let backwards: Vec<f64> = z[n - reach..].iter().rev().copied().collect();
    let corrected = regressed_start(&backwards, w, n);
    // In a trace shorter than two supports the ends overlap: `reach` is then n, and both sides give the same
    // regression.
    for (k, value) in corrected[..count].iter().enumerate() {
        line[n - 1 - k] = *value;
    }
    line
}

/// The regression line at the first points: (S₂ T₀ − S₁ T₁)/(S₀ S₂ − S₁²), T_j = Σ w kʲ z.
fn regressed_start(z: &[f64], w: &[f64], n: usize) -> Vec<f64> {
    let offset = z.iter().sum::<f64>() / z.len() as f64;
    let centred: Vec<f64> = z.iter().map(|z| z - offset).collect();
    // Σ w k z with k = j − i, from two symmetric sums about the middle of the piece.
    let middle = 0.5 * z.len() as f64;
    let lever: Vec<f64> = centred
        .iter()
        .enumerate()
        .map(|(j, z)| (j as f64 - middle) * z)
        .collect();
    let (t0, levered) = (convolve(&centred, w), convolve(&lever, w));
    let moments = FilterMoments::new(w, n);
    let count = (w.len() - 1).min(z.len());
    (0..count)
        .map(|i| {
            let [s0, s1, s2] = moments.at(i);
            let t1 = levered[i] - (i as f64 - middle) * t0[i];
            let determinant = s0 * s2 - s1 * s1;
            offset
                + if determinant > 0.0 {
                    (s2 * t0[i] - s1 * t1) / determinant
                } else {
                    t0[i] / s0
                }
        })
        .collect()
}

fn reflected(z: &[f64], w: &[f64]) -> Vec<f64> {
    let (n, m) = (z.len(), w.len() - 1);
    let offset = z.iter().sum::<f64>() / n as f64;
    let before = z[..m.min(n)].iter().rev();
    let after = z[n - m.min(n)..].iter().rev();
    let extended: Vec<f64> = before.chain(z).chain(after).map(|z| z - offset).collect();
    let sums = convolve(&extended, w);
    sums[m.min(n)..m.min(n) + n]
        .iter()
        .map(|t0| offset + t0)
        .collect()
}
