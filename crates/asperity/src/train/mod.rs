//! The run of a gear train: every mesh, and their loss together.

mod contacts;
#[doc(hidden)]
pub mod heat;

pub(crate) use contacts::contacts;

use asperity_core::{Estimate, PROGRAM};
use std::collections::BTreeMap;

use asperity_core::quantity::Power;
use asperity_core::unique;
use asperity_gear::gear_train::{Shaft, Torques};
use asperity_gear::planetary::{PlanetaryOperation, PlanetarySpeeds};
use serde::{Deserialize, Serialize, Serializer};

use crate::assembly::warnings_of_gearbox;
use crate::contacts::Contacts;
use crate::gearbox;
use crate::pipeline::{self, Options};
use crate::result::gearbox::{GearboxReport, Scope};
use crate::result::loss_band::{Digits, EvidenceRow};
use crate::result::{Losses, MeshOutcome, PositionRow, RunResult, Summary};
use crate::result::{rounded, with_interval};
use crate::uncertainty::{
    DrawnMesh, Predictive, Quantiles, beside, has_band, median_with_ends, predictive, run_and_draw,
};
use asperity_case::balance;
use asperity_case::case::train::{LoadedMesh, Train};
use asperity_case::case::{Flow, LoadedCase, MeshLoad, StageKind};
use asperity_case::error::{Error, PositionError};
use asperity_case::message::Warning;
use heat::{FoundOil, HeatReport};

/// The result of a gear train, in addition to the results of its meshes.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[non_exhaustive]
pub struct Whole {
    /// The program and its version.
    pub program: String,
    /// Title of the case.
    pub title: String,
    /// Scope of the result: the meshes only.
    pub scope: Scope,
    /// The planetary set of a case `[planetary]`.
    #[serde(flatten)]
    pub set: Option<PlanetaryReport>,
    /// Efficiency of the train from its mesh losses only.
    pub efficiency: f64,
    /// Loss of all meshes \[W\]: the median of the draws, without draws the loss of the run.
    pub loss_w: f64,
    /// Loss of the run with every constant at its median \[W\]; `None` without draws.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub loss_at_medians_w: Option<f64>,
    /// Its median, quantiles and spread as drawn; `None` of a formulation without uncertainty.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub loss_distribution: Option<Quantiles>,
    /// Power that enters through all shafts \[W\].
    pub power_in_w: f64,
    /// Power that leaves through all shafts \[W\], by their torques and speeds.
    pub power_out_w: f64,
    /// Loss of all meshes by its kinds.
    pub kinds: LossKinds,
    /// Heat balance, if the case states one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub heat: Option<HeatReport>,
    /// Meshes, seals and bearings together, if the case states some.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gearbox: Option<GearboxReport>,
    /// Shafts with their torques and speeds.
    pub shafts: Vec<ShaftRow>,
    /// The meshes, in a planetary set one of each kind.
    pub meshes: Vec<MeshRow>,
    /// Planetary sets by the names of their stages.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub sets: BTreeMap<String, PlanetaryReport>,
    /// Warnings about the train as a whole; a mesh has its own in its result.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub warnings: Vec<Warning>,
    /// Measurements that would narrow the interval, the one that leaves the narrowest first; empty if they were not sought.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub evidence: Vec<EvidenceRow>,
}

/// Speeds and power of a planetary set.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct PlanetaryReport {
    /// Number of planets.
    pub planets: u32,
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
}

/// Losses of all meshes by their kinds.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[non_exhaustive]
pub struct LossKinds {
    /// Sliding in the film \[W\].
    pub film_w: f64,
    /// Sliding of touching asperities that are lubricated \[W\].
    pub lubricated_asperity_w: f64,
    /// Sliding in the boundary layer of touching asperities \[W\].
    pub boundary_w: f64,
    /// Rolling, hysteresis of the steel included \[W\].
    pub rolling_w: f64,
    /// Plastic displacement, where the formulation counts it \[W\].
    pub deformation_w: f64,
}

impl LossKinds {
    fn from_summary(summary: &Summary) -> Self {
        Self {
            film_w: summary.film_w,
            lubricated_asperity_w: summary.lubricated_asperity_w,
            boundary_w: summary.boundary_w,
            rolling_w: summary.rolling_w,
            deformation_w: summary.deformation_w.iter().sum(),
        }
    }

    fn add(&mut self, other: &Self, count: f64) {
        self.film_w += count * other.film_w;
        self.lubricated_asperity_w += count * other.lubricated_asperity_w;
        self.boundary_w += count * other.boundary_w;
        self.rolling_w += count * other.rolling_w;
        self.deformation_w += count * other.deformation_w;
    }

