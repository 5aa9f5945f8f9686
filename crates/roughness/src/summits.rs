//! Radius of the load-carrying asperities, for the lubrication regime.
//!
//! Source: Hansen, Björling, Larsson 2021 (film over a single asperity); Nayak 1971 (spectral estimate).
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | z | composite profile, filtered at λ_s | m |
//! | κ | curvature of a summit, by a least-squares parabola over ±λ_s | 1/m |
//! | R_xa | asperity radius along the trace, 1/⟨κ⟩ | m |
//!
//! A summit is a local maximum (a plateau is one summit at its middle). The load-carrying summits are those above the
//! core, c(0) of the Rk line. If they are fewer than five, the summits above the mean line are used, which
//! [`AsperityRadius::level`] reports.

use asperity_core::cite;
use asperity_core::quantity::Length;
use asperity_core::{DomainError, Profile};
use serde::{Deserialize, Serialize};

use crate::error::RoughnessError;
use crate::material_ratio::rk_parameters;
use crate::spectral::{gaussian_summit_curvature, moments};

/// Minimum number of summits in the peak zone.
const MIN_SUMMITS: usize = 5;

/// Reference level for the selection of summits.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum ReferenceLevel {
    /// Above c(0) of the Rk line, the top of the core.
    PeakZone,
    /// Above the mean line, because fewer than five summits reach the peak zone.
    MeanLine,
}

/// Asperity radius with the details of its computation.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct AsperityRadius {
    /// R_xa, the reciprocal of the mean curvature.
    pub radius: Length,
    /// Number of summits.
    pub count: usize,
    /// Points of the curvature window on either side of a summit.
    pub window_points: usize,
    /// Half width of the curvature window.
    pub window: Length,
    /// Reference level of the summits.
    pub level: ReferenceLevel,
    /// Height of the reference level in the profile.
    pub level_height: Length,
    /// 1/√(π m₄/2): radius of a Gaussian profile of the same m₄.
    pub spectral_radius: Length,
}

/// R_xa = 1/⟨κ⟩ over the summits in the peak zone                     [Summit-1]
///
/// `composite` must be filtered at `lambda_s`; κ is computed over ±λ_s. Summits closer than λ_s to an end are omitted.
///
/// # Errors
/// When λ_s is shorter than half the spacing, there is no summit, or the mean curvature is not positive.
///
/// ```
/// use asperity_core::{Profile, quantity::Length};
/// use asperity_roughness::summits::asperity_radius;
/// // Parabolic ridges of radius 50 um, 40 um apart.
/// let ridge = |i: usize| { let x = ((i % 80) as f64 - 40.0) * 0.5e-6; -x * x / 100e-6 };
/// let profile = Profile::new(Length::from_si(0.5e-6), (0..8000).map(ridge).collect())?;
/// let asperities = asperity_radius(&profile, Length::from_si(2.5e-6))?;
/// assert!((asperities.radius.si() - 50e-6).abs() < 1e-12);
/// # Ok::<(), asperity_roughness::RoughnessError>(())
/// ```
pub fn asperity_radius(
    composite: &Profile,
    lambda_s: Length,
) -> Result<AsperityRadius, RoughnessError> {
    cite!("Summit-1");
    let (z, dx) = (composite.heights(), composite.spacing().si());
    let window = DomainError::positive("lambda_s", lambda_s)?;
    DomainError::require(
        window >= 0.5 * dx,
        "lambda_s",
        window,
        "m",
        "must not be shorter than half the spacing",
    )?;
    let m = (window / dx).round() as usize;
    let spectral = gaussian_summit_curvature(moments(composite)?.m4)?;
    let all = summits(z, m);
    let (level, level_height, chosen) = carrying(z, &all)?;
    if chosen.is_empty() {
        return Err(RoughnessError::NoSummit {
            window: lambda_s,
            level: "mean line",
        });
    }
    let total: f64 = chosen
        .iter()
        .map(|&i| parabola_curvature(&z[i - m..=i + m], dx))
        .sum();
    let curvature = total / chosen.len() as f64;
    if curvature <= 0.0 {
        return Err(RoughnessError::NoRadius {
            count: chosen.len(),
            curvature,
        });
    }
    Ok(AsperityRadius {
        radius: Length::from_si(1.0 / curvature),
        count: chosen.len(),
        window_points: m,
        window: lambda_s,
        level,
        level_height: Length::from_si(level_height),
        spectral_radius: Length::from_si(1.0 / spectral),
    })
}

/// Statistics of the summits of a profile.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct SummitStatistics {
    /// Number of summits, without those within a window of an end.
    pub count: usize,
    /// Number of summits per length [1/m].
    pub density: f64,
    /// Mean height of the summits above the mean line.
    pub mean_height: Length,
    /// Standard deviation of the heights of the summits.
    pub height_deviation: Length,
    /// Mean curvature [1/m], by a least-squares parabola.
    pub mean_curvature: f64,
    /// Reciprocal of the mean curvature; `None` if the mean curvature is not positive.
    pub mean_radius: Option<Length>,
    /// √(m₄/m₂)/(2π), the density [1/m] of a Gaussian profile of the same moments.
    pub spectral_density: f64,
}

