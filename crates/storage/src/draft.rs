//! Hidden folders in which files and folders are made before they get their names.
//!
//! A draft holds a lock on a file of its own for as long as its process lives. The system releases the lock when the
//! process ends, so the next process knows which drafts are left over. A hidden folder without such a file, with the
//! text of this program in it, is not a draft and is left alone.

use std::ffi::OsString;
use std::fs::{self, File, TryLockError};
use std::io::{self, Write as _};
use std::mem;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::Duration;

use crate::read::{regular_file, whole_text};
use crate::recovery::{self, LOCK, MAKING};
use crate::system::{look, parent_of};

/// Start of the names of drafts; six letters or digits follow.
const PREFIX: &str = ".asperity-";
const LETTERS: usize = 6;
/// Text of the lock; the number of the process and a line feed follow.
const TEXT: &str = "asperity draft of process ";
/// Bytes of the longest lock.
const LONGEST: u64 = 64;
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
    let making = folder.join(MAKING);
    let mut file = File::create_new(&making)?;
    file.lock()?;
    // In one piece: a process that is killed here leaves all of it or nothing.
    file.write_all(format!("{TEXT}{}\n", std::process::id()).as_bytes())?;
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
        if !recovery::restore(folder) {
            continue;
        }
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

/// Removes a draft whose process was killed before it had its lock: an empty folder, or one with the beginning of a
/// lock only.
fn remove_unlocked(draft: &Path) {
    let making = draft.join(MAKING);
    let is_ours = look(&making).is_ok_and(|found| found.is_some_and(|found| found.is_file()))
        && whole_text(&making, LONGEST).is_ok_and(|text| TEXT.starts_with(&text) || is_lock(&text));
    let is_alone = fs::read_dir(draft).is_ok_and(|entries| entries.count() == 1);
    if is_ours && is_alone {
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

/// Whether `lock` is one of ours that no process holds.
fn is_dead(lock: &Path) -> bool {
    // Taken for a moment: whoever holds it lives.
    let is_free = regular_file(lock).is_ok_and(|lock| match lock.try_lock() {
        Ok(()) => true,
        Err(TryLockError::WouldBlock | TryLockError::Error(_)) => false,
    });
    is_free && whole_text(lock, LONGEST).is_ok_and(|text| is_lock(&text))
}

fn is_old(entry: &fs::DirEntry) -> bool {
    let changed = entry.metadata().and_then(|found| found.modified());
    changed.is_ok_and(|at| at.elapsed().is_ok_and(|age| age > WITHOUT_LOCK))
}
