//! Keys of the losses other than the loss of the mesh: shaft seals, rolling bearings, an oil jet, a table.

use std::path::PathBuf;

use asperity_core::quantity::{Force, Length, Mass, Speed, Temperature, Torque, VolumeFlow};
use serde::{Deserialize, Serialize};

use super::rows::{OPEN, ratio, table};

table! {
    /// Losses of the gearbox other than the loss of the mesh; only the losses stated here are added.
    #[derive(Default)]
    GearboxInput;

    /// Temperature of the oil at bearings and jet and in the table; default that of the operation.
    #[serde(skip_serializing_if = "Option::is_none")]
    temperature: Option<Temperature> = "°C" usual [-40.0, 160.0] possible [-100.0, 400.0];
    /// CSV file, relative to the case file, with the loss torque at the pinion of all other parts:
    /// columns `speed_rpm`, `loss_torque_nm` or `loss_w` and, where the loss depends on them, `torque_nm` and `temperature_c`, as
    /// a grid; linear in between, nothing beyond.
    #[serde(skip_serializing_if = "Option::is_none")]
    loss_table: Option<PathBuf>;
    /// Radial shaft seals, each a table `[[gearbox.seals]]` with `shaft` (`pinion` or `wheel`, in a gear train its name),
    /// `diameter` of the shaft and, if wanted, `name`.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    seals: Vec<SealInput> => table;
    /// Rolling bearings, each a table `[[gearbox.bearings]]` with `shaft`, `kind` (`deep-groove-ball`,
    /// `cylindrical-roller` or `tapered-roller`), `bore`, `outside_diameter`, `radial` and `axial` load, and the
    /// constants of SKF's form from the bearing's catalogue: `r1`, `r2`, `s1`, `s2`, `k_z`, `k_rs`, `mu_bl`,
    /// `mu_ehl`; ball bearings need `static_rating`, tapered rollers `axial_factor`. Loads grow with
    /// the torque where `at_torque` says at which they were stated, and are constant otherwise. `name` if wanted. In a gear
    /// train two on a shaft, each with its place `at` along the shaft: their loads follow from the teeth by statics, with
    /// `at`, `angle` and `hand` of each mesh on the shaft, and the bearing with `locating = true` carries the axial force. The
    /// bearings of the planets of a set have the shaft `NAME planet` (`planet` in a case `[planetary]`), no place, and, if
    /// wanted, `planet_mass` and `per_planet`.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    bearings: Vec<BearingInput> => table;
    /// Oil jet onto the mesh: `{ flow = "2.5 l/min", speed = "20 m/s" }`.
    #[serde(skip_serializing_if = "Option::is_none")]
    jet: Option<JetInput> => table;
    /// Oil jets onto pairs of gears of a gear train, each a table `[[gearbox.jets]]` with the name of its `mesh`, `flow`, `speed`
    /// and, if wanted, `name`.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    jets: Vec<MeshJetInput> => table;
    /// Measured losses of a gear train, as of gears that run idle and of clutches, each a table `[[gearbox.tables]]` with the
    /// name of its `shaft`, `file` and, if wanted, `name`; a clutch names its other shaft `against` which it turns.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    tables: Vec<TableInput>;
}

table! {
    /// A radial shaft seal.
    SealInput;

    /// Name, shown with its loss; default `seal 1`, counted.
    #[serde(skip_serializing_if = "Option::is_none")]
    name: Option<String>;
    /// Shaft that it runs on: `pinion` or `wheel`, in a gear train its name.
    shaft: String;
    /// Diameter of the shaft under the lip.
    diameter: Length = "mm" usual [3.0, 1000.0] possible [0.5, 10_000.0];
}

