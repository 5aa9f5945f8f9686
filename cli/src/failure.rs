//! Errors of the command: code, position in the case file, remedy; with the line of the file on a terminal.

use std::io::{IsTerminal, Write};
use std::path::Path;
use std::process::ExitCode;

use asperity::case::Place;
use asperity::key_words::with_keys;
use asperity::{Error, Remedy};
use asperity_report::ReportError;
use miette::{Diagnostic, GraphicalReportHandler, GraphicalTheme, LabeledSpan, NamedSource};

use crate::words;

/// Error with its stable code.
#[derive(Debug, thiserror::Error)]
#[error("{code} {message}")]
pub struct Failure {
    code: &'static str,
    message: String,
    place: Option<Place>,
    remedy: Remedy,
    snippet: Option<Box<Snippet>>,
    /// Specific advice, in place of the general advice of the code.
    specific_advice: Option<&'static str>,
    is_told: bool,
}

#[derive(Debug)]
struct Snippet {
    text: NamedSource<String>,
    label: LabeledSpan,
}

impl Failure {
    /// Makes an error with a code.
    pub fn new(code: &'static str, message: impl Into<String>) -> Self {
        Self {
            code,
            message: asperity_storage::one_line(&message.into()).into_owned(),
            place: None,
            remedy: Remedy::none(),
            snippet: None,
            specific_advice: None,
            is_told: false,
        }
    }

    /// Sets specific advice, in place of the general advice of the code.
    pub fn advising(mut self, advice: &'static str) -> Self {
        self.specific_advice = Some(advice);
        self
    }

    /// Marks the error as printed; only its exit status is used.
    pub fn printed(mut self) -> Self {
        self.is_told = true;
        self
    }

    /// Makes an error from an error of the library, with keys of the case file.
    pub fn of(error: &Error) -> Self {
        Self::saying(error, &error.to_string())
    }

    /// Makes an error from an error of the library about the case in `file`.
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
            specific_advice: None,
            is_told: false,
        }
    }

    /// Appends text to the message.
    pub fn adding(mut self, more: &str) -> Self {
        self.message.push_str(&asperity_storage::one_line(more));
        self
    }

    /// The exit status: 2 bad input, 3 not converged, 4 outside the model, 5 internal fault.
    fn status(&self) -> u8 {
        match self.code {
            "E301" | "E304" | "E307" | "E309" | "E311" => 3,
            "E302" | "E303" | "E305" | "E306" | "E308" | "E314" | "E315" => 4,
            "E501" => 5,
            _ => 2,
        }
    }

    /// Prints the error and returns the exit status.
    pub fn report(&self, json: bool) -> ExitCode {
        if json && !self.is_told {
            // The reader may have closed the pipe; the exit status still reports the error.
            let _ = writeln!(std::io::stdout(), "{:#}", self.json());
        }
        if !self.is_told {
            self.print();
        }
        ExitCode::from(self.status())
    }

    /// Prints the error as text.
    pub fn print(&self) {
        let _ = writeln!(std::io::stderr(), "{}", self.rendered());
    }

    /// The error as JSON.
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

    /// The specific advice, or the general advice of the code.
    fn advice(&self) -> Option<String> {
        let specific = self.specific_advice.map(str::to_owned);
        specific.or_else(|| words::advice(self.code))
    }

    /// The error with the line of the case file on a terminal, otherwise as plain text.
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
