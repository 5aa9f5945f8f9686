//! The work of a shard.

use asperity_core::Code;
use asperity_core::task::{par_map, try_par_map};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use asperity::case::train::Train;
use asperity::core::cancel::checkpoint;
use asperity::message::{Warning, outside_codes_of_case};
use asperity::pipeline::Kept;
use asperity::{ContactStore, Contacts, Error, Run};
use asperity_storage::json_value;
use serde_json::Value;

use super::case_list::{CaseInputs, CaseList, resolved};
use super::error::SweepError;
use super::known_columns::{DRAWN, is_drawn, needs_draws, numbers_of};
use super::parts::{CaseRows, close, make_folder_of_parts, outputs, read};
use super::refused::{Refused, checked, refusals};
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
    /// Cases of the shard have been resolved.
    Checking {
        /// Number of cases resolved so far.
        cases: usize,
        /// Number of cases to resolve.
        of: usize,
    },
    /// The cases of the shard are resolved, of many the corners of the axes and a sample; none has been run.
    Checked {
        /// Cases that cannot be resolved, by code; each becomes a row with its code.
        refused: &'a BTreeMap<Code, Refused>,
        /// Number of cases resolved.
        checked: usize,
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

/// Resolves the cases of a shard that are not in a closed part in `folder`, of many some, then runs them, with events to `watch`. A
/// part is closed after 1000 cases or 30 s, and when the work is cancelled.
///
/// # Errors
/// When the study is not valid, a part cannot be written, or the work is cancelled. A case without a result becomes a row with its code.
pub fn run(
    study: &Study,
    shard: Shard,
    folder: &Path,
    watch: &(dyn Fn(Event<'_>) + Sync),
) -> Result<usize, SweepError> {
    let list = CaseList::new(study)?;
    make_folder_of_parts(study, folder)?;
    let (done, _) = read(study, &list, folder)?;
    let pending: Vec<usize> = (shard.number - 1..list.count())
        .step_by(shard.of)
        .filter(|number| !done.contains_key(number))
        .collect();
    let of = pending.len();
    let numbers = checked(&list, &pending);
    let checking = |cases, of| watch(Event::Checking { cases, of });
    let refused = &refusals(study, &list, &numbers, &checking)?;
    let checked = numbers.len();
    watch(Event::Checked {
        refused,
        checked,
        of,
    });
    let shared = SharedContacts::default();
    let (mut rows, mut opened) = (CaseRows::new(), Instant::now());
    let mut finished = 0;
    for numbers in pending.chunks(AT_ONCE) {
        // An error ends the shard; the rows finished before it are written.
        let mut ended = Ok(());
        for (number, row) in numbers.iter().zip(rows_of(study, &list, numbers, &shared)?) {
            match row {
                Ok(row) => {
                    rows.insert(*number, row);
                    finished += 1;
                }
                Err(error) => ended = ended.and(Err(error)),
            }
        }
        watch(Event::Done {
            cases: finished,
            of,
        });
        let is_full = rows.len() >= CASES_OF_A_PART || opened.elapsed() >= TIME_OF_A_PART;
        if is_full || ended.is_err() {
            close(study, &list, shard.number, shard.of, &mut rows, folder)?;
            opened = Instant::now();
        }
        ended?;
    }
    close(study, &list, shard.number, shard.of, &mut rows, folder)?;
    Ok(finished)
}

/// The rows of cases: number, id, inputs, results, codes of warnings about inputs outside of their ranges, error code. Their
/// contacts are solved first, each once, so that no case computes what another does at the same time. A row that was not finished
/// when the program was asked to stop is an error.
///
/// # Errors
/// When a file has changed since the study was loaded. Any other error of a case becomes the code of its row.
pub(super) fn rows_of(
    study: &Study,
    list: &CaseList,
    numbers: &[usize],
    shared: &SharedContacts,
) -> Result<Vec<Result<Vec<String>, SweepError>>, SweepError> {
    let resolve = |number: &usize| {
        let inputs = list.inputs(*number);
        match resolved(study, &inputs) {
            Err(error @ SweepError::Changed { .. }) => Err(error),
            found => Ok((*number, inputs, found.map_err(|error| error.code_of_case()))),
        }
    };
    let cases = try_par_map(numbers, resolve)?;
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
    let row = |(number, inputs, case)| {
        let row = row(study, number, inputs, case, &names, &store);
        checkpoint().map_err(Error::from)?;
        Ok(row)
    };
    Ok(par_map(cases, row))
}

/// Whether the meshes of a case run with the contacts that are stored for it: torques that follow from losses are not known
/// before.
fn uses_store(study: &Study, train: &Train) -> bool {
    !train.shafting.passes_losses && study.input.detail.unwrap_or_default() != Detail::Contacts
}

/// The row of a case, or its code where it cannot be resolved.
fn row(
    study: &Study,
    number: usize,
    inputs: CaseInputs,
    case: Result<(Train, String), Code>,
    names: &[String],
    store: &ContactStore,
) -> Vec<String> {
    let (id, found) = match case {
        Err(code) => (String::new(), Err(code)),
        Ok((case, id)) => {
            let with_draws = names.iter().any(|name| needs_draws(name));
            let found = result(study, &case, store, with_draws);
            (id, found.map_err(|error| error.code()))
        }
    };
    let mut row = vec![number.to_string(), id];
    row.extend(inputs.columns);
    let (outside, code) = match found {
        Ok(found) => {
            row.extend(values(&found, names));
            (found.outside, String::new())
        }
        Err(code) => {
            row.extend(names.iter().map(|_| String::new()));
            (String::new(), code.to_string())
        }
    };
    row.extend([outside, code]);
    row
}

/// Results of a case.
struct Found {
    /// Numbers by the names of their columns.
    numbers: Value,
    /// Loss at the medians with 5 and 95 % quantiles of the draws, if they are requested and the case has some.
    drawn: Option<[f64; 3]>,
    /// Codes of the warnings about inputs outside of their ranges.
    outside: String,
}

fn result(
    study: &Study,
    case: &Train,
    store: &ContactStore,
    with_draws: bool,
) -> Result<Found, Error> {
    let with_contacts = study.input.detail.unwrap_or_default() == Detail::Contacts;
    let codes = |warnings: &[Warning]| {
        let codes = warnings.iter().map(|warning| warning.code);
        codes.collect::<BTreeSet<Code>>()
    };
    let (found, summaries, mut outside) = if with_contacts {
        let run = Run::new(case).pictures(Kept::NoPictures);
        let found = run.interval(with_draws).execute()?;
        let meshes = found.meshes.into_iter().map(|mesh| mesh.result);
        let (summaries, outside): (Vec<_>, Vec<_>) = meshes
            .map(|mesh| (mesh.summary, codes(&mesh.warnings)))
            .unzip();
        let outside: BTreeSet<Code> = outside.into_iter().flatten().collect();
        (found.whole, summaries, outside)
    } else {
        let contacts: Vec<Arc<Contacts>> = case.cases().filter_map(|mesh| store.of(mesh)).collect();
        let run = Run::new(case).interval(with_draws);
        let found = run.known(contacts.iter().map(AsRef::as_ref)).losses()?;
        let warnings = found.meshes.iter().flat_map(|mesh| codes(&mesh.warnings));
        let (outside, whole) = (warnings.collect(), found.whole()?);
        let summaries = found.meshes.into_iter().map(|mesh| mesh.summary);
        let (found, summaries) = (whole, summaries.collect::<Vec<_>>());
        (found, summaries, outside)
    };
    let mut parts = found.gearbox.iter().flat_map(|gearbox| &gearbox.parts);
    if parts.any(|part| !part.outside.is_empty()) {
        outside.insert(Code::W401);
    }
    outside.extend(case.all_warnings().iter().map(|warning| warning.code));
    let numbers = match (case.only(), &summaries[..]) {
        (Some(_), [summary]) => json_value(summary).unwrap_or_default(),
        _ => numbers_of(&found),
    };
    Ok(Found {
        numbers,
        drawn: found.loss_distribution.and_then(|drawn| {
            let [low, high] = drawn.drawn.ends();
            Some([found.loss_at_medians_w?, low, high])
        }),
        outside: outside_codes_of_case(outside),
    })
}

/// The columns of a case.
fn values(found: &Found, names: &[String]) -> Vec<String> {
    let of_draws = |name: &str| {
        let place = DRAWN.iter().position(|drawn| *drawn == name)?;
        Some(found.drawn?[place].to_string())
    };
    let of = |name: &String| match found.numbers.get(name) {
        _ if is_drawn(name) => of_draws(name).unwrap_or_default(),
        Some(Value::Number(number)) => number.to_string(),
        // A known column without a number in this case.
        _ => String::new(),
    };
    names.iter().map(of).collect()
}
