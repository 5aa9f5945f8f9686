//! Errors as the page shows them: a code, a message in keys of the case, a place, help.

use asperity::case::Place;
use asperity::key_words::{advice, with_keys};
use asperity::message::{Code, Fault};
use asperity::profile_io::read::ReadError;
use serde::Serialize;

/// An error as the page shows it.
#[derive(Debug, Clone, Serialize)]
pub struct Failure {
    /// Stable code.
    pub code: Code,
    /// Values seen and expected, and what to write instead.
    pub message: String,
    /// The advice of the error, or the general advice of its code with its keys.
    pub help: String,
    /// Place in the text of the case.
    pub place: Option<Place>,
}

impl Failure {
    /// An error of this code.
    pub fn new(code: Code, message: impl Into<String>) -> Self {
        Fault::new(code, message).into()
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
    fn from(fault: Fault) -> Self {
        if let Some(error) = fault.cause::<asperity::Error>() {
            return error.into();
        }
        let is_general = fault.specific_help().is_none() && fault.remedy().is_empty();
        Self {
            code: fault.code(),
            message: fault.message().to_owned(),
            help: if is_general { advice(fault.code()) } else { fault.help() },
            place: fault.place().cloned(),
        }
    }
}

impl From<serde_json::Error> for Failure {
    fn from(error: serde_json::Error) -> Self {
        Fault::internal(error).into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_code_has_its_remedy() {
        for code in Code::ALL {
            let failure = Failure::new(*code, "m");
            assert!(failure.help.ends_with('.'), "{code}");
            assert!(
                !failure.help.contains("--"),
                "{code}: an option of the command"
            );
        }
    }
}
