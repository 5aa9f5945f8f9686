//! Friction at one mesh position: in the film by the law chosen, of the whole contact, of rolling.

use asperity_core::OutOfRange;
use asperity_core::cite;
use asperity_core::quantity::{Length, LineLoad, Pressure, Speed, Temperature};
use asperity_oil::{LubricantState, roelands};
use asperity_tribo_friction::{
    FilmContact, FilmFriction, FrictionConditions, MeshConditions, flash_temperature,
    mixed_friction,
};

use super::chosen_laws::ChosenLaws;
use super::smooth_position::SmoothPosition;
use crate::mesh::MeshPosition;
use asperity_case::case::OperatingCase;
use asperity_case::error::PositionError;
use asperity_case::flanks::{Roughness, Surfaces};
use asperity_case::load_share_law::SharedLoad;
use asperity_case::window_pressures::Pressed;

/// Friction coefficient in the film.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct InFilm {
    pub mu: f64,
    /// Inputs that left their fitted range.
    pub outside: Vec<OutOfRange>,
}

/// Flash temperatures closer than this \[K\] are the same.
const FLASH_SETTLED: f64 = 1e-6;
/// Most passes of the flash feedback; each pass shrinks the change about tenfold.
const FLASH_PASSES: usize = 50;

/// Friction in a film with `film_share` of the load by `law`, for each of the roughnesses at a position. With flash feedback the
/// oil is taken at bulk plus flash temperature, found by repeated substitution.
pub(crate) fn in_film<'a>(
    case: &OperatingCase,
    law: &dyn FilmFriction,
    position: SmoothPosition<'_>,
    film_share: f64,
    roughness: impl IntoIterator<Item = &'a Roughness>,
) -> Result<Vec<InFilm>, PositionError> {
    struct OpenWindow<'a> {
        k: usize,
        roughness: &'a Roughness,
        oil: LubricantState,
        before: f64,
    }
    let begin = |(k, roughness)| OpenWindow {
        k,
        roughness,
        oil: *case.oil(),
        before: 0.0,
    };
    let mut open: Vec<OpenWindow<'_>> = roughness.into_iter().enumerate().map(begin).collect();
    let mut settled = Vec::with_capacity(open.len());
    for _ in 0..FLASH_PASSES {
        let contacts = open
            .iter()
            .map(|one| film_contact(case, position, one.roughness, &one.oil));
        let mut contacts = contacts.collect::<Result<Vec<_>, _>>()?;
        for contact in &mut contacts {
            contact.film_share = film_share;
        }
        let mut left = Vec::new();
        for (one, found) in open.into_iter().zip(law.tractions(&contacts)?) {
            let mu = case.model.friction_scale * found.value.coefficient;
            let flash = flash(case, position.at, mu)?;
            let is_settled = (flash - one.before).abs() <= FLASH_SETTLED;
            if is_settled || !case.model.flash_feedback {
                let outside = found.outside;
                settled.push((one.k, InFilm { mu, outside }));
                continue;
            }
            let temperature = Temperature::from_si(case.temperature().si() + flash);
            left.push(OpenWindow {
                before: flash,
                oil: case.lubricant.at(temperature)?.value,
                ..one
            });
        }
        open = left;
        if open.is_empty() {
            settled.sort_by_key(|(k, _)| *k);
            return Ok(settled.into_iter().map(|(_, found)| found).collect());
        }
    }
    Err(PositionError::flash_not_settled(
        open.first().map_or(0.0, |one| one.before),
        FLASH_PASSES,
    ))
}

/// Friction coefficient of the smooth film by the law of the case.
pub(crate) fn smooth(
    case: &OperatingCase,
    laws: &ChosenLaws,
    surfaces: &Surfaces,
    position: SmoothPosition<'_>,
) -> Result<f64, PositionError> {
    let roughness = surfaces.roughness_as_a_whole()?;
    let contact = film_contact(case, position, &roughness, case.oil())?;
    Ok(laws.friction.traction(&contact)?.value.coefficient)
}

/// Flash temperature \[K\] of a contact whose whole friction coefficient is `mu`.
pub(crate) fn flash(
    case: &OperatingCase,
    position: &MeshPosition,
    mu: f64,
) -> Result<f64, PositionError> {
    let contact = position.line_contact(case.modulus, case.materials);
    Ok(flash_temperature(&contact, position.hertz.half_width, mu)?)
}

/// The local contact at `position` with the oil in the state `oil`, the whole load on the film.
pub(crate) fn film_contact<'a>(
    case: &'a OperatingCase,
    SmoothPosition { at: position, film }: SmoothPosition<'_>,
    roughness: &Roughness,
    oil: &LubricantState,
) -> Result<FilmContact<'a>, PositionError> {
    Ok(FilmContact {
        position: conditions(case, SmoothPosition { at: position, film }, roughness, oil)?,
        surface_speeds: [position.motion.u1, position.motion.u2],
        modulus: case.modulus,
        half_width: position.hertz.half_width,
        film_share: 1.0,
        materials: case.materials,
        bulk_temperature: case.temperature(),
        oil: *oil,
        lubricant: &case.lubricant,
    })
}

