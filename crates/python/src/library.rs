//! Gears, steels and oils of the library, worked cases, cases from gearbox files.

use std::path::{Path, PathBuf};

use asperity::Remedy;
use asperity::message::{Code, Fault};
use asperity_fixtures::worked::{Worked, WorkedError};
use asperity_report::library::{
    gears_named, listed_gears, listed_oil, listed_steel, oils_named, steels_named, unlisted,
};
use asperity_rexs::{CaseText, Flanks, Model, case_text, contents, train_text};
use asperity_storage::{new_folder_of, whole_file};
use pyo3::prelude::*;
use serde_json::Value;

use crate::failure::{self, Failure};
use crate::work::alone;

/// Bytes of the largest gearbox file that is read.
const LARGEST: u64 = 100_000_000;

fn listed<T>(
    found: Result<Vec<T>, Fault>,
    row: fn(&T) -> Result<Value, Fault>,
) -> PyResult<String> {
    let found = found.map_err(Failure::from)?;
    let rows = found.iter().map(row).collect::<Result<Vec<_>, _>>();
    Ok(failure::json(&rows.map_err(Failure::from)?)?)
}

/// The gears of the library, or those called `name`, as JSON.
#[pyfunction]
pub fn gears(name: Option<&str>) -> PyResult<String> {
    listed(gears_named(name), listed_gears)
}

/// The steels of the library, or the one called `name`, as JSON.
#[pyfunction]
pub fn steels(name: Option<&str>) -> PyResult<String> {
    listed(steels_named(name), listed_steel)
}

/// The oils of the library, or the one called `name`, as JSON.
#[pyfunction]
pub fn oils(name: Option<&str>) -> PyResult<String> {
    listed(oils_named(name), listed_oil)
}

/// Writes a worked case into a new folder, or finds it as it is written there, and returns the folder.
#[pyfunction]
pub fn demo(
    py: Python<'_>,
    folder: Option<PathBuf>,
    gears: Option<&str>,
    paper: bool,
) -> PyResult<PathBuf> {
    let worked = match (gears, paper) {
        (Some(name), false) => Worked::Gears(name),
        (None, true) => Worked::Paper,
        (None, false) => Worked::Drive,
        (Some(_), true) => {
            return Err(Failure::new(Code::E205, "gears and paper: one of both at most").into());
        }
    };
    let folder = folder.unwrap_or_else(|| worked.folder().into());
    alone(py, || {
        let files = worked.files().map_err(|error| match error {
            WorkedError::Gears(error) => unlisted(error),
            error => Fault::internal(error),
        })?;
        let texts = files.iter().map(|file| (file.name, file.content.as_str()));
        let is_written = |(name, text): (&str, &str)| {
            whole_file(&folder.join(name), LARGEST).is_ok_and(|found| found == text.as_bytes())
        };
        if !texts.clone().all(is_written) {
            if folder.exists() {
                let message = format!("{}: exists with other content", folder.display());
                let help = Remedy::act("name another folder, as demo(\"my-first-case\")");
                return Err(Failure::new(Code::E401, message).advising(help));
            }
            let written = new_folder_of(&folder, texts);
            written.map_err(|error| Failure::new(Code::E401, error.to_string()))?;
        }
        Ok(folder)
    })
}

/// What `read` makes of a gearbox file.
fn of_gearbox_file<T: Send>(
    py: Python<'_>,
    file: &Path,
    read: impl FnOnce(&Model) -> Result<T, Fault> + Send,
) -> PyResult<T> {
    let shown = file.display().to_string();
    alone(py, || {
        let bytes = whole_file(file, LARGEST)
            .map_err(|error| Failure::new(Code::E103, error.to_string()).about(&shown))?;
        let found = Model::read(&bytes).and_then(|model| read(&model));
        found.map_err(|error| Failure::from(error).about(&shown))
    })
}

/// Version, program, stages with their operating points and lubricants of a gearbox file, as JSON.
#[pyfunction]
pub fn rexs_contents(py: Python<'_>, file: PathBuf) -> PyResult<String> {
    Ok(failure::json(&of_gearbox_file(py, &file, contents)?)?)
}

/// Text of the case of a stage of a gearbox file, or of all stages, notes, and attributes that were not read.
#[pyfunction]
pub fn from_rexs(
    py: Python<'_>,
    file: PathBuf,
    stage: Option<usize>,
    load_case: usize,
    flanks: (Option<String>, Option<String>),
) -> PyResult<(String, Vec<String>, Vec<String>)> {
    let (pinion, wheel) = flanks;
    let flanks = Flanks { pinion, wheel };
    let name = file.file_name().unwrap_or_default().to_string_lossy();
    let case: CaseText = of_gearbox_file(py, &file, |model| match stage {
        None => train_text(model, &name, load_case, &flanks),
        Some(number) => case_text(model, &name, number, load_case, &flanks),
    })?;
    Ok((case.toml, case.notes, case.not_read))
}
