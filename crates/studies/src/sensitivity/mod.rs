//! Sensitivity of the loss of a case to single changes: heights and wavelengths of the flanks, boundary layer, oil, tip
//! relief. Every number is the difference of two runs of the model at the same windows of the traces.
//!
//! ```
//! use asperity::case;
//! use asperity_studies::sensitivity::sensitivity;
//! let file = std::path::Path::new("../../fixtures/cases/e-drive.toml");
//! let case = case::load_with(file, &|input| {
//!     (input.model.positions, input.model.offsets) = (Some(4), Some(4));
//! })?;
//! let found = sensitivity(&case.into(), &|_, _| {})?;
//! let lower = found.rows.iter().find(|row| row.what == "heights of both flanks").ok_or("always there")?;
//! assert!(lower.effect.as_ref().is_some_and(|effect| effect.difference_w < 0.0));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod bands;
mod changes;
mod report;
mod study;

pub use bands::wavelength_bands;
pub use study::{Effect, Refused, Sensitivity, SensitivityRow, SensitivitySettings, sensitivity};
