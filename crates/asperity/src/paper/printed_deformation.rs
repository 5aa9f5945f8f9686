//! Deformation loss as the paper prints it.

use asperity_contact::subsurface::subsurface_stress;
use asperity_core::quantity::{Length, Pressure, Time};
use asperity_efficiency::deformation::{SurfaceDeformation, printed_deformation};

use crate::contacts::{Displacements, Pressed};
use crate::mesh::MeshPosition;
use asperity_case::case::Case;
use asperity_case::error::PositionError;
use asperity_case::flanks::WindowPair;

/// Deformation loss of one position in the paper's formulation \[W\], each of pinion and wheel.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct PrintedDeformation {
    /// In contact: elastic and plastic displacement.
    pub in_contact: [f64; 2],
    /// After contact: plastic displacement only.
    pub after_contact: [f64; 2],
}

/// Deformation loss as the paper prints it: von Mises stress at the surface times displacement times the square
/// of a cell over the time of a revolution, summed over the cells.
pub(crate) fn printed_deformation_of(
    case: &Case,
    position: &MeshPosition,
    pair: &WindowPair,
    pressed: &Pressed,
    shear: &[f64],
) -> Result<PrintedDeformation, PositionError> {
    let revolution = Time::from_si(2.0 * std::f64::consts::PI / case.speed.si());
    let bodies = match &pressed.solids {
        Some(solids) => Displacements::new(case, solids)?.measured_from_edge(&solids.pressure),
        None => Displacements::hertz(case, position, &pair.x)?,
    };
    // Where the film has cavitated there is nothing to press.
    let solid = pressed.solids.as_ref().map(|solids| &solids.pressure);
    let pressure: Vec<f64> = (pressed.fluid.iter().enumerate())
        .map(|(i, fluid)| fluid.max(0.0) + solid.map_or(0.0, |solid| solid[i]))
        .collect();
    let surface = subsurface_stress(&pressure, Some(shear), pair.spacing, &[0.0])?;
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
                pair.spacing,
                revolution,
            )?;
            powers.in_contact[body] += power.in_contact.si();
            powers.after_contact[body] += power.after_contact.si();
        }
    }
    Ok(powers)
}
