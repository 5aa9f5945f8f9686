//! One mesh position at one operating point: film, load share and friction of every window.
//!
//! 1. The formulas give the smooth film of the position.
//! 2. In every window the rough contact under that film gives the share of the asperities ([`RoughFilm::share`]), unless a law of
//!    the load share replaces it.
//! 3. The law of the load share turns this into the shares of film and boundary layer and into a regime ([`Lubrication::decided`]).
//! 4. The friction of the film comes from a solved full film, from the share, or from the law of film friction.
//! 5. Forces follow from shares and coefficients, and from the forces the flash temperature.
//!
//! A formulation with pressures of its own ([`WindowPressures`]) has no share by the contact: friction, film share and deformation
//! of a window then follow from its pressures, in place of what step 3 gives.

use std::sync::Arc;

use asperity_contact::{ContactSolution, ContactWarning};
use asperity_core::Checked;
use asperity_core::cancel::checkpoint;
use asperity_ehl_regime::inlet_flow::LARGEST_SHARE;
use asperity_mixed_film::{FilmPressure, Kinks, LoadShareSolution};

use super::chosen_laws::ChosenLaws;
use super::decision::{Decision, Undecided};
use super::friction::{self, InFilm, Rubbing};
use super::full_film::FullFilm;
use super::full_film_solution::full_film_at;
use super::plausibility::{check_position, plausible_film};
use super::position::{ContactNumbers, LubricatedPosition, LubricatedWindow};
use super::rough_film::{HeightGradient, RoughFilm};
use crate::contacts::{Pressing, WindowContact};
use crate::mesh::MeshPosition;
use crate::records::{PathRecords, RecordedShare};
use asperity_case::case::{Case, FullFilmName};
use asperity_case::error::PositionError;
use asperity_case::flanks::{Roughness, Surfaces, WindowPair};
use asperity_case::formula_film::FormulaFilm;
use asperity_case::window_pressures::{Pressed, WindowConditions, WindowPressures};

/// Regime and load share in one window.
struct Decided {
    /// The rough contact at its share, if the load share depends on it.
    share: Option<Checked<LoadShareSolution>>,
    /// Heights of the window, if the load share depends on them.
    pair: Option<WindowPair>,
    decision: Decision,
}

/// Gradient of the sliding loss at a position.
pub(crate) struct PositionGradient {
    /// Over the heights of both traces at each offset \[W/m\].
    pub by_offset: Vec<[Vec<f64>; 2]>,
    /// Kinks of the windows.
    pub kinks: Kinks,
}

/// Everything that is the same at all positions.
#[derive(Clone, Copy)]
pub(crate) struct Lubrication<'a> {
    pub case: &'a Case,
    pub laws: &'a ChosenLaws,
    pub surfaces: &'a Surfaces,
    /// Records of mixed lubrication along the path.
    pub records: Option<&'a PathRecords>,
}

