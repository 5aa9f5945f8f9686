//! The corrected reading: the whole path of contact, exact load shares, energies per engagement.
//!
//! The path is cut into cells with one contact each. The friction coefficient of a cell times its share of
//! the loss factor is its sliding power, so that a constant coefficient gives μ H_V exactly.

use asperity_contact::Solver;
use asperity_core::quantity::Power;
use asperity_efficiency::{LossKind, RollingSurfaces};
use asperity_gear::{LoadCell, LoadMap};

use super::strategy::{Scene, Strategy};
use crate::branch::{Carried, Mixed, full_film, load_path, mixed};
use crate::case::Case;
use crate::decision::Decision;
use crate::deformation_losses::running_in_power;
use crate::error::PositionError;
use crate::friction::Rubbing;
use crate::position::{Position, PrintedDeformation};
use crate::result::HistoryRow;
use crate::station::{Place, Resolution};

/// Strategy of [`Formulation::Corrected`](crate::case::Formulation::Corrected).
#[derive(Debug)]
pub(super) struct Corrected;

/// Share of the sliding power below which a cell stops no run.
const LIGHT_CELL: f64 = 0.01;
/// Share of the sliding power that the lightest cells may have together.
const LIGHT_CELLS: f64 = 0.02;

/// Cells that contribute so little of the loss that their contact may go unresolved.
///
/// Zones of the face divide a cell of the path, and with it what is little.
fn lightly_loaded(cells: &[LoadCell]) -> Vec<bool> {
    let zones = cells.iter().map(|cell| cell.zone + 1).max().unwrap_or(1);
    let mut order: Vec<usize> = (0..cells.len()).collect();
    order.sort_by(|&i, &j| cells[i].sliding_share.total_cmp(&cells[j].sliding_share));
    let mut light = vec![false; cells.len()];
    let mut together = 0.0;
    for index in order {
        let share = cells[index].sliding_share;
        together += share;
        light[index] = share * (zones as f64) < LIGHT_CELL || together <= LIGHT_CELLS;
    }
    light
}

fn problem<'a>(scene: &Scene<'a>) -> Mixed<'a> {
    Mixed {
        case: scene.case,
        station: scene.station,
        encounter: scene.encounter,
        film_share: scene.decision.shared.film_share,
    }
}

impl Strategy for Corrected {
    fn places(&self, case: &Case, map: &LoadMap) -> Result<Vec<Place>, PositionError> {
        let width = case.gears.face_width;
        let edges: Vec<_> = case.face_zones.iter().map(|edge| width * *edge).collect();
        let cells = map.cells_in_zones(case.model.positions, &edges)?;
        let light = lightly_loaded(&cells);
        let power = case.torque.si().abs() * case.speed.si();
        cells
            .iter()
            .zip(light)
            .map(|(cell, is_light)| {
                let sliding = case
                    .gears
                    .kinematics(cell.s, case.speed)?
                    .sliding
                    .si()
                    .abs();
                let at_its_place = cell.contact_length.si() * cell.load.si() * sliding;
                Ok(Place {
                    s: cell.s,
                    load: cell.load,
                    weight: cell.contact_length,
                    sliding_factor: cell.loss_factor * power / at_its_place,
                    resolution: if is_light {
                        Resolution::WhereFine
                    } else {
                        Resolution::Required
                    },
                    zone: cell.zone,
                })
            })
            .collect()
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

    fn is_full_film(&self, decision: &Decision) -> bool {
        decision.shared.film_share >= 1.0
    }

    fn carry(
        &self,
        scene: &Scene<'_>,
        solver: &mut Option<Solver>,
    ) -> Result<Carried, PositionError> {
        if self.is_full_film(scene.decision) {
            return full_film(scene.station, &scene.encounter.x, scene.full_film);
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

    fn deformation(
        &self,
        _: &Scene<'_>,
        _: &Carried,
        _: f64,
    ) -> Result<PrintedDeformation, PositionError> {
        Ok(PrintedDeformation::default())
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
