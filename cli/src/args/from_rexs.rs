//! Arguments of `asperity case`.

use std::path::PathBuf;

use clap::{Args, Subcommand};

/// `asperity case`
#[derive(Debug, Subcommand)]
pub enum CaseCommand {
    /// List the stages of a REXS gearbox file, or write the case of one or of all
    #[command(after_help = "Examples:\n  asperity case from-rexs gearbox.rexs\n  \
        asperity case from-rexs gearbox.rexs --stage 2 --pinion pinion.csv --wheel wheel.csv -o case.toml\n  \
        asperity case from-rexs gearbox.rexs --all -o gearbox.toml\n\n\
        REXS 1.0 to 2.0 as .rexs, .rexsj or zip. Stages count from 1 in the order of the file; a planetary set\n\
        counts as one. A comment next to every number in the case names its attribute.")]
    FromRexs(FromRexsArgs),
}

/// `asperity case from-rexs`
#[derive(Debug, Args)]
pub struct FromRexsArgs {
    /// The REXS file
    pub file: PathBuf,
    /// Number of the stage to write a case for [default with -o: 1]
    #[arg(long, value_name = "N")]
    pub stage: Option<usize>,
    /// Write one case of all stages, with their shafts
    #[arg(long, conflicts_with = "stage")]
    pub all: bool,
    /// Number of the load case to take the operating point from, in the order of the file
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub load_case: usize,
    /// Trace of the flank of the pinion or sun
    #[arg(long, value_name = "FILE")]
    pub pinion: Option<PathBuf>,
    /// Trace of the flank of the wheel or planet
    #[arg(long, value_name = "FILE")]
    pub wheel: Option<PathBuf>,
    /// Case file to write [default: standard output]
    #[arg(long, short)]
    pub output: Option<PathBuf>,
}
