//! Cases from files and texts, and changes of their keys by name.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use asperity_core::Profile;
use asperity_storage::whole_file;

use super::case_file::CaseFile;
use crate::case::error::CaseError;
use crate::case::files::{Content, FileContents, Files};
use crate::case::input::CaseInput;
use crate::case::loaded::{LoadedCase, complete, keep_oil};
use crate::case::model::Formulation;
use crate::case::source::Source;
use crate::error::Error;

/// Resolver of the files that a case text names: from the name in the text to the bytes.
pub type Resolver<'a> = &'a dyn Fn(&str) -> std::io::Result<Vec<u8>>;

/// Reads the case file `path` and the traces it names; `formulation` takes precedence over that of the file.
///
/// # Errors
/// When a file cannot be read or holds impossible values. The error holds the source if it could be read, so that the
/// place can be shown.
pub fn load(path: &Path, formulation: Option<Formulation>) -> Result<LoadedCase, Error> {
    load_with(path, &|input| {
        if formulation.is_some() {
            input.formulation = formulation;
        }
    })
}

/// Reads the case in `source`, whose files are in `folder`, with keys set by their paths as [`CaseInput::set`] takes them.
///
/// # Errors
/// As for [`load`], or when a key is not known or its value cannot be read.
pub fn load_set(
    source: Source,
    folder: &Path,
    set: &[(String, String)],
    change: &dyn Fn(&mut CaseInput),
) -> Result<LoadedCase, Error> {
    load_holding(source, folder, &[], set, change)
}

/// Reads a case as [`load_set`] does, with traces in memory under the names that the text gives their files.
///
/// # Errors
/// As for [`load_set`].
///
/// ```
/// use asperity_case::case::{Source, load_holding};
/// use asperity_core::{Profile, quantity::Length};
/// let text = r#"
///     gears = { teeth = [23, 68], module = "1.8 mm", face_width = "32 mm" }
///     operation = { torque = "145 N m", speed = "9000 1/min", bulk_temperature = "90 °C" }
///     lubricant = { oil = "m100" }
///     surface = { pinion = { file = "measured just now" }, cutoff = "0.25 mm" }
/// "#;
/// let heights = (0..8000).map(|i| 2e-7 * (f64::from(i) * 0.7).sin()).collect();
/// let trace = Profile::new(Length::from_si(0.5e-6), heights)?;
/// let source = Source::from_bytes("case.toml", text.as_bytes()).map_err(asperity_case::error::Error::from)?;
/// let held = [("measured just now".into(), trace)];
/// let loaded = load_holding(source, ".".as_ref(), &held, &[], &|_| {})?;
/// assert!(loaded.surfaces.are_measured());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn load_holding(
    source: Source,
    folder: &Path,
    traces: &[(PathBuf, Profile)],
    set: &[(String, String)],
    change: &dyn Fn(&mut CaseInput),
) -> Result<LoadedCase, Error> {
    let mut source = source;
    let mut files = Files::in_folder(folder);
    for (name, trace) in traces {
        files.hold(name, Content::Heights(Arc::new(trace.clone())));
    }
    match changed(&mut source, files, set, change) {
        Ok(case) => Ok(case),
        Err(error) => Err(Error::in_text(error, source)),
    }
}

/// Completes the case in `source` with keys set past the text and a change.
fn changed(
    source: &mut Source,
    files: Files,
    set: &[(String, String)],
    change: &dyn Fn(&mut CaseInput),
) -> Result<LoadedCase, CaseError> {
    let stated = CaseInput::read(source)?;
    let mut input = stated.clone();
    for (key, value) in set {
        input.set_in(source, key, value)?;
    }
    change(&mut input);
    keep_oil(&stated, &mut input);
    complete(input, source, files.into(), None)
}

/// Reads the case file `path`, and changes the case before its defaults are filled in.
///
/// # Errors
/// As for [`load`].
pub fn load_with(path: &Path, change: &dyn Fn(&mut CaseInput)) -> Result<LoadedCase, Error> {
    let folder = path.parent().unwrap_or(Path::new("."));
    load_holding(open(path)?, folder, &[], &[], change)
}

