//! Composite profile of two rough surfaces and its root mean square height.
//!
//! Source: equation (8) of the 2022 paper.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | z₁, z₂ | profiles of the two flanks | m |
//! | S | composite root mean square height | m |

use asperity_core::cite;
use asperity_core::profile::common_spacing;
use asperity_core::quantity::Length;
use asperity_core::{DomainError, Profile};
use serde::{Deserialize, Serialize};

use crate::error::RoughnessError;
use crate::resampling::points_after;

/// Superposition of two profiles.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
pub struct Pairing {
    /// Reverse the second profile, as for flanks that face each other.
    pub mirror_second: bool,
    /// Resample the coarser profile linearly if the spacings differ; otherwise this is an error.
    pub resample: bool,
}

/// A composite profile with a record of its construction.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Composite {
    /// z₁ + z₂ on the finer grid, as long as the shorter profile.
    #[serde(skip)]
    pub profile: Profile,
    /// Whether the second profile was reversed.
    pub mirrored: bool,
    /// Original spacing of the resampled profile; `None` without resampling.
    pub resampled_from: Option<Length>,
    /// Number of unused points of the longer profile.
    pub points_unused: usize,
}

/// z(x) = z₁(x) + z₂(x)                                                       [Composite-1]
///
/// The profiles start at their first points; the composite has the length of the shorter profile.
///
/// # Errors
/// When the spacings differ by more than [`common_spacing`] allows and `resample` is false.
///
/// ```
/// use asperity_core::{Profile, quantity::Length};
/// use asperity_roughness::composite::{Pairing, compose};
/// let dx = Length::from_si(1e-6);
/// let (first, second) = (Profile::new(dx, vec![0.0, 1.0, 2.0])?, Profile::new(dx, vec![0.0, 0.0, 5.0])?);
/// let pairing = Pairing { mirror_second: true, ..Pairing::default() };
/// assert_eq!(compose(&first, &second, pairing)?.profile.heights(), &[5.0, 1.0, 2.0]);
/// # Ok::<(), asperity_roughness::RoughnessError>(())
/// ```
pub fn compose(
    first: &Profile,
    second: &Profile,
    pairing: Pairing,
) -> Result<Composite, RoughnessError> {
    cite!("Composite-1");
    let (dx1, dx2) = (first.spacing(), second.spacing());
    let second = if pairing.mirror_second {
        second.mirrored()
    } else {
        second.clone()
    };
    let (finer, coarser) = if dx1 < dx2 { (dx1, dx2) } else { (dx2, dx1) };
    let resampled_from = match common_spacing(dx1, dx2) {
        Some(_) => None,
        None if pairing.resample => Some(coarser),
        None => {
            return Err(RoughnessError::SpacingDiffers {
                first: dx1,
                second: dx2,
            });
        }
    };
    let (first, second) = (spaced(first, finer)?, spaced(&second, finer)?);
    let sum = first
        .heights()
        .iter()
        .zip(second.heights())
        .map(|(a, b)| a + b)
        .collect();
    Ok(Composite {
        profile: Profile::new(finer, sum)?,
        mirrored: pairing.mirror_second,
        resampled_from,
        points_unused: first.len().abs_diff(second.len()),
    })
}

/// The profile on a grid of `spacing`: its own points if the spacings are equal ([`common_spacing`]), otherwise
/// linearly interpolated.
///
/// # Errors
/// As [`resampled`].
///
/// ```
/// use asperity_core::Profile;
/// use asperity_roughness::composite::spaced;
/// let profile = Profile::new("0.5 um".parse()?, vec![0.0, 1e-7, 3e-7])?;
/// assert_eq!(spaced(&profile, "0.500001 um".parse()?)?.heights(), profile.heights());
/// assert_eq!(spaced(&profile, "1 um".parse()?)?.heights(), &[0.0, 3e-7]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn spaced(profile: &Profile, spacing: Length) -> Result<Profile, DomainError> {
    match common_spacing(profile.spacing(), spacing) {
        Some(_) => Profile::new(spacing, profile.heights().to_vec()),
        None => resampled(profile, spacing),
    }
}

/// The profile on a grid of `spacing`, linearly interpolated.
///
/// # Errors
/// When the spacing is not positive, or the profile would have more than a hundred million points.
pub fn resampled(profile: &Profile, spacing: Length) -> Result<Profile, DomainError> {
    let z = profile.heights();
    let count = points_after(profile.len(), profile.spacing(), spacing)?;
    let ratio = spacing / profile.spacing();
    let at = |i: usize| {
        let position = i as f64 * ratio;
        let k = (position.floor() as usize).min(z.len().saturating_sub(2));
        let part = position - k as f64;
        let next = z.get(k + 1).copied().unwrap_or(z[k]);
        z[k] + (next - z[k]) * part
    };
    Profile::new(spacing, (0..count).map(at).collect())
}

/// S = √(Rq₁² + Rq₂²)                                                          `[P8]`
///
/// Exact for uncorrelated flanks. For correlated flanks, such as a profile and its mirror image, use the Rq of the
/// composite profile.
///
/// # Errors
/// When a height is negative or not finite.
///
/// ```
/// use asperity_core::quantity::Length;
/// use asperity_roughness::composite::combined_rq;
/// let s = combined_rq(Length::from_si(0.3e-6), Length::from_si(0.4e-6))?;
/// assert!((s.si() - 0.5e-6).abs() < 1e-20);
/// # Ok::<(), asperity_core::DomainError>(())
/// ```
pub fn combined_rq(first: Length, second: Length) -> Result<Length, DomainError> {
    cite!("P8");
    let (rq1, rq2) = (
        DomainError::non_negative("Rq1", first)?,
        DomainError::non_negative("Rq2", second)?,
    );
    Ok(Length::from_si(rq1.hypot(rq2)))
}
