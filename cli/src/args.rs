//! The command line.

use std::path::PathBuf;

use asperity::case::PathPoint;
use asperity_core::quantity::{Length, LineLoad, Pressure, QuantityError};
use asperity_roughness::form::Form;
use asperity_roughness::gaussian_filter::Ends;
use asperity_roughness::read::{Columns, DecimalSign, Encoding, Gaps, LengthUnit, Separator};
use clap::{Args, Parser, Subcommand, ValueEnum};

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

/// What to do with a profile.
#[derive(Debug, Subcommand)]
pub enum ProfileCommand {
    /// Format, units, spacing, and roughness parameters of profile files
    Info(ProfileInfoArgs),
    /// Profile, filtered profile, material ratio curve with its Rk construction, and spectrum as SVG
    Plot(ProfilePlotArgs),
    /// Any readable format to CSV, X3P or SMD, heights to the last bit
    #[command(after_help = "Example:\n  asperity profile convert flank.x3p flank.csv")]
    Convert(ProfileConvertArgs),
    /// Form and waviness off, the roughness profile into a file
    Filter(ProfileFilterArgs),
    /// A synthetic profile from a recipe, with what it achieved
    Generate(ProfileGenerateArgs),
    /// The parameters of several profiles beside each other, relative to the first
    Compare(ProfileInfoArgs),
}

/// One profile and its picture.
#[derive(Debug, Args)]
pub struct ProfilePlotArgs {
    /// Profile file
    pub file: PathBuf,
    /// SVG file to write [default: the name of the profile with .svg]
    #[arg(long, short)]
    pub output: Option<PathBuf>,
    /// How it is prepared.
    #[command(flatten)]
    pub preparing: PreparingArgs,
    /// How it is read.
    #[command(flatten)]
    pub reading: ReadingArgs,
}

/// One profile into another format.
#[derive(Debug, Args)]
pub struct ProfileConvertArgs {
    /// Profile file
    pub file: PathBuf,
    /// File to write; its extension (csv, x3p, smd) chooses the format
    pub output: PathBuf,
    /// Resample linearly to this spacing
    #[arg(long, value_name = "DX")]
    pub resample: Option<Length>,
    /// Replace spikes of up to six points farther than K robust deviations from the running median
    #[arg(long, value_name = "K")]
    pub outliers: Option<f64>,
    /// How it is read.
    #[command(flatten)]
    pub reading: ReadingArgs,
}

/// One profile through form removal and filters.
#[derive(Debug, Args)]
pub struct ProfileFilterArgs {
    /// Profile file
    pub file: PathBuf,
    /// File to write; its extension (csv, x3p, smd) chooses the format
    pub output: PathBuf,
    /// Which profile is written
    #[arg(long, value_enum, default_value = "roughness")]
    pub part: ProfilePart,
    /// How it is prepared.
    #[command(flatten)]
    pub preparing: PreparingArgs,
    /// How it is read.
    #[command(flatten)]
    pub reading: ReadingArgs,
}

/// Into what the filters part a trace.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum ProfilePart {
    /// R: what lambda_c leaves of P
    Roughness,
    /// W: what lambda_c takes off P
    Waviness,
    /// P: without form and without waves below lambda_s
    Primary,
}

/// A recipe and where its profile goes.
#[derive(Debug, Args)]
pub struct ProfileGenerateArgs {
    /// Recipe, JSON; without it a self-affine profile from the options below
    #[arg(long)]
    pub recipe: Option<PathBuf>,
    /// File to write; its extension (csv, x3p, smd) chooses the format
    #[arg(long, short)]
    pub output: PathBuf,
    /// Number of points
    #[arg(long, default_value_t = 11_201)]
    pub points: usize,
    /// Spacing
    #[arg(long, default_value = "0.5 um")]
    pub spacing: Length,
    /// Root mean square height
    #[arg(long, default_value = "0.3 um")]
    pub rq: Length,
    /// Hurst exponent
    #[arg(long, default_value_t = 0.8)]
    pub hurst: f64,
    /// Wavelength above which the spectrum is flat
    #[arg(long, default_value = "100 um")]
    pub roll_off: Length,
    /// Wavelength below which there is nothing
    #[arg(long, default_value = "5 um")]
    pub short_cut: Length,
    /// Seed
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
}

/// Profiles and how to read and prepare them.
#[derive(Debug, Args)]
pub struct ProfileInfoArgs {
    /// Profile files
    #[arg(required = true)]
    pub files: Vec<PathBuf>,
    /// How they are prepared.
    #[command(flatten)]
    pub preparing: PreparingArgs,
    /// How the file is read.
    #[command(flatten)]
    pub reading: ReadingArgs,
}

/// Form removal, filters and sections.
#[derive(Debug, Clone, Args)]
#[command(next_help_heading = "Preparing the profile")]
pub struct PreparingArgs {
    /// Take the heights as they are: no form removal, no filter
    #[arg(long)]
    pub as_is: bool,
    /// Remove a straight line only, no filter
    #[arg(long, conflicts_with = "as_is")]
    pub level: bool,
    /// Form removed: none, level, poly2
    #[arg(long, value_parser = choice::<Form>)]
    pub form: Option<Form>,
    /// Cut-off lambda_c, or none [default: 0.8 mm]
    #[arg(long, value_parser = cutoff, allow_hyphen_values = true)]
    pub lambda_c: Option<Length>,
    /// Cut-off lambda_s, or none [default: 2.5 um]
    #[arg(long, value_parser = cutoff, allow_hyphen_values = true)]
    pub lambda_s: Option<Length>,
    /// What the filter does at the ends: cut, reg0, reg1, reflect
    #[arg(long, value_parser = choice::<Ends>)]
    pub ends: Option<Ends>,
    /// Use the robust Gaussian filter for lambda_c, for damaged flanks
    #[arg(long)]
    pub robust: bool,
    /// Number of sections [default: whole cut-offs in the evaluation length; five without filter]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub sections: Option<u16>,
}

/// What the file does not say; an option wins over what the file seems to say.
#[derive(Debug, Clone, Args)]
#[command(next_help_heading = "Reading the file")]
pub struct ReadingArgs {
    /// Unit of the positions: um, mm, nm, m
    #[arg(long)]
    pub x_unit: Option<LengthUnit>,
    /// Unit of the heights: um, mm, nm, m
    #[arg(long)]
    pub z_unit: Option<LengthUnit>,
    /// Spacing of the points, as "0.5 um"
    #[arg(long, allow_hyphen_values = true)]
    pub dx: Option<Length>,
    /// Columns of position and height, counted from 1: "1,2", or the height alone: "2"
    #[arg(long)]
    pub columns: Option<Columns>,
    /// Decimal sign: point or comma
    #[arg(long)]
    pub decimal: Option<DecimalSign>,
    /// Column separator: comma, semicolon, tab, blank, none
    #[arg(long)]
    pub separator: Option<Separator>,
    /// Text encoding: utf-8, utf-16le, utf-16be, windows-1252
    #[arg(long)]
    pub encoding: Option<Encoding>,
    /// Missing points: refuse or interpolate
    #[arg(long)]
    pub gaps: Option<Gaps>,
    /// Which profile of a file that holds several, from 1
    #[arg(long)]
    pub row: Option<usize>,
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
