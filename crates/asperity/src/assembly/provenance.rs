//! Equations that a result used, with their sources: those whose functions ran.

use std::collections::BTreeSet;

use crate::equations::{self, Equation};
use crate::result::{CitedSource, EquationUse};

/// The equations with these tags, those of the paper first, and the publications they come from.
pub(crate) fn equations_used(
    tags: &BTreeSet<&'static str>,
) -> (Vec<EquationUse>, Vec<CitedSource>) {
    let used = || (equations::all().iter()).filter(|equation| tags.contains(equation.tag));
    let row = |equation: &Equation| EquationUse {
        tag: equation.tag.into(),
        title: equation.title.into(),
        references: equation.references.iter().map(|r| r.key.into()).collect(),
    };
    let sources = equations::bibliography(used());
    (
        used().map(row).collect(),
        sources.into_iter().map(CitedSource::from).collect(),
    )
}
