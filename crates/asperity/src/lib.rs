//! From two measured tooth flanks to the efficiency of a gear mesh.
//!
//! A case comes from a file ([`case::load`]), from a text ([`case::from_text`]) or from quantities and heights
//! ([`Case::builder`]); [`run`] computes it, pure data in and pure data out. The physics lives in the crates
//! below this one, which are re-exported; the order in which it is used lives in [`pipeline`] alone.
//!
//! ```
//! use asperity::prelude::*;
//! let heights: Vec<f64> = (0..8000).map(|i| 2e-7 * (f64::from(i) * 0.7).sin()).collect();
//! let case = Case::builder(
//!     GearsInput::new([23, 68], "1.8 mm".parse()?, "32 mm".parse()?),
//!     OperationInput::new("145 N m".parse()?, "9000 1/min".parse()?, "90 °C".parse()?),
//!     LubricantInput { oil: Some("m100".to_owned()), ..LubricantInput::default() },
//! )
//! .pinion(Trace::from_heights(&heights, Length::from_si(0.5e-6))?)
//! .change(|input| input.surface.cutoff = Some(Length::from_si(0.25e-3)))
//! .change(|input| (input.model.positions, input.model.offsets) = (Some(8), Some(1)))
//! .build()?;
//! let summary = asperity::run(&case, &|_, _| ())?.result.summary;
//! assert!((0.95..1.0).contains(&summary.efficiency));
//! // A change rereads only the files that it affects.
//! let cooler = case.with_key("operation.temperature", "70 °C")?;
//! assert!(asperity::run(&cooler, &|_, _| ())?.result.summary.loss_w != summary.loss_w);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod assembly;
mod attention;
pub mod balance;
pub mod band;
mod branch;
mod bulk;
pub mod case;
mod chosen_laws;
mod comparison;
mod contact_tables;
pub mod contact_view;
mod decision;
mod deformation_losses;
mod detail;
pub mod dry_contact;
pub mod encounter;
pub mod equations;
pub mod error;
mod fields;
pub mod film_constants;
pub mod fingerprint;
pub mod flank_form;
pub mod flank_record;
pub mod fluid;
mod formulation;
mod friction;
pub mod full_film;
mod full_film_solution;
pub mod gear_report;
pub mod gearbox;
pub mod kept_fields;
pub mod key_words;
pub mod laws;
pub mod load_report;
pub mod load_share_law;
pub mod local_roughness;
pub mod loss_band;
pub mod loss_table;
mod losses;
pub mod message;
mod micropitting;
pub mod micropitting_report;
pub mod physical_sense;
pub mod pipeline;
pub mod placement;
pub mod planetary;
mod position;
pub mod prelude;
mod provenance;
pub mod records;
pub mod referee;
pub mod result;
pub mod reversed;
mod rolling;
mod rough_film;
pub mod run_in;
mod solve;
mod solved;
pub mod station;
mod stations;
pub mod surfaces;
pub mod survey;
pub mod trace_pairs;

pub use case::{Case, CaseInput, LoadedCase};
pub use contact_tables::ContactTables;
pub use error::{Error, PositionError, UnsolvedContact};
pub use pipeline::{contacts, losses, run};
pub use result::{Outcome, RunResult};

// The crates that the orchestrator stands on, each of use alone.
pub use asperity_contact as contact;
pub use asperity_core as core;
pub use asperity_core::quantity;
pub use asperity_core::remedy::{self, Remedy};
pub use asperity_efficiency as efficiency;
pub use asperity_ehl as ehl;
pub use asperity_ehl_regime as ehl_regime;
pub use asperity_gear as gear;
pub use asperity_mixed_film as mixed_film;
pub use asperity_ns_film as ns_film;
pub use asperity_oil as oil;
pub use asperity_profile_io as profile_io;
pub use asperity_roughness as roughness;
pub use asperity_tribo_friction as tribo_friction;
