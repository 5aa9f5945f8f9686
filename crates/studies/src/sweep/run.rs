//! The work of a shard.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use asperity::case::LoadedCase;
use asperity::case::gear_train::LoadedTrain;
use asperity::core::cancel::checkpoint;
use asperity::gear_train::{run_train, train_losses};
use asperity::pipeline::{KeptFields, losses, losses_with};
use asperity::result::{Losses, Summary};
use asperity::uncertainty::{Predictive, Quantiles, predictive};
use asperity::{ContactStore, Error, Run};
use rayon::prelude::*;
use serde_json::Value;

use super::case_list::{CaseInputs, CaseList, resolved};
use super::error::SweepError;
use super::known_columns::{DRAWN, is_drawn, needs_draws, numbers_of};
use super::parts::{Rows, close, make_folder_of_parts, outputs, read};
use super::refused::{Refused, refusals};
use super::study::Study;
use super::study_input::Detail;

/// One of several shards of a study.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shard {
    /// Number from 1.
    pub number: usize,
    /// Number of shards.
    pub of: usize,
}

impl std::str::FromStr for Shard {
    type Err = &'static str;

    /// Reads `3/64`.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        const FORM: &str = "must be K/N with K from 1 to N, such as 3/64";
        let (number, of) = text.split_once('/').ok_or(FORM)?;
        let (number, of) = (number.trim().parse(), of.trim().parse());
        match (number, of) {
            (Ok(number), Ok(of)) if (1..=of).contains(&number) => Ok(Self { number, of }),
            _ => Err(FORM),
        }
    }
}

/// Contacts of the cases of a study: those with other oils, speeds and temperatures share them.
pub(super) type SharedContacts = Mutex<ContactStore>;

/// Number of cases after which a part is closed.
const CASES_OF_A_PART: usize = 1000;
/// Time after which a part is closed.
const TIME_OF_A_PART: Duration = Duration::from_secs(30);
/// Number of cases run in parallel.
const AT_ONCE: usize = 16;

/// Progress event of a shard.
#[derive(Debug, Clone, Copy)]
pub enum Event<'a> {
    /// All cases of the shard are resolved; none has been run.
    Checked {
        /// Cases that cannot be resolved, by code; each becomes a row with its code.
        refused: &'a BTreeMap<String, Refused>,
        /// Number of cases to run.
        of: usize,
    },
    /// Cases have been run.
    Done {
        /// Number of cases run so far.
        cases: usize,
        /// Number of cases to run.
        of: usize,
    },
}

