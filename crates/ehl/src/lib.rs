//! Mixed elastohydrodynamic line contact of two rough surfaces.
//!
//! It is used by `asperity`, for reference solutions. It does not know gears or cases.
//!
//! [`steady::solve`] computes the film of smooth surfaces from a cold start, [`transient::record`] the
//! contact of two rough surfaces over a travel, [`traction::traction`] the traction of a smooth film, and
//! `graded::reference` (feature `oracle`) reference films with an error estimate. Every solution comes with its
//! [`Evidence`]; a solution that does not converge is an [`EhlError`].
//!
//! | symbol | meaning |
//! |---|---|
//! | a, p₀, R | half width and largest pressure of the Hertz contact, relative radius |
//! | X, P, H, T | x/a, p/p₀, h·R/a², t·u_m/a |
//! | S | slide-to-roll ratio (u₁ − u₂)/u_m |
//! | θ | void fraction of a cavitated node |
//!
#![doc = include_str!("../README.md")]

/// Numbers of a short rough record, to which the tests hold the solver: what is stored of the solver is valid for these.
pub const GOLDEN_RECORD: &str = include_str!("golden_record.txt");

mod bands;
pub mod batch_means;
pub mod dimensionless;
pub mod error;
pub mod evidence;
mod fluid;
pub mod friction;
#[cfg(feature = "oracle")]
pub mod graded;
mod grid;
mod hat_kernel;
pub mod heated_friction;
mod linear;
pub mod moving_profile;
mod newton;
mod oil;
mod reynolds;
pub mod several_records;
pub mod steady;
mod stepper;
pub mod traction;
pub mod transient;

pub use batch_means::RecordMean;
pub use dimensionless::{LineContact, Scales};
pub use error::EhlError;
pub use evidence::{Evidence, Solved};
pub use friction::{Friction, FrictionLaw};
pub use heated_friction::RecordHeat;
pub use moving_profile::MovingProfile;
pub use newton::NodeState;
pub use oil::Oil;
pub use steady::{CELL_MULTIPLE, SteadyFilm, SteadySettings, Warning, Window};
pub use transient::{PlasticCeiling, Record, RecordSettings, RoughContact};
