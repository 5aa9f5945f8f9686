//! Film, load share and regime along the path of contact without friction, which the 2022 paper evaluates before it branches.

use asperity_core::numerics::{mean, median};
use serde::Serialize;

use asperity_core::provenance::Provenance;

use super::stages::{Stages, sampled, warmed};
use crate::lubrication::{Decision, FormulaFilm};
use crate::mesh::MeshPosition;
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
    let (sampled, contacts) = sampled(loaded, &[])?;
    let warmed = warmed(&sampled, &contacts, true)?;
    let case = &warmed;
    let stages = Stages::new(&warmed, &contacts, &|_, _| {}, Provenance::new())?;
    let rows = stages.mesh.positions.iter().map(|at| {
        let (film, decisions) = stages
            .lubrication()
            .decisions(at, stages.contacts.at(at)?)?;
        Ok(row(case, at, &film, &decisions))
    });
    let rows: Result<_, PositionError> = rows.collect();
    rows.map_err(|error| Error::Whole(Box::new(error)))
}

fn row(case: &Case, at: &MeshPosition, film: &FormulaFilm, decisions: &[Decision]) -> RegimeRow {
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
