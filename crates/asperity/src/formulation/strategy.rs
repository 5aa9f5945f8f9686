//! Choices that a formulation makes.

use std::fmt::Debug;

use asperity_contact::Solver;
use asperity_core::quantity::Power;
use asperity_efficiency::{LossKind, RollingSurfaces};
use asperity_gear::LoadMap;

use crate::branch::Carried;
use crate::case::Case;
use crate::decision::Decision;
use crate::encounter::Encounter;
use crate::error::PositionError;
use crate::friction::Rubbing;
use crate::full_film::FullFilm;
use crate::position::{Position, PrintedDeformation};
use crate::result::HistoryRow;
use crate::station::{Place, Station};

/// Measured flanks at one mesh position and one offset, with their regime.
pub(crate) struct Scene<'a> {
    pub case: &'a Case,
    pub station: &'a Station,
    pub encounter: &'a Encounter,
    pub decision: &'a Decision,
    /// The full film by its elastohydrodynamic solution; none for formulas and where asperities touch.
    pub full_film: Option<&'a FullFilm>,
}

/// A reading of the model.
pub(crate) trait Strategy: Debug + Send + Sync {
    /// Places along the path of contact that represent the mesh under the load of `map`.
    fn places(&self, case: &Case, map: &LoadMap) -> Result<Vec<Place>, PositionError>;

    /// Whether a single position represents the whole mesh.
    fn takes_one_position(&self) -> bool;

    /// Whether both flanks must be measured.
    fn needs_traces(&self) -> bool;

    /// Whether the losses of `case` cannot be had without solving the rough contacts.
    fn losses_need_contacts(&self, case: &Case) -> bool;

    /// Surfaces on which rolling friction is counted.
    fn rolling_surfaces(&self) -> RollingSurfaces;

    /// Whether the film carries the whole load under `decision`.
    fn is_full_film(&self, decision: &Decision) -> bool;

    /// Pressures of film and solids; `solver` is made at first need and kept for all offsets.
    fn carry(
        &self,
        scene: &Scene<'_>,
        solver: &mut Option<Solver>,
    ) -> Result<Carried, PositionError>;

    /// Way to the solution `carried`, for its report.
    fn load_path(
        &self,
        scene: &Scene<'_>,
        carried: &Carried,
        solver: &mut Option<Solver>,
    ) -> Result<Vec<HistoryRow>, PositionError>;

    /// Friction of asperities and load on the film, where the contact was solved.
    fn rubbing(&self, scene: &Scene<'_>, carried: &Carried) -> Result<Rubbing, PositionError>;

    /// Share of the load that the film carries, where the contact was solved.
    fn film_share(&self, scene: &Scene<'_>, carried: &Carried, rubbing: &Rubbing) -> f64;

    /// Deformation loss at one offset, with the friction coefficient `mu_film` in the film.
    fn deformation(
        &self,
        scene: &Scene<'_>,
        carried: &Carried,
        mu_film: f64,
    ) -> Result<PrintedDeformation, PositionError>;

    /// Losses by deformation of the mesh at one offset.
    fn deformation_losses(
        &self,
        case: &Case,
        positions: &[Position],
        offset: usize,
    ) -> Result<Vec<(LossKind, Power)>, PositionError>;
}
