//! Plan of a study before it runs.

use std::collections::BTreeMap;
use std::time::Instant;

use asperity_core::Code;
use serde::Serialize;

use super::case_list::CaseList;
use super::error::SweepError;
use super::refused::{Refused, checked, refusals};
use super::run::{SharedContacts, rows_of};
use super::study::Study;

/// Size of a study and its estimated time.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Plan {
    /// Hash of the study.
    pub study: String,
    /// Number of cases.
    pub cases: usize,
    /// Number of points of the crossed axes.
    pub axis_points: usize,
    /// Number of points of the sample.
    pub sample_points: usize,
    /// Number of cases that were resolved: all, of many the corners of the axes and a sample.
    pub checked: usize,
    /// Cases among them that cannot be resolved, by code: their number, and the first of them with its message.
    pub refused: BTreeMap<Code, Refused>,
    /// Estimated time on the threads of the pool \[s\], from a few cases that were run.
    pub seconds: f64,
    /// Estimated size of the table \[bytes\].
    pub bytes: f64,
}

/// Resolves the cases, of many the corners of the axes and a sample, and runs a few; `watch` is called with (done, total).
///
/// # Errors
/// When the study is not valid.
pub fn plan(study: &Study, watch: &(dyn Fn(usize, usize) + Sync)) -> Result<Plan, SweepError> {
    /// Number of cases run for the estimate.
    const SAMPLED: usize = 3;
    let list = CaseList::new(study)?;
    let count = list.count();
    let checked = checked(&list, &Vec::from_iter(0..count));
    let refused = refusals(study, &list, &checked, watch)?;
    let begin = Instant::now();
    let few = SAMPLED.min(count);
    let mut bytes = 0;
    for k in 0..few {
        for row in rows_of(study, &list, &[k * count / few], &SharedContacts::default())? {
            bytes += row?.iter().map(|cell| cell.len() + 1).sum::<usize>();
        }
    }
    let each = |total: f64| total / few.max(1) as f64 * count as f64;
    Ok(Plan {
        study: study.hash.clone(),
        cases: count,
        axis_points: list.per_sample(),
        sample_points: list.samples(),
        checked: checked.len(),
        refused,
        seconds: each(begin.elapsed().as_secs_f64()),
        bytes: each(bytes as f64),
    })
}
