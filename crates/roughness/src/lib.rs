//! Filters, roughness parameters and synthetic profiles.
//!
//! It is used by `flanks`, `case` and `asperity`. It does not know files, gears or oil.
//!
//! [`preparation`] removes the form of a [`Profile`](asperity_core::Profile) and filters it by a recorded recipe;
//! [`Parameters`] holds the standardised parameters. [`composite`] adds two flanks, [`summits`] computes the radius of
//! asperities, [`generate`] creates synthetic profiles from a seed. Files are read by `asperity-profile-io`.
//!
//! ```
//! use asperity_roughness::{Parameters, height_parameters::Mode, preparation::{Preparation, prepare}};
//! use asperity_core::{Profile, quantity::Length};
//! let heights = (0..12_000).map(|i| 1e-6 * (0.063 * f64::from(i)).sin()).collect();
//! let flank = Profile::new(Length::from_si(0.5e-6), heights)?;
//! let prepared = prepare(&flank, &Preparation::default())?;
//! let parameters = Parameters::from_profile(&prepared.profile, Mode::Iso4287, "0.8 mm".parse()?)?;
//! assert!((parameters.heights.ra.si() / 0.6366e-6 - 1.0).abs() < 0.01);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod ambiguity;
pub mod areal;
pub mod autocorrelation;
mod blocks;
pub mod composite;
mod dominant;
mod elements;
pub mod error;
pub mod form;
pub mod gaussian_filter;
pub mod generate;
pub mod height_parameters;
pub mod hurst;
pub mod involute;
pub mod lay;
mod local_parabolas;
pub mod material_levels;
pub mod material_ratio;
pub mod outliers;
mod parameters;
pub mod preparation;
mod quantised;
pub mod relocation;
pub mod resampling;
pub mod robust_filter;
pub mod section_heights;
pub mod spectral;
pub mod summits;
pub mod surface_preparation;
pub mod surface_step;
mod warning;

pub use error::RoughnessError;
pub use parameters::Parameters;
pub use warning::Warning;

/// The examples of the README, run as tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
