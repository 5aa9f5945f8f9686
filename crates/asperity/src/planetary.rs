//! The run of a planetary set: both kinds of meshes, and their loss together.

use asperity_core::quantity::Power;
use asperity_gear::planetary::{PlanetaryMesh, PlanetarySpeeds};
use serde::{Deserialize, Serialize};

use crate::case::planetary::LoadedPlanetary;
use crate::error::{Error, PositionError};
use crate::pipeline::KeptFields;
use crate::pipeline::Progress;
use crate::result::gearbox::Scope;
use crate::result::{Outcome, RunResult};
use crate::result::{rounded, with_interval};
use crate::uncertainty::{Quantiles, run_and_draw};

/// The result of a planetary set, in addition to the results of its meshes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct PlanetaryResult {
    /// The program and its version.
    pub program: String,
    /// Title of the case.
    pub title: String,
    /// Scope of the result: the meshes only.
    #[serde(default)]
    pub scope: Scope,
    /// Number of planets.
    pub planets: u32,
    /// Efficiency of the set from its mesh losses only.
    pub efficiency: f64,
    /// Loss of all meshes \[W\].
    pub loss_w: f64,
    /// Its median, quantiles and spread as drawn; none of a formulation without uncertainty.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub loss_distribution: Option<Quantiles>,
    /// Power that enters through sun, ring and carrier \[W\].
    pub power_in_w: f64,
    /// Power that passes the meshes: torque of the sun times its speed relative to the carrier \[W\].
    pub rolling_power_w: f64,
    /// Speed of the sun \[rad/s\].
    pub sun_rad_per_s: f64,
    /// Speed of the ring \[rad/s\].
    pub ring_rad_per_s: f64,
    /// Speed of the carrier \[rad/s\].
    pub carrier_rad_per_s: f64,
    /// Speed of the planets relative to the carrier \[rad/s\].
    pub planet_relative_rad_per_s: f64,
    /// Whether equally spaced planets can be assembled.
    pub can_be_equally_spaced: bool,
    /// Load of the most loaded planet over the mean, K_γ.
    pub load_share_factor: f64,
    /// Meshes of sun and planet, and of planet and ring.
    pub meshes: Vec<MeshRow>,
}

/// One kind of mesh of a planetary set.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct MeshRow {
    /// Gears of the mesh.
    pub mesh: String,
    /// Torque at its pinion \[N m\].
    pub torque_nm: f64,
    /// Speed of its pinion relative to the carrier \[rad/s\].
    pub speed_rad_per_s: f64,
    /// Loss of one such mesh \[W\].
    pub loss_w: f64,
    /// Its median as drawn.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub loss_median_w: Option<f64>,
    /// Its 5 % quantile.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub loss_q05_w: Option<f64>,
    /// Its 95 % quantile.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub loss_q95_w: Option<f64>,
    /// Efficiency of the mesh.
    pub efficiency: f64,
    /// Loss factor of its load.
    pub loss_factor: f64,
    /// Friction coefficient that explains its loss.
    pub mu_equivalent: f64,
    /// Highest Hertz pressure of its cells at the mean load \[MPa\].
    pub hertz_pressure_mpa: f64,
    /// The same at the most loaded planet, √K_γ times as high \[MPa\].
    pub hertz_pressure_most_loaded_mpa: f64,
}

/// A run of a planetary set.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct PlanetaryOutcome {
    /// Loss of the set and a row of each kind of mesh.
    pub result: PlanetaryResult,
    /// Sun and planet, planet and ring.
    pub meshes: [Outcome; 2],
}

/// Runs both meshes of a planetary set; fields are held for the positions `kept` of each mesh.
///
/// # Errors
/// When a mesh has no solution.
pub fn run_planetary(
    loaded: &LoadedPlanetary,
    kept: &KeptFields,
    progress: Progress<'_>,
) -> Result<PlanetaryOutcome, Error> {
    let [first, second] = &loaded.meshes;
    let (of_first, drawn_first) = run_and_draw(first, Some(kept), progress)?;
    let (of_second, drawn_second) = run_and_draw(second, Some(kept), progress)?;
    let meshes = [of_first, of_second];
    let mut result = result(loaded, [&meshes[0].result, &meshes[1].result])
        .map_err(|error| Error::Whole(Box::new(error)))?;
    if let (Some(first), Some(second)) = (drawn_first, drawn_second) {
        // The meshes share oil and constants, so that these are drawn together, their flanks apart.
        let planets = f64::from(result.planets);
        let both = first
            .draws_w()
            .into_iter()
            .zip(second.draws_of_sum_w(1, 1.0));
        let drawn: Vec<f64> = both.map(|(a, b)| planets * (a + b)).collect();
        result.loss_distribution = Some(Quantiles::of(&drawn));
    }
    Ok(PlanetaryOutcome { result, meshes })
}