    /// Name and loss of each kind \[W\].
    #[must_use]
    pub fn rows(&self) -> [(&'static str, f64); 5] {
        [
            ("film", self.film_w),
            ("lubricated asperities", self.lubricated_asperity_w),
            ("boundary layer", self.boundary_w),
            ("rolling", self.rolling_w),
            ("plastic displacement", self.deformation_w),
        ]
    }
}

/// A shaft of a gear train.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct ShaftRow {
    /// Name.
    pub shaft: String,
    /// Speed \[rad/s\], negative against the direction of the input shaft.
    pub speed_rad_per_s: f64,
    /// Torque that passes through the shaft \[N m\].
    pub carried_nm: f64,
    /// Torque into the train at the shaft \[N m\], with all losses; zero of a shaft between two meshes.
    pub torque_nm: f64,
    /// Power into the train at the shaft \[W\].
    pub power_w: f64,
    /// Part of the carried torque that follows from the losses \[N m\].
    pub by_losses_nm: f64,
}

/// Kind of loss of all meshes of a gear train as printed.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct PrintedKind {
    /// Name.
    pub name: &'static str,
    /// Loss \[W\].
    pub watts: f64,
    /// Loss as text \[W\].
    pub loss: String,
    /// Share of the printed loss as text \[%\].
    pub share: String,
}

/// A mesh of a gear train, or one of the equal ones of a planetary set.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[non_exhaustive]
pub struct MeshRow {
    /// Gears of the mesh.
    pub mesh: String,
    /// Number of equal meshes.
    pub count: u32,
    /// Torque at its pinion \[N m\], negative when the wheel drives.
    pub torque_nm: f64,
    /// Speed of its pinion relative to the carrier \[rad/s\].
    pub speed_rad_per_s: f64,
    /// Loss of one such mesh \[W\]; with draws scaled as the loss of all meshes to its median, so that the meshes add up.
    pub loss_w: f64,
    /// Loss of its run with every constant at its median \[W\]; `None` without draws.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub loss_at_medians_w: Option<f64>,
    /// Its 5 % quantile.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub loss_p05_w: Option<f64>,
    /// Its 95 % quantile.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub loss_p95_w: Option<f64>,
    /// Its part by sliding \[W\].
    pub sliding_w: f64,
    /// Its part by rolling \[W\].
    pub rolling_w: f64,
    /// Efficiency of the mesh.
    pub efficiency: f64,
    /// Loss factor of its load.
    pub loss_factor_local: f64,
    /// Friction coefficient that explains its loss.
    pub mu_equivalent: f64,
    /// Highest Hertz pressure of its cells at the mean load \[MPa\].
    pub hertz_pressure_mpa: f64,
    /// The same at the most loaded planet, √K_γ times as high \[MPa\].
    pub hertz_pressure_most_loaded_mpa: f64,
}

/// A run of a case: of a gear train, or of its only mesh. Its JSON is the result of the case.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Outcome {
    /// Loss of the train, its shafts, and a row of each kind of mesh.
    pub whole: Whole,
    /// Every mesh, in the order of its row.
    pub meshes: Vec<MeshOutcome>,
    /// Draws of each mesh; `None` of a formulation without uncertainty.
    pub drawn: Option<Vec<Predictive>>,
    /// The train at the oil temperature and the torques that its losses cause.
    pub settled: Train,
    /// Rough contacts of each mesh.
    pub contacts: Vec<Contacts>,
}

impl Outcome {
    /// The only mesh of a case, which has no name and whose result is the result of the case.
    #[must_use]
    pub fn only(&self) -> Option<&MeshOutcome> {
        match (&self.whole.meshes[..], &self.meshes[..]) {
            ([row], [only]) if row.mesh.is_empty() => Some(only),
            _ => None,
        }
    }

    /// The outcome of the only mesh.
    ///
    /// # Errors
    /// When the case has several meshes.
    pub fn into_only(mut self) -> Result<MeshOutcome, Error> {
        self.settled.only_mesh()?;
        Ok(self.meshes.swap_remove(0))
    }

    /// The outcome of the only mesh with its draws, which [`difference`](crate::uncertainty::difference) compares; `None` of a case
    /// without an uncertainty.
    ///
    /// # Errors
    /// When the case has several meshes.
    pub fn only_with_draws(mut self) -> Result<(MeshOutcome, Option<Predictive>), Error> {
        let drawn = self.drawn.take().and_then(|mut drawn| drawn.pop());
        Ok((self.into_only()?, drawn))
    }

    /// States the measurements that would narrow the interval of the loss.
    pub(crate) fn put_evidence(&mut self, evidence: Vec<EvidenceRow>) {
        let is_only = self.only().is_some();
        match self.meshes.first_mut() {
            Some(only) if is_only => {
                if let Some(found) = &mut only.result.uncertainty {
                    found.evidence = evidence;
                }
            }
            _ => self.whole.evidence = evidence,
        }
    }

