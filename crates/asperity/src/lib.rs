//! From two measured tooth flanks to the efficiency of a gear mesh.
//!
//! It is used by `report`, `studies`, `calibration`, `paper-2022` and the programs. It does not know pages, studies or the formulation of the 2022 paper.
//!
//! | start here | for |
//! |---|---|
//! | [`prelude`] | the names that most programs need |
//! | [`case`] | a case from a file ([`case::load`]), from text ([`case::from_text`]), or from quantities and heights ([`Case::builder`]) |
//! | [`Run`] | a run of a pair of gears or of a train, with its interval, or its losses only |
//! | [`result`] | the numbers of a run, as values and as JSON |
//! | [`laws`] | user-defined laws of film, friction and load distribution |
//! | [`formulation`] | other formulations of the model, which a program registers |
//! | [`train`] | several meshes, shafts, bearings and seals with one loss |
//! | [`gear`], [`roughness`], [`contact`], [`oil`], [`ehl`], ... | the physics crates, which work without this one |
//!
//! A run is pure, data in and data out. A case passes through plain values:
//!
//! ```text
//!  Case ──> Mesh ──────> windows ──────> Contacts ────> lubricated ──────> RunResult
//!           load,        of both         pressure at    positions          rows, interval,
//!           speeds,      flanks          each mean      film, share,       warnings,
//!           Hertz                        gap            friction, loss     provenance
//! ```
//!
//! Their modules: [`mesh`], [`flanks`], [`contacts`], [`lubrication`], [`result`].
//!
//! [`pipeline`] has the functions between these values. Interval ([`uncertainty`]), bulk temperature, running-in, gear trains,
//! maps and calibrations are loops around them.
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
//! let summary = Run::new(&case).execute()?.into_only()?.result.summary;
//! assert!((0.95..1.0).contains(&summary.efficiency));
//! // A change rereads only the files that it affects.
//! let cooler = case.with_key("operation.bulk_temperature", "70 °C")?;
//! assert!(Run::new(&cooler).losses()?.into_only()?.summary.loss_w != summary.loss_w);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Features, on by default: `case-files` (cases, oil files and loss tables as text), `packed` (traces in archives, workbooks and
//! XML), `simd` (loops for the widest vectors of the machine). Without one its files are refused; no number changes.

mod assembly;
pub mod contacts;
#[doc(hidden)]
pub mod equations;
pub mod evidence;
pub mod gearbox;
pub mod lubrication;
pub mod mesh;
mod pictures;
pub mod pipeline;
pub mod prelude;
#[doc(hidden)]
pub mod records;
#[doc(hidden)]
pub mod reference_solution;
pub mod result;
mod run;
mod sampling;
pub mod train;
pub mod uncertainty;

pub use asperity_case::{
    balance, case, error, fingerprint, flanks, formulation, key_words, laws, loss_table, message,
    window_pressures,
};
pub use assembly::Reversed;
pub use case::{Case, CaseInput, LoadedCase};
pub use contacts::{Contacts, running_in};
pub use error::{Error, PositionError, UnsolvedContact};
pub use pipeline::ContactStore;
pub use result::{MeshOutcome, RunResult};
pub use run::Run;
pub use train::{Outcome, TrainLosses};

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
