//! Arguments of `asperity sweep`.

use std::path::PathBuf;

use clap::{Args, Subcommand};

/// Runs of many cases.
#[derive(Debug, Subcommand)]
pub enum SweepCommand {
    /// Run a study, or a shard of it; finished parts are stored and not run again
    #[command(after_help = "Examples:\n  asperity sweep run study.toml\n  \
        asperity sweep run study.toml --plan\n  \
        asperity sweep run study.toml --shard 3/64 --parts /scratch/parts\n  \
        asperity sweep run study.toml --status")]
    Run(SweepRunArgs),
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
    /// Print the completed, missing and failed cases of all shards; run nothing; exit status 3 while cases are missing
    #[arg(long, conflicts_with_all = ["plan", "shard"])]
    pub status: bool,
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
