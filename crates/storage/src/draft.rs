//! Hidden folders in which files and folders are made before they get their names.
//!
//! A draft holds a lock on a file of its own for as long as its process lives. The system takes the lock
//! away from a process that was killed, so the next one knows which drafts are left over.

use std::ffi::OsString;
use std::fs::{self, File, TryLockError};
use std::io;
use std::mem;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::Duration;

use crate::recovery;
use crate::system::{look, parent_of};

/// Start of the names of drafts; six letters or digits follow.
const PREFIX: &str = ".asperity-";
const LETTERS: usize = 6;
/// The locked file in a draft.
const LOCK: &str = "lock";
/// A draft without its lock is being made, or was killed before it was.
const WITHOUT_LOCK: Duration = Duration::from_secs(5);
/// Times that a process which is about to end tries to remove a draft, and the time between two.
const REMOVALS: usize = 100;
const BETWEEN_REMOVALS: Duration = Duration::from_millis(2);

/// Drafts of this process. Whoever holds it gives drafts their names or removes them.
static DRAFTS: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// Hidden folder beside the place of what is made in it; removed when it is dropped.
#[derive(Debug)]
pub struct Draft {
    folder: PathBuf,
    /// Held as long as the draft is at work.
    _lock: File,
}

impl Draft {
    /// Makes a draft beside `target`, and removes what killed processes left there.
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

    /// Place in the draft at which the file or folder is made.
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

/// Makes the lock of a draft under another name first, so that nobody finds it before it is held.
fn locked(folder: &Path) -> io::Result<File> {
    let making = folder.join("making");
    let file = File::create_new(&making)?;
    file.lock()?;
    fs::rename(&making, folder.join(LOCK))?;
    Ok(file)
}

/// The drafts of this process; while this is held none gets its name and none is removed.
pub(crate) fn drafts() -> MutexGuard<'static, Vec<PathBuf>> {
    DRAFTS.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Removes the drafts of this process, which is about to end: nothing gets its name after this.
pub fn abandon() {
    let drafts = drafts();
    for folder in drafts.iter() {
        recovery::restore(folder);
        // A thread that still writes there can put a file back in the middle of it.
        for _ in 0..REMOVALS {
            recovery::remove(folder);
            if matches!(look(folder), Ok(None)) {
                break;
            }
            thread::sleep(BETWEEN_REMOVALS);
        }
    }
    // Held for good: a thread that still writes must not make what nobody removes.
    mem::forget(drafts);
}

/// Restores and removes what killed processes left in `parent`. Nothing depends on it, so a refusal of
/// the system is no error.
pub(crate) fn clear(parent: &Path) {
    for entry in fs::read_dir(parent).into_iter().flatten().flatten() {
        let is_folder = entry.file_type().is_ok_and(|kind| kind.is_dir());
        if is_folder && is_draft(&entry.file_name()) && is_dead(&entry) {
            recovery::restore(&entry.path());
            recovery::remove(&entry.path());
        }
    }
}

fn is_draft(name: &OsString) -> bool {
    let letters = name.to_str().and_then(|name| name.strip_prefix(PREFIX));
    letters.is_some_and(|letters| {
        letters.len() == LETTERS && letters.bytes().all(|byte| byte.is_ascii_alphanumeric())
    })
}

fn is_dead(entry: &fs::DirEntry) -> bool {
    match File::open(entry.path().join(LOCK)) {
        // Taken for a moment: whoever holds it lives.
        Ok(lock) => match lock.try_lock() {
            Ok(()) => true,
            Err(TryLockError::WouldBlock | TryLockError::Error(_)) => false,
        },
        Err(error) if error.kind() == io::ErrorKind::NotFound => is_old(entry),
        Err(_) => false,
    }
}

fn is_old(entry: &fs::DirEntry) -> bool {
    let changed = entry.metadata().and_then(|found| found.modified());
    changed.is_ok_and(|at| at.elapsed().is_ok_and(|age| age > WITHOUT_LOCK))
}