fn result(
    loaded: &LoadedPlanetary,
    runs: [&RunResult; 2],
) -> Result<PlanetaryResult, PositionError> {
    let (set, operation) = (&loaded.set, &loaded.operation);
    let loads = set.meshes(operation)?;
    let PlanetarySpeeds {
        sun,
        ring,
        carrier,
        planet_relative,
        ..
    } = set.speeds(operation.sun_speed, operation.ring_speed)?;
    let [first, second] = runs.map(|run| Power::from_si(run.summary.loss_w));
    let loss = set.loss(first, second).si();
    let power_in = set.input_power(operation)?.si();
    let share = operation.load_share_factor;
    Ok(PlanetaryResult {
        program: concat!("asperity ", env!("CARGO_PKG_VERSION")).to_owned(),
        title: loaded.title.clone(),
        scope: Scope::Mesh,
        planets: set.planets,
        efficiency: 1.0 - loss / power_in,
        loss_w: loss,
        loss_distribution: None,
        power_in_w: power_in,
        rolling_power_w: set.rolling_power(operation)?.si(),
        sun_rad_per_s: sun.si(),
        ring_rad_per_s: ring.si(),
        carrier_rad_per_s: carrier.si(),
        planet_relative_rad_per_s: planet_relative.si(),
        can_be_equally_spaced: set.can_be_equally_spaced(),
        load_share_factor: share,
        meshes: vec![
            row("sun and planet", &loads[0], runs[0], share),
            row("planet and ring", &loads[1], runs[1], share),
        ],
    })
}

fn row(name: &str, load: &PlanetaryMesh, run: &RunResult, share: f64) -> MeshRow {
    let pressures = run.path.iter().map(|row| row.hertz_pressure_mpa);
    let highest = pressures.fold(0.0, f64::max);
    let drawn = run.uncertainty.as_ref().map(|found| &found.loss);
    MeshRow {
        mesh: name.to_owned(),
        torque_nm: load.torque.si(),
        speed_rad_per_s: load.speed.si(),
        loss_w: run.summary.loss_w,
        loss_median_w: drawn.map(|loss| loss.median_w),
        loss_q05_w: drawn.map(|loss| loss.quantiles_w[0]),
        loss_q95_w: drawn.map(|loss| loss.quantiles_w[1]),
        efficiency: run.summary.efficiency,
        loss_factor: run.summary.loss_factor_local,
        mu_equivalent: run.summary.mu_equivalent,
        hertz_pressure_mpa: highest,
        hertz_pressure_most_loaded_mpa: highest * share.sqrt(),
    }
}

impl PlanetaryResult {
    /// Loss \[W\] and efficiency \[%\] with their bands, each with the digits that its band leaves.
    #[must_use]
    pub fn with_bands(&self) -> [String; 2] {
        let Some(drawn) = &self.loss_distribution else {
            return [self.loss_w, 100.0 * self.efficiency].map(|value| format!("{value:.4}"));
        };
        with_interval(drawn.median_w, drawn.quantiles_w, self.power_in_w, ["", ""])
    }
}

impl MeshRow {
    /// Loss \[W\], efficiency \[%\] and μ_eq with the digits that the band of the loss leaves.
    #[must_use]
    pub fn with_digits(&self) -> [String; 3] {
        let half = match (self.loss_q05_w, self.loss_q95_w) {
            (Some(low), Some(high)) => 0.5 * (high - low),
            _ => 0.0,
        };
        // The losses of a mesh are its power times the rest of its efficiency.
        let power = self.loss_w / (1.0 - self.efficiency);
        [
            rounded(self.loss_w, half),
            rounded(100.0 * self.efficiency, 100.0 * half / power),
            rounded(self.mu_equivalent, self.mu_equivalent * half / self.loss_w),
        ]
    }
}
