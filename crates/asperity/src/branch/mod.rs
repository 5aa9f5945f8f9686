//! What carries the load at one mesh position and one offset: the film alone, film and asperities
//! together, or, as the paper has it, surfaces lowered into each other step by step.

mod bodies;
mod full_film;
mod marching;
mod mixed;
mod printed_deformation;

pub(crate) use bodies::Bodies;
pub(crate) use full_film::full_film;
pub(crate) use marching::march;
pub(crate) use mixed::{Mixed, load_path, mixed};
pub(crate) use printed_deformation::printed_deformation;

use asperity_contact::ContactSolution;

use crate::result::HistoryRow;

/// Pressures along a contact, and the solution of the solids where they touch.
#[derive(Debug, Clone)]
pub(crate) struct Carried {
    /// Pressure in the film \[Pa\].
    pub fluid: Vec<f64>,
    /// Solution of the rough contact; none in full film.
    pub solids: Option<ContactSolution>,
    /// How the solution was approached.
    pub history: Vec<HistoryRow>,
}

/// Points at which the load path is recorded, besides the full load.
pub(crate) const LOAD_PATH_POINTS: usize = 8;
