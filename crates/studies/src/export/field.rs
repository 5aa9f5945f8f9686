//! Exported data of a finish at one temperature.

use std::collections::BTreeMap;

use super::added;
use super::added::AddedLoss;
use super::error;
use crate::map::{EXTENDED, Map, MeshPart, Surface};
use asperity_core::Fault;

/// Loss torque of the mesh and added loss torque over torque and speed of the input shaft.
#[derive(Debug, Clone, PartialEq)]
pub struct Field {
    /// Title of the case.
    pub title: String,
    /// Name of the finish.
    pub finish: String,
    /// Scope of the losses.
    pub scope: String,
    /// Temperature \[°C\].
    pub temperature_c: f64,
    /// Revolutions of the input shaft per revolution of the output shaft; `None` of several outputs.
    pub ratio: Option<f64>,
    /// Torques \[N m\], ascending.
    pub torque_nm: Vec<f64>,
    /// Speeds \[1/min\], ascending from 0.
    pub speed_rpm: Vec<f64>,
    /// Loss torque of the mesh \[N m\], by torque.
    pub mesh_nm: Vec<f64>,
    /// Name and loss torque of each mesh of a gear train \[N m\], which add up to the one of all meshes.
    pub parts: Vec<(String, Vec<f64>)>,
    /// Added loss torque \[N m\].
    pub added_nm: Option<Vec<f64>>,
    /// Flanks that carry the load at a negative torque, in words.
    pub flanks: &'static str,
    /// Inputs out of their fitted range, or extended losses, with the number of nodes.
    pub outside: Vec<(String, usize)>,
}

/// The distinct marks in order, with the sum of the numbers of each.
fn counted<'a>(marks: impl Iterator<Item = (&'a String, usize)>) -> Vec<(String, usize)> {
    let mut counts: BTreeMap<&String, usize> = BTreeMap::new();
    for (mark, count) in marks {
        *counts.entry(mark).or_default() += count;
    }
    let owned = counts
        .into_iter()
        .map(|(mark, count)| (mark.clone(), count));
    owned.collect()
}

impl Field {
    /// Makes the fields of a finish, by temperature.
    ///
    /// # Errors
    /// When a point has no result, or the added loss does not cover the map.
    pub fn all(map: &Map, finish: usize, added: Option<&AddedLoss>) -> Result<Vec<Self>, Fault> {
        let Some(of) = map.finishes.get(finish) else {
            return Ok(Vec::new());
        };
        let axes = &map.axes;
        let gearbox = map.gearbox.as_ref();
        let scope = match (added, gearbox) {
            (None, None) => format!("{} only, input shaft", map.scope),
            (Some(added), None) => format!("{} and added {}, input shaft", map.scope, added.name),
            (None, Some(gearbox)) => format!(
                "{} and gearbox of the case ({}), input shaft",
                map.scope,
                gearbox.parts.join("; ")
            ),
            (Some(added), Some(_)) => {
                let name = added.name.clone();
                return Err(added::twice(name));
            }
        };
        let nodes = axes.torque_nm.len() * axes.speed_rpm.len();
        let field = |(index, &temperature_c): (usize, &f64)| {
            let Some(surface) = of.surface(axes, index) else {
                return Err(error::holes(map));
            };
            let added_nm = match (added, gearbox) {
                (Some(added), _) => Some(added.at_nodes(axes, temperature_c)?),
                (None, Some(gearbox)) => {
                    let losses = gearbox
                        .loss_torque_nm
                        .get(index * nodes..(index + 1) * nodes);
                    Some(losses.ok_or_else(|| error::holes(map))?.to_vec())
                }
                (None, None) => None,
            };
            let part = |mesh: &MeshPart| {
                let losses = mesh.loss_torque_nm.get(index * nodes..(index + 1) * nodes);
                let losses = losses.and_then(|losses| losses.iter().copied().collect());
                let name = match mesh.count {
                    1 => mesh.name.clone(),
                    count => format!("{count} {}", mesh.name),
                };
                Ok((name, losses.ok_or_else(|| error::holes(map))?))
            };
            let parts = of.meshes.iter().map(part).collect::<Result<_, Fault>>()?;
            let points = of.points.iter().skip(index * nodes).take(nodes);
            Ok(Self {
                title: map.title.clone(),
                finish: of.name.clone(),
                scope: scope.clone(),
                temperature_c,
                ratio: map.ratio,
                torque_nm: surface.torque_nm,
                speed_rpm: surface.speed_rpm,
                mesh_nm: surface.loss_torque_nm,
                parts,
                flanks: match (axes.torque_nm.first(), of.coast_files.is_empty()) {
                    (Some(low), true) if *low < 0.0 => "; negative torque: the same flanks",
                    (Some(low), false) if *low < 0.0 => "; negative torque: the coast flanks",
                    _ => "",
                },
                added_nm,
                outside: counted(
                    points.flat_map(|point| point.outside.iter().map(|mark| (mark, 1))),
                ),
            })
        };
        axes.temperature_c.iter().enumerate().map(field).collect()
    }

