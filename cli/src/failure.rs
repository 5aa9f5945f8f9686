//! Errors as the user sees them: a code, a place, what to do; a picture of the line on a terminal.

use std::io::{IsTerminal, Write};
use std::path::Path;
use std::process::ExitCode;

use asperity::case::Place;
use asperity::key_words::with_keys;
use asperity::{Error, Remedy};
use asperity_report::ReportError;
use miette::{Diagnostic, GraphicalReportHandler, GraphicalTheme, LabeledSpan, NamedSource};

use crate::words;

/// An error with its stable code.
#[derive(Debug, thiserror::Error)]
#[error("{code} {message}")]
pub struct Failure {
    code: &'static str,
    message: String,
    place: Option<Place>,
    remedy: Remedy,
    snippet: Option<Box<Snippet>>,
    /// Advice of its own, in place of that of its code.
    own_advice: Option<&'static str>,
    is_told: bool,
}

#[derive(Debug)]
struct Snippet {
    text: NamedSource<String>,
    label: LabeledSpan,
}

impl Failure {
    /// An error of this code.
    pub fn new(code: &'static str, message: impl Into<String>) -> Self {
        Self {
            code,
            message: asperity_storage::one_line(&message.into()).into_owned(),
            place: None,
            remedy: Remedy::none(),
            snippet: None,
            own_advice: None,
            is_told: false,
        }
    }

    /// The same error with advice that fits its command better than that of its code.
    pub fn advising(mut self, advice: &'static str) -> Self {
        self.own_advice = Some(advice);
        self
    }

    /// The same error, already printed, for its exit status alone.
    pub fn told(mut self) -> Self {
        self.is_told = true;
        self
    }

    /// An error of the orchestrator, in the words of the case file.
    pub fn of(error: &Error) -> Self {
        Self::saying(error, &error.to_string())
    }

    /// An error of the orchestrator about the case in `file`.
    pub fn about(file: &Path, error: &Error) -> Self {
        Self::saying(error, &format!("{}: {error}", file.display()))
    }

    fn saying(error: &Error, message: &str) -> Self {
        let place = error.place();
        let remedy = error.remedy();
        let snippet = || {
            let (text, span) = (error.text()?, place?.span.clone()?);
            Some(Box::new(Snippet {
                text: NamedSource::new(text.name(), text.text().to_owned()),
                label: LabeledSpan::at(span, "here"),
            }))
        };
        Self {
            code: error.code(),
            message: asperity_storage::one_line(&with_keys(message, &remedy, error.flank()))
                .into_owned(),
            place: place.cloned(),
            remedy,
            snippet: snippet(),
            own_advice: None,
            is_told: false,
        }
    }

    /// The same error with text appended.
    pub fn adding(mut self, more: &str) -> Self {
        self.message.push_str(&asperity_storage::one_line(more));
        self
    }

    /// The exit status: 2 bad input, 3 not converged, 4 outside the model, 5 internal fault.
    fn status(&self) -> u8 {
        match self.code {
            "E301" | "E304" | "E307" | "E309" | "E311" => 3,
            "E302" | "E303" | "E305" | "E306" | "E308" | "E314" => 4,
            "E501" => 5,
            _ => 2,
        }
    }

    /// Prints the error and gives the exit status.
    pub fn report(&self, json: bool) -> ExitCode {
        if json && !self.is_told {
            // Whoever reads may have gone away; the exit status still tells.
            let _ = writeln!(std::io::stdout(), "{:#}", self.json());
        }
        if !self.is_told {
            self.tell();
        }
        ExitCode::from(self.status())
    }

    /// Prints the error for reading.
    pub fn tell(&self) {
        let _ = writeln!(std::io::stderr(), "{}", self.rendered());
    }

    /// The error for programs.
    pub fn json(&self) -> serde_json::Value {
        serde_json::json!({
            "error": {
                "code": self.code,
                "message": self.message,
                "remedy": self.advice(),
                "actions": self.remedy,
                "place": self.place,
                "exit_status": self.status(),
            }
        })
    }

    /// The advice of its own, or the general advice of its code.
    fn advice(&self) -> Option<String> {
        let own = self.own_advice.map(str::to_owned);
        own.or_else(|| words::advice(self.code))
    }

    /// With the line of the case file on a terminal, plain otherwise.
    fn rendered(&self) -> String {
        let plain = match self.advice() {
            Some(remedy) => format!("{self}\n  help: {remedy}"),
            None => self.to_string(),
        };
        if self.snippet.is_none() || !std::io::stderr().is_terminal() {
            return plain;
        }
        let theme = match std::env::var_os("NO_COLOR") {
            Some(_) => GraphicalTheme::unicode_nocolor(),
            None => GraphicalTheme::unicode(),
        };
        let mut picture = String::new();
        match GraphicalReportHandler::new_themed(theme).render_report(&mut picture, self) {
            Ok(()) => picture,
            Err(_) => plain,
        }
    }
}

impl From<ReportError> for Failure {
    fn from(error: ReportError) -> Self {
        Self::new(error.code(), error.to_string())
    }
}

impl Diagnostic for Failure {
    fn help<'a>(&'a self) -> Option<Box<dyn std::fmt::Display + 'a>> {
        Some(Box::new(self.advice()?))
    }

    fn source_code(&self) -> Option<&dyn miette::SourceCode> {
        self.snippet
            .as_ref()
            .map(|snippet| &snippet.text as &dyn miette::SourceCode)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        let snippet = self.snippet.as_ref()?;
        Some(Box::new(std::iter::once(snippet.label.clone())))
    }
}
