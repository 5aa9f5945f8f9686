//! Pressure in and across a thin lubricating film between two cylinders.
//!
//! [`model`] answers the paper's question, how far the pressure differs across the film, with the
//! consistent film of [`reynolds_cross`] or that of the [`paper`]. [`film_pressure`] gives the
//! pressure along the film of any gap.

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
