//! The tests of this crate as one program, which is linked only once.

mod common;
mod flow;
mod lead;
mod limits;
mod orders;
mod patches;
mod paths;
mod properties;
mod provenance;
mod refusals;
mod validation;
