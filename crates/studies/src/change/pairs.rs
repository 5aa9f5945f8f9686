//! Pairs of traces of one place, and the case of the gears that they are of.

use asperity::case::LoadedCase;
use asperity::message::Warning;
use asperity_core::Profile;
use asperity_report::{Input, Setting};

/// Traces of one place before and after a test.
#[derive(Debug, Clone)]
pub struct TracePair {
    /// Names of both.
    pub names: [String; 2],
    /// Both traces.
    pub traces: [Profile; 2],
    /// Warnings of their readers.
    pub warnings: Vec<Warning>,
}

impl TracePair {
    /// A pair of traces with their names, read without a warning.
    pub fn new(names: [&str; 2], traces: [Profile; 2]) -> Self {
        Self {
            names: names.map(str::to_owned),
            traces,
            warnings: Vec::new(),
        }
    }
}

/// Pairs of traces, each of one place.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct TracePairs {
    /// The pairs.
    pub pairs: Vec<TracePair>,
    /// Case of the gears on which the test was.
    pub case: Option<LoadedCase>,
}

impl TracePairs {
    /// Pairs without a case.
    #[must_use]
    pub fn new(pairs: Vec<TracePair>) -> Self {
        Self { pairs, case: None }
    }

    /// The pairs on gears of a case.
    #[must_use]
    pub fn on(self, case: LoadedCase) -> Self {
        Self {
            case: Some(case),
            ..self
        }
    }
}

impl Input for TracePairs {
    fn described() -> Vec<Setting> {
        let traces = |name, about| Setting::new(name, "Vec<Trace>", about, None);
        vec![
            traces("before", "One or several traces before the test"),
            traces("after", "The traces of the same places after it"),
            Setting::new(
                "case",
                "Option<Case>",
                "Case of the gears, whose loss before and after the test is then compared",
                None,
            ),
        ]
    }

    fn title(&self) -> String {
        match &self.pairs[..] {
            [pair] => format!("{} after {}", pair.names[1], pair.names[0]),
            [first, rest @ ..] => format!(
                "{} after {}, and {} more pair{}",
                first.names[1],
                first.names[0],
                rest.len(),
                if rest.len() == 1 { "" } else { "s" }
            ),
            [] => String::new(),
        }
    }
}
