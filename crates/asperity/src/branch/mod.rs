//! Load carried at one mesh position and one offset: the film alone, film and asperities
//! together, or, as the paper has it, surfaces lowered into each other step by step.

mod bodies;
mod carried;
mod full_film;
mod marching;
mod mixed;
mod printed_deformation;
mod rough_contact;

pub(crate) use bodies::{Bodies, flow_shares};
pub(crate) use carried::Carried;
pub(crate) use full_film::full_film;
pub(crate) use marching::march;
pub(crate) use mixed::{Mixed, load_path, mixed};
pub(crate) use printed_deformation::printed_deformation_of;
