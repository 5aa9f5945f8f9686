//! The readings of the model as strategies: every choice that a formulation makes, in one place.

mod corrected;
mod paper;
mod strategy;

pub(crate) use strategy::{Scene, Strategy};

use crate::case::Formulation;

/// The strategy of a formulation.
pub(crate) fn of(formulation: Formulation) -> &'static dyn Strategy {
    match formulation {
        Formulation::Corrected => &corrected::Corrected,
        Formulation::Paper => &paper::Paper,
    }
}
