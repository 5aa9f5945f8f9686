//! The formulation of the 2022 paper: flanks that march to their load, its film pressure and its printed deformation
//! loss. The default formulation uses none of it.

mod film_pressure;
mod marching;
mod printed_deformation;

pub use film_pressure::film_at;

pub(crate) use marching::march;
pub(crate) use printed_deformation::{PrintedDeformation, printed_deformation_of};
