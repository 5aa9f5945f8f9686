//! One file per command.

pub mod compare;
pub mod completions;
pub mod contact;
pub mod demo;
pub mod ehl;
pub mod figures;
pub mod film;
pub mod gear;
pub mod profile;
pub mod reference;
pub mod regime;
pub mod report;
pub mod run;
mod work;

use std::path::Path;

use asperity::case::{self, Formulation, LoadedCase, PathPoint};

use crate::args::FormulationArg;
use crate::failure::Failure;

/// Reads a case with its traces.
fn load_case(path: &Path, formulation: Option<FormulationArg>) -> Result<LoadedCase, Failure> {
    let formulation = formulation.map(|choice| match choice {
        FormulationArg::Corrected => Formulation::Corrected,
        FormulationArg::Paper => Formulation::Paper,
    });
    case::load(path, formulation).map_err(|error| Failure::of(&error))
}

/// A place on the path of contact as the user gave it, 0 at A and 1 at E, checked.
fn on_the_path(loaded: &LoadedCase, place: Option<PathPoint>) -> Result<Option<f64>, Failure> {
    let Some(place) = place else {
        return Ok(None);
    };
    let fraction = place.fraction_of(loaded.case.gears.path());
    if (0.0..=1.0).contains(&fraction) {
        return Ok(Some(fraction));
    }
    Err(Failure::new(
        "E209",
        format!("--position {fraction}: must be A to E, or 0 (A) to 1 (E)"),
    ))
}
