//! Keys of the losses other than the loss of the mesh: shaft seals, rolling bearings, an oil jet, a table.

use std::path::PathBuf;

use asperity_core::quantity::{Force, Length, Mass, Speed, Temperature, Torque, VolumeFlow};
use serde::{Deserialize, Serialize};

/// Losses of the gearbox other than the loss of the mesh; only the losses stated here are added.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct GearboxInput {
    /// Temperature of the oil at bearings and jet and in the table; default that of the operation.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub temperature: Option<Temperature>,
    /// CSV file, relative to the case file, with the loss torque at the pinion of all other parts:
    /// columns `speed_rpm`, `loss_torque_nm` or `loss_w` and, where the loss depends on them, `torque_nm` and `temperature_c`, as
    /// a grid; linear in between, nothing beyond.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub loss_table: Option<PathBuf>,
    /// Radial shaft seals, each a table `[[gearbox.seals]]` with `shaft` (`pinion` or `wheel`), `diameter` of the
    /// shaft and, if wanted, `name`.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub seals: Vec<SealInput>,
    /// Rolling bearings, each a table `[[gearbox.bearings]]` with `shaft`, `kind` (`deep-groove-ball`,
    /// `cylindrical-roller` or `tapered-roller`), `bore`, `outside_diameter`, `radial` and `axial` load, and the
    /// constants of SKF's form from the bearing's catalogue: `r1`, `r2`, `s1`, `s2`, `k_z`, `k_rs`, `mu_bl`,
    /// `mu_ehl`; ball bearings need `static_rating`, tapered rollers `axial_factor`. Loads grow with
    /// the torque where `at_torque` says at which they were stated, and are constant otherwise. `name` if wanted.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub bearings: Vec<BearingInput>,
    /// Oil jet onto the mesh: `{ flow = "2.5 l/min", speed = "20 m/s" }`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub jet: Option<JetInput>,
}

/// A radial shaft seal.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct SealInput<S = Shaft> {
    /// Name, shown with its loss; default `seal 1`, counted.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Shaft that it runs on: `pinion` or `wheel`, in a gear train its name.
    pub shaft: S,
    /// Diameter of the shaft under the lip.
    pub diameter: Length,
}

/// A rolling bearing with its load.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct BearingInput<S = Shaft> {
    /// Name, shown with its loss; default `bearing 1`, counted.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Shaft that it carries: `pinion` or `wheel`, in a gear train its name.
    pub shaft: S,
    /// Shape of its rolling bodies.
    pub kind: BearingKind,
    /// Bore d.
    pub bore: Length,
    /// Outside diameter D.
    pub outside_diameter: Length,
    /// Place along the shaft, in a gear train: the loads then follow from the teeth.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub at: Option<Length>,
    /// Whether it carries the axial force of its shaft, in a gear train; default false.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub locating: Option<bool>,
    /// Mass of a planet with its share of the bearing, whose centrifugal force the bearings of planets carry; default 0 kg.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub planet_mass: Option<Mass>,
    /// Equal bearings of each planet, which share its load; default 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub per_planet: Option<u32>,
    /// Radial load F_r of a pair of gears.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub radial: Option<Force>,
    /// Axial load F_a; default 0 N.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub axial: Option<Force>,
    /// Torque at the pinion at which the loads are as stated, in proportion to which they are taken; default: they
    /// are the same at every torque.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub at_torque: Option<Torque>,
    /// Static load rating C₀ of a deep groove ball bearing.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub static_rating: Option<Force>,
    /// Axial load factor Y of a tapered roller bearing.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub axial_factor: Option<f64>,
    /// R₁ of the series.
    pub r1: f64,
    /// R₂ of the series; cylindrical roller bearings have none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub r2: Option<f64>,
    /// S₁ of the series.
    pub s1: f64,
    /// S₂ of the series.
    pub s2: f64,
    /// K_z of the type.
    pub k_z: f64,
    /// K_rs of the lubrication: 6e-8 with grease, 3e-8 with a jet or a low oil level, 0 in a bath.
    pub k_rs: f64,
    /// Coefficient of sliding where the film breaks down.
    pub mu_bl: f64,
    /// Coefficient of sliding on a whole film.
    pub mu_ehl: f64,
}

/// A table of losses on a shaft of a gear train: of gears that run idle, a clutch, a pump.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct TableInput {
    /// Name, shown with its loss; default the name of the file.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Shaft whose speed the table is over.
    pub shaft: String,
    /// Other shaft of a clutch: the table is then over the difference of both speeds.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub against: Option<String>,
    /// CSV file, relative to the case file: columns `speed_rpm`, `loss_torque_nm` or `loss_w` and, where the loss depends on
    /// them, `torque_nm` (of the operation) and `temperature_c`, as a grid; linear in between, nothing beyond.
    pub file: PathBuf,
}

/// An oil jet onto a pair of gears of a gear train.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct MeshJetInput {
    /// Name, shown with its loss; default `jet 1`, counted.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Name of the mesh.
    pub mesh: String,
    /// Flow of the jet.
    pub flow: VolumeFlow,
    /// Speed of the jet at the nozzle.
    pub speed: Speed,
}

/// An oil jet.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct JetInput {
    /// Flow of the jet.
    pub flow: VolumeFlow,
    /// Speed of the jet at the nozzle.
    pub speed: Speed,
}

/// Shaft of a part.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum Shaft {
    /// That of the pinion.
    Pinion,
    /// That of the wheel.
    Wheel,
}

/// Shape of the rolling bodies of a bearing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum BearingKind {
    /// Balls in deep grooves.
    DeepGrooveBall,
    /// Cylinders.
    CylindricalRoller,
    /// Tapers.
    TaperedRoller,
}
