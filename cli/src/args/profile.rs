//! Arguments of `asperity profile`.

use std::path::PathBuf;

use asperity_core::quantity::Length;
use asperity_profile_io::read::{
    Abscissa, Columns, DecimalSign, Encoding, Gaps, LengthUnit, Separator, TraceLine, TraceRange,
    Uneven,
};
use asperity_roughness::gaussian_filter::Ends;
use asperity_roughness::generate::Method;
use clap::{Args, Subcommand, ValueEnum};

use super::study::{KeyGroup, StudyCommand};
use super::values::{choice, cutoff};

/// Commands on profiles.
#[derive(Debug, Subcommand)]
pub enum ProfileCommand {
    /// Format, units, spacing, and roughness parameters of profile files
    #[command(
        after_help = "Examples:\n  asperity profile info flank.csv --lambda-c 0.25mm\n  \
            asperity profile info --as-is --sections 5 filtered.x3p\n  \
            asperity profile info --form involute --base-radius 50mm --roll-length 15mm flank.csv"
    )]
    Info(ProfileInfoArgs),
    /// Plot profile, filtered profile, material ratio curve with its Rk construction, and spectrum as SVG
    Plot(ProfilePlotArgs),
    /// Convert any readable format to CSV, X3P or SMD, without loss of digits
    #[command(after_help = "Example:\n  asperity profile convert flank.x3p flank.csv")]
    Convert(ProfileConvertArgs),
    /// Remove form and waviness, and write the roughness profile
    Filter(ProfileFilterArgs),
    /// Generate a synthetic profile, self-affine or like measured ones, and report the parameters achieved
    #[command(
        after_help = "Examples:\n  asperity profile generate -o rough.csv --rq \"0.4 um\" --seed 2\n  \
        asperity profile generate --like tooth1.csv --like tooth2.csv --seed 3 -o another.csv\n  \
        asperity profile generate --like flank.sur --seed 3 -o another.x3p"
    )]
    Generate(ProfileGenerateArgs),
    /// Compare the parameters of several profiles, relative to the first
    Compare(ProfileInfoArgs),
    /// Studies of profiles
    #[command(flatten)]
    Study(StudyCommand<Profiles>),
}

/// `asperity profile`
#[derive(Debug)]
pub struct Profiles;

impl KeyGroup for Profiles {
    const NAME: &'static str = "profile ";
}

/// Traces before and after a test.
#[derive(Debug, Args)]
pub struct GivenTracePairs {
    /// Trace before the test
    pub before: PathBuf,
    /// Trace of the same place after it
    pub after: PathBuf,
    /// Further pairs, each a trace before and a trace after
    #[arg(value_name = "BEFORE AFTER")]
    pub more: Vec<PathBuf>,
    /// Case of the gears, whose loss before and after the test is then compared
    #[arg(long, value_name = "CASE.toml")]
    pub case: Option<PathBuf>,
    /// Base radius of the gear, for files against roll length, e.g. "50 mm"
    #[arg(long, value_name = "R_B", allow_hyphen_values = true)]
    pub base_radius: Option<Length>,
    /// Reading of the files.
    #[command(flatten)]
    pub reading: ReadingArgs,
}

/// A profile and its plot.
#[derive(Debug, Args)]
pub struct ProfilePlotArgs {
    /// Profile file, or - for standard input
    pub file: PathBuf,
    /// SVG file to write [default: the name of the profile with .svg, unless such a file exists]
    #[arg(long, short)]
    pub output: Option<PathBuf>,
    /// Preparation of the profile.
    #[command(flatten)]
    pub preparing: PreparingArgs,
    /// Reading of the file.
    #[command(flatten)]
    pub reading: ReadingArgs,
}

