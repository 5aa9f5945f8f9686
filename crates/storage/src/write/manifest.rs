//! Manifest of the files in a folder that this program wrote, each with its SHA-256.

use std::collections::{BTreeMap, BTreeSet};
use std::fs::{self, Metadata};
use std::io::{self, Read};
use std::path::{Component, Path};

use asperity_core::PROGRAM;
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use super::error::StorageError;
use crate::hex;
use crate::read::{regular_file, whole_text};

/// Name of the manifest in its folder.
pub const MANIFEST: &str = "manifest.json";
/// Maximum size of a manifest in bytes: some 100 000 files.
const LARGEST: u64 = 20_000_000;

/// Files of a folder by their relative paths, with their permitted checksums. While a file is being replaced it has
/// two: the old and the new one.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Manifest {
    /// The program that wrote the files.
    pub written_by: String,
    /// SHA-256 of each file.
    pub sha256: BTreeMap<String, BTreeSet<String>>,
}

impl Manifest {
    /// A manifest without files.
    pub fn new() -> Self {
        Self {
            written_by: PROGRAM.to_owned(),
            sha256: BTreeMap::new(),
        }
    }

    /// The manifest of all files in `folder`.
    pub fn from_folder(folder: &Path) -> io::Result<Self> {
        let mut manifest = Self::new();
        for name in entries(folder)? {
            let sum = sum_of_file(&folder.join(&name))?;
            manifest.sha256.insert(name, BTreeSet::from([sum]));
        }
        Ok(manifest)
    }

    /// The manifest in `folder`; `None` if there is no manifest of this program, or a path in it leads out of the
    /// folder.
    pub fn read(folder: &Path) -> Option<Self> {
        let file = folder.join(MANIFEST);
        let is_file = fs::symlink_metadata(&file).is_ok_and(|entry| entry.is_file());
        let text = is_file.then(|| whole_text(&file, LARGEST).ok()).flatten()?;
        let manifest: Self = serde_json::from_str(&text).ok()?;
        let is_ours = manifest.written_by.starts_with("asperity ")
            && manifest.sha256.keys().all(|name| is_inside(name));
        is_ours.then_some(manifest)
    }

    /// Bytes of the manifest.
    pub fn bytes(&self) -> Vec<u8> {
        // Strings and maps of strings are always JSON.
        let mut bytes = serde_json::to_vec_pretty(self).unwrap_or_default();
        bytes.push(b'\n');
        bytes
    }

    /// Checks that every entry of `folder` is an unchanged file of its manifest. A folder without a manifest of this
    /// program must be empty.
    pub fn check(folder: &Path, kind: &'static str) -> Result<(), StorageError> {
        let manifest = Self::read(folder);
        for name in entries(folder).map_err(StorageError::io(folder))? {
            match &manifest {
                Some(_) if name == MANIFEST => {}
                Some(manifest) if manifest.sha256.contains_key(&name) => {
                    manifest.check_file(folder, &name)?;
                }
                _ => {
                    return Err(StorageError::NotOurs {
                        path: folder.to_owned(),
                        kind,
                        entry: Some(name),
                    });
                }
            }
        }
        Ok(())
    }

    /// Checks that the existing file `name` in `folder` is an unchanged file of this manifest.
    pub fn check_file(&self, folder: &Path, name: &str) -> Result<(), StorageError> {
        let path = folder.join(name);
        let entry = without_links(folder, name)?;
        let sums = self.sha256.get(name);
        let is_same = entry.is_file()
            && sums.is_some_and(|sums| sum_of_file(&path).is_ok_and(|sum| sums.contains(&sum)));
        if is_same {
            Ok(())
        } else {
            Err(StorageError::changed(&path))
        }
    }

    /// Removes the unchanged files of this manifest, then empty folders.
    pub fn remove_owned(&self, folder: &Path) {
        let mut folders = BTreeSet::new();
        for name in self.sha256.keys() {
            if self.check_file(folder, name).is_ok() {
                let _ = fs::remove_file(folder.join(name));
            }
            folders.extend(name.match_indices('/').map(|(end, _)| &name[..end]));
        }
        // Inner folders first; a folder that is not empty stays.
        for inner in folders.iter().rev() {
            if without_links(folder, inner).is_ok() {
                let _ = fs::remove_dir(folder.join(inner));
            }
        }
        let is_last = entries(folder).is_ok_and(|names| names == [MANIFEST]);
        if is_last {
            let _ = fs::remove_file(folder.join(MANIFEST));
        }
        let _ = fs::remove_dir(folder);
    }
}

/// Metadata of `name` in `folder`. Neither it nor one of its parent folders may be a link, which could lead out of
/// `folder`.
fn without_links(folder: &Path, name: &str) -> Result<Metadata, StorageError> {
    let mut path = folder.to_owned();
    let mut parts = Path::new(name).iter().peekable();
    loop {
        path.extend(parts.next());
        let entry = fs::symlink_metadata(&path).map_err(StorageError::io(&path))?;
        if entry.is_symlink() {
            return Err(StorageError::link(&path));
        }
        if parts.peek().is_none() {
            return Ok(entry);
        }
    }
}

/// Whether `name` is a relative path as [`entries`] writes it: plain names separated by `/`.
fn is_inside(name: &str) -> bool {
    let parts = Path::new(name).components().map(|part| match part {
        Component::Normal(part) => part.to_str(),
        _ => None,
    });
    let parts: Option<Vec<&str>> = parts.collect();
    parts.is_some_and(|parts| !parts.is_empty() && parts.join("/") == name)
}

/// Relative paths of all files, links and empty folders in `folder`, separated by `/`. Links are not followed.
fn entries(folder: &Path) -> io::Result<Vec<String>> {
    let mut names = Vec::new();
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let name = entry.file_name().to_string_lossy().into_owned();
        if entry.file_type()?.is_dir() {
            let inner = entries(&entry.path())?;
            if inner.is_empty() {
                names.push(format!("{name}/"));
            }
            names.extend(inner.into_iter().map(|inner| format!("{name}/{inner}")));
        } else {
            names.push(name);
        }
    }
    names.sort();
    Ok(names)
}

fn sum_of_file(file: &Path) -> io::Result<String> {
    const CHUNK: usize = 1 << 16;
    let mut reader = regular_file(file)?;
    let mut sum = Sha256::new();
    let mut buffer = vec![0; CHUNK];
    loop {
        match reader.read(&mut buffer)? {
            0 => return Ok(hex(&sum.finalize())),
            read => sum.update(&buffer[..read]),
        }
    }
}
