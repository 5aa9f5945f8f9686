//! Two results side by side.

use asperity::uncertainty::difference_of_meshes;
use asperity_report::TileKind;
use asperity_studies::compare::{difference_with_interval, verdict};
use asperity_studies::diff::changed_keys;
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

/// The results `first` (A) and `other` (B). The difference of the losses is taken over the draws that both have in common.
///
/// # Errors
/// When a result cannot be written as JSON.
pub fn versus(first: &Finished, other: &Finished) -> Result<Versus, Failure> {
    let drawn = first.outcome.drawn_beside(&other.outcome);
    let difference = drawn.map(|[a, b]| difference_of_meshes(&a, &b));
    let [a, b] = [first, other].map(Finished::tiles);
    let mut rows = Vec::new();
    let mut of_loss = None;
    for tile in &a {
        let theirs = b.iter().find(|other| other.name == tile.name);
        let Some(theirs) = theirs else { continue };
        if !tile.value.is_empty() {
            if tile.kind == TileKind::Loss {
                of_loss = Some(rows.len());
            }
            let own = [tile, theirs].map(|tile| tile.value.clone());
            rows.push(row(&tile.name, own, String::new()));
        } else if tile.kind != TileKind::Sources {
            for [name, loss] in &tile.rows {
                let other = theirs.rows.iter().find(|[other, _]| other == name);
                let other = other.map_or("-".to_owned(), |[_, loss]| loss.clone());
                rows.push(row(name, [loss.clone(), other], String::new()));
            }
        }
    }
    if let (Some(difference), Some(loss)) = (&difference, of_loss) {
        let [watts, percent] = difference_with_interval(difference);
        rows[loss][3] = format!("{watts} W, {percent} %");
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
        let mut defaults = of.defaults().iter();
        defaults.any(|default| default.key == key)
    };
    let changes = changed_keys(
        (first.inputs(), first.defaults()),
        (other.inputs(), other.defaults()),
    )?;
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
