//! Minimisation on one grid: active set first, projected gradients for the rest.

use asperity_core::cancel::Cancelled;

use super::line_search::settle;
use super::workspace::{Level, Task, Workspace};
use super::{active_set, projected_gradient};

/// Improves `work.pressure` until its certificate is within the tolerance or no progress is left;
/// returns the iterations.
pub(crate) fn minimise(
    level: Level,
    work: &mut Workspace,
    task: &Task,
) -> Result<usize, Cancelled> {
    work.resize();
    settle(level, work, task);
    // Of the start: near the solution but for the coarsest grid, whose result only is a start.
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
    let on_sets = match task.sum {
        Some(_) => active_set::minimise(level, work, task)?,
        None => 0,
    };
    let left = task.max_iterations.saturating_sub(on_sets);
    Ok(on_sets + projected_gradient::minimise(level, work, task, left)?)
}