table! {
    /// A rolling bearing with its load.
    BearingInput;

    /// Name, shown with its loss; default `bearing 1`, counted.
    #[serde(skip_serializing_if = "Option::is_none")]
    name: Option<String>;
    /// Shaft that it carries: `pinion` or `wheel`, in a gear train its name.
    shaft: String;
    /// Shape of its rolling bodies.
    kind: BearingKind;
    /// Bore d.
    bore: Length = "mm" usual [2.0, 2000.0] possible [0.1, 20_000.0];
    /// Outside diameter D.
    outside_diameter: Length = "mm" usual [4.0, 3000.0] possible [0.2, 30_000.0];
    /// Place along the shaft, in a gear train: the loads then follow from the teeth.
    #[serde(skip_serializing_if = "Option::is_none")]
    at: Option<Length> = "mm" usual [-5000.0, 5000.0] possible [-100_000.0, 100_000.0];
    /// Whether it carries the axial force of its shaft, in a gear train; default false.
    #[serde(skip_serializing_if = "Option::is_none")]
    locating: Option<bool>;
    /// Mass of a planet with its share of the bearing, whose centrifugal force the bearings of planets carry; default 0 kg.
    #[serde(skip_serializing_if = "Option::is_none")]
    planet_mass: Option<Mass> = "kg" usual [0.001, 5000.0] possible [1e-6, 1e6];
    /// Equal bearings of each planet, which share its load; default 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    per_planet: Option<u32> = "" usual [1.0, 4.0] possible [1.0, 20.0];
    /// Radial load F_r of a pair of gears.
    #[serde(skip_serializing_if = "Option::is_none")]
    radial: Option<Force> = "kN" usual [0.001, 5000.0] possible [1e-6, 1e6];
    /// Axial load F_a; default 0 N.
    #[serde(skip_serializing_if = "Option::is_none")]
    axial: Option<Force> = "kN" usual [0.001, 2000.0] possible [1e-6, 1e6];
    /// Torque at the pinion at which the loads are as stated, in proportion to which they are taken; default: they
    /// are the same at every torque.
    #[serde(skip_serializing_if = "Option::is_none")]
    at_torque: Option<Torque> = "N m" usual [0.01, 1e6] possible [1e-9, 1e8];
    /// Static load rating C₀ of a deep groove ball bearing.
    #[serde(skip_serializing_if = "Option::is_none")]
    static_rating: Option<Force> = "kN" usual [0.01, 20_000.0] possible [1e-4, 1e6];
    /// Axial load factor Y of a tapered roller bearing.
    #[serde(skip_serializing_if = "Option::is_none")]
    axial_factor: Option<f64> = "" usual [0.3, 3.0] possible [0.01, 30.0];
    /// R₁ of the series.
    r1: f64 = "" usual [1e-7, 5e-6] possible [1e-9, 1e-3];
    /// R₂ of the series; cylindrical roller bearings have none.
    #[serde(skip_serializing_if = "Option::is_none")]
    r2: Option<f64> = "" usual [0.5, 20.0] possible [0.01, 1000.0];
    /// S₁ of the series.
    s1: f64 = "" usual [5e-4, 0.5] possible [1e-6, 50.0];
    /// S₂ of the series.
    s2: f64 = "" usual [2e-4, 10.0] possible [1e-7, 1000.0];
    /// K_z of the type.
    k_z: f64 = "" usual [2.0, 8.0] possible [0.1, 100.0];
    /// K_rs of the lubrication: 6e-8 with grease, 3e-8 with a jet or a low oil level, 0 in a bath.
    k_rs: f64 = "" usual [1e-8, 1e-7] possible [1e-10, 1e-5];
    /// Coefficient of sliding where the film breaks down.
    mu_bl: f64 = "" usual [0.02, 0.3] possible [0.001, 2.0];
    /// Coefficient of sliding on a whole film.
    mu_ehl: f64 = "" usual [5e-4, 0.2] possible [1e-5, 2.0];

    => {
        "outside_diameter": "outside diameter over the bore", |bearing| ratio(Some(bearing.outside_diameter.si()), Some(bearing.bore.si())),
            "" usual [1.1, 5.0] possible OPEN;
        "static_rating": "static rating over the square of the bore", |bearing| bearing.over_bore(bearing.static_rating),
            "N/mm2" usual [0.5, 60.0] possible [0.01, 3000.0];
        "radial": "radial load over the square of the bore", |bearing| bearing.over_bore(bearing.radial),
            "N/mm2" usual [0.005, 100.0] possible [0.0, 3000.0];
        "axial": "axial load over the square of the bore", |bearing| bearing.over_bore(bearing.axial),
            "N/mm2" usual [0.001, 100.0] possible [0.0, 3000.0];
        "s2": "S2 over the one of its kind (balls 4, cylinders 0.0015, tapers 2)", |bearing| vec![bearing.s2 / bearing.kind.usual_s2()],
            "" usual [0.05, 20.0] possible OPEN;
    }
}

impl BearingInput {
    /// A force over the square of the bore \[N/mm²\]; catalogues rate balls at up to 25 N/mm², rollers at up to 90.
    fn over_bore(&self, force: Option<Force>) -> Vec<f64> {
        let square = 1e6 * self.bore.si() * self.bore.si();
        ratio(force.map(Force::si), Some(square))
    }
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

table! {
    /// An oil jet onto a pair of gears of a gear train.
    MeshJetInput;

    /// Name, shown with its loss; default `jet 1`, counted.
    #[serde(skip_serializing_if = "Option::is_none")]
    name: Option<String>;
    /// Name of the mesh.
    mesh: String;
    /// Flow of the jet.
    flow: VolumeFlow = "l/min" usual [0.01, 500.0] possible [1e-5, 50_000.0];
    /// Speed of the jet at the nozzle.
    speed: Speed = "m/s" usual [0.1, 150.0] possible [1e-3, 1000.0];
}

table! {
    /// An oil jet.
    #[derive(Copy)]
    JetInput;

    /// Flow of the jet.
    flow: VolumeFlow = "l/min" usual [0.01, 500.0] possible [1e-5, 50_000.0];
    /// Speed of the jet at the nozzle.
    speed: Speed = "m/s" usual [0.1, 150.0] possible [1e-3, 1000.0];
}

/// Direction of a helix.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum Hand {
    /// Left-handed.
    Left,
    /// Right-handed.
    Right,
}

impl BearingKind {
    /// S₂ of a usual series in SKF's catalogue.
    const fn usual_s2(self) -> f64 {
        match self {
            Self::DeepGrooveBall => 4.0,
            Self::CylindricalRoller => 0.0015,
            Self::TaperedRoller => 2.0,
        }
    }
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
