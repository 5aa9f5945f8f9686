//! Profilometer files, filters and roughness parameters of measured profiles.
//!
//! From a file to numbers: [`read`] gives a [`Profile`](asperity_core::Profile) with what was found
//! out about the file.

pub mod error;
pub mod read;
mod warning;

pub use error::RoughnessError;
pub use warning::Warning;