fn conditions(
    case: &OperatingCase,
    SmoothPosition { at: position, film }: SmoothPosition<'_>,
    roughness: &Roughness,
    oil: &LubricantState,
) -> Result<FrictionConditions, PositionError> {
    /// Mean over maximum pressure of a Hertz line contact, π/4.
    const MEAN_OVER_MAXIMUM: f64 = std::f64::consts::FRAC_PI_4;
    let mean_pressure = Pressure::from_si(MEAN_OVER_MAXIMUM * position.hertz.max_pressure.si());
    Ok(FrictionConditions {
        load: position.load,
        radius: position.motion.radius,
        entrainment: position.motion.entrainment,
        sliding: position.motion.sliding,
        max_pressure: position.hertz.max_pressure,
        viscosity: oil.dynamic_viscosity,
        contact_viscosity: roelands(oil.dynamic_viscosity, oil.pressure_viscosity, mean_pressure)?,
        kinematic_viscosity: oil.kinematic_viscosity,
        pressure_viscosity: oil.pressure_viscosity,
        central_film: film.film.central,
        minimum_film: film.film.minimum,
        combined_roughness: roughness.combined_rq()?,
        mean_ra: Length::from_si(0.5 * (roughness.ra[0] + roughness.ra[1])),
        sum_rz: Length::from_si(roughness.rz[0] + roughness.rz[1]),
        boundary_coefficient: case.model.boundary_friction,
        mesh: mesh_conditions(case)?,
    })
}

/// Inputs of the laws for the whole mesh: everything at the pitch point.
fn mesh_conditions(case: &OperatingCase) -> Result<MeshConditions, PositionError> {
    let gears = &case.gears;
    let forces = gears.forces(case.torque)?;
    let pitch = gears.kinematics(gears.path().c, case.speed)?;
    let width = gears.face_width.si();
    let pitch_radius = gears.working_pitch_radius[0].si();
    let ratio = gears.ratio;
    Ok(MeshConditions {
        base_line_load: LineLoad::from_si(forces.transverse_base.si() / width),
        sum_speed: pitch.u1 + pitch.u2,
        reduced_radius: pitch.radius,
        lubricant_factor: case.model.film_friction.lubricant_factor(),
        load_intensity: Pressure::from_si(
            forces.tangential.si() / (width * 2.0 * pitch_radius) * (ratio + 1.0) / ratio,
        ),
        pitch_line_speed: Speed::from_si(case.speed.si() * pitch_radius),
    })
}

/// Friction forces at a contact, per metre of contact line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Rubbing {
    /// Friction force of the boundary layer of touching asperities \[N/m\].
    pub boundary_force: f64,
    /// Friction force of lubricated asperities \[N/m\].
    pub lubricated_force: f64,
    /// Load on the film \[N/m\].
    pub film_load: f64,
}

impl Rubbing {
    /// With film and asperities sharing the load as `shared` says.
    pub(crate) fn of_share(
        case: &OperatingCase,
        position: &MeshPosition,
        shared: &SharedLoad,
    ) -> Self {
        let load = position.load.si();
        let solid = (1.0 - shared.film_share) * load;
        let boundary = shared.boundary_part * solid;
        Self {
            boundary_force: case.model.boundary_friction * boundary,
            lubricated_force: shared.lubricated_coefficient * (solid - boundary),
            film_load: shared.film_share * load,
        }
    }

    /// Summed over the pressures of the window, points `spacing` apart.
    pub(crate) fn of_pressures(
        case: &OperatingCase,
        spacing: Length,
        pressed: &Pressed,
    ) -> Result<Self, PositionError> {
        let none = vec![0.0; pressed.fluid.len()];
        let solids = pressed.solids.as_ref();
        let solid = solids.map_or(&none, |solids| &solids.pressure);
        // Below ambient pressure the film has cavitated and drags nothing.
        let fluid: Vec<f64> = pressed.fluid.iter().map(|p| p.max(0.0)).collect();
        let boundary = case.model.boundary_friction;
        // With a coefficient of one the film's friction is the load on it.
        let friction = mixed_friction(spacing, solid, &fluid, boundary, 1.0)?;
        Ok(Self {
            boundary_force: friction.solid.si(),
            lubricated_force: 0.0,
            film_load: friction.fluid.si(),
        })
    }

    /// With the friction forces of the asperities times `factor`.
    pub(crate) fn times(self, factor: f64) -> Self {
        Self {
            boundary_force: factor * self.boundary_force,
            lubricated_force: factor * self.lubricated_force,
            ..self
        }
    }

    /// Friction force \[N/m\] with the coefficient `mu_film` in the film, the integrals taken before:
    ///
    /// ```text
    /// F_s = μ_m ∫ p_solid dx + μ ∫ p_fluid dx                                     [P21]
    /// ```
    pub(crate) fn force(&self, mu_film: f64) -> f64 {
        cite!("P21");
        let [film, lubricated, boundary] = self.parts(mu_film);
        boundary + lubricated + film
    }

    /// Friction forces \[N/m\] of film, lubricated asperities and boundary layer.
    pub(crate) fn parts(&self, mu_film: f64) -> [f64; 3] {
        [
            mu_film * self.film_load,
            self.lubricated_force,
            self.boundary_force,
        ]
    }
}

/// Resistance to rolling by hysteresis per metre of contact line \[N/m\]: α_h 2 f a/(3πR).
pub(crate) fn hysteresis_force(case: &OperatingCase, position: &MeshPosition) -> f64 {
    let (f, a) = (position.load.si(), position.hertz.half_width.si());
    let swept = 2.0 * f * a / (3.0 * std::f64::consts::PI * position.motion.radius.si());
    case.model.hysteresis * swept
}
