//! Equations that a result used, with their sources: those whose functions ran.

use std::collections::BTreeSet;

use crate::equations::{self, Equation};
use crate::result::{CitedSource, EquationUse};

/// The equations with these tags, the equations of the paper first.
pub(crate) fn equations_used(tags: &BTreeSet<&'static str>) -> Vec<EquationUse> {
    let row = |equation: &Equation| EquationUse {
        tag: equation.tag.into(),
        title: equation.title.into(),
        references: equation.references.iter().map(|r| r.key.into()).collect(),
    };
    equations::of_tags(tags).into_iter().map(row).collect()
}

/// The publications that the equations with these tags come from.
pub(crate) fn sources_used(tags: &BTreeSet<&'static str>) -> Vec<CitedSource> {
    let sources = equations::bibliography(equations::of_tags(tags));
    sources.into_iter().map(CitedSource::from).collect()
}