/// A profile and the format to convert it to.
#[derive(Debug, Args)]
pub struct ProfileConvertArgs {
    /// Profile file, or - for standard input
    pub file: PathBuf,
    /// File to write; its extension (csv, x3p, smd) chooses the format
    pub output: PathBuf,
    /// Resample linearly to this spacing
    #[arg(long, value_name = "DX", allow_hyphen_values = true)]
    pub resample: Option<Length>,
    /// Replace spikes of up to six points farther than K robust deviations from the running median
    #[arg(long, value_name = "K", allow_hyphen_values = true)]
    pub outliers: Option<f64>,
    /// Base radius of the gear, for files against roll length, e.g. "50 mm"
    #[arg(long, value_name = "R_B", allow_hyphen_values = true)]
    pub base_radius: Option<Length>,
    /// Reading of the file.
    #[command(flatten)]
    pub reading: ReadingArgs,
}

/// A profile and the part of it to write.
#[derive(Debug, Args)]
pub struct ProfileFilterArgs {
    /// Profile file, or - for standard input
    pub file: PathBuf,
    /// File to write; its extension (csv, x3p, smd) chooses the format
    pub output: PathBuf,
    /// Profile to write
    #[arg(long, value_enum, default_value = "roughness")]
    pub part: ProfilePart,
    /// Preparation of the profile.
    #[command(flatten)]
    pub preparing: PreparingArgs,
    /// Reading of the file.
    #[command(flatten)]
    pub reading: ReadingArgs,
}

/// Parts into which the filters split a trace.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum ProfilePart {
    /// R: P without the waves longer than lambda_c
    Roughness,
    /// W: the waves of P longer than lambda_c
    Waviness,
    /// P: the trace without form and without the waves shorter than lambda_s
    Primary,
}

/// A synthetic profile and its file.
#[derive(Debug, Args)]
pub struct ProfileGenerateArgs {
    /// Trace or surface to make another like; may be repeated for several of one finish [default: a self-affine profile
    /// from the options below]
    #[arg(long, value_name = "FILE", conflicts_with_all = ["points", "spacing", "rq", "hurst", "roll_off", "short_cut"])]
    pub like: Vec<PathBuf>,
    /// Method of --like: pieces of the traces or surfaces, or spectrum, their spectrum and heights with random phases [default:
    /// pieces, or spectrum where heights, slopes and curvatures are Gaussian]
    #[arg(long, value_name = "METHOD", value_parser = choice::<Method>, requires = "like")]
    pub method: Option<Method>,
    /// Trace of the place of each --like after a test, in the same order, of several stages one stage after the other; flanks are
    /// made of pieces of all
    #[arg(
        long,
        value_name = "FILE",
        requires = "like",
        conflicts_with = "method"
    )]
    pub after: Vec<PathBuf>,
    /// State of the flank from before the test, 0, to after it, 1 [default: 1]
    #[arg(long, requires = "after", allow_hyphen_values = true)]
    pub state: Option<f64>,
    /// Engagements of a tooth at each stage of the test: "1e4,1e6"
    #[arg(
        long,
        value_name = "NUMBERS",
        value_delimiter = ',',
        requires = "after",
        conflicts_with = "state"
    )]
    pub stages: Vec<f64>,
    /// Engagements of a tooth after which the flank is made, instead of --state [default: at the last stage]
    #[arg(long, value_name = "NUMBER", requires = "stages")]
    pub engagements: Option<f64>,
    /// File to write; its extension (csv, x3p, smd) chooses the format
    #[arg(long, short)]
    pub output: PathBuf,
    /// Number of points
    #[arg(long, default_value_t = 11_201)]
    pub points: usize,
    /// Spacing
    #[arg(long, default_value = "0.5 um", allow_hyphen_values = true)]
    pub spacing: Length,
    /// Root mean square height
    #[arg(long, default_value = "0.3 um", allow_hyphen_values = true)]
    pub rq: Length,
    /// Hurst exponent
    #[arg(long, default_value_t = 0.8, allow_hyphen_values = true)]
    pub hurst: f64,
    /// Wavelength above which the spectrum is flat
    #[arg(long, default_value = "100 um", allow_hyphen_values = true)]
    pub roll_off: Length,
    /// Wavelength below which the spectrum is zero
    #[arg(long, default_value = "5 um", allow_hyphen_values = true)]
    pub short_cut: Length,
    /// Seed
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
    /// Reading of the traces of --like.
    #[command(flatten)]
    pub reading: ReadingArgs,
}

