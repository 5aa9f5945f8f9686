//! Simulated machines: friction with the errors of a machine. All files that hold it declare it as simulated.

use asperity_core::Fault;
use nalgebra::DVector;

use super::fit::PointErrors;
use super::problem::{CONSTANTS, Nuisance, TractionProblem};
use crate::simulate::normals;

/// Friction that a machine would measure at the points of `problem`, with its variables: errors of the machine drawn from
/// their priors, constants of the oil at their medians or drawn as well, independent normal errors of the points.
///
/// # Errors
/// When the friction has no solution at a point.
pub fn simulated(
    problem: &TractionProblem<'_>,
    is_oil_drawn: bool,
    errors: PointErrors,
    seed: u64,
) -> Result<(DVector<f64>, Vec<f64>), Fault> {
    let mut normal = normals(seed);
    let mut x = DVector::from_fn(problem.variables(), |_, _| normal());
    if !is_oil_drawn {
        x.rows_mut(0, CONSTANTS).fill(0.0);
    }
    for (k, term) in problem.terms.iter().enumerate() {
        if term.kind == Nuisance::Rise {
            // At least 0: the median is one standard deviation above it.
            x[CONSTANTS + k] = x[CONSTANTS + k].max(-1.0);
        }
    }
    let measured = problem.predicted(&x)?.into_iter().map(|friction| {
        let error = errors.of(friction);
        friction + error * normal()
    });
    let measured = measured.collect();
    Ok((x, measured))
}
