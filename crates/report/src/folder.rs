//! The result folder, written beside its place and moved there whole, and read back.

use std::fs;
use std::path::{Path, PathBuf};

use asperity::UnsolvedContact;
use asperity::result::{Outcome, RunResult};
use serde::Serialize;

use crate::draft::{draft_file, draft_folder, parent_of};
use crate::error::ReportError;
use crate::html;
use crate::page_tables::PageTables;
use crate::tables::{self, ContactTables, folder_of};

/// Contents of a folder that is written as a whole.
#[derive(Debug, Clone, Copy)]
pub struct Contents {
    /// The file that marks it as ours.
    pub mark: &'static str,
    /// The other files.
    pub files: &'static [&'static str],
}

/// The file that marks a folder as a result.
const MARK: &str = "result.json";
/// The page of a result.
const PAGE: &str = "report.html";

/// Every point of the load map, where it was asked for.
const MAP: &str = "map.csv";

/// A result; beside its files are the folders of the positions.
const RESULT: Contents = Contents {
    mark: MARK,
    files: &FILES,
};

const FILES: [&str; 15] = [
    "path.csv",
    "load.csv",
    "load_map.csv",
    MAP,
    "offsets.csv",
    "convergence.csv",
    "losses.csv",
    "friction_laws.csv",
    "flank_pinion.csv",
    "flank_wheel.csv",
    "abbott_pinion.csv",
    "abbott_wheel.csv",
    "psd_pinion.csv",
    "psd_wheel.csv",
    PAGE,
];

/// Statement of the mark about its writer.
const WRITER: &str = "\"program\": \"asperity ";

/// Whether a result may be written as folder `target`: nothing is there, or an empty folder, or an
/// older result and nothing else, since it is replaced as a whole.
///
/// # Errors
/// When something else is there.
pub fn check_place(target: &Path) -> Result<(), ReportError> {
    check(target, &RESULT)
}

pub(crate) fn check(target: &Path, contents: &Contents) -> Result<(), ReportError> {
    let foreign = |entry: Option<String>| ReportError::NotOurs {
        path: target.to_owned(),
        entry,
    };
    if !target.exists() {
        return Ok(());
    }
    if !target.is_dir() {
        return Err(foreign(None));
    }
    let mut names = Vec::new();
    for entry in fs::read_dir(target).map_err(ReportError::io(target))? {
        let entry = entry.map_err(ReportError::io(target))?;
        names.push(entry.file_name().to_string_lossy().into_owned());
    }
    let is_ours = |name: &&String| {
        *name == contents.mark
            || contents.files.contains(&name.as_str())
            || name.starts_with("position_")
    };
    if let Some(name) = names.iter().find(|name| !is_ours(name)) {
        return Err(foreign(Some(name.clone())));
    }
    // Many programs write a result.json.
    let is_marked =
        || fs::read_to_string(target.join(contents.mark)).is_ok_and(|text| text.contains(WRITER));
    if names.is_empty() || is_marked() {
        Ok(())
    } else {
        Err(foreign(None))
    }
}

/// Writes `outcome` as folder `target`: `result.json`, `path.csv`, `load.csv`, `load_map.csv`, `convergence.csv` where a
/// rough contact was solved, tables of losses, friction laws and flanks, a folder `position_NN` with the
/// fields of each position, and `report.html`. An older result there is replaced; anything else there
/// is left alone and reported.
///
/// # Errors
/// When the system refuses, or `target` holds something else.
pub fn write_folder(outcome: &Outcome, target: &Path) -> Result<(), ReportError> {
    write_whole(target, &RESULT, |folder| fill(outcome, folder))
}

/// Adds every point of the load map of `outcome` to its result folder, as `map.csv`.
///
/// # Errors
/// When the system refuses.
pub fn write_load_points(outcome: &Outcome, folder: &Path) -> Result<(), ReportError> {
    tables::write(&folder.join(MAP), tables::load_points(&outcome.load_map))
}

/// Writes the gap of a contact without solution as CSV, in the form `asperity contact --gap` reads.
///
/// # Errors
/// When the system refuses.
pub fn write_unsolved(contact: &UnsolvedContact, file: &Path) -> Result<(), ReportError> {
    #[derive(Serialize)]
    struct Row {
        x_m: f64,
        h_m: f64,
    }
    let parent = parent_of(file);
    fs::create_dir_all(parent).map_err(ReportError::io(parent))?;
    let draft = draft_file(parent).map_err(ReportError::io(parent))?;
    let rows = contact.x.iter().zip(&contact.gap);
    tables::write(draft.path(), rows.map(|(&x_m, &h_m)| Row { x_m, h_m }))?;
    draft
        .persist(file)
        .map(|_| ())
        .map_err(|error| ReportError::io(file)(error.error))
}

