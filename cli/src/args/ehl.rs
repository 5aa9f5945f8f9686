//! Options of `asperity ehl`.

use std::path::PathBuf;

use asperity::case::PathPoint;
use asperity_core::quantity::{Length, Pressure};
use clap::Args;

use super::set::SetArgs;

/// Case, and position of its lubricated contact.
#[derive(Debug, Args)]
pub struct EhlArgs {
    /// Case file, TOML (or JSON with the same keys); - reads standard input
    pub case: PathBuf,
    /// Position along the path of contact: A, B, C, D, E, or 0 (A) to 1 (E) [default: the case's]
    #[arg(long, allow_hyphen_values = true)]
    pub position: Option<PathPoint>,
    /// Print the load-sharing laws next to the solution
    #[arg(long)]
    pub compare: bool,
    /// Keys of the case set on the command line.
    #[command(flatten)]
    pub set: SetArgs,
    /// Solve the smooth contact of the case, without its traces
    #[arg(long)]
    pub smooth: bool,
    /// Eyring stress of the film, e.g. "5 MPa" [default: the value of the case]
    #[arg(long, allow_hyphen_values = true)]
    pub eyring_stress: Option<Pressure>,
    /// Number of records, each at other positions on the profiles, run in parallel; their mean is printed
    #[arg(long, default_value_t = 1, value_parser = clap::value_parser!(u16).range(1..=64))]
    pub records: u16,
    /// Number of cells along the contact, a multiple of 64; at least 8 per shortest wave of the profiles
    #[arg(long, default_value_t = 512)]
    pub cells: usize,
    /// Shortest wave left in the profiles of the case, with at least the cells that it needs [default: 8 um, or 8 cells]
    #[arg(
        long,
        value_name = "LENGTH",
        conflicts_with = "smooth",
        allow_hyphen_values = true
    )]
    pub shortest_wave: Option<Length>,
    /// Travel recorded, in half-widths of the contact
    #[arg(
        long,
        value_name = "TRAVEL",
        default_value_t = 20.0,
        allow_hyphen_values = true
    )]
    pub half_widths: f64,
    /// Travel before recording starts: in the first three half-widths the film is still smooth
    #[arg(
        long,
        value_name = "TRAVEL",
        default_value_t = 3.0,
        allow_hyphen_values = true
    )]
    pub start: f64,
    /// Film thickness below which load is attributed to the solids
    #[arg(long, default_value = "20 nm", allow_hyphen_values = true)]
    pub solid_film: Length,
    /// Film thickness at which a point counts as in contact
    #[arg(long, default_value = "5 nm", allow_hyphen_values = true)]
    pub contact_film: Length,
    /// Write pressure and film at every point; for two rough surfaces at several times
    #[arg(long, short)]
    pub output: Option<PathBuf>,
    /// Write an HTML page with film and pressure; for two rough surfaces with an animation
    #[arg(long, value_name = "FILE")]
    pub report: Option<PathBuf>,
    /// Travel between the times written, in half-widths [default: 5; in a page 0.1]
    #[arg(long, value_name = "TRAVEL", allow_hyphen_values = true)]
    pub every: Option<f64>,
}
