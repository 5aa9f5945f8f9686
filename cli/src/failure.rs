//! Errors of the command: code, position in the case file, remedy; with the line of the file on a terminal.

use std::borrow::Cow;
use std::io::{IsTerminal, Write};
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

use annotate_snippets::renderer::DecorStyle;
use annotate_snippets::{AnnotationKind, Level, Renderer};
use asperity::Error;
use asperity::case::Source;
use asperity::key_words::with_keys;
use asperity_core::{Code, Fault};
use clap::error::{ContextKind, ContextValue};

use crate::words;

/// An error as the command prints it.
#[derive(Debug)]
pub struct Failure {
    fault: Fault,
    snippet: Option<Snippet>,
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
    pub fn new(code: Code, message: impl Into<String>) -> Self {
        Fault::new(code, message).into()
    }

    /// Sets specific advice, instead of the general advice of the code.
    pub fn advising(mut self, advice: impl Into<Cow<'static, str>>) -> Self {
        self.fault = self.fault.helping(advice);
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
        Self::new(Code::E213, message).advising(advice.join("; ").replace("tip: ", ""))
    }

    /// Makes an error from an error of the library, with keys of the case file.
    pub fn from_error(error: &Error) -> Self {
        Self::saying(error, &error.to_string())
    }

    /// Makes an error from an error of the library about the case in `file`.
    pub fn about(file: &Path, error: &Error) -> Self {
        Self::saying(error, &format!("{}: {error}", file.display()))
    }

    fn saying(error: &Error, message: &str) -> Self {
        let remedy = error.remedy();
        let message = with_keys(message, &remedy, error.flank());
        // The message has the remedy.
        let fault = Fault::new(error.code(), message).with(remedy);
        let fault = fault.helping(words::advice(error.code()));
        let snippet = || {
            let (text, place) = (error.text()?, error.place()?);
            // The place may be in a file that the case names.
            let span = place.span.clone().filter(|_| place.file == text.name())?;
            Some(Snippet {
                text: Arc::clone(text),
                span,
            })
        };
        Self {
            snippet: snippet(),
            ..Self::whole(match error.place() {
                Some(place) => fault.at(place.clone()),
                None => fault,
            })
        }
    }

    fn whole(fault: Fault) -> Self {
        Self {
            fault,
            snippet: None,
            is_told: false,
        }
    }

    /// Appends text to the message.
    pub fn adding(mut self, more: &str) -> Self {
        self.fault = self.fault.adding(more);
        self
    }

    fn code(&self) -> Code {
        self.fault.code()
    }

    fn message(&self) -> Cow<'_, str> {
        asperity_storage::one_line(self.fault.message())
    }

    fn status(&self) -> u8 {
        self.code().exit_status()
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
        [Code::E109, Code::E120, Code::E136].contains(&self.code())
    }

    /// Whether the file holds several traces and none was chosen.
    pub fn is_of_several(&self) -> bool {
        self.code() == Code::E119
    }

    /// The error as JSON.
    pub fn json(&self) -> serde_json::Value {
        serde_json::json!({
            "error": {
                "code": self.code(),
                "message": self.message(),
                "remedy": self.advice(),
                "actions": self.fault.remedy(),
                "place": self.fault.place(),
                "exit_status": self.status(),
            }
        })
    }

    /// The advice of the error, its remedy in options, or the general advice of its code.
    fn advice(&self) -> String {
        let remedy = self.fault.remedy();
        match self.fault.specific_help() {
            Some(help) => help.to_owned(),
            None if remedy.is_empty() => words::advice(self.code()),
            None => format!("{}.", remedy.sentence(words::in_options)),
        }
    }

    /// The error with the line of the case file on a terminal, otherwise as plain text.
    fn rendered(&self) -> String {
        match &self.snippet {
            Some(snippet) if std::io::stderr().is_terminal() => self.pictured(snippet),
            _ => format!("{self}\n  help: {}", self.advice()),
        }
    }

    /// The error with the marked line of the case file.
    fn pictured(&self, snippet: &Snippet) -> String {
        let place = AnnotationKind::Primary.span(snippet.span.clone());
        let source =
            annotate_snippets::Snippet::source(snippet.text.text()).path(snippet.text.name());
        let title = Level::ERROR.primary_title(self.message());
        let title = title.id(self.code().as_str());
        let error = title
            .element(source.annotation(place))
            .element(Level::HELP.message(self.advice()));
        let renderer = match std::env::var_os("NO_COLOR") {
            Some(_) => Renderer::plain(),
            None => Renderer::styled(),
        };
        renderer.decor_style(DecorStyle::Unicode).render(&[error])
    }
}

impl std::fmt::Display for Failure {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} {}", self.code(), self.message())
    }
}

impl<E: Into<Fault>> From<E> for Failure {
    fn from(error: E) -> Self {
        let fault: Fault = error.into();
        match fault.cause::<Error>() {
            Some(error) => Self::saying(error, fault.message()),
            None => Self::whole(fault),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_code_has_a_remedy_and_an_exit_status() {
        for code in Code::ALL {
            let told = Failure::new(*code, "m").json();
            let error = &told["error"];
            assert_eq!(error["code"], code.as_str());
            assert!(
                error["remedy"]
                    .as_str()
                    .is_some_and(|text| text.ends_with('.')),
                "{code}"
            );
            let is_error = code.as_str().starts_with('E');
            assert_eq!(error["exit_status"] != 0, is_error, "{code}");
        }
    }

    #[test]
    fn a_remedy_in_keys_of_a_function_is_told_in_options() {
        let remedy = asperity::Remedy::state(asperity::core::Setting::Key("pressure_limit"));
        let failure = Failure::from(Fault::new(Code::E302, "m").with(remedy));
        assert_eq!(failure.rendered(), "E302 m\n  help: Pass --pressure-limit.");
    }
}