/// Profiles, with options for reading and preparation.
#[derive(Debug, Args)]
pub struct ProfileInfoArgs {
    /// Profile files; - is standard input
    #[arg(required = true)]
    pub files: Vec<PathBuf>,
    /// Wavelengths of the Hurst fit, e.g. 200um:8um [default: lambda_c/3 to 5 lambda_s]
    #[arg(long, value_name = "LONG:SHORT")]
    pub hurst: Option<Wavelengths>,
    /// Material ratio Rmr(c) at this height over the mean line, e.g. 0.2um; may be repeated
    #[arg(long, value_name = "C", allow_hyphen_values = true)]
    pub rmr: Vec<Length>,
    /// Height Rdc between two material ratios in percent, e.g. 5:75; may be repeated
    #[arg(long, value_name = "P:Q")]
    pub rdc: Vec<Ratios>,
    /// With --json: also print spectrum, autocorrelation and material ratio curve, point by point
    #[arg(long)]
    pub curves: bool,
    /// Preparation of the profiles.
    #[command(flatten)]
    pub preparing: PreparingArgs,
    /// Reading of the files.
    #[command(flatten)]
    pub reading: ReadingArgs,
}

/// Form to remove from a trace.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum FormArg {
    /// Nothing, not even the mean height
    None,
    /// The mean height
    Mean,
    /// The least-squares line (also: line)
    #[value(alias = "line")]
    Level,
    /// The least-squares parabola (also: parabola)
    #[value(alias = "parabola")]
    Poly2,
    /// The least-squares circle
    Circle,
    /// The involute of the flank, and the line left by misalignment; needs --base-radius and
    /// --roll-length
    Involute,
}

/// Wavelengths of a fit, from long to short.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wavelengths {
    /// Longest.
    pub longest: Length,
    /// Shortest.
    pub shortest: Length,
}

impl std::str::FromStr for Wavelengths {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        const FORM: &str = "must be two wavelengths, the longer first, e.g. 200um:8um";
        let (longest, shortest) = text.split_once(':').ok_or(FORM)?;
        let read = |part: &str| part.parse::<Length>().map_err(|error| error.to_string());
        let (longest, shortest) = (read(longest)?, read(shortest)?);
        if longest > shortest && shortest.si() > 0.0 {
            Ok(Self { longest, shortest })
        } else {
            Err(FORM.to_owned())
        }
    }
}

/// Two material ratios in percent, the smaller first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ratios {
    /// Ratio at the higher level.
    pub upper: f64,
    /// Ratio at the lower level.
    pub lower: f64,
}

impl std::str::FromStr for Ratios {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        const FORM: &str = "must be two ratios in percent, the smaller first, e.g. 5:75";
        let (upper, lower) = text.split_once(':').ok_or(FORM)?;
        let read = |part: &str| part.trim().trim_end_matches('%').trim().parse::<f64>();
        let (upper, lower) = (
            read(upper).map_err(|_| FORM)?,
            read(lower).map_err(|_| FORM)?,
        );
        if 0.0 <= upper && upper < lower && lower <= 100.0 {
            Ok(Self { upper, lower })
        } else {
            Err(FORM.to_owned())
        }
    }
}

