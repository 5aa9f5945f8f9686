//! The compiled part of the Python package `asperity`: arguments in, the functions of the library called without
//! Python's lock, arrays and JSON out. Nothing here computes; units, tables and charts are made in Python.

mod arrays;
mod case;
mod choices;
mod command;
mod contact;
mod ehl;
mod failure;
mod laws;
mod library;
mod maps;
mod oil;
mod outcome;
mod own_laws;
mod quantity;
mod stored;
mod study;
mod sweep;
mod trace;
mod work;

use pyo3::prelude::*;

/// The compiled part of the package asperity.
#[pymodule]
mod _asperity {
    #[pymodule_export]
    use super::case::{Case, schema};
    #[pymodule_export]
    use super::choices::{choices, nearest, values};
    #[pymodule_export]
    use super::command::command;
    #[pymodule_export]
    use super::contact::{press_flanks, solve_contact, subsurface_stress};
    #[pymodule_export]
    use super::ehl::ehl;
    #[pymodule_export]
    use super::failure::explain;
    #[pymodule_export]
    use super::laws::{film_thickness, friction_coefficient, hertz, thermal_reduction};
    #[pymodule_export]
    use super::library::{demo, from_rexs, gears, oils, rexs_contents, steels};
    #[pymodule_export]
    use super::maps::{Map, axis, read_map};
    #[pymodule_export]
    use super::oil::is_oil;
    #[pymodule_export]
    use super::outcome::Outcome;
    #[pymodule_export]
    use super::quantity::{si_units, to_si};
    #[pymodule_export]
    use super::stored::{diff, read_result, read_whole, summary};
    #[pymodule_export]
    use super::study::{Study, keys_of, steps, studies, study};
    #[pymodule_export]
    use super::sweep::Cases;
    #[pymodule_export]
    use super::trace::{Trace, generate, generate_like, read_profile};

    use pyo3::prelude::*;

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        asperity_paper_2022::register();
        super::failure::add_codes(module)?;
        module.add("__version__", env!("CARGO_PKG_VERSION"))
    }
}
