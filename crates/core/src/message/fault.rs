//! The one kind of error that every program renders.

use std::borrow::Cow;
use std::error::Error;
use std::sync::Arc;

use super::place::Place;
use super::table::Code;
use crate::error::DomainError;
use crate::quantity::QuantityError;
use crate::remedy::Remedy;

/// An error with its stable code; it prints its message without the code.
///
/// A library that raises an error which no caller distinguishes from others makes it here; a typed error stays where a
/// caller branches on it, and becomes a fault where it is shown.
///
/// ```
/// use asperity_core::message::{Code, Fault};
/// let fault = Fault::new(Code::E209, "offsets = 1: one offset has no spread");
/// assert_eq!(fault.code(), Code::E209);
/// assert_eq!(fault.help(), "Correct the value named.");
/// let fault = fault.helping("Give at least two offsets.");
/// assert_eq!(fault.help(), "Give at least two offsets.");
/// assert_eq!(fault.about("case.toml").to_string(), "case.toml: offsets = 1: one offset has no spread");
/// ```
#[derive(Debug, Clone)]
pub struct Fault(Box<Parts>);

#[derive(Debug, Clone)]
struct Parts {
    code: Code,
    message: String,
    place: Option<Place>,
    remedy: Remedy,
    help: Option<Cow<'static, str>>,
    source: Option<Arc<dyn Error + Send + Sync>>,
}

impl Fault {
    /// An error of this code.
    pub fn new(code: Code, message: impl Into<String>) -> Self {
        Self(Box::new(Parts {
            code,
            message: message.into(),
            place: None,
            remedy: Remedy::none(),
            help: None,
            source: None,
        }))
    }

    /// An error of this code with the message of its cause.
    pub fn from_cause(code: Code, cause: impl Error + Send + Sync + 'static) -> Self {
        Self::new(code, cause.to_string()).caused_by(cause)
    }

    /// The error of a file that cannot be opened or read.
    pub fn unopened(file: impl std::fmt::Display, reason: impl std::fmt::Display) -> Self {
        Self::new(Code::E103, format!("{file}: cannot be opened: {reason}"))
    }

    /// The error of a file that cannot be written.
    pub fn unwritten(file: impl std::fmt::Display, reason: impl std::fmt::Display) -> Self {
        Self::new(Code::E401, format!("{file}: cannot be written: {reason}"))
    }

    /// An error that no input causes.
    pub fn internal(message: impl std::fmt::Display) -> Self {
        Self::new(Code::E501, message.to_string())
    }

    /// The same error at a place of a case.
    #[must_use]
    pub fn at(mut self, place: Place) -> Self {
        self.0.place = Some(place);
        self
    }

    /// The same error with what can be done about it, as data.
    #[must_use]
    pub fn with(mut self, remedy: Remedy) -> Self {
        self.0.remedy = remedy;
        self
    }

    /// The same error with advice as text, instead of the general advice of its code.
    #[must_use]
    pub fn helping(mut self, help: impl Into<Cow<'static, str>>) -> Self {
        self.0.help = Some(help.into());
        self
    }

    /// The same error with its cause.
    #[must_use]
    pub fn caused_by(mut self, cause: impl Error + Send + Sync + 'static) -> Self {
        self.0.source = Some(Arc::new(cause));
        self
    }

    /// The same error by the code of the work which it ended.
    #[must_use]
    pub fn coded(mut self, code: Code) -> Self {
        self.0.code = code;
        self
    }

    /// The same error, its message beginning with what it is about.
    #[must_use]
    pub fn about(mut self, what: impl std::fmt::Display) -> Self {
        self.0.message = format!("{what}: {}", self.0.message);
        self
    }

    /// The same error with another message.
    #[must_use]
    pub fn saying(mut self, message: impl Into<String>) -> Self {
        self.0.message = message.into();
        self
    }

    /// The same error with `more` behind its message.
    #[must_use]
    pub fn adding(mut self, more: &str) -> Self {
        self.0.message.push_str(more);
        self
    }

    /// Stable code.
    pub fn code(&self) -> Code {
        self.0.code
    }

    /// Values seen and expected.
    pub fn message(&self) -> &str {
        &self.0.message
    }

    /// Place in a case.
    pub fn place(&self) -> Option<&Place> {
        self.0.place.as_ref()
    }

    /// Remedy as data; empty if no more is known than the code says.
    pub fn remedy(&self) -> &Remedy {
        &self.0.remedy
    }

    /// Advice as text, if it is more specific than the code's.
    pub fn specific_help(&self) -> Option<&str> {
        self.0.help.as_deref()
    }

    /// The remedy in a sentence with keys, the advice of this error, or the general advice of its code; never empty.
    pub fn help(&self) -> String {
        match (&self.0.help, self.0.remedy.is_empty()) {
            (_, false) => format!("{}.", self.0.remedy),
            (Some(help), true) => help.clone().into_owned(),
            (None, true) => self.0.code.explain().remedy.to_owned(),
        }
    }

    /// The cause, if it is of type `E`.
    pub fn cause<E: Error + 'static>(&self) -> Option<&E> {
        self.0.source.as_deref()?.downcast_ref()
    }
}

impl std::fmt::Display for Fault {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.0.message)
    }
}

impl Error for Fault {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        self.0.source.as_ref().map(|cause| &**cause as _)
    }
}

/// The cause is left out: its text is in the message.
impl PartialEq for Fault {
    fn eq(&self, other: &Self) -> bool {
        let parts = |fault: &Self| {
            let Parts {
                code,
                place,
                remedy,
                help,
                message,
                ..
            } = (*fault.0).clone();
            (code, message, place, remedy, help)
        };
        parts(self) == parts(other)
    }
}

/// Defines the error of a library that no caller distinguishes from its others: a fault, whose constructors the library
/// states. A number outside its domain is one of them.
///
/// ```
/// use asperity_core::{Code, DomainError, Fault};
/// asperity_core::fault_error! {
///     /// Errors of a spring.
///     SpringError
/// }
/// let refused = DomainError::positive("stiffness", asperity_core::quantity::Length::from_si(-1.0));
/// let error = SpringError::from(refused.unwrap_err());
/// assert_eq!(error.to_string(), "stiffness = -1 m: must be finite and greater than zero");
/// assert_eq!(Fault::from(error).code(), Code::E209);
/// ```
#[macro_export]
macro_rules! fault_error {
    ($(#[$text:meta])* $name:ident) => {
        $(#[$text])*
        #[derive(Debug, Clone, PartialEq)]
        pub struct $name($crate::Fault);

        impl ::std::fmt::Display for $name {
            fn fmt(&self, f: &mut ::std::fmt::Formatter<'_>) -> ::std::fmt::Result {
                ::std::fmt::Display::fmt(&self.0, f)
            }
        }

        impl ::std::error::Error for $name {
            fn source(&self) -> Option<&(dyn ::std::error::Error + 'static)> {
                ::std::error::Error::source(&self.0)
            }
        }

        impl From<$crate::Fault> for $name {
            fn from(fault: $crate::Fault) -> Self {
                Self(fault)
            }
        }

        impl From<$crate::DomainError> for $name {
            fn from(error: $crate::DomainError) -> Self {
                Self(error.into())
            }
        }

        impl From<$name> for $crate::Fault {
            fn from(error: $name) -> Self {
                error.0
            }
        }
    };
}

impl From<DomainError> for Fault {
    fn from(error: DomainError) -> Self {
        Self::from_cause(Code::E209, error)
    }
}

impl From<QuantityError> for Fault {
    fn from(error: QuantityError) -> Self {
        Self::from_cause(Code::E204, error)
    }
}
