//! Recovery of a draft whose process ended: the older folder gets its name back, what is ours goes.

use std::ffi::OsStr;
use std::fs;
use std::path::Path;

use crate::manifest::Manifest;
use crate::read::whole_text;
use crate::system::{look, parent_of};

/// Kind of content made in a draft.
pub const NEW: &str = "new";
/// The older folder, moved aside for a moment where two names cannot be exchanged at once.
pub const OLD: &str = "old";
/// Name that the older folder had.
pub const JOURNAL: &str = "journal";
/// The locked file of a draft, and its name until it is locked.
pub const LOCK: &str = "lock";
pub const MAKING: &str = "making";
/// Bytes of the longest journal: the longest name that a system allows.
const LONGEST: u64 = 1024;

/// Gives a folder that was moved aside its name back, where nothing has it. False where that fails, or the journal does
/// not hold the plain name of a folder beside the draft: the draft then has to stay as it is.
pub fn restore(draft: &Path) -> bool {
    let old = draft.join(OLD);
    match look(&old) {
        Ok(None) => return true,
        Ok(Some(found)) if found.is_dir() => {}
        _ => return false,
    }
    let journal = draft.join(JOURNAL);
    let is_file = look(&journal).is_ok_and(|found| found.is_some_and(|found| found.is_file()));
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

/// Restores what a dead process moved aside and removes its draft.
pub fn recover(draft: &Path) {
    if restore(draft) {
        remove(draft);
    }
}

/// Removes a draft. Of an older folder in it only files of the manifest go; whatever else somebody put
/// there stays.
pub fn remove(draft: &Path) {
    for place in [NEW, OLD] {
        let place = draft.join(place);
        match look(&place) {
            Ok(Some(found)) if found.is_dir() => match Manifest::read(&place) {
                Some(manifest) => manifest.remove_owned(&place),
                // Not finished: nobody but this program has written there.
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
