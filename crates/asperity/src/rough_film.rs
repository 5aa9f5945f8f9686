//! Film and rough contact of one mesh position: the load share at any offset.

use asperity_contact::SolverSettings;
use asperity_core::Checked;
use asperity_core::line_contact::LineContact;
use asperity_core::quantity::{Length, Pressure};
use asperity_ehl_regime::inlet_flow::Lay;

use crate::case::{Case, Formulation};
use crate::chosen_laws::ChosenLaws;
use crate::contact_tables::{FoundContact, KeptContact};
use crate::encounter::Encounter;
use crate::error::PositionError;
use crate::station::Station;
use crate::surfaces::{Surfaces, Texture};
use asperity_mixed_film::{
    AttenuatedTraces, ContactState, ContactTable, LoadShareSettings, LoadShareSolution,
    PositionFilm, RoughContact, RoughWindow, SmoothFilm,
};

/// Loosest tolerance of the contacts that decide the loss: at 1e-4 it would move by 3e-5.
const LOOSEST_TOLERANCE: f64 = 1e-8;

/// Film of a position with the traces as its inlet leaves them.
pub(crate) struct RoughFilm<'a> {
    case: &'a Case,
    contact: LineContact,
    film: PositionFilm<'a>,
    surfaces: Surfaces,
    /// Both whole traces, once a window was cut from them.
    traces: Option<AttenuatedTraces>,
}

impl<'a> RoughFilm<'a> {
    /// The film at `station`, where the law of the load share asks for the rough contact and both flanks are
    /// measured.
    pub(crate) fn at(
        case: &'a Case,
        laws: &ChosenLaws,
        surfaces: &Surfaces,
        station: &Station,
    ) -> Result<Option<Self>, PositionError> {
        let Some(supply) = laws
            .load_share
            .supply()
            .filter(|_| is_asked_for(case, laws, surfaces))
        else {
            return Ok(None);
        };
        let Some(rheology) = &case.rheology else {
            return Ok(None);
        };
        let model = &case.model;
        let settings = LoadShareSettings {
            boundary_friction: model.boundary_friction,
            boundary_layer: model.boundary_layer,
            lay: surfaces.lay(model.lay)?,
            film_law: model.film,
            thermal: model.thermal,
            central_film: model.central_film,
            supply,
            spot_speed: model.spot_speed,
            share_factor: model.asperity_share_factor,
            ..LoadShareSettings::default()
        };
        let contact = station.line_contact(case.materials);
        let smooth = SmoothFilm {
            central: station.film.central,
            thermal_factor: station.thermal_reduction,
        };
        let film =
            PositionFilm::with_film(rheology, &contact, case.temperature, &settings, smooth)?;
        Ok(Some(Self {
            case,
            contact,
            film,
            surfaces: surfaces.clone(),
            traces: None,
        }))
    }

    /// Standard deviation of the attenuated windows that begin at `starts`.
    fn window_rms(&mut self, starts: [isize; 2], points: usize) -> Result<Length, PositionError> {
        let nabla = self.film.nabla_per_length();
        let whole = &mut self.traces;
        self.surfaces.window_rms((starts, points), nabla, whole)
    }

    /// Load share and friction of a contact kept before; of a window that stayed apart then and touches now,
    /// `meet` gives the heights.
    pub(crate) fn share_of_kept(
        &mut self,
        kept: &KeptContact,
        meet: impl FnOnce() -> Result<Encounter, PositionError>,
    ) -> Result<Checked<LoadShareSolution>, PositionError> {
        let rms = self.window_rms(kept.starts, kept.points)?;
        if let Some(table) = kept.table() {
            return Ok(self.film.share(table, rms)?);
        }
        let apart = match kept.first_touch {
            Some(first_touch) => self.film.share_apart(first_touch, rms)?,
            None => None,
        };
        if let Some(solution) = apart {
            return Ok(solution);
        }
        let met = meet()?;
        let (composite, spacing) = (met.composite(), met.spacing);
        let mut contact = rough_contact(self.case, &self.contact, &composite, spacing)?;
        let table = kept.keep(ContactTable::build(&mut contact)?);
        Ok(self.film.share(table, rms)?)
    }

