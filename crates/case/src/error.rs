//! The error of the orchestrator: why a case cannot be run, or a run has no result.

use std::sync::Arc;

use asperity_contact::ContactError;
use asperity_core::cancel::Cancelled;
use asperity_core::remedy::Remedy;
use asperity_core::{Code, Fault, Place};
use asperity_efficiency::EfficiencyError;
pub use asperity_flanks::error::{PositionError, UnsolvedContact};

use crate::source::case_error::CaseError;
use crate::source::source_text::Source;

/// Errors of a case or a run.
///
/// [`code`](Self::code) is stable; [`place`](Self::place) and [`remedy`](Self::remedy) are data, so that a
/// command line, a page or another language can put them in words of its own.
///
/// ```
/// use asperity_case::case::from_text;
/// let error = from_text("case.toml", "gears = 3", &|_| Ok(Vec::new())).unwrap_err();
/// assert_eq!(error.code(), "E204");
/// assert_eq!(error.place().and_then(|place| place.line), Some(1));
/// assert!(error.to_string().starts_with("case.toml:1: gears: "));
/// ```
#[derive(Debug, Clone, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The case cannot be run.
    #[error(transparent)]
    Case(#[from] Box<CaseError>),
    /// The case cannot be run, and its text is at hand to show the place.
    #[error("{error}")]
    CaseText {
        /// Cause.
        error: Box<CaseError>,
        /// The text of the case.
        text: Arc<Source>,
    },
    /// A mesh position failed; nothing is reported.
    #[error("position {number} of {count}: {source}{}", advice(source))]
    Position {
        /// Number of the position from A, counted from 1.
        number: usize,
        /// Number of positions.
        count: usize,
        /// Cause.
        source: Box<PositionError>,
    },
    /// The sums over the path failed.
    #[error(transparent)]
    Whole(#[from] Box<PositionError>),
}

impl From<EfficiencyError> for Error {
    fn from(error: EfficiencyError) -> Self {
        Self::Whole(Box::new(error.into()))
    }
}

impl From<Cancelled> for Error {
    fn from(cancelled: Cancelled) -> Self {
        Self::Whole(Box::new(cancelled.into()))
    }
}

impl From<CaseError> for Error {
    fn from(error: CaseError) -> Self {
        Self::Case(Box::new(error))
    }
}

fn advice(source: &PositionError) -> &'static str {
    match source.reason() {
        PositionError::Contact(ContactError::NotConverged { .. }) | PositionError::Ehl(_) => {
            ". No efficiency is reported"
        }
        PositionError::Fault(fault)
            if matches!(fault.code(), Code::E301 | Code::E304 | Code::E308) =>
        {
            ". No efficiency is reported"
        }
        _ => "",
    }
}

impl Error {
    /// A case error with the text that it is about, which the errors of a case share.
    #[cfg(feature = "case-files")]
    pub(crate) fn in_text(error: CaseError, text: impl Into<Arc<Source>>) -> Self {
        Self::CaseText {
            error: Box::new(error),
            text: text.into(),
        }
    }

    /// The error of the case, where the case is to blame.
    pub fn case(&self) -> Option<&CaseError> {
        match self {
            Self::Case(error) | Self::CaseText { error, .. } => Some(error),
            Self::Position { .. } | Self::Whole(_) => None,
        }
    }

    /// The error of a mesh position, where one is to blame.
    pub fn position(&self) -> Option<&PositionError> {
        match self {
            Self::Position { source, .. } | Self::Whole(source) => Some(source),
            Self::Case(_) | Self::CaseText { .. } => None,
        }
    }

    /// The rough contact that was not solved, where that is the reason.
    pub fn unsolved(&self) -> Option<&UnsolvedContact> {
        match self.position()? {
            PositionError::Unsolved(kept) => Some(kept),
            _ => None,
        }
    }

    /// Stable code of the message.
    pub fn code(&self) -> Code {
        match (self.case(), self.position()) {
            (Some(error), _) => error.code(),
            (None, Some(error)) => error.code(),
            (None, None) => Code::E501,
        }
    }

    /// Place in the case, if the error is about one.
    pub fn place(&self) -> Option<&Place> {
        self.case()?.place()
    }

    /// The text of the case, where it came from a text; [`place`](Self::place) gives the span in it.
    pub fn text(&self) -> Option<&Arc<Source>> {
        match self {
            Self::CaseText { text, .. } => Some(text),
            _ => None,
        }
    }

    /// Remedy of this error; empty where no more is known than its code says.
    pub fn remedy(&self) -> Remedy {
        match (self.case(), self.position()) {
            (Some(error), _) => error.remedy(),
            (None, Some(error)) => error.remedy(),
            (None, None) => Remedy::none(),
        }
    }

    /// The general advice of the code.
    pub fn advice(&self) -> &'static str {
        self.code().explain().remedy
    }
}

impl From<Error> for Fault {
    fn from(error: Error) -> Self {
        let fault = Self::new(error.code(), error.to_string()).with(error.remedy());
        let fault = match error.place() {
            Some(place) => fault.at(place.clone()),
            None => fault,
        };
        fault.caused_by(error)
    }
}
