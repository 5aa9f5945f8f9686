//! Merging of the parts of a study.

use std::path::Path;

use asperity::fingerprint::sha256;

use super::case_list::CaseList;
use super::effects::{Indices, effects, sobol_indices};
use super::error::SweepError;
use super::merged::{EffectRow, Merged};
use super::parts::{Rows, header, other_inputs, outputs, read, text_of};
use super::study::Study;
use crate::map::ranges;

/// Merges the parts in `folder`.
///
/// # Errors
/// When a case is in no part, a part is damaged, or two parts contradict each other.
pub fn merge(study: &Study, folder: &Path) -> Result<Merged, SweepError> {
    let list = CaseList::of(study)?;
    let (rows, _) = read(study, &list, folder)?;
    let count = list.count();
    if rows.len() < count {
        let missing: Vec<usize> = (0..count).filter(|n| !rows.contains_key(n)).collect();
        return Err(SweepError::Missing {
            count,
            missing: missing.len(),
            numbers: ranges(&missing),
            others: other_inputs(study, folder),
        });
    }
    let table = text_of(&header(study, &list), rows.values().cloned(), folder)?;
    let has_code = |row: &&Vec<String>| row.last().is_some_and(|code| !code.is_empty());
    Ok(Merged {
        name: study.name.clone(),
        study: study.hash.clone(),
        title: study.case.case.title.clone(),
        cases: count,
        failed: rows.values().filter(has_code).count(),
        sha256: sha256(&table),
        effects: effects_of(study, &list, &rows),
        table,
    })
}

/// Mean of a result over the axes at each point of the sample; `None` if one of its cases has no result.
fn over_axes(list: &CaseList, rows: &Rows, column: usize) -> Vec<Option<f64>> {
    let (samples, axes) = (list.samples(), list.per_sample());
    let mean = |point: usize| {
        let cells =
            (0..axes).map(|at| rows.get(&(at * samples + point))?.get(column)?.parse().ok());
        let values: Option<Vec<f64>> = cells.collect();
        values.map(|values| values.iter().sum::<f64>() / axes as f64)
    };
    (0..samples).map(mean).collect()
}

fn effects_of(study: &Study, list: &CaseList, rows: &Rows) -> Vec<EffectRow> {
    let (inputs, outputs) = (list.sampled(), outputs(study));
    let first = 2 + list.columns().len();
    let numbers: Vec<Vec<f64>> = (0..list.samples())
        .map(|point| list.numbers(point))
        .collect();
    let seed = study.input.sample.as_ref().map_or(0, |sample| sample.seed);
    let mut effect_rows = Vec::new();
    for (at, output) in outputs.iter().enumerate() {
        let values = over_axes(list, rows, first + at);
        let indices = list
            .block()
            .and_then(|block| indices(&values, block, inputs.len(), seed));
        for (index, input) in inputs.iter().enumerate() {
            // The blocks of Saltelli repeat the inputs of A, so the main effect is computed from A only.
            let few = list.block().unwrap_or(values.len());
            let pairs: Vec<(f64, f64)> = numbers
                .iter()
                .zip(&values)
                .take(few)
                .filter_map(|(x, y)| Some((*x.get(index)?, (*y)?)))
                .collect();
            let (x, y): (Vec<f64>, Vec<f64>) = pairs.into_iter().unzip();
            effect_rows.push(EffectRow {
                output: output.clone(),
                input: input.clone(),
                effect: effects(&x, &y),
                indices: indices.as_ref().and_then(|all| all.get(index).copied()),
            });
        }
    }
    effect_rows
}

/// Indices from the blocks; points at which a block has no result are omitted.
fn indices(values: &[Option<f64>], block: usize, inputs: usize, seed: u64) -> Option<Vec<Indices>> {
    let blocks: Vec<&[Option<f64>]> = values.chunks(block).collect();
    let is_whole = |k: &usize| {
        blocks
            .iter()
            .all(|block| block.get(*k).is_some_and(Option::is_some))
    };
    let whole: Vec<usize> = (0..block).filter(is_whole).collect();
    let of = |number: usize| -> Option<Vec<f64>> {
        let block = blocks.get(number)?;
        whole.iter().map(|k| block[*k]).collect()
    };
    let mixed = (0..inputs).map(|i| of(i + 2)).collect::<Option<Vec<_>>>()?;
    sobol_indices(&of(0)?, &of(1)?, &mixed, seed)
}
