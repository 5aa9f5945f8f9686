//! Results read back from their folders.

use std::path::PathBuf;

use asperity::message::{Code, Fault};
use asperity::result::RunResult;
use pyo3::prelude::*;

use crate::failure::{self, Failure};
use crate::work::alone;

fn parsed(result: &str) -> Result<RunResult, Failure> {
    asperity_report::parse_result(result)
        .map_err(|error| Failure::new(Code::E402, error.to_string()))
}

/// The summary of a result in JSON, as the command prints it.
#[pyfunction]
pub fn summary(result: &str) -> PyResult<String> {
    Ok(asperity_report::summary(&parsed(result)?))
}

/// Differences of two results in JSON, as JSON.
#[pyfunction]
pub fn diff(first: &str, second: &str) -> PyResult<String> {
    let found = asperity_studies::diff::diff(&parsed(first)?, &parsed(second)?);
    let found = found.map_err(Fault::internal).map_err(Failure::from)?;
    Ok(failure::json(&found)?)
}

/// Content of train.json or planetary.json about a gear train as a whole, as JSON.
#[pyfunction]
pub fn read_whole(py: Python<'_>, path: PathBuf) -> PyResult<String> {
    alone(py, || failure::json(&asperity_report::read_whole(&path)?))
}

/// The result in a folder or a result.json, as JSON.
#[pyfunction]
pub fn read_result(py: Python<'_>, path: PathBuf) -> PyResult<String> {
    alone(py, || {
        failure::json(&asperity_report::read_result(&path)?.1)
    })
}
