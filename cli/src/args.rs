//! The command line.

mod ehl;
mod finish;
mod from_rexs;
mod oil;
mod profile;
mod set;
mod study;
mod sweep;
mod values;
mod work;

use std::path::PathBuf;

use asperity::case::PathPoint;
use asperity::formulation::FormulationChoice;
use asperity_core::quantity::Pressure;
use clap::{Args, Parser, Subcommand, ValueEnum};

pub use ehl::EhlArgs;
pub use finish::FinishArg;
pub use from_rexs::{CaseCommand, FromRexsArgs};
pub use oil::{GivenCurves, GivenOil, GivenOilOfCase, NoLimits, Oils};
pub use profile::{
    FormArg, GivenTracePairs, PreparingArgs, ProfileCommand, ProfileConvertArgs, ProfileFilterArgs,
    ProfileGenerateArgs, ProfileInfoArgs, ProfilePart, ProfilePlotArgs, Ratios, ReadingArgs,
    Wavelengths,
};
pub use set::SetArgs;
pub use study::{Given, KeyGroup, StudyArgs, StudyCommand, Subject, Top, command, named};
pub use sweep::{SweepArgs, SweepCommand, SweepMergeArgs, SweepRunArgs};
pub use values::name_of;
pub use work::WorkArgs;

/// Mesh efficiency of a gear pair from the measured roughness of its tooth flanks.
#[derive(Debug, Parser)]
#[command(
    name = "asperity",
    bin_name = "asperity",
    version,
    propagate_version = true,
    max_term_width = 100
)]
#[command(
    after_help = "Start with `asperity demo`, then `asperity run demo/case.toml`.\n\
    Exit status: 0 done, 2 bad input, 3 not converged, 4 outside the model, 5 internal fault."
)]
pub struct Cli {
    /// Command to run.
    #[command(subcommand)]
    pub command: Command,
    /// Options shared by every command.
    #[command(flatten)]
    pub common: Common,
}

/// Options shared by every command.
#[derive(Debug, Clone, Args)]
pub struct Common {
    /// Print machine-readable JSON on standard output
    #[arg(long, global = true)]
    pub json: bool,
    /// Print only errors
    #[arg(long, short, global = true)]
    pub quiet: bool,
    /// Print everything behind the first screen: all tables, explanations and warnings in full
    #[arg(long, global = true)]
    pub notes: bool,
    /// Number of threads [default: all cores]; the result does not depend on it
    #[arg(long, global = true, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub threads: Option<u16>,
}

