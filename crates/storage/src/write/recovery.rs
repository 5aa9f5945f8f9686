//! Recovery of a draft whose process ended: the older folder gets its name back, and the files of this program are
//! removed.

use std::ffi::OsStr;
use std::fs;
use std::path::Path;

use super::manifest::Manifest;
use super::system::{look, parent_of};
use crate::read::whole_text;

/// The new file or folder in a draft.
pub const NEW: &str = "new";
/// The older folder, moved aside if the system cannot exchange two names atomically.
pub const OLD: &str = "old";
/// File with the name of the older folder.
pub const JOURNAL: &str = "journal";
/// The lock file of a draft, and its name until it is locked.
pub const LOCK: &str = "lock";
pub const MAKING: &str = "making";
/// Maximum size of a journal in bytes: no system allows a longer name.
const LONGEST: u64 = 1024;

/// Renames a folder that was moved aside back to its old name if that is free. Returns false if this fails, or the
/// journal is not the plain name of a folder next to the draft: the draft must then be left unchanged.
pub fn restore(draft: &Path) -> bool {
    let old = draft.join(OLD);
    match look(&old) {
        Ok(None) => return true,
        Ok(Some(entry)) if entry.is_dir() => {}
        _ => return false,
    }
    let journal = draft.join(JOURNAL);
    let is_file = look(&journal).is_ok_and(|entry| entry.is_some_and(|entry| entry.is_file()));
    let Some(name) = is_file
        .then(|| whole_text(&journal, LONGEST).ok())
        .flatten()
    else {
        return false;
    };
    if Path::new(&name).file_name() != Some(OsStr::new(&name)) {
        return false;
    }
    let target = parent_of(draft).join(name);
    match look(&target) {
        Ok(None) => fs::rename(&old, &target).is_ok(),
        Ok(Some(_)) => true,
        Err(_) => false,
    }
}

/// Restores the folder that a dead process moved aside and removes its draft.
pub fn recover(draft: &Path) {
    if restore(draft) {
        remove(draft);
    }
}

/// Removes a draft. Of an older folder in it only the files of its manifest are removed.
pub fn remove(draft: &Path) {
    for place in [NEW, OLD] {
        let place = draft.join(place);
        match look(&place) {
            Ok(Some(entry)) if entry.is_dir() => match Manifest::read(&place) {
                Some(manifest) => manifest.remove_owned(&place),
                // Unfinished: only this program has written there.
                None if place.ends_with(NEW) => {
                    let _ = fs::remove_dir_all(&place);
                }
                None => {
                    let _ = fs::remove_dir(&place);
                }
            },
            Ok(Some(_)) => {
                let _ = fs::remove_file(&place);
            }
            _ => {}
        }
    }
    if [NEW, OLD]
        .iter()
        .all(|place| matches!(look(&draft.join(place)), Ok(None)))
    {
        for name in [JOURNAL, MAKING, LOCK] {
            let _ = fs::remove_file(draft.join(name));
        }
        let _ = fs::remove_dir(draft);
    }
}
