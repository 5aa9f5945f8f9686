//! Gate after the run: states at a mesh position that are beyond physical sense end without an efficiency.
//!
//! The limits are own choices, some powers of ten beyond what was ever measured on gears, where the model says
//! nothing any more whatever its laws return.

use super::film_of_case::formula_film;
use super::position::LubricatedPosition;
use crate::mesh::MeshPosition;
use asperity_case::case::OperatingCase;
use asperity_case::error::PositionError;
use asperity_case::formula_film::FormulaFilm;
use asperity_case::physical_limits::{HIGHEST_PRESSURE, HIGHEST_SPEED};

/// Film \[m\]: gear films are below 10 um.
const FILM: f64 = 1e-3;
/// Rq of a flank under the contact \[m\].
const ROUGHNESS: f64 = 0.2e-3;
/// Flash temperature \[K\]: steel melts at 1800 K.
const FLASH: f64 = 1500.0;
/// Friction coefficient of the whole contact.
const FRICTION: f64 = 2.0;

/// Refuses a smooth contact that cannot be.
///
/// # Errors
/// With a pressure or a speed beyond physical sense.
pub fn check_mesh_position(position: &MeshPosition) -> Result<(), PositionError> {
    let motion = &position.motion;
    let speeds = motion.u1.si().abs().max(motion.u2.si().abs());
    let pressure = position.hertz.max_pressure.si();
    below("Hertz pressure", pressure, "Pa", HIGHEST_PRESSURE.si())?;
    below("speed of the flanks", speeds, "m/s", HIGHEST_SPEED)
}

/// The film at `position` by the formulas, unless it cannot be.
///
/// # Errors
/// When a law refuses the numbers, or with a film beyond physical sense.
pub fn plausible_film(
    case: &OperatingCase,
    position: &MeshPosition,
) -> Result<FormulaFilm, PositionError> {
    let film = formula_film(case, position)?;
    below("central film", film.film.central.si(), "m", FILM)?;
    let minimum = film.film.minimum.si();
    if minimum > 0.0 {
        return Ok(film);
    }
    Err(PositionError::impossible(
        "minimum film",
        minimum,
        "m",
        "greater than zero",
        None,
    ))
}

/// Refuses a solved position that cannot be.
pub(crate) fn check_position(position: &LubricatedPosition) -> Result<(), PositionError> {
    let load = position.at.load.si();
    for offset in &position.offsets {
        let [first, second] = offset.roughness.rq;
        below("Rq under the contact", first.max(second), "m", ROUGHNESS)?;
        below("flash temperature", offset.flash, "K", FLASH)?;
        let friction = offset.friction_force / load;
        below("friction coefficient", friction, "-", FRICTION)?;
    }
    Ok(())
}

fn below(
    name: &'static str,
    value: f64,
    unit: &'static str,
    limit: f64,
) -> Result<(), PositionError> {
    // No number is not below the limit either.
    if value <= limit {
        return Ok(());
    }
    Err(PositionError::impossible(
        name,
        value,
        unit,
        "at most",
        Some(limit),
    ))
}
