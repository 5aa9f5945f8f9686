//! Files that a case names: their keys, where they come from, and the sums of those that were read.

use std::borrow::Cow;
use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::ffi::OsStr;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use asperity_core::Profile;
use asperity_flanks::statements::Statements;
use asperity_profile_io::read::conditions_of;
use asperity_storage::whole_file;

use super::case_input::CaseInput;
use super::film_friction_input::FilmFrictionInput;
use super::trace_list::{TraceList, is_pattern, matches};
use crate::fingerprint::sha256;
use crate::source::case_error::CaseError;
use crate::source::source_text::Source;

pub(crate) const LOSS_TABLE: &str = "gearbox.loss_table";
pub(crate) const OIL_FILE: &str = "lubricant.oil_file";
pub(crate) const XU_COEFFICIENTS: &str = "model.film_friction.xu";

/// Every key of a pair of gears that names a file, or several.
pub const FILE_KEYS: [&str; 19] = [
    "surface.pinion.file",
    "surface.wheel.file",
    "surface.coast.pinion.file",
    "surface.coast.wheel.file",
    "surface.pinion.traces",
    "surface.wheel.traces",
    "surface.coast.pinion.traces",
    "surface.coast.wheel.traces",
    "surface.pinion.like",
    "surface.wheel.like",
    "surface.coast.pinion.like",
    "surface.coast.wheel.like",
    "surface.pinion.after",
    "surface.wheel.after",
    "surface.coast.pinion.after",
    "surface.coast.wheel.after",
    OIL_FILE,
    LOSS_TABLE,
    XU_COEFFICIENTS,
];

/// SHA-256 of the content of files, by the names that a case gives them.
pub type FileSums = BTreeMap<PathBuf, String>;

/// Bytes of the largest file that a case may name.
const LARGEST: u64 = 1_000_000_000;

/// Content of files, by the names that a case gives them.
pub type FileContents = BTreeMap<PathBuf, Content>;

/// Content of a file.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Content {
    /// The bytes of a file.
    Bytes(Arc<[u8]>),
    /// A trace in memory.
    Heights(Arc<HeldTrace>),
}

impl Content {
    /// SHA-256 of the bytes, or of spacing and heights of a trace in memory.
    fn sum(&self) -> String {
        match self {
            Self::Bytes(bytes) => sha256(bytes),
            Self::Heights(trace) => {
                let spacing = trace.profile.spacing().si();
                let numbers = std::iter::once(&spacing).chain(trace.profile.heights());
                let mut bytes: Vec<u8> = numbers.flat_map(|number| number.to_le_bytes()).collect();
                if trace.statements != Statements::default() {
                    bytes.extend(serde_json::to_vec(&trace.statements).unwrap_or_default());
                }
                sha256(&bytes)
            }
        }
    }
}

/// A trace in memory, with what is stated of its heights: a case takes it as the file that it was read from.
#[derive(Debug, Clone, PartialEq)]
pub struct HeldTrace {
    /// The heights.
    pub profile: Profile,
    /// Statements about them.
    pub statements: Statements,
}

impl From<Profile> for HeldTrace {
    /// Heights of which nothing is stated.
    fn from(profile: Profile) -> Self {
        Self {
            profile,
            statements: Statements::default(),
        }
    }
}

/// A file, or a pattern of files, that a case names.
pub(crate) struct Named {
    #[cfg_attr(
        not(feature = "case-files"),
        expect(dead_code, reason = "a resolver names it")
    )]
    pub key: Cow<'static, str>,
    pub name: PathBuf,
    pub is_pattern: bool,
}

impl Named {
    pub fn file(key: impl Into<Cow<'static, str>>, name: &Path) -> Self {
        Self {
            key: key.into(),
            name: name.to_owned(),
            is_pattern: false,
        }
    }
}

/// Files and patterns of files that `input` names.
pub(crate) fn named(input: &CaseInput) -> Vec<Named> {
    let surface = &input.surface;
    let coast = surface.coast.as_ref();
    let flanks = [
        ("surface.pinion", Some(&surface.pinion)),
        ("surface.wheel", surface.wheel.as_ref()),
        ("surface.coast.pinion", coast.map(|coast| &coast.pinion)),
        (
            "surface.coast.wheel",
            coast.and_then(|coast| coast.wheel.as_ref()),
        ),
    ];
    let mut named: Vec<Named> = Vec::new();
    for (table, flank) in flanks {
        let Some(flank) = flank else { continue };
        let file = flank.file.iter();
        named.extend(file.map(|name| Named::file(format!("{table}.file"), name)));
        let lists = [
            ("traces", &flank.traces),
            ("like", &flank.like),
            ("after", &flank.after),
        ];
        for (name, list) in lists {
            let key = format!("{table}.{name}");
            let listed = list.iter().flat_map(TraceList::entries);
            named.extend(listed.map(|entry| Named {
                key: key.clone().into(),
                is_pattern: is_pattern(&entry.file),
                name: entry.file,
            }));
        }
    }
    let oil = input.lubricant.oil_file.iter();
    named.extend(oil.map(|name| Named::file(OIL_FILE, name)));
    let friction = input.model.film_friction.iter();
    let xu = friction.filter_map(FilmFrictionInput::xu_coefficients);
    named.extend(xu.map(|name| Named::file(XU_COEFFICIENTS, name)));
    let gearbox = input.gearbox.iter();
    let tables = gearbox.filter_map(|gearbox| gearbox.loss_table.as_ref());
    named.extend(tables.map(|name| Named::file(LOSS_TABLE, name)));
    named
}