    /// The drawn losses of the meshes; `None` without draws.
    #[must_use]
    pub(crate) fn drawn_meshes(&self) -> Option<Vec<DrawnMesh<'_>>> {
        let drawn = self.drawn.as_ref()?;
        let flanks = self.settled.first_with_flanks();
        let cases = self.settled.cases().zip(drawn).enumerate();
        let drawn = cases.map(|(k, (loaded, predictive))| {
            Some(DrawnMesh {
                loaded,
                predictive,
                uncertainty: self.meshes.get(k)?.result.uncertainty.as_ref()?,
                count: self.whole.meshes.get(k)?.count,
                common: (*flanks.get(k)?).into(),
            })
        });
        drawn.collect()
    }

    /// The drawn meshes of this run and of another, with the draws that they have in common; `None` without draws.
    #[must_use]
    pub fn drawn_beside<'a>(&'a self, other: &'a Self) -> Option<[Vec<DrawnMesh<'a>>; 2]> {
        Some(beside(self.drawn_meshes()?, other.drawn_meshes()?))
    }
}

/// The result of the only mesh, or of the train as a whole.
impl Serialize for Outcome {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        match self.only() {
            Some(only) => only.result.serialize(to),
            None => self.whole.serialize(to),
        }
    }
}

/// Losses of a mesh for a result without its pictures.
struct MeshLosses<'a> {
    summary: &'a Summary,
    path: &'a [PositionRow],
    drawn: Option<Estimate>,
}

impl<'a> MeshLosses<'a> {
    fn of_run(run: &'a RunResult) -> Self {
        Self {
            summary: &run.summary,
            path: &run.path,
            drawn: run.uncertainty.as_ref().map(|found| found.loss.drawn()),
        }
    }
}

/// The losses of a gear train, or of its only mesh.
#[derive(Debug, Clone)]
pub struct TrainLosses {
    /// Losses of each mesh.
    pub meshes: Vec<Losses>,
    drawn: Vec<Option<Predictive>>,
    /// The train at the oil temperature and the torques that its losses cause.
    settled: Train,
    /// Temperature of the oil, if the case states a heat balance.
    oil: Option<FoundOil>,
    /// The drawn loss of all meshes.
    total: Option<Quantiles>,
}

/// The losses of every mesh of a gear train, at the median of its draws if its interval is requested.
///
/// # Errors
/// As [`run`].
pub(crate) fn losses(loaded: &Train, options: &Options<'_>) -> Result<TrainLosses, Error> {
    let (settled, oil) = with_oil(loaded)?;
    let mut meshes = Vec::new();
    let mut drawn = Vec::new();
    for case in settled.cases() {
        // Contacts are solved once for the losses and their draws.
        let contacts = if options.interval && has_band(case) {
            Some(pipeline::contacts(case, &options.known)?)
        } else {
            None
        };
        let of_mesh = Options {
            known: options.known.iter().copied().chain(&contacts).collect(),
            ..options.clone()
        };
        let mut losses = pipeline::losses_of(case, &of_mesh)?;
        let draws = match &contacts {
            Some(contacts) => predictive(case, &losses, Some(contacts))?,
            None => None,
        };
        if let Some(draws) = &draws {
            losses.restate(&case.case, draws.quantiles().drawn.value)?;
        }
        meshes.push(losses);
        drawn.push(draws);
    }
    let total = total_of(&settled, drawn.iter().map(Option::as_ref));
    if let (Some(total), true) = (total, meshes.len() > 1) {
        let at_medians = meshes.iter().map(|losses| losses.summary.at_medians_w());
        let restated = restated(&settled, at_medians, total.drawn.value);
        for (losses, (case, loss_w)) in meshes.iter_mut().zip(settled.cases().zip(restated)) {
            losses.restate(&case.case, loss_w)?;
        }
    }
    Ok(TrainLosses {
        meshes,
        drawn,
        settled,
        oil,
        total,
    })
}

impl TrainLosses {
    /// The losses of the only mesh.
    ///
    /// # Errors
    /// When the case has several meshes.
    pub fn into_only(mut self) -> Result<Losses, Error> {
        self.settled.only_mesh()?;
        Ok(self.meshes.swap_remove(0))
    }

    /// The result of the train: the same numbers as of a run, without runs of the meshes.
    ///
    /// # Errors
    /// When losses and powers are in no balance, or a part of the gearbox has no loss at this point.
    pub fn whole(&self) -> Result<Whole, Error> {
        let runs = self.meshes.iter().zip(&self.drawn).map(|(losses, drawn)| {
            let drawn = drawn.as_ref();
            let drawn = drawn.map(|drawn| median_with_ends(&drawn.draws_w()));
            let loss_w = losses.summary.loss_w;
            MeshLosses {
                summary: &losses.summary,
                path: &losses.path,
                drawn: drawn.map(|drawn| drawn.map(|loss| loss_w / drawn.value * loss)),
            }
        });
        let runs: Vec<MeshLosses<'_>> = runs.collect();
        let mut result =
            result(&self.settled, &runs).map_err(|error| Error::Whole(Box::new(error)))?;
        result.heat = self
            .oil
            .as_ref()
            .zip(self.settled.heat.as_ref())
            .map(|(oil, heat)| HeatReport::new(oil, heat, result.losses(), std::iter::empty()));
        result.loss_distribution = self.total;
        Ok(result)
    }
}

