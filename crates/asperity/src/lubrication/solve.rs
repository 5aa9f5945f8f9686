//! One mesh position at one operating point: film, load share and friction of every window.
//!
//! 1. The formulas give the smooth film of the position.
//! 2. In every window the rough contact under that film gives the share of the asperities ([`RoughFilm::share`]), unless a law of
//!    the load share replaces it.
//! 3. The law of the load share turns this into the shares of film and boundary layer and into a regime ([`LubricatedMesh::decided`]).
//! 4. The friction of the film comes from a solved full film, from the share, or from the law of film friction.
//! 5. Forces follow from shares and coefficients, and from the forces the flash temperature.
//!
//! A formulation with pressures of its own ([`WindowPressures`]) has no share by the contact: its pressures replace what step 3
//! gives to friction, film share and deformation of a window ([`LubricatedMesh::press_by_law`]).

use std::sync::Arc;

use asperity_contact::{ContactSolution, ContactWarning};
use asperity_core::Checked;
use asperity_core::cancel::checkpoint;
use asperity_ehl_regime::inlet_flow::LARGEST_SHARE;
use asperity_mixed_film::{Kinks, LoadShareSolution, Unflattening, WindowGradient};

use super::chosen_laws::ChosenLaws;
use super::decision::{Decision, Undecided};
use super::friction::{self, InFilm, Rubbing};
use super::full_film::FullFilm;
use super::full_film_solution::full_film_at;
use super::plausibility::{check_position, plausible_film};
use super::position::{ContactNumbers, LubricatedPosition, LubricatedWindow};
use super::rough_film::RoughFilm;
use super::smooth_position::SmoothPosition;
use crate::contacts::{Pressing, WindowContact};
use crate::mesh::MeshPosition;
use crate::records::{PathRecords, RecordedShare};
use asperity_case::case::{FullFilmName, OperatingCase, ShareLaw};
use asperity_case::error::PositionError;
use asperity_case::flanks::{OffsetIndex, Surfaces, WindowPair};
use asperity_case::formula_film::FormulaFilm;
use asperity_case::window_pressures::{Pressed, WindowConditions, WindowPressures};

/// Regime and load share in one window.
struct Decided {
    /// The rough contact at its share, if the load share depends on it.
    share: Option<Checked<LoadShareSolution>>,
    decision: Decision,
}

/// Gradient of the sliding loss at a position.
#[derive(Debug, Clone)]
pub(crate) struct PositionGradient {
    /// Over the sums of both traces in the window of each offset; `None` of a window that does not depend on them.
    pub windows: Vec<Option<WindowGradient>>,
    /// From these to the heights of the whole traces.
    pub unflattening: Unflattening,
    /// Kinks of the windows.
    pub kinks: Kinks,
}

/// Everything that is the same at all positions.
#[derive(Clone, Copy)]
pub(crate) struct LubricatedMesh<'a> {
    pub case: &'a OperatingCase,
    pub laws: &'a ChosenLaws,
    pub surfaces: &'a Surfaces,
    /// Reference solutions along the path.
    pub records: Option<&'a PathRecords>,
}

