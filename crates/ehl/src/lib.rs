//! Mixed elastohydrodynamic line contact of two rough surfaces.

#![allow(dead_code)]
pub mod amplitude_reduction;
mod bands;
pub mod batch_means;
pub mod dimensionless;
pub mod equations;
pub mod error;
pub mod evidence;
pub mod friction;
pub mod graded;
mod grid;
mod hat_kernel;
mod linear;
pub mod moving_profile;
mod newton;
mod reynolds;
pub mod rheology;
pub mod steady;
mod stepper;
pub mod traction;
pub mod transient;

pub use batch_means::Estimate;
pub use dimensionless::{LineContact, Scales};
pub use error::EhlError;
pub use evidence::{Evidence, Solved};
pub use friction::{Friction, FrictionLaw};
pub use moving_profile::MovingProfile;
pub use newton::NodeState;
pub use rheology::{DensityLaw, Oil, ShearLaw, ViscosityLaw};
pub use steady::{SteadyFilm, SteadySettings, Warning, Window};
pub use transient::{PlasticCeiling, Record, RecordSettings, RoughContact};
