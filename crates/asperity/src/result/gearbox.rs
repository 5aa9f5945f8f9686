//! Losses of the gearbox in addition to the meshes, as its user states them. No band belongs to these parts.

use asperity_core::quantity::{AngularSpeed, Torque};
use asperity_core::{Estimate, OutOfRange};
use serde::{Deserialize, Serialize};

/// Scope of a result.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Scope {
    /// The mesh only: no bearings, seals, churning.
    #[default]
    Mesh,
    /// The mesh and the parts of the gearbox that the user states.
    Gearbox,
}

/// Loss and efficiency of the gearbox: of the mesh by the model, of all else as the user states it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct GearboxReport {
    /// η = 1 − (mesh and parts)/power in.
    pub efficiency: f64,
    /// Losses of mesh and parts together \[W\].
    pub loss_w: f64,
    /// Losses of the parts \[W\], from the user's input, without an uncertainty.
    pub parts_w: f64,
    /// Power into the gearbox \[W\].
    pub power_in_w: f64,
    /// Temperature of the oil at the parts \[°C\].
    pub temperature_c: f64,
    /// The parts, in the order of the case file.
    pub parts: Vec<GearboxPart>,
}

impl GearboxReport {
    /// The loss \[W\] with the interval that the mesh leaves: that of the mesh plus the parts.
    #[must_use]
    pub fn drawn_w(&self, of_mesh: Estimate) -> Estimate {
        of_mesh.map(|loss| loss + self.parts_w)
    }
}

/// Loss of a part of the gearbox.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct GearboxPart {
    /// Its name.
    pub name: String,
    /// `seal`, `bearing`, `jet` or `table`.
    pub kind: String,
    /// Law that its loss follows.
    pub law: String,
    /// Loss \[W\].
    pub loss_w: f64,
    /// Torque \[N m\]: of a seal and a bearing at its own shaft, else at the pinion.
    pub torque_nm: f64,
    /// Inputs outside the range of their law.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub outside: Vec<String>,
}

impl GearboxPart {
    /// A part by its kind and law, with the torque at its shaft and the speed of the shaft.
    pub(crate) fn new(
        name: &str,
        [kind, law]: [&str; 2],
        torque: Torque,
        speed: AngularSpeed,
        outside: &[OutOfRange],
    ) -> Self {
        Self {
            name: name.to_owned(),
            kind: kind.to_owned(),
            law: law.to_owned(),
            loss_w: torque.si() * speed.si(),
            torque_nm: torque.si(),
            outside: outside.iter().map(ToString::to_string).collect(),
        }
    }
}
