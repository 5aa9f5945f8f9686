//! Errors as the user sees them: a code, a place, what to do; a picture of the line on a terminal.

use std::io::{IsTerminal, Write};
use std::process::ExitCode;

use asperity::case::{Place, Source};
use miette::{Diagnostic, GraphicalReportHandler, GraphicalTheme, LabeledSpan, NamedSource};

/// An error with its stable code.
#[derive(Debug, thiserror::Error)]
#[error("{code} {message}")]
pub struct Failure {
    code: &'static str,
    message: String,
    snippet: Option<Snippet>,
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
            message: asperity_storage::printable(&message.into()).into_owned(),
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

    /// The same error, of which only the exit status is still to be told.
    pub fn told(mut self) -> Self {
        self.is_told = true;
        self
    }

    /// The same error with the place in the case file that it is about.
    pub fn at(mut self, place: Option<&Place>, source: &Source) -> Self {
        self.snippet = place.and_then(|place| {
            let span = place.span.clone()?;
            Some(Snippet {
                text: NamedSource::new(source.name(), source.text().to_owned()),
                label: LabeledSpan::at(span, "here"),
            })
        });
        self
    }

    /// The exit status: 2 bad input, 3 not converged, 4 outside the model, 5 internal fault.
    fn status(&self) -> u8 {
        match self.code {
            "E301" | "E304" => 3,
            "E302" | "E303" | "E305" => 4,
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
                "remedy": self.remedy(),
                "exit_status": self.status(),
            }
        })
    }

    /// What to do about it.
    fn remedy(&self) -> Option<&'static str> {
        let of_code = || asperity::message::explain(self.code).map(|entry| entry.remedy);
        self.own_advice.or_else(of_code)
    }

    /// With the line of the case file on a terminal, plain otherwise.
    fn rendered(&self) -> String {
        let plain = match self.remedy() {
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

impl Diagnostic for Failure {
    fn help<'a>(&'a self) -> Option<Box<dyn std::fmt::Display + 'a>> {
        Some(Box::new(self.remedy()?))
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
