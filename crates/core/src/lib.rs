//! Types that every Asperity crate shares: quantities with units, checked values, equations with
//! their sources, materials, profiles, and the little numerics that is not physics.
//!
//! It is used by every other crate. It does not know the physics of a contact, gears, files or cases.
//!
//! Conventions hold for the whole workspace: SI inside every function, heights point out of the
//! material, the reduced modulus is E* = 1 / Σ((1 − νᵢ²)/Eᵢ), and E′ = 2 E* in the groups of
//! elastohydrodynamics.
//!
#![doc = include_str!("../README.md")]

/// The program and its version, as results and files name it.
pub const PROGRAM: &str = concat!("asperity ", env!("CARGO_PKG_VERSION"));

/// Version of every structure that a program reads back: `result.json`, `map.json`, `calibration.json`. It is raised when a field
/// changes its meaning.
pub const SCHEMA_VERSION: u32 = 1;

pub mod cancel;
pub mod checked;
pub mod derived;
pub mod error;
pub mod estimate;
pub mod hardness;
pub mod line_contact;
pub mod material;
pub mod message;
mod message_number;
mod nearest_name;
pub mod noted;
pub mod numerics;
mod plain_words;
pub mod powder_metal;
pub mod presets;
pub mod profile;
pub mod provenance;
pub mod quantity;
pub mod remedy;
mod repeated_fault;
mod system_file;
pub mod task;
mod token;
mod unique;
mod unit_text;

pub use checked::{Checked, FittedRange, OutOfRange, Treatment};
pub use error::DomainError;
pub use estimate::{Estimate, EstimateKeys};
pub use material::Material;
pub use message::{Code, Fault, Place};
pub use message_number::{by_size, decimals, number, number_with_unit};
pub use nearest_name::{did_you_mean, most_similar, nearest_name};
pub use plain_words::{in_plain_words, type_in_words};
pub use profile::Profile;
pub use quantity::Quantity;
pub use remedy::{Action, Remedy, Setting, capitalised};
pub use repeated_fault::RepeatedFault;
pub use system_file::is_of_system;
pub use unique::unique;
