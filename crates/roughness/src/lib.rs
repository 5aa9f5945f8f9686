//! Profilometer files, filters and roughness parameters of measured profiles.
//!
//! From a file to numbers: [`read`] gives a [`Profile`](asperity_core::Profile) with what was found
//! out about the file, [`preparation`] removes form and filters by a recipe that goes with the result,
//! [`Parameters`] bundles what standards ask for. [`composite`] lays two flanks on each other,
//! [`summits`] finds the radius of their asperities, [`generate`] makes profiles from a seed.
//!
//! ```
//! use asperity_roughness::{Parameters, height_parameters::Mode, preparation::{Preparation, prepare}};
//! use asperity_roughness::read::{ReadOptions, read_bytes};
//! let rows = (0..12_000).map(|i| format!("{:.4},{:.5}\n", 0.0005 * f64::from(i), (0.063 * f64::from(i)).sin()));
//! let file = format!("x in mm,z in um\n{}", rows.collect::<String>());
//! let reading = read_bytes("flank.csv", file.as_bytes(), &ReadOptions::default())?;
//! let prepared = prepare(&reading.profile, &Preparation::default())?;
//! let found = Parameters::of(&prepared.profile, Mode::Iso4287, "0.8 mm".parse()?)?;
//! assert!((found.heights.ra.si() / 0.6366e-6 - 1.0).abs() < 0.01);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod ambiguity;
pub mod autocorrelation;
mod blocks;
pub mod composite;
mod elements;
pub mod equations;
pub mod error;
pub mod form;
pub mod gaussian_filter;
pub mod generate;
pub mod height_parameters;
pub mod hurst;
pub mod involute;
mod local_parabolas;
pub mod material_ratio;
pub mod outliers;
mod parameters;
pub mod preparation;
pub mod read;
pub mod robust_filter;
pub mod section_heights;
pub mod spectral;
pub mod summits;
mod warning;
pub mod write;

pub use equations::EQUATIONS;
pub use error::RoughnessError;
pub use parameters::Parameters;
pub use warning::Warning;
