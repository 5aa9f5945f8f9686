//! Arguments of `asperity oil`.

use std::path::PathBuf;

use asperity_core::quantity::{Force, Length, Ratio, Speed};
use clap::{Args, Subcommand};

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
}

/// `asperity oil traction`
#[derive(Debug, Args)]
pub struct OilTractionArgs {
    /// Oil of the library, or a case file whose oil is taken
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
    /// Radius of the ball
    #[arg(long, default_value = "9.525 mm", allow_hyphen_values = true)]
    pub ball_radius: Length,
    /// Radius of the second body [default: a flat disc]
    #[arg(long, allow_hyphen_values = true)]
    pub second_radius: Option<Length>,
    /// Root mean square roughness of ball and disc together
    #[arg(long, default_value = "15 nm", allow_hyphen_values = true)]
    pub rq: Length,
    /// Boundary friction to which the dashed guide of the chart leads [default: that of the model]
    #[arg(long, allow_hyphen_values = true)]
    pub boundary_friction: Option<f64>,
    /// Folder of the curves [default: results/<name of the oil or case>-traction]
    #[arg(long, short)]
    pub output: Option<PathBuf>,
}
