//! Options of `asperity calibrate`.

use std::path::PathBuf;

use asperity::case::CalibratedName;
use asperity_core::quantity::Ratio;
use clap::Args;

use super::SetArgs;

/// Rig table, or limits of a rig.
#[derive(Debug, Args)]
pub struct CalibrateArgs {
    /// Rig table; with --design only the case
    #[arg(value_name = "RIG.csv")]
    pub file: PathBuf,
    /// Case of the rows without a case
    #[arg(value_name = "CASE.toml")]
    pub case: Option<PathBuf>,
    /// Keys of the case set on the command line.
    #[command(flatten)]
    pub set: SetArgs,
    /// Hold a parameter at the value of the case instead of fitting it; repeat for several
    #[arg(long, value_enum, value_name = "PARAMETER")]
    pub hold: Vec<CalibratedName>,
    /// Choose the points to measure: those within the limits below with the best information on the parameters
    #[arg(long)]
    pub design: bool,
    /// Largest torque of the rig at the pinion in N m [default: the largest of the table; with --design map.torque_max
    /// of the case, or its torque]
    #[arg(long, value_name = "N_M")]
    pub torque_max: Option<f64>,
    /// Largest speed of the rig at the pinion in 1/min [default: the largest of the table; with --design map.speed_max
    /// of the case, or its speed]
    #[arg(long, value_name = "RPM")]
    pub speed_max: Option<f64>,
    /// Oil temperatures of the rig in °C: a..b:n or a list [default: lowest, middle and highest of the table; with
    /// --design 40,65,90, extended to the temperature of the case]
    #[arg(long, value_name = "AXIS")]
    pub temperature: Option<String>,
    /// Torques to choose from in N m: a..b:n, a..b:n:log or a list [default: a third of --torque-max, and --torque-max]
    #[arg(
        long,
        value_name = "AXIS",
        requires = "design",
        conflicts_with = "torque_max"
    )]
    pub torque: Option<String>,
    /// Speeds to choose from in 1/min [default: 8 speeds from a fiftieth of --speed-max up to it]
    #[arg(
        long,
        value_name = "AXIS",
        requires = "design",
        conflicts_with = "speed_max"
    )]
    pub speed: Option<String>,
    /// Measuring time in hours, without heating
    #[arg(long, default_value_t = 8.0, value_name = "H")]
    pub hours: f64,
    /// Minutes per point
    #[arg(long, default_value_t = 15.0, value_name = "MIN")]
    pub minutes: f64,
    /// Standard deviation of a point relative to its loss
    #[arg(long, default_value = "3 %", value_name = "SHARE")]
    pub sigma: Ratio,
    /// Number of assemblies; each measures all points
    #[arg(long, default_value_t = 2, value_name = "N")]
    pub assemblies: usize,
    /// Also write simulated.csv: losses at these points, simulated with the case and random errors of this seed, to
    /// test a calibration
    #[arg(long, requires = "design", value_name = "SEED")]
    pub simulate: Option<u64>,
    /// Folder of the result [default: results/<name of the table>-calibration, or results/<name of the
    /// case>-design]
    #[arg(long, short)]
    pub output: Option<PathBuf>,
}
