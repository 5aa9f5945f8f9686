//! Files written by this program in a folder that may hold others.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use asperity_core::{Code, Fault};

use super::draft::clear;
use super::error::StorageError;
use super::file::save;
use super::manifest::{MANIFEST, Manifest};
use super::system::look;
use crate::sha256;

/// Checks that the files `names` in `folder`, which are read back as a `kind`, are as this program wrote them, by the sums in
/// their manifest.
///
/// # Errors
/// When one of them is not in the manifest or was changed since.
pub fn check_written(folder: &Path, kind: &str, names: &[&str]) -> Result<(), Fault> {
    let manifest = Manifest::read(folder).unwrap_or_else(Manifest::new);
    let is_changed = |name: &&&str| manifest.check_file(folder, name).is_err();
    match names.iter().find(is_changed) {
        None => Ok(()),
        Some(name) => Err(Fault::new(
            Code::E402,
            format!(
                "{}: not the {kind} that was written: the file was changed, or its manifest.json is missing",
                folder.join(name).display()
            ),
        )),
    }
}

/// Checks that the files `names` may be written into `folder`: each is absent, or is listed in the manifest and
/// unchanged.
///
/// # Errors
/// When one of them is not in the manifest, was changed since, or is a link.
pub fn check_among(folder: &Path, names: &[&str]) -> Result<(), StorageError> {
    if folder == Path::new("-") {
        return Err(StorageError::dash());
    }
    clear(folder);
    let manifest = Manifest::read(folder).unwrap_or_else(Manifest::new);
    for name in names {
        let path = folder.join(name);
        if look(&path).map_err(StorageError::io(&path))?.is_some() {
            manifest.check_file(folder, name)?;
        }
    }
    Ok(())
}

/// Writes `files` into `folder` without touching its other files. Each file is replaced atomically; until all are
/// written the manifest lists the sums of the old and the new files.
///
/// # Errors
/// When the system refuses, or [`check_among`] fails.
///
/// ```
/// let place = tempfile::tempdir()?;
/// std::fs::write(place.path().join("notes.txt"), "mine")?;
/// let page = |text: &str| vec![("page.html".to_owned(), text.as_bytes().to_vec())];
/// asperity_storage::write_among(place.path(), &page("1"))?;
/// asperity_storage::write_among(place.path(), &page("2"))?;
/// // A file that was changed by hand is not overwritten.
/// std::fs::write(place.path().join("page.html"), "2, and my own words")?;
/// assert!(asperity_storage::write_among(place.path(), &page("3")).is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write_among(folder: &Path, files: &[(String, Vec<u8>)]) -> Result<(), StorageError> {
    let names: Vec<&str> = files.iter().map(|(name, _)| name.as_str()).collect();
    fs::create_dir_all(folder).map_err(StorageError::io(folder))?;
    check_among(folder, &names)?;
    let manifest_path = folder.join(MANIFEST);
    let is_foreign = Manifest::read(folder).is_none()
        && look(&manifest_path)
            .map_err(StorageError::io(&manifest_path))?
            .is_some();
    if is_foreign {
        return Err(StorageError::changed(&manifest_path));
    }
    let mut manifest = Manifest::read(folder).unwrap_or_else(Manifest::new);
    for (name, bytes) in files {
        let sums = manifest.sha256.entry(name.clone()).or_default();
        sums.insert(sha256(bytes));
    }
    save(&manifest_path, &manifest.bytes())?;
    for (name, bytes) in files {
        save(&folder.join(name), bytes)?;
        let only = BTreeSet::from([sha256(bytes)]);
        manifest.sha256.insert(name.clone(), only);
    }
    save(&manifest_path, &manifest.bytes())
}
