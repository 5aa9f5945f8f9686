//! The tests of this crate as one program, which is linked only once.

mod common;
mod filters;
mod limits;
mod properties;
mod provenance;
mod surface;
mod validation;
