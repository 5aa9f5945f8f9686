//! The job of the page: what `asperity run` does, without a file system.

use asperity::case::gear_train::{self, LoadedTrain, TrainCaseInput};
use asperity::case::{self, AnyInput, CaseInput, DefaultUsed, Source};
use asperity::gear_train::{TrainOutcome, run_train};
use asperity::message::Code;
use asperity::pipeline::{KeptFields, Progress};
use asperity::result::RunResult;
use asperity_report::{
    Tile, summary, summary_of_train, texts, texts_of_train, tiles, tiles_of_train,
};
use asperity_studies::estimate::{estimate, estimate_of_train};

use crate::failure::Failure;
use crate::files::Files;

/// Bytes of fields that the memory of a page has room for, beside what else is in it: it ends at 4 GiB.
const MOST_BYTES: f64 = 2e9;

/// A result, and what a comparison with another one needs.
#[derive(Debug, Clone)]
pub struct Finished {
    /// The case: a pair of gears or a gear train.
    pub train: LoadedTrain,
    /// Its run.
    pub outcome: TrainOutcome,
    /// The files of the result folder.
    pub files: Vec<(String, Vec<u8>)>,
}

impl Finished {
    /// The result of a pair of gears; `None` of a gear train.
    #[must_use]
    pub fn pair(&self) -> Option<&RunResult> {
        let run = self.outcome.meshes.first()?;
        self.train.pair().and(Some(&run.result))
    }

    /// The summary as the command prints it, with all notes.
    #[must_use]
    pub fn summary(&self) -> String {
        let of_train = || summary_of_train(&self.outcome);
        self.pair().map_or_else(of_train, summary)
    }

    /// The headline of the result.
    #[must_use]
    pub fn tiles(&self) -> Vec<Tile> {
        let of_train = || tiles_of_train(&self.outcome.result);
        self.pair().map_or_else(of_train, tiles)
    }

    /// The keys of the case.
    #[must_use]
    pub fn inputs(&self) -> &AnyInput {
        &self.train.input
    }

    /// The defaults in use.
    pub(crate) fn defaults(&self) -> &[DefaultUsed] {
        let of_train = &self.train.defaults;
        self.pair().map_or(of_train, |pair| &pair.defaults)
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
    let outcome = run_train(&train, &KeptFields::Highest, true, progress)
        .map_err(|error| Failure::of_run(name, &error))?;
    let files = match (train.pair(), &outcome.meshes[..]) {
        (Some(_), [run]) => {
            let files = texts(run)?.into_iter();
            files.map(|(name, text)| (name.to_owned(), text)).collect()
        }
        _ => texts_of_train(&outcome)?,
    };
    Ok(Finished {
        train,
        outcome,
        files,
    })
}

fn load(name: &str, text: &str, files: &Files) -> Result<LoadedTrain, Failure> {
    let find = |file: &str| Ok(files.find(file)?.to_vec());
    let loaded = match gear_train::is_train(&read(name, text)?) {
        true => gear_train::from_text(name, text, &find),
        false => case::from_text(name, text, &find).map(LoadedTrain::from),
    };
    loaded.map_err(|error| Failure::from(&error))
}

fn read(name: &str, text: &str) -> Result<Source, Failure> {
    Source::from_bytes(name, text.as_bytes())
        .map_err(|error| Failure::from(&asperity::Error::from(error)))
}

fn check_memory(train: &LoadedTrain) -> Result<(), Failure> {
    // A case that has no estimate has no run, which says why.
    let Ok(work) = estimate_of_train(train, &KeptFields::Highest, estimate) else {
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
    let source = read(name, text)?;
    let input = match gear_train::is_train(&source) {
        true => {
            let input = source.read::<TrainCaseInput>();
            input.map(|input| AnyInput::Train(input.into()))
        }
        false => {
            let input = source.read::<CaseInput>();
            input.map(|input| AnyInput::Mesh(input.into()))
        }
    };
    let input = input.map_err(|error| Failure::from(&asperity::Error::from(error)))?;
    Ok(serde_json::to_string(&input)?)
}