/// D = √(m₄/m₂)/(2π) for a Gaussian profile                `[Summit-3]`
///
/// Statistics of all summits, whatever their height; κ is computed over ±`window`.
///
/// # Errors
/// When the window is shorter than half the spacing, or there is no summit.
///
/// ```
/// use asperity_core::{Profile, quantity::Length};
/// use asperity_roughness::summits::summit_statistics;
/// let wave = |i: usize| 1e-6 * (i as f64 / 100.0 * std::f64::consts::TAU).sin();
/// let profile = Profile::new(Length::from_si(0.5e-6), (0..20_000).map(wave).collect())?;
/// let statistics = summit_statistics(&profile, Length::from_si(0.5e-6))?;
/// assert_eq!(statistics.count, 200);
/// assert!((statistics.density * 50e-6 - 1.0).abs() < 0.01);
/// # Ok::<(), asperity_roughness::RoughnessError>(())
/// ```
pub fn summit_statistics(
    profile: &Profile,
    window: Length,
) -> Result<SummitStatistics, RoughnessError> {
    cite!("Summit-3");
    let (z, dx) = (profile.heights(), profile.spacing().si());
    let m = window_points(window, dx)?;
    let all = summits(z, m);
    if all.is_empty() {
        return Err(RoughnessError::NoSummit {
            window,
            level: "lowest point",
        });
    }
    let count = all.len() as f64;
    let mean = z.iter().sum::<f64>() / z.len() as f64;
    let height = all.iter().map(|&i| z[i]).sum::<f64>() / count;
    let variance = all.iter().map(|&i| (z[i] - height).powi(2)).sum::<f64>() / count;
    let curvature = |&i: &usize| parabola_curvature(&z[i - m..=i + m], dx);
    let curvature = all.iter().map(curvature).sum::<f64>() / count;
    let moments = moments(profile)?;
    Ok(SummitStatistics {
        count: all.len(),
        density: count / ((z.len() - 2 * m) as f64 * dx),
        mean_height: Length::from_si(height - mean),
        height_deviation: Length::from_si(variance.sqrt()),
        mean_curvature: curvature,
        mean_radius: (curvature > 0.0).then(|| Length::from_si(1.0 / curvature)),
        spectral_density: (moments.m4 / moments.m2).sqrt() / std::f64::consts::TAU,
    })
}

/// Number of points of a curvature window on either side.
fn window_points(window: Length, dx: f64) -> Result<usize, RoughnessError> {
    let window = DomainError::positive("window", window)?;
    DomainError::require(
        window >= 0.5 * dx,
        "window",
        window,
        "m",
        "must not be shorter than half the spacing",
    )?;
    Ok((window / dx).round() as usize)
}

/// The load-carrying summits: those in the peak zone, or above the mean line if they are too few; with the reference
/// level.
fn carrying(z: &[f64], all: &[usize]) -> Result<(ReferenceLevel, f64, Vec<usize>), RoughnessError> {
    let above = |level: f64| {
        all.iter()
            .copied()
            .filter(|&i| z[i] > level)
            .collect::<Vec<_>>()
    };
    let core_top = rk_parameters(z)?.upper.si();
    let in_peak_zone = above(core_top);
    if in_peak_zone.len() >= MIN_SUMMITS {
        return Ok((ReferenceLevel::PeakZone, core_top, in_peak_zone));
    }
    let mean = z.iter().sum::<f64>() / z.len() as f64;
    Ok((ReferenceLevel::MeanLine, mean, above(mean)))
}

/// Indices of local maxima at least `margin` points from the ends; for a plateau the index of its middle.
fn summits(z: &[f64], margin: usize) -> Vec<usize> {
    let mut summits = Vec::new();
    let mut rise = None;
    for i in 1..z.len() {
        if z[i] > z[i - 1] {
            rise = Some(i);
        } else if z[i] < z[i - 1]
            && let Some(start) = rise.take()
        {
            let middle = (start + i - 1) / 2;
            if middle >= margin && middle + margin < z.len() {
                summits.push(middle);
            }
        }
    }
    summits
}

/// κ = −2 c₂ of the least-squares parabola c₀ + c₁ x + c₂ x² through 2m + 1 even points     [Summit-2]
fn parabola_curvature(z: &[f64], dx: f64) -> f64 {
    cite!("Summit-2");
    let m = (z.len() / 2) as f64;
    let count = z.len() as f64;
    // ⟨k²⟩ for k in points from the middle.
    let mean_square = m * (m + 1.0) / 3.0;
    let (mut product, mut norm) = (0.0, 0.0);
    let middle = z.iter().sum::<f64>() / count;
    for (i, z) in z.iter().enumerate() {
        let k = i as f64 - m;
        let p = k * k - mean_square;
        product += (z - middle) * p;
        norm += p * p;
    }
    -2.0 * product / norm / (dx * dx)
}
