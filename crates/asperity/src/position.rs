//! One mesh position: at every offset the regime, the branch it leads to, and the friction.

use asperity_contact::Solver;
use asperity_contact::subsurface::{graded_depths, subsurface_stress};
use asperity_core::OutOfRange;
use asperity_core::quantity::{Length, Pressure};
use asperity_ehl_regime::{AsperityShape, Orientation, film_ratio, lambda_star};

use crate::branch::{
    Bodies, Carried, Mixed, full_film, load_path, march, mixed, printed_deformation,
};
use crate::case::{Case, Formulation};
use crate::encounter::Encounter;
use crate::error::PositionError;
use crate::friction::{self, FilmFriction, Rubbing};
use crate::local_roughness::Roughness;
use crate::result::{PositionFields, Regime, SubsurfaceFields};
use crate::station::Station;
use crate::surfaces::Surfaces;

/// A mesh position with everything that varies over the offsets.
#[derive(Debug, Clone)]
pub(crate) struct Position {
    pub station: Station,
    pub offsets: Vec<Offset>,
    /// Fields of the first offset.
    pub fields: Option<PositionFields>,
    /// Largest von Mises stress below the first offset's contact, and its depth.
    pub von_mises: Option<(Pressure, Length)>,
}

/// What one offset gives.
#[derive(Debug, Clone)]
pub(crate) struct Offset {
    pub roughness: Roughness,
    /// Λ*; none when the peaks of the flanks are not known or there are none.
    pub lambda_star: Option<f64>,
    /// h_min/S.
    pub film_ratio: f64,
    pub regime: Regime,
    /// Share of the load that the film carries.
    pub film_share: f64,
    /// Friction in the film.
    pub friction: FilmFriction,
    /// What the asperities and the film contribute to the friction force.
    pub rubbing: Rubbing,
    /// Friction force per metre of contact line \[N/m\].
    pub friction_force: f64,
    /// Flash temperature of film and asperities together \[K\].
    pub flash: f64,
    /// Numbers of the rough contact.
    pub contact: Option<ContactNumbers>,
    /// Deformation loss of the paper's reading, per surface \[W\].
    pub deformation: [f64; 2],
}

/// What is kept of a rough contact.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ContactNumbers {
    pub contact_fraction: f64,
    pub p_max: f64,
    /// Plastic work \[J/m\].
    pub plastic_work: f64,
    pub iterations: usize,
    pub load_error: f64,
    pub duality_gap: f64,
}

/// The regime and what decides it.
pub(crate) struct Decision {
    pub lambda_star: Option<f64>,
    pub film_ratio: f64,
    pub regime: Regime,
    pub film_share: f64,
}

impl Position {
    /// Solves `station` at every offset, in order.
    pub(crate) fn solve(
        case: &Case,
        surfaces: &Surfaces,
        station: Station,
    ) -> Result<Self, PositionError> {
        let count = if surfaces.are_measured() {
            case.model.offsets
        } else {
            1
        };
        let mut made = Self {
            offsets: Vec::with_capacity(count),
            fields: None,
            von_mises: None,
            station,
        };
        let mut solver = None;
        for k in 0..count {
            made.add_offset(case, surfaces, k, count, &mut solver)?;
        }
        Ok(made)
    }

