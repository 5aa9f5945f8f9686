//! Which equations a result rests on, and their sources: those whose functions ran.

use std::collections::BTreeSet;

use asperity_core::{Equation, Reference};

use crate::equations;
use crate::result::EquationUse;

/// The equations with these tags, those of the paper first, and the publications they come from.
pub(crate) fn used(tags: &BTreeSet<&'static str>) -> (Vec<EquationUse>, Vec<Reference>) {
    let found: Vec<&'static Equation> = equations::all()
        .into_iter()
        .filter(|equation| tags.contains(equation.tag))
        .collect();
    let uses = found
        .iter()
        .map(|equation| EquationUse {
            tag: equation.tag,
            title: equation.title,
            references: equation.references.iter().map(|r| r.key).collect(),
        })
        .collect();
    (uses, equations::bibliography(&found))
}
