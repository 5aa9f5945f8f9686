//! Projected preconditioned conjugate gradients for bounded pressures: for single patches, for a
//! controlled approach, and where the active set does not settle.
//!
//! The method follows Polonsky and Keer (1999), with a preconditioner and with one displacement per
//! iteration where theirs needs two, and takes a third to a twelfth of their iterations. The free set
//! holds the points between the bounds and the points at a bound whose gap has the wrong sign. A trial
//! step along the direction is clipped and its load restored; the exact line search then follows the
//! feasible difference, whose displacement is the only one needed. It is computed in single precision,
//! whose error shrinks with the step. The displacement of the pressure is recomputed in double
//! precision before the errors add up and before a result is accepted.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | p, u, h | pressure, displacement, undeformed gap | Pa, m, m |
//! | α, g | approach, gap u + h − α | m |
//! | F, r | free set, residual: g on F without its mean | -, m |
//! | z = M r | preconditioned residual | Pa |
//! | d, τ | direction, length of the trial step along it | Pa, - |
//! | Δ, s | feasible step, its length by exact line search | Pa, - |

use asperity_core::cancel::{Cancelled, checkpoint};

use super::line_search::{
    SINGLE, exact_length, length_to_bound, line_search, settle, take_step, try_gradient, try_step,
};
use super::search_direction::{Search, choose_direction};
use super::workspace::{Assessment, Level, Task, Workspace};
use crate::grid::Grid;

/// Updates of the displacement after which it is recomputed at the latest, so that round-off does not
/// accumulate. Most iterations end earlier.
const REFRESH_INTERVAL: usize = 50;
/// Iterations without a smaller duality gap after which the solution counts as stalled. The gap need
/// not fall in every iteration while the free set changes, hence the large number.
const MAX_STALLED: usize = 400;
/// A clipped step is taken in full if the line search would go at least half as far. Up to twice the
/// minimum of a parabola the energy decreases, and the full step ends exactly on the bounds.
const FULL_STEP_FROM: f64 = 0.5;
/// Error of the displacement, relative to the penetration that is left, at which it is recomputed.
const MAX_DRIFT: f64 = 0.1;

/// Improves `work.pressure`, whose opening is known, until its certificate is within the tolerance or
/// no progress is possible. Returns the number of iterations, at most `most`.
pub(crate) fn minimise<G: Grid>(
    level: Level<G>,
    work: &mut Workspace,
    task: &Task,
    most: usize,
) -> Result<usize, Cancelled> {
    let mut iterations = 0;
    let mut search = Search::default();
    let (mut updates, mut stalled, mut best) = (0, 0, f64::INFINITY);
    loop {
        checkpoint()?;
        let mut assessment = work.assess(task);
        let penetration = assessment.penetration.max(task.tolerance) * task.reference_gap;
        let drifted = search.drift > MAX_DRIFT * penetration || updates >= REFRESH_INTERVAL;
        // A result is accepted only by a displacement in double precision.
        if updates > 0 && (drifted || assessment.within(task.tolerance)) {
            settle(level, work, task);
            search.drift = 0.0;
            updates = 0;
            assessment = work.assess(task);
        }
        let done = assessment.within(task.tolerance) || assessment.free == 0;
        stalled = if assessment.duality_gap < best {
            0
        } else {
            stalled + 1
        };
        best = best.min(assessment.duality_gap);
        if done
            || iterations >= most
            || stalled > MAX_STALLED
            || !advance(level, work, task, &assessment, &mut search)
        {
            return Ok(iterations);
        }
        iterations += 1;
        updates += 1;
    }
}

/// One iteration: direction, feasible trial step, line search, update. False when no step lowers the
/// energy.
fn advance<G: Grid>(
    level: Level<G>,
    work: &mut Workspace,
    task: &Task,
    assessment: &Assessment,
    search: &mut Search,
) -> bool {
    let residual_mean = match task.sum {
        Some(_) => assessment.residual_sum / assessment.free as f64,
        None => 0.0,
    };
    choose_direction(level, work, task, assessment.free, residual_mean, search);
    let reach = match search.length {
        Some(length) => length,
        // The preconditioner gives the right length of a step of constant load, but ignores the datum.
        None if task.sum.is_some() => 1.0,
        None => exact_length(level, work, task),
    };
    let mut clipped = try_step(work, task, reach);
    let mut line = line_search(level, work, task, assessment.approach);
    if !line.descends() {
        // The clipped direction is no descent any more: a projected gradient is, and restarts the directions.
        try_gradient(work, task, assessment.approach);
        line = line_search(level, work, task, assessment.approach);
        search.descent = 0.0;
        clipped = true;
    }
    if !line.descends() {
        return false;
    }
    let s = -line.slope / line.curvature;
    // The next trial length follows the minimum of the line search, within a factor that keeps one
    // unusual step from spoiling it: narrower where clipping changed the direction.
    let length = if clipped {
        search.length = Some(reach * s.clamp(0.5, 2.0));
        if s < FULL_STEP_FROM {
            search.descent = 0.0;
        }
        if s < FULL_STEP_FROM { s } else { 1.0 }
    } else {
        search.length = Some(reach * s.clamp(0.1, 4.0));
        if s > 1.0 {
            s.min(length_to_bound(work, task.limit))
        } else {
            s
        }
    };
    take_step(work, task, length);
    work.open(length, line.scale, line.datum);
    search.drift += SINGLE * (length * line.scale * work.largest_change());
    true
}
