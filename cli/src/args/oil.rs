//! Arguments of `asperity oil`.

use std::path::PathBuf;

use asperity_core::quantity::{Force, Length, Ratio, Speed, Time};
use clap::{Args, Subcommand, ValueEnum};

use super::SetArgs;

/// `asperity oil`
#[derive(Debug, Subcommand)]
pub enum OilCommand {
    /// List the oils of the library, any of which a case can name in lubricant.oil
    List,
    /// Show an oil of the library, each number with its certainty and source
    #[command(after_help = "Example:\n  asperity oil show m100")]
    Show {
        /// Name of the oil
        name: String,
    },
    /// Traction of the film between ball and disc, over slide-to-roll ratio and speed
    #[command(after_help = "Examples:\n  asperity oil traction m100\n  \
        asperity oil traction case.toml --load \"20 N\" --speed \"1 m/s\" --temperature 40,80,120\n\n\
        Predicted where the film is at least three times as thick as the roughness. The specimens are of\n\
        through-hardened steel (21 W/(m K)). The tables have the columns of a measured traction curve.")]
    Traction(OilTractionArgs),
    /// Constants of an oil from measured traction curves of ball and disc, with their bands
    #[command(after_help = "Examples:\n  asperity oil fit curves.csv --oil m100\n  \
        asperity oil fit mtm.txt --oil case.toml --temperature-column pot -o results/my-oil\n\n\
        A table has the columns load_n, mean_speed_m_s, slide_roll_percent (200 is pure sliding),\n\
        temperature_c and traction, and where known sigma, group, set_temperature_c, film_nm and the\n\
        specimens; a text export of a PCS machine is read as it is. oil.toml in the result is the oil\n\
        file that a case names by lubricant.oil_file.")]
    Fit(OilFitArgs),
    /// Traction measurements that would determine the constants of an oil, with the errors they would leave
    #[command(after_help = "Examples:\n  asperity oil plan --oil m100\n  \
        asperity oil plan --oil case.toml\n\n\
        plan.csv in the result is the table to fill in for asperity oil fit. With a case, the error of its\n\
        loss by the constants is listed too, and the points are chosen that narrow it most.")]
    Plan(OilPlanArgs),
    /// Boundary friction from Stribeck curves of ball and disc, with its band
    #[command(
        after_help = "Examples:\n  asperity oil stribeck stribeck.csv --oil m100\n  \
        asperity oil stribeck new.txt rubbed.txt --rubbing \"0 s,2 h\" --oil case.toml\n\n\
        The files have the columns of a traction curve, and rubbing_s, the time for which the specimens\n\
        have rubbed before. Points with a film of at most a fifth of the roughness count. How much of the\n\
        load of gears the layer carries does not follow from them: model.inner_boundary is drawn."
    )]
    Stribeck(OilStribeckArgs),
}

/// Zeros of the friction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum ZeroArg {
    /// One for each curve
    Curve,
    /// One for all curves
    Common,
    /// None
    None,
}

/// Probe of the temperature of an export.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum TemperatureColumnArg {
    /// In the oil at the contact
    Lube,
    /// In the pot
    Pot,
}

/// Specimens of a machine.
#[derive(Debug, Args)]
pub struct SpecimenArgs {
    /// Root mean square roughness of both specimens together
    #[arg(long, default_value = "15 nm", allow_hyphen_values = true)]
    pub rq: Length,
    /// Radius of the ball, unless a row states it
    #[arg(long, default_value = "9.525 mm", allow_hyphen_values = true)]
    pub ball_radius: Length,
    /// Radius of the second body, unless a row states it [default: a flat disc]
    #[arg(long, allow_hyphen_values = true)]
    pub second_radius: Option<Length>,
}

/// Priors of the constants and errors of the points.
#[derive(Debug, Args)]
pub struct ErrorArgs {
    /// Leave the constants to the points, with wide priors in place of the family
    #[arg(long)]
    pub wide: bool,
    /// Zeros of the friction
    #[arg(long, value_enum, default_value = "curve")]
    pub zero: ZeroArg,
    /// Standard deviation of points without sigma, relative to the friction
    #[arg(long, default_value = "1.5 %", allow_hyphen_values = true)]
    pub point_sd: Ratio,
    /// Least standard deviation of the friction coefficient of such points
    #[arg(long, default_value_t = 3e-4, allow_hyphen_values = true)]
    pub point_floor: f64,
}

