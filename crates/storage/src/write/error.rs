//! Errors of writing.

use std::io;
use std::path::{Path, PathBuf};

use asperity_core::{Code, Fault};

/// Error of writing; earlier files are unchanged.
#[derive(Debug, Clone, thiserror::Error)]
#[non_exhaustive]
pub enum StorageError {
    /// The target exists and was not written by the program; a result never replaces another folder.
    #[error(
        "{path}: exists and is not a {kind} folder{}; choose another with -o, or remove it",
        entry.as_ref().map(|name| format!(" ({name} is not part of a {kind})")).unwrap_or_default()
    )]
    NotOurs {
        /// The target.
        path: PathBuf,
        /// The expected kind of folder.
        kind: &'static str,
        /// An entry that is not part of such a folder.
        entry: Option<String>,
    },
    /// An error that no caller distinguishes from others.
    #[error(transparent)]
    Fault(#[from] Fault),
}

impl StorageError {
    /// The error of the system at `path`.
    pub fn io(path: &Path) -> impl Fn(io::Error) -> Self {
        let path = path.to_owned();
        move |source| {
            let fault = Fault::unwritten(path.display(), &source);
            Self::Fault(fault.caused_by(source))
        }
    }

    fn refused(path: &Path, rule: &str) -> Self {
        Self::Fault(Fault::new(
            Code::E401,
            format!("{}: {rule}", path.display()),
        ))
    }

    /// A file in a folder that does not exist.
    pub(crate) fn no_folder(path: &Path, folder: &Path) -> Self {
        let folder = folder.display();
        Self::refused(
            path,
            &format!("cannot be written: there is no folder {folder}"),
        )
    }

    /// A link, which is not followed.
    pub(crate) fn link(path: &Path) -> Self {
        Self::refused(
            path,
            "is a link, which is not followed; name the place itself",
        )
    }

    /// A file that was changed since it was written.
    pub(crate) fn changed(path: &Path) -> Self {
        let rule = "was changed since it was written; choose another with -o, or move it away";
        Self::refused(path, rule)
    }

    /// A file whose name the user did not choose, and that exists.
    pub(crate) fn exists(path: &Path) -> Self {
        let rule = "exists; choose another with -o, or name it with -o to replace it";
        Self::refused(path, rule)
    }

    /// A folder on standard output.
    pub(crate) fn dash() -> Self {
        let rule = "a folder cannot go to standard output; name one with -o";
        Self::refused(Path::new("-"), rule)
    }
}

impl From<StorageError> for Fault {
    fn from(error: StorageError) -> Self {
        match error {
            StorageError::Fault(fault) => fault,
            error => Self::from_cause(Code::E401, error),
        }
    }
}
