//! Pressure of the fluid at the gap of two rough flanks, for the paper's marching.

use asperity::PositionError;
use asperity::gear::GearPair;
use asperity::mesh::MeshPosition;
use asperity::oil::LubricantState;
use asperity::window_pressures::WindowConditions;
use asperity_core::quantity::{Angle, Length};
use asperity_ns_film::film_pressure::{Rupture, film_pressure};
use asperity_ns_film::gap::GapShape;
use asperity_ns_film::{FilmConditions, FluidModel};

/// Pressure of the fluid \[Pa\] at the points of a window where the current gap is `gap` \[m\].
///
/// The paper's model gives the pressure difference across the film at each point, zero where the
/// flanks touch and where the difference draws them together. The consistent model gives the full
/// film pressure of smooth flanks at the mean gap under the Hertz contact.
pub(crate) fn pressure_at_gap(
    window: &WindowConditions<'_>,
    gap: &[f64],
) -> Result<Vec<f64>, PositionError> {
    match window.paper.fluid_pressure {
        FluidModel::Paper => across(window, gap),
        FluidModel::ReynoldsCross => along(window, gap),
    }
}

/// The film between the two flanks at a position, `thickness` apart on the line of centres.
#[must_use]
pub fn film_between(
    gears: &GearPair,
    oil: &LubricantState,
    position: &MeshPosition,
    thickness: Length,
) -> FilmConditions {
    FilmConditions {
        wall_1: position.motion.u1,
        wall_2: position.motion.u2,
        radius_1: position.motion.rho1,
        radius_2: position.motion.rho2,
        film_thickness: thickness,
        angle: Angle::from_si(0.0),
        base_radius: gears.base_radius[1],
        middle_speed: None,
        viscosity: oil.dynamic_viscosity,
        density: oil.density,
    }
}

fn across(window: &WindowConditions<'_>, gap: &[f64]) -> Result<Vec<f64>, PositionError> {
    let Some(&open) = gap.iter().find(|gap| **gap > 0.0) else {
        return Ok(vec![0.0; gap.len()]);
    };
    let thickness = Length::from_si(open);
    let film = film_between(window.gears, window.oil, window.position, thickness);
    let section = film.paper_film().at_any_gap()?;
    gap.iter()
        .map(|&gap| {
            if gap <= 0.0 {
                return Ok(0.0);
            }
            let difference = section.pressure_difference(Length::from_si(gap))?;
            Ok(difference.si().max(0.0))
        })
        .collect()
}

fn along(window: &WindowConditions<'_>, gap: &[f64]) -> Result<Vec<f64>, PositionError> {
    let (position, x) = (window.position, &window.pair.x);
    let half_width = position.hertz.half_width.si();
    let under: Vec<f64> = x
        .iter()
        .zip(gap)
        .filter(|(x, _)| x.abs() <= half_width)
        .map(|(_, gap)| gap.max(0.0))
        .collect();
    let mean = under.iter().sum::<f64>() / under.len() as f64;
    if mean <= 0.0 {
        return Ok(vec![0.0; x.len()]);
    }
    let film = x
        .iter()
        .map(|&x| {
            let place = Length::from_si(x);
            let shape = GapShape::Parabola;
            Ok(shape
                .gap(Length::from_si(mean), place, position.motion.radius)?
                .si())
        })
        .collect::<Result<Vec<f64>, PositionError>>()?;
    let found = film_pressure(
        x,
        &film,
        position.motion.u1 + position.motion.u2,
        window.oil.dynamic_viscosity,
        Rupture::default(),
    )?;
    Ok(found.pressure)
}
