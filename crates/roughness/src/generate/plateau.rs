//! Plateaus: peaks taken off a profile, as running-in and superfinishing do.

use asperity_core::quantity::Length;
use asperity_core::{DomainError, Profile};

use crate::RoughnessError;
use crate::material_ratio::abbott_curve;

/// z(x) = min(z₁(x), z₂(x))                                                  [Plateau-1]
///
/// A fine process over a coarse one gives a plateau-honed surface.
///
/// # Errors
/// When the profiles differ in spacing or number of points.
///
/// ```
/// use asperity_core::{Profile, quantity::Length};
/// use asperity_roughness::generate::lower_envelope;
/// let dx = Length::from_si(1e-6);
/// let (coarse, fine) = (Profile::new(dx, vec![-5.0, 3.0])?, Profile::new(dx, vec![0.1, -0.1])?);
/// assert_eq!(lower_envelope(&coarse, &fine)?.heights(), &[-5.0, -0.1]);
/// # Ok::<(), asperity_roughness::RoughnessError>(())
/// ```
pub fn lower_envelope(first: &Profile, second: &Profile) -> Result<Profile, RoughnessError> {
    if first.spacing() != second.spacing() {
        return Err(RoughnessError::SpacingDiffers {
            first: first.spacing(),
            second: second.spacing(),
        });
    }
    if first.len() != second.len() {
        return Err(RoughnessError::TooFewPoints {
            points: first.len().min(second.len()),
            needed: first.len().max(second.len()),
            purpose: "the lower envelope of two profiles",
        });
    }
    let least = first
        .heights()
        .iter()
        .zip(second.heights())
        .map(|(a, b)| a.min(*b))
        .collect();
    Ok(Profile::new(first.spacing(), least)?)
}

/// z(x) = min(z(x), s(Mr)), and the height taken off the highest peak               [Plateau-2]
///
/// s is the material ratio curve and Mr the share of the trace, 0 .. 1, that becomes plateau.
///
/// # Errors
/// When the share is not within 0 .. 1.
///
/// ```
/// use asperity_core::{Profile, quantity::Length};
/// use asperity_roughness::generate::truncated;
/// let ramp = Profile::new(Length::from_si(1e-6), (0..100).map(|i| f64::from(i) * 1e-8).collect())?;
/// let (plateau, removed) = truncated(&ramp, 0.2)?;
/// assert!((removed.si() - 0.2e-6).abs() < 1e-12);
/// assert!((plateau.heights()[99] - 0.79e-6).abs() < 1e-12);
/// # Ok::<(), asperity_core::DomainError>(())
/// ```
pub fn truncated(profile: &Profile, share: f64) -> Result<(Profile, Length), DomainError> {
    let rule = "must lie between 0 and 1";
    DomainError::require(
        (0.0..=1.0).contains(&share),
        "share of the plateau",
        share,
        "-",
        rule,
    )?;
    let curve = abbott_curve(profile.heights())?;
    let at = ((share * curve.len() as f64).round() as usize).min(curve.len() - 1);
    let level = curve[at];
    let cut = profile.heights().iter().map(|z| z.min(level)).collect();
    Ok((
        Profile::new(profile.spacing(), cut)?,
        Length::from_si(curve[0] - level),
    ))
}
