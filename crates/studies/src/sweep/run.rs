//! The work of a shard.

use std::collections::{BTreeMap, HashMap};
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use asperity::case::LoadedCase;
use asperity::core::cancel::checkpoint;
use asperity::pipeline::{contacts, losses, losses_with};
use asperity::result::Summary;
use asperity::{Contacts, Error, Run};
use rayon::prelude::*;

use super::case_list::{CaseList, key_of_tables, resolved};
use super::error::SweepError;
use super::parts::{Rows, close, make_place, outputs, read};
use super::refused::{Refused, refusals};
use super::study::Study;
use super::study_input::Detail;

/// One of several shards of a study.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shard {
    /// Number from 1.
    pub number: usize,
    /// How many there are.
    pub of: usize,
}

impl std::str::FromStr for Shard {
    type Err = &'static str;

    /// Reads `3/64`.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        const FORM: &str = "must be K/N with K from 1 to N, as 3/64";
        let (number, of) = text.split_once('/').ok_or(FORM)?;
        let (number, of) = (number.trim().parse(), of.trim().parse());
        match (number, of) {
            (Ok(number), Ok(of)) if (1..=of).contains(&number) => Ok(Self { number, of }),
            _ => Err(FORM),
        }
    }
}

/// Contact tables by the part of the case that they hang on: cases of other oils, speeds and temperatures share them.
pub(super) type Kept = Mutex<HashMap<String, Arc<Contacts>>>;

/// Most tables that are held at once, some megabytes each.
const MOST_TABLES: usize = 16;
/// Cases after which a part is closed.
const CASES_OF_A_PART: usize = 1000;
/// Time after which a part is closed.
const TIME_OF_A_PART: Duration = Duration::from_secs(30);
/// Cases that are run at once.
const AT_ONCE: usize = 16;

/// What happens while a shard runs.
#[derive(Debug, Clone, Copy)]
pub enum Event<'a> {
    /// Every case to be run has been resolved, none has been run.
    Checked {
        /// Those that cannot be, by code; each will be a row with its code.
        refused: &'a BTreeMap<String, Refused>,
        /// Cases to be run.
        of: usize,
    },
    /// Cases have been run.
    Done {
        /// How many.
        cases: usize,
        /// Cases to be run.
        of: usize,
    },
}

/// Resolves all cases of a shard that no closed part in `folder` holds, then runs them; `watch` is told of both.
/// A part is closed after 1000 cases or 30 s.
///
/// # Errors
/// When the study names what cannot be, or a part cannot be written. A case without a result is a row with its code.
pub fn run(
    study: &Study,
    shard: Shard,
    folder: &Path,
    watch: &(dyn Fn(Event<'_>) + Sync),
) -> Result<usize, SweepError> {
    let list = CaseList::of(study)?;
    make_place(study, folder)?;
    let (done, _) = read(study, &list, folder)?;
    let wanted: Vec<usize> = (shard.number - 1..list.count())
        .step_by(shard.of)
        .filter(|number| !done.contains_key(number))
        .collect();
    let of = wanted.len();
    let refused = &refusals(study, &list, &wanted)?;
    watch(Event::Checked { refused, of });
    let kept = Kept::default();
    let (mut rows, mut opened) = (Rows::new(), Instant::now());
    let mut finished = 0;
    for numbers in wanted.chunks(AT_ONCE) {
        let found = numbers
            .par_iter()
            .map(|number| Ok((*number, row_of(study, &list, *number, Some(&kept))?)))
            .collect::<Result<Vec<(usize, Vec<String>)>, SweepError>>()?;
        // Rows of cancelled cases are no rows of the study.
        checkpoint().map_err(Error::from).map_err(Box::new)?;
        finished += found.len();
        rows.extend(found);
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

/// The row of a case: number, id, inputs, results, code.
///
/// # Errors
/// When a file changed since the study was loaded; any other error of the case is the code of its row.
pub(super) fn row_of(
    study: &Study,
    list: &CaseList,
    number: usize,
    kept: Option<&Kept>,
) -> Result<Vec<String>, SweepError> {
    let place = list.place(number);
    let names = outputs(study);
    let (id, found) = match resolved(study, &place) {
        Err(error @ SweepError::Changed { .. }) => return Err(error),
        Err(error) => (String::new(), Err(error.code_of_case())),
        Ok((case, id)) => {
            let summary = summary(study, &case, kept);
            (id, summary.map_err(|error| error.code().to_owned()))
        }
    };
    let mut row = vec![number.to_string(), id];
    row.extend(place.columns);
    match found.and_then(|summary| values(&summary, &names)) {
        Ok(values) => {
            row.extend(values);
            row.push(String::new());
        }
        Err(code) => {
            row.extend(names.iter().map(|_| String::new()));
            row.push(code);
        }
    }
    Ok(row)
}

fn summary(study: &Study, case: &LoadedCase, kept: Option<&Kept>) -> Result<Summary, Error> {
    if study.input.detail.unwrap_or_default() == Detail::Contacts {
        let run = Run::new(case).without_pictures();
        return Ok(run.execute()?.result.summary);
    }
    if let Some(tables) = kept.and_then(|kept| tables(case, kept)) {
        // Tables that turn out to be of another contact refuse.
        if let Ok(found) = losses_with(&tables, case) {
            return Ok(found.summary);
        }
    }
    Ok(losses(case)?.summary)
}

/// The contact tables of a case, made at their first need.
fn tables(case: &LoadedCase, kept: &Kept) -> Option<Arc<Contacts>> {
    let key = key_of_tables(case)?;
    let held = || kept.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(found) = held().get(&key) {
        return Some(Arc::clone(found));
    }
    let made = Arc::new(contacts(case).ok()?);
    let mut held = held();
    if held.len() >= MOST_TABLES {
        held.clear();
    }
    held.insert(key, Arc::clone(&made));
    Some(made)
}

/// The columns of a summary; none of them where one is not of it.
fn values(summary: &Summary, names: &[String]) -> Result<Vec<String>, String> {
    let value = serde_json::to_value(summary).map_err(|_| "E501".to_owned())?;
    let of = |name: &String| match value.get(name) {
        Some(serde_json::Value::Number(number)) => Ok(number.to_string()),
        Some(serde_json::Value::Null) => Ok(String::new()),
        _ => Err("E402".to_owned()),
    };
    names.iter().map(of).collect()
}
