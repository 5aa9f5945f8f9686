//! The result folder, written beside its place and moved there whole.

use std::fs;
use std::path::{Path, PathBuf};

use super::draft::{draft_file, draft_folder, parent_of};
use super::{flanks, html, losses, tables};
use crate::error::UnsolvedContact;
use crate::result::Outcome;

/// Why a result was not written; nothing is left half-written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ReportError {
    /// The system refused.
    #[error("{path}: cannot be written: {source}")]
    Io {
        /// The file or folder.
        path: PathBuf,
        /// What the system says.
        source: std::io::Error,
    },
    /// A file or folder is in the place that is not an older result.
    #[error(
        "{path}: exists and is not a result folder{}; choose another with -o, or remove it",
        entry.as_ref().map(|name| format!(" ({name} is no part of a result)")).unwrap_or_default()
    )]
    NotOurs {
        /// What is there.
        path: PathBuf,
        /// What in the folder is foreign to a result.
        entry: Option<String>,
    },
    /// A result that is not there or not one of ours.
    #[error("{path}: not a result of asperity run: {reason}")]
    NotAResult {
        /// The file.
        path: PathBuf,
        /// What is missing.
        reason: &'static str,
    },
    /// A position that the result does not have.
    #[error("position {number} is not among the {count} of the result")]
    NoSuchPosition {
        /// What was asked for.
        number: usize,
        /// How many there are.
        count: usize,
    },
    /// A trace that cannot be prepared again.
    #[error(transparent)]
    Flank(#[from] asperity_roughness::RoughnessError),
    /// A value that JSON cannot hold.
    #[error("result.json: {0}")]
    Json(#[from] serde_json::Error),
    /// A row that CSV cannot hold.
    #[error("{path}: {source}")]
    Csv {
        /// The file.
        path: PathBuf,
        /// What the writer says.
        source: csv::Error,
    },
}

/// What a folder that is written as a whole may hold.
pub(super) struct Contents {
    /// The file that marks it as ours.
    pub mark: &'static str,
    /// The other files.
    pub files: &'static [&'static str],
}

/// The file that marks a folder as a result.
const MARK: &str = "result.json";

/// A result; beside its files are the folders of the positions.
const RESULT: Contents = Contents {
    mark: MARK,
    files: &FILES,
};

const FILES: [&str; 12] = [
    "path.csv",
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
    "report.html",
];

/// What the mark says of who wrote it.
const WRITER: &str = "\"program\": \"asperity ";

/// Whether a result may be written as folder `target`: nothing is there, or an empty folder, or an
/// older result and nothing else, since it is replaced as a whole.
///
/// # Errors
/// When something else is there.
pub fn check_place(target: &Path) -> Result<(), ReportError> {
    check(target, &RESULT)
}

fn check(target: &Path, contents: &Contents) -> Result<(), ReportError> {
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
    for entry in fs::read_dir(target).map_err(io_at(target))? {
        let entry = entry.map_err(io_at(target))?;
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

/// Writes `outcome` as folder `target`: `result.json`, `path.csv`, `convergence.csv` where a
/// rough contact was solved, tables of losses, friction laws and flanks, a folder `position_NN` with the
/// fields of each position, and `report.html`. An older result there is replaced; anything else there
/// is left alone and reported.
///
/// # Errors
/// When the system refuses, or `target` holds something else.
pub fn write_folder(outcome: &Outcome, target: &Path) -> Result<(), ReportError> {
    write_whole(target, &RESULT, |folder| fill(outcome, folder))
}

/// Writes the gap of a contact without solution as CSV, in the form `asperity contact --gap` reads.
///
/// # Errors
/// When the system refuses.
pub fn write_unsolved(contact: &UnsolvedContact, file: &Path) -> Result<(), ReportError> {
    let parent = parent_of(file);
    fs::create_dir_all(parent).map_err(io_at(parent))?;
    let draft = draft_file(parent).map_err(io_at(parent))?;
    tables::gap(&contact.x, &contact.gap, draft.path())?;
    draft
        .persist(file)
        .map(|_| ())
        .map_err(|error| io_at(file)(error.error))
}

/// Fills a folder beside its place and moves it there.
pub(super) fn write_whole(
    target: &Path,
    contents: &Contents,
    fill: impl FnOnce(&Path) -> Result<(), ReportError>,
) -> Result<(), ReportError> {
    check(target, contents)?;
    let parent = parent_of(target);
    fs::create_dir_all(parent).map_err(io_at(parent))?;
    // Removed with everything in it when anything below fails.
    let draft = draft_folder(parent).map_err(io_at(parent))?;
    let made = draft.path().join("result");
    fs::create_dir(&made).map_err(io_at(&made))?;
    fill(&made)?;
    if target.exists() {
        let old = draft.path().join("old");
        fs::rename(target, &old).map_err(io_at(target))?;
        if let Err(source) = fs::rename(&made, target) {
            // Put the older result back rather than lose it; the first error is the one to tell.
            let _ = fs::rename(&old, target);
            return Err(io_at(target)(source));
        }
        return Ok(());
    }
    fs::rename(&made, target).map_err(io_at(target))
}

fn fill(outcome: &Outcome, folder: &Path) -> Result<(), ReportError> {
    let json = folder.join(MARK);
    let mut text = serde_json::to_string_pretty(&outcome.result)?;
    text.push('\n');
    fs::write(&json, text).map_err(io_at(&json))?;
    tables::path(&outcome.result.path, &folder.join("path.csv"))?;
    if outcome
        .fields
        .iter()
        .any(|fields| !fields.history.is_empty())
    {
        tables::convergence(&outcome.fields, &folder.join("convergence.csv"))?;
    }
    tables::write(&folder.join("offsets.csv"), outcome.offsets.iter())?;
    losses::losses(&outcome.result, &folder.join("losses.csv"))?;
    losses::friction_laws(&outcome.result, &folder.join("friction_laws.csv"))?;
    flanks::write_flanks(&outcome.result.flanks, folder)?;
    for fields in &outcome.fields {
        let place = folder.join(format!("position_{:02}", fields.position));
        fs::create_dir(&place).map_err(io_at(&place))?;
        let rows = &outcome.result.path;
        if let Some(row) = rows.iter().find(|row| row.position == fields.position) {
            tables::surface(fields, row, &place.join("surface.csv"))?;
        }
        if let Some(below) = &fields.subsurface {
            tables::subsurface(&fields.x, below, &place.join("subsurface.csv"))?;
        }
    }
    html::write(folder, None)?;
    Ok(())
}

pub(super) fn io_at(path: &Path) -> impl Fn(std::io::Error) -> ReportError {
    let path = path.to_owned();
    move |source| ReportError::Io {
        path: path.clone(),
        source,
    }
}
