//! Recovery of a draft whose process ended: the older folder gets its name back, what is ours goes.

use std::fs;
use std::path::Path;

use crate::manifest::Manifest;
use crate::system::{look, parent_of};

/// Kind of content made in a draft.
pub const NEW: &str = "new";
/// The older folder, moved aside for a moment where two names cannot be exchanged at once.
pub const OLD: &str = "old";
/// Name that the older folder had.
pub const JOURNAL: &str = "journal";

/// Gives a folder that was moved aside its name back, where nothing has it.
pub fn restore(draft: &Path) {
    let old = draft.join(OLD);
    if !matches!(look(&old), Ok(Some(_))) {
        return;
    }
    let Ok(name) = fs::read_to_string(draft.join(JOURNAL)) else {
        return;
    };
    let target = parent_of(draft).join(name.trim_end_matches('\n'));
    if matches!(look(&target), Ok(None)) {
        let _ = fs::rename(&old, &target);
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
        for name in [JOURNAL, "making", "lock"] {
            let _ = fs::remove_file(draft.join(name));
        }
        let _ = fs::remove_dir(draft);
    }
}
