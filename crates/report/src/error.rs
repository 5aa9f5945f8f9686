//! Errors of reading and writing results.

use std::path::{Path, PathBuf};

use asperity_roughness::RoughnessError;

/// Reason why a result was not written or not read; nothing is left half-written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ReportError {
    /// The system refused.
    #[error("{path}: cannot be written: {source}")]
    Io {
        /// The file or folder.
        path: PathBuf,
        /// Reason given by the system.
        source: std::io::Error,
    },
    /// A file or folder is in the place that is not an older result.
    #[error(
        "{path}: exists and is not a result folder{}; choose another with -o, or remove it",
        entry.as_ref().map(|name| format!(" ({name} is no part of a result)")).unwrap_or_default()
    )]
    NotOurs {
        /// The place.
        path: PathBuf,
        /// Entry of the folder that is foreign to a result.
        entry: Option<String>,
    },
    /// A result that is not there or not one of ours.
    #[error("{path}: not a result of asperity run: {reason}")]
    NotAResult {
        /// The file.
        path: PathBuf,
        /// The reason.
        reason: &'static str,
    },
    /// A value of `result.json` that is missing or damaged.
    #[error("{path}: not a result of asperity run: {key}: {source}")]
    Damaged {
        /// The file.
        path: PathBuf,
        /// Path of the value within it, `summary.efficiency`.
        key: String,
        /// Reason given by the reader.
        source: serde_json::Error,
    },
    /// A table beside `result.json` that is missing, damaged or not of this result.
    #[error("{path}: not a table of this result: {reason}")]
    BadTable {
        /// The file.
        path: PathBuf,
        /// The reason.
        reason: TableFault,
    },
    /// A choice of the model that is neither given nor among the defaults.
    #[error("result.json: {key} is neither among the inputs nor among the defaults")]
    NoValue {
        /// Key of the case file.
        key: &'static str,
    },
    /// A position that the result does not have.
    #[error("position {number} is not among the {count} of the result")]
    NoSuchPosition {
        /// Number asked for.
        number: usize,
        /// Number of positions.
        count: usize,
    },
    /// A trace that cannot be prepared again.
    #[error(transparent)]
    Flank(#[from] RoughnessError),
    /// A value that JSON cannot hold.
    #[error("result.json: {0}")]
    Json(#[from] serde_json::Error),
    /// A row that CSV cannot hold.
    #[error("{path}: {source}")]
    Csv {
        /// The file.
        path: PathBuf,
        /// Reason given by the writer.
        source: csv::Error,
    },
}

/// Fault of a table.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum TableFault {
    /// The file cannot be opened or a row not be read.
    #[error("{0}")]
    Unreadable(#[from] csv::Error),
    /// No row.
    #[error("it has no rows")]
    Empty,
    /// A cell that is not a finite number.
    #[error("row {row}: {column} is not a finite number")]
    NotFinite {
        /// Row, from 1 below the header.
        row: usize,
        /// Name of the column.
        column: &'static str,
    },
    /// Rows that do not form a rectangular field.
    #[error("its rows are no field of equal rows over depth")]
    NotAField,
}

impl ReportError {
    /// Error of the system at `path`.
    pub(crate) fn io(path: &Path) -> impl Fn(std::io::Error) -> Self {
        let path = path.to_owned();
        move |source| Self::Io {
            path: path.clone(),
            source,
        }
    }
}
