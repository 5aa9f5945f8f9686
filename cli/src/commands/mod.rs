//! One file per command.

pub mod contact;
pub mod demo;
pub mod film;
pub mod profile;
pub mod reference;
pub mod regime;
pub mod run;

use std::path::Path;

use asperity::case::{self, Formulation, LoadedCase};

use crate::args::FormulationArg;
use crate::failure::Failure;

/// Reads a case with its traces.
fn load_case(path: &Path, formulation: Option<FormulationArg>) -> Result<LoadedCase, Failure> {
    let formulation = formulation.map(|choice| match choice {
        FormulationArg::Corrected => Formulation::Corrected,
        FormulationArg::Paper => Formulation::Paper,
    });
    case::load(path, formulation).map_err(|(error, source)| {
        let failure = Failure::new(error.code(), error.to_string());
        match &source {
            Some(source) => failure.at(error.place(), source),
            None => failure,
        }
    })
}

/// A place on the path of contact as the user gave it, checked.
fn on_the_path(place: Option<f64>) -> Result<Option<f64>, Failure> {
    match place {
        Some(value) if !(0.0..=1.0).contains(&value) => Err(Failure::new(
            "E209",
            format!("--position {value}: must lie between 0 (A) and 1 (E)"),
        )),
        _ => Ok(place),
    }
}
