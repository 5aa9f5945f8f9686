//! From a case to its mesh positions without roughness.

use asperity_contact::hertz_line::HertzLine;
use asperity_core::quantity::Length;
use asperity_ehl_regime::{FilmConditions, FilmThickness, thermal_loading};
use asperity_gear::LoadMap;

use crate::case::Case;
use crate::chosen_laws::ChosenLaws;
use crate::error::PositionError;
use crate::formulation;
use crate::station::{Place, Resolution, Station};

/// The mesh positions without roughness: along the path, or the paper's single one.
///
/// # Errors
/// When an equation refuses the numbers at a position.
pub fn stations(case: &Case) -> Result<Vec<Station>, PositionError> {
    Ok(stations_with(case, &ChosenLaws::of(case))?.1)
}

/// The load over the flanks and the mesh positions, with laws looked up before.
pub(crate) fn stations_with(
    case: &Case,
    laws: &ChosenLaws,
) -> Result<(LoadMap, Vec<Station>), PositionError> {
    let map = case.load_map()?;
    let stations = stations_under(case, laws, &map)?;
    Ok((map, stations))
}

/// The mesh positions under the load of `map`.
pub(crate) fn stations_under(
    case: &Case,
    laws: &ChosenLaws,
    map: &LoadMap,
) -> Result<Vec<Station>, PositionError> {
    let places = formulation::of(case.formulation).places(case, map)?;
    let numbered = places.iter().enumerate();
    numbered
        .map(|(index, place)| station(case, laws, index + 1, place))
        .collect()
}

/// The place `s` of the path of contact on its own, under the mean load over the face: number 1, without
/// weight in a mean.
///
/// # Errors
/// When an equation refuses the numbers there, as where relief keeps the flanks apart.
pub fn station_at(case: &Case, s: Length) -> Result<Station, PositionError> {
    let place = shown_at(&case.load_map()?, s, Resolution::Required)?;
    station(case, &ChosenLaws::of(case), 1, &place)
}

/// The points A to E of the path with the mean load over the face, which are shown and never weighted. A
/// point that the path does not reach, or at which relief keeps the flanks apart, is left out.
pub(crate) fn named_points(
    case: &Case,
    laws: &ChosenLaws,
    map: &LoadMap,
) -> Result<Vec<(&'static str, Station)>, PositionError> {
    let path = case.gears.path();
    let mut found = Vec::new();
    let points = path.named_points().into_iter();
    for (name, s) in points.filter(|(_, s)| (path.a..=path.e).contains(s)) {
        let place = shown_at(map, s, Resolution::WhereFine)?;
        if place.load.si() > 0.0 {
            found.push((name, station(case, laws, found.len() + 1, &place)?));
        }
    }
    Ok(found)
}

fn shown_at(map: &LoadMap, s: Length, resolution: Resolution) -> Result<Place, PositionError> {
    Ok(Place {
        s,
        load: map.mean_line_load(s)?,
        weight: Length::from_si(0.0),
        sliding_factor: 1.0,
        resolution,
        zone: 0,
    })
}

/// The mesh position at a place.
fn station(
    case: &Case,
    laws: &ChosenLaws,
    number: usize,
    place: &Place,
) -> Result<Station, PositionError> {
    let Place { s, load, .. } = *place;
    let motion = case.gears.kinematics(s, case.speed)?;
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
    let film = smooth.value.reduced(reduction.value);
    let shown = case.model.lambda_film;
    let film_shown = FilmThickness {
        central: shown.thickness(film.central, hertz.max_pressure)?,
        ..film
    };
    Ok(Station {
        number,
        s,
        weight: place.weight.si(),
        sliding_factor: place.sliding_factor,
        resolution: place.resolution,
        zone: place.zone,
        motion,
        load,
        hertz,
        film_conditions,
        thermal_reduction: reduction.value,
        film,
        film_shown,
        outside,
    })
}
