//! The corrected reading: the whole path of contact, exact load shares, energies per engagement.

use asperity_contact::Solver;
use asperity_core::quantity::Power;
use asperity_efficiency::{LossKind, RollingSurfaces};
use asperity_gear::{MeshPosition, PositionRule};

use super::strategy::{Scene, Strategy};
use crate::branch::{Carried, Mixed, full_film, load_path, mixed};
use crate::case::Case;
use crate::deformation_losses::running_in_power;
use crate::error::PositionError;
use crate::friction::Rubbing;
use crate::position::Position;
use crate::result::HistoryRow;

/// Strategy of [`Formulation::Corrected`](crate::case::Formulation::Corrected).
#[derive(Debug)]
pub(super) struct Corrected;

fn problem<'a>(scene: &Scene<'a>) -> Mixed<'a> {
    Mixed {
        case: scene.case,
        station: scene.station,
        encounter: scene.encounter,
        film_share: scene.decision.shared.film_share,
    }
}

impl Strategy for Corrected {
    fn places(&self, case: &Case) -> Result<Vec<MeshPosition>, PositionError> {
        let rule = PositionRule::default();
        Ok(case.gears.positions(case.model.positions, rule)?)
    }

    fn takes_one_position(&self) -> bool {
        false
    }

    fn needs_traces(&self) -> bool {
        false
    }

    fn losses_need_contacts(&self, case: &Case) -> bool {
        case.model.include_running_in
    }

    fn rolling_surfaces(&self) -> RollingSurfaces {
        RollingSurfaces::Both
    }

    fn carry(
        &self,
        scene: &Scene<'_>,
        solver: &mut Option<Solver>,
    ) -> Result<Carried, PositionError> {
        if scene.decision.shared.film_share >= 1.0 {
            return full_film(scene.station, &scene.encounter.x);
        }
        let problem = problem(scene);
        let solver = match solver {
            Some(solver) => solver,
            None => solver.insert(problem.solver()?),
        };
        mixed(&problem, solver)
    }

    fn load_path(
        &self,
        scene: &Scene<'_>,
        carried: &Carried,
        solver: &mut Option<Solver>,
    ) -> Result<Vec<HistoryRow>, PositionError> {
        match solver {
            Some(solver) => load_path(&problem(scene), solver, carried),
            None => Ok(Vec::new()),
        }
    }

    fn rubbing(&self, scene: &Scene<'_>, _: &Carried) -> Result<Rubbing, PositionError> {
        // Exact shares rather than sums over the points of a window.
        let shared = &scene.decision.shared;
        Ok(Rubbing::of_share(scene.case, scene.station, shared))
    }

    fn film_share(&self, scene: &Scene<'_>, _: &Carried, _: &Rubbing) -> f64 {
        scene.decision.shared.film_share
    }

    fn deformation(&self, _: &Scene<'_>, _: &Carried) -> Result<[f64; 2], PositionError> {
        Ok([0.0; 2])
    }

    fn deformation_losses(
        &self,
        case: &Case,
        positions: &[Position],
        offset: usize,
    ) -> Result<Vec<(LossKind, Power)>, PositionError> {
        Ok(vec![(
            LossKind::RunningIn,
            running_in_power(case, positions, offset)?,
        )])
    }
}
