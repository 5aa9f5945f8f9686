//! Cases that cannot be resolved, determined before any case is run.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::atomic::{AtomicUsize, Ordering};

use asperity::Error;
use asperity::core::cancel::checkpoint;
use asperity_core::Code;
use asperity_core::numerics::GOLDEN_SECTION;
use asperity_core::task::try_par_map;
use serde::Serialize;

use super::case_list::{CaseList, resolved};
use super::error::SweepError;
use super::study::Study;

/// Cases that cannot be resolved.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Refused {
    /// Number of cases.
    pub count: usize,
    /// Number of the first.
    pub first: usize,
    /// Message of the first.
    pub message: String,
}

/// Largest number of cases that are all resolved before a run, a few milliseconds each.
const MOST: usize = 2000;
/// Largest number of corners of the axes that are resolved.
const MOST_CORNERS: usize = 512;

/// The cases among `numbers` (sorted) that are resolved before a run: all of them, of many the corners of the axes and a
/// sample.
pub(super) fn checked(list: &CaseList, numbers: &[usize]) -> Vec<usize> {
    if numbers.len() <= MOST {
        return numbers.to_vec();
    }
    let corners = list.corners().take(MOST_CORNERS);
    let corners = corners.filter(|number| numbers.binary_search(number).is_ok());
    let spread = (0..MOST).map(|k| {
        let share = (GOLDEN_SECTION * k as f64).fract();
        numbers[(share * numbers.len() as f64) as usize]
    });
    let all: BTreeSet<usize> = corners.chain(spread).collect();
    all.into_iter().collect()
}

/// Cases among `numbers` that cannot be resolved, by code; `watch` is called with (done, total).
///
/// # Errors
/// When a file has changed since the study was loaded.
pub(super) fn refusals(
    study: &Study,
    list: &CaseList,
    numbers: &[usize],
    watch: &(dyn Fn(usize, usize) + Sync),
) -> Result<BTreeMap<Code, Refused>, SweepError> {
    let done = AtomicUsize::new(0);
    let refusals = try_par_map(numbers, |number| {
        checkpoint().map_err(Error::from)?;
        watch(done.fetch_add(1, Ordering::Relaxed) + 1, numbers.len());
        match resolved(study, &list.inputs(*number)) {
            Ok(_) => Ok(None),
            Err(error @ SweepError::Changed { .. }) => Err(error),
            Err(refused) => Ok(Some((*number, refused.code_of_case(), refused.to_string()))),
        }
    })?;
    let mut refused: BTreeMap<Code, Refused> = BTreeMap::new();
    for (first, code, message) in refusals.into_iter().flatten() {
        let entry = refused.entry(code).or_insert(Refused {
            count: 0,
            first,
            message,
        });
        entry.count += 1;
    }
    Ok(refused)
}
