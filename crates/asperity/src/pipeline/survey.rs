//! Film, load share and regime along the path of contact without friction, which the paper evaluates before it branches.

use asperity_core::numerics::{mean, median};
use asperity_core::quantity::Length;
use asperity_ns_film::{FluidModel, pressure_difference_across};
use serde::Serialize;

use asperity_core::provenance::Provenance;

use super::stages::{Stages, sampled, settled, warmed};
use crate::lubrication::{Decision, FormulaFilm, check_mesh_position, plausible_film};
use crate::mesh::{MeshPosition, position_at};
use crate::paper::film_at;
use crate::result::Regime;
use asperity_case::case::{Case, LoadedCase};
use asperity_case::error::{Error, PositionError};

/// Film and regime at one mesh position, mean over the offsets, Λ* their median.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RegimeRow {
    /// 0 at A, 1 at E.
    pub path_fraction: f64,
    /// Line load \[N/mm\].
    pub line_load_n_per_mm: f64,
    /// Hertz pressure \[MPa\].
    pub hertz_pressure_mpa: f64,
    /// Sliding speed \[m/s\].
    pub sliding_m_per_s: f64,
    /// Entrainment speed \[m/s\].
    pub entrainment_m_per_s: f64,
    /// Central film with thermal reduction \[µm\].
    pub film_central_um: f64,
    /// Minimum film with thermal reduction \[µm\].
    pub film_minimum_um: f64,
    /// Thermal reduction φ.
    pub thermal_reduction: f64,
    /// Λ*; absent when the peaks of the flanks are not known.
    pub lambda_star: Option<f64>,
    /// Minimum film over composite Rq; absent between flat flanks.
    pub film_ratio: Option<f64>,
    /// Share of the load the film carries.
    pub film_share: f64,
    /// Share of the offsets whose asperities carry 2 % of the load and more; with `formulation = "paper"`, Λ* < 1.
    pub mixed_share: f64,
}

/// Film and regime at every mesh position of a case.
///
/// # Errors
/// When an equation refuses the numbers at a position.
pub fn survey(loaded: &LoadedCase) -> Result<Vec<RegimeRow>, Error> {
    let (sampled, contacts) = sampled(loaded, None, &[])?;
    let warmed = warmed(&sampled, &contacts, true)?;
    let case = &warmed.case;
    let stages = Stages::of(&warmed, &contacts, &|_, _| {}, Provenance::new())?;
    let rows = stages.mesh.positions.iter().map(|at| {
        let (film, decisions) = stages
            .lubrication()
            .decisions(at, stages.contacts.at(at)?)?;
        Ok(row(case, at, (&film, &decisions)))
    });
    let rows: Result<_, PositionError> = rows.collect();
    rows.map_err(|error| Error::Whole(Box::new(error)))
}

fn row(
    case: &Case,
    at: &MeshPosition,
    (film, decisions): (&FormulaFilm, &[Decision]),
) -> RegimeRow {
    let path = case.gears.path();
    let over = |of: &dyn Fn(&Decision) -> f64| mean(decisions.iter().map(of));
    RegimeRow {
        path_fraction: (at.s - path.a) / (path.e - path.a),
        line_load_n_per_mm: at.load.si() * 1e-3,
        hertz_pressure_mpa: at.hertz.max_pressure.si() * 1e-6,
        sliding_m_per_s: at.motion.sliding.si(),
        entrainment_m_per_s: at.motion.entrainment.si(),
        film_central_um: film.shown.central.si() * 1e6,
        film_minimum_um: film.shown.minimum.si() * 1e6,
        thermal_reduction: film.thermal_reduction,
        lambda_star: median(decisions.iter().filter_map(|d| d.lambda_star)),
        film_ratio: Some(over(&|d| d.film_ratio)).filter(|ratio| ratio.is_finite()),
        film_share: over(&|d| d.shared.film_share),
        mixed_share: over(&|d| f64::from(d.regime == Regime::Mixed)),
    }
}

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
    let found = settled(loaded, None)?;
    film_rows(&found, place).map_err(|error| Error::Whole(Box::new(error)))
}

fn film_rows(loaded: &LoadedCase, place: Option<f64>) -> Result<FilmSurvey, PositionError> {
    /// Four thicknesses a decade over six decades from 1 nm.
    const PER_DECADE: i32 = 4;
    const DECADES: i32 = 6;
    const THINNEST: f64 = 1e-9;
    let case = &loaded.case;
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
        let film = film_at(case, &position, Length::from_si(thickness));
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
