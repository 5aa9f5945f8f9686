//! The film of a mesh position by the film law and the thermal reduction of a case.

use asperity_case::case::OperatingCase;
use asperity_case::error::PositionError;
use asperity_ehl_regime::starvation::starved;
use asperity_ehl_regime::thermal_reduction::gupta_as_printed;
use asperity_ehl_regime::{FilmConditions, FilmThickness, ThermalLaw, thermal_loading};

use crate::mesh::MeshPosition;
use asperity_case::formula_film::FormulaFilm;

/// The film at `position` with the oil, film law and thermal reduction of `case`.
///
/// # Errors
/// When a law refuses the numbers.
pub fn formula_film(
    case: &OperatingCase,
    position: &MeshPosition,
) -> Result<FormulaFilm, PositionError> {
    let motion = &position.motion;
    let conditions = FilmConditions {
        entrainment: motion.entrainment,
        radius: motion.radius,
        load: position.load,
        modulus: case.modulus,
        viscosity: case.oil().dynamic_viscosity,
        pressure_viscosity: case.oil().pressure_viscosity,
        contact_length: Some(case.gears.face_width),
    };
    let smooth = case.film_law().film(&conditions)?;
    let loading = thermal_loading(
        case.oil().dynamic_viscosity,
        case.oil().temperature_coefficient,
        motion.entrainment,
        case.oil().thermal_conductivity,
    )?;
    let max_pressure = position.hertz.max_pressure;
    let (thermal, slide_to_roll) = (case.model.thermal, motion.slide_to_roll);
    let mut reduction = thermal.reduction(max_pressure, case.modulus, loading, slide_to_roll)?;
    if thermal == ThermalLaw::Gupta && case.overrides.printed_thermal {
        reduction.value = gupta_as_printed(max_pressure, case.modulus, loading, slide_to_roll)?;
    }
    let mut outside = smooth.outside;
    outside.extend(reduction.outside);
    let mut film = smooth.value.reduced(reduction.value);
    if let Some(layer) = case.model.inlet_layer {
        film = film.reduced(starved(film.central, layer)?);
    }
    let printed = case.formulation.printed_film();
    let shown = FilmThickness {
        central: printed.thickness(film.central, max_pressure)?,
        ..film
    };
    Ok(FormulaFilm {
        conditions,
        thermal_reduction: reduction.value,
        film,
        shown,
        outside,
    })
}
