//! Writing profiles in the formats of other programs.
//!
//! | format | heights | spacing |
//! |---|---|---|
//! | CSV | micrometres, the fewest digits that are read back without loss; metres if a height has none | header line `# dx = 0.5 um` |
//! | X3P (ISO 25178-72) | binary64 metres | increment of CX |
//! | SMD (ISO 5436-2) | metres, the fewest digits that are read back without loss | CX line |
//!
//! The functions return bytes and open no files.

mod csv;
mod error;
mod field;
mod places;
mod smd;
#[cfg_attr(not(feature = "packed"), path = "no_x3p.rs")]
mod x3p;

use asperity_core::Profile;
use asperity_core::quantity::Length;
use serde::{Deserialize, Serialize};

pub use error::WriteError;
use places::Places;

use crate::read::metadata::Metadata;
use crate::read::{FilterState, Positions, Trace};

/// A format for writing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum WrittenFormat {
    /// Comma-separated text with units in its header.
    Csv,
    /// ISO 25178-72.
    X3p,
    /// ISO 5436-2.
    Smd,
}

impl WrittenFormat {
    /// The format of a file name by its extension.
    ///
    /// ```
    /// use asperity_profile_io::write::WrittenFormat;
    /// assert_eq!(WrittenFormat::of_name("flank.X3P"), Some(WrittenFormat::X3p));
    /// assert_eq!(WrittenFormat::of_name("flank"), None);
    /// ```
    pub fn of_name(name: &str) -> Option<Self> {
        let (_, extension) = name.rsplit_once('.')?;
        match extension.to_lowercase().as_str() {
            "csv" | "txt" => Some(Self::Csv),
            "x3p" => Some(Self::X3p),
            "smd" => Some(Self::Smd),
            _ => None,
        }
    }
}

/// The bytes of a file with `profile`, of which nothing is known about its filters; reading them back gives the same
/// profile, to the last bit.
///
/// # Errors
/// When the archive of an X3P cannot be created, as for more than 4 GiB of heights.
///
/// ```
/// use asperity_core::{Profile, quantity::Length};
/// use asperity_profile_io::read::{Metadata, ReadOptions, read_bytes};
/// use asperity_profile_io::write::{WrittenFormat, write};
/// let heights = (0..200).map(|i| 1e-7 * (0.1 * f64::from(i)).sin()).collect();
/// let profile = Profile::new(Length::from_si(0.1e-6), heights)?;
/// for (name, format) in [("a.csv", WrittenFormat::Csv), ("a.x3p", WrittenFormat::X3p), ("a.smd", WrittenFormat::Smd)] {
///     let bytes = write(&profile, &Metadata::default(), format)?;
///     let again = read_bytes(name, &bytes, &ReadOptions::default())?.profile;
///     assert_eq!(again.spacing(), profile.spacing());
///     assert_eq!(again.heights(), profile.heights());
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write(
    profile: &Profile,
    metadata: &Metadata,
    format: WrittenFormat,
) -> Result<Vec<u8>, WriteError> {
    write_filtered(profile, metadata, FilterState::Unknown, format)
}

/// The bytes of a file with `profile` as [`write()`], and its filter state with the cut-offs of `metadata`, which CSV
/// states.
///
/// # Errors
/// As [`write()`].
///
/// ```
/// use asperity_core::{Profile, quantity::Length};
/// use asperity_profile_io::read::{FilterState, Metadata, ReadOptions, read_bytes};
/// use asperity_profile_io::write::{WrittenFormat, write_filtered};
/// let heights = (0..200).map(|i| 1e-7 * (0.1 * f64::from(i)).sin()).collect();
/// let profile = Profile::new(Length::from_si(0.1e-6), heights)?;
/// let metadata = Metadata { lambda_c: Some("0.8 mm".parse()?), ..Metadata::default() };
/// let bytes = write_filtered(&profile, &metadata, FilterState::Roughness, WrittenFormat::Csv)?;
/// let again = read_bytes("r.csv", &bytes, &ReadOptions::default())?;
/// assert_eq!((again.filter_state, again.metadata.lambda_c), (FilterState::Roughness, metadata.lambda_c));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write_filtered(
    profile: &Profile,
    metadata: &Metadata,
    filter_state: FilterState,
    format: WrittenFormat,
) -> Result<Vec<u8>, WriteError> {
    let (places, heights) = (Places::Even(profile.spacing().si()), profile.heights());
    match format {
        WrittenFormat::Csv => Ok(csv::write(places, heights, metadata, filter_state)),
        WrittenFormat::X3p => x3p::write(places, heights, None, metadata),
        WrittenFormat::Smd => Ok(smd::write(profile, metadata)),
    }
}

