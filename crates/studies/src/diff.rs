//! Differences between two results.

use std::collections::{BTreeMap, BTreeSet};

use asperity::case::DefaultUsed;
use asperity::result::RunResult;
use asperity_storage::json_value;
use serde::Serialize;
use serde_json::Value;

/// Differences between two results.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct ResultDiff {
    /// Changed keys of the cases and defaults.
    pub inputs: Vec<Change>,
    /// Changed efficiency and losses, and the quantiles of the draws.
    pub summary: Vec<Change>,
    /// Largest difference in each column of the path; empty if the numbers of positions differ.
    pub path: Vec<PathChange>,
    /// Warnings of only the first and only the second result.
    pub warnings: [Vec<String>; 2],
    /// Tags of equations of only the first and only the second result.
    pub equations: [Vec<String>; 2],
}

/// Changed value.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Change {
    /// Path of the value.
    pub key: String,
    /// Value in the first result, if present.
    pub first: Option<Value>,
    /// Value in the second result, if present.
    pub second: Option<Value>,
    /// Second minus first, for numbers.
    pub difference: Option<f64>,
    /// Difference relative to the first, for numbers.
    pub relative: Option<f64>,
}

/// Largest difference in a column of the path.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct PathChange {
    /// Name of the column.
    pub column: String,
    /// Number of the position.
    pub position: usize,
    /// Value in the first result.
    pub first: f64,
    /// Value in the second result.
    pub second: f64,
}

/// Changed keys between two cases, each with its input and its defaults.
///
/// # Errors
/// When an input cannot be written as JSON.
pub fn changed_keys(
    first: (&dyn erased_serde::Serialize, &[DefaultUsed]),
    second: (&dyn erased_serde::Serialize, &[DefaultUsed]),
) -> Result<Vec<Change>, serde_json::Error> {
    let inputs = |(input, defaults): (&dyn erased_serde::Serialize, &[DefaultUsed])| {
        let mut values = BTreeMap::new();
        flatten("", &json_value(input)?, &mut values);
        for default in defaults {
            let value = serde_json::from_str(&default.value);
            let value = value.unwrap_or_else(|_| Value::from(default.value.clone()));
            values.insert(default.key.to_string(), value);
        }
        Ok::<_, serde_json::Error>(values)
    };
    Ok(changes(&inputs(first)?, &inputs(second)?))
}

/// Computes the differences between `first` and `second`, without program and version.
///
/// # Errors
/// When a result cannot be written as JSON.
pub fn diff(first: &RunResult, second: &RunResult) -> Result<ResultDiff, serde_json::Error> {
    let summary = |result: &RunResult| -> Result<BTreeMap<String, Value>, serde_json::Error> {
        let mut values = BTreeMap::new();
        flatten("", &json_value(&result.summary)?, &mut values);
        if let Some(band) = &result.uncertainty {
            let (loss, efficiency) = (band.loss.drawn(), band.efficiency());
            let drawn = [
                ("loss_p05_w", loss.low),
                ("loss_p95_w", loss.high),
                ("efficiency_p05", efficiency.low),
                ("efficiency_p95", efficiency.high),
            ];
            values.extend(drawn.map(|(key, value)| (key.to_owned(), value.into())));
        }
        Ok(values)
    };
    let warnings = |result: &RunResult| -> BTreeSet<String> {
        result.warnings.iter().map(ToString::to_string).collect()
    };
    let tags = |result: &RunResult| -> BTreeSet<String> {
        let tags = result.equations.iter();
        tags.map(|equation| equation.tag.to_string()).collect()
    };
    Ok(ResultDiff {
        inputs: changed_keys(
            (&first.inputs, &first.defaults),
            (&second.inputs, &second.defaults),
        )?,
        summary: changes(&summary(first)?, &summary(second)?),
        path: path(first, second)?,
        warnings: only_in_each(&warnings(first), &warnings(second)),
        equations: only_in_each(&tags(first), &tags(second)),
    })
}

/// Collects all values by path; tables are entered, absent values omitted.
fn flatten(path: &str, value: &Value, into: &mut BTreeMap<String, Value>) {
    match value {
        Value::Object(fields) => {
            for (name, inner) in fields {
                let path = match path {
                    "" => name.clone(),
                    path => format!("{path}.{name}"),
                };
                flatten(&path, inner, into);
            }
        }
        Value::Null => {}
        value => {
            into.insert(path.to_owned(), value.clone());
        }
    }
}

fn changes(first: &BTreeMap<String, Value>, second: &BTreeMap<String, Value>) -> Vec<Change> {
    let keys: BTreeSet<&String> = first.keys().chain(second.keys()).collect();
    let change = |key: &String| {
        let (a, b) = (first.get(key), second.get(key));
        let numbers = a.and_then(Value::as_f64).zip(b.and_then(Value::as_f64));
        let differs = match numbers {
            // 1 and 1.0 are equal.
            Some((a, b)) => a != b,
            None => a != b,
        };
        let difference = numbers.map(|(a, b)| b - a);
        differs.then(|| Change {
            key: key.clone(),
            first: a.cloned(),
            second: b.cloned(),
            difference,
            relative: numbers
                .filter(|(a, _)| *a != 0.0)
                .map(|(a, b)| (b - a) / a.abs()),
        })
    };
    keys.into_iter().filter_map(change).collect()
}

fn path(first: &RunResult, second: &RunResult) -> Result<Vec<PathChange>, serde_json::Error> {
    if first.path.len() != second.path.len() {
        return Ok(Vec::new());
    }
    let mut largest: BTreeMap<String, PathChange> = BTreeMap::new();
    for (a, b) in first.path.iter().zip(&second.path) {
        let (mut left, mut right) = (BTreeMap::new(), BTreeMap::new());
        flatten("", &json_value(a)?, &mut left);
        flatten("", &json_value(b)?, &mut right);
        for (column, value) in &left {
            let pair = value
                .as_f64()
                .zip(right.get(column).and_then(Value::as_f64));
            let Some((x, y)) = pair.filter(|(x, y)| x != y) else {
                continue;
            };
            let size = (y - x).abs();
            let before = largest
                .get(column)
                .map(|change| (change.second - change.first).abs());
            if before.is_none_or(|before| size > before) {
                let change = PathChange {
                    column: column.clone(),
                    position: a.position,
                    first: x,
                    second: y,
                };
                largest.insert(column.clone(), change);
            }
        }
    }
    Ok(largest.into_values().collect())
}

fn only_in_each(first: &BTreeSet<String>, second: &BTreeSet<String>) -> [Vec<String>; 2] {
    [
        first.difference(second).cloned().collect(),
        second.difference(first).cloned().collect(),
    ]
}
