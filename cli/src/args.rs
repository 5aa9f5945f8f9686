//! The command line.

mod profile;

use std::path::PathBuf;

use asperity::case::PathPoint;
use asperity_core::quantity::{Length, LineLoad, Pressure, QuantityError};
use clap::{Args, Parser, Subcommand, ValueEnum};

pub use profile::{
    FormArg, PreparingArgs, ProfileCommand, ProfileConvertArgs, ProfileFilterArgs,
    ProfileGenerateArgs, ProfileInfoArgs, ProfilePart, ProfilePlotArgs, ReadingArgs, Wavelengths,
};

/// Mesh efficiency of a gear pair from the measured roughness of its tooth flanks.
#[derive(Debug, Parser)]
#[command(
    name = "asperity",
    version,
    propagate_version = true,
    max_term_width = 100
)]
#[command(
    after_help = "Start with `asperity demo`, then `asperity run demo/case.toml`.\n\
    Exit status: 0 done, 2 bad input, 3 not converged, 4 outside the model, 5 internal fault."
)]
pub struct Cli {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
    /// Options of every command.
    #[command(flatten)]
    pub common: Common,
}

/// Options of every command.
#[derive(Debug, Clone, Args)]
pub struct Common {
    /// Print machine-readable JSON on standard output
    #[arg(long, global = true)]
    pub json: bool,
    /// Print nothing but errors
    #[arg(long, short, global = true)]
    pub quiet: bool,
    /// Number of threads [default: all cores]; the result does not depend on it
    #[arg(long, global = true, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub threads: Option<u16>,
}

/// What to do.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// The main job: from a case file to efficiency, losses and a result folder
    #[command(
        after_help = "Example:\n  asperity run fixtures/cases/e-drive.toml -o results/e-drive"
    )]
    Run(RunArgs),
    /// Draw the page of a result anew: report.html beside its result.json
    #[command(after_help = "Examples:\n  asperity report results/e-drive\n  \
        asperity report results/e-drive/result.json --position 3")]
    Report(ReportArgs),
    /// Compare finishes: several profile sets on one case, with paired differences
    #[command(after_help = "Examples:\n  asperity compare demo/case.toml \\\n    \
        --finish ground=demo/ground_pinion.csv,demo/ground_wheel.csv \\\n    \
        --finish superfinished=demo/superfinished.csv\n\n\
        The first finish is what the others are compared with. One file serves both flanks, mirrored\n\
        for the wheel; two files, separated by a comma, are pinion and wheel.")]
    Compare(CompareArgs),
    /// Make the figures of the 2022 paper, each with its table
    #[command(after_help = "Example:\n  asperity figures -o docs/figures")]
    Figures(FiguresArgs),
    /// Print the completions of a shell, or the man page
    #[command(
        after_help = "Examples:\n  asperity completions bash > /etc/bash_completion.d/asperity\n  \
        asperity completions zsh > ~/.zfunc/_asperity\n  \
        asperity completions man > /usr/local/share/man/man1/asperity.1"
    )]
    Completions {
        /// The shell, or man
        #[arg(value_enum)]
        kind: CompletionKind,
    },
    /// Film thickness, Lambda* and regime along the path of contact, without the rough contact
    Regime(CaseArgs),
    /// The rough contact alone: of a case at one position, or of a bare gap file
    #[command(after_help = "Examples:\n  asperity contact case.toml\n  \
        asperity contact --gap gap.csv --e-star \"115.4 GPa\" --load \"300000 N/m\" -o out.csv")]
    Contact(ContactArgs),
    /// Fluid pressure across the film against its thickness (the paper's Fig. 8)
    Film(FilmArgs),
    /// Look at a profile file
    #[command(subcommand)]
    Profile(ProfileCommand),
    /// Where each equation lives, its source and its test
    Equations(EquationsArgs),
    /// What a message code means and what to do
    Explain {
        /// The code, such as W402; all codes when left out
        code: Option<String>,
    },
    /// Print the JSON schema of the case file
    Schema,
    /// Write a worked case with synthetic profiles into a new folder
    Demo {
        /// The folder to make
        #[arg(default_value = "demo")]
        folder: PathBuf,
    },
}

/// A case and where its result goes.
#[derive(Debug, Args)]
pub struct RunArgs {
    /// Case file, TOML (or JSON with the same keys)
    pub case: PathBuf,
    /// Result folder [default: results/<name of the case>]
    #[arg(long, short)]
    pub output: Option<PathBuf>,
    /// Which reading of the model, whatever the case says
    #[arg(long, value_enum)]
    pub formulation: Option<FormulationArg>,
    /// List every default that was used
    #[arg(long)]
    pub explain_defaults: bool,
    /// Do not write a result folder
    #[arg(long, conflicts_with = "output")]
    pub no_output: bool,
}

/// A result and what to show of it.
#[derive(Debug, Args)]
pub struct ReportArgs {
    /// Result folder, or the result.json in it
    pub result: PathBuf,
    /// Number of the mesh position whose contact is shown [default: the highest pressure]
    #[arg(long)]
    pub position: Option<usize>,
}

/// A case and the finishes to compare on it.
#[derive(Debug, Args)]
pub struct CompareArgs {
    /// Case file; its traces are replaced by those of each finish
    pub case: PathBuf,
    /// A finish and its traces; give at least two
    #[arg(
        long = "finish",
        required = true,
        value_name = "NAME=PINION.csv[,WHEEL.csv]"
    )]
    pub finishes: Vec<FinishArg>,
    /// Offsets along the traces at which the flanks meet
    #[arg(long, default_value_t = 32)]
    pub offsets: usize,
    /// Folder of the comparison [default: results/<name of the case>-compare]
    #[arg(long, short)]
    pub output: Option<PathBuf>,
}

