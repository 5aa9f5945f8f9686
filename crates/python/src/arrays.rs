//! Arrays of numpy: copied in, owned out.

use asperity::core::DomainError;
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;

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
