//! Merging of the parts of a study.

use std::collections::BTreeMap;
use std::path::Path;

use asperity::case::MeshLoad;
use asperity::fingerprint::sha256;
use asperity_core::decimals;

use super::case_list::CaseList;
use super::columns::InputColumn;
use super::effects::{Indices, Regressor, effects, sobol_indices};
use super::error::SweepError;
use super::merged::{EffectRow, Merged};
use super::parts::{CaseRows, header, other_inputs, outputs, read, text_of};
use super::study::Study;
use crate::map::ranges;

/// Merges the parts in `folder`.
///
/// # Errors
/// When a case is in no part, a part is damaged, or two parts contradict each other.
pub fn merge(study: &Study, folder: &Path) -> Result<Merged, SweepError> {
    let list = CaseList::new(study)?;
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
    let inputs = inputs_of(&list, &rows);
    let table = table(study, &list, &rows, &inputs, folder)?;
    let has_code = |row: &&Vec<String>| row.last().is_some_and(|code| !code.is_empty());
    Ok(Merged {
        name: study.name.clone(),
        study: study.hash.clone(),
        title: study.case.title.clone(),
        cases: count,
        failed: rows.values().filter(has_code).count(),
        outside: outside_of(&rows),
        sha256: sha256(&table),
        effects: effects_of(study, &list, &rows, &inputs),
        outputs: values_of(study, &rows, first_output(&list)),
        axes: list.columns().len() - list.sampled().len(),
        constant: study.axes.constant(),
        conditions: conditions(study, &list),
        inputs,
        table,
    })
}

/// Operating point of the case in words, without what an axis or the sample varies.
fn conditions(study: &Study, list: &CaseList) -> String {
    let sampled = list.sampled();
    let axes = study.axes.keys().flatten();
    let varied: Vec<&str> = axes.chain(sampled.iter().map(String::as_str)).collect();
    let is_of_point = |key: &&str| ["operation.torque", "operation.speed"].contains(key);
    let is_constant = |key: &str| !varied.contains(&key);
    let is_heat = |key: &&str| key.starts_with("operation") && !is_of_point(key);
    let MeshLoad { torque, speed } = study.case.shafting.operation();
    let temperature = study.case.input.operation.stated_temperature();
    let temperature = temperature.filter(|_| !varied.iter().any(is_heat));
    let parts = [
        is_constant("operation.torque").then(|| format!("{} N m", decimals(torque.si(), 1))),
        is_constant("operation.speed").then(|| {
            let rpm = speed.si() * 30.0 / std::f64::consts::PI;
            format!("{} 1/min", decimals(rpm, 0))
        }),
        temperature.map(|of| format!("flanks at {} °C", decimals(of.celsius(), 0))),
    ];
    parts.into_iter().flatten().collect::<Vec<_>>().join(", ")
}

/// Number of cases by the codes in the column before that of the error codes.
fn outside_of(rows: &CaseRows) -> BTreeMap<String, usize> {
    let mut counts = BTreeMap::new();
    let cells = rows.values().filter_map(|row| row.iter().rev().nth(1));
    for code in cells.flat_map(|cell| cell.split_whitespace()) {
        *counts.entry(code.to_owned()).or_insert(0) += 1;
    }
    counts
}

/// Number and id of a case are before its inputs.
const BEFORE: usize = 2;

/// Index of the first result in a row.
fn first_output(list: &CaseList) -> usize {
    BEFORE + list.columns().len()
}

fn inputs_of(list: &CaseList, rows: &CaseRows) -> Vec<InputColumn> {
    let names = list.columns().into_iter().enumerate();
    let column = |(at, name)| {
        let cells = rows
            .values()
            .filter_map(|row| row.get(BEFORE + at).cloned());
        InputColumn::new(name, cells.collect())
    };
    names.map(column).collect()
}

/// The table with numbers in the columns of the inputs, their units in the header.
fn table(
    study: &Study,
    list: &CaseList,
    rows: &CaseRows,
    inputs: &[InputColumn],
    folder: &Path,
) -> Result<Vec<u8>, SweepError> {
    let mut names = header(study, list);
    for (name, input) in names[BEFORE..].iter_mut().zip(inputs) {
        *name = input.header();
    }
    let numbered = rows.values().enumerate().map(|(at, row)| {
        let mut row = row.clone();
        for (cell, input) in row[BEFORE..].iter_mut().zip(inputs) {
            cell.clone_from(&input.cells()[at]);
        }
        row
    });
    text_of(&names, numbered, folder)
}

/// The results with their values in every case.
fn values_of(study: &Study, rows: &CaseRows, first: usize) -> Vec<(String, Vec<f64>)> {
    let number = |row: &Vec<String>, column: usize| {
        let cell = row.get(column).and_then(|cell| cell.parse().ok());
        cell.unwrap_or(f64::NAN)
    };
    let names = outputs(study).into_iter().enumerate();
    names
        .map(|(at, name)| {
            let values = rows.values().map(|row| number(row, first + at));
            (name, values.collect())
        })
        .collect()
}

/// Mean of a result over the axes at each point of the sample; `None` if one of its cases has no result.
fn over_axes(list: &CaseList, rows: &CaseRows, column: usize) -> Vec<Option<f64>> {
    let (samples, axes) = (list.samples(), list.per_sample());
    let mean = |point: usize| {
        let cells =
            (0..axes).map(|at| rows.get(&(at * samples + point))?.get(column)?.parse().ok());
        let values: Option<Vec<f64>> = cells.collect();
        values.map(|values| values.iter().sum::<f64>() / axes as f64)
    };
    (0..samples).map(mean).collect()
}

fn effects_of(
    study: &Study,
    list: &CaseList,
    rows: &CaseRows,
    inputs: &[InputColumn],
) -> Vec<EffectRow> {
    let first = first_output(list);
    let sampled = list.sampled();
    let seed = study.input.sample.as_ref().map_or(0, |sample| sample.seed);
    // The blocks of Saltelli repeat the inputs of A, so the effects are computed from A only.
    let few = list.block().unwrap_or(list.samples());
    let mut effect_rows = Vec::new();
    for (at, (output, values)) in values_of(study, rows, first).into_iter().enumerate() {
        let with_result = |k: &usize| k % list.samples() < few && values[*k].is_finite();
        let cases: Vec<usize> = (0..values.len()).filter(with_result).collect();
        let regressors = inputs.iter().flat_map(|input| input.regressors(&cases));
        let regressors: Vec<Regressor> = regressors.collect();
        let results: Vec<f64> = cases.iter().map(|k| values[*k]).collect();
        let indices = list.block().and_then(|block| {
            let means = over_axes(list, rows, first + at);
            indices(&means, block, sampled.len(), seed)
        });
        let found = effects(&regressors, &results);
        for (regressor, effect) in regressors.into_iter().zip(found) {
            let index = sampled.iter().position(|key| *key == regressor.name);
            effect_rows.push(EffectRow {
                output: output.clone(),
                input: regressor.name,
                effect,
                indices: index.and_then(|index| indices.as_ref()?.get(index).copied()),
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
