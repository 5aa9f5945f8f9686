//! Errors as the page shows them: a code, a message in keys of the case, a place, help.

use asperity::message::Code;
use asperity::case::Place;
use asperity::key_words::{advice, with_keys};
use asperity::profile_io::read::ReadError;
use asperity_report::Fault;
use serde::Serialize;

/// An error with its stable code.
#[derive(Debug, Clone, Serialize)]
pub struct Failure {
    /// Stable code.
    pub code: Code,
    /// Values seen and expected, and what to write instead.
    pub message: String,
    /// General advice for the code.
    pub help: Option<String>,
    /// Place in the text of the case.
    pub place: Option<Place>,
}

impl Failure {
    /// An error of this code.
    pub fn new(code: Code, message: impl Into<String>) -> Self {
        Self {
            code,
            message: message.into(),
            help: advice(code),
            place: None,
        }
    }

    /// The error of a run of the case called `name`.
    pub fn of_run(name: &str, error: &asperity::Error) -> Self {
        let failure = Self::from(error);
        Self {
            message: format!("{name}: {}", failure.message),
            ..failure
        }
    }

    /// The error of a trace for the flank at `flank` of the case.
    pub fn of_reading(error: &ReadError, flank: &str) -> Self {
        Self::new(
            error.code(),
            with_keys(&error.to_string(), &error.remedy(), flank),
        )
    }
}

impl From<&asperity::Error> for Failure {
    fn from(error: &asperity::Error) -> Self {
        Self {
            place: error.place().cloned(),
            ..Self::new(error.code(), error.in_keys())
        }
    }
}

impl From<Fault> for Failure {
    fn from(error: Fault) -> Self {
        // No file is written, so a number that is not finite is all that can be.
        Self::new(Code::E501, error.to_string())
    }
}

impl From<serde_json::Error> for Failure {
    fn from(error: serde_json::Error) -> Self {
        Self::new(Code::E501, error.to_string())
    }
}
