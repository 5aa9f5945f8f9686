//! The tests of this crate as one program, which is linked only once.

mod areal;
mod common;
mod filters;
mod fitted;
mod fitted_surface;
mod lay;
mod limits;
mod properties;
mod provenance;
mod relocation;
mod surface;
mod surface_preparation;
mod validation;
