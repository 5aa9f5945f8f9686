//! `asperity demo`: a worked case to start from.

use std::path::Path;

use asperity_core::{DomainError, presets};
use asperity_fixtures::TextFile;
use asperity_storage::{StorageError, new_folder};
use serde_json::json;

use super::presets::refused;
use crate::args::Common;
use crate::failure::Failure;
use crate::output::{print_json, print_text, shown};

/// `asperity demo`
pub fn demo(folder: Option<&Path>, paper: bool, common: &Common) -> Result<(), Failure> {
    let default = if paper { "table2" } else { "demo" };
    let folder = folder.unwrap_or(Path::new(default));
    refuse_existing(folder)?;
    let files = match paper {
        true => asperity_fixtures::demo::table_2().map(paper_files),
        false => asperity_fixtures::demo::files(),
    };
    let (what, option) = match paper {
        true => (
            "case.toml and a damaged flank (synthetic)",
            " --formulation paper",
        ),
        false => (
            "case.toml, two pairs of flanks and two cycles (synthetic), a README",
            "",
        ),
    };
    finish(files, folder, what, option, common)
}

/// `asperity demo --gears`
pub fn preset(name: &str, folder: Option<&Path>, common: &Common) -> Result<(), Failure> {
    let gears = presets::gear(name).map_err(|error| refused(&error))?;
    let sources = presets::sources().map_err(|error| refused(&error))?;
    let folder = folder.unwrap_or(Path::new(&gears.name));
    refuse_existing(folder)?;
    let files = asperity_fixtures::preset::files(&gears, &sources);
    let what = format!(
        "{}, two pairs of flanks (synthetic), a README; case.toml states the source of every number",
        gears.title
    );
    finish(files, folder, &what, "", common)
}

fn refuse_existing(folder: &Path) -> Result<(), Failure> {
    match folder.exists() {
        false => Ok(()),
        true => Err(Failure::new(
            "E401",
            format!(
                "{}: exists already; name another folder, e.g. asperity demo my-first-case",
                folder.display()
            ),
        )),
    }
}

/// Writes the files and reports them.
fn finish(
    files: Result<Vec<TextFile>, DomainError>,
    folder: &Path,
    what: &str,
    option: &str,
    common: &Common,
) -> Result<(), Failure> {
    let files =
        files.map_err(|error| Failure::new("E501", format!("the demo cannot be made: {error}")))?;
    write(&files, folder).map_err(|error| Failure::new("E401", error.to_string()))?;
    if common.json {
        let names: Vec<&str> = files.iter().map(|file| file.name).collect();
        return print_json(&json!({ "folder": folder, "files": names }));
    }
    let name = shown(folder);
    print_text(
        common,
        &format!("wrote {name}: {what}\nnext: asperity run {name}/case.toml{option}\n"),
    )
}

/// The case with its flank in the same folder.
fn paper_files((case, flank): (TextFile, TextFile)) -> Vec<TextFile> {
    let content = case.content.replace("../profiles/", "");
    let case = TextFile {
        name: "case.toml",
        content,
    };
    vec![case, flank]
}

fn write(files: &[TextFile], folder: &Path) -> Result<(), StorageError> {
    new_folder(folder, |made| {
        for file in files {
            let place = made.join(file.name);
            std::fs::write(&place, &file.content).map_err(|source| StorageError::Io {
                path: place.clone(),
                source,
            })?;
        }
        Ok(())
    })
}
