//! The job of the page: what `asperity run` does, without a file system.

use asperity::Run;
use asperity::case::{CaseInput, DefaultUsed, Source, Train};
use asperity::message::Code;
use asperity::pipeline::{Kept, Progress};
use asperity::train::Outcome;
use asperity_calibration::evidence::standard_plan;
use asperity_report::{COLUMNS, Results, Tile, texts};
use asperity_studies::estimate::estimate;

use crate::failure::Failure;
use crate::files::Files;

/// Bytes of fields that the memory of a page has room for, beside what else is in it: it ends at 4 GiB.
const MOST_BYTES: f64 = 2e9;

/// A result, and what a comparison with another one needs.
#[derive(Debug, Clone)]
pub struct Finished {
    /// The case: a pair of gears or a gear train.
    pub train: Train,
    /// Its run.
    pub outcome: Outcome,
    /// The files of the result folder.
    pub files: Vec<(String, Vec<u8>)>,
}

impl Finished {
    /// The summary as the command prints it, with all notes.
    #[must_use]
    pub fn summary(&self) -> String {
        Results::from(&self.outcome).summary(COLUMNS)
    }

    /// The headline of the result.
    #[must_use]
    pub fn tiles(&self) -> Vec<Tile> {
        Results::from(&self.outcome).tiles()
    }

    /// The keys of the case.
    #[must_use]
    pub fn inputs(&self) -> &CaseInput {
        &self.train.input
    }

    /// The defaults in use.
    pub(crate) fn defaults(&self) -> &[DefaultUsed] {
        let only = self.outcome.only();
        only.map_or(&self.train.defaults, |only| &only.result.defaults)
    }
}

/// Runs the case in `text`, called `name`, on `files`.
///
/// # Errors
/// When the case cannot be read or run, as for `asperity run`, and when its fields would not fit into the memory of a page.
pub fn run(
    name: &str,
    text: &str,
    files: &Files,
    progress: Progress<'_>,
) -> Result<Finished, Failure> {
    let train = load(name, text, files)?;
    check_memory(&train)?;
    let run = Run::new(&train).pictures(Kept::Highest).interval(true);
    let outcome = run
        .evidence(&standard_plan)
        .progress(progress)
        .execute()
        .map_err(|error| Failure::of_run(name, &error))?;
    let files = texts(&outcome)?;
    Ok(Finished {
        train,
        outcome,
        files,
    })
}

fn load(name: &str, text: &str, files: &Files) -> Result<Train, Failure> {
    let find = |file: &str| Ok(files.find(file)?.to_vec());
    Train::from_text(name, text, &find).map_err(|error| Failure::from(&error))
}

fn check_memory(train: &Train) -> Result<(), Failure> {
    // A case that has no estimate has no run, which says why.
    let Ok(work) = estimate(train.cases(), &Kept::Highest) else {
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
    Err(Failure::new(Code::E209, message))
}

/// The keys of the case in `text` as JSON, for a form to show; its files are not opened.
///
/// # Errors
/// When the text is no case.
pub fn keys(name: &str, text: &str) -> Result<String, Failure> {
    let source = Source::from_bytes(name, text.as_bytes()).map_err(asperity::Error::from);
    let input = source.and_then(|source| CaseInput::of_source(&source));
    let input = input.map_err(|error| Failure::from(&error))?;
    Ok(input.store(serde_json::value::Serializer)?.to_string())
}
