//! List of the components and attributes of a file that a case does not use.

use std::collections::BTreeMap;

use crate::model::Model;

/// Lines that name every attribute without a mark, by component, and the number of these attributes.
///
/// Components of a type of which nothing was read share a line.
pub fn unread(model: &Model) -> (usize, Vec<String>) {
    let mut count = 0;
    let mut lines = Vec::new();
    let mut untouched: BTreeMap<&str, Vec<String>> = BTreeMap::new();
    for (case, component) in model.all_components() {
        let attributes = &component.attributes;
        let missed: Vec<&str> = attributes
            .iter()
            .filter(|(_, attribute)| !attribute.is_read.is_set())
            .map(|(name, _)| name.as_str())
            .collect();
        count += missed.len();
        let place = match case {
            Some(case) => format!("{} of load case {}", component.id, case.id),
            None => component.id.clone(),
        };
        if missed.len() == attributes.len() {
            if case.is_none() || !missed.is_empty() {
                untouched.entry(&component.kind).or_default().push(place);
            }
        } else if !missed.is_empty() {
            lines.push(format!("{} {place}: {}", component.kind, missed.join(", ")));
        }
    }
    lines.extend(
        untouched
            .iter()
            .map(|(kind, places)| format!("{kind} {}: nothing", places.join(", "))),
    );
    (count, lines)
}
