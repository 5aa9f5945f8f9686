//! Heat balance of a gear train: the losses heat the oil, the oil the housing, and the housing the ambient air.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | P | losses of all meshes at the oil temperature, and the stated other losses | W |
//! | G_o, G_h | conductances from oil to housing and from housing to the ambient | W/K |
//! | ϑ_a, ϑ_h, ϑ_o | temperatures of ambient, housing and oil | °C |
//!
//! The gears heat the oil: their bulk temperatures follow from the oil and the loss of their mesh by the law of each mesh
//! (`mesh.NAME.bulk`, else `operation.bulk`). Conductances and other losses are the user's; no value of them is assumed.

use asperity_core::cite;
use asperity_core::quantity::{Power, Temperature};
use asperity_efficiency::bulk_temperature::{BulkTemperature, fixed_point};
use serde::{Deserialize, Serialize};

use super::contacts::contacts;
use crate::contacts::Contacts;
use crate::gearbox;
use crate::pipeline::{self, Options};
use crate::result::RunResult;
use asperity_case::case::LoadedCase;
use asperity_case::case::train::{HeatInput, Train};
use asperity_case::error::Error;

/// Temperatures at which the losses of a gear train leave through its housing.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct HeatReport {
    /// Temperature of the oil \[°C\].
    pub oil_c: f64,
    /// Temperature of the housing \[°C\].
    pub housing_c: f64,
    /// Temperature of the ambient air \[°C\].
    pub ambient_c: f64,
    /// Bulk temperatures of the gears of each mesh, which heat the oil.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub gears: Vec<GearNode>,
    /// Heat from meshes and other losses into the oil \[W\].
    pub heat_w: f64,
    /// Stated losses of other parts \[W\], which are in the heat and not in the loss of the meshes.
    pub other_losses_w: f64,
    /// Difference between this temperature of the oil and the one of the losses \[K\].
    pub residual_k: f64,
    /// Number of steps.
    pub steps: usize,
    /// A second, hotter equilibrium temperature of the oil \[°C\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub hotter_c: Option<f64>,
    /// Temperature of the oil from which no equilibrium is reached \[°C\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub runs_away_from_c: Option<f64>,
}

/// Bulk temperature of the gears of a mesh.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct GearNode {
    /// Name of the mesh.
    pub mesh: String,
    /// Bulk temperature, by the law of the mesh from its loss \[°C\].
    pub bulk_c: f64,
    /// Bulk temperatures of pinion and wheel \[°C\], if the law distinguishes them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pinion_and_wheel_c: Option<[f64; 2]>,
}

impl GearNode {
    fn new(mesh: &str, run: &RunResult) -> Option<Self> {
        let bulk = run.bulk.as_ref()?;
        Some(Self {
            mesh: mesh.to_owned(),
            bulk_c: bulk.bulk_c,
            pinion_and_wheel_c: bulk.gears_c,
        })
    }
}

/// Temperatures of housing and oil at a heat P:
///
/// ϑ_h = ϑ_a + P/G_h,  ϑ_o = ϑ_h + P/G_o                                          [Heat-nodes]
fn nodes(heat: &HeatInput, losses: Power) -> [Temperature; 2] {
    cite!("Heat-nodes");
    let into_oil = into_oil(heat, losses).si();
    let housing = heat.ambient.si() + into_oil / heat.housing_to_ambient.si();
    let oil = housing + into_oil / heat.oil_to_housing.si();
    [housing, oil].map(Temperature::from_si)
}

fn into_oil(heat: &HeatInput, losses: Power) -> Power {
    losses + heat.other_losses.unwrap_or(Power::from_si(0.0))
}

/// The temperature of the oil that the losses of a train cause.
#[derive(Debug, Clone)]
pub(crate) struct FoundOil {
    found: BulkTemperature,
    /// Temperature at which the search began.
    start: Temperature,
}