impl Lubrication<'_> {
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
        let smooth = self.smooth_friction((at, &film))?;
        let records = self
            .records
            .filter(|_| self.laws.load_share.needs_records());
        let recorded = records.map(|records| records.at(at.s, smooth));
        let mut position = LubricatedPosition {
            offsets: Vec::with_capacity(contacts.len()),
            full_film: None,
            doubts: Vec::new(),
            pressed: None,
            at: at.clone(),
            film: film.clone(),
        };
        let mut film_alone = None;
        let mut by_law = Vec::new();
        if !self.is_film_alone() {
            let roughness = contacts.iter().map(|contact| &contact.roughness);
            let law = self.laws.friction.as_ref();
            by_law = friction::in_film(self.case, law, (at, &film), 1.0, roughness)?;
        }
        let decided = self.decided((at, &film), contacts, recorded)?;
        for (k, (contact, decided)) in contacts.iter().zip(decided).enumerate() {
            let Decided {
                share,
                pair,
                decision,
            } = decided;
            let is_full = decision.is_full;
            if is_full && position.full_film.is_none() {
                position.full_film = full_film_at(self.case, (at, &film), self.records, smooth)?;
            }
            let solved = position.full_film.as_ref().filter(|_| is_full);
            let friction = match by_law.get(k) {
                Some(by_law) => by_law.clone(),
                None => self.in_film(
                    (at, &film),
                    &contact.roughness,
                    &decision,
                    (solved, share.as_ref()),
                    &mut film_alone,
                )?,
            };
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
            if let Some((law, pair)) = self.pressures().zip(pair) {
                self.press_by_law(law, &pair, is_full, (&mut position, &mut offset))?;
            }
            offset.friction_force = offset.rubbing.force(offset.friction.mu);
            offset.flash = friction::flash(self.case, at, offset.friction_force / at.load.si())?;
            position.offsets.push(offset);
        }
        check_position(&position)?;
        Ok(position)
    }

    /// Regime and load share in every window, solved in order.
    fn decided(
        &self,
        of_position: (&MeshPosition, &FormulaFilm),
        contacts: &[Arc<WindowContact>],
        recorded: Option<RecordedShare>,
    ) -> Result<Vec<Decided>, PositionError> {
        let at = of_position.0;
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
            let pair = match self.looks_at_heights() {
                true => self.pair(at, contact, (k, count))?,
                false => None,
            };
            if pair.is_none() && self.pressures().is_some() {
                return Err(PositionError::no_profile());
            }
            let undecided = Undecided::of(self.case, self.laws, of_position, &contact.roughness)?;
            open.push((share, pair, undecided));
        }
        let conditions = contacts.iter().zip(&open);
        let conditions = conditions.map(|(contact, (share, pair, undecided))| {
            let solved = share.as_ref().map(|share| &share.value);
            undecided.conditions(
                self.case,
                of_position,
                (&contact.roughness, pair.as_ref()),
                (solved, recorded.as_ref()),
            )
        });
        let shared = self
            .laws
            .load_share
            .shares(&conditions.collect::<Vec<_>>())?;
        let with_share = open.into_iter().zip(shared);
        with_share
            .map(|((share, pair, undecided), shared)| {
                let decision = undecided.decided(self.case, shared)?;
                Ok(Decided {
                    share,
                    pair,
                    decision,
                })
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
        let records = self
            .records
            .filter(|_| self.laws.load_share.needs_records());
        let recorded = records.map(|records| records.at(at.s, None));
        let decided = self.decided((at, &film), contacts, recorded)?;
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
        let of_position = (at, &film);
        let rough = RoughFilm::at(self.case, self.laws, self.surfaces, of_position)?;
        let mut rough = rough.ok_or_else(PositionError::no_profile)?;
        let count = contacts.len();
        let force = at.weight * at.mean_sliding() * at.load.si();
        let mut of_offsets = Vec::with_capacity(count);
        let mut kinks = Kinks::default();
        for contact in contacts {
            let mut sums = HeightGradient::none(self.surfaces)?;
            if let Some(window) = contact.window {
                rough.add_gradient((contact, window), force, &mut sums)?;
            }
            kinks += sums.kinks;
            of_offsets.push(sums);
        }
        let by_offset = rough.gradients(&of_offsets)?;
        Ok(PositionGradient { by_offset, kinks })
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
            let Some(pair) = self.pair(&position.at, contact, (k, count))? else {
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
        (position, offset): (&mut LubricatedPosition, &mut LubricatedWindow),
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
            oil: &case.oil,
            model: &case.model,
        };
        let pressed = match is_full {
            true => Pressed::full_film(position.film_pressure(&pair.x)?),
            false => (law.press(&window)).map_err(|error| error.keeping(&pair.x, &pair.gap))?,
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
        offset: (usize, usize),
    ) -> Result<Option<WindowPair>, PositionError> {
        let Some(window) = contact.window else {
            return Ok(None);
        };
        let flanks = window.cut(self.surfaces, at.zone, offset)?;
        WindowPair::new(flanks, at, self.case.modulus).map(Some)
    }

    /// Pressures in a window, if friction follows from them.
    fn pressures(&self) -> Option<&dyn WindowPressures> {
        self.case.formulation.pressures()
    }

    /// Whether the load share depends on the heights of a window: with pressures it does, and any user-defined law may.
    fn looks_at_heights(&self) -> bool {
        self.pressures().is_some() || self.case.laws.load_share.is_some()
    }

    /// Friction of the film: from the full film or the load share if these solve for it, else by the law, which depends on the
    /// roughness through the film's share of the load only: offsets of one share take it from the first of them.
    fn in_film(
        &self,
        position: (&MeshPosition, &FormulaFilm),
        roughness: &Roughness,
        decision: &Decision,
        (full_film, share): (Option<&FullFilm>, Option<&Checked<LoadShareSolution>>),
        film_alone: &mut Option<(f64, InFilm)>,
    ) -> Result<InFilm, PositionError> {
        let case = self.case;
        let by_full_film = full_film.and_then(|film| film.coefficient);
        if let Some(mu) = by_full_film.or(decision.shared.film_coefficient) {
            return Ok(InFilm {
                mu: case.model.friction_scale * mu,
                outside: share.map(|share| share.outside.clone()).unwrap_or_default(),
            });
        }
        let film_share = match case.model.film_pressure {
            FilmPressure::Hertz => 1.0,
            FilmPressure::Own | FilmPressure::Rippled => {
                decision.shared.film_share.max(1.0 - LARGEST_SHARE)
            }
        };
        if !matches!(film_alone, Some((share, _)) if *share == film_share) {
            let law = self.laws.friction.as_ref();
            let by_law = friction::in_film(case, law, position, film_share, [roughness])?;
            *film_alone = by_law.into_iter().next().map(|film| (film_share, film));
        }
        let known = film_alone.as_ref().map(|(_, film)| film.clone());
        known.ok_or_else(PositionError::no_profile)
    }

    /// Whether the film friction of the case is for a film without asperities, which a solved film can replace.
    fn is_film_alone(&self) -> bool {
        let case = self.case;
        case.laws.friction.is_none() && case.model.film_friction.shear_law().is_some()
    }

    /// Friction coefficient of the smooth film, where records or a full film are compared with it.
    fn smooth_friction(
        &self,
        position: (&MeshPosition, &FormulaFilm),
    ) -> Result<Option<f64>, PositionError> {
        let is_compared =
            self.records.is_some() || self.case.model.full_film != FullFilmName::Formulas;
        match is_compared && self.is_film_alone() {
            true => friction::smooth(self.case, self.laws, self.surfaces, position).map(Some),
            false => Ok(None),
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
