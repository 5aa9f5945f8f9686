//! Gear trains from files and texts.

use asperity_core::Code;
use std::collections::BTreeSet;
use std::path::Path;
use std::sync::Arc;

use super::case_file::CaseFile;
use super::check::{completed, in_text, readable};
use super::load::{Resolver, open_source};
use crate::case::error::CaseError;
use crate::case::files::{FileContents, Files, Reader};
use crate::case::input::CaseInput;
use crate::case::loaded::complete;
use crate::case::loaded_train::LoadedTrain;
use crate::case::model::Formulation;
use crate::case::ranges::impossible;
use crate::case::source::Source;
use crate::case::train_input::TrainCaseInput;
use crate::error::Error;

/// Whether the text is of a gear train: it has tables `[mesh.NAME]` or `[planetary]`.
pub fn is_train(source: &Source) -> bool {
    let mut keys = source.key_paths();
    keys.any(|key| TrainCaseInput::TABLES.contains(&key))
}

/// Reads the case file `path` of a gear train and the traces it names; `None` if it holds neither `[mesh.NAME]` nor
/// `[planetary]`.
///
/// # Errors
/// When a file cannot be read or holds impossible values.
pub fn load(path: &Path) -> Result<Option<LoadedTrain>, Error> {
    // The loader of ordinary cases reports files that cannot be read.
    let Ok(source) = open_source(path) else {
        return Ok(None);
    };
    if !is_train(&source) {
        return Ok(None);
    }
    load_set(source, path.parent().unwrap_or(Path::new(".")), &[], None).map(Some)
}

/// Reads the gear train in `source`, whose files are in `folder`, with keys set by their paths; `formulation` is that of
/// all meshes.
///
/// # Errors
/// As for [`load`], or when a key is not known or its value cannot be read.
pub fn load_set(
    source: Source,
    folder: &Path,
    keys: &[(String, String)],
    formulation: Option<Formulation>,
) -> Result<LoadedTrain, Error> {
    load_holding(source, Some(folder), FileContents::new(), keys, formulation)
}

/// Reads a gear train as [`load_set`] does, with files in memory, which come before those on disk; without a folder no file
/// on disk is read.
///
/// # Errors
/// As for [`load_set`].
pub fn load_holding(
    source: Source,
    folder: Option<&Path>,
    contents: FileContents,
    keys: &[(String, String)],
    formulation: Option<Formulation>,
) -> Result<LoadedTrain, Error> {
    let mut source = source;
    let files = Files::holding(folder, contents);
    let loaded = read(&mut source, Origin::Files(files), keys, formulation);
    loaded.map_err(|error| Error::in_text(error, source))
}

/// Reads the gear train in `text`, called `name`, whose files `resolver` gives, as [`from_text`](crate::case::from_text).
///
/// # Errors
/// As for [`load`].
pub fn from_text(name: &str, text: &str, resolver: Resolver<'_>) -> Result<LoadedTrain, Error> {
    let mut source = Source::from_bytes(name, text.as_bytes())?;
    let loaded = read(&mut source, Origin::Memory(resolver), &[], None);
    loaded.map_err(|error| Error::in_text(error, source))
}

/// Origin of the files of a train.
enum Origin<'a> {
    Files(Files),
    Memory(Resolver<'a>),
}

fn read(
    source: &mut Source,
    from: Origin<'_>,
    keys: &[(String, String)],
    formulation: Option<Formulation>,
) -> Result<LoadedTrain, CaseError> {
    let mut input = TrainCaseInput::read(source)?;
    for (key, value) in keys {
        input.set_in(source, key, value)?;
    }
    let (mut files, resolver) = match from {
        Origin::Files(files) => (files, None),
        Origin::Memory(resolver) => (Files::default(), Some(resolver)),
    };
    if let Some(resolver) = resolver {
        let tables = input.gearbox.iter().flat_map(|gearbox| &gearbox.tables);
        files.gather_tables(tables.map(|table| table.file.as_path()), source, resolver)?;
    }
    let parts = input.parts(source, Reader::of(&files))?;
    if let Some(resolver) = resolver {
        for mesh in parts.meshes() {
            files.gather(&mesh.case, &source.of_mesh(&mesh.keys), resolver)?;
        }
    }
    let files = Arc::new(files);
    let mut cases = Vec::new();
    for mesh in parts.meshes() {
        let case = CaseInput {
            formulation: formulation.or(mesh.case.formulation),
            ..mesh.case.clone()
        };
        let source = source.of_mesh(&mesh.keys);
        cases.push(complete(case, &source, Arc::clone(&files), None)?);
    }
    Ok(LoadedTrain::of(parts, cases, input))
}

/// The errors of a gear train, or the train.
#[derive(Debug)]
#[non_exhaustive]
pub struct TrainFindings {
    /// Every error, in the order of the checks; empty if the case can be run.
    pub errors: Vec<Error>,
    /// The case with its traces; `None` after an error.
    pub case: Option<LoadedTrain>,
}

/// Reads the gear train in `source` as [`load_set`] does, and goes on after an error.
pub fn check(source: Source, folder: &Path, keys: &[(String, String)]) -> TrainFindings {
    let mut source = source;
    let mut errors = Vec::new();
    let case = all(&mut source, folder, keys, &mut errors);
    let errors = in_text(errors, source);
    TrainFindings {
        case: case.filter(|_| errors.is_empty()),
        errors,
    }
}

fn all(
    source: &mut Source,
    folder: &Path,
    keys: &[(String, String)],
    errors: &mut Vec<CaseError>,
) -> Option<LoadedTrain> {
    let (input, mending) = readable::<TrainCaseInput>(source, keys, errors)?;
    errors.extend(impossible(&input, source));
    let files = Files::in_folder(folder);
    let parts = match input.parts(source, Reader::of(&files)) {
        Ok(parts) => parts,
        Err(error) => {
            let is_blamed = TrainCaseInput::TABLES
                .iter()
                .any(|table| mending.is_known(table));
            let is_known = errors
                .iter()
                .any(|known| identity(known) == identity(&error));
            if !is_blamed && !is_known {
                errors.push(error);
            }
            return None;
        }
    };
    let mut cases = Vec::new();
    for mesh in parts.meshes() {
        let source = source.of_mesh(&mesh.keys);
        let mending = mending.of_mesh(&mesh.keys)?;
        let mut of_mesh = Vec::new();
        cases.extend(completed(
            mesh.case.clone(),
            &source,
            folder,
            mending,
            &mut of_mesh,
        ));
        // Errors of shared keys occur in all meshes.
        let known: BTreeSet<_> = errors.iter().map(identity).collect();
        let is_new = |error: &CaseError| !known.contains(&identity(error));
        errors.extend(of_mesh.into_iter().filter(is_new));
    }
    let is_whole = cases.len() == parts.meshes().count();
    is_whole.then(|| LoadedTrain::of(parts, cases, input))
}

/// Identity of an error: its code with its line, or with its text if it has no line.
fn identity(error: &CaseError) -> (Code, Option<usize>, String) {
    let line = error.place().and_then(|place| place.line);
    let text = line.map_or_else(|| error.to_string(), |_| String::new());
    (error.code(), line, text)
}
