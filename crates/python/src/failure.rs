//! Errors of the library as Python's `AsperityError`: code, help and place.

use asperity::Remedy;
use asperity::core::in_plain_words;
use asperity::message::{self, Code, Fault};
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{IntoPyDict, PyType};
use serde::de::DeserializeOwned;
use serde_json::Value;

/// An error as Python raises it.
#[derive(Debug)]
pub struct Failure(Fault);

impl Failure {
    /// An error of this code.
    pub fn new(code: Code, message: impl Into<String>) -> Self {
        Self(Fault::new(code, message))
    }

    /// The same error with what can be done about it, instead of the general advice of its code.
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

/// The settings in a text of JSON, or an error that names the setting and what it takes.
pub fn asked<T: DeserializeOwned>(text: &str) -> Result<T, Failure> {
    serde_json::from_str(text).map_err(|error| {
        // The user wrote no JSON, in which an error has its line; one of a value has none.
        let whole: Value = serde_json::from_str(text).unwrap_or_default();
        let error = serde_json::from_value::<T>(whole.clone())
            .err()
            .unwrap_or(error);
        Failure::new(Code::E204, in_words::<T>(&whole, &error.to_string()))
    })
}

/// The message of serde in words of Python.
fn in_words<T: DeserializeOwned>(whole: &Value, message: &str) -> String {
    if message.contains(" field `") {
        // Keywords of Python.
        return message.replace('-', "_");
    }
    let name = refused::<T>(whole, message).map_or(String::new(), |name| format!("{name}: "));
    format!("{name}{}", in_plain_words(message))
}

/// Name of the innermost setting without which the settings do not have this error.
fn refused<T: DeserializeOwned>(whole: &Value, message: &str) -> Option<String> {
    let (mut place, mut name) = (String::new(), None);
    while let Some(Value::Object(table)) = whole.pointer(&place) {
        let is_cause = |key: &&String| {
            let mut others = whole.clone();
            if let Some(Value::Object(table)) = others.pointer_mut(&place) {
                table.remove(*key);
            }
            let error = serde_json::from_value::<T>(others).err();
            error.is_none_or(|error| error.to_string() != message)
        };
        // A choice is a key in JSON, too: its name is in the message.
        let is_quoted = |key: &String| message.contains(&format!("`{key}`"));
        let Some(key) = table.keys().find(is_cause).filter(|key| !is_quoted(key)) else {
            break;
        };
        place = format!("{place}/{}", key.replace('~', "~0").replace('/', "~1"));
        name = Some(key.replace('-', "_"));
    }
    name
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