/// `asperity oil fit`
#[derive(Debug, Args)]
pub struct OilFitArgs {
    /// Tables or text exports of traction curves
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<PathBuf>,
    /// Oil of the library with the viscosity and family, or a case, an oil file, or a file with the table [lubricant] only
    #[arg(long)]
    pub oil: String,
    /// Keys of the case set on the command line.
    #[command(flatten)]
    pub set: SetArgs,
    /// Specimens.
    #[command(flatten)]
    pub specimens: SpecimenArgs,
    /// Probe of the temperature in a text export
    #[arg(long, value_enum, default_value = "lube")]
    pub temperature_column: TemperatureColumnArg,
    /// Priors and errors.
    #[command(flatten)]
    pub errors: ErrorArgs,
    /// Accept constants of no known oil
    #[arg(long)]
    pub force: bool,
    /// Folder of the fit [default: results/<name of the first file>-oil]
    #[arg(long, short)]
    pub output: Option<PathBuf>,
}

/// `asperity oil traction`
#[derive(Debug, Args)]
pub struct OilTractionArgs {
    /// Oil of the library, or a case, an oil file, or a file with the table [lubricant] only
    pub oil: String,
    /// Keys of the case set on the command line.
    #[command(flatten)]
    pub set: SetArgs,
    /// Load
    #[arg(long, default_value = "30 N", allow_hyphen_values = true)]
    pub load: Force,
    /// Mean speed of the curves over the slide-to-roll ratio
    #[arg(long, default_value = "2 m/s", allow_hyphen_values = true)]
    pub speed: Speed,
    /// Slide-to-roll ratio of the curves over the speed
    #[arg(long, default_value = "5 %", allow_hyphen_values = true)]
    pub slide_to_roll: Ratio,
    /// Temperatures of the oil bath in °C: a..b:n or a list
    #[arg(
        long,
        default_value = "40,80,120",
        value_name = "AXIS",
        allow_hyphen_values = true
    )]
    pub temperature: String,
    /// Specimens.
    #[command(flatten)]
    pub specimens: SpecimenArgs,
    /// Boundary friction to which the dashed guide of the chart leads [default: that of the model]
    #[arg(long, allow_hyphen_values = true)]
    pub boundary_friction: Option<f64>,
    /// Folder of the curves [default: results/<name of the oil or case>-traction]
    #[arg(long, short)]
    pub output: Option<PathBuf>,
}

/// `asperity oil plan`
#[derive(Debug, Args)]
pub struct OilPlanArgs {
    /// Oil of the library, or a case, an oil file, or a file with the table [lubricant] only
    #[arg(long)]
    pub oil: String,
    /// Case whose loss is to be narrowed [default: the case of --oil]
    #[arg(long)]
    pub case: Option<PathBuf>,
    /// Keys of the case set on the command line.
    #[command(flatten)]
    pub set: SetArgs,
    /// Specimens.
    #[command(flatten)]
    pub specimens: SpecimenArgs,
    /// Priors and errors.
    #[command(flatten)]
    pub errors: ErrorArgs,
    /// Write simulated.csv with simulated friction of the minimal plan, with this seed
    #[arg(long, value_name = "SEED")]
    pub simulate: Option<u64>,
    /// Folder of the plan [default: results/<name of the oil or case>-plan]
    #[arg(long, short)]
    pub output: Option<PathBuf>,
}

/// `asperity oil stribeck`
#[derive(Debug, Args)]
pub struct OilStribeckArgs {
    /// Tables or text exports of Stribeck curves
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<PathBuf>,
    /// Oil of the library, or a case, an oil file, or a file with the table [lubricant] only
    #[arg(long)]
    pub oil: String,
    /// Keys of the case set on the command line.
    #[command(flatten)]
    pub set: SetArgs,
    /// Time of rubbing before each file, 0 s for new specimens, unless a row states it
    #[arg(long, value_delimiter = ',', allow_hyphen_values = true)]
    pub rubbing: Vec<Time>,
    /// Specimens.
    #[command(flatten)]
    pub specimens: SpecimenArgs,
    /// Probe of the temperature in a text export
    #[arg(long, value_enum, default_value = "lube")]
    pub temperature_column: TemperatureColumnArg,
    /// Folder of the result [default: results/<name of the first file>-stribeck]
    #[arg(long, short)]
    pub output: Option<PathBuf>,
}