/// The bytes of a file with `trace`, with the individual x of uneven points.
///
/// # Errors
/// As [`write()`], and for uneven points as SMD.
///
/// ```
/// use asperity_profile_io::read::{ReadOptions, read_trace_bytes};
/// use asperity_profile_io::write::{WrittenFormat, write_trace};
/// let x = |i: u32| 0.5 * f64::from(i) + 0.2 * f64::from(i).sin();
/// let row = |i: u32| format!("{:.4};{:.4}\n", x(i), (0.1 * x(i)).sin());
/// let file = format!("x [um];z [um]\n{}", (0..200).map(row).collect::<String>());
/// let options = ReadOptions::default();
/// let trace = read_trace_bytes("a.csv", file.as_bytes(), &options)?;
/// for (name, format) in [("a.csv", WrittenFormat::Csv), ("a.x3p", WrittenFormat::X3p)] {
///     let again = read_trace_bytes(name, &write_trace(&trace, format)?, &options)?;
///     assert_eq!(again.x().len(), trace.x().len());
///     let both = again.heights.iter().zip(&trace.heights);
///     assert!(both.into_iter().all(|(again, z)| (again - z).abs() <= f64::EPSILON * z.abs()));
/// }
/// assert!(write_trace(&trace, WrittenFormat::Smd).is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write_trace(trace: &Trace, format: WrittenFormat) -> Result<Vec<u8>, WriteError> {
    let (heights, metadata) = (&trace.heights, &trace.metadata);
    match (&trace.positions, format) {
        (Positions::Own { x, .. }, WrittenFormat::Csv) => Ok(csv::write(
            Places::Own(x),
            heights,
            metadata,
            trace.filter_state,
        )),
        (Positions::Own { x, .. }, WrittenFormat::X3p) => {
            x3p::write(Places::Own(x), heights, None, metadata)
        }
        (Positions::Own { .. }, WrittenFormat::Smd) => Err(WriteError::uneven()),
        (Positions::Even { spacing }, _) => {
            let profile = Profile::new(*spacing, heights.clone());
            write_filtered(
                &profile.map_err(|_| WriteError::no_profile())?,
                metadata,
                trace.filter_state,
                format,
            )
        }
    }
}

/// The bytes of an X3P with a surface, heights \[m\] row by row, NaN where there is none; `spacings` along and across the rows.
///
/// # Errors
/// As [`write()`], and if the heights are not whole rows of `columns` points.
///
/// ```
/// use asperity_core::quantity::Length;
/// use asperity_profile_io::read::{Metadata, ReadOptions, read_surface_bytes};
/// use asperity_profile_io::write::write_surface;
/// let z: Vec<f64> = (0..300).map(|k| 1e-7 * f64::from(k % 17)).collect();
/// let spacings = [0.5e-6, 2e-6].map(Length::from_si);
/// let bytes = write_surface(&z, 100, spacings, &Metadata::default())?;
/// let again = read_surface_bytes("a.x3p", &bytes, &ReadOptions::default())?;
/// assert_eq!((again.columns, again.rows, again.z), (100, 3, z));
/// assert_eq!([again.dx, again.dy], spacings.map(Some));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write_surface(
    z: &[f64],
    columns: usize,
    [dx, dy]: [Length; 2],
    metadata: &Metadata,
) -> Result<Vec<u8>, WriteError> {
    let is_whole = columns > 0 && !z.is_empty() && z.len().is_multiple_of(columns);
    if is_whole && dx.si() > 0.0 && dy.si() > 0.0 {
        x3p::write(
            Places::Even(dx.si()),
            z,
            Some((z.len() / columns, dy.si())),
            metadata,
        )
    } else {
        Err(WriteError::no_profile())
    }
}
