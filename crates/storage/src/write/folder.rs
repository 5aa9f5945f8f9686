//! Atomic writing of a folder, replacing an older one of this program.

use std::fs;
use std::io;
use std::path::Path;

use super::draft::{Draft, clear, drafts};
use super::error::StorageError;
use super::manifest::{MANIFEST, Manifest};
use super::recovery::{JOURNAL, OLD};
use super::system::{exchanged, look, parent_of, sync_folder, sync_tree};

/// Checks that a folder of this `kind` ("result") may be written as `target`: `target` does not exist, is empty, or
/// holds exactly the unchanged files of its manifest. Drafts of killed processes next to it and in it are recovered
/// first.
///
/// # Errors
/// When `target` holds other files, a file was changed since it was written, or `target` is a link.
pub fn check_folder(target: &Path, kind: &'static str) -> Result<(), StorageError> {
    if target == Path::new("-") {
        return Err(StorageError::dash());
    }
    clear(parent_of(target));
    if look(target).is_ok_and(|entry| entry.is_some_and(|entry| entry.is_dir())) {
        clear(target);
    }
    check(target, kind)
}

fn check(target: &Path, kind: &'static str) -> Result<(), StorageError> {
    let foreign = StorageError::NotOurs {
        path: target.to_owned(),
        kind,
        entry: None,
    };
    match look(target).map_err(StorageError::io(target))? {
        None => return Ok(()),
        Some(entry) if entry.is_symlink() => {
            return Err(StorageError::link(target));
        }
        Some(entry) if !entry.is_dir() => return Err(foreign),
        Some(_) => {}
    }
    Manifest::check(target, kind)
}

/// Fills a draft folder and renames it to `target`, replacing an older folder of this program.
///
/// # Errors
/// When `fill` or the system fails, or [`check_folder`] does; `target` is then unchanged.
///
/// ```
/// let place = tempfile::tempdir()?;
/// let target = place.path().join("result");
/// let with = |text: &'static str| move |folder: &std::path::Path| {
///     std::fs::write(folder.join("value.txt"), text).map_err(|source| {
///         asperity_storage::StorageError::io(folder)(source)
///     })
/// };
/// asperity_storage::replace_folder(&target, "result", with("1"))?;
/// asperity_storage::replace_folder(&target, "result", with("2"))?;
/// assert_eq!(std::fs::read_to_string(target.join("value.txt"))?, "2");
/// // A folder with a file of the user is not replaced.
/// std::fs::write(target.join("notes.txt"), "mine")?;
/// assert!(asperity_storage::replace_folder(&target, "result", with("3")).is_err());
/// assert_eq!(std::fs::read_to_string(target.join("notes.txt"))?, "mine");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn replace_folder<E: From<StorageError>>(
    target: &Path,
    kind: &'static str,
    fill: impl FnOnce(&Path) -> Result<(), E>,
) -> Result<(), E> {
    check_folder(target, kind)?;
    let draft = filled(target, fill)?;
    let refused = StorageError::io(target);
    let made = draft.made();
    let listed = || -> io::Result<()> {
        fs::write(made.join(MANIFEST), Manifest::from_folder(&made)?.bytes())?;
        sync_tree(&made)
    };
    listed().map_err(&refused)?;
    name(&draft, target, kind)?;
    Ok(())
}

/// Writes a folder that does not exist yet with these texts by name, whole or not at all.
///
/// # Errors
/// When the folder exists or cannot be written.
pub fn new_folder_of<'a>(
    target: &Path,
    texts: impl IntoIterator<Item = (&'a str, &'a str)>,
) -> Result<(), StorageError> {
    new_folder(target, |made| {
        texts.into_iter().try_for_each(|(name, text)| {
            let place = made.join(name);
            fs::write(&place, text).map_err(StorageError::io(&place))
        })
    })
}

/// Fills a draft folder and renames it to `target`, which must not exist. It gets no manifest, so this program never
/// replaces it.
///
/// # Errors
/// When `fill` or the system fails, or `target` exists.
pub fn new_folder<E: From<StorageError>>(
    target: &Path,
    fill: impl FnOnce(&Path) -> Result<(), E>,
) -> Result<(), E> {
    if target == Path::new("-") {
        return Err(StorageError::dash().into());
    }
    let refused = StorageError::io(target);
    let is_free = || match look(target) {
        Ok(None) => Ok(()),
        Ok(Some(_)) => Err(refused(io::ErrorKind::AlreadyExists.into())),
        Err(error) => Err(refused(error)),
    };
    is_free()?;
    let draft = filled(target, fill)?;
    sync_tree(&draft.made()).map_err(&refused)?;
    let naming = drafts();
    is_free()?;
    fs::rename(draft.made(), target).map_err(&refused)?;
    drop(naming);
    sync_folder(parent_of(target)).map_err(&refused)?;
    Ok(())
}

