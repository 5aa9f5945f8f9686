//! Records stored by their content.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use asperity_storage::whole_file;
use serde_json::{from_slice, to_vec};

use super::path_record::PathRecord;
use crate::reference_solution::ReferenceContact;
use asperity_case::fingerprint::Fingerprint;

/// Raised whenever the solver gives other numbers for the same contact, so that older records are not used.
const REVISION: u32 = 2;
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

    /// File of the record of `contact`, named by the fingerprint of its bodies, oil, surfaces and settings.
    pub(super) fn file(&self, contact: &ReferenceContact) -> Option<PathBuf> {
        // Debug prints every digit of a number.
        let name = Fingerprint::default()
            .with(format!("{REVISION}"))
            .with(format!("{:?}", contact.rough))
            .with(format!("{:?}", contact.record))
            .with(format!("{:?}", contact.traces))
            .with(format!("{:?}", contact.position.hertz))
            .hex();
        Some(self.folder.as_ref()?.join(format!("record-{name}.json")))
    }

    /// The record in `file`, if there is one that can be read.
    pub(super) fn find(file: &Path) -> Option<PathRecord> {
        from_slice(&whole_file(file, LARGEST).ok()?).ok()
    }

    /// Keeps `record` in `file`; a reader sees it whole or not at all.
    pub(super) fn keep(&self, file: &Path, record: &PathRecord) {
        // A cache that cannot be written costs time, and no result.
        let _ = self.written(file, record);
    }

    fn written(&self, file: &Path, record: &PathRecord) -> std::io::Result<()> {
        if let Some(folder) = &self.folder {
            fs::create_dir_all(folder)?;
        }
        let draft = file.with_extension(format!("{}.draft", std::process::id()));
        let write = || {
            let mut made = fs::File::create_new(&draft)?;
            made.write_all(&to_vec(record)?)?;
            made.sync_all()?;
            fs::rename(&draft, file)
        };
        write().inspect_err(|_| {
            let _ = fs::remove_file(&draft);
        })
    }
}
