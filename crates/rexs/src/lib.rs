//! Gear cases from REXS gearbox files.
//!
//! It is used by the programs: `cli`, `python` and `web`. It does not know how a case is read or computed.
//!
//! REXS (Reusable Engineering EXchange Standard, FVA) describes gearboxes as components with attributes and
//! relations between them. This crate reads versions 1.0 to 2.0 as XML, JSON or zip, lists the stages, and writes
//! a case of one of them or of all.
//!
//! Names of components, attributes and units: the public REXS model, schema 2.0.0, and files of three
//! programs. A flank is called `flank_geometry` in 1.0 and 1.1, `cylindrical_gear_flank` from 1.2 on.
//!
#![doc = include_str!("../README.md")]

mod case_text;
mod contents;
mod error;
mod json;
mod model;
mod modifications;
mod oil;
mod operating_points;
mod read;
mod set_text;
mod shafts;
mod stages;
mod tool;
mod train_text;
mod units;
mod unread;
mod writer;
mod xml;

pub use case_text::{Flanks, case_text};
pub use contents::{contents, lubricants, teeth_of};
pub use model::{Attribute, Component, LoadCase, Model, Relation};
pub use operating_points::{OperatingPoint, operating_points};
pub use stages::{Stage, StageKind, stages};
pub use train_text::train_text;
pub use writer::CaseText;