/// The train at the temperature of the oil that its losses cause, and how it was found; the train itself if it states no
/// heat balance.
pub(crate) fn warmed(loaded: &Train) -> Result<(Train, Option<FoundOil>), Error> {
    let Some(heat) = &loaded.heat else {
        return Ok((loaded.clone(), None));
    };
    let contacts = contacts(loaded, &[])?;
    let losses = |train: &Train| -> Result<Power, Error> {
        let of_mesh = |(case, contacts): (&LoadedCase, &Contacts)| {
            let coldest = Options {
                seeks_hotter: false,
                ..Options::known(contacts)
            };
            let losses = pipeline::losses_of(case, &coldest)?;
            Ok(Power::from_si(losses.summary.loss_w))
        };
        let cases = train.meshes().map(|mesh| &mesh.case);
        let of_meshes = cases.zip(&contacts).map(of_mesh);
        let of_meshes = of_meshes.collect::<Result<Vec<Power>, Error>>()?;
        let meshes = train.loss(&of_meshes);
        let oil = train
            .meshes()
            .map(|mesh| mesh.case.case.stated_temperature)
            .next();
        let oil = oil.unwrap_or(heat.ambient);
        let operation = train.shafting.operation();
        let of_meshes = train.by_stage(&of_meshes);
        let parts = gearbox::parts(train, operation, oil, &of_meshes).map_err(Box::new)?;
        let parts = parts.iter().map(|part| Power::from_si(part.loss_w));
        Ok(parts.fold(meshes, |sum, part| sum + part))
    };
    let start = loaded
        .meshes()
        .map(|mesh| mesh.case.case.stated_temperature)
        .next();
    let start = start.unwrap_or(heat.ambient);
    let found = fixed_point(start, |oil| {
        let [_, oil] = nodes(heat, losses(&at(loaded, oil)?)?);
        Ok::<_, Error>(oil)
    })?;
    let warmed = at(loaded, found.temperature)?;
    Ok((warmed, Some(FoundOil { found, start })))
}

impl HeatReport {
    /// The temperatures in one line, with an equilibrium that is hotter or missing.
    #[must_use]
    pub fn line(&self) -> String {
        let [oil, housing, ambient] = [self.oil_c, self.housing_c, self.ambient_c];
        let mut line = format!(
            "oil {oil:.1} °C, housing {housing:.1} °C at {ambient:.1} °C ambient, by {:.0} W of heat",
            self.heat_w
        );
        for gears in &self.gears {
            line.push_str(&match gears.pinion_and_wheel_c {
                Some([pinion, wheel]) => {
                    format!("; {} {pinion:.1} and {wheel:.1} °C", gears.mesh)
                }
                None => format!("; {} {:.1} °C", gears.mesh, gears.bulk_c),
            });
        }
        if let Some(hotter) = self.hotter_c {
            line.push_str(&format!("; a second equilibrium exists at {hotter:.1} °C"));
        }
        if let Some(from) = self.runs_away_from_c {
            line.push_str(&format!("; oil at {from:.1} °C finds no equilibrium"));
        }
        line
    }

    /// The report with the temperatures that follow from the losses of the run.
    pub(crate) fn new<'a>(
        oil: &FoundOil,
        heat: &HeatInput,
        losses: Power,
        runs: impl Iterator<Item = (&'a str, &'a RunResult)>,
    ) -> Self {
        let FoundOil { found, start } = oil;
        let celsius = Temperature::celsius;
        let [housing_c, oil_c] = nodes(heat, losses).map(celsius);
        let [hotter, from] = found.hotter_ends(*start);
        Self {
            oil_c,
            housing_c,
            ambient_c: celsius(heat.ambient),
            gears: runs
                .filter_map(|(mesh, run)| GearNode::new(mesh, run))
                .collect(),
            heat_w: into_oil(heat, losses).si(),
            other_losses_w: heat.other_losses.map_or(0.0, Power::si),
            residual_k: (oil_c - celsius(found.temperature)).abs(),
            steps: found.steps,
            hotter_c: hotter.map(celsius),
            runs_away_from_c: from.map(celsius),
        }
    }
}

/// The train with another temperature of the oil.
fn at(loaded: &Train, oil: Temperature) -> Result<Train, Error> {
    loaded.with(&|input| input.operation.oil_temperature = Some(oil))
}
