//! Sources of the files that a case names: a folder, or memory.

use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use asperity_core::Profile;
use asperity_profile_io::read::conditions_of;
use asperity_storage::whole_file;

use super::error::CaseError;
use super::input::CaseInput;
use super::source::Source;
use super::trace_list::{TraceList, matches};

pub(super) const FILE_OF_PINION: &str = "surface.pinion.file";
pub(super) const FILE_OF_WHEEL: &str = "surface.wheel.file";
pub(super) const FILE_OF_COAST_PINION: &str = "surface.coast.pinion.file";
pub(super) const FILE_OF_COAST_WHEEL: &str = "surface.coast.wheel.file";
pub(super) const TRACES_OF_PINION: &str = "surface.pinion.traces";
pub(super) const TRACES_OF_WHEEL: &str = "surface.wheel.traces";
pub(super) const TRACES_OF_COAST_PINION: &str = "surface.coast.pinion.traces";
pub(super) const TRACES_OF_COAST_WHEEL: &str = "surface.coast.wheel.traces";
pub(super) const LOSS_TABLE: &str = "gearbox.loss_table";
pub(super) const XU_COEFFICIENTS: &str = "model.xu_coefficients";

/// Bytes of the largest file that a case may name.
const LARGEST: u64 = 1_000_000_000;

/// Content behind the name of a file.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Content {
    /// The bytes of a file.
    Bytes(Arc<[u8]>),
    /// A trace that is known already.
    Heights(Arc<Profile>),
}

/// The files of a case by the names that the case gives them.
#[derive(Debug, Clone, Default)]
pub(super) struct Files {
    /// Folder that names are relative to; none where only memory is asked.
    folder: Option<PathBuf>,
    held: BTreeMap<PathBuf, Content>,
}

impl Files {
    /// Files on disk, relative to `folder`.
    pub(super) fn in_folder(folder: &Path) -> Self {
        Self {
            folder: Some(folder.to_owned()),
            held: BTreeMap::new(),
        }
    }

    /// Files in memory: those that `input` names, as `resolver` gives them.
    pub(super) fn gathered(
        input: &CaseInput,
        source: &Source,
        resolver: &dyn Fn(&str) -> io::Result<Vec<u8>>,
    ) -> Result<Self, CaseError> {
        let coast = input.surface.coast.as_ref();
        let flanks = [
            (
                [FILE_OF_PINION, TRACES_OF_PINION],
                Some(&input.surface.pinion),
            ),
            (
                [FILE_OF_WHEEL, TRACES_OF_WHEEL],
                input.surface.wheel.as_ref(),
            ),
            (
                [FILE_OF_COAST_PINION, TRACES_OF_COAST_PINION],
                coast.map(|coast| &coast.pinion),
            ),
            (
                [FILE_OF_COAST_WHEEL, TRACES_OF_COAST_WHEEL],
                coast.and_then(|coast| coast.wheel.as_ref()),
            ),
        ];
        let mut named: Vec<(&'static str, PathBuf)> = Vec::new();
        for ([file, traces], flank) in flanks {
            let Some(flank) = flank else { continue };
            named.extend(flank.file.iter().map(|name| (file, name.clone())));
            let listed = flank.traces.iter().flat_map(TraceList::files);
            named.extend(listed.map(|name| (traces, name)));
        }
        let xu = input.model.xu_coefficients.iter();
        named.extend(xu.map(|name| (XU_COEFFICIENTS, name.clone())));
        let gearbox = input.gearbox.as_ref();
        let table = gearbox.and_then(|gearbox| gearbox.loss_table.clone());
        named.extend(table.map(|name| (LOSS_TABLE, name)));
        let mut files = Self::default();
        for (key, name) in &named {
            if files.held.contains_key(name) {
                continue;
            }
            let file = name.display().to_string();
            let bytes = resolver(&file).map_err(|reason| CaseError::OpenNamed {
                file,
                place: source.place_of(key),
                key,
                reason,
            })?;
            files.hold(name, Content::Bytes(bytes.into()));
            // Not named in the case, and not missed where it is not there.
            if let Some(conditions) = conditions_of(name)
                && let Ok(bytes) = resolver(&conditions.display().to_string())
            {
                files.hold(&conditions, Content::Bytes(bytes.into()));
            }
        }
        Ok(files)
    }

    /// Folder that names are relative to; none where only memory is asked.
    pub(super) fn folder(&self) -> Option<&Path> {
        self.folder.as_deref()
    }

    /// Files below the folder in `parent` whose names are of `pattern`, and such traces in memory, by name.
    pub(super) fn matching(&self, parent: &Path, pattern: &str) -> Vec<PathBuf> {
        let is_meant = |name: &OsStr| matches(pattern, &name.to_string_lossy());
        let entries = self.folder.as_ref().and_then(|folder| {
            let path = folder.join(parent);
            let is_here = path.as_os_str().is_empty();
            let path = if is_here { Path::new(".") } else { &path };
            path.read_dir().ok()
        });
        let on_disk = entries.into_iter().flatten().flatten();
        let on_disk = on_disk.filter(|entry| entry.path().is_file());
        let on_disk = on_disk
            .map(|entry| entry.file_name())
            .filter(|name| is_meant(name));
        let in_memory = self
            .held
            .keys()
            .filter(|name| name.parent() == Some(parent) && name.file_name().is_some_and(is_meant));
        let mut found: Vec<PathBuf> = on_disk.map(|name| parent.join(name)).collect();
        found.extend(in_memory.cloned());
        found.sort();
        found.dedup();
        found
    }

    /// Keeps `content` under this name.
    pub(super) fn hold(&mut self, name: &Path, content: Content) {
        self.held.insert(name.to_owned(), content);
    }

    /// Content kept under this name.
    pub(super) fn held(&self, name: &Path) -> Option<&Content> {
        self.held.get(name)
    }

    /// The measuring conditions that belong to the trace `name`, where there are any.
    pub(super) fn conditions(&self, name: &Path) -> Option<Arc<[u8]>> {
        let name = conditions_of(name)?;
        if let Some(Content::Bytes(bytes)) = self.held.get(&name) {
            return Some(Arc::clone(bytes));
        }
        let path = self.folder.as_ref()?.join(name);
        whole_file(&path, LARGEST).ok().map(Into::into)
    }

    /// Content behind `name`, which stands at `key` of the case.
    pub(super) fn open(
        &self,
        name: &Path,
        source: &Source,
        key: &'static str,
    ) -> Result<Content, CaseError> {
        if let Some(content) = self.held.get(name) {
            return Ok(content.clone());
        }
        let refused = |file: &Path, reason| CaseError::OpenNamed {
            file: file.display().to_string(),
            place: source.place_of(key),
            key,
            reason,
        };
        match &self.folder {
            Some(folder) => {
                let path = folder.join(name);
                let bytes = whole_file(&path, LARGEST).map_err(|reason| refused(&path, reason))?;
                Ok(Content::Bytes(bytes.into()))
            }
            None => {
                let reason = io::Error::new(
                    io::ErrorKind::NotFound,
                    "no file of this name came with the case",
                );
                Err(refused(name, reason))
            }
        }
    }
}
