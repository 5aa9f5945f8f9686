//! A map as data.

use asperity::case::{CaseInput, DefaultUsed};
use serde::{Deserialize, Serialize};

use super::axes::Axes;
use super::surface::Surface;

/// Mark of points below the smallest torque whose contact the traces resolve.
pub const EXTENDED: &str = "extended";

/// Losses of a mesh over torque, speed and temperature.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Map {
    /// Version of this structure.
    pub schema_version: u32,
    /// The program and its version.
    pub program: String,
    /// The case's title.
    pub title: String,
    /// What loses at the points: `mesh`, no bearings, seals or churning.
    pub scope: String,
    /// The gearbox around the mesh, where the case states one; in no point, and added to exports.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gearbox: Option<MapGearbox>,
    /// The nodes.
    pub axes: Axes,
    /// Turns of the pinion for one turn of the wheel.
    pub ratio: f64,
    /// The finishes, the first one the reference of differences.
    pub finishes: Vec<FinishMap>,
    /// What left its range, with the points that it is about.
    pub warnings: Vec<MapWarning>,
    /// The case as read; the traces are those of each finish.
    pub input: CaseInput,
    /// Every default that was used.
    pub defaults: Vec<DefaultUsed>,
}

/// Losses beside the mesh at the points of a map, as the user of the case states them.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MapGearbox {
    /// Names of the parts.
    pub parts: Vec<String>,
    /// Their loss over the speed of the pinion at every point \[N m\], in the order of [`Axes::index`]; at standstill
    /// that at 1 1/min.
    pub loss_torque_nm: Vec<f64>,
}

/// The map of one pair of flanks.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FinishMap {
    /// Name of the finish.
    pub name: String,
    /// SHA-256 of its case, of every byte of the files read for it, and of the version of the program; empty in older
    /// maps.
    #[serde(default)]
    pub fingerprint: String,
    /// Names of the files that it read, and their SHA-256.
    pub files: Vec<[String; 2]>,
    /// The same of the coast flanks, where there are any.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub coast_files: Vec<[String; 2]>,
    /// Smallest torques whose contacts the traces resolve, drive and coast \[N m\]; points below are extended.
    pub resolved_from_nm: [f64; 2],
    /// Every point, in the order of [`Axes::index`]; in the table, not in the JSON.
    #[serde(skip)]
    pub points: Vec<Point>,
}

/// A warning and the points it is about.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MapWarning {
    /// Code, correlation and input.
    pub text: String,
    /// Name of the finish.
    pub finish: String,
    /// Number of points.
    pub count: usize,
    /// Rows of the finish in the table from 1, as `1-4,9`.
    pub points: String,
}

/// A point of a map.
#[derive(Debug, Clone, PartialEq)]
pub struct Point {
    /// Torque at the pinion \[N m\].
    pub torque_nm: f64,
    /// Speed of the pinion \[1/min\].
    pub speed_rpm: f64,
    /// Temperature of the flanks \[°C\].
    pub temperature_c: f64,
    /// Losses; none where the point has no result.
    pub numbers: Option<Numbers>,
    /// What left its range there.
    pub outside: Vec<String>,
    /// Code of the error where there is no result.
    pub code: Option<String>,
}

/// Losses at a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Numbers {
    /// All losses \[W\].
    pub loss_w: f64,
    /// Loss over the speed of the pinion \[N m\], at standstill that at 1 1/min.
    pub loss_torque_nm: f64,
    /// Standard deviation of the loss torque over the offsets of the traces \[N m\]; none with one offset.
    pub loss_torque_deviation_nm: Option<f64>,
    /// 5 % and 95 % quantiles of the loss torque \[N m\] over parameters and sampling, where they were computed.
    pub loss_torque_quantiles_nm: Option<[f64; 2]>,
    /// Efficiency; none without power.
    pub efficiency: Option<f64>,
    /// Its standard deviation over the offsets.
    pub efficiency_deviation: Option<f64>,
    /// Sliding loss \[W\].
    pub sliding_w: f64,
    /// Part of it in the film \[W\].
    pub film_w: f64,
    /// Part of it in lubricated asperities \[W\].
    pub lubricated_asperity_w: f64,
    /// Part of it in the boundary layer \[W\].
    pub boundary_w: f64,
    /// Rolling loss \[W\].
    pub rolling_w: f64,
    /// Loss by deformation of the flanks \[W\], with that of running-in if the case includes it.
    pub deformation_w: f64,
    /// Friction coefficient that explains the loss; `None` without torque.
    pub mu_equivalent: Option<f64>,
    /// Share of the path in mixed lubrication.
    pub mixed_share: f64,
}

impl FinishMap {
    /// Loss torque over torque and speed at one node of the temperature; none where a point has no result.
    #[must_use]
    pub fn surface(&self, axes: &Axes, temperature: usize) -> Option<Surface> {
        let value = |of: &dyn Fn(&Numbers) -> f64| -> Option<Vec<f64>> {
            let nodes = axes.torque_nm.len() * axes.speed_rpm.len();
            let first = axes.index(temperature, 0, 0);
            let points = self.points.get(first..first + nodes)?;
            let numbers = points.iter().map(|point| Some(of(point.numbers.as_ref()?)));
            numbers.collect()
        };
        Some(Surface {
            torque_nm: axes.torque_nm.clone(),
            speed_rpm: axes.speed_rpm.clone(),
            loss_torque_nm: value(&|numbers| numbers.loss_torque_nm)?,
            deviation_nm: value(&|numbers| numbers.loss_torque_deviation_nm.unwrap_or(0.0))?,
        })
    }

    /// Points without a result, by code.
    #[must_use]
    pub fn failures(&self) -> std::collections::BTreeMap<&str, usize> {
        let mut found = std::collections::BTreeMap::new();
        for code in self.points.iter().filter_map(|point| point.code.as_deref()) {
            *found.entry(code).or_insert(0) += 1;
        }
        found
    }
}

impl Point {
    /// Whether the losses are those of another torque, scaled.
    #[must_use]
    pub fn is_extended(&self) -> bool {
        self.outside.iter().any(|mark| mark == EXTENDED)
    }
}

/// Numbers from 1 as ranges, `1-4,9`; `at` are rising indices from 0.
///
/// ```
/// assert_eq!(asperity_studies::map::ranges(&[0, 1, 2, 3, 8]), "1-4,9");
/// ```
#[must_use]
pub fn ranges(at: &[usize]) -> String {
    let mut runs: Vec<[usize; 2]> = Vec::new();
    for &index in at {
        match runs.last_mut() {
            Some(run) if run[1] + 1 == index => run[1] = index,
            _ => runs.push([index, index]),
        }
    }
    let text = runs.iter().map(|&[from, to]| match from == to {
        true => format!("{}", from + 1),
        false => format!("{}-{}", from + 1, to + 1),
    });
    text.collect::<Vec<_>>().join(",")
}
