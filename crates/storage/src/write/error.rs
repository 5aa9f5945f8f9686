//! Errors of writing.

use std::io;
use std::path::{Path, PathBuf};

/// Reason why nothing was written. Earlier files are unchanged.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum StorageError {
    /// The system refused.
    #[error("{path}: cannot be written: {source}")]
    Io {
        /// The file or folder.
        path: PathBuf,
        /// Reason given by the system.
        source: io::Error,
    },
    /// The folder for a single file does not exist.
    #[error("{path}: cannot be written: there is no folder {folder}")]
    NoFolder {
        /// The file.
        path: PathBuf,
        /// The folder.
        folder: PathBuf,
    },
    /// The place is a link, behind which something else may be.
    #[error("{path}: is a link, which is not followed; name the place itself")]
    Link {
        /// The link.
        path: PathBuf,
    },
    /// The target is a file or folder that this program did not write.
    #[error(
        "{path}: exists and is not a {kind} folder{}; choose another with -o, or remove it",
        entry.as_ref().map(|name| format!(" ({name} is not part of a {kind})")).unwrap_or_default()
    )]
    NotOurs {
        /// The place.
        path: PathBuf,
        /// Kind of folder to be written.
        kind: &'static str,
        /// Entry of the folder that this program did not write.
        entry: Option<String>,
    },
    /// A file of this program was changed after it was written.
    #[error("{path}: was changed since it was written; choose another with -o, or move it away")]
    Changed {
        /// The file.
        path: PathBuf,
    },
    /// A file exists under a name that the user did not choose.
    #[error("{path}: exists; choose another with -o, or name it with -o to replace it")]
    Exists {
        /// The file.
        path: PathBuf,
    },
    /// The target folder is `-`, which means standard output.
    #[error("-: a folder cannot go to standard output; name one with -o")]
    Dash,
}

impl StorageError {
    /// Error of the system at `path`.
    pub(crate) fn io(path: &Path) -> impl Fn(io::Error) -> Self {
        let path = path.to_owned();
        move |source| Self::Io {
            path: path.clone(),
            source,
        }
    }
}
