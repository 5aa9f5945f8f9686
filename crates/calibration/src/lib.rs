//! Calibration of boundary friction, boundary layer and film traction, with their bands, on losses measured on a rig.
//!
//! It is used by the programs: `cli`, `python` and `web`. It does not know options of a command.
//!
//! [`calibrate()`] fits four constants that are in no data sheet to the points of a [`RigTable`]. Its result is the table
//! `calibration` of a case, whose bands are part of the band of every later loss. [`plan`] chooses the points with the
//! best information on the constants.
//!
//! | step | file |
//! |---|---|
//! | the table and its checks | [`rig_table`] |
//! | the model at the points, with stored contacts | [`rig_model`] |
//! | response surfaces instead of the model | [`response`], [`surfaces`] |
//! | identifiability | [`information`], [`identifiability`] |
//! | stages and the fit | [`least_squares`], [`problem`], [`fit`] |
//! | bands | [`birge`], [`profile_likelihood`], [`bootstrap`](mod@bootstrap) |
//! | optimal design | [`optimal_design`], [`design`] |
//! | settings | `settings` |
//! | traction curves of ball and disc | [`oil`] |
//! | measurements that would narrow the loss of a case | [`evidence`] |
//!
#![doc = include_str!("../README.md")]

pub mod birge;
mod block;
pub mod bootstrap;
mod calibrate;
pub mod design;
pub mod error;
pub mod evidence;
mod files;
pub mod fit;
mod held_out;
pub mod identifiability;
pub mod information;
pub mod least_squares;
mod number_table;
pub mod oil;
pub mod optimal_design;
mod outliers;
pub mod parameters;
pub mod problem;
pub mod profile_likelihood;
mod report;
pub mod response;
mod result;
pub mod rig;
pub mod rig_model;
pub mod rig_table;
mod settings;
pub mod simulate;
mod summary;
pub mod surfaces;

pub use asperity_report::Watch;
pub use asperity_table::RowFault;
pub use block::block;
pub use calibrate::calibrate;
pub use design::{Design, Limits, plan};
pub use files::{RigFiles, table_text};
pub use result::{
    Calibration, Evidence, FittedParameter, FittedPoint, HeldOut, HelpfulPoint, Identifiability,
    IdentifiedParameter, NuisanceRow, StageRow, Verdict,
};
pub use rig::{Rig, RigCase};
pub use rig_table::{Reach, RigRow, RigTable, Scope};
pub use settings::{CalibrationSettings, DesignSettings};
