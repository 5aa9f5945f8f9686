//! Hidden folders in which files and folders are written before they are renamed to their final names.
//!
//! A draft contains a file that is locked as long as its process lives. The system releases the lock when the process
//! ends, so the next process recognises abandoned drafts. A hidden folder without a lock file of this program is not a
//! draft and is not touched.

use std::ffi::OsString;
use std::fs::{self, File, TryLockError};
use std::io::{self, Write as _};
use std::mem;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::Duration;

use super::recovery::{self, LOCK, MAKING};
use super::system::{look, parent_of};
use crate::read::{regular_file, whole_text};

/// Start of the names of drafts; six letters or digits follow.
const PREFIX: &str = ".asperity-";
const LETTERS: usize = 6;
/// Text of the lock; the number of the process and a line feed follow.
const TEXT: &str = "asperity draft of process ";
/// Maximum size of a lock file in bytes.
const LONGEST: u64 = 64;
/// Age from which a draft without a lock counts as abandoned: younger ones may be about to be locked.
const WITHOUT_LOCK: Duration = Duration::from_secs(5);
/// Attempts of a terminating process to remove a draft, and the pause between two attempts.
const REMOVALS: usize = 100;
const BETWEEN_REMOVALS: Duration = Duration::from_millis(2);

/// Drafts of this process. Renaming and removing a draft requires this lock.
static DRAFTS: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// Hidden folder next to its target; removed when it is dropped.
#[derive(Debug)]
pub struct Draft {
    folder: PathBuf,
    /// Locked as long as the draft exists.
    _lock: File,
}

impl Draft {
    /// Creates a draft next to `target` and removes drafts of killed processes there.
    ///
    /// # Errors
    /// When the system refuses.
    pub fn beside(target: &Path) -> io::Result<Self> {
        let parent = parent_of(target);
        clear(parent);
        let mut drafts = drafts();
        let folder = tempfile::Builder::new()
            .prefix(PREFIX)
            .rand_bytes(LETTERS)
            .tempdir_in(parent)?
            .keep();
        match locked(&folder) {
            Ok(lock) => {
                drafts.push(folder.clone());
                Ok(Self {
                    folder,
                    _lock: lock,
                })
            }
            Err(error) => {
                let _ = fs::remove_dir_all(&folder);
                Err(error)
            }
        }
    }

    /// Path in the draft at which the file or folder is written.
    #[must_use]
    pub fn made(&self) -> PathBuf {
        self.folder.join(recovery::NEW)
    }

    /// The draft itself.
    pub(crate) fn folder(&self) -> &Path {
        &self.folder
    }
}

impl Drop for Draft {
    fn drop(&mut self) {
        let mut drafts = drafts();
        recovery::remove(&self.folder);
        drafts.retain(|known| *known != self.folder);
    }
}

/// Creates and locks the lock file of a draft under a temporary name, so that it is never visible unlocked.
fn locked(folder: &Path) -> io::Result<File> {
    let making = folder.join(MAKING);
    let mut file = File::create_new(&making)?;
    file.lock()?;
    // A single write: a process killed here leaves the complete text or none.
    file.write_all(format!("{TEXT}{}\n", std::process::id()).as_bytes())?;
    fs::rename(&making, folder.join(LOCK))?;
    Ok(file)
}

/// The drafts of this process; no draft is renamed or removed while the guard lives.
pub(crate) fn drafts() -> MutexGuard<'static, Vec<PathBuf>> {
    DRAFTS.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Removes the drafts of this process before it terminates; no draft is renamed afterwards.
pub fn abandon() {
    let drafts = drafts();
    for folder in drafts.iter() {
        if !recovery::restore(folder) {
            continue;
        }
        // Another thread may still write files into the draft during the removal.
        for _ in 0..REMOVALS {
            recovery::remove(folder);
            if matches!(look(folder), Ok(None)) {
                break;
            }
            thread::sleep(BETWEEN_REMOVALS);
        }
    }
    // Never released, so that no other thread creates a draft that would not be removed.
    mem::forget(drafts);
}

/// Recovers or removes the drafts of killed processes in `parent`. Errors of the system are ignored because nothing
/// depends on it.
pub(crate) fn clear(parent: &Path) {
    for entry in fs::read_dir(parent).into_iter().flatten().flatten() {
        let is_folder = entry.file_type().is_ok_and(|kind| kind.is_dir());
        if !is_folder || !is_draft(&entry.file_name()) {
            continue;
        }
        let draft = entry.path();
        match look(&draft.join(LOCK)) {
            Ok(Some(lock)) if lock.is_file() && is_dead(&draft.join(LOCK)) => {
                recovery::recover(&draft);
            }
            Ok(None) if is_old(&entry) => remove_unlocked(&draft),
            _ => {}
        }
    }
}

/// Removes a draft whose process was killed before the lock was complete: an empty folder, or one that holds only the
/// beginning of a lock file.
fn remove_unlocked(draft: &Path) {
    let making = draft.join(MAKING);
    let is_ours = look(&making).is_ok_and(|entry| entry.is_some_and(|entry| entry.is_file()))
        && whole_text(&making, LONGEST).is_ok_and(|text| TEXT.starts_with(&text) || is_lock(&text));
    let is_only_entry = fs::read_dir(draft).is_ok_and(|entries| entries.count() == 1);
    if is_ours && is_only_entry {
        let _ = fs::remove_file(making);
    }
    let _ = fs::remove_dir(draft);
}

fn is_draft(name: &OsString) -> bool {
    let letters = name.to_str().and_then(|name| name.strip_prefix(PREFIX));
    letters.is_some_and(|letters| {
        letters.len() == LETTERS && letters.bytes().all(|byte| byte.is_ascii_alphanumeric())
    })
}

fn is_lock(text: &str) -> bool {
    let number = text
        .strip_prefix(TEXT)
        .and_then(|rest| rest.strip_suffix('\n'));
    number.is_some_and(|number| number.parse::<u32>().is_ok())
}

/// Whether `lock` is a lock file of this program that no process holds.
fn is_dead(lock: &Path) -> bool {
    // Locking fails while the owner lives; a lock obtained here is released at once.
    let is_free = regular_file(lock).is_ok_and(|lock| match lock.try_lock() {
        Ok(()) => true,
        Err(TryLockError::WouldBlock | TryLockError::Error(_)) => false,
    });
    is_free && whole_text(lock, LONGEST).is_ok_and(|text| is_lock(&text))
}

fn is_old(entry: &fs::DirEntry) -> bool {
    let changed = entry.metadata().and_then(|entry| entry.modified());
    changed.is_ok_and(|at| at.elapsed().is_ok_and(|age| age > WITHOUT_LOCK))
}
