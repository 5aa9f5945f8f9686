//! Regime and load share at one mesh position and one offset.

use asperity_core::quantity::Length;
use asperity_ehl_regime::{
    AsperityShape, FilmThickness, Orientation, Regime, film_ratio, lambda_star,
};
use asperity_tribo_friction::FilmContact;

use super::chosen_laws::ChosenLaws;
use super::friction;
use super::smooth_position::SmoothPosition;
use crate::mesh::MeshPosition;
use asperity_case::case::OperatingCase;
use asperity_case::error::PositionError;
use asperity_case::flanks::{Roughness, WindowPair};
use asperity_case::formulation::FilmRegime;
use asperity_case::load_share_law::{ShareConditions, SharedLoad};
use asperity_mixed_film::LoadShareSolution;

/// The regime, what decides it, and how film and asperities share the load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Decision {
    pub lambda_star: Option<f64>,
    pub film_ratio: f64,
    pub regime: Regime,
    /// Whether the film has the friction of a full film.
    pub is_full: bool,
    pub shared: SharedLoad,
}

/// Film parameters and local contact at one offset, before the load is shared.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Undecided<'a> {
    lambda_star: Option<f64>,
    /// Λ* with the film of the load share.
    lambda_star_of_share: Option<f64>,
    film_ratio: f64,
    contact: FilmContact<'a>,
}

impl<'a> Undecided<'a> {
    /// Film parameters with this roughness.
    pub(crate) fn new(
        case: &'a OperatingCase,
        laws: &ChosenLaws,
        SmoothPosition { at: position, film }: SmoothPosition<'_>,
        roughness: &Roughness,
    ) -> Result<Self, PositionError> {
        let combined = roughness.combined_rq()?;
        let ratio = if combined.si() > 0.0 {
            film_ratio(film.film.minimum, 1.0, combined)?
        } else {
            f64::INFINITY
        };
        let star = |film: &FilmThickness| lambda_star_of(laws, position, film, roughness);
        Ok(Self {
            lambda_star: star(&film.shown)?,
            lambda_star_of_share: star(&film.film)?,
            film_ratio: ratio,
            contact: friction::film_contact(
                case,
                SmoothPosition { at: position, film },
                roughness,
                case.oil(),
            )?,
        })
    }

    /// Inputs of the load share.
    pub(crate) fn conditions<'b>(
        &'b self,
        case: &OperatingCase,
        SmoothPosition { at: position, film }: SmoothPosition<'b>,
        roughness: &'b Roughness,
        window: Option<&'b WindowPair>,
        solved: Option<&'b LoadShareSolution>,
    ) -> ShareConditions<'b> {
        ShareConditions {
            position,
            film,
            roughness,
            window,
            lambda_star: self.lambda_star_of_share,
            film_ratio: self.film_ratio,
            contact: &self.contact,
            flow_pressure: case.flow_pressure,
            solved,
        }
    }

    /// The regime, by the rule of the case.
    pub(crate) fn decided(
        &self,
        case: &OperatingCase,
        shared: SharedLoad,
    ) -> Result<Decision, PositionError> {
        let film_ratio = self.lambda_star.unwrap_or(self.film_ratio);
        let FilmRegime { regime, is_full } =
            (case.formulation).regime(shared.film_share, film_ratio)?;
        Ok(Decision {
            lambda_star: self.lambda_star,
            film_ratio: self.film_ratio,
            regime,
            is_full,
            shared,
        })
    }
}

pub(crate) fn lambda_star_of(
    laws: &ChosenLaws,
    position: &MeshPosition,
    film: &FilmThickness,
    roughness: &Roughness,
) -> Result<Option<f64>, PositionError> {
    let Some(peak) = roughness.reduced_peak.filter(|peak| *peak > 0.0) else {
        return Ok(None);
    };
    // Without a summit to measure, the asperities lift no film of their own.
    let factor = match roughness.asperity_radius {
        None => 0.0,
        Some(radius) => AsperityShape::ridges(radius, position.motion.radius)
            .film_factor(Orientation::Transverse, laws.film.speed_exponent())?,
    };
    Ok(Some(
        lambda_star(film, factor, Length::from_si(peak))?.value,
    ))
}