/// The drawn loss of all meshes of a train: oil and constants are drawn once, error of the model and sampling once for equal flanks. `None` if a
/// mesh is not drawn.
#[must_use]
pub fn total_of<'a>(
    loaded: &Train,
    drawn: impl Iterator<Item = Option<&'a Predictive>>,
) -> Option<Quantiles> {
    let drawn = drawn.collect::<Option<Vec<_>>>()?;
    let mut total = vec![0.0; Predictive::count()];
    let meshes = drawn.into_iter().zip(loaded.first_with_flanks());
    for ((predictive, flanks), count) in meshes.zip(loaded.counts()) {
        predictive.add_draws(&mut total, f64::from(count), flanks);
    }
    Some(Quantiles::from_draws(&total))
}

/// The losses \[W\] of the meshes of a train, each by the same ratio, so that all meshes together lose `median_w`.
fn restated(
    loaded: &Train,
    at_medians: impl Iterator<Item = f64> + Clone,
    median_w: f64,
) -> Vec<f64> {
    let counted = at_medians.clone().zip(loaded.counts());
    let sum: f64 = counted.map(|(loss, count)| f64::from(count) * loss).sum();
    let ratio = if sum > 0.0 { median_w / sum } else { 1.0 };
    at_medians.map(|loss| ratio * loss).collect()
}

/// Runs every mesh of a gear train.
///
/// # Errors
/// When a mesh has no solution, or losses that are passed on do not settle.
pub(crate) fn run(loaded: &Train, options: &Options<'_>) -> Result<Outcome, Error> {
    let (settled, oil) = with_oil(loaded)?;
    let loaded = &settled;
    let mut contacts: Vec<Contacts> = Vec::new();
    let mut meshes = Vec::new();
    let mut drawn = Vec::new();
    for mesh in loaded.meshes() {
        let known = options.known.iter().copied().chain(&contacts).collect();
        let of_mesh = Options {
            known,
            ..options.clone()
        };
        let mut run = run_and_draw(&mesh.case, &of_mesh)?;
        run.outcome.result.mesh = Some(mesh.name.clone()).filter(|name| !name.is_empty());
        meshes.push(run.outcome);
        drawn.push(run.drawn);
        contacts.push(run.contacts);
    }
    let total = total_of(loaded, drawn.iter().map(Option::as_ref));
    if let (Some(total), true) = (total, meshes.len() > 1) {
        let summaries = meshes.iter().map(|mesh: &MeshOutcome| &mesh.result.summary);
        let at_medians = summaries.map(Summary::at_medians_w);
        let restated = restated(loaded, at_medians, total.drawn.value);
        for (outcome, (mesh, loss_w)) in meshes.iter_mut().zip(loaded.meshes().zip(restated)) {
            outcome.restate_drawn(&mesh.case.case, loss_w)?;
        }
    }
    let whole = |error: PositionError| Error::Whole(Box::new(error));
    let runs: Vec<MeshLosses<'_>> = meshes
        .iter()
        .map(|mesh: &MeshOutcome| MeshLosses::of_run(&mesh.result))
        .collect();
    let mut result = result(loaded, &runs).map_err(whole)?;
    let found = oil.zip(loaded.heat.as_ref());
    result.heat = found.map(|(oil, heat)| {
        let runs = loaded.meshes().zip(&meshes);
        let runs = runs.map(|(mesh, outcome)| (mesh.name.as_str(), &outcome.result));
        HeatReport::new(&oil, heat, result.losses(), runs)
    });
    result.loss_distribution = total;
    Ok(Outcome {
        whole: result,
        meshes,
        drawn: drawn.into_iter().collect(),
        settled: settled.clone(),
        contacts,
    })
}

/// The train at the oil temperature and the torques that its losses cause.
pub(crate) fn settled(loaded: &Train) -> Result<Train, Error> {
    Ok(with_oil(loaded)?.0)
}

/// The settled train, and the temperature of its oil with its law.
fn with_oil(loaded: &Train) -> Result<(Train, Option<FoundOil>), Error> {
    let (warmed, oil) = heat::warmed(loaded)?;
    let settled = loaded_by_losses(warmed)?;
    if loaded.heat.is_none() || !loaded.shafting.passes_losses {
        return Ok((settled, oil));
    }
    // Losses at the torques that they leave change the oil by tenths of a kelvin, and the torques then by less than 1e-5.
    let (warmed, oil) = heat::warmed(&settled)?;
    Ok((loaded_by_losses(warmed)?, oil))
}