impl LubricatedMesh<'_> {
    /// Film, load share and friction at `at` in every window of `contacts`.
    ///
    /// # Errors
    /// When a law refuses the numbers, a contact has no solution, or a number is physically impossible.
    pub(crate) fn position(
        &self,
        at: &MeshPosition,
        contacts: &[Arc<WindowContact>],
    ) -> Result<LubricatedPosition, PositionError> {
        let film = plausible_film(self.case, at)?;
        let of_position = SmoothPosition { at, film: &film };
        let smooth = self.smooth_friction(of_position)?;
        let records = self.records_of_share();
        let recorded = records.map(|records| records.at(at.s, smooth));
        let decided = self.decided(of_position, contacts, recorded)?;
        let is_full = |decided: &Decided| decided.decision.is_full;
        let full_film = if decided.iter().any(is_full) {
            full_film_at(self.case, of_position, self.records, smooth)?
        } else {
            None
        };
        let frictions = self.in_film(of_position, contacts, &decided, full_film.as_ref())?;
        let mut position = LubricatedPosition {
            offsets: Vec::with_capacity(contacts.len()),
            full_film,
            doubts: Vec::new(),
            pressed: None,
            at: at.clone(),
            film: film.clone(),
        };
        let windows = contacts.iter().zip(decided).zip(frictions);
        for (k, ((contact, decided), friction)) in windows.enumerate() {
            let Decided { share, decision } = decided;
            let shared = &decision.shared;
            let share = share.map(|share| share.value);
            let mut offset = LubricatedWindow {
                roughness: contact.roughness,
                lambda_star: decision.lambda_star,
                film_ratio: decision.film_ratio,
                regime: decision.regime,
                film_share: shared.film_share,
                boundary_part: shared.boundary_part,
                lubricated_coefficient: shared.lubricated_coefficient,
                solved: share,
                recorded,
                friction,
                rubbing: Rubbing::of_share(self.case, at, shared),
                friction_force: 0.0,
                flash: 0.0,
                contact: share
                    .filter(|share| share.asperity_share > 0.0)
                    .map(|share| numbers_of_share(&share, self.case.model.window)),
                deformation: None,
            };
            if let Some(law) = self.case.formulation.pressures() {
                let pair = self.pair(
                    at,
                    contact,
                    OffsetIndex {
                        k,
                        count: contacts.len(),
                    },
                )?;
                let pair = pair.ok_or_else(PositionError::no_profile)?;
                self.press_by_law(law, &pair, decision.is_full, &mut position, &mut offset)?;
            }
            if let Some(records) = records {
                offset.friction.mu *= records.of_lay;
                offset.rubbing = offset.rubbing.times(records.of_lay);
            }
            offset.friction_force = offset.rubbing.force(offset.friction.mu);
            offset.flash = friction::flash(self.case, at, offset.friction_force / at.load.si())?;
            position.offsets.push(offset);
        }
        check_position(&position)?;
        Ok(position)
    }

    /// The records, where the load share is theirs.
    fn records_of_share(&self) -> Option<&PathRecords> {
        match self.laws.load_share {
            ShareLaw::Reference => self.records,
            _ => None,
        }
    }

    /// Regime and load share in every window, solved in order.
    fn decided(
        &self,
        of_position: SmoothPosition<'_>,
        contacts: &[Arc<WindowContact>],
        recorded: Option<RecordedShare>,
    ) -> Result<Vec<Decided>, PositionError> {
        let at = of_position.at;
        let count = contacts.len();
        let mut rough_film = None;
        let mut open = Vec::with_capacity(count);
        for (k, contact) in contacts.iter().enumerate() {
            checkpoint()?;
            if self.surfaces.begins_a_pair(k, count) {
                let (of_pair, ..) = self.surfaces.met(at.zone, k, count);
                rough_film = RoughFilm::at(self.case, self.laws, of_pair, of_position)?;
            }
            let share = match (&mut rough_film, contact.window) {
                (Some(film), Some(window)) => {
                    let share = film.share(contact, window);
                    Some(share.map_err(|error| contact.keeping(error, at))?)
                }
                _ => None,
            };
            // A law of the user may depend on the heights of the window.
            let pair = match self.laws.load_share {
                ShareLaw::Own { .. } => self.pair(at, contact, OffsetIndex { k, count })?,
                _ => None,
            };
            let undecided = Undecided::new(self.case, self.laws, of_position, &contact.roughness)?;
            open.push((share, pair, undecided));
        }
        let conditions = contacts.iter().zip(&open);
        let conditions = conditions.map(|(contact, (share, pair, undecided))| {
            let solved = share.as_ref().map(|share| &share.value);
            undecided.conditions(
                self.case,
                of_position,
                &contact.roughness,
                pair.as_ref(),
                solved,
            )
        });
        let conditions: Vec<_> = conditions.collect();
        let shared = (self.laws.load_share).shares(&conditions, recorded.as_ref())?;
        let with_share = open.into_iter().zip(shared);
        with_share
            .map(|((share, _, undecided), shared)| {
                let decision = undecided.decided(self.case, shared)?;
                Ok(Decided { share, decision })
            })
            .collect()
    }

    /// Film by the formulas with regime and load share in every window, without friction.
    ///
    /// # Errors
    /// As [`position`](Self::position).
    pub(crate) fn decisions(
        &self,
        at: &MeshPosition,
        contacts: &[Arc<WindowContact>],
    ) -> Result<(FormulaFilm, Vec<Decision>), PositionError> {
        let film = plausible_film(self.case, at)?;
        let records = self.records_of_share();
        let recorded = records.map(|records| records.at(at.s, None));
        let decided = self.decided(SmoothPosition { at, film: &film }, contacts, recorded)?;
        let decisions = decided.into_iter().map(|decided| decided.decision);
        Ok((film, decisions.collect()))
    }

    /// Gradient of the sliding loss at `at` over the heights, its rough contacts stored and their sets held.
    ///
    /// # Errors
    /// When a contact has no solution, or the load share does not follow from one.
    pub(crate) fn gradient(
        &self,
        at: &MeshPosition,
        contacts: &[Arc<WindowContact>],
    ) -> Result<PositionGradient, PositionError> {
        checkpoint()?;
        let film = plausible_film(self.case, at)?;
        let of_position = SmoothPosition { at, film: &film };
        let rough = RoughFilm::at(self.case, self.laws, self.surfaces, of_position)?;
        let mut rough = rough.ok_or_else(PositionError::no_profile)?;
        let force = at.weight * at.mean_sliding() * at.load.si();
        let mut windows = Vec::with_capacity(contacts.len());
        let mut kinks = Kinks::default();
        for contact in contacts {
            windows.push(match contact.window {
                Some(window) => {
                    let (gradient, of_window) = rough.window_gradient(contact, window, force)?;
                    kinks += of_window;
                    gradient
                }
                None => None,
            });
        }
        Ok(PositionGradient {
            windows,
            unflattening: rough.unflattening()?,
            kinks,
        })
    }

    /// Solves the rough contact of every window whose load share did not: its numbers, for the result and for the
    /// plastic work of running-in.
    ///
    /// # Errors
    /// When a contact has no solution.
    pub(crate) fn press(
        &self,
        position: &mut LubricatedPosition,
        contacts: &[Arc<WindowContact>],
    ) -> Result<(), PositionError> {
        let count = contacts.len();
        for (k, contact) in contacts.iter().enumerate() {
            if position.offsets[k].solved.is_some() || position.offsets[k].contact.is_some() {
                continue;
            }
            checkpoint()?;
            let Some(pair) = self.pair(&position.at, contact, OffsetIndex { k, count })? else {
                continue;
            };
            let pressed = self.pressed(position, k, &pair)?;
            position.doubts.extend(doubts(&pressed));
            position.offsets[k].contact = numbers(&pressed);
        }
        Ok(())
    }

    /// Pressures of film and solids in window `k` of a solved position.
    ///
    /// # Errors
    /// When the contact has no solution.
    pub(crate) fn pressed(
        &self,
        position: &LubricatedPosition,
        k: usize,
        pair: &WindowPair,
    ) -> Result<Pressed, PositionError> {
        let film_share = position.offsets[k].film_share;
        if film_share >= 1.0 {
            return position.film_pressure(&pair.x).map(Pressed::full_film);
        }
        let pressing = Pressing {
            case: self.case,
            position: &position.at,
            pair,
            film_share,
        };
        let pressed = pressing.solve();
        pressed.map_err(|error| error.keeping(&pair.x, &pair.gap))
    }

    /// Friction, film share and deformation of one window from the pressures by `law`, or from the pressure of a full film.
    fn press_by_law(
        &self,
        law: &dyn WindowPressures,
        pair: &WindowPair,
        is_full: bool,
        position: &mut LubricatedPosition,
        offset: &mut LubricatedWindow,
    ) -> Result<(), PositionError> {
        let (case, at) = (self.case, &position.at);
        let window = WindowConditions {
            position: at,
            pair,
            gears: &case.gears,
            speed: case.speed,
            materials: &case.materials,
            flow_pressure: case.flow_pressure,
            modulus: case.modulus,
            oil: case.oil(),
            model: &case.model,
            paper: &case.paper,
        };
        let pressed = if is_full {
            Pressed::full_film(position.film_pressure(&pair.x)?)
        } else {
            (law.press(&window)).map_err(|error| error.keeping(&pair.x, &pair.gap))?
        };
        offset.rubbing = Rubbing::of_pressures(case, pair.spacing, &pressed)?;
        if pressed.solids.is_some() {
            // The law of the load share is not asked: the film carries what is left to it.
            offset.film_share = offset.rubbing.film_load / at.load.si();
        }
        let shear = offset.shear(case, at, &pressed);
        offset.deformation = Some(law.deformation(&window, &pressed, &shear)?);
        offset.contact = numbers(&pressed);
        position.doubts.extend(doubts(&pressed));
        position.pressed.get_or_insert(pressed);
        Ok(())
    }

    /// Heights and gap of a window; `None` where no window is resolved.
    pub(crate) fn pair(
        &self,
        at: &MeshPosition,
        contact: &WindowContact,
        offset: OffsetIndex,
    ) -> Result<Option<WindowPair>, PositionError> {
        let Some(window) = contact.window else {
            return Ok(None);
        };
        let flanks = window.cut(self.surfaces, at.zone, offset)?;
        WindowPair::new(flanks, at, self.case.modulus).map(Some)
    }

    /// Friction of the film in every window: from the full film or the load share if these solve for it, else by the law of film
    /// friction. A law for a film without asperities depends on the roughness through the film's share of the load only: offsets
    /// of one share take it from the first of them.
    fn in_film(
        &self,
        of_position: SmoothPosition<'_>,
        contacts: &[Arc<WindowContact>],
        decided: &[Decided],
        full_film: Option<&FullFilm>,
    ) -> Result<Vec<InFilm>, PositionError> {
        let (case, law) = (self.case, self.laws.friction.as_ref());
        if !self.is_film_alone() {
            let roughness = contacts.iter().map(|contact| &contact.roughness);
            return friction::in_film(case, law, of_position, 1.0, roughness);
        }
        let by_full_film = full_film.and_then(|film| film.coefficient);
        let mut last: Option<(f64, InFilm)> = None;
        let mut of_window = |contact: &WindowContact, Decided { share, decision }: &Decided| {
            let by_full_film = by_full_film.filter(|_| decision.is_full);
            if let Some(mu) = by_full_film.or(decision.shared.film_coefficient) {
                let outside = share.as_ref().map(|share| share.outside.clone());
                return Ok(InFilm {
                    mu: case.model.friction_scale * mu,
                    outside: outside.unwrap_or_default(),
                });
            }
            // Where the friction follows from pressures, they are those of the whole load.
            let film_share = match case.formulation.pressures() {
                Some(_) => 1.0,
                None => decision.shared.film_share.max(1.0 - LARGEST_SHARE),
            };
            if let Some((_, known)) = last.as_ref().filter(|(share, _)| *share == film_share) {
                return Ok(known.clone());
            }
            let found =
                friction::in_film(case, law, of_position, film_share, [&contact.roughness])?;
            let found = found
                .into_iter()
                .next()
                .ok_or_else(PositionError::no_profile)?;
            last = Some((film_share, found.clone()));
            Ok(found)
        };
        let windows = contacts.iter().zip(decided);
        windows
            .map(|(contact, decided)| of_window(contact, decided))
            .collect()
    }

    /// Whether the film friction of the case is for a film without asperities, which a solved film can replace.
    fn is_film_alone(&self) -> bool {
        let case = self.case;
        case.laws.friction.is_none() && case.model.film_friction.shear_law().is_some()
    }

    /// Friction coefficient of the smooth film, where records or a full film are compared with it.
    fn smooth_friction(&self, position: SmoothPosition<'_>) -> Result<Option<f64>, PositionError> {
        let is_compared =
            self.records.is_some() || self.case.model.full_film != FullFilmName::Formulas;
        if is_compared && self.is_film_alone() {
            friction::smooth(self.case, self.laws, self.surfaces, position).map(Some)
        } else {
            Ok(None)
        }
    }
}

