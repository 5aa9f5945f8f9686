//! The ridges of both flanks that cost most: the gradient of the loss over the heights, by ridge and by octave of
//! wavelength, and a run with the costliest ridges pressed to the mean line.
//!
//! ```
//! use asperity::case;
//! use asperity_studies::ridges::ridges;
//! let file = std::path::Path::new("../../fixtures/cases/e-drive.toml");
//! let case = case::load_with(file, &|input| {
//!     (input.model.positions, input.model.offsets) = (Some(4), Some(2));
//! })?;
//! let found = ridges(&case, &|_, _| {})?.found;
//! assert!(found.pressed_at_medians_w < found.loss_at_medians_w);
//! assert!(found.rows[0].first_order_w >= found.rows[1].first_order_w);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod report;
mod study;

pub use study::{RUNS, RidgeSettings, RidgeStudy, add_ridges, ridges};
