//! One file per command.

mod bibtex;
pub mod check;
pub mod completions;
pub mod contact;
pub mod demo;
pub mod ehl;
pub mod figures;
pub mod film;
mod finish;
pub mod from_rexs;
pub mod gear;
mod given;
pub mod list;
pub mod new_case;
mod oil;
pub mod profile;
pub mod reference;
pub mod report;
pub mod run;
pub mod study;
pub mod sweep;
mod work;

use std::ffi::{OsStr, OsString};
use std::io::Read as _;
use std::path::Path;

use asperity::case::{self, LoadedCase, PathPoint, Source, Train};
use asperity::formulation::FormulationChoice;
use asperity_core::Code;
use asperity_core::number;

use serde::Serialize;
use serde_json::json;

use crate::args::SetArgs;
use crate::failure::Failure;
use crate::output::shown;

/// Text of a case, and the folder of its relative file names; `-` is standard input.
fn source(path: &Path) -> Result<(Source, &Path), Failure> {
    /// Largest size of a case in bytes.
    const LONGEST: u64 = 10_000_000;
    if path != Path::new("-") {
        let source = case::open_source(path).map_err(|error| Failure::from_error(&error))?;
        return Ok((source, path.parent().unwrap_or(Path::new("."))));
    }
    let mut bytes = Vec::new();
    let read = std::io::stdin()
        .lock()
        .take(LONGEST)
        .read_to_end(&mut bytes);
    read.map_err(|error| Failure::new(Code::E201, format!("standard input: {error}")))?;
    let is_json = bytes.trim_ascii_start().starts_with(b"{");
    let name = if is_json { "stdin.json" } else { "stdin" };
    let source = Source::from_bytes(name, &bytes)
        .map_err(|error| Failure::from_error(&asperity::Error::from(error)))?;
    Ok((source, Path::new(".")))
}

/// Keys to set, in the form of the library.
fn keys(set: &SetArgs) -> Vec<(String, String)> {
    let pairs = set.keys.iter();
    pairs
        .map(|set| (set.key.clone(), set.value.clone()))
        .collect()
}

/// Reads the case in a text, or its mesh `--mesh`, with keys set and a change of every mesh.
fn load_text(
    text: Source,
    folder: &Path,
    set: &SetArgs,
    change: case::Change<'_>,
) -> Result<Train, Failure> {
    let train = Train::load_set(text, folder, &keys(set), change);
    let loaded = match &set.mesh {
        None => train,
        Some(mesh) => train.and_then(|train| train.of_mesh(mesh)),
    };
    loaded.map_err(|error| Failure::from_error(&error))
}

/// Reads a case with its traces.
fn load_train(
    path: &Path,
    set: &SetArgs,
    formulation: Option<FormulationChoice>,
) -> Result<Train, Failure> {
    let (text, folder) = source(path)?;
    load_text(text, folder, set, &|input| {
        if formulation.is_some() {
            input.formulation = formulation;
        }
    })
}

/// Reads the case of a single mesh with its traces.
fn load_case(
    path: &Path,
    set: &SetArgs,
    formulation: Option<FormulationChoice>,
) -> Result<LoadedCase, Failure> {
    let train = load_train(path, set, formulation)?;
    one_mesh(&train).cloned()
}

/// The only mesh of a case.
fn one_mesh(train: &Train) -> Result<&LoadedCase, Failure> {
    train.only_mesh().map_err(|error| {
        Failure::from_error(&error).advising("Name it with --mesh; run, check, gear, map, compare, sweep, sensitivity and evidence take all meshes.")
    })
}

/// The value of the only mesh, or the title of the train and the values of all meshes, as JSON.
fn of_meshes<V: Serialize>(train: &Train, values: &[V]) -> serde_json::Value {
    match (train.only(), values) {
        (Some(_), [only]) => json!(only),
        _ => json!({ "title": train.title, "meshes": values }),
    }
}

/// Name of a mesh in the `title` of its case, which begins with the title of the train.
fn mesh_of<'a>(train: &str, title: &'a str) -> &'a str {
    let rest = title.strip_prefix(train);
    rest.and_then(|rest| rest.strip_prefix(": "))
        .unwrap_or(title)
}

/// Refuses the folder that the user did not name if it holds the result of a case with another title, `older`.
fn refuse_other(folder: &Path, title: &str, older: &str) -> Result<(), Failure> {
    if older == title {
        Ok(())
    } else {
        Err(Failure::new(
            Code::E401,
            format!(
                "{}: holds the result of another case ({}); choose another with -o, or name it with -o to replace it",
                shown(folder),
                asperity_storage::one_line(older)
            ),
        ))
    }
}

/// Name of a file without extension.
fn stem(path: &Path) -> &OsStr {
    if path == Path::new("-") {
        OsStr::new("stdin")
    } else {
        path.file_stem().unwrap_or_default()
    }
}

/// Name of the results of a file: its name without extension, after the folder of its path if many files have that name.
fn result_name(path: &Path) -> OsString {
    const COMMON: &str = "case";
    let name = stem(path);
    match path.parent().and_then(Path::file_name) {
        Some(folder) if name == COMMON => {
            let mut both = folder.to_owned();
            both.push("-");
            both.push(name);
            both
        }
        _ => name.to_owned(),
    }
}

/// Checks a position on the path of contact, 0 at A and 1 at E.
fn on_the_path(loaded: &LoadedCase, position: Option<PathPoint>) -> Result<Option<f64>, Failure> {
    let Some(position) = position else {
        return Ok(None);
    };
    let fraction = position.fraction_of(loaded.case.gears.path());
    if (0.0..=1.0).contains(&fraction) {
        return Ok(Some(fraction));
    }
    Err(Failure::new(
        Code::E209,
        format!(
            "--position {}: must be A to E, or 0 (A) to 1 (E)",
            number(fraction)
        ),
    ))
}
