//! Cases that cannot be resolved, determined before any case is run.

use std::collections::BTreeMap;

use asperity::Error;
use asperity::core::cancel::checkpoint;
use rayon::prelude::*;
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

/// Cases among `numbers` that cannot be resolved, by code.
///
/// # Errors
/// When a file has changed since the study was loaded.
pub(super) fn refusals(
    study: &Study,
    list: &CaseList,
    numbers: &[usize],
) -> Result<BTreeMap<String, Refused>, SweepError> {
    let refusals = numbers
        .par_iter()
        .filter_map(|number| {
            if let Err(cancelled) = checkpoint() {
                return Some(Err(Error::from(cancelled).into()));
            }
            match resolved(study, &list.inputs(*number)) {
                Ok(_) => None,
                Err(error @ SweepError::Changed { .. }) => Some(Err(error)),
                Err(refused) => Some(Ok((*number, refused.code_of_case(), refused.to_string()))),
            }
        })
        .collect::<Result<Vec<(usize, String, String)>, SweepError>>()?;
    let mut refused: BTreeMap<String, Refused> = BTreeMap::new();
    for (first, code, message) in refusals {
        let entry = refused.entry(code).or_insert(Refused {
            count: 0,
            first,
            message,
        });
        entry.count += 1;
    }
    Ok(refused)
}
