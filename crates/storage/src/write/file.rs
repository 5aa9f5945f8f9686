//! Atomic writing of a single file.

use std::fs::{self, File};
use std::io::{self, Write};
use std::path::Path;

use super::draft::{Draft, drafts};
use super::error::StorageError;
use super::system::{look, parent_of, sync_folder};
use crate::read::whole_file;

/// Writes `bytes` as `file`, replacing an older file of that name.
///
/// # Errors
/// When its folder does not exist, `file` is a folder or a link, or the system refuses.
///
/// ```
/// let place = tempfile::tempdir()?;
/// let file = place.path().join("flank.csv");
/// asperity_storage::save(&file, b"1\n")?;
/// asperity_storage::save(&file, b"2\n")?;
/// assert_eq!(std::fs::read(&file)?, b"2\n");
/// assert!(asperity_storage::save(&place.path().join("none/flank.csv"), b"1").is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn save(file: &Path, bytes: &[u8]) -> Result<(), StorageError> {
    let parent = parent_of(file);
    if !parent.is_dir() {
        return Err(StorageError::no_folder(file, parent));
    }
    let refused = StorageError::io(file);
    match look(file).map_err(&refused)? {
        Some(entry) if entry.is_symlink() => {
            return Err(StorageError::link(file));
        }
        Some(entry) if !entry.is_file() => {
            return Err(refused(io::ErrorKind::AlreadyExists.into()));
        }
        _ => {}
    }
    let draft = Draft::beside(file).map_err(&refused)?;
    let written = || -> io::Result<()> {
        let mut made = File::create_new(draft.made())?;
        made.write_all(bytes)?;
        made.sync_all()?;
        let naming = drafts();
        fs::rename(draft.made(), file)?;
        drop(naming);
        sync_folder(parent)
    };
    written().map_err(&refused)
}

/// Writes `bytes` as `file` if it does not exist. A file with the same bytes is accepted.
///
/// For names that the user did not choose.
///
/// # Errors
/// When `file` exists with other content, its folder does not exist, or the system refuses.
///
/// ```
/// let place = tempfile::tempdir()?;
/// let file = place.path().join("flank.svg");
/// asperity_storage::save_new(&file, b"<svg/>")?;
/// asperity_storage::save_new(&file, b"<svg/>")?;
/// assert!(asperity_storage::save_new(&file, b"<svg></svg>").is_err());
/// assert_eq!(std::fs::read(&file)?, b"<svg/>");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn save_new(file: &Path, bytes: &[u8]) -> Result<(), StorageError> {
    let Some(entry) = look(file).map_err(StorageError::io(file))? else {
        return save(file, bytes);
    };
    let is_same = entry.is_file()
        && entry.len() == bytes.len() as u64
        && whole_file(file, entry.len()).is_ok_and(|there| there == bytes);
    if is_same {
        Ok(())
    } else {
        Err(StorageError::exists(file))
    }
}