    /// Load share and friction at one offset, with the contact found; it is solved unless the window stays
    /// apart.
    pub(crate) fn share(
        &mut self,
        encounter: &Encounter,
    ) -> Result<(Checked<LoadShareSolution>, FoundContact), PositionError> {
        let rms = self.window_rms(encounter.starts, encounter.x.len())?;
        let (composite, spacing) = (encounter.composite(), encounter.spacing);
        let mut contact = rough_contact(self.case, &self.contact, &composite, spacing)?;
        let first_touch = contact.first_touch_gap();
        let found = |table| FoundContact { first_touch, table };
        match self.film.share_apart(first_touch, rms)? {
            Some(solution) => Ok((solution, found(None))),
            None => {
                let table = ContactTable::build(&mut contact)?;
                Ok((self.film.share(&table, rms)?, found(Some(table))))
            }
        }
    }
}

/// Whether the load share of the case looks at the rough contact.
pub(crate) fn is_asked_for(case: &Case, laws: &ChosenLaws, surfaces: &Surfaces) -> bool {
    laws.load_share.supply().is_some()
        && case.rheology.is_some()
        && surfaces.are_measured()
        && case.formulation != Formulation::Paper
}

/// The contact of a window of heights `composite` that carries the whole load without a film.
pub(crate) fn without_film(
    case: &Case,
    station: &Station,
    composite: &[f64],
    spacing: Length,
) -> Result<ContactState, PositionError> {
    let mut contact = rough_contact(
        case,
        &station.line_contact(case.materials),
        composite,
        spacing,
    )?;
    Ok(contact.at(1.0)?)
}

/// The contact of one window at every share.
pub(crate) fn table(
    case: &Case,
    station: &Station,
    encounter: &Encounter,
) -> Result<FoundContact, PositionError> {
    let (composite, spacing) = (encounter.composite(), encounter.spacing);
    let mut contact = rough_contact(
        case,
        &station.line_contact(case.materials),
        &composite,
        spacing,
    )?;
    Ok(FoundContact {
        first_touch: contact.first_touch_gap(),
        table: Some(ContactTable::build(&mut contact)?),
    })
}

fn rough_contact(
    case: &Case,
    contact: &LineContact,
    composite: &[f64],
    spacing: Length,
) -> Result<RoughContact, PositionError> {
    let [pinion, wheel] = case.flow_pressure.map(Pressure::si);
    Ok(RoughContact::new(&RoughWindow {
        composite,
        spacing,
        load: contact.load,
        radius: contact.radius,
        modulus: contact.modulus,
        flow_pressure: Pressure::from_si(pinion.min(wheel)),
        settings: SolverSettings {
            tolerance: case.model.tolerance.min(LOOSEST_TOLERANCE),
            ..SolverSettings::default()
        },
    })?)
}

impl Surfaces {
    /// Lay of both flanks together.
    fn lay(&self, lays: [Lay; 2]) -> Result<Lay, PositionError> {
        let rq = |texture: &Texture| match texture {
            Texture::Trace(profile) => {
                let z = profile.heights();
                let n = z.len() as f64;
                let mean = z.iter().sum::<f64>() / n;
                let square = z.iter().map(|z| (z - mean).powi(2)).sum::<f64>() / n;
                Length::from_si(square.sqrt())
            }
            Texture::Values { rq, .. } => Length::from_si(*rq),
        };
        if lays[0] == lays[1] {
            return Ok(lays[0]);
        }
        let [first, second] = self.textures();
        Ok(Lay::of_pair(lays, [rq(first), rq(second)])?)
    }
}