/// The files of a case by the names that the case gives them.
#[derive(Debug, Clone, Default)]
pub(crate) struct Files {
    /// Folder that names are relative to; `None` if all files are in memory.
    folder: Option<PathBuf>,
    /// Whether those in memory are all files of the case, and not those that a resolver gave for single names.
    are_all_held: bool,
    pub(crate) held: FileContents,
}

impl Files {
    /// Files in memory, and below `folder` if there is one.
    pub(crate) fn holding(folder: Option<&Path>, held: FileContents) -> Self {
        Self {
            folder: folder.map(Path::to_owned),
            are_all_held: folder.is_none(),
            held,
        }
    }

    /// Contents of the files with these sums.
    pub(crate) fn contents(&self, sums: &FileSums) -> Result<FileContents, CaseError> {
        let reader = Reader::new(self);
        let content = |(name, sum): (&PathBuf, &String)| match reader.content(name) {
            Ok((content, now)) if now == *sum => Ok((name.clone(), content)),
            _ => Err(CaseError::file_changed(
                self.path_of(name).display().to_string(),
            )),
        };
        sums.iter().map(content).collect()
    }

    /// Files on disk, relative to `folder`.
    pub(crate) fn in_folder(folder: &Path) -> Self {
        Self::holding(Some(folder), FileContents::new())
    }

    /// Folder that names are relative to; `None` if all files are in memory.
    pub(crate) fn folder(&self) -> Option<&Path> {
        self.folder.as_deref()
    }

    /// Path of the file `name`.
    pub(crate) fn path_of(&self, name: &Path) -> PathBuf {
        self.folder().unwrap_or(Path::new("")).join(name)
    }

    /// Files below the folder and files in memory whose names match `pattern`, sorted by name. Empty if the folder of
    /// the pattern is itself a pattern, and where neither a folder nor all files are known.
    pub(crate) fn matching(&self, pattern: &Path) -> Vec<PathBuf> {
        let parent = pattern.parent().unwrap_or(Path::new(""));
        let Some(wanted) = pattern.file_name().map(OsStr::to_string_lossy) else {
            return Vec::new();
        };
        if is_pattern(parent) || (self.folder.is_none() && !self.are_all_held) {
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
        let mut names: Vec<PathBuf> = on_disk.map(|name| parent.join(name)).collect();
        names.extend(in_memory.cloned());
        names.sort();
        names.dedup();
        names
    }

    /// Stores `content` under this name.
    pub(crate) fn hold(&mut self, name: &Path, content: Content) {
        self.held.insert(name.to_owned(), content);
    }

    /// Content stored under this name.
    pub(crate) fn held(&self, name: &Path) -> Option<&Content> {
        self.held.get(name)
    }

    /// Sums of the files that any of `inputs` names; those that cannot be read are left out.
    pub(crate) fn sums_of(&self, inputs: &[CaseInput]) -> FileSums {
        let named = inputs.iter().flat_map(named);
        self.sums_of_names(named.flat_map(|named| {
            if named.is_pattern {
                self.matching(&named.name)
            } else {
                vec![named.name]
            }
        }))
    }

    /// Sums of the files with these names; those that cannot be read are left out.
    pub(crate) fn sums_of_names(&self, names: impl Iterator<Item = PathBuf>) -> FileSums {
        let reader = Reader::new(self);
        for name in &names.collect::<BTreeSet<PathBuf>>() {
            // A file that cannot be read is an error of the case that needs it.
            let _ = reader.content(name);
            reader.conditions(name);
        }
        reader.into_sums()
    }
}

/// Reads files of a case and notes the sum of each.
#[derive(Debug)]
pub(crate) struct Reader<'a> {
    pub files: &'a Files,
    sums: RefCell<FileSums>,
}

impl<'a> Reader<'a> {
    pub(crate) fn new(files: &'a Files) -> Self {
        Self {
            files,
            sums: RefCell::default(),
        }
    }

    /// Sums of what was read.
    pub(crate) fn into_sums(self) -> FileSums {
        self.sums.into_inner()
    }

    /// Content of the file `name`, which is stated at `key` of the case, and its sum.
    pub(crate) fn open(
        &self,
        name: &Path,
        source: &Source,
        key: impl Into<Cow<'static, str>>,
    ) -> Result<(Content, String), CaseError> {
        self.content(name).map_err(|reason| {
            let key = key.into();
            CaseError::open_named(
                self.files.path_of(name).display().to_string(),
                source.place_of(&key),
                &key,
                reason,
            )
        })
    }

    /// The measuring conditions of the trace `name`, if there are any.
    pub(crate) fn conditions(&self, name: &Path) -> Option<Arc<[u8]>> {
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
