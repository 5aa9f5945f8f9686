//! Elastohydrodynamic solutions of full films: steady and smooth, or means over records.

use asperity_core::quantity::Length;
use asperity_ehl::traction::{Heat, TractionLaw, traction};
use asperity_ehl::{Oil, SteadySettings, steady};
use asperity_ehl_regime::inlet_flow::CentralFilm;
use asperity_oil::{PressureLaw, PressureViscosityLaw};

use super::full_film::{FilmFields, FullFilm};
use super::smooth_position::SmoothPosition;
use crate::records::PathRecords;
use crate::reference_solution::smooth_contact;
use asperity_case::case::{FullFilmName, OperatingCase};
use asperity_case::error::PositionError;

/// The full film of `position` by the choice of the case; none for formulas, and where records were asked
/// for and there are none. `law` is the friction of the film by the case's law, none for a published one.
pub(crate) fn full_film_at(
    case: &OperatingCase,
    SmoothPosition {
        at: position,
        film: formula,
    }: SmoothPosition<'_>,
    records: Option<&PathRecords>,
    law: Option<f64>,
) -> Result<Option<FullFilm>, PositionError> {
    match (case.model.full_film, records) {
        (FullFilmName::Ehl, _) => Ok(Some(smooth(
            case,
            SmoothPosition {
                at: position,
                film: formula,
            },
            law,
        )?)),
        (FullFilmName::EhlTransient, Some(records)) => Ok(Some(recorded(
            SmoothPosition {
                at: position,
                film: formula,
            },
            records,
            law,
        )?)),
        _ => Ok(None),
    }
}

/// Steady film of smooth flanks with its traction: limiting shear stress, heat of film and surfaces.
///
/// The inlet is isothermal; the thermal reduction of the case thins the film as it does that of the formula.
fn smooth(
    case: &OperatingCase,
    SmoothPosition {
        at: position,
        film: formula,
    }: SmoothPosition<'_>,
    law: Option<f64>,
) -> Result<FullFilm, PositionError> {
    let (contact, oil) = smooth_contact(case, position);
    let settings = SteadySettings {
        cells: case.model.ehl.cells,
        window: None,
    };
    let film = steady::solve(&contact, &oil, &settings)?.value;
    let reduction = formula.thermal_reduction;
    let scale = film.scales.film_length(1.0).si() * reduction;
    let coefficient = match law {
        Some(_) => {
            let law = traction_law(case)?;
            // The film is solved with Roelands' law; its shear is that of the case's friction.
            let sheared = Oil {
                viscosity_law: viscosity_law(case, oil.viscosity_law),
                ..oil
            };
            Some(traction(&contact, &sheared, &film, &law)?.coefficient)
        }
        None => None,
    };
    // The formula's central film is a flow of mass.
    let flow = film.flux * scale / formula.film.central.si();
    let central = film.central_film.si() * reduction;
    let p_0 = position.hertz.max_pressure.si();
    Ok(FullFilm::new(
        SmoothPosition {
            at: position,
            film: formula,
        },
        FilmFields {
            x: film.x,
            pressure: film.pressure.iter().map(|p| p * p_0).collect(),
            film: film.film.iter().map(|h| h * scale).collect(),
        },
        [central, film.minimum_film.si() * reduction, flow],
        [coefficient, law],
    ))
}

/// Means over the neighbouring records.
fn recorded(
    SmoothPosition {
        at: position,
        film: formula,
    }: SmoothPosition<'_>,
    records: &PathRecords,
    law: Option<f64>,
) -> Result<FullFilm, PositionError> {
    let p_0 = position.hertz.max_pressure;
    let (x, pressure, film) = records.profile(position.s);
    let share = records.at(position.s, law);
    let gap = Length::from_si(share.mean_gap.mean);
    // The formula's film is a flow of mass: the gap is thinner by the density under pressure.
    let gap_of_formula = CentralFilm::Gap.thickness(formula.film.central, p_0)?;
    let minimum = film
        .iter()
        .zip(&x)
        .filter(|(_, x)| x.abs() < 1.0)
        .map(|(film, _)| *film)
        .fold(f64::INFINITY, f64::min);
    let flow = gap / gap_of_formula;
    let pressure = pressure.iter().map(|p| p * p_0.si()).collect();
    Ok(FullFilm::new(
        SmoothPosition {
            at: position,
            film: formula,
        },
        FilmFields { x, pressure, film },
        [gap.si(), minimum, flow],
        [share.film_coefficient, law],
    ))
}

/// Viscosity over pressure of the film friction of the case.
fn viscosity_law(case: &OperatingCase, of_film: PressureViscosityLaw) -> PressureViscosityLaw {
    match case.model.film_pressure_law {
        PressureLaw::Barus => PressureViscosityLaw::Barus,
        _ => of_film,
    }
}

/// Shear law of the film friction with the limiting stress and the heat of the case.
fn traction_law(case: &OperatingCase) -> Result<TractionLaw, PositionError> {
    let rheology = case
        .rheology()
        .ok_or_else(asperity_oil::LubricantError::no_base_oil)?;
    let constants = rheology.constants();
    Ok(TractionLaw {
        shear: constants.shear_law(rheology.laws().0),
        limit: Some(constants.limiting_shear_at(case.temperature())),
        heat: Some(Heat {
            bulk: case.temperature(),
            temperature_coefficient: case.oil().temperature_coefficient,
            oil_conductivity: case.oil().thermal_conductivity,
            material: case.materials[0],
        }),
    })
}
