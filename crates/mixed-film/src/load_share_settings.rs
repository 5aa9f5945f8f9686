//! Choices of the load share at a position.

use asperity_core::DomainError;
use asperity_core::quantity::Length;
use asperity_ehl_regime::inlet_flow::Lay;
use asperity_ehl_regime::{FilmLaw, GapLaw, ThermalLaw};
use asperity_tribo_friction::FilmSettings;
use asperity_tribo_friction::boundary::{BOUNDARY_FRICTION, BOUNDARY_LAYER, INNER_BOUNDARY};

use crate::error::LoadShareError;

/// Mean gap that the inlet supplies without asperity contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum InletSupply {
    /// More than the smooth film, by the attenuated roughness, which counts more at light load; a window has the gap under its middle.
    #[default]
    Rough,
    /// More than the smooth film by Grubin's inlet at any load, in every window by itself: what independent programs of the tests have.
    Grubin,
    /// That of a starved inlet: the film thickens as the asperities take load off it.
    Starved,
    /// The smooth film, according to Johnson, Greenwood and Poon: the share law `jgp`.
    Smooth,
}

impl InletSupply {
    /// Law of the supplied gap.
    #[must_use]
    pub const fn gap_law(self) -> GapLaw {
        match self {
            Self::Rough | Self::Grubin => GapLaw::Inlet,
            Self::Starved | Self::Smooth => GapLaw::Power,
        }
    }
}

/// Mean gap that the inlet supplies to patches: others than the computed one are for the interval of a loss.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum PatchGap {
    /// By the computed flow.
    #[default]
    Computed,
    /// This many times as wide.
    Times(f64),
    /// By the second order of the roughness over the gap, as of lines.
    SecondOrder,
}

/// Film that a touching spot carries with it. All but the default are refuted, and among the other models of a result.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum SpotSpeed {
    /// The film of the inlet until the flanks have slid past the spot; a spot that forms inside the contact has no film that flows.
    #[default]
    Carried,
    /// The film of the entrainment speed of the whole contact, in every spot.
    Entrainment,
    /// The film of half the sliding speed, in every spot.
    HalfSliding,
}

/// Central film of smooth flanks with its thermal reduction, as the formula gives it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SmoothFilm {
    /// Central film, thermal factor included.
    pub central: Length,
    /// The thermal factor in it.
    pub thermal_factor: f64,
}

/// Choices of the load share.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LoadShareSettings {
    /// Coefficient of boundary friction μ_b.
    pub boundary_friction: f64,
    /// Height of the boundary layer h_b.
    pub boundary_layer: Length,
    /// Lay of the roughness.
    pub lay: Lay,
    /// Law of the smooth film.
    pub film_law: FilmLaw,
    /// Thermal reduction of the film.
    pub thermal: ThermalLaw,
    /// Inlet supply.
    pub supply: InletSupply,
    /// Film that a touching spot carries with it.
    pub spot_speed: SpotSpeed,
    /// Least boundary share β_i of spots that form inside the contact, with [`SpotSpeed::Carried`].
    pub inner_boundary: f64,
    /// Gap supplied to patches.
    pub patch_gap: PatchGap,
    /// Factor on the asperity share after it is solved: 1, and ½ in one of the other models of a result.
    pub share_factor: f64,
    /// Nodes and heat of the film friction.
    pub film: FilmSettings,
}

impl Default for LoadShareSettings {
    fn default() -> Self {
        Self {
            boundary_friction: BOUNDARY_FRICTION,
            boundary_layer: BOUNDARY_LAYER,
            lay: Lay::GROUND,
            film_law: FilmLaw::Steady,
            thermal: ThermalLaw::Gupta,
            supply: InletSupply::Rough,
            spot_speed: SpotSpeed::default(),
            inner_boundary: INNER_BOUNDARY,
            patch_gap: PatchGap::Computed,
            share_factor: 1.0,
            film: FilmSettings::default(),
        }
    }
}

impl LoadShareSettings {
    pub(crate) fn check(&self) -> Result<(), LoadShareError> {
        let factor = self.share_factor;
        let rule = "must be above 0 and not above 1";
        let fits = factor > 0.0 && factor <= 1.0;
        DomainError::require(fits, "factor on the asperity share", factor, "-", rule)?;
        let inner = self.inner_boundary;
        let rule = "must lie between 0 and 1";
        let fits = (0.0..=1.0).contains(&inner);
        DomainError::require(fits, "boundary share of inner contacts", inner, "-", rule)?;
        Ok(())
    }
}