fn filled<E: From<StorageError>>(
    target: &Path,
    fill: impl FnOnce(&Path) -> Result<(), E>,
) -> Result<Draft, E> {
    let parent = parent_of(target);
    fs::create_dir_all(parent).map_err(StorageError::io(parent))?;
    let draft = Draft::beside(target).map_err(StorageError::io(parent))?;
    let made = draft.made();
    fs::create_dir(&made).map_err(StorageError::io(&made))?;
    fill(&made)?;
    Ok(draft)
}

/// Renames the folder in `draft` to `target`. An older folder is checked again after it has lost its name and is
/// removed together with the draft.
fn name(draft: &Draft, target: &Path, kind: &'static str) -> Result<(), StorageError> {
    let refused = StorageError::io(target);
    let parent = parent_of(target);
    // A signal handler must not remove the draft during the renaming.
    let _naming = drafts();
    let made = draft.made();
    if look(target).map_err(&refused)?.is_none() {
        fs::rename(&made, target).map_err(&refused)?;
        return sync_folder(parent).map_err(&refused);
    }
    check(target, kind)?;
    if exchanged(&made, target).map_err(&refused)? {
        if let Err(error) = check(&made, kind) {
            exchanged(&made, target).map_err(&refused)?;
            return Err(error);
        }
        return sync_folder(parent).map_err(&refused);
    }
    name_in_two_steps(draft, target, kind)
}

/// Moves the older folder aside, then renames the new one. The journal stores the name of the older folder for recovery
/// after a kill between the two.
fn name_in_two_steps(draft: &Draft, target: &Path, kind: &'static str) -> Result<(), StorageError> {
    let refused = StorageError::io(target);
    let (old, journal) = (draft.folder().join(OLD), draft.folder().join(JOURNAL));
    let aside = || -> io::Result<()> {
        let name = target.file_name().unwrap_or_default();
        fs::write(&journal, name.as_encoded_bytes())?;
        sync_tree(draft.folder())?;
        fs::rename(target, &old)
    };
    aside().map_err(&refused)?;
    let named = check(&old, kind).and_then(|()| fs::rename(draft.made(), target).map_err(&refused));
    if let Err(error) = named {
        fs::rename(&old, target).map_err(&refused)?;
        return Err(error);
    }
    sync_folder(parent_of(target)).map_err(&refused)
}

#[cfg(test)]
#[allow(clippy::disallowed_methods, reason = "tests read their own files")]
mod tests {
    use super::*;

    fn write(text: &'static str) -> impl Fn(&Path) -> Result<(), StorageError> {
        move |folder| fs::write(folder.join("a.txt"), text).map_err(StorageError::io(folder))
    }

    #[test]
    fn two_renames_do_what_one_exchange_does() {
        let place = tempfile::tempdir().unwrap();
        let target = place.path().join("result");
        replace_folder(&target, "result", write("1")).unwrap();
        let draft = filled(&target, write("2")).unwrap();
        let made = draft.made();
        fs::write(
            made.join(MANIFEST),
            Manifest::from_folder(&made).unwrap().bytes(),
        )
        .unwrap();
        name_in_two_steps(&draft, &target, "result").unwrap();
        assert_eq!(fs::read_to_string(target.join("a.txt")).unwrap(), "2");
        drop(draft);
        assert_eq!(fs::read_dir(place.path()).unwrap().count(), 1);
    }

    #[test]
    fn a_file_that_came_between_is_not_lost() {
        let place = tempfile::tempdir().unwrap();
        let target = place.path().join("result");
        replace_folder(&target, "result", write("1")).unwrap();
        let refused = replace_folder(&target, "result", |folder: &Path| {
            fs::write(target.join("notes.txt"), "mine").unwrap();
            write("2")(folder)
        });
        assert!(matches!(refused, Err(StorageError::NotOurs { .. })));
        assert_eq!(
            fs::read_to_string(target.join("notes.txt")).unwrap(),
            "mine"
        );
        assert_eq!(fs::read_to_string(target.join("a.txt")).unwrap(), "1");
        assert_eq!(fs::read_dir(place.path()).unwrap().count(), 1);
    }
}
