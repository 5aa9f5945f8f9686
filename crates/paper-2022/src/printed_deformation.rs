//! Deformation loss as the paper prints it.

use asperity::PositionError;
use asperity::contacts::Displacements;
use asperity::window_pressures::{DeformationPower, Pressed, WindowConditions};
use asperity_contact::plasticity::elastic_shares;
use asperity_contact::subsurface::subsurface_stress;
use asperity_core::quantity::{Length, Pressure, Time};
use asperity_efficiency::deformation::{SurfaceDeformation, printed_deformation};

/// Deformation loss as the paper prints it: von Mises stress at the surface times displacement times the square
/// of a cell over the time of a revolution, summed over the cells.
pub(crate) fn printed_deformation_of(
    window: &WindowConditions<'_>,
    pressed: &Pressed,
    shear: &[f64],
) -> Result<DeformationPower, PositionError> {
    let (pair, materials) = (window.pair, window.materials);
    let revolution = Time::from_si(2.0 * std::f64::consts::PI / window.speed.si());
    let bodies = match &pressed.solids {
        Some(solids) => {
            let found = Displacements::new(materials, window.flow_pressure, solids)?;
            measured_from_edge(found, &solids.pressure)
        }
        None => hertz(window)?,
    };
    // Where the film has cavitated there is nothing to press.
    let solid = pressed.solids.as_ref().map(|solids| &solids.pressure);
    let pressure: Vec<f64> = (pressed.fluid.iter().enumerate())
        .map(|(i, fluid)| fluid.max(0.0) + solid.map_or(0.0, |solid| solid[i]))
        .collect();
    let surface = subsurface_stress(&pressure, Some(shear), pair.spacing, &[0.0])?;
    let mut powers = DeformationPower::default();
    for (body, material) in materials.iter().enumerate() {
        let stress = surface.von_mises(material.poisson)?;
        for (i, stress) in stress.into_iter().enumerate() {
            let power = printed_deformation(
                &SurfaceDeformation {
                    stress: Pressure::from_si(stress),
                    elastic: Length::from_si(bodies.elastic[body][i]),
                    plastic: Length::from_si(bodies.plastic[body][i]),
                },
                pair.spacing,
                revolution,
            )?;
            powers.in_contact[body] += power.in_contact.si();
            powers.after_contact[body] += power.after_contact.si();
        }
    }
    Ok(powers)
}

/// Displacement inside the contact from its edge, so that it does not depend on a datum: the
/// least displacement under pressure counts as zero, and so does all that lies outside.
fn measured_from_edge(mut bodies: Displacements, pressure: &[f64]) -> Displacements {
    for field in &mut bodies.elastic {
        let loaded = || pressure.iter().map(|&p| p > 0.0);
        let edge = field
            .iter()
            .zip(loaded())
            .filter(|(_, loaded)| *loaded)
            .map(|(u, _)| *u)
            .fold(f64::INFINITY, f64::min);
        for (u, loaded) in field.iter_mut().zip(loaded()) {
            *u = if loaded { *u - edge } else { 0.0 };
        }
    }
    bodies
}

/// Displacement of smooth bodies under Hertz's pressure, (a² − x²)/2R from the edge.
fn hertz(window: &WindowConditions<'_>) -> Result<Displacements, PositionError> {
    let [pinion, wheel] = window.materials;
    let (position, x) = (window.position, &window.pair.x);
    let radius = position.motion.radius;
    let displacement = |&x: &f64| {
        let place = Length::from_si(x);
        Ok(position.hertz.displacement_from_edge(place, radius)?.si())
    };
    let both = x.iter().map(displacement);
    let both = both.collect::<Result<Vec<f64>, PositionError>>()?;
    let shares = elastic_shares(pinion, wheel)?;
    let mut bodies = Displacements::none(x.len());
    bodies.elastic = shares.map(|share| both.iter().map(|u| share * u).collect());
    Ok(bodies)
}
