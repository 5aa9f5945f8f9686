//! Arrays of numpy: copied in, owned out.

use asperity::core::DomainError;
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::failure::Failure;

/// Numbers of an array in any layout.
pub type Input<'py> = PyReadonlyArray1<'py, f64>;

/// A copy of the numbers, so that Python may go on with the array.
pub fn copied(array: &Input<'_>) -> Vec<f64> {
    array.as_array().to_vec()
}

/// An array that owns `values`.
pub fn owned(py: Python<'_>, values: Vec<f64>) -> Bound<'_, PyArray1<f64>> {
    values.into_pyarray(py)
}

/// Arrays by name.
pub fn columns<'py>(
    py: Python<'py>,
    all: impl IntoIterator<Item = (&'static str, Vec<f64>)>,
) -> PyResult<Bound<'py, PyDict>> {
    let arrays = PyDict::new(py);
    for (name, values) in all {
        arrays.set_item(name, owned(py, values))?;
    }
    Ok(arrays)
}

/// Arrays of one length.
pub fn same_length(arrays: &[(&'static str, usize)]) -> Result<usize, Failure> {
    let count = arrays.first().map_or(0, |(_, count)| *count);
    match arrays.iter().find(|(_, other)| *other != count) {
        None => Ok(count),
        Some((name, other)) => Err(DomainError {
            name,
            value: *other as f64,
            unit: "values",
            rule: "all arrays must be of one length",
        }
        .into()),
    }
}
