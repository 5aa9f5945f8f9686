//! One mesh position solved at every offset: regime, friction and, where asked for, contact and fields.

use asperity_contact::{ContactSolution, Solver};
use asperity_core::Checked;
use asperity_core::cancel::checkpoint;

use crate::case::{Case, FullFilmName};
use crate::chosen_laws::ChosenLaws;
use crate::contact_tables::{ContactTables, KeptContact};
use crate::decision::{Decision, decide};
use crate::detail::Detail;
use crate::encounter::{Encounter, meeting};
use crate::error::PositionError;
use crate::fields::fields;
use crate::formulation::{self, Scene, Strategy};
use crate::friction::{self, InFilm, Rubbing};
use crate::full_film::FullFilm;
use crate::full_film_solution::full_film_at;
use crate::local_roughness::Roughness;
use crate::physical_sense::check_station;
use crate::position::{ContactNumbers, Offset, Position, PrintedDeformation};
use crate::records::{PathRecords, RecordedShare};
use crate::rough_film::RoughFilm;
use crate::station::Station;
use crate::surfaces::Surfaces;
use asperity_mixed_film::LoadShareSolution;

/// Everything that is the same at all positions of a run.
pub(crate) struct Run<'a> {
    pub case: &'a Case,
    pub laws: &'a ChosenLaws,
    pub surfaces: &'a Surfaces,
    pub detail: Detail,
    /// Contact tables made before.
    pub tables: Option<&'a ContactTables>,
    /// Whether the contacts are kept for other constants of oil and boundary.
    pub keeps: bool,
    /// Records of mixed lubrication along the path.
    pub records: Option<&'a PathRecords>,
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
        let count = self.surfaces.offsets(self.case.model.offsets);
        let mut position = Position {
            offsets: Vec::with_capacity(count),
            fields: None,
            view: None,
            full_film: None,
            von_mises: None,
            doubts: Vec::new(),
            kept: Vec::new(),
            station,
        };
        let mut workspace = Workspace {
            solver: None,
            film: None,
            smooth: self.smooth_friction(&position.station)?,
            film_alone: None,
            recorded: None,
        };
        let records = self
            .records
            .filter(|_| self.laws.load_share.needs_records());
        let recorded = records.map(|records| records.at(position.station.s, workspace.smooth));
        workspace.recorded = recorded;
        for k in 0..count {
            checkpoint()?;
            if self.surfaces.begins_a_pair(k, count) {
                let station = &position.station;
                let (met, ..) = self.surfaces.met(station.zone, k, count);
                workspace.film = RoughFilm::at(self.case, self.laws, met, station)?;
                workspace.solver = None;
            }
            let offset = self.offset(&mut position, k, count, &mut workspace)?;
            position.offsets.push(offset);
        }
        Ok(position)
    }

    /// Checks what [`Run::solve`] checks before it solves a contact, at the first offset of each pair of teeth.
    ///
    /// # Errors
    /// When the smooth contact is beyond physical sense, or the traces do not have its windows.
    pub(crate) fn check(&self, station: &Station) -> Result<(), PositionError> {
        check_station(station)?;
        let count = self.surfaces.offsets(self.case.model.offsets);
        for k in (0..count).filter(|k| self.surfaces.begins_a_pair(*k, count)) {
            let (met, _) = meeting(self.surfaces, station, self.case.model.window, k, count)?;
            self.check_traces(met.as_ref())?;
        }
        Ok(())
    }

    /// Refuses flanks without traces where the formulation needs them.
    fn check_traces(&self, met: Option<&Encounter>) -> Result<(), PositionError> {
        match met.is_none() && self.strategy().needs_traces() {
            true => Err(PositionError::NoProfile),
            false => Ok(()),
        }
    }

    fn offset(
        &self,
        position: &mut Position,
        k: usize,
        count: usize,
        workspace: &mut Workspace<'_>,
    ) -> Result<Offset, PositionError> {
        let (case, laws) = (self.case, self.laws);
        let window = case.model.window;
        let station = &position.station;
        let kept = self.kept(station, k, workspace.film.is_some())?;
        let (encounter, roughness) = match kept {
            Some(kept) => (None, kept.roughness),
            None => meeting(self.surfaces, station, window, k, count)?,
        };
        self.check_traces(encounter.as_ref())?;
        let mut found = None;
        let solved = match (&mut workspace.film, kept, &encounter) {
            (Some(film), Some(kept), _) => {
                let meet = || {
                    let (met, _) = meeting(self.surfaces, station, window, k, count)?;
                    met.ok_or(PositionError::NoProfile)
                };
                Some(film.share_of_kept(kept, meet)?)
            }
            (Some(film), None, Some(met)) => {
                let shared = film.share(met);
                let (shared, contact) = shared.map_err(|error| error.keeping(&met.x, &met.gap))?;
                found = Some(contact);
                Some(shared)
            }
            _ => None,
        };
        if let Some(met) = encounter.as_ref().filter(|_| self.keeps) {
            let contact = KeptContact::new(met, roughness, found);
            position.kept.push(contact);
        }
        let station = &position.station;
        let solution = solved.as_ref().map(|solved| &solved.value);
        let met = encounter.as_ref();
        let recorded = workspace.recorded.as_ref();
        let decision = decide(case, laws, station, &roughness, met, solution, recorded)?;
        let is_full = self.strategy().is_full_film(&decision);
        if is_full && position.full_film.is_none() {
            position.full_film =
                full_film_at(case, &position.station, self.records, workspace.smooth)?;
        }
        let station = &position.station;
        let full_film = position.full_film.as_ref().filter(|_| is_full);
        let mut offset = Offset {
            roughness,
            lambda_star: decision.lambda_star,
            film_ratio: decision.film_ratio,
            regime: decision.regime,
            film_share: decision.shared.film_share,
            boundary_part: decision.shared.boundary_part,
            solved: solution.copied(),
            recorded: workspace.recorded,
            friction: self.in_film(
                station,
                &roughness,
                &decision,
                (full_film, solved),
                &mut workspace.film_alone,
            )?,
            rubbing: Rubbing::of_share(case, station, &decision.shared),
            friction_force: 0.0,
            flash: 0.0,
            contact: None,
            deformation: PrintedDeformation::default(),
        };
        let first = position.offsets.is_empty() && self.detail == Detail::Fields;
        let needed = first || (offset.solved.is_none() && self.solves_contacts());
        if let Some(encounter) = encounter.filter(|_| needed) {
            let solver = &mut workspace.solver;
            self.contact(position, &mut offset, &encounter, &decision, solver)
                .map_err(|error| error.keeping(&encounter.x, &encounter.gap))?;
        }
        if let Some(solved) = offset.solved.filter(|solved| solved.asperity_share > 0.0) {
            offset.contact = Some(numbers(&solved, window));
        }
        offset.friction_force = offset.rubbing.force(offset.friction.mu);
        let station = &position.station;
        offset.flash = friction::flash(case, station, offset.friction_force / station.load.si())?;
        Ok(offset)
    }

    /// The contact made before, where all that is looked at is in it: a load share of a user's own may look at
    /// the heights, and so do losses that need the contact itself.
    fn kept(
        &self,
        station: &Station,
        offset: usize,
        is_solved: bool,
    ) -> Result<Option<&KeptContact>, PositionError> {
        let named = self.case.laws.load_share.is_none();
        let heights = self.solves_contacts() || self.strategy().needs_traces();
        match self.tables {
            Some(tables) if named && (is_solved || !heights) => tables.at(station, offset),
            _ => Ok(None),
        }
    }

    /// Friction in the film: of the load share where that solved for it, by the law otherwise. That of a film alone
    /// sees no roughness, so that all offsets of a position have it from the first one.
    fn in_film(
        &self,
        station: &Station,
        roughness: &Roughness,
        decision: &Decision,
        (full_film, solved): (Option<&FullFilm>, Option<Checked<LoadShareSolution>>),
        film_alone: &mut Option<InFilm>,
    ) -> Result<InFilm, PositionError> {
        let case = self.case;
        let by_full_film = full_film.and_then(|film| film.coefficient);
        match by_full_film.or(decision.shared.film_coefficient) {
            Some(mu) if self.is_film_alone() => Ok(InFilm {
                mu: case.model.friction_scale * mu,
                outside: solved.map(|solved| solved.outside).unwrap_or_default(),
            }),
            _ => {
                if let Some(found) = film_alone.as_ref().filter(|_| self.is_film_alone()) {
                    return Ok(found.clone());
                }
                let found =
                    friction::in_film(case, self.laws.friction.as_ref(), station, roughness)?;
                Ok(film_alone.insert(found).clone())
            }
        }
    }

    /// Whether the film friction of the case is that of a film alone, which a solved film can replace.
    fn is_film_alone(&self) -> bool {
        let case = self.case;
        case.laws.friction.is_none() && case.model.film_friction.shear_law().is_some()
    }

    /// Friction coefficient of the smooth film, where records or a full film are compared with it.
    fn smooth_friction(&self, station: &Station) -> Result<Option<f64>, PositionError> {
        let is_compared =
            self.records.is_some() || self.case.model.full_film != FullFilmName::Formulas;
        match is_compared && self.is_film_alone() {
            true => friction::smooth(self.case, self.laws, self.surfaces, station).map(Some),
            false => Ok(None),
        }
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
            full_film: position.full_film.as_ref(),
        };
        let mut carried = strategy.carry(&scene, solver)?;
        offset.rubbing = strategy.rubbing(&scene, &carried)?;
        offset.film_share = strategy.film_share(&scene, &carried, &offset.rubbing);
        offset.deformation = strategy.deformation(&scene, &carried, offset.friction.mu)?;
        let doubts = carried.solids.iter().flat_map(ContactSolution::warnings);
        position.doubts.extend(doubts);
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
            position.view = Some(found.view);
            position.fields = Some(found.fields);
            position.von_mises = found.von_mises;
        }
        Ok(())
    }
}

/// Kept between the offsets of a position; solver and film between those of a pair of traces.
struct Workspace<'a> {
    solver: Option<Solver>,
    film: Option<RoughFilm<'a>>,
    /// Friction coefficient of the smooth film.
    smooth: Option<f64>,
    /// Friction in the film of the last offset, by the law of the case.
    film_alone: Option<InFilm>,
    recorded: Option<RecordedShare>,
}

/// Numbers of a contact known by its table, in a window of `window` half-widths to each side.
fn numbers(solved: &LoadShareSolution, window: f64) -> ContactNumbers {
    ContactNumbers {
        contact_fraction: solved.area / window,
        p_max: solved.max_pressure.si(),
        plastic_work: solved.dissipated.si(),
        iterations: solved.evidence.share.iterations,
        load_error: solved.evidence.load_error,
        duality_gap: solved.evidence.duality_gap,
    }
}

fn peak(solid: &[f64], fluid: &[f64]) -> f64 {
    let sums = solid.iter().zip(fluid).map(|(s, f)| s + f);
    sums.fold(0.0, f64::max)
}