/// Commands of the program.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Run a case: efficiency, losses and a result folder
    #[command(
        after_help = "Example:\n  asperity run demo/case.toml -o results/e-drive\n  \
        asperity run demo/case.toml --set operation.torque=\"200 N m\" --set model.offsets=4\n  \
        asperity run - < demo/case.toml"
    )]
    Run(RunArgs),
    /// Redraw the page of a result: report.html next to its result.json
    #[command(after_help = "Examples:\n  asperity report results/e-drive\n  \
        asperity report results/e-drive/result.json --position 3")]
    Report(ReportArgs),
    /// Check a case without running it: all errors at once, the defaults, and the time and memory of a run
    #[command(after_help = "Examples:\n  asperity check demo/case.toml\n  \
        asperity check demo/case.toml --set operation.torque=\"200 N m\"")]
    Check(CheckArgs),
    /// Oils: the traction of a film between ball and disc, and the tests that measure it
    #[command(subcommand)]
    Oil(StudyCommand<Oils>),
    /// List the oils, steels or gears of the library, or all numbers of one with certainty and source
    #[command(
        after_help = "Examples:\n  asperity list oils\n  asperity list steels 16MnCr5\n  asperity list gears fzg-c\n\n\
        A case names an oil in lubricant.oil and a steel in material.pinion.steel.\n\
        asperity demo --gears NAME writes a case with the gears.\n\
        Certainty: A read in the source, B quoted by others, C derived, assumed: not known of this one."
    )]
    List(ListArgs),
    /// Ask ten questions, and write a commented case with the answers
    #[command(
        after_help = "Examples:\n  asperity new my-case.toml\n  asperity new - < answers.txt\n\n\
        An empty answer takes the default in brackets; each line of standard input is an answer."
    )]
    New {
        /// Case file to write; - is standard output
        #[arg(default_value = "case.toml")]
        output: PathBuf,
    },
    /// Make a case from the file of another program
    #[command(subcommand)]
    Case(CaseCommand),
    /// Studies of the library
    #[command(flatten)]
    Study(StudyCommand<Top>),
    /// Run many cases: crossed axes and samples of the inputs, in shards
    #[command(subcommand)]
    Sweep(SweepCommand),
    /// Draw the figures of the 2022 paper, each with its table of values
    #[command(after_help = "Example:\n  asperity figures -o docs/figures")]
    Figures(FiguresArgs),
    /// Print the completions for a shell, the man page, or the list of all commands
    #[command(
        after_help = "Examples:\n  asperity completions bash > /etc/bash_completion.d/asperity\n  \
        asperity completions zsh > ~/.zfunc/_asperity\n  \
        asperity completions man > /usr/local/share/man/man1/asperity.1\n  \
        asperity completions markdown > commands.md"
    )]
    Completions {
        /// The shell, man, or markdown
        #[arg(value_enum)]
        kind: CompletionKind,
    },
    /// Geometry, stiffness, transmission error, and the loss factor of every load distribution law
    Gear(CaseArgs),
    /// Only the rough contact of a case at one position, without oil
    #[command(after_help = "Examples:\n  asperity contact case.toml\n  \
        asperity contact case.toml --position B -o points.csv --stress stress.csv")]
    Contact(ContactArgs),
    /// Mixed elastohydrodynamic contact: film, pressure, and the load carried below a given film thickness
    #[command(after_help = "Examples:\n  asperity ehl case.toml --position A\n  \
        asperity ehl case.toml --compare --half-widths 10 --json\n\n\
        With --smooth, the steady film of smooth flanks is solved. In this model the ridges run across\n\
        the whole face width and oil cannot leak round them: where the roughness that remains in the contact\n\
        exceeds three smooth films, trust measurements instead.")]
    Ehl(EhlArgs),
    /// Variation of fluid pressure across the film, against film thickness (the paper's Fig. 8)
    Film(FilmArgs),
    /// Inspect, plot, filter, convert, generate or compare profile files
    #[command(subcommand)]
    Profile(ProfileCommand),
    /// List the equations: the file, the source and the test of each
    Equations(EquationsArgs),
    /// Explain a message code, and what to do about it
    Explain {
        /// The code, e.g. W402 [default: all codes]
        code: Option<String>,
        /// Print all as a page of Markdown: every code with its cause and remedy
        #[arg(long, conflicts_with_all = ["code", "json"])]
        markdown: bool,
    },
    /// Print the JSON schema of the case file, or of the settings of the studies
    Schema {
        /// Print the schema of the settings instead: an object for each study by the name of its function in Python
        #[arg(long, conflicts_with = "markdown")]
        settings: bool,
        /// Print the page docs/CASE_FILE.md instead: every key with its unit, default and meaning
        #[arg(long, conflicts_with = "json")]
        markdown: bool,
    },
    /// Write a worked case with synthetic profiles into a new folder
    #[command(
        after_help = "Examples:\n  asperity demo\n  asperity demo --gears fzg-c my-first-case"
    )]
    Demo {
        /// Folder to create [default: demo; with --paper: table2; with --gears: the name of the gears]
        folder: Option<PathBuf>,
        /// Write Table 2 of the 2022 paper on a synthetic damaged flank instead
        #[arg(long)]
        paper: bool,
        /// Write a case with these gears of the library instead; asperity list gears lists them
        #[arg(long, value_name = "NAME", conflicts_with = "paper")]
        gears: Option<String>,
    },
}

/// A list of the library, or one of its entries.
#[derive(Debug, Args)]
pub struct ListArgs {
    /// What to list
    #[arg(value_enum)]
    pub kind: ListKind,
    /// Name of one of them, to show all its numbers [default: a table of all]
    pub name: Option<String>,
}

/// Lists of the library.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum ListKind {
    /// Oils
    Oils,
    /// Steels
    Steels,
    /// Gears
    Gears,
}

/// A case to check.
#[derive(Debug, Args)]
pub struct CheckArgs {
    /// Case file, TOML (or JSON with the same keys); - reads standard input
    pub case: PathBuf,
    /// Keys of the case set on the command line.
    #[command(flatten)]
    pub set: SetArgs,
    /// List all defaults used
    #[arg(long)]
    pub explain_defaults: bool,
}

