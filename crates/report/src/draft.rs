//! Files and folders are written beside their place and moved there whole.
//!
//! A run that is killed leaves its draft behind, hidden; the next one that writes there removes it.

use std::fs;
use std::io;
use std::path::Path;
use std::time::Duration;

use tempfile::{NamedTempFile, TempDir};

/// How the names of drafts begin; six letters or digits follow.
const PREFIX: &str = ".asperity-";
/// How the names of drafts of files end.
const SUFFIX: &str = ".draft";
/// What drafts of folders hold. One with an older result, moved aside to be replaced, holds more.
const CONTENTS: [&str; 2] = ["result", "demo"];
/// A draft is written in seconds: after this time nobody is at it any more.
const STALE: Duration = Duration::from_secs(3600);

/// A hidden folder in `parent`, removed with everything in it when it is dropped.
///
/// # Errors
/// When the system refuses.
pub fn draft_folder(parent: &Path) -> io::Result<TempDir> {
    clear_stale(parent);
    tempfile::Builder::new().prefix(PREFIX).tempdir_in(parent)
}

/// A hidden file in `parent`, removed when it is dropped, with the permissions of any new file.
///
/// # Errors
/// When the system refuses.
pub fn draft_file(parent: &Path) -> io::Result<NamedTempFile> {
    clear_stale(parent);
    let mut builder = tempfile::Builder::new();
    builder.prefix(PREFIX).suffix(SUFFIX);
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        // Less what the user's mask takes away; a temporary file is for its owner alone otherwise.
        const ANY_NEW_FILE: u32 = 0o666;
        builder.permissions(fs::Permissions::from_mode(ANY_NEW_FILE));
    }
    builder.tempfile_in(parent)
}

/// Writes `bytes` as `file`: all of them, or nothing.
///
/// # Errors
/// When there is no folder for it, or the system refuses.
pub fn save(file: &Path, bytes: &[u8]) -> io::Result<()> {
    let parent = parent_of(file);
    if !parent.is_dir() {
        let text = format!("there is no folder {}", parent.display());
        return Err(io::Error::new(io::ErrorKind::NotFound, text));
    }
    let draft = draft_file(parent)?;
    fs::write(draft.path(), bytes)?;
    draft.persist(file).map_err(|refused| refused.error)?;
    Ok(())
}

/// The folder of `file`.
pub(crate) fn parent_of(file: &Path) -> &Path {
    match file.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    }
}

/// Removes what killed runs left in `parent`. Nothing depends on it, so a refusal is no error.
fn clear_stale(parent: &Path) {
    for entry in fs::read_dir(parent).into_iter().flatten().flatten() {
        let (path, kind) = (entry.path(), entry.file_type());
        let is_folder = kind.as_ref().is_ok_and(fs::FileType::is_dir);
        let is_file = kind.is_ok_and(|kind| kind.is_file());
        let name = entry.file_name();
        let name = name.to_str().unwrap_or_default();
        if !is_old(&entry) {
            continue;
        }
        if is_folder && is_draft(name, "") && holds_a_draft_only(&path) {
            let _ = fs::remove_dir_all(&path);
        } else if is_file && is_draft(name, SUFFIX) {
            let _ = fs::remove_file(&path);
        }
    }
}

fn is_old(entry: &fs::DirEntry) -> bool {
    let changed = entry.metadata().and_then(|metadata| metadata.modified());
    changed.is_ok_and(|at| at.elapsed().is_ok_and(|age| age > STALE))
}

fn is_draft(name: &str, suffix: &str) -> bool {
    const LETTERS: usize = 6;
    let letters = name
        .strip_prefix(PREFIX)
        .and_then(|rest| rest.strip_suffix(suffix));
    letters.is_some_and(|letters| {
        letters.len() == LETTERS && letters.bytes().all(|byte| byte.is_ascii_alphanumeric())
    })
}

fn holds_a_draft_only(folder: &Path) -> bool {
    fs::read_dir(folder).is_ok_and(|entries| {
        entries.flatten().all(|entry| {
            let name = entry.file_name();
            CONTENTS.iter().any(|known| name == *known)
        })
    })
}

#[cfg(test)]
mod tests {
    use std::time::SystemTime;

    use super::*;

    fn age(path: &Path) {
        let long_ago = SystemTime::now() - 2 * STALE;
        let file = fs::File::open(path).unwrap();
        file.set_modified(long_ago).unwrap();
    }

    #[test]
    fn old_drafts_go_and_all_else_stays() {
        let place = tempfile::tempdir().unwrap();
        let at = |name: &str| place.path().join(name);
        for folder in [
            ".asperity-abc123/result",
            ".asperity-new456/result",
            ".asperity-old789/result",
            ".asperity-old789/old",
            ".asperity-mine",
        ] {
            fs::create_dir_all(at(folder)).unwrap();
        }
        for file in [".asperity-abc123.draft", ".asperity-notes", "flank.csv"] {
            fs::write(at(file), "1").unwrap();
        }
        for name in [
            ".asperity-abc123",
            ".asperity-old789",
            ".asperity-mine",
            ".asperity-abc123.draft",
            ".asperity-notes",
            "flank.csv",
        ] {
            age(&at(name));
        }
        save(&at("out.csv"), b"2").unwrap();
        let mut names: Vec<String> = fs::read_dir(place.path())
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        // One is at work, one holds an older result, the others are not ours.
        let kept = [
            ".asperity-mine",
            ".asperity-new456",
            ".asperity-notes",
            ".asperity-old789",
            "flank.csv",
            "out.csv",
        ];
        assert_eq!(names, kept);
    }

    #[cfg(unix)]
    #[test]
    fn a_saved_file_has_the_permissions_of_any_other() {
        use std::os::unix::fs::PermissionsExt;
        let place = tempfile::tempdir().unwrap();
        let mode = |name: &str| {
            let metadata = fs::metadata(place.path().join(name)).unwrap();
            metadata.permissions().mode()
        };
        save(&place.path().join("saved"), b"1").unwrap();
        fs::write(place.path().join("plain"), b"1").unwrap();
        assert_eq!(mode("saved"), mode("plain"));
    }
}
