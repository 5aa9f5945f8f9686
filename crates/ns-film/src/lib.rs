//! Pressure in and across a thin lubricating film between two cylinders.
//!
//! It is used by `asperity` and `paper-2022`. It does not know gears, roughness or cases.
//!
//! [`model`] computes the pressure difference across the film, the question of the paper, with the
//! consistent film of [`reynolds_cross`] or with the film of the [`paper`]. [`film_pressure`] computes
//! the pressure along the film of any gap.
//!
#![doc = include_str!("../README.md")]

pub mod error;
pub mod film_pressure;
pub mod gap;
pub mod model;
pub mod paper;
pub mod reynolds_cross;
pub mod velocity_profile;

pub use error::FilmError;
pub use model::{
    FilmConditions, FluidModel, pressure_difference_across, pressure_difference_over_thickness,
};
