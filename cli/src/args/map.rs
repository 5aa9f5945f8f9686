//! Options of `asperity map`, `cycle` and `sweep`.

use std::path::PathBuf;

use asperity_studies::export::Format;
use asperity_studies::map::MapSettings;
use clap::{Args, Subcommand};

use super::{FinishArg, SetArgs, WorkArgs};

/// A case and the axes of its map.
#[derive(Debug, Args)]
pub struct MapArgs {
    /// Case file, TOML (or JSON with the same keys); - reads standard input
    pub case: PathBuf,
    /// Keys of the case set on the command line.
    #[command(flatten)]
    pub set: SetArgs,
    /// Axes and points of the map.
    #[command(flatten)]
    pub settings: MapSettings,
    /// A finish and its traces, in a gear train of all meshes or of one; give several to see their difference
    /// [default: the flanks of the case]
    #[arg(long = "finish", value_name = "NAME[@MESH]=PINION.csv[,WHEEL.csv]")]
    pub finishes: Vec<FinishArg>,
    /// Cycle whose points are drawn over the map, in the format of asperity cycle
    #[arg(long, value_name = "TRACE.csv")]
    pub cycle: Option<PathBuf>,
    /// Also write the map for these programs, into the folder of the map
    #[arg(long, value_enum, value_name = "FORMAT", value_delimiter = ',')]
    pub export: Vec<Format>,
    /// Table with the loss torque of bearings, seals and churning, added to the exports as a separate part:
    /// columns torque_nm, speed_rpm, loss_torque_nm (and temperature_c)
    #[arg(long, value_name = "TABLE.csv", requires = "export")]
    pub add_loss: Option<PathBuf>,
    /// Folder of the map [default: results/<name of the case>-map, named as for run]
    #[arg(long, short)]
    pub output: Option<PathBuf>,
    /// Limits of the work.
    #[command(flatten)]
    pub work: WorkArgs,
}

/// A map and a cycle.
#[derive(Debug, Args)]
pub struct CycleArgs {
    /// Folder of a map
    pub map: PathBuf,
    /// Cycle: CSV with time_s and torque_nm, speed_rpm at the pinion, or speed_km_h (and grade_percent) with
    /// [vehicle] in the case of the map
    pub trace: PathBuf,
    /// Keys of the case of the map to set, e.g. vehicle.mass="1600 kg"
    #[command(flatten)]
    pub set: SetArgs,
    /// Temperature of the flanks in °C, one of the map [default: the first]
    #[arg(long, value_name = "°C", allow_hyphen_values = true)]
    pub temperature: Option<f64>,
    /// Names of the columns of a cycle without names, or in place of its own, e.g. time_s,speed_km_h; - leaves one out
    #[arg(
        long,
        value_name = "NAMES",
        value_delimiter = ',',
        allow_hyphen_values = true
    )]
    pub columns: Option<Vec<String>>,
    /// Permit more than 5 % of the energy of the cycle outside of the map, where the ratio of loss to torque is
    /// constant
    #[arg(long)]
    pub allow_outside: bool,
    /// Folder of the result [default: results/<name of the map>-<name of the cycle>]
    #[arg(long, short)]
    pub output: Option<PathBuf>,
    /// Do not write a folder
    #[arg(long, conflicts_with = "output")]
    pub no_output: bool,
}

/// Runs of many cases.
#[derive(Debug, Subcommand)]
pub enum SweepCommand {
    /// Run a study, or a shard of it; finished parts are stored and not run again
    #[command(after_help = "Examples:\n  asperity sweep run study.toml\n  \
        asperity sweep run study.toml --plan\n  \
        asperity sweep run study.toml --shard 3/64 --parts /scratch/parts")]
    Run(SweepRunArgs),
    /// Completed, missing and failed cases of a study; exit status 3 while cases are missing
    Status(SweepArgs),
    /// Merge the parts of a study: table, checksum, effects of the inputs, page
    Merge(SweepMergeArgs),
}

/// Study, and folder of its parts.
#[derive(Debug, Args)]
pub struct SweepArgs {
    /// Study file, TOML
    pub study: PathBuf,
    /// Folder of the parts [default: parts next to the study]
    #[arg(long)]
    pub parts: Option<PathBuf>,
}

/// A study to run.
#[derive(Debug, Args)]
pub struct SweepRunArgs {
    /// The study.
    #[command(flatten)]
    pub sweep: SweepArgs,
    /// The K-th of N shards: cases K-1, K-1+N, ...
    #[arg(long, value_name = "K/N", default_value = "1/1")]
    pub shard: String,
    /// Check every case and print count, errors, time and bytes; run nothing
    #[arg(long)]
    pub plan: bool,
}

/// Parts to merge.
#[derive(Debug, Args)]
pub struct SweepMergeArgs {
    /// The study.
    #[command(flatten)]
    pub sweep: SweepArgs,
    /// Folder of the result [default: results/<name of the study>-sweep]
    #[arg(long, short)]
    pub output: Option<PathBuf>,
}
