//! The command `asperity`, whose program is this module.

use std::ffi::OsString;

use pyo3::prelude::*;

/// Runs a command line, whose first argument is the name of the program, and returns the exit status.
#[pyfunction]
pub fn command(py: Python<'_>, arguments: Vec<OsString>) -> u8 {
    py.detach(|| asperity_cli::run(arguments))
}