/// The train with the torques that the losses leave, where the case passes them on.
fn loaded_by_losses(loaded: Train) -> Result<Train, Error> {
    /// Change of a torque, relative to it, at which the torques have settled.
    const SETTLED: f64 = 1e-9;
    const MOST: usize = 30;
    if !loaded.shafting.passes_losses {
        return Ok(loaded);
    }
    let whole = |error| Error::Whole(Box::new(PositionError::from(error)));
    let mut settled = loaded;
    let mut known: Vec<Vec<(MeshLoad, Power)>> = vec![Vec::new(); settled.stages.len()];
    let mut change = f64::INFINITY;
    for _ in 0..MOST {
        for (stage, known) in settled.stages.iter().zip(&mut known) {
            // A mesh whose load did not change has the loss of the pass before.
            let loss = |(k, mesh): (usize, &LoadedMesh)| {
                let load = MeshLoad::from_case(&mesh.case.case);
                match known.get(k) {
                    Some((before, loss)) if *before == load => Ok((load, *loss)),
                    _ => {
                        let losses = pipeline::losses_of(&mesh.case, &Options::default())?;
                        Ok((load, Power::from_si(losses.summary.loss_w)))
                    }
                }
            };
            let meshes = stage.meshes.iter().enumerate();
            *known = meshes.map(loss).collect::<Result<_, Error>>()?;
        }
        let of_stage =
            |known: &Vec<(MeshLoad, Power)>| known.iter().map(|(_, loss)| *loss).collect();
        let losses: Vec<Vec<Power>> = known.iter().map(of_stage).collect();
        let flow = settled.shafting.flow(&losses).map_err(whole)?;
        change = 0.0;
        for (stage, loads) in settled.stages.iter_mut().zip(&flow.loads) {
            for (mesh, load) in stage.meshes.iter_mut().zip(loads) {
                let before = mesh.case.case.torque.si();
                change = f64::max(change, (load.torque.si() / before - 1.0).abs());
                mesh.case = at_load(&mesh.case, *load)?;
            }
        }
        if change < SETTLED {
            return Ok(settled);
        }
    }
    Err(Error::Whole(Box::new(PositionError::torques_not_settled(
        change,
    ))))
}

/// Checks all meshes of a train.
pub(crate) fn check(train: &Train) -> Result<Vec<Warning>, Error> {
    let found = train.meshes().map(|mesh| pipeline::check(&mesh.case));
    let found = found.collect::<Result<Vec<_>, Error>>()?;
    let of_loaded = train.meshes().flat_map(|mesh| &mesh.case.warnings);
    let mut warnings: Vec<Warning> = train.warnings.iter().chain(of_loaded).cloned().collect();
    for (mesh, own) in train.meshes().zip(&found) {
        let named = own.iter().map(|warning| {
            if found.iter().all(|of| of.contains(warning)) {
                warning.clone()
            } else {
                warning.with(&format!(" [{}]", mesh.name))
            }
        });
        warnings.extend(named);
    }
    let gearbox = gearbox_without_losses(train).map_err(|error| Error::Whole(Box::new(error)))?;
    let parts = gearbox.iter().flat_map(|report| &report.parts);
    warnings_of_gearbox(parts, &mut warnings);
    Ok(unique(warnings))
}

fn gearbox_without_losses(train: &Train) -> Result<Option<GearboxReport>, PositionError> {
    let losses = train.by_stage(&vec![Power::from_si(0.0); train.meshes().count()]);
    let flow = train.shafting.flow(&losses)?;
    let report = gearbox::report(train, &flow, &losses)?;
    Ok(report.map(|(report, _)| report))
}

/// The case of a mesh at another load.
fn at_load(case: &LoadedCase, load: MeshLoad) -> Result<LoadedCase, Error> {
    if MeshLoad::from_case(&case.case) == load {
        Ok(case.clone())
    } else {
        case.with(|input| {
            input.operation.torque = load.torque;
            input.operation.speed = load.speed;
        })
    }
}

