//! Errors of the library as Python's `AsperityError`: code, help and place.

use asperity::message::Code;
use asperity::case::Place;
use asperity::contact::ContactError;
use asperity::core::DomainError;
use asperity::ehl::EhlError;
use asperity::ehl_regime::RegimeError;
use asperity::error::PositionError;
use asperity::message;
use asperity::profile_io::read::ReadError;
use asperity::quantity::QuantityError;
use asperity::reference_solution::ReferenceError;
use asperity::remedy::{Remedy, Setting, Value};
use asperity::roughness::RoughnessError;
use asperity::tribo_friction::FrictionError;
use asperity_calibration::CalibrationError;
use asperity_calibration::oil::OilError;
use asperity_report::Fault;
use asperity_report::library::Fault;
use asperity_rexs::Fault;
use asperity_studies::export::Fault;
use asperity_studies::map::{Fault, Fault};
use asperity_studies::sweep::SweepError;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::PyType;

/// An error with its stable code.
#[derive(Debug)]
pub struct Failure {
    code: Code,
    message: String,
    place: Option<Place>,
    remedy: Remedy,
}

impl Failure {
    /// An error of this code.
    pub fn new(code: Code, message: impl Into<String>) -> Self {
        Self {
            code,
            message: message.into(),
            place: None,
            remedy: Remedy::none(),
        }
    }

    /// The same error with what can be done about it, in place of the general advice of its code.
    pub fn advising(self, remedy: Remedy) -> Self {
        Self { remedy, ..self }
    }

    /// The same error, its message beginning with what it is about.
    pub fn about(self, what: &str) -> Self {
        Self {
            message: format!("{what}: {}", self.message),
            ..self
        }
    }

    fn help(&self) -> String {
        if self.remedy.is_empty() {
            let known = message::explain(self.code);
            return known.map_or_else(String::new, |entry| entry.remedy.to_owned());
        }
        format!("{}.", self.remedy)
    }
}

impl From<Failure> for PyErr {
    fn from(failure: Failure) -> Self {
        Python::attach(|py| raised(py, &failure).unwrap_or_else(|error| error))
    }
}

fn raised(py: Python<'_>, failure: &Failure) -> PyResult<PyErr> {
    static CLASS: PyOnceLock<Py<PyType>> = PyOnceLock::new();
    let class = CLASS.import(py, "asperity._errors", "AsperityError")?;
    let place = failure.place.as_ref();
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
    let actions = json(&failure.remedy)?;
    let help = failure.help();
    let error = class.call1((&failure.message, failure.code, help, place, actions))?;
    Ok(PyErr::from_value(error))
}

/// The settings in a text of JSON.
pub fn asked<T: serde::de::DeserializeOwned>(text: &str) -> Result<T, Failure> {
    serde_json::from_str(text).map_err(|error| Failure::new(Code::E204, error.to_string()))
}

/// A value as JSON text.
pub fn json<T: serde::Serialize>(value: &T) -> Result<String, Failure> {
    serde_json::to_string(value).map_err(|error| Failure::new(Code::E501, error.to_string()))
}

/// Failures by the code of each error.
macro_rules! failures {
    ($($error:ty: $code:expr),+ $(,)?) => {$(
        impl From<$error> for Failure {
            fn from(error: $error) -> Self {
                let code: fn(&$error) -> &'static str = $code;
                Self::new(code(&error), error.to_string())
            }
        }
    )+};
}

failures! {
    Fault: |_| Code::E209,
    CalibrationError: CalibrationError::code,
    DomainError: |_| Code::E209,
    EhlError: EhlError::code,
    Fault: |_| Code::E205,
    FrictionError: |error| match error {
        FrictionError::MissingSetting { .. } => Code::E205,
        _ => Code::E209,
    },
    Fault: Fault::code,
    Fault: |_| Code::E402,
    OilError: OilError::code,
    QuantityError: |_| Code::E204,
    RegimeError: |error| match error {
        RegimeError::MissingInput { .. } => Code::E205,
        _ => Code::E209,
    },
    Fault: Fault::code,
    Fault: Fault::code,
    RoughnessError: |_| Code::E120,
}

impl From<asperity::Error> for Failure {
    fn from(error: asperity::Error) -> Self {
        Self {
            code: error.code(),
            message: error.to_string(),
            place: error.place().cloned(),
            remedy: error.remedy(),
        }
    }
}

impl From<PositionError> for Failure {
    fn from(error: PositionError) -> Self {
        asperity::Error::Whole(Box::new(error)).into()
    }
}

impl From<ReadError> for Failure {
    fn from(error: ReadError) -> Self {
        Self::new(error.code(), error.to_string()).advising(error.remedy())
    }
}

impl From<ContactError> for Failure {
    fn from(error: ContactError) -> Self {
        let set = |key, why: &'static str| Remedy::set(Setting::Key(key), Value::Any).because(why);
        let remedy = match error {
            ContactError::NotConverged { .. } => set("tolerance", "to a larger one (at most 1e-4)")
                .or_do("look for spikes in the gap"),
            ContactError::NotRunIn { .. } => set("tolerance", "to a smaller one")
                .or_set(Setting::Key("pressure_limit"), Value::Any)
                .because("to a higher one"),
            ContactError::LimitBelowMeanPressure { .. } => set("pressure_limit", "to a higher one")
                .or_set(Setting::Key("load"), Value::Any)
                .because("to a lower one"),
            ContactError::DatumTooNear { .. } => set("datum", "to a larger one"),
            _ => Remedy::none(),
        };
        Self::new(error.code(), error.to_string()).advising(remedy)
    }
}

impl From<ReferenceError> for Failure {
    fn from(error: ReferenceError) -> Self {
        match error {
            ReferenceError::Position(error) => error.into(),
            ReferenceError::Ehl(error) => error.into(),
            ReferenceError::NoBaseOil => Self::new(Code::E208, error.to_string()),
            error => Self::new(Code::E305, error.to_string()),
        }
    }
}

impl From<SweepError> for Failure {
    fn from(error: SweepError) -> Self {
        match error {
            SweepError::Case(error) => (*error).into(),
            error => Self::new(error.code(), error.to_string()),
        }
    }
}

/// Title, cause and remedy of a message code; none of a code that does not exist.
#[pyfunction]
pub fn explain(code: &str) -> Option<(&'static str, &'static str, &'static str)> {
    message::explain(code).map(|entry| (entry.title, entry.meaning, entry.remedy))
}
