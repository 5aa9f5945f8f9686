//! Draws of the loss over torque, speed and temperature, from draws at a few nodes.
//!
//! ```text
//! L_j = ln(P_j/P),  linear in ln T, ln ω and the temperature between the nodes, held constant outside
//! ```
//!
//! P_j is the loss of all meshes in draw j and P the loss with every constant at its median. Draws are the same at all nodes, so that
//! the constants, the structure and the tip relief of a draw hold for the whole map.

use asperity::uncertainty::{Common, Predictive, median_with_ends};
use asperity_core::Estimate;
use asperity_core::numerics::{NodeInterval, add_times, distinct};
use asperity_core::task::par_map;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::axes::Axes;
use super::surface::forwards;

/// Points of a map whose draws are computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
#[serde(rename_all = "kebab-case")]
pub enum MapBand {
    /// None: no quantiles
    None,
    /// Three torques and three speeds at three temperatures, interpolated between them
    #[default]
    Nodes,
}

/// Smallest torque and speed of a node relative to the largest.
const SMALLEST: f64 = 0.02;
/// Parts of an interval between nodes to which a place is rounded.
const PARTS: u32 = 64;

/// Ingredients of the draws of a mesh at nodes of torque, speed and temperature, for one side of the teeth.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct DrawnNodes {
    /// Absolute torques \[N m\], ascending.
    pub torque_nm: Vec<f64>,
    /// Speeds \[1/min\], ascending.
    pub speed_rpm: Vec<f64>,
    /// Temperatures \[°C\], ascending.
    pub temperature_c: Vec<f64>,
    /// Draws at the nodes, in the order of temperature, torque and speed.
    pub predictive: Vec<Predictive>,
    /// Number of equal meshes.
    #[serde(default = "one", skip_serializing_if = "is_one")]
    pub count: u32,
    /// Number of the flanks within a gear train: equal flanks have the same errors of model and sampling.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub flanks: usize,
    /// Draws in common with the first finish, of the first and of this one; `None` of the first itself.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub common: Option<[Common; 2]>,
}

/// Finish that the draws of a finish are put in common with.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Beside<'a> {
    /// None.
    Nothing,
    /// The first finish.
    First,
    /// Another finish, of the first one.
    Other(&'a [DrawnNodes]),
}

impl DrawnNodes {
    /// The draws of the mesh number `k` of all sides.
    fn common(&self, k: usize, beside: Beside<'_>) -> Common {
        let common = match beside {
            Beside::Nothing => None,
            Beside::First => self.common.map(|[_, own]| own),
            Beside::Other(nodes) => nodes.get(k).and_then(|other| Some(other.common?[0])),
        };
        common.unwrap_or_else(|| self.flanks.into())
    }
}

fn one() -> u32 {
    1
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "called by serde")]
fn is_one(count: &u32) -> bool {
    *count == 1
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "called by serde")]
fn is_zero(flanks: &usize) -> bool {
    *flanks == 0
}

/// Torques, speeds and temperatures of the nodes, chosen from the axes of a map.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Nodes {
    pub torque_nm: Vec<f64>,
    pub speed_rpm: Vec<f64>,
    pub temperature_c: Vec<f64>,
}

impl Nodes {
    /// Nodes among the absolute torques at which one side of the teeth is computed, and the other axes of the map.
    pub fn new(band: MapBand, torques: &[f64], axes: &Axes) -> Self {
        let temperatures = &axes.temperature_c;
        let Some(last) = temperatures.len().checked_sub(1) else {
            return Self::default();
        };
        if band == MapBand::None {
            return Self::default();
        }
        let temperatures = [0, last / 2, last].map(|k| temperatures[k]);
        Self {
            torque_nm: three(torques),
            speed_rpm: three(&axes.speed_rpm),
            temperature_c: distinct(temperatures),
        }
    }

    pub fn has(&self, torque: f64, speed: f64, temperature: f64) -> bool {
        self.torque_nm.contains(&torque)
            && self.speed_rpm.contains(&speed)
            && self.temperature_c.contains(&temperature)
    }
}

/// The lowest of the positive `values` from 2 % of the largest, the largest, and the one nearest to their geometric mean.
fn three(values: &[f64]) -> Vec<f64> {
    let positive = values.iter().copied().filter(|value| *value > 0.0);
    let all = distinct(positive);
    let Some(&high) = all.last() else {
        return all;
    };
    let from = all.partition_point(|value| *value < SMALLEST * high);
    let all = &all[from..];
    let low = all[0];
    let off = |value: &&f64| (*value * *value / (low * high)).ln().abs();
    let middle = all.iter().min_by(|a, b| off(a).total_cmp(&off(b)));
    distinct([low, high].into_iter().chain(middle.copied()))
}

/// L_j at the nodes of one side.
struct Side<'a> {
    nodes: &'a DrawnNodes,
    logs: Vec<Vec<f64>>,
}

/// Draws of a finish between its nodes.
pub struct Drawn<'a> {
    /// Drive and, if they differ, coast flanks.
    sides: Vec<Side<'a>>,
}

/// Place between nodes: side, then coordinates over temperature, torque and speed in parts of an interval.
pub(crate) type MapPlace = [u32; 4];

