//! Shafts of a gearbox and the gears on them.

use std::collections::BTreeMap;

use crate::model::{Component, Model};

/// The shaft that a gear or a load sits on.
pub fn shaft_of<'a>(model: &'a Model, part: &str) -> Option<&'a str> {
    model
        .related("assembly")
        .filter(|relation| relation.role("part") == Some(part))
        .filter_map(|relation| model.components.get(relation.role("assembly")?))
        .find(|component| component.kind == "shaft")
        .map(|shaft| shaft.id.as_str())
}

/// The first shaft of the carrier of a planetary stage.
pub fn carrier_shaft<'a>(model: &'a Model, set: &str) -> Option<&'a str> {
    model
        .related("planet_carrier_shaft")
        .find(|relation| relation.role("planetary_stage") == Some(set))
        .and_then(|relation| relation.role("shaft"))
}

/// Whether a coupling holds the shaft in the casing.
pub fn is_held(model: &Model, shaft: &str) -> bool {
    couplings(model).any(|parts| {
        let kinds = parts.map(|part| part.kind.as_str());
        parts.iter().any(|part| part.id == shaft) && kinds.contains(&"gear_casing")
    })
}

/// The two parts of every coupling.
fn couplings(model: &Model) -> impl Iterator<Item = [&Component; 2]> {
    model.related("side").filter_map(|relation| {
        let part = |role: &str| model.components.get(relation.role(role)?);
        let is_coupling = part("assembly")?.kind.ends_with("coupling");
        is_coupling.then_some([part("inner_part")?, part("outer_part")?])
    })
}

/// Shafts that couplings join, each with the first of its group.
pub fn joined(model: &Model) -> BTreeMap<&str, &str> {
    let shafts = model.of_kind("shaft").map(|shaft| shaft.id.as_str());
    let mut groups: BTreeMap<&str, &str> = shafts.map(|shaft| (shaft, shaft)).collect();
    for parts in couplings(model) {
        let [Some(a), Some(b)] = parts.map(|part| groups.get(part.id.as_str()).copied()) else {
            continue;
        };
        for group in groups.values_mut().filter(|group| **group == b) {
            *group = a;
        }
    }
    groups
}
