//! Call-out of a finish: the limit of a roughness parameter, and the number of traces to inspect, at which a lot of flanks
//! meets a stated loss with a stated confidence.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | s | height of the flanks of a lot over the recipe of the case, the median of the lot | - |
//! | u_n | mean of the parameter over n traces of a lot at s = 1, over its value of the recipe | - |
//! | s* | height at which the mean loss of 16 pairs of flanks of the lot is the stated loss | - |
//! | x | limit of the inspected mean over the value of the recipe | - |
//! | c | confidence | - |
//! | K | simulated lots | - |
//!
//! A recipe is fitted to the prepared traces of the case ([`Fitted`](asperity_roughness::generate::Fitted)). A flank is a
//! part of an endless trace of the recipe, whose heights, wavelengths and peaks (heights above the mean line) are multiplied
//! by factors; each scatters about the median of its lot with the stated standard deviation of its logarithm. The medians of
//! wavelengths and peaks scatter equally from lot to lot about the recipe.
//!
//! One pair of each lot is run, at the height at which the lots lose the stated loss on average; the mean over its 16 pairs
//! follows from the parameters of their traces by a regression over all lots. Pairs of 16 lots are run together and share positions,
//! smooth films and the load of the gears. The curve of the loss over the height is of the pairs of the first 16 lots at equal
//! flanks, and takes the level of all lots.
//!
//! Assumption about the lots: before the inspection nothing is known of the height s of a lot, ln s is uniform. The inspected
//! mean of a lot is s u_n, so that a lot whose inspected mean is x has s = x/u_n, and it meets the loss if x ≤ s* u_n: the limit
//! is a quantile of s* u_n over the lots.
//!
//! ```no_run
//! use asperity::case;
//! use asperity_studies::callout::{CallOutSettings, RoughnessParameter, callout};
//! use asperity_report::Settings;
//! let file = std::path::Path::new("../../fixtures/cases/e-drive.toml");
//! let case = case::load_with(file, &|input| input.model.positions = Some(3))?;
//! let stated = serde_json::json!({ "loss": "600 W", "lots": 20, "parameter": "rq" });
//! let settings = CallOutSettings::of_json(stated)?;
//! let found = callout(&case, &settings, &|_, _| {})?;
//! assert_eq!(found.parameter, RoughnessParameter::Rq);
//! assert!(found.smooth_loss_w < 600.0 && found.limits[0].limit < found.limits[0].recipe);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod error;
mod lots;
mod pair_losses;
mod report;
mod study;
mod target;

pub use lots::RoughnessParameter;
pub use study::{CallOut, CallOutSettings, CurvePoint, LimitRow, ParameterRow, TracesRow, callout};
pub use target::LossTarget;
