//! Files of ours in a folder that may hold others.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use crate::draft::clear;
use crate::error::StorageError;
use crate::file::save;
use crate::manifest::{MANIFEST, Manifest, sum_of};
use crate::system::look;

/// Whether the files `names` may be written into `folder`: each is not there, or is of the manifest as
/// it was written.
///
/// # Errors
/// When one of them is not ours, was changed since, or is a link.
pub fn check_among(folder: &Path, names: &[&str]) -> Result<(), StorageError> {
    if folder == Path::new("-") {
        return Err(StorageError::Dash);
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

/// Writes `files` into `folder` beside whatever else is there. Each is replaced whole; the manifest
/// names the old and the new ones while that goes on.
///
/// # Errors
/// When the system refuses, or a file is not what [`check_among`] allows.
///
/// ```
/// let place = tempfile::tempdir()?;
/// std::fs::write(place.path().join("notes.txt"), "mine")?;
/// let page = |text: &str| vec![("page.html".to_owned(), text.as_bytes().to_vec())];
/// asperity_storage::write_among(place.path(), &page("1"))?;
/// asperity_storage::write_among(place.path(), &page("2"))?;
/// // One that was changed by hand is kept.
/// std::fs::write(place.path().join("page.html"), "2, and my own words")?;
/// assert!(asperity_storage::write_among(place.path(), &page("3")).is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write_among(folder: &Path, files: &[(String, Vec<u8>)]) -> Result<(), StorageError> {
    let names: Vec<&str> = files.iter().map(|(name, _)| name.as_str()).collect();
    fs::create_dir_all(folder).map_err(StorageError::io(folder))?;
    check_among(folder, &names)?;
    let place = folder.join(MANIFEST);
    let is_foreign = Manifest::read(folder).is_none()
        && look(&place).map_err(StorageError::io(&place))?.is_some();
    if is_foreign {
        return Err(StorageError::Changed { path: place });
    }
    let mut manifest = Manifest::read(folder).unwrap_or_else(Manifest::new);
    for (name, bytes) in files {
        let sums = manifest.sha256.entry(name.clone()).or_default();
        sums.insert(sum_of(bytes));
    }
    save(&place, &manifest.bytes())?;
    for (name, bytes) in files {
        save(&folder.join(name), bytes)?;
        let only = BTreeSet::from([sum_of(bytes)]);
        manifest.sha256.insert(name.clone(), only);
    }
    save(&place, &manifest.bytes())
}
