//! Errors of reading and writing results.

use asperity_core::{Code, Fault};
use std::path::{Path, PathBuf};

use asperity_roughness::RoughnessError;
use asperity_storage::{NotFinite, StorageError};
use asperity_table::own::{OwnFault, Unwritten};

/// Error of writing or reading a result. No incomplete result is left behind.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ReportError {
    /// The target holds something else, or the system reports an error.
    #[error(transparent)]
    Storage(#[from] StorageError),
    /// A number is not finite and is not written.
    #[error("{path}: not written: {source}")]
    NotFinite {
        /// The file.
        path: PathBuf,
        /// The number.
        source: NotFinite,
    },
    /// The result is missing or was not written by Asperity.
    #[error("{path}: not a result of asperity run: {reason}")]
    NotAResult {
        /// The file.
        path: PathBuf,
        /// The reason.
        reason: &'static str,
    },
    /// The folder holds the result of a gear train, which has one for each mesh.
    #[error("{path}: the result of a gear train; name the folder of one of its meshes")]
    OfTrain {
        /// The folder.
        path: PathBuf,
    },
    /// A value of `result.json` is missing or damaged.
    #[error("{path}: not a result of asperity run: {key}: {source}")]
    Damaged {
        /// The file.
        path: PathBuf,
        /// Path of the value within it, `summary.efficiency`.
        key: String,
        /// Reason given by the reader.
        source: serde_json::Error,
    },
    /// A table next to `result.json` is missing, damaged or belongs to another result.
    #[error("{path}: not a table of this result: {reason}")]
    BadTable {
        /// The file.
        path: PathBuf,
        /// The reason.
        reason: OwnFault,
    },
    /// A model choice is neither among the inputs nor among the defaults.
    #[error("result.json: {key} is neither among the inputs nor among the defaults")]
    NoValue {
        /// Key of the case file.
        key: &'static str,
    },
    /// The position does not exist.
    #[error("position {number} is not among the {count} of the result")]
    NoSuchPosition {
        /// The requested number.
        number: usize,
        /// Number of positions.
        count: usize,
    },
    /// The fields of the position were not stored.
    #[error("the fields of position {number} were not stored{}", place.as_ref().map(|place| format!(" in {}", place.display())).unwrap_or_default())]
    NoFields {
        /// The requested number.
        number: usize,
        /// The result folder, if there is one.
        place: Option<PathBuf>,
    },
    /// A trace cannot be prepared.
    #[error(transparent)]
    Flank(#[from] RoughnessError),
    /// A value cannot be written as JSON.
    #[error("result.json: {0}")]
    Json(#[from] serde_json::Error),
    /// A row cannot be written as CSV.
    #[error("{path}: {source}")]
    Csv {
        /// The file.
        path: PathBuf,
        /// Reason given by the writer.
        source: Box<Unwritten>,
    },
}

impl ReportError {
    /// Stable code of the message.
    pub fn code(&self) -> Code {
        match self {
            Self::NotAResult { .. }
            | Self::OfTrain { .. }
            | Self::Damaged { .. }
            | Self::BadTable { .. }
            | Self::NoValue { .. }
            | Self::NoFields { .. }
            | Self::NoSuchPosition { .. } => Code::E402,
            Self::NotFinite { .. } => Code::E501,
            _ => Code::E401,
        }
    }

    /// Error of the system at `path`.
    pub(crate) fn io(path: &Path) -> impl Fn(std::io::Error) -> Self {
        let path = path.to_owned();
        move |source| {
            Self::Storage(StorageError::Io {
                path: path.clone(),
                source,
            })
        }
    }

    /// Error of a table at `path`.
    pub(crate) fn unwritten(path: &Path) -> impl Fn(Unwritten) -> Self {
        let path = path.to_owned();
        move |reason| match reason {
            Unwritten::NotFinite(source) => Self::not_finite(&path)(source),
            reason => Self::Csv {
                path: path.clone(),
                source: Box::new(reason),
            },
        }
    }

    /// Error of a number at `path`.
    pub(crate) fn not_finite(path: &Path) -> impl Fn(NotFinite) -> Self {
        let path = path.to_owned();
        move |source| Self::NotFinite {
            path: path.clone(),
            source,
        }
    }
}

impl From<ReportError> for Fault {
    fn from(error: ReportError) -> Self {
        let help = match error {
            ReportError::NoSuchPosition { .. } => {
                "Positions are numbered from 1, as in the column position of path.csv."
            }
            ReportError::NoFields { .. } => "Run the case again with this position in --fields.",
            _ => return Self::of(error.code(), error),
        };
        Self::of(error.code(), error).helping(help)
    }
}
