//! Recipe of any kind of surface, for files.

use asperity_core::DomainError;
use asperity_core::numerics::extremes;
use serde::{Deserialize, Serialize};

use super::achieved::{Achieved, Generated};
use super::damage::{Pits, Scratches};
use super::fitted::Fitted;
use super::ground::Ground;
use super::non_gaussian::NonGaussian;
use super::plateau::PlateauHoned;
use super::pores::Pores;
use super::self_affine::{Amplitudes, SelfAffine};
use crate::error::RoughnessError;

/// A surface to generate.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum Surface {
    /// Self-affine with roll-off and cut-offs.
    SelfAffine(SelfAffine),
    /// Given spectrum and height distribution.
    NonGaussian(NonGaussian),
    /// Plateau-honed: a coarse and a fine process.
    PlateauHoned(PlateauHoned),
    /// Ground, traced across the lay.
    Ground(Ground),
    /// Fitted to measured traces.
    Fitted(Fitted),
}

/// A surface with the modifications applied to it, in this order.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Recipe {
    /// The surface.
    pub surface: Surface,
    /// Amplitudes of a self-affine surface.
    #[serde(default)]
    pub amplitudes: Amplitudes,
    /// Added pits or micropitting.
    pub pits: Option<Pits>,
    /// Added open pores of a sintered steel.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pores: Option<Pores>,
    /// Added scratches.
    pub scratches: Option<Scratches>,
    /// Whether the result is reversed.
    #[serde(default)]
    pub mirrored: bool,
}

impl Recipe {
    /// A surface without modifications.
    pub fn from_surface(surface: Surface) -> Self {
        Self {
            surface,
            amplitudes: Amplitudes::default(),
            pits: None,
            pores: None,
            scratches: None,
            mirrored: false,
        }
    }

    /// Generates the profile and measures its parameters.
    ///
    /// # Errors
    /// When the recipe has a number outside its domain.
    ///
    /// ```
    /// use asperity_core::quantity::Length;
    /// use asperity_roughness::generate::{Recipe, SelfAffine, Surface};
    /// let spectrum = SelfAffine {
    ///     points: 4096, spacing: Length::from_si(0.5e-6), rq: Length::from_si(0.3e-6), hurst: 0.8,
    ///     roll_off: Length::from_si(100e-6), short_cut: Length::from_si(5e-6), seed: 7,
    /// };
    /// let generated = Recipe::from_surface(Surface::SelfAffine(spectrum)).generate()?;
    /// assert!((generated.achieved.rq.si() - 0.3e-6).abs() < 1e-18);
    /// # Ok::<(), asperity_roughness::RoughnessError>(())
    /// ```
    pub fn generate(&self) -> Result<Generated, RoughnessError> {
        let made = match &self.surface {
            Surface::SelfAffine(recipe) => Generated::new(recipe.generate_with(self.amplitudes)?),
            Surface::NonGaussian(recipe) => recipe.generate()?,
            Surface::PlateauHoned(recipe) => Generated::new(recipe.generate()?),
            Surface::Ground(recipe) => Generated::new(recipe.generate()?),
            Surface::Fitted(recipe) => recipe.generate()?,
        };
        let mut profile = made.profile;
        if let Some(pits) = self.pits {
            profile = pits.add_to(&profile)?;
        }
        if let Some(pores) = self.pores {
            profile = pores.add_to(&profile)?;
        }
        if let Some(scratches) = self.scratches {
            profile = scratches.add_to(&profile)?;
        }
        if self.mirrored {
            profile = profile.mirrored();
        }
        // Powers of larger heights overflow.
        const MAX_HEIGHT: f64 = 1.0;
        let (low, high) = extremes(profile.heights());
        let largest = high.max(-low);
        let rule = "must not exceed 1 m: a depth of the recipe is too large";
        DomainError::require(largest <= MAX_HEIGHT, "height", largest, "m", rule)?;
        let achieved = Achieved {
            spectrum_error: made.achieved.spectrum_error,
            iterations: made.achieved.iterations,
            ..Achieved::from_profile(&profile)
        };
        Ok(Generated { profile, achieved })
    }
}
