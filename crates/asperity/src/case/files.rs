//! Files that a case names: their keys, where they come from, and the sums of those that were read.

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
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
use super::trace_list::{TraceEntry, TraceList, is_pattern, matches};
use crate::fingerprint::sha256;

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

/// Every key of a case that names a file, or several.
pub const FILE_KEYS: [&str; 10] = [
    FILE_OF_PINION,
    FILE_OF_WHEEL,
    FILE_OF_COAST_PINION,
    FILE_OF_COAST_WHEEL,
    TRACES_OF_PINION,
    TRACES_OF_WHEEL,
    TRACES_OF_COAST_PINION,
    TRACES_OF_COAST_WHEEL,
    LOSS_TABLE,
    XU_COEFFICIENTS,
];

/// SHA-256 of the content of files, by the names that a case gives them.
pub type FileSums = BTreeMap<PathBuf, String>;

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

impl Content {
    /// SHA-256 of the bytes; of spacing and heights where the trace was no file.
    fn sum(&self) -> String {
        match self {
            Self::Bytes(bytes) => sha256(bytes),
            Self::Heights(profile) => {
                let spacing = profile.spacing().si();
                let numbers = std::iter::once(&spacing).chain(profile.heights());
                sha256(
                    &numbers
                        .flat_map(|number| number.to_le_bytes())
                        .collect::<Vec<u8>>(),
                )
            }
        }
    }
}

/// A file, or a pattern of files, that a case names.
struct Named {
    key: &'static str,
    name: PathBuf,
    is_pattern: bool,
}

/// Files and patterns of files that `input` names.
fn named(input: &CaseInput) -> Vec<Named> {
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
    let file = |key, name: &PathBuf| Named {
        key,
        name: name.clone(),
        is_pattern: false,
    };
    let mut named: Vec<Named> = Vec::new();
    for ([file_key, traces], flank) in flanks {
        let Some(flank) = flank else { continue };
        named.extend(flank.file.iter().map(|name| file(file_key, name)));
        let listed = flank.traces.iter().flat_map(TraceList::entries);
        named.extend(listed.map(|entry| match entry {
            TraceEntry::Table(table) => file(traces, &table.file),
            TraceEntry::Pattern(text) => Named {
                key: traces,
                is_pattern: is_pattern(&text),
                name: text.into(),
            },
        }));
    }
    let xu = input.model.xu_coefficients.iter();
    named.extend(xu.map(|name| file(XU_COEFFICIENTS, name)));
    let gearbox = input.gearbox.iter();
    let tables = gearbox.filter_map(|gearbox| gearbox.loss_table.as_ref());
    named.extend(tables.map(|name| file(LOSS_TABLE, name)));
    named
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
        let mut files = Self::default();
        for Named {
            key,
            name,
            is_pattern,
        } in &named(input)
        {
            // Patterns are of files on disk.
            if files.held.contains_key(name) || *is_pattern {
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

    /// Files below the folder and traces in memory whose names match `pattern`, sorted by name. Empty if the folder of
    /// the pattern is itself a pattern.
    pub(super) fn matching(&self, pattern: &Path) -> Vec<PathBuf> {
        let parent = pattern.parent().unwrap_or(Path::new(""));
        let Some(wanted) = pattern.file_name().map(OsStr::to_string_lossy) else {
            return Vec::new();
        };
        if is_pattern(&parent.to_string_lossy()) {
            return Vec::new();
        }
        let is_meant = |name: &OsStr| matches(&wanted, &name.to_string_lossy());
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

    /// Sums of the files that any of `inputs` names; those that cannot be read are left out.
    pub(super) fn sums_of(&self, inputs: &[CaseInput]) -> FileSums {
        let named = inputs.iter().flat_map(named);
        let names: BTreeSet<PathBuf> = named
            .flat_map(|named| match named.is_pattern {
                true => self.matching(&named.name),
                false => vec![named.name],
            })
            .collect();
        let reader = Reader::of(self);
        for name in &names {
            // A file that cannot be read is an error of the case that needs it.
            let _ = reader.content(name);
            reader.conditions(name);
        }
        reader.into_sums()
    }
}

/// Reads files of a case and notes the sum of each.
#[derive(Debug)]
pub(super) struct Reader<'a> {
    pub files: &'a Files,
    sums: RefCell<FileSums>,
}

impl<'a> Reader<'a> {
    pub(super) fn of(files: &'a Files) -> Self {
        Self {
            files,
            sums: RefCell::default(),
        }
    }

    /// Sums of what was read.
    pub(super) fn into_sums(self) -> FileSums {
        self.sums.into_inner()
    }

    /// Content behind `name`, which is at `key` of the case, and its sum.
    pub(super) fn open(
        &self,
        name: &Path,
        source: &Source,
        key: &'static str,
    ) -> Result<(Content, String), CaseError> {
        self.content(name).map_err(|reason| {
            let folder = self.files.folder.as_deref().unwrap_or(Path::new(""));
            CaseError::OpenNamed {
                file: folder.join(name).display().to_string(),
                place: source.place_of(key),
                key,
                reason,
            }
        })
    }

    /// The measuring conditions that belong to the trace `name`, where there are any.
    pub(super) fn conditions(&self, name: &Path) -> Option<Arc<[u8]>> {
        match self.content(&conditions_of(name)?).ok()?.0 {
            Content::Bytes(bytes) => Some(bytes),
            Content::Heights(_) => None,
        }
    }

    fn content(&self, name: &Path) -> io::Result<(Content, String)> {
        let content = match (self.files.held.get(name), &self.files.folder) {
            (Some(content), _) => content.clone(),
            (None, Some(folder)) => Content::Bytes(whole_file(&folder.join(name), LARGEST)?.into()),
            (None, None) => {
                let reason = "no file of this name came with the case";
                return Err(io::Error::new(io::ErrorKind::NotFound, reason));
            }
        };
        let sum = content.sum();
        self.sums.borrow_mut().insert(name.to_owned(), sum.clone());
        Ok((content, sum))
    }
}
