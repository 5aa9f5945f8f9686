//! Cases from files and texts, and changes of their keys by name.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use asperity_core::Profile;
use asperity_storage::whole_file;

use crate::error::Error;
use crate::input::case_input::CaseInput;
use crate::input::files::{Content, FileContents, Files, Reader};
use crate::input::formulation::FormulationChoice;
use crate::loaded::loaded_case::{LoadedCase, complete, keep_oil};
use crate::source::case_error::CaseError;
use crate::source::source_text::{MeshKeys, Source};
use crate::text::case_file::CaseFile;
use crate::train::gear_train::Train;

/// Resolver of the files that a case text names: from the name in the text to the bytes.
pub type Resolver<'a> = &'a dyn Fn(&str) -> std::io::Result<Vec<u8>>;

/// Change of the case of every mesh before its defaults are filled in.
pub type Change<'a> = &'a dyn Fn(&mut CaseInput);

impl Train {
    /// Reads the case file `path` and the traces it names.
    ///
    /// # Errors
    /// When a file cannot be read or holds impossible values. The error holds the source if it could be read, so that the
    /// place can be shown.
    pub fn load(path: &Path) -> Result<Self, Error> {
        let folder = path.parent().unwrap_or(Path::new("."));
        Self::load_set(open(path)?, folder, &[], &|_| {})
    }

    /// Reads the case in `source`, whose files are in `folder`, with keys set by their paths as [`CaseInput::set`] takes them,
    /// and a change of every mesh.
    ///
    /// # Errors
    /// As for [`load`](Self::load), or when a key is not known or its value cannot be read.
    pub fn load_set(
        source: Source,
        folder: &Path,
        set: &[(String, String)],
        change: Change<'_>,
    ) -> Result<Self, Error> {
        Self::load_holding(source, Some(folder), FileContents::new(), set, change)
    }

    /// Reads a case as [`load_set`](Self::load_set) does, with files in memory, which come before those on disk; without a
    /// folder no file on disk is read.
    ///
    /// # Errors
    /// As for [`load_set`](Self::load_set).
    pub fn load_holding(
        source: Source,
        folder: Option<&Path>,
        contents: FileContents,
        set: &[(String, String)],
        change: Change<'_>,
    ) -> Result<Self, Error> {
        let mut source = source;
        let files = Files::holding(folder, contents);
        let loaded = read(&mut source, files, None, set, change);
        loaded.map_err(|error| Error::in_text(error, source))
    }

    /// Reads a case from the TOML `text` of its keys and the content of its files; no file on disk is read. Messages use `name`.
    ///
    /// # Errors
    /// As for [`load`](Self::load).
    pub fn from_contents(name: &str, text: &str, contents: FileContents) -> Result<Self, Error> {
        let mut source = Source::new("case.toml", text)?;
        // The text is TOML, whatever the name ends in.
        name.clone_into(&mut source.name);
        Self::load_holding(source, None, contents, &[], &|_| {})
    }

    /// Reads a case from its `text`; the files it names come from `resolver`, so that no file system is needed.
    /// Messages use `name`; the text is JSON if it ends in `.json`, TOML otherwise.
    ///
    /// # Errors
    /// As for [`load`](Self::load), or when the resolver refuses a file.
    pub fn from_text(name: &str, text: &str, resolver: Resolver<'_>) -> Result<Self, Error> {
        let mut source = Source::from_bytes(name, text.as_bytes())?;
        let loaded = read(&mut source, Files::default(), Some(resolver), &[], &|_| {});
        loaded.map_err(|error| Error::in_text(error, source))
    }
}

/// The case in `source` with keys set past the text and a change of every mesh; `resolver` gives files that are not held.
fn read(
    source: &mut Source,
    mut files: Files,
    resolver: Option<Resolver<'_>>,
    set: &[(String, String)],
    change: Change<'_>,
) -> Result<Train, CaseError> {
    let stated = CaseInput::read(source)?;
    let mut input = stated.clone();
    input.make_way_for(set.iter().map(|(key, _)| key.as_str()));
    for (key, value) in set {
        input.set_in(source, key, value)?;
    }
    keep_oil(&stated, &mut input);
    let in_mesh = |mesh: Option<&Arc<MeshKeys>>| match mesh {
        Some(mesh) => source.of_mesh(mesh),
        None => source.clone(),
    };
    if let Some(resolver) = resolver {
        files.gather_tables(input.own_tables(), source, resolver)?;
        for (case, mesh) in input.of_meshes(source, Reader::new(&files))? {
            files.gather(&case, &in_mesh(mesh.as_ref()), resolver)?;
        }
    }
    let files = Arc::new(files);
    Train::made_of(input, source, Reader::new(&files), &|stated, mesh| {
        let mut case = stated.clone();
        change(&mut case);
        keep_oil(stated, &mut case);
        complete(
            case,
            &in_mesh(mesh.map(|mesh| &mesh.keys)),
            Arc::clone(&files),
            None,
        )
    })
}

/// Reads the case of a single mesh in the file `path`, and the traces it names; `formulation` takes precedence over the
/// formulation of the file.
///
/// # Errors
/// As for [`Train::load`], and when the case has several meshes.
pub fn load(path: &Path, formulation: Option<FormulationChoice>) -> Result<LoadedCase, Error> {
    load_with(path, &|input| {
        if formulation.is_some() {
            input.formulation = formulation;
        }
    })
}

/// Reads the case of a single mesh in the file `path`, and changes it before its defaults are filled in.
///
/// # Errors
/// As for [`load`].
pub fn load_with(path: &Path, change: Change<'_>) -> Result<LoadedCase, Error> {
    let folder = path.parent().unwrap_or(Path::new("."));
    load_holding(open(path)?, folder, &[], &[], change)
}

/// Reads the case of a single mesh as [`Train::load_set`] does.
///
/// # Errors
/// As for [`load`], or when a key is not known or its value cannot be read.
pub fn load_set(
    source: Source,
    folder: &Path,
    set: &[(String, String)],
    change: Change<'_>,
) -> Result<LoadedCase, Error> {
    load_holding(source, folder, &[], set, change)
}

/// Reads the case of a single mesh as [`load_set`] does, with traces in memory under the names that the text gives their files.
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
    change: Change<'_>,
) -> Result<LoadedCase, Error> {
    let held = traces.iter().map(|(name, trace)| {
        let content = Content::Heights(Arc::new(trace.clone().into()));
        (name.clone(), content)
    });
    Train::load_holding(source, Some(folder), held.collect(), set, change)?.into_only_mesh()
}

/// Reads the case of a single mesh from its `text` as [`Train::from_text`] does.
///
/// # Errors
/// As for [`Train::from_text`], and when the case has several meshes.
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
    Train::from_text(name, text, resolver)?.into_only_mesh()
}

/// Reads the case of a single mesh from the TOML `text` of its keys and the content of its files; no file on disk is read.
/// Messages use `name`.
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
    Train::from_contents(name, text, contents)?.into_only_mesh()
}

impl LoadedCase {
    /// The case with the key at `path` set to `value`, as [`CaseInput::set`] takes them; an oil replaces all numbers of the case's oil.
    ///
    /// # Errors
    /// When the key is not known, the value cannot be read, or the changed case cannot be run.
    pub fn with_key(&self, path: &str, value: &str) -> Result<Self, Error> {
        let mut input = self.case.input.clone();
        input.make_way_for([path]);
        input.set(path, value)?;
        Ok(self.changed_to(input, None)?)
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