impl<'a> Drawn<'a> {
    /// The draws at the nodes of each side with this number of `meshes`, see [`FinishMap::drawn`](super::FinishMap::drawn).
    pub(super) fn new(
        sides: &'a [DrawnNodes],
        meshes: usize,
        beside: Beside<'_>,
        sampling: f64,
    ) -> Option<Self> {
        let of_side = |(side, of_meshes): (usize, &'a [DrawnNodes])| {
            let nodes = of_meshes.first()?;
            let at_node = |node: usize| {
                let mut drawn = vec![0.0; Predictive::count()];
                let mut at_medians = 0.0;
                for (k, mesh) in of_meshes.iter().enumerate() {
                    let predictive = mesh.predictive.get(node)?;
                    let count = f64::from(mesh.count);
                    at_medians += count * predictive.at_medians_w;
                    let common = mesh.common(side * meshes + k, beside);
                    let of_mesh = predictive.draws_of_sum_w(common, sampling);
                    add_times(&mut drawn, count, &of_mesh);
                }
                let ln = |loss: f64| (loss / at_medians).ln();
                Some(drawn.into_iter().map(ln).collect())
            };
            let at_nodes = par_map(0..nodes.predictive.len(), at_node);
            Some(Side {
                nodes,
                logs: at_nodes.into_iter().collect::<Option<_>>()?,
            })
        };
        let sides: Option<Vec<Side<'a>>> = sides.chunks(meshes).enumerate().map(of_side).collect();
        sides
            .filter(|sides| !sides.is_empty())
            .map(|sides| Self { sides })
    }

    /// The place of an operating point, rounded to a 64th of the interval between nodes.
    pub(crate) fn place(&self, torque_nm: f64, speed_rpm: f64, temperature_c: f64) -> MapPlace {
        let [torque_nm, speed_rpm] = forwards(torque_nm, speed_rpm);
        let side = usize::from(torque_nm < 0.0).min(self.sides.len() - 1);
        let nodes = self.sides[side].nodes;
        let ln = |nodes: &[f64], value: f64| {
            let nodes: Vec<f64> = nodes.iter().map(|node| node.ln()).collect();
            coordinate(&nodes, value.abs().ln())
        };
        [
            side as u32,
            coordinate(&nodes.temperature_c, temperature_c),
            ln(&nodes.torque_nm, torque_nm),
            ln(&nodes.speed_rpm, speed_rpm),
        ]
    }

    /// exp(L_j) of all draws.
    pub(crate) fn ratios(&self, place: MapPlace) -> Vec<f64> {
        let [side, at @ ..] = place;
        let side = &self.sides[side as usize];
        let (torques, speeds) = (side.nodes.torque_nm.len(), side.nodes.speed_rpm.len());
        let corners = |k: usize| {
            let (below, part) = (at[k] / PARTS, at[k] % PARTS);
            let above = f64::from(part) / f64::from(PARTS);
            [(below, 1.0 - above), (below + 1, above)]
        };
        let mut logs = vec![0.0; Predictive::count()];
        for (temperature, a) in corners(0) {
            for (torque, b) in corners(1) {
                for (speed, c) in corners(2) {
                    let weight = a * b * c;
                    if weight == 0.0 {
                        continue;
                    }
                    let node = (temperature as usize * torques + torque as usize) * speeds;
                    let values = &side.logs[node + speed as usize];
                    add_times(&mut logs, weight, values);
                }
            }
        }
        logs.into_iter().map(f64::exp).collect()
    }

    /// Median with 5 and 95 % quantiles over the loss with every constant at its median.
    pub(crate) fn quantiles(&self, place: MapPlace) -> Estimate {
        median_with_ends(&self.ratios(place))
    }
}

/// Coordinate of `value` among ascending `nodes` in parts of an interval, held at the ends.
fn coordinate(nodes: &[f64], value: f64) -> u32 {
    let interval = NodeInterval::from_nodes(nodes, |node| *node, value).held();
    // NaN counts as the lower node.
    let part = (interval.part * f64::from(PARTS)).round() as u32;
    PARTS * interval.low as u32 + part * (interval.high - interval.low) as u32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nodes_are_the_ends_and_the_middle_of_the_ratios_from_a_fiftieth_of_the_largest() {
        let speeds = [0.0, 1.0, 10.0, 100.0];
        let axes = Axes::new(&[100.0], &speeds, &[20.0, 40.0, 60.0, 90.0]).unwrap();
        let torques = [1.0, 3.0, 20.0, 50.0, 80.0, 100.0];
        let nodes = Nodes::new(MapBand::Nodes, &torques, &axes);
        assert_eq!(nodes.torque_nm, [3.0, 20.0, 100.0]);
        assert_eq!(nodes.speed_rpm, [10.0, 100.0]);
        assert_eq!(nodes.temperature_c, [20.0, 40.0, 90.0]);
        assert!(nodes.has(20.0, 10.0, 90.0) && !nodes.has(50.0, 10.0, 90.0));
        assert_eq!(three(&torques[2..]), [20.0, 50.0, 100.0]);
        assert_eq!(Nodes::new(MapBand::None, &torques, &axes), Nodes::default());
    }

    #[test]
    fn places_are_held_at_the_ends() {
        let nodes = [1.0, 3.0, 4.0];
        for (value, expected) in [
            (0.0, 0),
            (1.0, 0),
            (2.0, 32),
            (3.0, 64),
            (3.75, 112),
            (4.0, 128),
            (9.0, 128),
            (f64::NAN, 0),
        ] {
            assert_eq!(coordinate(&nodes, value), expected, "{value}");
        }
        assert_eq!(coordinate(&[5.0], 7.0), 0);
    }
}
