//! Options of `asperity ehl`.

use std::path::PathBuf;

use asperity::case::PathPoint;
use asperity_core::quantity::{
    DynamicViscosity, Length, LineLoad, Pressure, PressureViscosity, Speed, Temperature,
};
use clap::{Args, ValueEnum};

use super::set::SetArgs;

/// A lubricated line contact: of a case, or of bare numbers.
#[derive(Debug, Args)]
pub struct EhlArgs {
    /// Case file, TOML (or JSON with the same keys)
    #[arg(required_unless_present = "radius", conflicts_with_all = ["radius", "profile1"])]
    pub case: Option<PathBuf>,
    /// Position along the path of contact: A, B, C, D, E, or 0 (A) to 1 (E) [default: the case's]
    #[arg(long, conflicts_with = "radius", allow_hyphen_values = true)]
    pub position: Option<PathPoint>,
    /// Set the laws of load sharing beside the solution
    #[arg(long, requires = "case")]
    pub compare: bool,
    /// Keys of the case.
    #[command(flatten)]
    pub set: SetArgs,
    /// Bodies, speeds and oil without a case.
    #[command(flatten)]
    pub bare: BareArgs,
    /// The smooth contact of the case, without its traces
    #[arg(long, requires = "case")]
    pub smooth: bool,
    /// Eyring stress of the film, as "5 MPa" [default: that of the base oil; bare: Newtonian]
    #[arg(long, allow_hyphen_values = true)]
    pub eyring_stress: Option<Pressure>,
    /// Records, each from another pair of places on the profiles, in parallel; their mean is told
    #[arg(long, default_value_t = 1, value_parser = clap::value_parser!(u16).range(1..=64))]
    pub records: u16,
    /// Cells across the film, a multiple of 64; at least 8 a shortest wave of the profiles
    #[arg(long, default_value_t = 512)]
    pub cells: usize,
    /// Travel that is recorded, in half-widths of the contact
    #[arg(
        long,
        value_name = "TRAVEL",
        default_value_t = 20.0,
        allow_hyphen_values = true
    )]
    pub half_widths: f64,
    /// Travel before the record: in the first three half-widths the film is still smooth
    #[arg(
        long,
        value_name = "TRAVEL",
        default_value_t = 3.0,
        allow_hyphen_values = true
    )]
    pub start: f64,
    /// Film below which load counts as carried by solids
    #[arg(long, default_value = "20 nm", allow_hyphen_values = true)]
    pub solid_film: Length,
    /// Film at which a place counts as in contact
    #[arg(long, default_value = "5 nm", allow_hyphen_values = true)]
    pub contact_film: Length,
    /// Write pressure and film per point; of two rough surfaces at several times
    #[arg(long, short)]
    pub output: Option<PathBuf>,
    /// Write a page with film and pressure; of two rough surfaces with frames that can be played
    #[arg(long, value_name = "FILE")]
    pub report: Option<PathBuf>,
    /// Travel between the times that are written, in half-widths [default: 5, in a page 0.1]
    #[arg(long, value_name = "TRAVEL", allow_hyphen_values = true)]
    pub every: Option<f64>,
}

/// Bodies, speeds, oil and profiles without a case.
#[derive(Debug, Args)]
pub struct BareArgs {
    /// Relative radius of curvature, as "10 mm"
    #[arg(long, requires_all = ["e_star", "load", "u1", "u2"], allow_hyphen_values = true)]
    pub radius: Option<Length>,
    /// Reduced modulus E*, as "115.4 GPa"
    #[arg(
        long,
        value_name = "E*",
        requires = "radius",
        allow_hyphen_values = true
    )]
    pub e_star: Option<Pressure>,
    /// Load per length, as "392 N/mm"
    #[arg(long, requires = "radius", allow_hyphen_values = true)]
    pub load: Option<LineLoad>,
    /// Speed of the first surface through the contact, as "5.5 m/s"
    #[arg(long, requires = "radius", allow_hyphen_values = true)]
    pub u1: Option<Speed>,
    /// Speed of the second surface through the contact
    #[arg(long, requires = "radius", allow_hyphen_values = true)]
    pub u2: Option<Speed>,
    /// Oil of the library, as m100; its state at the temperature --bulk
    #[arg(long, requires_all = ["radius", "bulk"], conflicts_with = "viscosity")]
    pub oil: Option<String>,
    /// Temperature of the oil at the inlet, as "90 °C"
    #[arg(long, requires = "oil", allow_hyphen_values = true)]
    pub bulk: Option<Temperature>,
    /// Viscosity at the inlet, as "10 mPa s"
    #[arg(long, requires_all = ["radius", "pressure_viscosity"], allow_hyphen_values = true)]
    pub viscosity: Option<DynamicViscosity>,
    /// Pressure-viscosity coefficient, as "18 1/GPa"
    #[arg(long, requires = "viscosity", allow_hyphen_values = true)]
    pub pressure_viscosity: Option<PressureViscosity>,
    /// Viscosity over pressure; barus goes with a constant density
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
    /// The profiles fit their own beginnings; otherwise the last tenth of each fades into its beginning
    #[arg(long, requires = "radius")]
    pub periodic: bool,
    /// Pressure at which the surfaces flow, as "7 GPa"
    #[arg(long, requires = "radius", allow_hyphen_values = true)]
    pub pressure_limit: Option<Pressure>,
    /// Limiting shear stress of the film over its pressure
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

/// Viscosity over pressure.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum ViscosityLawArg {
    /// Roelands with a free exponent, compressible
    Roelands,
    /// Barus, incompressible
    Barus,
    /// No change with pressure, incompressible
    Isoviscous,
}
