//! Deformation loss in the paper's reading.

use asperity_contact::subsurface::subsurface_stress;
use asperity_core::quantity::{Length, Pressure, Time};
use asperity_efficiency::deformation::{SurfaceDeformation, printed_deformation};

use super::bodies::Bodies;
use super::carried::Carried;
use crate::error::PositionError;
use crate::fields::shear;
use crate::formulation::Scene;
use crate::position::PrintedDeformation;

/// Deformation loss as the paper prints it: von Mises stress at the surface times displacement times the square
/// of a cell over the time of a revolution, summed over the cells.
pub(crate) fn printed_deformation_of(
    scene: &Scene<'_>,
    carried: &Carried,
    mu_film: f64,
) -> Result<PrintedDeformation, PositionError> {
    let (case, encounter) = (scene.case, scene.encounter);
    let revolution = Time::from_si(2.0 * std::f64::consts::PI / case.speed.si());
    let bodies = match &carried.solids {
        Some(solids) => Bodies::new(case, solids)?.measured_from_edge(&solids.pressure),
        None => Bodies::hertz(case, scene.station, &encounter.x)?,
    };
    // Where the film has cavitated there is nothing to press.
    let solid = carried.solids.as_ref().map(|solids| &solids.pressure);
    let pressure: Vec<f64> = (carried.fluid.iter().enumerate())
        .map(|(i, fluid)| fluid.max(0.0) + solid.map_or(0.0, |solid| solid[i]))
        .collect();
    let shear = shear(scene, carried, mu_film);
    let surface = subsurface_stress(&pressure, Some(&shear), encounter.spacing, &[0.0])?;
    let mut powers = PrintedDeformation::default();
    for body in 0..2 {
        let stress = surface.von_mises(case.materials[body].poisson)?;
        for (i, stress) in stress.into_iter().enumerate() {
            let power = printed_deformation(
                &SurfaceDeformation {
                    stress: Pressure::from_si(stress),
                    elastic: Length::from_si(bodies.elastic[body][i]),
                    plastic: Length::from_si(bodies.plastic[body][i]),
                },
                encounter.spacing,
                revolution,
            )?;
            powers.in_contact[body] += power.in_contact.si();
            powers.after_contact[body] += power.after_contact.si();
        }
    }
    Ok(powers)
}
