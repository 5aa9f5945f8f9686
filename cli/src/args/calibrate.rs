//! Options of `asperity calibrate`.

use std::path::PathBuf;

use asperity_calibration::DesignSettings;
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
    /// Choose the points to measure: those within the limits below with the best information on the parameters
    #[arg(long)]
    pub design: bool,
    /// Settings of a design; a calibration uses its settings of the rig.
    #[command(flatten)]
    pub settings: DesignSettings,
    /// Folder of the result [default: results/<name of the table>-calibration, or results/<name of the
    /// case>-design]
    #[arg(long, short)]
    pub output: Option<PathBuf>,
}
