//! The friction laws a case file can name.
//!
//! | name | law | local or whole mesh | roughness by |
//! |---|---|---|---|
//! | `xu` | [`xu`](crate::xu) | local | S |
//! | `benedict-kelley` | [`benedict_kelley`] | local | Ra |
//! | `iso-14179-1` | [`iso_14179_1`] | whole mesh | - |
//! | `iso-14179-2` | [`iso_14179_2`], Schlenk | whole mesh | Ra |
//! | `matsumoto` | [`matsumoto`] | local | Rz |
//! | `doleschel` | [`doleschel`] | local | Ra |
//! | `eyring` | [`eyring`], full film | local | - |
//! | `constant` | the setting `constant` | whole mesh | - |
//!
//! A whole-mesh law gives the same coefficient at every position. `matsumoto` and `doleschel`
//! share the load between the boundary coefficient and a fluid one: the setting
//! `fluid_coefficient`, or Eyring's when there is none.

use asperity_core::{Checked, DomainError};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::benedict_kelley::{self, BenedictKelleyConditions};
use crate::conditions::FrictionConditions;
use crate::error::FrictionError;
use crate::eyring::{self, EyringConditions};
use crate::xu::{XuConditions, XuLaw};
use crate::{doleschel, iso_14179_1, iso_14179_2, matsumoto};

/// Law of the friction coefficient.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum FrictionLaw {
    /// Xu 2005: regression of thermal mixed EHL solutions.
    #[default]
    Xu,
    /// Benedict and Kelley 1961: roller tests.
    BenedictKelley,
    /// ISO/TR 14179-1: one coefficient for the mesh.
    #[serde(rename = "iso-14179-1")]
    Iso14179Part1,
    /// ISO/TR 14179-2 (Schlenk 1994): one coefficient for the mesh.
    #[serde(rename = "iso-14179-2")]
    Iso14179Part2,
    /// Matsumoto and Morikawa 2014: load sharing by maximum heights.
    Matsumoto,
    /// Doleschel 2002: load sharing by the film ratio.
    Doleschel,
    /// Eyring with a limiting shear stress: fluid friction of a full film.
    Eyring,
    /// A given constant.
    Constant,
}

/// Choices that the laws leave open.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct FrictionSettings {
    /// Coefficients and choices of Xu's law.
    pub xu: XuLaw,
    /// The coefficient of the law `constant`.
    pub constant: Option<f64>,
    /// Fluid coefficient of `matsumoto` and `doleschel`; Eyring's when there is none.
    pub fluid_coefficient: Option<f64>,
    /// Limiting shear stress over pressure of the oil.
    pub limiting_stress: f64,
}

impl Default for FrictionSettings {
    fn default() -> Self {
        Self {
            xu: XuLaw::default(),
            constant: None,
            fluid_coefficient: None,
            limiting_stress: eyring::MINERAL_OIL_LIMIT,
        }
    }
}

impl FrictionLaw {
    /// Every law, in the order of the table above.
    pub const ALL: [Self; 8] = [
        Self::Xu,
        Self::BenedictKelley,
        Self::Iso14179Part1,
        Self::Iso14179Part2,
        Self::Matsumoto,
        Self::Doleschel,
        Self::Eyring,
        Self::Constant,
    ];

    /// The name in a case file.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Xu => "xu",
            Self::BenedictKelley => "benedict-kelley",
            Self::Iso14179Part1 => "iso-14179-1",
            Self::Iso14179Part2 => "iso-14179-2",
            Self::Matsumoto => "matsumoto",
            Self::Doleschel => "doleschel",
            Self::Eyring => "eyring",
            Self::Constant => "constant",
        }
    }

    /// The friction coefficient at one mesh position.
    ///
    /// Without sliding `benedict-kelley` gives 0: its logarithm diverges there, but no sliding
    /// friction does work, and μ V_s → 0 is what the losses need.
    ///
    /// # Errors
    /// When an input that the law reads is outside its domain or a setting is missing.
    pub fn coefficient(
        self,
        settings: &FrictionSettings,
        position: &FrictionConditions,
    ) -> Result<Checked<f64>, FrictionError> {
        match self {
            Self::Xu => settings.xu.coefficient(&XuConditions {
                slide_to_roll: position.slide_to_roll()?,
                max_pressure: position.max_pressure,
                viscosity: position.viscosity,
                entrainment: position.entrainment,
                radius: position.radius,
                combined_roughness: position.combined_roughness,
            }),
            Self::BenedictKelley if position.sliding.si() == 0.0 => Ok(Checked::inside(0.0)),
            Self::BenedictKelley => benedict_kelley::coefficient(&BenedictKelleyConditions {
                load: position.load,
                viscosity: position.viscosity,
                sliding: position.sliding,
                sum_speed: position.entrainment * 2.0,
                mean_ra: position.mean_ra,
            }),
            Self::Iso14179Part1 => iso_14179_1::coefficient(
                position.kinematic_viscosity,
                position.mesh.load_intensity,
                position.mesh.pitch_line_speed,
            ),
            Self::Iso14179Part2 => {
                iso_14179_2::coefficient(&position.mesh, position.viscosity, position.mean_ra)
            }
            Self::Matsumoto => {
                let fluid = fluid_coefficient(settings, position)?;
                let boundary = position.boundary_coefficient;
                let (film, rz) = (position.minimum_film, position.sum_rz);
                let value = matsumoto::coefficient(film, rz, fluid.value, boundary)?;
                Ok(fluid.map(|_| value))
            }
            Self::Doleschel => {
                let fluid = fluid_coefficient(settings, position)?;
                let boundary = position.boundary_coefficient;
                let (film, ra) = (position.central_film, position.mean_ra);
                let value = doleschel::coefficient(film, ra, fluid.value, boundary)?;
                Ok(fluid.map(|_| value))
            }
            Self::Eyring => eyring_coefficient(settings, position),
            Self::Constant => constant(settings),
        }
    }
}

fn constant(settings: &FrictionSettings) -> Result<Checked<f64>, FrictionError> {
    let value = settings.constant.ok_or(FrictionError::MissingSetting {
        law: FrictionLaw::Constant.name(),
        setting: "constant",
    })?;
    let rule = "must be finite and not negative";
    let valid = value.is_finite() && value >= 0.0;
    let value = DomainError::require(valid, "constant friction coefficient", value, "-", rule)?;
    Ok(Checked::inside(value))
}

fn fluid_coefficient(
    settings: &FrictionSettings,
    position: &FrictionConditions,
) -> Result<Checked<f64>, FrictionError> {
    match settings.fluid_coefficient {
        Some(value) => Ok(Checked::inside(value)),
        None => eyring_coefficient(settings, position),
    }
}

fn eyring_coefficient(
    settings: &FrictionSettings,
    position: &FrictionConditions,
) -> Result<Checked<f64>, FrictionError> {
    eyring::coefficient(&EyringConditions {
        max_pressure: position.max_pressure,
        contact_viscosity: position.contact_viscosity,
        pressure_viscosity: position.pressure_viscosity,
        sliding: position.sliding,
        central_film: position.central_film,
        limiting_stress: settings.limiting_stress,
    })
}
