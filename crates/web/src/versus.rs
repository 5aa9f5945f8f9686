//! Two results side by side.

use asperity::uncertainty;
use asperity_report::tiles;
use asperity_studies::compare::{difference_with_interval, verdict};
use asperity_studies::diff::diff;
use serde::Serialize;
use serde_json::Value;

use crate::failure::Failure;
use crate::job::Finished;

/// Names of the results.
const NAMES: [&str; 2] = ["A", "B"];

/// Two results and their difference.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Versus {
    /// The decision about the losses; empty without an interval.
    pub verdict: String,
    /// Name, value of A, value of B, and B minus A where it is known.
    pub rows: Vec<[String; 4]>,
    /// Keys of the case with the values in A and in B.
    pub inputs: Vec<[String; 3]>,
}

/// The results `first` (A) and `other` (B). The difference of the losses is drawn with the constants that both share.
///
/// # Errors
/// When a result cannot be written as JSON.
pub fn versus(first: &Finished, other: &Finished) -> Result<Versus, Failure> {
    let drawn = |of: &Finished| {
        let uncertainty = of.result.uncertainty.clone()?;
        Some((of.predictive.clone()?, uncertainty))
    };
    let same_flanks = first.surfaces.has_flanks_of(&other.surfaces);
    let difference = drawn(first)
        .zip(drawn(other))
        .map(|(a, b)| uncertainty::difference((&a.0, &a.1), (&b.0, &b.1), same_flanks));
    let [a, b] = [first, other].map(|of| tiles(&of.result));
    let mut rows = Vec::new();
    for tile in &a {
        let theirs = b.iter().find(|other| other.name == tile.name);
        let Some(theirs) = theirs else { continue };
        if !tile.value.is_empty() {
            let own = [tile, theirs].map(|tile| tile.value.clone());
            rows.push(row(tile.name, own, String::new()));
        } else if tile.name.starts_with("parts") {
            for [name, loss] in &tile.rows {
                let other = theirs.rows.iter().find(|[other, _]| other == name);
                let other = other.map_or("-".to_owned(), |[_, loss]| loss.clone());
                rows.push(row(name, [loss.clone(), other], String::new()));
            }
        }
    }
    if let (Some(difference), Some(loss)) = (&difference, rows.first_mut()) {
        let [watts, percent] = difference_with_interval(difference);
        loss[3] = format!("{watts} W, {percent} %");
    }
    Ok(Versus {
        verdict: difference.map_or(String::new(), |difference| verdict(NAMES, &difference)),
        rows,
        inputs: inputs(first, other)?,
    })
}

fn row(name: &str, [a, b]: [String; 2], difference: String) -> [String; 4] {
    [name.to_owned(), a, b, difference]
}

/// Stated keys of the cases that differ.
fn inputs(first: &Finished, other: &Finished) -> Result<Vec<[String; 3]>, Failure> {
    let text = |value: &Option<Value>| match value {
        None => "-".to_owned(),
        Some(Value::String(text)) => text.clone(),
        Some(value) => value.to_string(),
    };
    let is_default = |of: &Finished, key: &str| {
        let mut defaults = of.result.defaults.iter();
        defaults.any(|default| default.key == key)
    };
    let changes = diff(&first.result, &other.result)?.inputs;
    let stated = |key: &str| ![first, other].iter().all(|of| is_default(of, key));
    let rows = changes
        .iter()
        .filter(|change| stated(&change.key))
        .map(|change| {
            [
                change.key.clone(),
                text(&change.first),
                text(&change.second),
            ]
        });
    Ok(rows.collect())
}
