//! Minimisation on one grid: active set, then projected gradients.

use asperity_core::cancel::Cancelled;

use super::line_search::settle;
use super::workspace::{Level, Task, Workspace};
use super::{active_set, projected_gradient};
use crate::grid::Grid;

/// Improves `work.pressure` until its certificate is within the tolerance or no progress is possible.
/// Returns the number of iterations.
pub(crate) fn minimise<G: Grid>(
    level: Level<G>,
    work: &mut Workspace,
    task: &Task,
) -> Result<usize, Cancelled> {
    work.resize();
    settle(level, work, task);
    // The reference gap of the start is close to that of the solution, except on the coarsest grid, whose
    // result is only a start itself.
    let task = &Task {
        reference_gap: work.reference_gap(task),
        ..*task
    };
    let tolerance = if task.least_tolerance < task.tolerance {
        let start = work.assess(task);
        let goal = task.gain * start.duality_gap.max(start.penetration);
        goal.clamp(task.least_tolerance, task.tolerance)
    } else {
        task.tolerance
    };
    let task = &Task { tolerance, ..*task };
    // The coarse space assumes steps of constant load, so a controlled approach starts with gradients.
    let set_iterations = match task.sum {
        Some(_) => active_set::minimise(level, work, task)?,
        None => 0,
    };
    let remaining = task.max_iterations.saturating_sub(set_iterations);
    Ok(set_iterations + projected_gradient::minimise(level, work, task, remaining)?)
}
