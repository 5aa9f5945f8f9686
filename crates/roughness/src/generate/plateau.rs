//! Plateaus: profiles with peaks removed, as by running-in and superfinishing.

use asperity_core::cite;
use asperity_core::profile::common_spacing;
use asperity_core::quantity::Length;
use asperity_core::{DomainError, Profile};
use serde::{Deserialize, Serialize};

use super::self_affine::SelfAffine;
use crate::error::RoughnessError;
use crate::material_ratio::abbott_curve;

/// Recipe of a plateau-honed profile.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct PlateauHoned {
    /// The coarse process, which forms the valleys.
    pub coarse: SelfAffine,
    /// The fine process, which forms the plateau, with the same points and spacing.
    pub fine: SelfAffine,
    /// Depth of the mean line of the fine process below the mean line of the coarse one.
    pub depth: Length,
}

impl PlateauHoned {
    /// z(x) = min(z₁(x), z₂(x) − d), about its mean                                  `[Plateau-3]`
    ///
    /// # Errors
    /// As [`SelfAffine::generate`], and when the two differ in spacing or number of points.
    ///
    /// ```
    /// use asperity_core::quantity::Length;
    /// use asperity_roughness::generate::{Achieved, PlateauHoned, SelfAffine};
    /// let fine = SelfAffine {
    ///     points: 8192, spacing: Length::from_si(0.5e-6), rq: Length::from_si(0.05e-6), hurst: 0.8,
    ///     roll_off: Length::from_si(20e-6), short_cut: Length::from_si(5e-6), seed: 1,
    /// };
    /// let coarse = SelfAffine { rq: Length::from_si(1e-6), roll_off: Length::from_si(100e-6), seed: 2, ..fine };
    /// let profile = PlateauHoned { coarse, fine, depth: Length::from_si(0.5e-6) }.generate()?;
    /// // A flat plateau with deep valleys.
    /// assert!(Achieved::from_profile(&profile).rsk.unwrap() < -0.5);
    /// # Ok::<(), asperity_roughness::RoughnessError>(())
    /// ```
    pub fn generate(&self) -> Result<Profile, RoughnessError> {
        cite!("Plateau-3");
        let depth = DomainError::finite("depth", self.depth)?;
        let (coarse, fine) = (self.coarse.generate()?, self.fine.generate()?);
        let lowered = fine.heights().iter().map(|z| z - depth).collect();
        let lowered = Profile::new(fine.spacing(), lowered)?;
        let honed = lower_envelope(&coarse, &lowered)?;
        let mean = honed.heights().iter().sum::<f64>() / honed.len() as f64;
        let centred = honed.heights().iter().map(|z| z - mean).collect();
        Ok(Profile::new(honed.spacing(), centred)?)
    }
}

/// z(x) = min(z₁(x), z₂(x))                                                  [Plateau-1]
///
/// The lower envelope of a coarse and a fine process is a plateau-honed surface.
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
    cite!("Plateau-1");
    let (dx1, dx2) = (first.spacing(), second.spacing());
    let spacing = common_spacing(dx1, dx2).ok_or(RoughnessError::SpacingDiffers {
        first: dx1,
        second: dx2,
    })?;
    RoughnessError::at_least(
        first.len().min(second.len()),
        first.len().max(second.len()),
        "the lower envelope of two profiles",
    )?;
    let least = first
        .heights()
        .iter()
        .zip(second.heights())
        .map(|(a, b)| a.min(*b))
        .collect();
    Ok(Profile::new(spacing, least)?)
}

/// z(x) = min(z(x), s(Mr)), and the height removed from the highest peak               [Plateau-2]
///
/// s is the material ratio curve and Mr the fraction of the trace, 0 .. 1, that becomes plateau.
///
/// # Errors
/// When `share` is not within 0 .. 1.
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
    cite!("Plateau-2");
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
