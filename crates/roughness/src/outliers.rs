//! Detection and replacement of outliers, with a record.
//!
//! Source: Hampel 1974 (distance from a running median in units of the median deviation).
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | z̃ᵢ | median over ±w points | m |
//! | d | 1.4826 · median of \|z − z̃ᵢ\| over the same points, a robust standard deviation | m |
//!
//! The minimum of d is its median over the profile, so that points in flat regions are not replaced. Dust and lost
//! light cause spikes of a few points. A pit or scratch is wider than the window, so the median follows it and it
//! remains. Towards the ends the window narrows symmetrically; the outermost points are never replaced.

use asperity_core::cite;
use asperity_core::numerics::{median, median_in_place};
use asperity_core::profile::WIDEST_SPIKE;
use asperity_core::quantity::Length;
use asperity_core::{DomainError, Profile};
use serde::{Deserialize, Serialize};

use crate::error::RoughnessError;
use crate::warning::Warning;

/// Standard deviation of normally distributed heights divided by their median deviation.
const NORMAL: f64 = 1.4826;
/// Maximum half window: the cost of the running median is points times window.
const MAX_HALF_WINDOW: usize = 1000;

/// Criterion for outliers.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Outliers {
    /// Distance from the running median in robust standard deviations beyond which a point is replaced.
    pub deviations: f64,
    /// Points on either side in the running median: the maximum width of detected spikes.
    pub half_window: usize,
}

impl Outliers {
    /// Criterion for points farther than `deviations`, for spikes of up to [`WIDEST_SPIKE`] points.
    pub fn beyond(deviations: f64) -> Self {
        Self {
            deviations,
            half_window: WIDEST_SPIKE,
        }
    }
}

/// Record of the replaced points.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct OutlierRecord {
    /// The criterion.
    pub rule: Outliers,
    /// Number of replaced points.
    pub replaced: usize,
    /// Longest run of replaced points.
    pub longest: usize,
    /// Largest distance of a replaced point from the running median.
    pub farthest: Length,
    /// Minimum distance of a replaced point in regions with the median d.
    pub threshold: Length,
}

impl OutlierRecord {
    /// Warning about the replaced points; `None` if there are none.
    pub fn warning(&self) -> Option<Warning> {
        (self.replaced > 0).then_some(Warning::OutliersReplaced {
            points: self.replaced,
            longest: self.longest,
            farthest: self.farthest,
        })
    }
}

/// zᵢ ← linear interpolation between its neighbours, where |zᵢ − z̃ᵢ| > k d                     `[Outlier-1]`
///
/// # Errors
/// When the deviations are not positive or the window is wider than the profile.
///
/// ```
/// use asperity_core::{Profile, quantity::Length};
/// use asperity_roughness::outliers::{Outliers, replace};
/// let mut z: Vec<f64> = (0..1000).map(|i| 1e-7 * (0.05 * f64::from(i)).sin() + 2e-9 * f64::from(7919 * i % 13)).collect();
/// z[500] = 20e-6;
/// let profile = Profile::new(Length::from_si(1e-6), z)?;
/// let (cleaned, record) = replace(&profile, Outliers { deviations: 6.0, half_window: 5 })?;
/// assert_eq!((record.replaced, record.longest), (1, 1));
/// assert!((cleaned.heights()[500] - 1e-7 * 25f64.sin()).abs() < 30e-9);
/// # Ok::<(), asperity_roughness::RoughnessError>(())
/// ```
pub fn replace(
    profile: &Profile,
    rule: Outliers,
) -> Result<(Profile, OutlierRecord), RoughnessError> {
    cite!("Outlier-1");
    let z = profile.heights();
    let k = rule.deviations;
    DomainError::require(
        k > 0.0 && k.is_finite(),
        "deviations",
        k,
        "-",
        "must be positive",
    )?;
    let w = rule.half_window;
    DomainError::require(
        (1..=MAX_HALF_WINDOW).contains(&w) && 2 * w < z.len(),
        "half window",
        w as f64,
        "points",
        "must lie between 1 and 1000 and fit into the profile",
    )?;
    let (distances, deviations) = distances(z, w);
    let floor = median(deviations.iter().copied()).unwrap_or_default();
    let threshold = |i: usize| k * NORMAL * deviations[i].max(floor);
    let outlier = |i: usize| distances[i] > threshold(i);
    let (mut cleaned, mut longest, mut replaced) = (z.to_vec(), 0, 0);
    let mut start = 0;
    while start < z.len() {
        if !outlier(start) {
            start += 1;
            continue;
        }
        let length = (start..z.len()).take_while(|&i| outlier(i)).count();
        bridge(&mut cleaned, start, length);
        replaced += length;
        longest = longest.max(length);
        start += length;
    }
    let far = (0..z.len()).filter(|&i| outlier(i)).map(|i| distances[i]);
    let record = OutlierRecord {
        rule,
        replaced,
        longest,
        farthest: Length::from_si(far.fold(0.0, f64::max)),
        threshold: Length::from_si(k * NORMAL * floor),
    };
    Ok((Profile::new(profile.spacing(), cleaned)?, record))
}

/// Distance of every point from its running median, and the median deviation of its window.
fn distances(z: &[f64], half_window: usize) -> (Vec<f64>, Vec<f64>) {
    let mut window = Vec::with_capacity(2 * half_window + 1);
    (0..z.len())
        .map(|i| {
            window.clear();
            // With a one-sided window slopes at the ends would be detected as spikes.
            let w = half_window.min(i).min(z.len() - 1 - i);
            window.extend_from_slice(&z[i - w..=i + w]);
            // A window is never empty.
            let middle = median_in_place(&mut window).unwrap_or_default();
            window.iter_mut().for_each(|z| *z = (*z - middle).abs());
            let deviation = median_in_place(&mut window).unwrap_or_default();
            ((z[i] - middle).abs(), deviation)
        })
        .unzip()
}

/// Replaces `length` points from `start` by a straight line; by a constant at an end of the profile.
fn bridge(z: &mut [f64], start: usize, length: usize) {
    let before = start.checked_sub(1).map(|at| z[at]);
    let after = z.get(start + length).copied();
    let (Some(from), Some(to)) = (before.or(after), after.or(before)) else {
        return;
    };
    for (step, z) in z[start..start + length].iter_mut().enumerate() {
        *z = from + (to - from) * (step + 1) as f64 / (length + 1) as f64;
    }
}
