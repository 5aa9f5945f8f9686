//! Projected preconditioned conjugate gradients for bounded pressures: for single patches, for a given
//! approach, and where the active set does not settle.
//!
//! One displacement and one preconditioner application per iteration, where the method of
//! Polonsky and Keer (1999) needs two displacements and three to twelve times the iterations. The
//! free set holds the points between the bounds and those at a bound with the gap on its wrong
//! side. A trial step along the direction is clipped and its load restored; the exact line search
//! is then made along the feasible difference, whose displacement is the only one needed. Single
//! precision is enough for it: what it loses shrinks with the steps, and the displacement is
//! computed afresh in double precision before the loss matters and before a result is accepted.
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
    SINGLE, exact_length, farthest, line_search, settle, take_step, try_gradient, try_step,
};
use super::search_direction::{Search, choose_direction};
use super::workspace::{Assessment, Level, Task, Workspace};

/// Updates of the displacement after which it is computed afresh, before round-off gathers.
const REFRESH_INTERVAL: usize = 50;
/// Iterations without a smaller duality gap after which no more progress is expected.
const MAX_STALLED: usize = 400;
/// A clipped step is taken whole when the line search would go at least half as far: the energy
/// then decreases, and the bounds are identified exactly.
const FULL_STEP_FROM: f64 = 0.5;
/// Share of the gap left to close that the error of the displacement may have.
const MAX_DRIFT: f64 = 0.1;

/// Improves `work.pressure`, whose opening is known, until its certificate is within the tolerance or
/// no progress is left; returns the iterations, of which `most` are allowed.
pub(crate) fn minimise(
    level: Level,
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
        let left = assessment.penetration.max(task.tolerance) * task.reference_gap;
        let drifted = search.drift > MAX_DRIFT * left || updates >= REFRESH_INTERVAL;
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

/// One iteration; false when the energy cannot be lowered.
fn advance(
    level: Level,
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
        // The preconditioner scales steps of constant load, but knows no datum.
        None if task.sum.is_some() => 1.0,
        None => exact_length(level, work, task),
    };
    let mut clipped = try_step(work, task, reach);
    let mut line = line_search(level, work, task, assessment.approach);
    if !line.descends() {
        try_gradient(work, task, assessment.approach);
        line = line_search(level, work, task, assessment.approach);
        search.descent = 0.0;
        clipped = true;
    }
    if !line.descends() {
        return false;
    }
    let s = -line.slope / line.curvature;
    let length = if clipped {
        search.length = Some(reach * s.clamp(0.5, 2.0));
        if s < FULL_STEP_FROM {
            search.descent = 0.0;
        }
        if s < FULL_STEP_FROM { s } else { 1.0 }
    } else {
        search.length = Some(reach * s.clamp(0.1, 4.0));
        if s > 1.0 {
            s.min(farthest(work, task.limit))
        } else {
            s
        }
    };
    take_step(work, task, length);
    search.drift += SINGLE * work.open(length, line.scale, line.datum);
    true
}