/// Doubts about the solution of a rough contact.
pub(crate) fn doubts(pressed: &Pressed) -> Vec<ContactWarning> {
    let solids = pressed.solids.iter();
    solids.flat_map(ContactSolution::warnings).collect()
}

/// Numbers of a solved contact; `None` where the flanks do not touch.
pub(crate) fn numbers(pressed: &Pressed) -> Option<ContactNumbers> {
    let solids = pressed.solids.as_ref()?;
    Some(ContactNumbers {
        contact_fraction: solids.contact_fraction,
        p_max: pressed.highest(),
        plastic_work: solids.dissipated.si(),
        iterations: solids.iterations,
        // Marching stops short of the load; its last step reports by how much.
        load_error: match pressed.history.last() {
            Some(step) => step.load_error,
            None => solids.certificate.load_error,
        },
        duality_gap: solids.certificate.duality_gap,
    })
}

/// Numbers of a contact known by its table, in a window of `window` half-widths to each side.
fn numbers_of_share(share: &LoadShareSolution, window: f64) -> ContactNumbers {
    ContactNumbers {
        contact_fraction: share.area / window,
        p_max: share.max_pressure.si(),
        plastic_work: share.dissipated.si(),
        iterations: share.evidence.share.iterations,
        load_error: share.evidence.load_error,
        duality_gap: share.evidence.duality_gap,
    }
}