/// Reads a case from its `text`; the files it names come from `resolver`, so that no file system is needed.
/// Messages use `name`; the text is JSON if it ends in `.json`, TOML otherwise.
///
/// # Errors
/// As for [`load`], or when the resolver refuses a file.
///
/// ```
/// use asperity_case::case;
/// let text = r#"
///     gears = { teeth = [23, 68], module = "1.8 mm", face_width = "32 mm" }
///     operation = { torque = "145 N m", speed = "9000 1/min", bulk_temperature = "90 °C" }
///     lubricant = { oil = "m100" }
///     surface = { pinion = { file = "flank", dx = "0.5 um", z_unit = "um" }, cutoff = "0.25 mm" }
/// "#;
/// let trace: String = (0..8000).map(|i| format!("{:.6}\n", (f64::from(i) * 0.7).sin())).collect();
/// let loaded = case::from_text("case.toml", text, &|name| match name {
///     "flank" => Ok(trace.clone().into_bytes()),
///     _ => Err(std::io::ErrorKind::NotFound.into()),
/// })?;
/// assert!(loaded.surfaces.are_measured());
/// # Ok::<(), asperity_case::error::Error>(())
/// ```
pub fn from_text(name: &str, text: &str, resolver: Resolver<'_>) -> Result<LoadedCase, Error> {
    let source = Source::from_bytes(name, text.as_bytes())?;
    let read = || {
        let input = CaseInput::read(&source)?;
        let mut files = Files::default();
        files.gather(&input, &source, resolver)?;
        complete(input, &source, files.into(), None)
    };
    read().map_err(|error| Error::in_text(error, source.clone()))
}

/// Reads a case from the TOML `text` of its keys and the content of its files; no file on disk is read. Messages use `name`.
///
/// ```
/// use asperity_case::case;
/// let case = case::load("../../fixtures/cases/e-drive.toml".as_ref(), None)?;
/// let again = case::from_contents(case.name(), &case.case.input.to_toml()?, case.contents()?)?;
/// assert_eq!(again.fingerprint(), case.fingerprint());
/// # Ok::<(), asperity_case::error::Error>(())
/// ```
///
/// # Errors
/// As for [`load`].
pub fn from_contents(name: &str, text: &str, contents: FileContents) -> Result<LoadedCase, Error> {
    let mut source = Source::new("case.toml", text)?;
    let read = CaseInput::read(&source);
    // The text is TOML, whatever the name ends in.
    name.clone_into(&mut source.name);
    let files = Files::holding(None, contents);
    let case = read.and_then(|input| complete(input, &source, files.into(), None));
    case.map_err(|error| Error::in_text(error, source))
}

impl LoadedCase {
    /// The case with the key at `path` set to `value`, as [`CaseInput::set`] takes them.
    ///
    /// # Errors
    /// When the key is not known, the value cannot be read, or the changed case cannot be run.
    pub fn with_key(&self, path: &str, value: &str) -> Result<Self, Error> {
        let mut input = self.case.input.clone();
        input.set(path, value)?;
        self.changed_to(input, None)
    }
}

/// The text of the case file `path`.
///
/// # Errors
/// When it cannot be read, or is not a text in TOML (or JSON).
pub fn open_source(path: &Path) -> Result<Source, Error> {
    Ok(open(path)?)
}

/// Bytes of the largest case file.
const LARGEST_CASE: u64 = 10_000_000;

fn open(path: &Path) -> Result<Source, CaseError> {
    let file = path.display().to_string();
    if path.is_dir() {
        return Err(CaseError::folder(&file));
    }
    match whole_file(path, LARGEST_CASE) {
        Ok(bytes) => Source::from_bytes(&file, &bytes),
        Err(reason) => Err(CaseError::open(file, reason)),
    }
}
