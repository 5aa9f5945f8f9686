//! Pressure difference across the film by its thickness: the paper's Fig. 8.

use asperity::case::{LoadedCase, OperatingCase};
use asperity::lubrication::{check_mesh_position, plausible_film};
use asperity::mesh::position_at;
use asperity::{Error, PositionError, Run};
use asperity_core::quantity::Length;
use asperity_ns_film::{FluidModel, pressure_difference_across};
use serde::Serialize;

use crate::film_pressure::film_between;

/// Pressure difference across a film of one thickness: a point of the paper's Fig. 8.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FilmRow {
    /// Film thickness on the line of centres \[m\].
    pub thickness_m: f64,
    /// Difference of the wall pressures with Reynolds and the cross-film term \[Pa\].
    pub reynolds_cross_pa: f64,
    /// Difference with the paper's radial momentum equation \[Pa\].
    pub paper_pa: f64,
    /// The larger of both over the Hertz pressure.
    pub ratio_to_hertz: f64,
    /// Thickness over the radius of the wheel's flank.
    pub thickness_over_radius: f64,
}

/// The film of a case at one place: the paper's Fig. 8.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FilmSurvey {
    /// Place on the path, 0 at A and 1 at E.
    pub path_fraction: f64,
    /// Hertz pressure there \[Pa\].
    pub hertz_pressure_pa: f64,
    /// Central film of the case there \[m\].
    pub film_central_m: f64,
    /// Differences by thickness.
    pub rows: Vec<FilmRow>,
}

/// Pressure difference across films from 1 nm to 1 mm at `place` on the path, 0 at A and 1 at E; at
/// the pitch point when none is given, where the flanks roll without sliding and both models agree.
///
/// # Errors
/// When an equation refuses the numbers there.
pub fn film(loaded: &LoadedCase, place: Option<f64>) -> Result<FilmSurvey, Error> {
    let found = Run::new(loaded).operating_case()?;
    film_rows(&found, place).map_err(|error| Error::Whole(Box::new(error)))
}

fn film_rows(case: &OperatingCase, place: Option<f64>) -> Result<FilmSurvey, PositionError> {
    /// Four thicknesses a decade over six decades from 1 nm.
    const PER_DECADE: i32 = 4;
    const DECADES: i32 = 6;
    const THINNEST: f64 = 1e-9;
    let path = case.gears.path();
    let place = place.unwrap_or((path.c - path.a) / (path.e - path.a));
    let s = path.a + (path.e - path.a) * place;
    let position = position_at(case, s)?;
    check_mesh_position(&position)?;
    let central = plausible_film(case, &position)?.shown.central;
    let hertz = position.hertz.max_pressure.si();
    let mut rows = Vec::new();
    for step in 0..=PER_DECADE * DECADES {
        let thickness = THINNEST * 10f64.powf(f64::from(step) / f64::from(PER_DECADE));
        let film = film_between(
            &case.gears,
            case.oil(),
            &position,
            Length::from_si(thickness),
        );
        let across = |model| pressure_difference_across(model, &film).map(|p| p.si());
        let (reynolds, paper) = (
            across(FluidModel::ReynoldsCross)?,
            across(FluidModel::Paper)?,
        );
        rows.push(FilmRow {
            thickness_m: thickness,
            reynolds_cross_pa: reynolds,
            paper_pa: paper,
            ratio_to_hertz: reynolds.abs().max(paper.abs()) / hertz,
            thickness_over_radius: thickness / position.motion.rho2.si(),
        });
    }
    Ok(FilmSurvey {
        path_fraction: place,
        hertz_pressure_pa: hertz,
        film_central_m: central.si(),
        rows,
    })
}
