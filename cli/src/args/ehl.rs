//! Options of `asperity ehl`.

use std::path::PathBuf;

use asperity::case::PathPoint;
use asperity_core::quantity::{
    DynamicViscosity, Length, LineLoad, Pressure, PressureViscosity, Speed, Temperature,
};
use clap::{Args, ValueEnum};

use super::set::SetArgs;

/// Lubricated line contact: of a case, or from numbers only.
#[derive(Debug, Args)]
pub struct EhlArgs {
    /// Case file, TOML (or JSON with the same keys)
    #[arg(required_unless_present = "radius", conflicts_with_all = ["radius", "profile1"])]
    pub case: Option<PathBuf>,
    /// Position along the path of contact: A, B, C, D, E, or 0 (A) to 1 (E) [default: the case's]
    #[arg(long, conflicts_with = "radius", allow_hyphen_values = true)]
    pub position: Option<PathPoint>,
    /// Print the load-sharing laws next to the solution
    #[arg(long, requires = "case")]
    pub compare: bool,
    /// Keys of the case set on the command line.
    #[command(flatten)]
    pub set: SetArgs,
    /// Bodies, speeds and oil without a case.
    #[command(flatten)]
    pub bare: BareArgs,
    /// Solve the smooth contact of the case, without its traces
    #[arg(long, requires = "case")]
    pub smooth: bool,
    /// Eyring stress of the film, e.g. "5 MPa" [default: the value of the base oil; without a case Newtonian]
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
        requires = "case",
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

/// Bodies, speeds, oil and profiles without a case.
#[derive(Debug, Args)]
pub struct BareArgs {
    /// Relative radius of curvature, e.g. "10 mm"
    #[arg(long, requires_all = ["e_star", "load", "u1", "u2"], allow_hyphen_values = true)]
    pub radius: Option<Length>,
    /// Reduced modulus E*, e.g. "115.4 GPa"
    #[arg(
        long,
        value_name = "E*",
        requires = "radius",
        allow_hyphen_values = true
    )]
    pub e_star: Option<Pressure>,
    /// Load per length, e.g. "392 N/mm"
    #[arg(long, requires = "radius", allow_hyphen_values = true)]
    pub load: Option<LineLoad>,
    /// Speed of the first surface through the contact, e.g. "5.5 m/s"
    #[arg(long, requires = "radius", allow_hyphen_values = true)]
    pub u1: Option<Speed>,
    /// Speed of the second surface through the contact
    #[arg(long, requires = "radius", allow_hyphen_values = true)]
    pub u2: Option<Speed>,
    /// Oil of the library, e.g. m100, at the temperature of --bulk
    #[arg(long, requires_all = ["radius", "bulk"], conflicts_with = "viscosity")]
    pub oil: Option<String>,
    /// Temperature of the oil at the inlet, e.g. "90 °C"
    #[arg(long, requires = "oil", allow_hyphen_values = true)]
    pub bulk: Option<Temperature>,
    /// Viscosity at the inlet, e.g. "10 mPa s"
    #[arg(long, requires_all = ["radius", "pressure_viscosity"], allow_hyphen_values = true)]
    pub viscosity: Option<DynamicViscosity>,
    /// Pressure-viscosity coefficient, e.g. "18 1/GPa"
    #[arg(long, requires = "viscosity", allow_hyphen_values = true)]
    pub pressure_viscosity: Option<PressureViscosity>,
    /// Law of viscosity against pressure; barus has a constant density
    #[arg(long, value_enum, requires = "radius", default_value = "roelands")]
    pub viscosity_law: ViscosityLawArg,
    /// Roelands' exponent
    #[arg(
        long,
        requires = "radius",
        default_value_t = 0.6,
        allow_hyphen_values = true
    )]
    pub roelands: f64,
    /// Profile of the first surface: CSV with columns x and z, heights out of the material
    #[arg(long, requires = "radius", value_name = "FILE")]
    pub profile1: Option<PathBuf>,
    /// Profile of the second surface
    #[arg(long, requires = "radius", value_name = "FILE")]
    pub profile2: Option<PathBuf>,
    /// The profiles are periodic; otherwise the last tenth of each is blended into its beginning
    #[arg(long, requires = "radius")]
    pub periodic: bool,
    /// Pressure at which the surfaces flow plastically, e.g. "7 GPa"
    #[arg(long, requires = "radius", allow_hyphen_values = true)]
    pub pressure_limit: Option<Pressure>,
    /// Ratio of the limiting shear stress of the film to its pressure
    #[arg(
        long,
        requires = "radius",
        default_value_t = 0.05,
        allow_hyphen_values = true
    )]
    pub limiting_shear: f64,
    /// Friction coefficient of the boundary layer
    #[arg(
        long,
        requires = "radius",
        default_value_t = 0.1,
        allow_hyphen_values = true
    )]
    pub boundary_friction: f64,
}

/// Law of viscosity against pressure.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum ViscosityLawArg {
    /// Roelands with a free exponent, compressible
    Roelands,
    /// Barus, incompressible
    Barus,
    /// Constant viscosity, incompressible
    Isoviscous,
}