/// A finish as the user names it.
#[derive(Debug, Clone)]
pub struct FinishArg {
    /// Its name.
    pub name: String,
    /// Trace of the pinion.
    pub pinion: PathBuf,
    /// Trace of the wheel, where it has its own.
    pub wheel: Option<PathBuf>,
}

impl std::str::FromStr for FinishArg {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        const FORM: &str = "must be a name and one or two files, as ground=pinion.csv,wheel.csv";
        let (name, files) = text.split_once('=').ok_or(FORM)?;
        let (pinion, wheel) = match files.split_once(',') {
            None => (files, None),
            Some((pinion, wheel)) => (pinion, Some(wheel)),
        };
        if [Some(name), Some(pinion), wheel]
            .into_iter()
            .flatten()
            .any(str::is_empty)
        {
            return Err(FORM);
        }
        Ok(Self {
            name: name.to_owned(),
            pinion: pinion.into(),
            wheel: wheel.map(PathBuf::from),
        })
    }
}

/// What a shell needs to know of the command.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum CompletionKind {
    /// bash
    Bash,
    /// elvish
    Elvish,
    /// fish
    Fish,
    /// PowerShell
    Powershell,
    /// zsh
    Zsh,
    /// The man page, for man itself
    Man,
}

/// Where the figures go.
#[derive(Debug, Args)]
pub struct FiguresArgs {
    /// Case of the figures 7 to 13, run in the paper formulation
    #[arg(default_value = "fixtures/cases/table2.toml")]
    pub case: PathBuf,
    /// Folder of the figures
    #[arg(long, short, default_value = "figures")]
    pub output: PathBuf,
}

/// A case.
#[derive(Debug, Args)]
pub struct CaseArgs {
    /// Case file, TOML (or JSON with the same keys)
    pub case: PathBuf,
    /// Which reading of the model, whatever the case says
    #[arg(long, value_enum)]
    pub formulation: Option<FormulationArg>,
}

/// A case and a place on its path of contact.
#[derive(Debug, Args)]
pub struct FilmArgs {
    /// Case file, TOML (or JSON with the same keys)
    pub case: PathBuf,
    /// Position along the path of contact: A, B, C, D, E, or 0 (A) to 1 (E) [default: C]
    #[arg(long, allow_hyphen_values = true)]
    pub position: Option<PathPoint>,
}

/// Which reading of the model is used.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum FormulationArg {
    /// Dimensionally and physically consistent
    Corrected,
    /// The paper's reading, only its misprints mended
    Paper,
}

/// A rough contact.
#[derive(Debug, Args)]
pub struct ContactArgs {
    /// Case file, TOML (or JSON with the same keys)
    #[arg(required_unless_present = "gap", conflicts_with = "gap")]
    pub case: Option<PathBuf>,
    /// Position along the path of contact: A, B, C, D, E, or 0 (A) to 1 (E) [default: the case's]
    #[arg(long, conflicts_with = "gap", allow_hyphen_values = true)]
    pub position: Option<PathPoint>,
    /// Gap of the undeformed bodies: CSV with columns x and h, units in the header
    #[arg(long, requires = "e_star", requires = "load")]
    pub gap: Option<PathBuf>,
    /// Reduced modulus E*, as "115.4 GPa"
    #[arg(long, value_name = "E*", requires = "gap", allow_hyphen_values = true)]
    pub e_star: Option<Pressure>,
    /// Load per length, as "300000 N/m" (per period when periodic)
    #[arg(long, requires = "gap", allow_hyphen_values = true)]
    pub load: Option<LineLoad>,
    /// The gap repeats itself; otherwise both ends are free
    #[arg(long, requires = "gap")]
    pub periodic: bool,
    /// Pressure at which the surface flows, as "3 GPa"
    #[arg(long, requires = "gap", allow_hyphen_values = true)]
    pub pressure_limit: Option<Pressure>,
    /// Tolerance of the certificate: duality gap, penetration and load error
    #[arg(long, default_value_t = 1e-8, allow_hyphen_values = true)]
    pub tolerance: f64,
    /// Write pressure, gap and displacement per point
    #[arg(long, short)]
    pub output: Option<PathBuf>,
}

/// Which equations to print.
#[derive(Debug, Args)]
pub struct EquationsArgs {
    /// Tag of one equation, such as P7
    pub tag: Option<String>,
    /// Print the page docs/EQUATIONS.md
    #[arg(long, conflicts_with = "tag")]
    pub markdown: bool,
}

/// Reads a choice by its name in the case file.
fn choice<T: serde::de::DeserializeOwned>(text: &str) -> Result<T, serde::de::value::Error> {
    use serde::de::IntoDeserializer;
    T::deserialize(text.into_deserializer())
}

/// Reads a cut-off; `none` is a cut-off of zero.
fn cutoff(text: &str) -> Result<Length, QuantityError> {
    if text.trim() == "none" {
        return Ok(Length::from_si(0.0));
    }
    text.parse()
}

/// The name of a choice in the case file.
pub fn name_of<T: serde::Serialize>(choice: &T) -> String {
    match serde_json::to_value(choice) {
        Ok(serde_json::Value::String(name)) => name,
        Ok(other) => other.to_string(),
        Err(_) => String::new(),
    }
}
