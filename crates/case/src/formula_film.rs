//! The film of a mesh position by the formulas, without roughness.

use asperity_core::OutOfRange;
use asperity_ehl_regime::starvation::starved;
use asperity_ehl_regime::{FilmConditions, FilmThickness, thermal_loading};

use crate::case::Case;
use crate::error::PositionError;
use crate::mesh_position::MeshPosition;

/// Film of smooth flanks at a mesh position, by the film law of a case with its thermal reduction.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct FormulaFilm {
    /// Inputs of the film laws.
    pub conditions: FilmConditions,
    /// Thermal reduction φ of film and rolling.
    pub thermal_reduction: f64,
    /// Film with thermal reduction, as the formulas give it: their central film is one of mass flow.
    pub film: FilmThickness,
    /// The film with the central thickness that Λ* and the tables take.
    pub shown: FilmThickness,
    /// Inputs that left their fitted range.
    pub outside: Vec<OutOfRange>,
}

impl FormulaFilm {
    /// The film at `position` with the oil, film law and thermal reduction of `case`.
    ///
    /// # Errors
    /// When a law refuses the numbers.
    pub fn of(case: &Case, position: &MeshPosition) -> Result<Self, PositionError> {
        let motion = &position.motion;
        let conditions = FilmConditions {
            entrainment: motion.entrainment,
            radius: motion.radius,
            load: position.load,
            modulus: case.modulus,
            viscosity: case.oil.dynamic_viscosity,
            pressure_viscosity: case.oil.pressure_viscosity,
            contact_length: Some(case.gears.face_width),
        };
        let smooth = case.film_law().film(&conditions)?;
        let loading = thermal_loading(
            case.oil.dynamic_viscosity,
            case.oil.temperature_coefficient,
            motion.entrainment,
            case.oil.thermal_conductivity,
        )?;
        let max_pressure = position.hertz.max_pressure;
        let reduction = case.model.thermal.reduction(
            max_pressure,
            case.modulus,
            loading,
            motion.slide_to_roll,
        )?;
        let mut outside = smooth.outside;
        outside.extend(reduction.outside);
        let mut film = smooth.value.reduced(reduction.value);
        if let Some(layer) = case.model.inlet_layer {
            film = film.reduced(starved(film.central, layer)?);
        }
        let lambda_film = case.model.lambda_film;
        let shown = FilmThickness {
            central: lambda_film.thickness(film.central, max_pressure)?,
            ..film
        };
        Ok(Self {
            conditions,
            thermal_reduction: reduction.value,
            film,
            shown,
            outside,
        })
    }
}
