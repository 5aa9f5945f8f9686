//! Equations that a result used, with their sources: those whose functions ran.

use std::collections::BTreeSet;

use asperity_core::Equation;

use crate::equations;
use crate::result::{CitedSource, EquationUse};

/// The equations with these tags, those of the paper first, and the publications they come from.
pub(crate) fn used(tags: &BTreeSet<&'static str>) -> (Vec<EquationUse>, Vec<CitedSource>) {
    let found: Vec<&'static Equation> = equations::all()
        .into_iter()
        .filter(|equation| tags.contains(equation.tag))
        .collect();
    let uses = found
        .iter()
        .map(|equation| EquationUse {
            tag: equation.tag.into(),
            title: equation.title.into(),
            references: equation.references.iter().map(|r| r.key.into()).collect(),
        })
        .collect();
    let sources = equations::bibliography(&found);
    (uses, sources.into_iter().map(CitedSource::from).collect())
}
