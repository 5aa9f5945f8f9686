//! Options of `asperity calibrate`.

use std::path::PathBuf;

use asperity::case::CalibratedName;
use asperity_core::quantity::Ratio;
use clap::{Args, ValueEnum};

use super::SetArgs;

/// A rig's table, or the limits of a rig.
#[derive(Debug, Args)]
pub struct CalibrateArgs {
    /// The rig's table; with --design the case alone
    #[arg(value_name = "RIG.csv")]
    pub file: PathBuf,
    /// The case of the rows that name none
    #[arg(value_name = "CASE.toml")]
    pub case: Option<PathBuf>,
    /// Keys set past the case.
    #[command(flatten)]
    pub set: SetArgs,
    /// Hold a parameter at the value of the case instead of fitting it; repeat for several
    #[arg(long, value_enum, value_name = "PARAMETER")]
    pub hold: Vec<ParameterArg>,
    /// Propose the points to measure: those of the axes below that find the parameters best
    #[arg(long)]
    pub design: bool,
    /// Torques of the rig in N m: a..b:n, a..b:n:log or a list [default: a third and all of that of the case]
    #[arg(long, value_name = "AXIS", requires = "design")]
    pub torque: Option<String>,
    /// Speeds of the rig in 1/min [default: 8 up to that of the case, from a fiftieth of it]
    #[arg(long, value_name = "AXIS", requires = "design")]
    pub speed: Option<String>,
    /// Oil temperatures of the rig in °C [default: 40,65,90]
    #[arg(long, value_name = "AXIS", requires = "design")]
    pub temperature: Option<String>,
    /// Hours of measuring, heating left out
    #[arg(long, default_value_t = 8.0, value_name = "H")]
    pub hours: f64,
    /// Minutes of a point
    #[arg(long, default_value_t = 15.0, value_name = "MIN")]
    pub minutes: f64,
    /// Standard deviation of a point over its loss
    #[arg(long, default_value = "3 %", value_name = "SHARE")]
    pub sigma: Ratio,
    /// Assemblies, which all measure the same points
    #[arg(long, default_value_t = 2, value_name = "N")]
    pub assemblies: usize,
    /// Also write simulated.csv: losses that a rig might measure at these points, simulated with the case and
    /// random errors of this seed, to rehearse a calibration
    #[arg(long, requires = "design", value_name = "SEED")]
    pub simulate: Option<u64>,
    /// Folder of the result [default: results/<name of the table>-calibration, or results/<name of the
    /// case>-design]
    #[arg(long, short)]
    pub output: Option<PathBuf>,
}

/// Parameters that can be held.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum ParameterArg {
    /// Coefficient of boundary friction
    BoundaryFriction,
    /// Thickness of the boundary layer, which decides the share of boundary friction
    BoundaryLayer,
    /// Limiting shear stress over pressure
    LimitingShear,
    /// Eyring stress
    EyringStress,
}

impl ParameterArg {
    /// The parameter of the case.
    pub fn name(self) -> CalibratedName {
        match self {
            Self::BoundaryFriction => CalibratedName::BoundaryFriction,
            Self::BoundaryLayer => CalibratedName::BoundaryLayer,
            Self::LimitingShear => CalibratedName::LimitingShear,
            Self::EyringStress => CalibratedName::EyringStress,
        }
    }
}
