//! The job of the page: what `asperity run` does, without a file system.

use asperity::Run;
use asperity::case::{self, CaseInput, LoadedCase, Source, gear_train};
use asperity::flanks::Surfaces;
use asperity::pipeline::KeptFields;
use asperity::pipeline::Progress;
use asperity::result::RunResult;
use asperity::uncertainty::Predictive;
use asperity_report::{FileText, summary, texts, tiles};
use asperity_studies::estimate::estimate;

use crate::failure::Failure;
use crate::files::Files;

/// Bytes of fields that the memory of a page has room for, beside what else is in it: it ends at 4 GiB.
const MOST_BYTES: f64 = 2e9;

/// A result, and what a comparison with another one needs.
#[derive(Debug, Clone)]
pub struct Finished {
    /// The result.
    pub result: RunResult,
    /// The files of the result folder.
    pub files: Vec<FileText>,
    /// Draws of the loss; `None` if the model has no uncertainty.
    pub(crate) predictive: Option<Predictive>,
    /// The flanks.
    pub(crate) surfaces: Surfaces,
}

impl Finished {
    /// The summary as the command prints it, with all notes.
    #[must_use]
    pub fn summary(&self) -> String {
        summary(&self.result)
    }

    /// The headline of the result as JSON.
    ///
    /// # Errors
    /// When it cannot be written.
    pub fn tiles(&self) -> Result<String, Failure> {
        Ok(serde_json::to_string(&tiles(&self.result))?)
    }
}

/// Runs the case in `text`, called `name`, on `files`.
///
/// # Errors
/// When the case cannot be read or run, as for `asperity run`; when it has several meshes; and when its fields
/// would not fit into the memory of a page.
pub fn run(
    name: &str,
    text: &str,
    files: &Files,
    progress: Progress<'_>,
) -> Result<Finished, Failure> {
    let loaded = load(name, text, files)?;
    check_memory(&loaded)?;
    let (outcome, predictive) = Run::new(&loaded)
        .fields(&KeptFields::Highest)
        .progress(progress)
        .draw()
        .map_err(|error| Failure::of_run(name, &error))?;
    Ok(Finished {
        files: texts(&outcome)?,
        result: outcome.result,
        predictive,
        surfaces: loaded.surfaces,
    })
}

fn load(name: &str, text: &str, files: &Files) -> Result<LoadedCase, Failure> {
    let source = read(name, text)?;
    if gear_train::is_train(&source) {
        let message =
            format!("{name}: has several meshes; the page takes a pair of gears, the command both");
        return Err(Failure::new("E205", message));
    }
    case::from_text(name, text, &|file| Ok(files.find(file)?.to_vec()))
        .map_err(|error| Failure::from(&error))
}

fn read(name: &str, text: &str) -> Result<Source, Failure> {
    Source::from_bytes(name, text.as_bytes())
        .map_err(|error| Failure::from(&asperity::Error::from(error)))
}

fn check_memory(loaded: &LoadedCase) -> Result<(), Failure> {
    // A case that has no estimate has no run, which says why.
    let Ok(work) = estimate(loaded, &KeptFields::Highest) else {
        return Ok(());
    };
    if work.bytes <= MOST_BYTES {
        return Ok(());
    }
    let message = format!(
        "{} rough contacts take about {:.1} GB of memory (limit {:.0}); reduce model.positions or model.offsets, \
         or run the case with the command",
        work.contacts,
        work.bytes / 1e9,
        MOST_BYTES / 1e9,
    );
    Err(Failure::new("E209", message))
}

/// The keys of the case in `text` as JSON, for a form to show; its files are not opened.
///
/// # Errors
/// When the text is no case.
pub fn keys(name: &str, text: &str) -> Result<String, Failure> {
    let input: CaseInput = read(name, text)?
        .read()
        .map_err(|error| Failure::from(&asperity::Error::from(error)))?;
    Ok(serde_json::to_string(&input)?)
}
