//! Why a study cannot be run.

use std::path::PathBuf;

fn with_other_inputs(others: &[PathBuf]) -> String {
    let others: Vec<_> = others
        .iter()
        .map(|path| path.display().to_string())
        .collect();
    match others.is_empty() {
        true => String::new(),
        false => format!(
            "; parts of the study with other inputs (its case, a file that it reads, or another version of the program) are in {}",
            others.join(", ")
        ),
    }
}

/// Why a study cannot be run, or its parts not put together.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum SweepError {
    /// A file cannot be opened.
    #[error("{path}: {source}")]
    Open {
        /// The file.
        path: PathBuf,
        /// Reason given by the system.
        source: std::io::Error,
    },
    /// The study is not TOML, or has other keys.
    #[error("{path}: {message}")]
    Study {
        /// The file.
        path: PathBuf,
        /// Reason given by the reader.
        message: String,
    },
    /// A key of the study that cannot be.
    #[error("{key}: {rule}")]
    Key {
        /// The key.
        key: String,
        /// Rule.
        rule: String,
    },
    /// The case of the study cannot be read.
    #[error("{0}")]
    Case(#[from] Box<asperity::Error>),
    /// Parts cannot be written.
    #[error(transparent)]
    Storage(#[from] asperity_storage::StorageError),
    /// A table or page cannot be written.
    #[error(transparent)]
    Report(#[from] asperity_report::ReportError),
    /// A file that a case reads has another content than when the study was loaded.
    #[error("{file}: changed while the study was run; run it again")]
    Changed {
        /// The file, by the name that the case gives it.
        file: PathBuf,
    },
    /// A part that is damaged, or of another study.
    #[error("{path}: not a part of this study: {reason}")]
    Part {
        /// The file.
        path: PathBuf,
        /// The reason.
        reason: String,
    },
    /// Cases that no part holds.
    #[error(
        "{missing} of {count} cases are in no part: {numbers}{}",
        with_other_inputs(.others)
    )]
    Missing {
        /// Cases of the study.
        count: usize,
        /// Cases in no part.
        missing: usize,
        /// Their numbers, as `1-4,9`.
        numbers: String,
        /// Folders of parts of the same study that were computed from other inputs.
        others: Vec<PathBuf>,
    },
    /// Two parts that say different things of one case.
    #[error("{path}: case {number} is not what another part says of it")]
    Contradiction {
        /// The file.
        path: PathBuf,
        /// Number of the case.
        number: usize,
    },
}

impl SweepError {
    pub(super) fn key(key: &str, rule: impl Into<String>) -> Self {
        Self::Key {
            key: key.to_owned(),
            rule: rule.into(),
        }
    }
}

impl SweepError {
    /// Code of the error of a single case, for its row.
    pub(super) fn code_of_case(&self) -> String {
        match self {
            Self::Case(error) => error.code().to_owned(),
            _ => "E204".to_owned(),
        }
    }
}

impl From<asperity::Error> for SweepError {
    fn from(error: asperity::Error) -> Self {
        Self::Case(Box::new(error))
    }
}