fn result(loaded: &Train, runs: &[MeshLosses<'_>]) -> Result<Whole, PositionError> {
    let train = &loaded.shafting;
    let losses = runs.iter().map(|run| Power::from_si(run.summary.loss_w));
    let losses = losses.collect::<Vec<Power>>();
    let loss_w = loaded.loss(&losses).si();
    let at_medians = runs.iter().map(|run| run.summary.loss_at_medians_w);
    let at_medians = at_medians.map(|loss| loss.map(Power::from_si));
    let at_medians = at_medians.collect::<Option<Vec<Power>>>();
    let loss_at_medians_w = at_medians.map(|losses| loaded.loss(&losses).si());
    let losses = loaded.by_stage(&losses);
    let flow = train.flow(&losses)?;
    let mut kinds = LossKinds::default();
    let mut meshes = Vec::new();
    let mut sets = BTreeMap::new();
    let mut runs = runs.iter();
    for (k, (stage, kind)) in loaded.stages.iter().zip(&train.kinds).enumerate() {
        for (mesh, run) in stage.meshes.iter().zip(runs.by_ref()) {
            kinds.add(
                &LossKinds::from_summary(run.summary),
                f64::from(kind.count()),
            );
            meshes.push(row(mesh, kind, run));
        }
        if let Some(report) = planetary(loaded, k, &flow)? {
            sets.insert(stage.name.clone().unwrap_or_default(), report);
        }
    }
    let of_meshes_w = flow.power_in().si();
    let efficiency = 1.0 - loss_w / of_meshes_w;
    let of = "efficiency of the gear train";
    balance::efficiency(of, efficiency, loss_w, of_meshes_w)?;
    let (gearbox, flow) = match gearbox::report(loaded, &flow, &losses)? {
        Some((report, flow)) => (Some(report), flow),
        None => (None, flow),
    };
    let shafts = shafts(loaded, &flow)?;
    let powers = || shafts.iter().map(|shaft| shaft.power_w);
    let whole_w = gearbox.as_ref().map_or(loss_w, |gearbox| gearbox.loss_w);
    let of = "loss of the gear train";
    balance::sum(of, "W", whole_w, &powers().collect::<Vec<_>>())?;
    if let Some(gearbox) = &gearbox {
        let of = "efficiency of the gearbox";
        balance::efficiency(of, gearbox.efficiency, gearbox.loss_w, gearbox.power_in_w)?;
    }
    let power_in_w: f64 = powers().map(|power| power.max(0.0)).sum();
    let mut warnings = loaded.warnings.clone();
    let parts = gearbox.iter().flat_map(|report| &report.parts);
    warnings_of_gearbox(parts, &mut warnings);
    Ok(Whole {
        program: PROGRAM.to_owned(),
        title: loaded.title.clone(),
        scope: match gearbox {
            Some(_) => Scope::Gearbox,
            None => Scope::Mesh,
        },
        gearbox,
        set: loaded.only_set().and_then(|_| sets.remove("")),
        efficiency,
        loss_w,
        loss_at_medians_w,
        loss_distribution: None,
        power_in_w,
        power_out_w: powers().map(|power| (-power).max(0.0)).sum(),
        kinds,
        heat: None,
        shafts,
        meshes,
        sets,
        warnings,
        evidence: Vec::new(),
    })
}

fn shafts(loaded: &Train, flow: &Flow) -> Result<Vec<ShaftRow>, PositionError> {
    let train = &loaded.shafting.shafts;
    let carried = |torques: &Torques, number: usize| {
        let inner = train.places_of(number);
        let inner = inner.map(|(stage, place)| torques.stages[stage][place].si().abs());
        0.5 * (inner.sum::<f64>() + torques.shafts[number].si().abs())
    };
    let without_losses = train.torques(&flow.speeds, &[])?;
    let row = |(number, shaft): (usize, &Shaft)| {
        let (speed, torque) = (flow.speeds[number].si(), flow.torques.shafts[number].si());
        let carried_nm = carried(&flow.torques, number);
        ShaftRow {
            shaft: shaft.name.clone(),
            speed_rad_per_s: speed,
            carried_nm,
            torque_nm: torque,
            // A shaft between two meshes has 0, not -0.
            power_w: torque * speed + 0.0,
            by_losses_nm: carried_nm - carried(&without_losses, number),
        }
    };
    Ok(train.shafts.iter().enumerate().map(row).collect())
}

/// The planetary set of stage `k`; `None` if it is a pair.
fn planetary(
    loaded: &Train,
    k: usize,
    flow: &Flow,
) -> Result<Option<PlanetaryReport>, PositionError> {
    let train = &loaded.shafting;
    let StageKind::Planetary {
        set,
        load_share_factor,
    } = &train.kinds[k]
    else {
        return Ok(None);
    };
    let [sun, ring] = train.shafts.stages[k].gears.map(|shaft| flow.speeds[shaft]);
    let [sun_torque, _, _] = flow.torques.stages[k];
    let rolling_power = set.rolling_power(&PlanetaryOperation {
        sun_torque,
        sun_speed: sun,
        ring_speed: ring,
        load_share_factor: *load_share_factor,
    })?;
    let PlanetarySpeeds {
        carrier,
        planet_relative,
        ..
    } = set.speeds(sun, ring)?;
    Ok(Some(PlanetaryReport {
        planets: set.planets,
        rolling_power_w: rolling_power.si(),
        sun_rad_per_s: sun.si(),
        ring_rad_per_s: ring.si(),
        carrier_rad_per_s: carrier.si(),
        planet_relative_rad_per_s: planet_relative.si(),
        can_be_equally_spaced: set.can_be_equally_spaced(),
        load_share_factor: *load_share_factor,
    }))
}

fn row(mesh: &LoadedMesh, kind: &StageKind, run: &MeshLosses<'_>) -> MeshRow {
    let pressures = run.path.iter().map(|row| row.hertz_pressure_mpa);
    let highest = pressures.fold(0.0, f64::max);
    let MeshLosses { summary, drawn, .. } = run;
    let [low, high] = [drawn.map(|of| of.low), drawn.map(|of| of.high)];
    MeshRow {
        mesh: mesh.name.clone(),
        count: kind.count(),
        torque_nm: mesh.case.case.torque.si(),
        speed_rad_per_s: mesh.case.case.speed.si(),
        loss_w: summary.loss_w,
        loss_at_medians_w: summary.loss_at_medians_w,
        loss_p05_w: low,
        loss_p95_w: high,
        sliding_w: summary.sliding_w,
        rolling_w: summary.rolling_w,
        efficiency: summary.efficiency,
        loss_factor_local: summary.loss_factor_local,
        mu_equivalent: summary.mu_equivalent,
        hertz_pressure_mpa: highest,
        hertz_pressure_most_loaded_mpa: highest * kind.load_share_factor().sqrt(),
    }
}

impl Whole {
    /// Losses of all meshes, and of seals, bearings and other parts if the case states some.
    fn losses(&self) -> Power {
        Power::from_si(
            self.gearbox
                .as_ref()
                .map_or(self.loss_w, |gearbox| gearbox.loss_w),
        )
    }

    /// Power into the meshes \[W\], without seals, bearings and other parts.
    #[must_use]
    pub fn meshes_power_in_w(&self) -> f64 {
        self.loss_w / (1.0 - self.efficiency)
    }

    /// Loss \[W\] and efficiency \[%\] with their bands, each with the digits that its band leaves.
    #[must_use]
    pub fn with_bands(&self) -> [String; 2] {
        let Some(drawn) = &self.loss_distribution else {
            return with_units(without_interval(self.loss_w, self.efficiency));
        };
        with_interval(drawn.drawn, self.power_in_w, UNITS)
    }

    /// Loss \[W\] and efficiency \[%\] of meshes, seals and bearings together with the bands of the meshes; `None` without
    /// seals and bearings.
    #[must_use]
    pub fn gearbox_with_bands(&self) -> Option<[String; 2]> {
        let gearbox = self.gearbox.as_ref()?;
        let Some(drawn) = &self.loss_distribution else {
            let run = without_interval(gearbox.loss_w, gearbox.efficiency);
            return Some(with_units(run));
        };
        let of_gearbox = gearbox.drawn_w(drawn.drawn);
        Some(with_interval(of_gearbox, gearbox.power_in_w, UNITS))
    }

    /// Half of the interval of the loss over the loss; without one two steps of its last place, which leave that place.
    fn half_band(&self) -> f64 {
        let half = match self.loss_distribution {
            Some(Quantiles { drawn, .. }) => drawn.half_width(),
            None => 2.0 * self.digits().step(),
        };
        half / self.loss_w
    }

    /// The digits that the interval of the loss leaves, without one the digits of a power.
    #[must_use]
    pub fn digits(&self) -> Digits {
        let drawn = self.loss_distribution.map(|found| found.drawn);
        Digits::of_drawn(drawn, Digits::of_power(self.loss_w))
    }

    /// The kinds of loss that occur. Each has the digits that its part of the interval leaves, so that the
    /// printed kinds need not add up.
    #[must_use]
    pub fn kinds_with_digits(&self) -> Vec<PrintedKind> {
        let digits = self.digits();
        let kinds = self.kinds.rows();
        let losses = kinds.map(|(_, loss)| loss);
        let steps = losses.map(|watts| watts / digits.step());
        let shares = digits.shares(&steps, &losses);
        let text = |watts: f64| {
            let own = self.loss_distribution.map(|found| found.drawn);
            let own = own.map(|drawn| drawn.map(|loss| watts / self.loss_w * loss));
            Digits::of_drawn(own, Digits::of_power(watts)).rounded(watts)
        };
        let rows = kinds.into_iter().zip(shares);
        let rows = rows.filter(|((_, watts), _)| *watts > 0.0);
        let row = |((name, watts), share)| PrintedKind {
            name,
            watts,
            loss: text(watts),
            share,
        };
        rows.map(row).collect()
    }

    /// Carried torque \[N m\], torque into the train \[N m\] and power \[kW\] of a shaft with the digits that the band of the loss
    /// leaves.
    #[must_use]
    pub fn shaft_with_digits(&self, row: &ShaftRow) -> [String; 3] {
        let half = self.half_band() * row.by_losses_nm.abs();
        let text = |value: f64, half: f64| match half > 0.0 {
            true => rounded(value, half),
            // Stated, or zero.
            false => format!("{}", (value * 1e4).round() / 1e4 + 0.0),
        };
        [
            text(row.carried_nm, half),
            text(row.torque_nm, half),
            text(1e-3 * row.power_w, 1e-3 * half * row.speed_rad_per_s.abs()),
        ]
    }

    fn drives(&self) -> bool {
        self.shafts.first().is_none_or(|input| input.power_w >= 0.0)
    }

    /// Power in and power out \[kW\] with the digits that the band of the loss leaves.
    #[must_use]
    pub fn powers_with_digits(&self) -> [String; 2] {
        let half = 1e-3 * self.half_band() * self.loss_w;
        let [of_in, of_out] = if self.drives() {
            [0.0, half]
        } else {
            [half, 0.0]
        };
        let [power_in, power_out] = [self.power_in_w, self.power_out_w];
        [
            rounded(1e-3 * power_in, of_in),
            rounded(1e-3 * power_out, of_out),
        ]
    }

    /// Every planetary set, with the name of its stage if the train has several.
    pub fn planetary_sets(&self) -> impl Iterator<Item = (&str, &PlanetaryReport)> {
        let sets = self.sets.iter().map(|(name, set)| (name.as_str(), set));
        self.set.iter().map(|set| ("", set)).chain(sets)
    }
}

/// Units of a loss and an efficiency as text.
const UNITS: [&str; 2] = [" W", " %"];

fn with_units([loss, efficiency]: [String; 2]) -> [String; 2] {
    [loss + UNITS[0], efficiency + UNITS[1]]
}

/// Loss \[W\] and efficiency \[%\] without an interval, as text.
fn without_interval(loss_w: f64, efficiency: f64) -> [String; 2] {
    [
        Digits::of_power(loss_w).rounded(loss_w),
        format!("{:.4}", 100.0 * efficiency),
    ]
}

impl MeshRow {
    /// Loss \[W\], efficiency \[%\] and μ_eq with the digits that the interval of the loss leaves, the loss with its quantiles.
    #[must_use]
    pub fn with_digits(&self) -> [String; 3] {
        // The losses of a mesh are its power times the rest of its efficiency.
        let power = self.loss_w / (1.0 - self.efficiency);
        let Some(drawn) = self.drawn_w() else {
            let [loss, efficiency] = without_interval(self.loss_w, self.efficiency);
            return [loss, efficiency, rounded(self.mu_equivalent, 0.0)];
        };
        let [loss, efficiency] = with_interval(drawn, power, ["", ""]);
        let efficiency = efficiency.split(' ').next().unwrap_or_default().to_owned();
        let half = drawn.half_width() / self.loss_w * self.mu_equivalent;
        [loss, efficiency, rounded(self.mu_equivalent, half)]
    }

    /// Sliding and rolling loss \[W\], which add up to the loss as printed.
    #[must_use]
    pub fn parts_with_digits(&self) -> Vec<String> {
        let digits = Digits::of_drawn(self.drawn_w(), Digits::of_power(self.loss_w));
        digits.texts_of_parts(self.loss_w, &[self.sliding_w, self.rolling_w])
    }

    /// The loss with its quantiles \[W\]; `None` without an interval.
    #[must_use]
    pub fn drawn_w(&self) -> Option<Estimate> {
        Some(Estimate {
            value: self.loss_w,
            low: self.loss_p05_w?,
            high: self.loss_p95_w?,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_train_without_an_interval_has_the_digits_of_a_pair() {
        let mesh = MeshRow {
            loss_w: 663.2771,
            sliding_w: 625.4321,
            rolling_w: 37.845,
            efficiency: 0.995_150_4,
            mu_equivalent: 0.032_312_34,
            ..MeshRow::default()
        };
        assert_eq!(mesh.with_digits(), ["663", "99.5150", "0.0323"]);
        assert_eq!(mesh.parts_with_digits(), ["625", "38"]);
        let mut train = Whole {
            loss_w: 1370.2773,
            efficiency: 0.989_523,
            ..Whole::default()
        };
        (train.kinds.film_w, train.kinds.rolling_w) = (1000.1, 370.1773);
        assert_eq!(train.with_bands(), ["1370 W", "98.9523 %"]);
        let kinds = train.kinds_with_digits();
        assert_eq!(kinds[0].loss, "1000");
        assert_eq!([&kinds[1].loss, &kinds[1].share], ["370", "27.0"]);
        // The torque of the losses is known to as many digits as the loss.
        let shaft = ShaftRow {
            shaft: "out".to_owned(),
            speed_rad_per_s: 80.0,
            carried_nm: 1654.3957,
            torque_nm: -1654.3957,
            power_w: -132_351.66,
            by_losses_nm: -16.6,
        };
        let [carried, torque, _] = train.shaft_with_digits(&shaft);
        assert_eq!([carried, torque], ["1654.396", "-1654.396"]);
        let stated = ShaftRow {
            by_losses_nm: 0.0,
            torque_nm: 145.0,
            ..shaft.clone()
        };
        assert_eq!(train.shaft_with_digits(&stated)[1], "145");
        // With an interval the power that leaves has its digits.
        train.loss_distribution = Some(Quantiles {
            drawn: Estimate::new(1370.2773, [1320.0, 1420.0]),
            sd_ln: 0.02,
        });
        let all = ShaftRow {
            by_losses_nm: -1370.2773 / 80.0,
            ..shaft
        };
        // In steps of 10 W.
        assert_eq!(train.shaft_with_digits(&all)[2], "-132.35");
    }
}
