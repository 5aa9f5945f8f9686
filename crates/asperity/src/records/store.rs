//! Records stored by all that they follow from, and checked when they are read.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use asperity_ehl::GOLDEN_RECORD;
use asperity_storage::{seal, sha256, unseal, whole_file};

use super::path_record::PathRecord;
use crate::reference_solution::ReferenceContact;
use asperity_case::fingerprint::Fingerprint;

/// Bytes of the largest record that is read.
const LARGEST: u64 = 100_000_000;

/// Folder of records, each in a file named after everything that the record depends on.
///
/// A folder that cannot be read or written keeps nothing; no result depends on it.
#[derive(Debug, Clone)]
pub struct RecordStore {
    folder: Option<PathBuf>,
}

impl RecordStore {
    /// Records in `folder`, made at need; without one nothing is stored.
    #[must_use]
    pub fn new(folder: Option<PathBuf>) -> Self {
        Self { folder }
    }

    /// Name of the record of `contact`: the fingerprint of its bodies, oil, surfaces and settings.
    pub(super) fn name(contact: &ReferenceContact) -> String {
        // Debug prints every digit of a number.
        Fingerprint::default()
            .with(format!("{:?}", contact.rough))
            .with(format!("{:?}", contact.record))
            .with(format!("{:?}", contact.traces))
            .with(format!("{:?}", contact.position.hertz))
            .hex()
    }

    fn file(&self, name: &str) -> Option<PathBuf> {
        Some(self.folder.as_ref()?.join(format!("record-{name}.json")))
    }

    /// The record of this name, if it is stored, was computed by this solver, and is as it was written.
    pub(super) fn find(&self, name: &str) -> Option<PathRecord> {
        let bytes = whole_file(&self.file(name)?, LARGEST).ok()?;
        unseal(name, &version(), &bytes)
    }

    /// Stores a record; a reader sees it whole or not at all.
    pub(super) fn keep(&self, name: &str, record: &PathRecord) {
        // A cache that cannot be written costs time, and no result.
        if let Some(file) = self.file(name) {
            let _ = written(&file, name, record);
        }
    }
}

fn written(file: &Path, name: &str, record: &PathRecord) -> std::io::Result<()> {
    if let Some(folder) = file.parent() {
        fs::create_dir_all(folder)?;
    }
    let draft = file.with_extension(format!("{}.draft", std::process::id()));
    let write = || {
        let mut made = fs::File::create_new(&draft)?;
        made.write_all(&seal(name, &version(), record)?)?;
        made.sync_all()?;
        fs::rename(&draft, file)
    };
    write().inspect_err(|_| {
        let _ = fs::remove_file(&draft);
    })
}

/// Version of the solver: of the program, and of the numbers that its tests hold the solver to.
fn version() -> String {
    let golden = sha256(GOLDEN_RECORD.as_bytes());
    format!("{} {}", env!("CARGO_PKG_VERSION"), &golden[..16])
}