/// Case, and target of its result.
#[derive(Debug, Args)]
pub struct RunArgs {
    /// Case file, TOML (or JSON with the same keys); - reads standard input
    pub case: PathBuf,
    /// Keys of the case set on the command line.
    #[command(flatten)]
    pub set: SetArgs,
    /// Print the sources of the equations used as BibTeX
    #[arg(long, conflicts_with = "json")]
    pub cite: bool,
    /// Result folder [default: results/<name of the case>, and results/demo-case for demo/case.toml; refused if it holds
    /// the result of a case with another title]
    #[arg(long, short)]
    pub output: Option<PathBuf>,
    /// Formulation of the model, overriding the case
    #[arg(long)]
    pub formulation: Option<FormulationChoice>,
    /// List all defaults used
    #[arg(long)]
    pub explain_defaults: bool,
    /// Write all points of the load map into the result folder, as map.csv
    #[arg(long, conflicts_with = "no_output")]
    pub load_map: bool,
    /// Also print the published friction laws, each instead of the model
    #[arg(long)]
    pub laws: bool,
    /// Also print the loss over the boundary share that is drawn, and by other models with the evidence against them
    #[arg(long)]
    pub models: bool,
    /// Also find the ridges of the traces that cost most, for the report; takes about six times the time of the contacts
    #[arg(long)]
    pub ridges: bool,
    /// Omit the uncertainty of the loss, which takes some 60 evaluations of the laws with the contacts of the run
    #[arg(long)]
    pub no_band: bool,
    /// Do not write a result folder
    #[arg(long, conflicts_with = "output")]
    pub no_output: bool,
    /// Write the fields along the contact of these positions as tables: all, or numbers, e.g. 1,5
    /// [default: only thinned fields of the position with the highest pressure, in the page]
    #[arg(long, value_name = "all|N,N", conflicts_with = "no_output")]
    pub fields: Option<String>,
    /// Limits of time and memory.
    #[command(flatten)]
    pub work: WorkArgs,
}

/// Result, and position to show.
#[derive(Debug, Args)]
pub struct ReportArgs {
    /// Result folder, or the result.json in it
    pub result: PathBuf,
    /// Number of the mesh position whose contact is shown [default: the one with the highest pressure]
    #[arg(long)]
    pub position: Option<usize>,
}

/// Shell whose completions are printed.
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
    /// man page
    Man,
    /// all commands as Markdown
    Markdown,
}

/// Case of the figures and their folder.
#[derive(Debug, Args)]
pub struct FiguresArgs {
    /// Case of figures 7 to 13, run in the paper formulation; - reads standard input [default: Table 2
    /// of the paper on a synthetic damaged flank]
    pub case: Option<PathBuf>,
    /// Keys of the case set on the command line.
    #[command(flatten)]
    pub set: SetArgs,
    /// Folder of the figures
    #[arg(long, short, default_value = "figures")]
    pub output: PathBuf,
}

/// A case.
#[derive(Debug, Args)]
pub struct CaseArgs {
    /// Case file, TOML (or JSON with the same keys); - reads standard input
    pub case: PathBuf,
    /// Keys of the case set on the command line.
    #[command(flatten)]
    pub set: SetArgs,
    /// Formulation of the model, overriding the case
    #[arg(long)]
    pub formulation: Option<FormulationChoice>,
}

/// Case, and position on its path of contact.
#[derive(Debug, Args)]
pub struct FilmArgs {
    /// Case file, TOML (or JSON with the same keys); - reads standard input
    pub case: PathBuf,
    /// Keys of the case set on the command line.
    #[command(flatten)]
    pub set: SetArgs,
    /// Position along the path of contact: A, B, C, D, E, or 0 (A) to 1 (E) [default: C]
    #[arg(long, allow_hyphen_values = true)]
    pub position: Option<PathPoint>,
}

/// Case, and position of its rough contact.
#[derive(Debug, Args)]
pub struct ContactArgs {
    /// Case file, TOML (or JSON with the same keys); - reads standard input
    pub case: PathBuf,
    /// Keys of the case set on the command line.
    #[command(flatten)]
    pub set: SetArgs,
    /// Position along the path of contact: A, B, C, D, E, or 0 (A) to 1 (E) [default: the case's]
    #[arg(long, allow_hyphen_values = true)]
    pub position: Option<PathPoint>,
    /// Write the subsurface stress at every point, and print its largest values
    #[arg(long, value_name = "FILE")]
    pub stress: Option<PathBuf>,
    /// Friction coefficient of full sliding, whose traction is included in the stress
    #[arg(
        long,
        requires = "stress",
        default_value_t = 0.0,
        allow_hyphen_values = true
    )]
    pub friction: f64,
    /// Poisson's ratio, for the stress
    #[arg(
        long,
        requires = "stress",
        default_value_t = 0.3,
        allow_hyphen_values = true
    )]
    pub poisson: f64,
    /// Elastic limit, to report the zone in which the stress exceeds it
    #[arg(long, requires = "stress", allow_hyphen_values = true)]
    pub elastic_limit: Option<Pressure>,
    /// Tolerance of the certificate: duality gap, penetration and load error; at most 1e-4
    #[arg(long, default_value_t = 1e-8, allow_hyphen_values = true)]
    pub tolerance: f64,
    /// Write pressure, gap and displacement at every point
    #[arg(long, short)]
    pub output: Option<PathBuf>,
}

/// Equations to print.
#[derive(Debug, Args)]
pub struct EquationsArgs {
    /// Tag of one equation, e.g. P7
    pub tag: Option<String>,
    /// Print all as a page of Markdown: with formulas, tests, sources and misprints
    #[arg(long, conflicts_with = "tag")]
    pub markdown: bool,
}
