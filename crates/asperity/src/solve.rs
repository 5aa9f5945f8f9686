//! One mesh position solved at every offset: regime, friction and, where asked for, contact and fields.

use asperity_contact::Solver;

use crate::case::Case;
use crate::chosen_laws::ChosenLaws;
use crate::decision::{Decision, decide};
use crate::detail::Detail;
use crate::encounter::{Encounter, meeting};
use crate::error::PositionError;
use crate::fields::fields;
use crate::formulation::{self, Scene, Strategy};
use crate::friction::{self, Rubbing};
use crate::position::{ContactNumbers, Offset, Position};
use crate::station::{Resolution, Station};
use crate::surfaces::Surfaces;

/// Everything that is the same at all positions of a run.
pub(crate) struct Run<'a> {
    pub case: &'a Case,
    pub laws: &'a ChosenLaws,
    pub surfaces: &'a Surfaces,
    pub detail: Detail,
}

impl Run<'_> {
    fn strategy(&self) -> &'static dyn Strategy {
        formulation::of(self.case.formulation)
    }

    /// Whether the rough contacts are solved.
    fn solves_contacts(&self) -> bool {
        self.detail >= Detail::Contacts || self.strategy().losses_need_contacts(self.case)
    }

    /// Solves `station` at every offset, in order.
    pub(crate) fn solve(&self, station: Station) -> Result<Position, PositionError> {
        let count = match station.resolution {
            // Every offset would give the same.
            Resolution::WholeTraces => 1,
            _ => self.surfaces.offsets(self.case.model.offsets),
        };
        let mut position = Position {
            offsets: Vec::with_capacity(count),
            fields: None,
            von_mises: None,
            station,
        };
        let mut solver = None;
        for k in 0..count {
            let offset = self.offset(&mut position, k, count, &mut solver)?;
            position.offsets.push(offset);
        }
        Ok(position)
    }

    fn offset(
        &self,
        position: &mut Position,
        k: usize,
        count: usize,
        solver: &mut Option<Solver>,
    ) -> Result<Offset, PositionError> {
        let (case, laws) = (self.case, self.laws);
        let window = case.model.window;
        let (encounter, roughness) = meeting(self.surfaces, &position.station, window, k, count)?;
        if encounter.is_none() && self.strategy().needs_traces() {
            return Err(PositionError::NoProfile);
        }
        let station = &position.station;
        let decision = decide(case, laws, station, &roughness, encounter.as_ref())?;
        let friction = friction::in_film(case, laws.friction.as_ref(), station, &roughness)?;
        let mut offset = Offset {
            roughness,
            lambda_star: decision.lambda_star,
            film_ratio: decision.film_ratio,
            regime: decision.regime,
            film_share: decision.shared.film_share,
            friction,
            rubbing: Rubbing::of_share(case, station, &decision.shared),
            friction_force: 0.0,
            flash: 0.0,
            contact: None,
            deformation: [0.0; 2],
        };
        if let Some(encounter) = encounter.filter(|_| self.solves_contacts()) {
            self.contact(position, &mut offset, &encounter, &decision, solver)
                .map_err(|error| error.keeping(&encounter.x, &encounter.gap))?;
        }
        offset.friction_force = offset.rubbing.force(offset.friction.mu);
        let station = &position.station;
        offset.flash = friction::flash(case, station, offset.friction_force / station.load.si())?;
        Ok(offset)
    }

    /// The rough contact at one offset, and the fields of the first one.
    fn contact(
        &self,
        position: &mut Position,
        offset: &mut Offset,
        encounter: &Encounter,
        decision: &Decision,
        solver: &mut Option<Solver>,
    ) -> Result<(), PositionError> {
        let strategy = self.strategy();
        let scene = Scene {
            case: self.case,
            station: &position.station,
            encounter,
            decision,
        };
        let mut carried = strategy.carry(&scene, solver)?;
        offset.rubbing = strategy.rubbing(&scene, &carried)?;
        offset.film_share = strategy.film_share(&scene, &carried, &offset.rubbing);
        offset.deformation = strategy.deformation(&scene, &carried)?;
        offset.contact = carried.solids.as_ref().map(|solids| ContactNumbers {
            contact_fraction: solids.contact_fraction,
            p_max: peak(&solids.pressure, &carried.fluid),
            plastic_work: solids.dissipated.si(),
            iterations: solids.iterations,
            // Marching stops short of the load; its last step tells by how much.
            load_error: match carried.history.last() {
                Some(step) => step.load_error,
                None => solids.certificate.load_error,
            },
            duality_gap: solids.certificate.duality_gap,
        });
        // The fields are those of the first offset.
        if self.detail == Detail::Fields && position.offsets.is_empty() {
            carried.history = strategy.load_path(&scene, &carried, solver)?;
            let found = fields(&scene, carried, offset.friction.mu)?;
            position.fields = Some(found.fields);
            position.von_mises = found.von_mises;
        }
        Ok(())
    }
}

fn peak(solid: &[f64], fluid: &[f64]) -> f64 {
    let sums = solid.iter().zip(fluid).map(|(s, f)| s + f);
    sums.fold(0.0, f64::max)
}
