//! All parameters of a prepared profile.

use asperity_core::Profile;
use asperity_core::quantity::Length;
use serde::{Deserialize, Serialize};

use crate::error::RoughnessError;
use crate::height_parameters::{HeightParameters, Mode, in_sections, sections_in};
use crate::material_ratio::{RkParameters, rk_parameters};
use crate::spectral::{SpectralMoments, moments};
use crate::warning::Warning;

/// Standard number of sections (ISO 4288).
const NORMAL_SECTIONS: usize = 5;

/// The parameters of a prepared profile.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct Parameters {
    /// Height, spacing and slope parameters, with their mode.
    pub heights: HeightParameters,
    /// Rk parameters over the whole evaluation length.
    pub material: RkParameters,
    /// Mean squares of height, slope and curvature.
    pub spectral: SpectralMoments,
    /// Section length.
    pub lambda_c: Length,
    /// Evaluation length.
    pub evaluation_length: Length,
    /// Warnings.
    pub warnings: Vec<Warning>,
}

impl Parameters {
    /// The parameters of `profile`, which must be prepared.
    ///
    /// # Errors
    /// When the profile is shorter than one `lambda_c` or has too few points.
    ///
    /// ```
    /// use asperity_core::{Profile, quantity::Length};
    /// use asperity_roughness::{Parameters, height_parameters::Mode};
    /// let wave = |i: usize| 1e-6 * (i as f64 / 100.0 * std::f64::consts::TAU).sin();
    /// let profile = Profile::new(Length::from_si(0.8e-6), (0..5000).map(wave).collect())?;
    /// let parameters = Parameters::from_profile(&profile, Mode::Iso4287, "0.8 mm".parse()?)?;
    /// assert!((parameters.material.rk.si() / 1.7747e-6 - 1.0).abs() < 0.01);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn from_profile(
        profile: &Profile,
        mode: Mode,
        lambda_c: Length,
    ) -> Result<Self, RoughnessError> {
        let mut parameters = Self::with_sections(profile, mode, sections_in(profile, lambda_c)?)?;
        parameters.lambda_c = lambda_c;
        if parameters.heights.sections < NORMAL_SECTIONS {
            parameters.warnings.push(Warning::FewSections {
                sections: parameters.heights.sections,
                lambda_c,
                length: parameters.evaluation_length,
            });
        }
        Ok(parameters)
    }

    /// The parameters of the same `profile` in another mode; only the height parameters are computed again.
    ///
    /// # Errors
    /// As [`with_sections`](Self::with_sections).
    pub fn in_mode(&self, profile: &Profile, mode: Mode) -> Result<Self, RoughnessError> {
        Ok(Self {
            heights: in_sections(profile, mode, self.heights.sections)?,
            ..self.clone()
        })
    }

    /// The parameters of `profile` divided into `sections` equal sections of any length.
    ///
    /// # Errors
    /// When `sections` is zero, or the profile has too few points.
    pub fn with_sections(
        profile: &Profile,
        mode: Mode,
        sections: usize,
    ) -> Result<Self, RoughnessError> {
        let evaluation_length = profile.spacing() * profile.len() as f64;
        Ok(Self {
            heights: in_sections(profile, mode, sections)?,
            material: rk_parameters(profile.heights())?,
            spectral: moments(profile)?,
            lambda_c: evaluation_length / sections as f64,
            evaluation_length,
            warnings: Vec::new(),
        })
    }
}
