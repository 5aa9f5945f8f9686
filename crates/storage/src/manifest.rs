//! Manifest of the files in a folder that this program wrote, each with its SHA-256.

use std::collections::{BTreeMap, BTreeSet};
use std::fs::{self, File};
use std::io::{self, Read};
use std::path::Path;

use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use crate::error::StorageError;

/// Name of the manifest in its folder.
pub const MANIFEST: &str = "manifest.json";

/// Files of a folder by their paths in it, with the sums they may have. While a file is replaced it has
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
            written_by: concat!("asperity ", env!("CARGO_PKG_VERSION")).to_owned(),
            sha256: BTreeMap::new(),
        }
    }

    /// Every file in `folder`.
    pub fn of(folder: &Path) -> io::Result<Self> {
        let mut manifest = Self::new();
        for name in entries(folder)? {
            let sum = sum_of_file(&folder.join(&name))?;
            manifest.sha256.insert(name, BTreeSet::from([sum]));
        }
        Ok(manifest)
    }

    /// The manifest in `folder`; none when there is none of ours.
    pub fn read(folder: &Path) -> Option<Self> {
        let file = folder.join(MANIFEST);
        let is_file = fs::symlink_metadata(&file).is_ok_and(|found| found.is_file());
        let text = fs::read_to_string(file).ok().filter(|_| is_file)?;
        let manifest: Self = serde_json::from_str(&text).ok()?;
        manifest
            .written_by
            .starts_with("asperity ")
            .then_some(manifest)
    }

    /// Bytes of the manifest.
    pub fn bytes(&self) -> Vec<u8> {
        // Strings and maps of strings are always JSON.
        let mut bytes = serde_json::to_vec_pretty(self).unwrap_or_default();
        bytes.push(b'\n');
        bytes
    }

    /// Whether every entry of `folder` is a file of this manifest as it was written.
    pub fn check(&self, folder: &Path, kind: &'static str) -> Result<(), StorageError> {
        for name in entries(folder).map_err(StorageError::io(folder))? {
            if name == MANIFEST {
                continue;
            }
            if !self.sha256.contains_key(&name) {
                return Err(StorageError::NotOurs {
                    path: folder.to_owned(),
                    kind,
                    entry: Some(name),
                });
            }
            self.check_file(folder, &name)?;
        }
        Ok(())
    }

    /// Whether `name` in `folder`, which is there, is a file of this manifest as it was written.
    pub fn check_file(&self, folder: &Path, name: &str) -> Result<(), StorageError> {
        let path = folder.join(name);
        let found = fs::symlink_metadata(&path).map_err(StorageError::io(&path))?;
        if found.is_symlink() {
            return Err(StorageError::Link { path });
        }
        let sums = self.sha256.get(name);
        let is_same = found.is_file()
            && sums.is_some_and(|sums| sum_of_file(&path).is_ok_and(|sum| sums.contains(&sum)));
        if is_same {
            Ok(())
        } else {
            Err(StorageError::Changed { path })
        }
    }

    /// Removes the files of this manifest that are as they were written, and then what is empty.
    pub fn remove_owned(&self, folder: &Path) {
        let mut folders = BTreeSet::new();
        for name in self.sha256.keys() {
            if self.check_file(folder, name).is_ok() {
                let _ = fs::remove_file(folder.join(name));
            }
            if let Some((parent, _)) = name.rsplit_once('/') {
                folders.insert(parent.to_owned());
            }
        }
        for parent in folders.iter().rev() {
            let _ = fs::remove_dir(folder.join(parent));
        }
        let is_last = entries(folder).is_ok_and(|names| names == [MANIFEST]);
        if is_last {
            let _ = fs::remove_file(folder.join(MANIFEST));
        }
        let _ = fs::remove_dir(folder);
    }
}

/// Paths of all entries in `folder` but folders that hold some, with `/` between names; links are not
/// followed.
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

/// SHA-256 of `bytes`.
pub fn sum_of(bytes: &[u8]) -> String {
    hex(&Sha256::digest(bytes))
}

fn sum_of_file(file: &Path) -> io::Result<String> {
    const CHUNK: usize = 1 << 16;
    let mut reader = File::open(file)?;
    let mut sum = Sha256::new();
    let mut buffer = vec![0; CHUNK];
    loop {
        match reader.read(&mut buffer)? {
            0 => return Ok(hex(&sum.finalize())),
            read => sum.update(&buffer[..read]),
        }
    }
}

fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}
