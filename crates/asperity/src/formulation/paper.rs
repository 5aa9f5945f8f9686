//! The paper's reading: one position for the mesh, marching to the load, deformation as printed.

use asperity_contact::Solver;
use asperity_core::quantity::Power;
use asperity_efficiency::{LossKind, RollingSurfaces};
use asperity_ehl_regime::Regime;
use asperity_gear::LoadMap;

use super::strategy::{Scene, Strategy};
use crate::branch::{Carried, full_film, march, printed_deformation_of};
use crate::case::Case;
use crate::decision::Decision;
use crate::error::PositionError;
use crate::friction::Rubbing;
use crate::position::{Position, PrintedDeformation};
use crate::result::HistoryRow;
use crate::station::{Place, Resolution};

/// Strategy of [`Formulation::Paper`](crate::case::Formulation::Paper).
#[derive(Debug)]
pub(super) struct Paper;

impl Strategy for Paper {
    fn places(&self, case: &Case, map: &LoadMap) -> Result<Vec<Place>, PositionError> {
        let path = case.gears.path();
        let s = path.a + (path.e - path.a) * case.model.position;
        let position = case.gears.single_position(s)?;
        Ok(vec![Place {
            s,
            load: map.mean_line_load(s)?,
            weight: position.weight,
            sliding_factor: 1.0,
            resolution: Resolution::Required,
            zone: 0,
        }])
    }

    fn takes_one_position(&self) -> bool {
        true
    }

    fn needs_traces(&self) -> bool {
        true
    }

    fn losses_need_contacts(&self, _: &Case) -> bool {
        true
    }

    fn rolling_surfaces(&self) -> RollingSurfaces {
        RollingSurfaces::One
    }

    fn is_full_film(&self, decision: &Decision) -> bool {
        decision.regime == Regime::FullFilm
    }

    fn carry(&self, scene: &Scene<'_>, _: &mut Option<Solver>) -> Result<Carried, PositionError> {
        if self.is_full_film(scene.decision) {
            return full_film(scene.station, &scene.encounter.x, scene.full_film);
        }
        march(scene.case, scene.station, scene.encounter)
    }

    /// The march keeps its own history.
    fn load_path(
        &self,
        _: &Scene<'_>,
        carried: &Carried,
        _: &mut Option<Solver>,
    ) -> Result<Vec<HistoryRow>, PositionError> {
        Ok(carried.history.clone())
    }

    fn rubbing(&self, scene: &Scene<'_>, carried: &Carried) -> Result<Rubbing, PositionError> {
        Rubbing::of_pressures(scene.case, scene.encounter.spacing, carried)
    }

    fn film_share(&self, scene: &Scene<'_>, carried: &Carried, rubbing: &Rubbing) -> f64 {
        // Marching does not know Λ*: its film carries what is left to it.
        match carried.solids {
            Some(_) => rubbing.film_load / scene.station.load.si(),
            None => scene.decision.shared.film_share,
        }
    }

    fn deformation(
        &self,
        scene: &Scene<'_>,
        carried: &Carried,
        mu_film: f64,
    ) -> Result<PrintedDeformation, PositionError> {
        printed_deformation_of(scene, carried, mu_film)
    }

    fn deformation_losses(
        &self,
        _: &Case,
        positions: &[Position],
        offset: usize,
    ) -> Result<Vec<(LossKind, Power)>, PositionError> {
        let kinds = [LossKind::DeformationPinion, LossKind::DeformationWheel];
        let of = |body: usize| {
            // What is left after contact: the elastic part in contact is given back.
            let power = positions
                .iter()
                .map(|position| position.offsets[offset].deformation.after_contact[body])
                .sum();
            Power::from_si(power)
        };
        Ok(kinds.into_iter().zip([of(0), of(1)]).collect())
    }
}
