//! Results read back from their folders.

use std::path::PathBuf;

use asperity::result::RunResult;
use pyo3::prelude::*;

use crate::failure::{self, Failure};
use crate::work::alone;

/// The summary of a result in JSON, as the command prints it.
#[pyfunction]
pub fn summary(result: &str) -> PyResult<String> {
    let result: RunResult =
        serde_json::from_str(result).map_err(|error| Failure::new("E402", error.to_string()))?;
    Ok(asperity_report::summary(&result))
}

/// The result in a folder or a result.json, as JSON.
#[pyfunction]
pub fn read_result(py: Python<'_>, path: PathBuf) -> PyResult<String> {
    alone(py, || {
        failure::json(&asperity_report::read_result(&path)?.1)
    })
}
