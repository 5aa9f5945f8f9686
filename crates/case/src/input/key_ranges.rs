//! Ranges of keys by their paths, for messages, documents and other programs.

use super::case_input::CaseInput;
use super::mesh_input::MESH;
use super::ranges::{range_in_pair, row_of};
use super::rows::{KeyPath, Limits, RangedKey};
use crate::source::source_text::is_within;

/// Tables of a gear train, each with the table of a pair of gears whose rows it has.
const ROWS_OF: [(&str, &str); 11] = [
    ("planetary.sun", "gears.pinion"),
    ("planetary.planet", "gears.pinion"),
    ("planetary.ring", "gears.pinion"),
    ("planetary", "gears"),
    ("material.sun", "material.pinion"),
    ("material.planet", "material.pinion"),
    ("material.ring", "material.pinion"),
    ("surface.sun", "surface.pinion"),
    ("surface.planet", "surface.pinion"),
    ("surface.ring", "surface.pinion"),
    ("bulk", "operation.bulk"),
];

/// The ranges of the numbers at `key` of a case or a gear train; `None` for a key without a range.
///
/// ```
/// use asperity_case::case::range_of;
/// assert_eq!(range_of("operation.speed").map(|range| range.possible), Some([1e-6, 1e6]));
/// assert_eq!(range_of("heat.ambient").map(|range| range.unit), Some("°C"));
/// assert_eq!(range_of("operation.bulk"), None);
/// ```
#[must_use]
pub fn range_of(key: &str) -> Option<Limits> {
    let mesh = key.strip_prefix("mesh.");
    let in_mesh = mesh.and_then(|mesh| mesh.split_once('.'));
    let key = in_mesh.map_or(key, |(_, key)| key);
    let shared = ROWS_OF
        .iter()
        .find(|(of_train, _)| is_within(key, of_train));
    let shared = shared.map(|(of_train, of_pair)| key.replacen(of_train, of_pair, 1));
    let own = match in_mesh {
        Some(_) => format!("mesh.{MESH}.{key}"),
        None => key.to_owned(),
    };
    let of_train = row_of::<CaseInput>(&|row| is_within(&own, row));
    of_train.or_else(|| range_in_pair(shared.as_deref().unwrap_or(key)))
}

/// Every relation between keys, of the first of equal tables: the key that it is reported at, the quantity, and its usual range.
#[cfg_attr(
    not(feature = "case-files"),
    allow(dead_code, reason = "the page of the case file lists them")
)]
pub(crate) fn relations() -> Vec<[String; 3]> {
    let mut found = Vec::new();
    let mut judge = |at: KeyPath<'_>, limits: &Limits, _: &[f64]| {
        let key = at.to_string();
        let is_twin = key.contains(".wheel.") || key.contains(".coast.");
        if !limits.relation.is_empty() && !is_twin {
            found.push([key, limits.relation.to_owned(), limits.usual()]);
        }
    };
    CaseInput::visit(None, KeyPath::default(), &mut judge);
    found
}
