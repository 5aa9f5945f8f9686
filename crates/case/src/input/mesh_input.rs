//! Keys of the meshes of a case whose meshes have names: their shafts, gears and sets.

use std::collections::BTreeMap;

use asperity_core::quantity::{Angle, AngularSpeed, Length};
use serde::{Deserialize, Serialize};

use super::bulk_input::BulkInput;
use super::gear_input::GearFlankInput;
use super::gearbox_input::Hand;
use super::input_tables::{GearsInput, MaterialInput, SurfaceInput, is_unstated};
use super::rows::{Judge, KeyPath, RangedKey, limits};

/// Name of a mesh in the paths of rows.
pub(crate) const MESH: &str = "NAME";

limits! {
    MeshInput;
    at = "mm" usual [-5000.0, 5000.0] possible [-100_000.0, 100_000.0];
    angle = "deg" usual [-360.0, 360.0] possible [-3600.0, 3600.0];
    planetary => table;
}

/// Shafts at which the power enters and leaves a gear train.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct ShaftsInput {
    /// Shaft with torque and speed of the operation.
    pub input: String,
    /// Shaft at which the power leaves; default: the only other end of the train.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub output: Option<String>,
    /// Shafts that do not turn; a ring without a shaft is held.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub held: Vec<String>,
    /// Torques of the meshes: `not-passed-on` (default), by the tooth numbers, or `passed-on`, lowered by the losses
    /// of the meshes before.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub losses: Option<PassedLosses>,
}

/// Whether losses lower the torques of the following meshes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum PassedLosses {
    /// Torques by the tooth numbers.
    #[default]
    NotPassedOn,
    /// Torques lowered by the losses.
    PassedOn,
}

/// A mesh of a gear train: a pair of gears, or a planetary set.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct MeshInput {
    /// Shafts of pinion and wheel; of a planetary set sun and carrier, or sun, carrier and ring.
    pub shafts: Vec<String>,
    /// A pair of gears; the number of teeth of a ring is negative.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gears: Option<GearsInput>,
    /// A planetary set.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub planetary: Option<PlanetaryInput>,
    /// Middle of the teeth along the shafts, for the loads of the bearings.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub at: Option<Length>,
    /// Angle of the centre line from the pinion to the wheel about the axes, for the loads of the bearings of a shaft with
    /// several meshes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub angle: Option<Angle>,
    /// Direction of the helix of the pinion or sun, for the loads of the bearings: `left` or `right`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hand: Option<Hand>,
    /// Law of the bulk temperature of this mesh, such as the conductances of its gears to the oil; default
    /// `operation.bulk`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bulk: Option<BulkInput>,
    /// Steel of this mesh.
    #[serde(default, skip_serializing_if = "is_unstated")]
    pub material: MaterialInput,
    /// Flanks of this mesh, and the preparation of their traces.
    #[serde(default, skip_serializing_if = "is_unstated")]
    pub surface: SurfaceInput,
}

/// Sun, planets and ring. Three values belong to sun, planet and ring.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct PlanetaryInput {
    /// Tooth numbers; the ring's may be negative: `[27, 24, -75]`.
    pub teeth: [i32; 3],
    /// Number of planets.
    pub planets: u32,
    /// Normal module.
    pub module: Length,
    /// Helix angle β; default 0 deg.
    pub helix: Option<Angle>,
    /// Normal pressure angle; default 20 deg.
    pub pressure_angle: Option<Angle>,
    /// Face widths.
    pub face_width: [Length; 3],
    /// Profile shift coefficients; default `[0, 0, 0]`. A positive one brings the ring's teeth towards its axis.
    pub profile_shift: Option<[f64; 3]>,
    /// Distance of the planet axes from that of the sun; derived from the profile shifts when not given.
    pub centre_distance: Option<Length>,
    /// Tip diameters; derived from the addendum when not given.
    pub tip_diameter: Option<[Length; 3]>,
    /// Addendum in modules; default 1.
    pub addendum: Option<f64>,
    /// Speed of the ring; default 0, held.
    pub ring_speed: Option<AngularSpeed>,
    /// Load of the most loaded planet over the mean, K_γ, which raises pressures alone; default 1.
    pub load_share_factor: Option<f64>,
    /// Flanks, tip and root of the sun.
    pub sun: Option<GearFlankInput>,
    /// Flanks, tip and root of the planets.
    pub planet: Option<GearFlankInput>,
    /// Flanks, tip and root of the ring.
    pub ring: Option<GearFlankInput>,
}

limits! {
    PlanetaryInput;
    planets = "" usual [1.0, 12.0] possible [1.0, 200.0];
    ring_speed = "1/min" usual [-60_000.0, 60_000.0] possible [-1e6, 1e6];
    load_share_factor = "" usual [1.0, 2.0] possible [0.1, 100.0];
}

/// Meshes by their names.
impl RangedKey for BTreeMap<String, MeshInput> {
    fn visit(stated: Option<&Self>, at: KeyPath<'_>, judge: Judge<'_>) {
        let Some(meshes) = stated else {
            return MeshInput::visit(None, at.below(MESH), judge);
        };
        for (name, mesh) in meshes {
            MeshInput::visit(Some(mesh), at.below(name), judge);
        }
    }
}