/// Resolves all cases of a shard that are not in a closed part in `folder`, then runs them, with events to `watch`. A
/// part is closed after 1000 cases or 30 s.
///
/// # Errors
/// When the study is not valid, or a part cannot be written. A case without a result becomes a row with its code.
pub fn run(
    study: &Study,
    shard: Shard,
    folder: &Path,
    watch: &(dyn Fn(Event<'_>) + Sync),
) -> Result<usize, SweepError> {
    let list = CaseList::of(study)?;
    make_folder_of_parts(study, folder)?;
    let (done, _) = read(study, &list, folder)?;
    let pending: Vec<usize> = (shard.number - 1..list.count())
        .step_by(shard.of)
        .filter(|number| !done.contains_key(number))
        .collect();
    let of = pending.len();
    let refused = &refusals(study, &list, &pending)?;
    watch(Event::Checked { refused, of });
    let shared = SharedContacts::default();
    let (mut rows, mut opened) = (Rows::new(), Instant::now());
    let mut finished = 0;
    for numbers in pending.chunks(AT_ONCE) {
        let results = rows_of(study, &list, numbers, &shared)?;
        // Rows of cancelled cases are not written.
        checkpoint().map_err(Error::from).map_err(Box::new)?;
        finished += results.len();
        rows.extend(numbers.iter().copied().zip(results));
        watch(Event::Done {
            cases: finished,
            of,
        });
        if rows.len() >= CASES_OF_A_PART || opened.elapsed() >= TIME_OF_A_PART {
            close(study, &list, (shard.number, shard.of), &mut rows, folder)?;
            opened = Instant::now();
        }
    }
    close(study, &list, (shard.number, shard.of), &mut rows, folder)?;
    Ok(finished)
}

/// The rows of cases: number, id, inputs, results, code. Their contacts are solved first, each once, so that no case computes
/// what another does at the same time.
///
/// # Errors
/// When a file has changed since the study was loaded. Any other error of a case becomes the code of its row.
pub(super) fn rows_of(
    study: &Study,
    list: &CaseList,
    numbers: &[usize],
    shared: &SharedContacts,
) -> Result<Vec<Vec<String>>, SweepError> {
    let resolve = |number: &usize| {
        let inputs = list.inputs(*number);
        match resolved(study, &inputs) {
            Err(error @ SweepError::Changed { .. }) => Err(error),
            found => Ok((*number, inputs, found.map_err(|error| error.code_of_case()))),
        }
    };
    let cases = numbers.par_iter().map(resolve);
    let cases = cases.collect::<Result<Vec<_>, SweepError>>()?;
    let store = {
        let mut shared = shared.lock().unwrap_or_else(PoisonError::into_inner);
        let trains = cases
            .iter()
            .filter_map(|(.., case)| Some(&case.as_ref().ok()?.0));
        let meshes = trains
            .filter(|train| uses_store(study, train))
            .flat_map(|train| train.meshes().map(|mesh| &mesh.case));
        shared.prepare(&meshes.collect::<Vec<_>>());
        shared.clone()
    };
    let names = outputs(study);
    let row = |(number, inputs, case)| row(study, (number, inputs, case), &names, &store);
    Ok(cases.into_par_iter().map(row).collect())
}

/// Whether the meshes of a case run with the contacts that are stored for it: torques that follow from losses are not known
/// before.
fn uses_store(study: &Study, train: &LoadedTrain) -> bool {
    !train.train.passes_losses && study.input.detail.unwrap_or_default() != Detail::Contacts
}

/// The row of a case, or its code where it cannot be resolved.
fn row(
    study: &Study,
    (number, inputs, case): (usize, CaseInputs, Result<(LoadedTrain, String), String>),
    names: &[String],
    store: &ContactStore,
) -> Vec<String> {
    let (id, found) = match case {
        Err(code) => (String::new(), Err(code)),
        Ok((case, id)) => {
            let with_draws = names.iter().any(|name| needs_draws(name));
            let found = result(study, &case, store, with_draws);
            (id, found.map_err(|error| error.code().to_owned()))
        }
    };
    let mut row = vec![number.to_string(), id];
    row.extend(inputs.columns);
    match found.map(|found| values(&found, names)) {
        Ok(values) => {
            row.extend(values);
            row.push(String::new());
        }
        Err(code) => {
            row.extend(names.iter().map(|_| String::new()));
            row.push(code);
        }
    }
    row
}

/// Numbers of a case by the names of their columns, and median, 5 and 95 % quantiles of its draws if they are requested and
/// the case has some.
type Found = (Value, Option<[f64; 3]>);

fn result(
    study: &Study,
    case: &LoadedTrain,
    store: &ContactStore,
    with_draws: bool,
) -> Result<Found, Error> {
    let columns = |median, [low, high]: [f64; 2]| [median, low, high];
    let of_draws = |found: Quantiles| columns(found.median_w, found.quantiles_w);
    let with_contacts = study.input.detail.unwrap_or_default() == Detail::Contacts;
    let of_mesh = |case: &LoadedCase| mesh_losses(case, store, with_draws);
    let Some(pair) = case.pair() else {
        let found = match with_contacts {
            true => run_train(case, &KeptFields::Highest, with_draws, &|_, _| {})?.result,
            false => train_losses(case, &of_mesh)?,
        };
        return Ok((numbers_of(&found), found.loss_distribution.map(of_draws)));
    };
    let numbers = |summary: &Summary| serde_json::to_value(summary).unwrap_or_default();
    if with_contacts {
        let run = Run::new(pair).without_pictures().band(with_draws);
        let found = run.execute()?.result;
        let drawn = found.uncertainty.map(|found| found.loss);
        return Ok((
            numbers(&found.summary),
            drawn.map(|loss| columns(loss.median_w, loss.quantiles_w)),
        ));
    }
    let (losses, draws) = of_mesh(pair)?;
    let drawn = draws.map(|draws| of_draws(Quantiles::of(&draws.draws_w())));
    Ok((numbers(&losses.summary), drawn))
}

/// Losses of a mesh with its draws, if they are requested and it has some.
fn mesh_losses(
    case: &LoadedCase,
    store: &ContactStore,
    with_draws: bool,
) -> Result<(Losses, Option<Predictive>), Error> {
    let contacts = store.of(case);
    let losses = match &contacts {
        Some(contacts) => losses_with(contacts, case)?,
        None => losses(case)?,
    };
    let draws = match with_draws {
        true => predictive(case, &losses, contacts.as_deref())?,
        false => None,
    };
    Ok((losses, draws))
}

/// The columns of a case.
fn values((value, drawn): &Found, names: &[String]) -> Vec<String> {
    let of_draws = |name: &str| {
        let place = DRAWN.iter().position(|drawn| *drawn == name)?;
        Some(drawn.as_ref()?[place].to_string())
    };
    let of = |name: &String| match value.get(name) {
        _ if is_drawn(name) => of_draws(name).unwrap_or_default(),
        Some(Value::Number(number)) => number.to_string(),
        // A known column without a number in this case.
        _ => String::new(),
    };
    names.iter().map(of).collect()
}
