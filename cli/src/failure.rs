//! Errors of the command: code, position in the case file, remedy; with the line of the file on a terminal.

use std::borrow::Cow;
use std::io::{IsTerminal, Write};
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

use annotate_snippets::renderer::DecorStyle;
use annotate_snippets::{AnnotationKind, Level, Renderer};
use asperity::case::{Place, Source};
use asperity::key_words::with_keys;
use asperity::{Error, Remedy};
use asperity_report::ReportError;
use clap::error::{ContextKind, ContextValue};

use crate::interrupt::INTERRUPTED;
use crate::words;

/// Error with its stable code.
#[derive(Debug, thiserror::Error)]
#[error("{code} {message}")]
pub struct Failure {
    code: &'static str,
    message: String,
    place: Option<Place>,
    remedy: Remedy,
    snippet: Option<Snippet>,
    /// Specific advice, in place of the general advice of the code.
    specific_advice: Option<Cow<'static, str>>,
    is_told: bool,
}

/// The text of a case file and the bytes of it that the error is about.
#[derive(Debug)]
struct Snippet {
    text: Arc<Source>,
    span: Range<usize>,
}

/// Whether an argument, which clap takes for an option, begins a negative number.
fn is_negative_number(argument: &str) -> bool {
    let number = argument.strip_prefix('-');
    number.is_some_and(|number| number.starts_with(|c: char| c.is_ascii_digit() || c == '.'))
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
    pub fn advising(mut self, advice: impl Into<Cow<'static, str>>) -> Self {
        self.specific_advice = Some(advice.into());
        self
    }

    /// Marks the error as printed; only its exit status is used.
    pub fn printed(mut self) -> Self {
        self.is_told = true;
        self
    }

    /// Makes an error from a command line that clap refuses: its first paragraph, with its tips and the usage as advice.
    pub fn of_command_line(refusal: &clap::Error) -> Self {
        let text = refusal.render().to_string();
        let one_line = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
        let mut paragraphs = text.split("\n\n").map(one_line);
        let message = paragraphs.next().unwrap_or_default();
        // clap offers any unknown option as a value, which no command takes; `--help` has a sentence of its own below.
        let is_advice = |part: &String| {
            !part.starts_with("tip: to pass") && !part.starts_with("For more information")
        };
        let mut advice: Vec<String> = paragraphs.filter(is_advice).collect();
        let unknown = refusal.get(ContextKind::InvalidArg);
        if let Some(ContextValue::String(argument)) = unknown
            && is_negative_number(argument)
        {
            let text =
                format!("a negative value follows an equals sign, as --option=\"{argument}\"");
            advice.insert(0, text);
        }
        advice.push("--help lists commands and options.".to_owned());
        let message = message.strip_prefix("error: ").unwrap_or(&message);
        Self::new("E213", message).advising(advice.join("; ").replace("tip: ", ""))
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
            let (text, place) = (error.text()?, place?);
            // The place may be in a file that the case names.
            let span = place.span.clone().filter(|_| place.file == text.name())?;
            Some(Snippet {
                text: Arc::clone(text),
                span,
            })
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

    /// The exit status: 2 bad input, 3 not converged, 4 outside the model, 5 internal fault, 130 interrupted.
    fn status(&self) -> u8 {
        match self.code {
            "E301" | "E304" | "E307" | "E309" | "E311" => 3,
            "E302" | "E303" | "E305" | "E306" | "E308" | "E314" | "E315" => 4,
            "E501" => 5,
            "E502" => INTERRUPTED,
            _ => 2,
        }
    }

    /// Prints the error and returns the exit status.
    pub fn report(&self, json: bool) -> u8 {
        if json && !self.is_told {
            // The reader may have closed the pipe; the exit status still reports the error.
            let _ = writeln!(std::io::stdout(), "{:#}", self.json());
        }
        if !self.is_told {
            self.print();
        }
        self.status()
    }

    /// Prints the error as text.
    pub fn print(&self) {
        let _ = writeln!(std::io::stderr(), "{}", self.rendered());
    }

    /// Whether the error says why a trace that was read has no parameters.
    pub fn is_of_trace(&self) -> bool {
        ["E109", "E120", "E136"].contains(&self.code)
    }

    /// Whether the file holds several traces and none was chosen.
    pub fn is_of_several(&self) -> bool {
        self.code == "E119"
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
        let specific = self.specific_advice.as_deref().map(str::to_owned);
        specific.or_else(|| words::advice(self.code))
    }

    /// The error with the line of the case file on a terminal, otherwise as plain text.
    fn rendered(&self) -> String {
        let advice = self.advice();
        match &self.snippet {
            Some(snippet) if std::io::stderr().is_terminal() => self.pictured(snippet, advice),
            _ => match advice {
                Some(advice) => format!("{self}\n  help: {advice}"),
                None => self.to_string(),
            },
        }
    }

    /// The error with the marked line of the case file.
    fn pictured(&self, snippet: &Snippet, advice: Option<String>) -> String {
        let place = AnnotationKind::Primary.span(snippet.span.clone());
        let source =
            annotate_snippets::Snippet::source(snippet.text.text()).path(snippet.text.name());
        let title = Level::ERROR.primary_title(&self.message).id(self.code);
        let error = title
            .element(source.annotation(place))
            .elements(advice.map(|advice| Level::HELP.message(advice)));
        let renderer = match std::env::var_os("NO_COLOR") {
            Some(_) => Renderer::plain(),
            None => Renderer::styled(),
        };
        renderer.decor_style(DecorStyle::Unicode).render(&[error])
    }
}

impl From<ReportError> for Failure {
    fn from(error: ReportError) -> Self {
        let failure = Self::new(error.code(), error.to_string());
        match error {
            ReportError::NoSuchPosition { .. } => failure
                .advising("Positions are numbered from 1, as in the column position of path.csv."),
            ReportError::NoFields { .. } => {
                failure.advising("Run the case again with this position in --fields.")
            }
            _ => failure,
        }
    }
}