    fn add_offset(
        &mut self,
        case: &Case,
        surfaces: &Surfaces,
        k: usize,
        count: usize,
        solver: &mut Option<Solver>,
    ) -> Result<(), PositionError> {
        let station = &self.station;
        let Some(encounter) = Encounter::new(surfaces, station, case.model.window, k, count)?
        else {
            if case.formulation == Formulation::Paper {
                return Err(PositionError::NoProfile);
            }
            let roughness = surfaces.roughness_of_values();
            let offset = without_fields(case, station, roughness)?;
            self.offsets.push(offset);
            return Ok(());
        };
        let decision = decide(case, station, &encounter.roughness)?;
        let friction = friction::in_film(case, station, &encounter.roughness)?;
        let mut carried = carry(case, station, &encounter, &decision, solver)
            .map_err(|error| error.keeping(&encounter))?;
        let rubbing = match case.formulation {
            // Exact shares rather than sums over the points of a window.
            Formulation::Corrected => Rubbing::of_share(case, station, decision.film_share),
            Formulation::Paper => Rubbing::of_pressures(case, &encounter, &carried)?,
        };
        // Marching does not know Λ*: its film carries what is left to it.
        let film_share = match (case.formulation, &carried.solids) {
            (Formulation::Paper, Some(_)) => rubbing.film_load / station.load.si(),
            _ => decision.film_share,
        };
        let force = rubbing.force(friction.mu);
        let flash = friction::flash(case, station, force / station.load.si())?;
        let deformation = match case.formulation {
            Formulation::Corrected => [0.0; 2],
            Formulation::Paper => printed_deformation(case, station, &encounter, &carried)?,
        };
        let contact = carried.solids.as_ref().map(|solids| ContactNumbers {
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
        if k == 0 {
            if let (Formulation::Corrected, Some(solver)) = (case.formulation, solver.as_mut()) {
                let problem = Mixed {
                    case,
                    station,
                    encounter: &encounter,
                    film_share: decision.film_share,
                };
                carried.history = load_path(&problem, solver, &carried)
                    .map_err(|error| error.keeping(&encounter))?;
            }
            self.keep_fields(case, &encounter, carried, friction.mu)?;
        }
        self.offsets.push(Offset {
            roughness: encounter.roughness,
            lambda_star: decision.lambda_star,
            film_ratio: decision.film_ratio,
            regime: decision.regime,
            film_share,
            friction,
            rubbing,
            friction_force: force,
            flash,
            contact,
            deformation,
        });
        Ok(())
    }

    fn keep_fields(
        &mut self,
        case: &Case,
        encounter: &Encounter,
        carried: Carried,
        mu_film: f64,
    ) -> Result<(), PositionError> {
        let n = encounter.x.len();
        let bodies = match &carried.solids {
            Some(solids) => Bodies::new(case, solids)?,
            None => Bodies::none(n),
        };
        let solid = match &carried.solids {
            Some(solids) => solids.pressure.clone(),
            None => vec![0.0; n],
        };
        let gap = match &carried.solids {
            Some(solids) => solids.gap.clone(),
            None => vec![self.station.film.central.si(); n],
        };
        // Friction drags the pinion's flank against its sliding.
        let sign = -self.station.motion.sliding.si().signum();
        let shear: Vec<f64> = solid
            .iter()
            .zip(&carried.fluid)
            .map(|(s, f)| sign * (case.model.boundary_friction * s + mu_film * f))
            .collect();
        let total: Vec<f64> = solid
            .iter()
            .zip(&carried.fluid)
            .map(|(s, f)| s + f)
            .collect();
        let subsurface = self.stress_below(case, encounter, &total, &shear)?;
        let total_displacement = |body: usize| {
            let pairs = bodies.elastic[body].iter().zip(&bodies.plastic[body]);
            pairs.map(|(e, p)| e + p).collect()
        };
        self.fields = Some(PositionFields {
            position: self.station.number,
            x: encounter.x.clone(),
            height_pinion: encounter.heights[0].clone(),
            height_wheel: encounter.heights[1].clone(),
            displacement_pinion: total_displacement(0),
            displacement_wheel: total_displacement(1),
            plastic_pinion: bodies.plastic[0].clone(),
            plastic_wheel: bodies.plastic[1].clone(),
            gap,
            pressure_solid: solid,
            pressure_fluid: carried.fluid,
            shear,
            subsurface,
            history: carried.history,
        });
        Ok(())
    }

    fn stress_below(
        &mut self,
        case: &Case,
        encounter: &Encounter,
        pressure: &[f64],
        shear: &[f64],
    ) -> Result<Option<SubsurfaceFields>, PositionError> {
        if case.model.depths < 2 {
            return Ok(None);
        }
        let half_width = self.station.hertz.half_width;
        let depths = graded_depths(encounter.spacing, half_width, case.model.depths)?;
        let field = subsurface_stress(pressure, Some(shear), encounter.spacing, &depths)?;
        let von_mises = field.von_mises(case.materials[0].poisson)?;
        self.von_mises = field.peak(&von_mises).map(|peak| (peak.value, peak.depth));
        Ok(Some(SubsurfaceFields {
            depths,
            sigma_xx: field.sigma_xx,
            sigma_zz: field.sigma_zz,
            tau_xz: field.tau_xz,
            von_mises,
        }))
    }
}

/// The regime at one offset from Λ*, or from the classical film ratio where Λ* is not known: full film
/// from 1 upward.
pub(crate) fn decide(
    case: &Case,
    station: &Station,
    roughness: &Roughness,
) -> Result<Decision, PositionError> {
    let combined = roughness.combined_rq();
    let ratio = if combined > 0.0 {
        film_ratio(station.film.minimum, 1.0, Length::from_si(combined))?
    } else {
        f64::INFINITY
    };
    let lambda_star = match roughness.reduced_peak.filter(|peak| *peak > 0.0) {
        None => None,
        Some(peak) => {
            // Without a summit to measure, the asperities lift no film of their own.
            let factor = match roughness.asperity_radius {
                None => 0.0,
                Some(radius) => AsperityShape::ridges(radius, station.motion.radius)
                    .film_factor(Orientation::Transverse, case.model.film.speed_exponent())?,
            };
            Some(lambda_star(&station.film, factor, Length::from_si(peak))?.value)
        }
    };
    // Where the peaks are not known, or there are none, the classical film ratio decides.
    let deciding = lambda_star.unwrap_or(ratio);
    let full = deciding >= 1.0;
    let film_share = if full {
        1.0
    } else {
        case.model.load_share.film_share(deciding, ratio)?
    };
    Ok(Decision {
        lambda_star,
        film_ratio: ratio,
        regime: if full {
            Regime::FullFilm
        } else {
            Regime::Mixed
        },
        film_share,
    })
}

fn carry(
    case: &Case,
    station: &Station,
    encounter: &Encounter,
    decision: &Decision,
    solver: &mut Option<Solver>,
) -> Result<Carried, PositionError> {
    match (decision.regime, case.formulation) {
        (Regime::FullFilm, _) => full_film(station, &encounter.x),
        (Regime::Mixed, Formulation::Paper) => march(case, station, encounter),
        (Regime::Mixed, Formulation::Corrected) if decision.film_share >= 1.0 => {
            full_film(station, &encounter.x)
        }
        (Regime::Mixed, Formulation::Corrected) => {
            let problem = Mixed {
                case,
                station,
                encounter,
                film_share: decision.film_share,
            };
            let solver = match solver {
                Some(solver) => solver,
                None => solver.insert(problem.solver()?),
            };
            mixed(&problem, solver)
        }
    }
}

fn without_fields(
    case: &Case,
    station: &Station,
    roughness: Roughness,
) -> Result<Offset, PositionError> {
    let decision = decide(case, station, &roughness)?;
    let friction = friction::in_film(case, station, &roughness)?;
    let rubbing = Rubbing::of_share(case, station, decision.film_share);
    let force = rubbing.force(friction.mu);
    Ok(Offset {
        roughness,
        lambda_star: decision.lambda_star,
        film_ratio: decision.film_ratio,
        regime: decision.regime,
        film_share: decision.film_share,
        rubbing,
        friction_force: force,
        flash: friction::flash(case, station, force / station.load.si())?,
        friction,
        contact: None,
        deformation: [0.0; 2],
    })
}

fn peak(solid: &[f64], fluid: &[f64]) -> f64 {
    let sums = solid.iter().zip(fluid).map(|(s, f)| s + f);
    sums.fold(0.0, f64::max)
}

impl Offset {
    /// What left its fitted range at this offset.
    pub(crate) fn outside(&self) -> &[OutOfRange] {
        &self.friction.outside
    }
}
