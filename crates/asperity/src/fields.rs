//! Fields along one rough contact, and the stress below it.

use asperity_contact::subsurface::{graded_depths, subsurface_stress};
use asperity_core::quantity::{Length, Pressure};

use crate::branch::{Bodies, Carried};
use crate::contact_view::ContactView;
use crate::error::PositionError;
use crate::formulation::Scene;
use crate::result::{PositionFields, SubsurfaceFields};
use crate::station::Station;

/// Fields of one contact with the largest von Mises stress below it and its depth.
pub(crate) struct Fields {
    pub fields: PositionFields,
    pub von_mises: Option<(Pressure, Length)>,
    pub view: ContactView,
}

/// Stress below a surface with its largest von Mises stress and the depth of that.
type Below = (SubsurfaceFields, Option<(Pressure, Length)>);

/// The fields of `carried`, with the friction coefficient `mu_film` in the film.
pub(crate) fn fields(
    scene: &Scene<'_>,
    carried: Carried,
    mu_film: f64,
) -> Result<Fields, PositionError> {
    let (case, station, encounter) = (scene.case, scene.station, scene.encounter);
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
        None => match scene.full_film {
            Some(film) => film.gap_at(&encounter.x, station.motion.radius),
            None => vec![station.film_shown.central.si(); n],
        },
    };
    let shear = shear(scene, &carried, mu_film);
    let total: Vec<f64> = solid
        .iter()
        .zip(&carried.fluid)
        .map(|(s, f)| s + f)
        .collect();
    let (subsurface, von_mises) = stress_below(scene, &total, &shear)?.unzip();
    let displacement = |body: usize| {
        let pairs = bodies.elastic[body].iter().zip(&bodies.plastic[body]);
        pairs.map(|(e, p)| e + p).collect()
    };
    let fields = PositionFields {
        position: station.number,
        x: encounter.x.clone(),
        height_pinion: encounter.heights[0].clone(),
        height_wheel: encounter.heights[1].clone(),
        displacement_pinion: displacement(0),
        displacement_wheel: displacement(1),
        plastic_pinion: bodies.plastic[0].clone(),
        plastic_wheel: bodies.plastic[1].clone(),
        gap,
        pressure_solid: solid,
        pressure_fluid: carried.fluid,
        shear,
        subsurface,
        history: carried.history,
    };
    Ok(Fields {
        view: view(&fields, station),
        fields,
        von_mises: von_mises.flatten(),
    })
}

/// The flanks of `fields` facing each other.
///
/// The pinion's flank is z₁ = −κ₁ x²/2 + h₁ − δ₁ with its curvature κ₁ = (1/R) ρ₂/(ρ₁ + ρ₂), the wheel's lies the
/// gap above it; δ is the displacement.
fn view(fields: &PositionFields, station: &Station) -> ContactView {
    let motion = &station.motion;
    let curvature = motion.rho2 / (motion.rho1 + motion.rho2) / motion.radius.si();
    let half_width = station.hertz.half_width.si();
    let height = |i: usize| {
        let form = 0.5 * curvature * fields.x[i] * fields.x[i];
        fields.height_pinion[i] - fields.displacement_pinion[i] - form
    };
    let within = |reach: f64| (0..fields.x.len()).filter(move |&i| fields.x[i].abs() <= reach);
    let (sum, count) =
        within(half_width).fold((0.0, 0.0), |(sum, count), i| (sum + height(i), count + 1.0));
    let level = if count > 0.0 { sum / count } else { 0.0 };
    let column = |value: &dyn Fn(usize) -> f64| -> Vec<f64> {
        within(ContactView::REACH * half_width).map(value).collect()
    };
    let pinion = |i: usize| height(i) - level;
    ContactView::new(
        fields.position,
        column(&|i| fields.x[i] * 1e6),
        [
            column(&|i| pinion(i) * 1e6),
            column(&|i| (pinion(i) + fields.gap[i]) * 1e6),
            column(&|i| fields.pressure_solid[i] * 1e-6),
            column(&|i| fields.pressure_fluid[i] * 1e-6),
        ],
    )
}

/// Shear stress on the pinion's flank \[Pa\], with the friction coefficient `mu_film` in the film.
pub(crate) fn shear(scene: &Scene<'_>, carried: &Carried, mu_film: f64) -> Vec<f64> {
    // Friction drags the pinion's flank against its sliding.
    let sign = -scene.station.motion.sliding.si().signum();
    let mu_solid = scene
        .decision
        .shared
        .asperity_coefficient(scene.case.model.boundary_friction);
    let solid = carried.solids.as_ref().map(|solids| &solids.pressure);
    let fluid = carried.fluid.iter().enumerate();
    fluid
        .map(|(i, f)| sign * (mu_solid * solid.map_or(0.0, |solid| solid[i]) + mu_film * f))
        .collect()
}

fn stress_below(
    scene: &Scene<'_>,
    pressure: &[f64],
    shear: &[f64],
) -> Result<Option<Below>, PositionError> {
    let (case, spacing) = (scene.case, scene.encounter.spacing);
    if case.model.depths < 2 {
        return Ok(None);
    }
    let half_width = scene.station.hertz.half_width;
    let depths = graded_depths(spacing, half_width, case.model.depths)?;
    let field = subsurface_stress(pressure, Some(shear), spacing, &depths)?;
    let von_mises = field.von_mises(case.materials[0].poisson)?;
    let largest = field.peak(&von_mises).map(|peak| (peak.value, peak.depth));
    let fields = SubsurfaceFields {
        depths,
        sigma_xx: field.sigma_xx,
        sigma_zz: field.sigma_zz,
        tau_xz: field.tau_xz,
        von_mises,
    };
    Ok(Some((fields, largest)))
}
