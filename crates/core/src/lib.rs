//! Types that every Asperity crate shares: quantities with units, checked values, equations with
//! their sources, materials, profiles, and the little numerics that is not physics.
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

pub mod cancel {
    //! Cancelling long work from another thread.
    //!
    //! A program gives a piece of work a [`Token`], which [`Task`](crate::task::Task) takes to other threads. The loops of the library
    //! call [`checkpoint`], which returns [`Cancelled`] once the token is cancelled; the error passes up as any other. Without a token a
    //! checkpoint costs the reading of a thread-local flag.
    //!
    //! ```
    //! use asperity_core::cancel::{Cancelled, Token, checkpoint};
    //! let token = Token::new();
    //! token.cancel();
    //! let endless = token.run(|| -> Result<(), Cancelled> {
    //!     loop {
    //!         checkpoint()?;
    //!     }
    //! });
    //! assert_eq!(endless, Err(Cancelled));
    //! ```
    pub use crate::task::checkpoint;
    pub use crate::token::{Cancelled, Token};
}

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
