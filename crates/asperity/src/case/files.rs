//! Sources of the files that a case names: a folder, or memory.

use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use asperity_core::Profile;
use asperity_profile_io::read::{conditions_of, whole_file};

use super::error::CaseError;
use super::input::CaseInput;
use super::source::Source;

pub(super) const FILE_OF_PINION: &str = "surface.pinion.file";
pub(super) const FILE_OF_WHEEL: &str = "surface.wheel.file";
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
        let wheel = input.surface.wheel.as_ref();
        let named = [
            (FILE_OF_PINION, input.surface.pinion.file.as_ref()),
            (FILE_OF_WHEEL, wheel.and_then(|wheel| wheel.file.as_ref())),
            (XU_COEFFICIENTS, input.model.xu_coefficients.as_ref()),
        ];
        let mut files = Self::default();
        for (key, name) in named {
            let Some(name) = name else { continue };
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
