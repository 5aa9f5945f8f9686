//! Profilometer files: reading measured profiles with a record of assumptions, and writing them without loss.
//!
//! It is used by `flanks`, `case` and `cli`. It does not know filters, parameters or gears.
//!
//! [`read`] recognises the format of a file and returns its [`Profile`](asperity_core::Profile) with units, spacing,
//! metadata and [`Warning`]s, or a typed error; [`mod@write`] returns the bytes of a file. Filters and parameters are
//! in `asperity-roughness`.
//!
//! ```
//! use asperity_profile_io::read::{ReadOptions, read_bytes};
//! use asperity_profile_io::write::{WrittenFormat, write};
//! let rows = (0..200).map(|i| format!("{:.4},{:.5}\n", 0.0005 * f64::from(i), (0.063 * f64::from(i)).sin()));
//! let file = format!("x in mm,z in um\n{}", rows.collect::<String>());
//! let reading = read_bytes("flank.csv", file.as_bytes(), &ReadOptions::default())?;
//! assert_eq!(reading.spacing, "0.5 um".parse()?);
//! let bytes = write(&reading.profile, &reading.metadata, WrittenFormat::X3p)?;
//! assert_eq!(read_bytes("flank.x3p", &bytes, &ReadOptions::default())?.profile, reading.profile);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod read;
mod warning;
pub mod write;

pub use warning::Warning;

/// The examples of the README, run as tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