/// Form removal, filters and sections.
#[derive(Debug, Clone, Args)]
#[command(next_help_heading = "Preparing the profile")]
pub struct PreparingArgs {
    /// Use the heights unchanged: no form removal, and no filter unless its option is given
    #[arg(long, conflicts_with_all = ["level", "form"])]
    pub as_is: bool,
    /// Remove a straight line, with no filter unless its option is given
    #[arg(long, conflicts_with = "form")]
    pub level: bool,
    /// Form to remove [default: level]
    #[arg(long, value_enum, value_name = "FORM")]
    pub form: Option<FormArg>,
    /// Base radius of the gear, for --form involute and for files against roll length, e.g. "50 mm"
    #[arg(long, value_name = "R_B", allow_hyphen_values = true)]
    pub base_radius: Option<Length>,
    /// Roll length (radius of curvature) at the middle of the trace, for --form involute: at radius r
    /// on the flank it is √(r² − r_b²)
    #[arg(long, value_name = "RHO", allow_hyphen_values = true)]
    pub roll_length: Option<Length>,
    /// The trace runs from tip to root, for --form involute
    #[arg(long)]
    pub towards_root: bool,
    /// Cut-off lambda_c, or none [default: as the file states, else 0.25 mm as in a case, usual on gear
    /// flanks; ISO 4288 and ISO 21920-3 use 0.8 mm for Ra from 0.1 to 2 um]
    #[arg(long, value_parser = cutoff, allow_hyphen_values = true)]
    pub lambda_c: Option<Length>,
    /// Cut-off lambda_s, or none [default: as the file states, else 2.5 um]
    #[arg(long, value_parser = cutoff, allow_hyphen_values = true)]
    pub lambda_s: Option<Length>,
    /// Treatment of the ends in filtering: cut, reg0, reg1, reflect
    #[arg(long, value_parser = choice::<Ends>)]
    pub ends: Option<Ends>,
    /// Use the robust Gaussian filter for lambda_c, for damaged flanks
    #[arg(long)]
    pub robust: bool,
    /// Replace spikes of up to six points farther than K robust deviations from the running median
    #[arg(long, value_name = "K", allow_hyphen_values = true)]
    pub outliers: Option<f64>,
    /// Number of sections [default: whole cut-offs in the evaluation length; five without a filter]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub sections: Option<u16>,
}

/// Statements about a file; an option overrides what was detected.
#[derive(Debug, Clone, Args)]
#[command(next_help_heading = "Reading the file")]
pub struct ReadingArgs {
    /// Unit of the positions: um, mm, nm, m, angstrom, inch, mil, uin
    #[arg(long)]
    pub x_unit: Option<LengthUnit>,
    /// Unit of the heights: um, mm, nm, m, angstrom, inch, mil, uin
    #[arg(long)]
    pub z_unit: Option<LengthUnit>,
    /// Spacing of the points, e.g. "0.5 um"
    #[arg(long, allow_hyphen_values = true)]
    pub dx: Option<Length>,
    /// Spacing of the rows of a surface, e.g. "10 um"
    #[arg(long, allow_hyphen_values = true)]
    pub dy: Option<Length>,
    /// Columns of position and height, counted from 1: "1,2", or only the height: "2"
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
    /// Number of the profile in a file that holds several, counted from 1
    #[arg(long)]
    pub row: Option<usize>,
    /// Trace taken from a surface: row, column, mean (of all rows), mean-column; --row is its number
    #[arg(long)]
    pub line: Option<TraceLine>,
    /// Meaning of the positions: distance, roll-length, roll-degrees, roll-radians [default: as stated
    /// in the header, else distance]
    #[arg(long)]
    pub abscissa: Option<Abscissa>,
    /// Unevenly spaced positions: refuse or resample
    #[arg(long)]
    pub uneven: Option<Uneven>,
    /// Part of the trace that is used, by distances from its first point: "1.2mm..6.4mm"
    #[arg(long)]
    pub range: Option<TraceRange>,
    /// Turn the values, which grow into the material, into heights; false keeps those that the file names depths
    #[arg(long, num_args = 0..=1, require_equals = true, default_missing_value = "true", value_name = "BOOL")]
    pub invert: Option<bool>,
}
