//! Errors of studies.

use std::path::{Path, PathBuf};

use asperity::PositionError;
use asperity::core::did_you_mean;
use asperity_core::remedy::Remedy;
use asperity_core::{Code, Fault};
use asperity_storage::StorageError;

fn with_other_inputs(others: &[PathBuf]) -> String {
    let others: Vec<_> = others
        .iter()
        .map(|path| path.display().to_string())
        .collect();
    if others.is_empty() {
        String::new()
    } else {
        format!(
            "; parts of the study with other inputs (its case, a file that it reads, or another version of the program) are in {}",
            others.join(", ")
        )
    }
}

/// Error of running a study or merging its parts.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum SweepError {
    /// The study is not valid TOML, or has unknown keys.
    #[error("{path}: {message}")]
    Study {
        /// The file.
        path: PathBuf,
        /// Reason given by the reader.
        message: String,
    },
    /// A key of the study is not valid.
    #[error("{key}: {rule}")]
    Key {
        /// The key.
        key: String,
        /// Rule.
        rule: String,
    },
    /// No result has a column of this name.
    #[error("unknown column \"{column}\"{}", did_you_mean(.nearest.as_deref()))]
    Column {
        /// The column.
        column: String,
        /// The most similar known column.
        nearest: Option<String>,
    },
    /// The case of the study cannot be read.
    #[error("{0}")]
    Case(#[from] Box<asperity::Error>),
    /// An error that no caller distinguishes from others.
    #[error(transparent)]
    Fault(#[from] Fault),
    /// A file that a case reads has changed since the study was loaded.
    #[error("{file}: changed while the study was run; run it again")]
    Changed {
        /// The file, as named in the case.
        file: PathBuf,
    },
    /// A part is damaged or belongs to another study.
    #[error("{path}: not a part of this study: {reason}")]
    Part {
        /// The file.
        path: PathBuf,
        /// The reason.
        reason: String,
    },
    /// Cases are missing in the parts.
    #[error(
        "{missing} of {count} cases are in no part: {numbers}{}",
        with_other_inputs(.others)
    )]
    Missing {
        /// Number of cases of the study.
        count: usize,
        /// Number of missing cases.
        missing: usize,
        /// Their numbers, such as `1-4,9`.
        numbers: String,
        /// Folders of parts of the same study that were computed from other inputs.
        others: Vec<PathBuf>,
    },
    /// Two parts have different rows of one case.
    #[error("{path}: case {number} is not what another part says of it")]
    Contradiction {
        /// The file.
        path: PathBuf,
        /// Number of the case.
        number: usize,
    },
}

/// The error of a file that cannot be opened.
pub(super) fn unopened(path: &Path, reason: std::io::Error) -> SweepError {
    let fault = Fault::new(Code::E103, format!("{}: {reason}", path.display()));
    SweepError::Fault(fault.caused_by(reason))
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
    /// Stable code.
    #[must_use]
    pub fn code(&self) -> Code {
        match self {
            Self::Study { .. } => Code::E202,
            Self::Column { .. } => Code::E203,
            Self::Key { .. } => Code::E204,
            Self::Case(error) => error.code(),
            Self::Fault(fault) => fault.code(),
            Self::Missing { .. } | Self::Changed { .. } => Code::E309,
            Self::Part { .. } | Self::Contradiction { .. } => Code::E402,
        }
    }

    /// Whether the work was cancelled, and nothing failed.
    pub fn is_cancelled(&self) -> bool {
        match self {
            Self::Case(error) => error.position().is_some_and(PositionError::is_cancelled),
            _ => false,
        }
    }

    /// Whether a file cannot be read, whatever the other keys of the case are.
    pub(super) fn is_of_file(&self) -> bool {
        (Code::E101..=Code::E116).contains(&self.code())
    }

    /// Error code of a single case, for its row.
    pub(super) fn code_of_case(&self) -> Code {
        match self {
            Self::Case(error) => error.code(),
            _ => Code::E204,
        }
    }
}

impl From<asperity::Error> for SweepError {
    fn from(error: asperity::Error) -> Self {
        Self::Case(Box::new(error))
    }
}

impl From<SweepError> for Fault {
    fn from(error: SweepError) -> Self {
        match error {
            SweepError::Case(error) => (*error).into(),
            SweepError::Fault(fault) => fault,
            error @ SweepError::Changed { .. } => {
                let code = error.code();
                Self::from_cause(code, error).with(Remedy::act("run the study again"))
            }
            error => Self::from_cause(error.code(), error),
        }
    }
}

impl From<StorageError> for SweepError {
    fn from(error: StorageError) -> Self {
        Self::Fault(error.into())
    }
}