    /// Total loss torque of mesh and added loss \[N m\].
    #[must_use]
    pub(crate) fn total_nm(&self) -> Vec<f64> {
        match &self.added_nm {
            None => self.mesh_nm.clone(),
            Some(added) => self.mesh_nm.iter().zip(added).map(|(a, b)| a + b).collect(),
        }
    }

    /// Interpolation of the total loss torque.
    #[must_use]
    pub fn surface(&self) -> Surface {
        let loss_torque_nm = self.total_nm();
        Surface {
            torque_nm: self.torque_nm.clone(),
            speed_rpm: self.speed_rpm.clone(),
            loss_torque_nm,
        }
    }

    /// Speeds \[rad/s\].
    #[must_use]
    pub fn omega(&self) -> Vec<f64> {
        let omega = |rpm: &f64| rpm * std::f64::consts::PI / 30.0;
        self.speed_rpm.iter().map(omega).collect()
    }

    /// Rule for points outside of the nodes, for the head of a table whose reader may extrapolate differently.
    pub(super) const BEYOND: &str = "outside the table hold loss torque over torque, as Asperity does: a reader that holds the last loss torque is too low at higher torques, so have it refuse";

    /// Head of a file, in one line.
    pub(super) fn head(&self) -> String {
        Self::head_of(std::slice::from_ref(self))
    }

    /// Head of a file of the fields of a finish, in one line.
    pub(super) fn head_of(fields: &[Self]) -> String {
        let Some(first) = fields.first() else {
            return String::new();
        };
        let plain = |text: &str| text.replace(['\n', '\r'], " ");
        let temperatures = fields.iter().map(|field| field.temperature_c.to_string());
        let nodes: usize = fields.iter().map(|field| field.mesh_nm.len()).sum();
        let marks = fields.iter().flat_map(|field| &field.outside);
        let marks = counted(marks.map(|(mark, count)| (mark, *count)));
        let places = |count: usize| {
            if count == nodes {
                "every node".to_owned()
            } else {
                format!("{count} of {nodes} nodes")
            }
        };
        let (extended, outside): (Vec<_>, Vec<_>) =
            marks.into_iter().partition(|(mark, _)| mark == EXTENDED);
        let outside = outside
            .iter()
            .map(|(mark, count)| format!("{} ({})", plain(mark), places(*count)));
        let mut said = match outside.collect::<Vec<_>>().join(", ") {
            none if none.is_empty() => none,
            outside => format!("; outside a fitted range: {outside}"),
        };
        for (_, count) in extended {
            said += "; loss extended below the torque that the traces resolve: ";
            said += &places(count);
        }
        format!(
            "Asperity, {}, finish {}, {} °C{}{said}",
            plain(&first.title),
            plain(&first.finish),
            temperatures.collect::<Vec<_>>().join(", "),
            first.flanks
        )
    }

    /// Rejects a map of one torque or one speed.
    pub(super) fn check_size(&self, format: &'static str) -> Result<(), Fault> {
        if self.torque_nm.len() >= 2 && self.speed_rpm.len() >= 2 {
            Ok(())
        } else {
            Err(error::too_small(format))
        }
    }

    /// Rejects a map without torques of both signs.
    pub(super) fn check_signs(&self, format: &'static str) -> Result<(), Fault> {
        let ends = (self.torque_nm.first(), self.torque_nm.last());
        match ends {
            (Some(low), Some(high)) if *low < 0.0 && *high > 0.0 => Ok(()),
            _ => Err(error::one_sign(format)),
        }
    }

    /// Rejects a map whose loss torque increases as fast as the torque: the output torque would not determine the input
    /// torque.
    pub(super) fn check_slope(&self, format: &'static str) -> Result<(), Fault> {
        let total = self.total_nm();
        let across = self.speed_rpm.len();
        for i in 1..self.torque_nm.len() {
            for (j, &speed_rpm) in self.speed_rpm.iter().enumerate() {
                let rise = total[i * across + j] - total[(i - 1) * across + j];
                if rise >= self.torque_nm[i] - self.torque_nm[i - 1] {
                    return Err(error::slope(format, self.torque_nm[i], speed_rpm));
                }
            }
        }
        Ok(())
    }
}
