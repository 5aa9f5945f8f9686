//! Errors of the library as Python's `AsperityError`: code, help and place.

use asperity::Remedy;
use asperity::message::{self, Code, Fault};
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{IntoPyDict, PyType};

/// An error as Python raises it.
#[derive(Debug)]
pub struct Failure(Fault);

impl Failure {
    /// An error of this code.
    pub fn new(code: Code, message: impl Into<String>) -> Self {
        Self(Fault::new(code, message))
    }

    /// The same error with what can be done about it, in place of the general advice of its code.
    pub fn advising(self, remedy: Remedy) -> Self {
        Self(self.0.with(remedy))
    }

    /// The same error, its message beginning with what it is about.
    pub fn about(self, what: &str) -> Self {
        Self(self.0.about(what))
    }
}

impl<E: Into<Fault>> From<E> for Failure {
    fn from(error: E) -> Self {
        Self(error.into())
    }
}

impl From<Failure> for PyErr {
    fn from(failure: Failure) -> Self {
        Python::attach(|py| raised(py, &failure.0).unwrap_or_else(|error| error))
    }
}

fn raised(py: Python<'_>, fault: &Fault) -> PyResult<PyErr> {
    static CLASS: PyOnceLock<Py<PyType>> = PyOnceLock::new();
    let class = CLASS.import(py, "asperity._errors", "AsperityError")?;
    let place = fault.place();
    let place = place.map(|place| {
        let mesh = place.mesh.clone();
        (
            place.file.clone(),
            place.key.clone(),
            place.line,
            place.column,
            mesh,
        )
    });
    let actions = json(fault.remedy())?;
    let error = class.call1((
        fault.message(),
        fault.code().as_str(),
        fault.help(),
        place,
        actions,
    ))?;
    Ok(PyErr::from_value(error))
}

/// The settings in a text of JSON.
pub fn asked<T: serde::de::DeserializeOwned>(text: &str) -> Result<T, Failure> {
    // The user wrote no JSON, in which there would be such a line.
    let of_value = |error: serde_json::Error| {
        let place = format!(" at line {} column {}", error.line(), error.column());
        let text = error.to_string();
        text.strip_suffix(&place).unwrap_or(&text).to_owned()
    };
    serde_json::from_str(text).map_err(|error| Failure::new(Code::E204, of_value(error)))
}

/// A value as JSON text.
pub fn json<T: serde::Serialize>(value: &T) -> Result<String, Failure> {
    serde_json::to_string(value).map_err(|error| Failure::from(Fault::internal(error)))
}

/// Title, cause and remedy of a message code; none of a code that does not exist.
#[pyfunction]
pub fn explain(code: &str) -> Option<(&'static str, &'static str, &'static str)> {
    message::explain(code).map(|entry| (entry.title, entry.meaning, entry.remedy))
}

/// Adds the namespace `Code`, with an attribute for each code of the table of messages.
pub fn add_codes(module: &Bound<'_, PyModule>) -> PyResult<()> {
    let codes = Code::ALL.iter().map(|code| (code.as_str(), code.as_str()));
    let namespace = module.py().import("types")?.getattr("SimpleNamespace")?;
    module.add(
        "Code",
        namespace.call((), Some(&codes.into_py_dict(module.py())?))?,
    )
}
