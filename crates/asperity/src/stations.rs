//! From a case to its mesh positions without roughness.

use asperity_contact::hertz_line::HertzLine;
use asperity_core::quantity::Length;
use asperity_ehl_regime::{FilmConditions, thermal_loading};

use crate::case::Case;
use crate::chosen_laws::ChosenLaws;
use crate::error::PositionError;
use crate::formulation;
use crate::station::Station;

/// The mesh positions without roughness: along the path, or the paper's single one.
///
/// # Errors
/// When an equation refuses the numbers at a position.
pub fn stations(case: &Case) -> Result<Vec<Station>, PositionError> {
    stations_with(case, &ChosenLaws::of(case))
}

/// The same with laws looked up before.
pub(crate) fn stations_with(case: &Case, laws: &ChosenLaws) -> Result<Vec<Station>, PositionError> {
    let places = formulation::of(case.formulation).places(case)?;
    places
        .into_iter()
        .enumerate()
        .map(|(index, place)| station(case, laws, index + 1, place.s, place.weight.si()))
        .collect()
}

/// The place `s` of the path of contact on its own: number 1, without weight in a mean.
///
/// # Errors
/// When an equation refuses the numbers there.
pub fn station_at(case: &Case, s: Length) -> Result<Station, PositionError> {
    station(case, &ChosenLaws::of(case), 1, s, 0.0)
}

/// The mesh position at `s` with its weight in the cycle mean.
fn station(
    case: &Case,
    laws: &ChosenLaws,
    number: usize,
    s: Length,
    weight: f64,
) -> Result<Station, PositionError> {
    let motion = case.gears.kinematics(s, case.speed)?;
    let load = laws
        .load_distribution
        .line_load(&case.gears, s, case.torque)?;
    let hertz = HertzLine::new(load, motion.radius, case.modulus)?;
    let film_conditions = FilmConditions {
        entrainment: motion.entrainment,
        radius: motion.radius,
        load,
        modulus: case.modulus,
        viscosity: case.oil.dynamic_viscosity,
        pressure_viscosity: case.oil.pressure_viscosity,
        contact_length: Some(case.gears.face_width),
    };
    let smooth = laws.film.film(&film_conditions)?;
    let loading = thermal_loading(
        case.oil.dynamic_viscosity,
        case.oil.temperature_coefficient,
        motion.entrainment,
        case.oil.thermal_conductivity,
    )?;
    let reduction = case.model.thermal.reduction(
        hertz.max_pressure,
        case.modulus,
        loading,
        motion.slide_to_roll,
    )?;
    let mut outside = smooth.outside;
    outside.extend(reduction.outside);
    Ok(Station {
        number,
        s,
        weight,
        motion,
        load,
        hertz,
        film_conditions,
        thermal_reduction: reduction.value,
        film: smooth.value.reduced(reduction.value),
        outside,
    })
}