/// Fills a folder beside its place and moves it there.
///
/// # Errors
/// When the system or `fill` refuses, or `target` holds anything else than such a folder.
pub fn write_whole<E: From<ReportError>>(
    target: &Path,
    contents: &Contents,
    fill: impl FnOnce(&Path) -> Result<(), E>,
) -> Result<(), E> {
    check(target, contents)?;
    let parent = parent_of(target);
    fs::create_dir_all(parent).map_err(ReportError::io(parent))?;
    // Removed with everything in it when anything below fails.
    let draft = draft_folder(parent).map_err(ReportError::io(parent))?;
    let made = draft.path().join("result");
    fs::create_dir(&made).map_err(ReportError::io(&made))?;
    fill(&made)?;
    if target.exists() {
        let old = draft.path().join("old");
        fs::rename(target, &old).map_err(ReportError::io(target))?;
        if let Err(source) = fs::rename(&made, target) {
            // Put the older result back rather than lose it; the first error is the one to tell.
            let _ = fs::rename(&old, target);
            return Err(ReportError::io(target)(source).into());
        }
        return Ok(());
    }
    fs::rename(&made, target).map_err(ReportError::io(target))?;
    Ok(())
}

fn fill(outcome: &Outcome, folder: &Path) -> Result<(), ReportError> {
    let result = &outcome.result;
    write_json(&folder.join(MARK), result)?;
    tables::write(&folder.join("path.csv"), &result.path)?;
    tables::write(&folder.join("load.csv"), &result.load.path)?;
    let steps: Vec<_> = outcome
        .fields
        .iter()
        .flat_map(tables::convergence)
        .collect();
    if !steps.is_empty() {
        tables::write(&folder.join("convergence.csv"), &steps)?;
    }
    tables::write(&folder.join("offsets.csv"), &outcome.offsets)?;
    tables::write(&folder.join("losses.csv"), tables::losses(result))?;
    tables::write(
        &folder.join("friction_laws.csv"),
        tables::friction_laws(result),
    )?;
    for fields in &outcome.fields {
        let rows = &result.path;
        if let Some(row) = rows.iter().find(|row| row.position == fields.position) {
            let place = folder.join(folder_of(fields.position));
            fs::create_dir(&place).map_err(ReportError::io(&place))?;
            write_position(&ContactTables::new(fields, row), &place)?;
        }
    }
    let shown = PageTables::of(outcome, None)?;
    tables::write_load_map(folder, &shown.load_map)?;
    for (body, flank) in shown.flanks.iter().enumerate() {
        if let Some(flank) = flank {
            flank.write(folder, body)?;
        }
    }
    let page = folder.join(PAGE);
    fs::write(&page, html::render(result, &shown)?).map_err(ReportError::io(&page))
}

fn write_position(contact: &ContactTables, place: &Path) -> Result<(), ReportError> {
    tables::write(&place.join("surface.csv"), &contact.surface)?;
    if !contact.subsurface.is_empty() {
        tables::write(&place.join("subsurface.csv"), &contact.subsurface)?;
    }
    Ok(())
}

/// Writes `value` as JSON that ends with a line feed.
///
/// # Errors
/// When the system refuses or JSON cannot hold the value.
pub fn write_json<T: Serialize>(file: &Path, value: &T) -> Result<(), ReportError> {
    let mut text = serde_json::to_string_pretty(value)?;
    text.push('\n');
    fs::write(file, text).map_err(ReportError::io(file))
}

/// Writes `text`.
///
/// # Errors
/// When the system refuses.
pub fn write_text(file: &Path, text: &str) -> Result<(), ReportError> {
    fs::write(file, text).map_err(ReportError::io(file))
}

/// Makes `folder` and those it is in.
///
/// # Errors
/// When the system refuses.
pub fn make_folder(folder: &Path) -> Result<(), ReportError> {
    fs::create_dir_all(folder).map_err(ReportError::io(folder))
}

/// Reads a result by its folder or by its `result.json`; gives its folder, too.
///
/// # Errors
/// When there is no result, or a value of it is missing or damaged.
pub fn read_result(path: &Path) -> Result<(PathBuf, RunResult), ReportError> {
    let file = match path.is_dir() {
        true => path.join(MARK),
        false => path.to_owned(),
    };
    let folder = parent_of(&file).to_owned();
    let refused = |reason| ReportError::NotAResult {
        path: file.clone(),
        reason,
    };
    let text = fs::read_to_string(&file).map_err(|_| refused("there is no such file"))?;
    let mut reader = serde_json::Deserializer::from_str(&text);
    let found = serde_path_to_error::deserialize(&mut reader);
    let result: RunResult = found.map_err(|error| {
        if error.inner().is_syntax() || error.inner().is_eof() {
            return refused("it is not JSON");
        }
        ReportError::Damaged {
            path: file.clone(),
            key: error.path().to_string(),
            source: error.into_inner(),
        }
    })?;
    reader.end().map_err(|_| refused("it is not JSON"))?;
    Ok((folder, result))
}

/// Draws `report.html` anew beside the `result.json` at `path` (or in the folder `path`) and gives its
/// place. Fields are shown at `position`, or where the pressure is highest.
///
/// # Errors
/// When the result cannot be read or the page not be written.
pub fn redraw(path: &Path, position: Option<usize>) -> Result<PathBuf, ReportError> {
    let (folder, result) = read_result(path)?;
    let shown = PageTables::read(&folder, &result, position)?;
    let file = folder.join(PAGE);
    fs::write(&file, html::render(&result, &shown)?).map_err(ReportError::io(&file))?;
    Ok(file)
}
