//! Primal-dual active set (Hintermüller, Ito and Kunisch 2002), with a few conjugate gradients per
//! set.
//!
//! On a given free set F the contact is a linear problem: the gap is zero on F and the pressure may
//! have any sign. A point whose pressure leaves the bounds then leaves F, and a point at a bound
//! whose gap has the wrong sign joins F. This is Newton's method for the contact conditions, and it
//! converges as fast: four to six sets are enough from a coarser solution. Far from the solution the
//! sets may cycle; projected gradients then continue.
//!
//! The linear problems are solved inexactly, to a fifth of their first residual, because the next set
//! makes them obsolete. No step is clipped to the bounds, so conjugate directions stay conjugate and
//! the coarse space of the contact patches removes its part of the residual in full: the number of
//! iterations depends neither on the grid nor on the number of patches.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | p, v | pressure, displacement with the undeformed gap | Pa, m |
//! | F, α, g | free set, mean of v over F, gap v − α | -, m, m |

use super::line_search::settle;
use super::search_direction::{Search, choose_direction, remove_patch_means};
use super::workspace::{BLOCK, Level, Task, Workspace};
use crate::convolution::{Convolution, Lanes, Run, extend, listed, parts, vectorised};
use crate::grid::Grid;
use asperity_core::cancel::{Cancelled, checkpoint};
use asperity_core::cite;

/// Set updates after which projected gradients continue. Sets that converge do so after four to six
/// updates, so thirty mean that they cycle.
const MAX_SET_UPDATES: usize = 30;
/// Consecutive sets with a larger duality gap than the one before. The first set often is such a set,
/// because the negative pressures of its solution are clipped; sets that cycle soon exceed two.
const MAX_WORSE_SETS: usize = 2;
/// Iterations on one set: several times the ten to fifteen that the preconditioner leaves for a whole
/// solution.
const MAX_ITERATIONS_PER_SET: usize = 60;
/// Residual, relative to the first one of a set, at which the set is updated. A smaller value spends
/// iterations on a set that changes anyway, a larger one updates the set from a poor solution.
const SET_TOLERANCE: f64 = 0.2;
/// Residual and overlap that count as zero, in units of the tolerated penetration. The duality gap
/// may reach the sum of both, so each gets a little less than half.
const FORGIVEN_SHARE: f64 = 0.45;

/// Improves `work.pressure`, whose opening is known, until its certificate is within the tolerance
/// or the sets do not settle. Leaves the opening of the result and returns the number of iterations.
pub(crate) fn minimise<G: Grid>(
    level: Level<G>,
    work: &mut Workspace,
    task: &Task,
) -> Result<usize, Cancelled> {
    let iterations = update_sets(level, work, task);
    // Cleared even after a cancelled solution: the next problem uses the same workspace.
    work.coarse.deactivate();
    for array in [&mut work.direction, &mut work.previous] {
        array.fill(0.0);
    }
    iterations
}

/// The outer loop: one free set per pass, from the assessment of the pressure to the next set.
fn update_sets<G: Grid>(
    level: Level<G>,
    work: &mut Workspace,
    task: &Task,
) -> Result<usize, Cancelled> {
    let forgiven = FORGIVEN_SHARE * task.tolerance * task.reference_gap;
    let (mut iterations, mut worse, mut last) = (0, 0, f64::INFINITY);
    for set in 0..MAX_SET_UPDATES {
        checkpoint()?;
        let assessment = work.assess(task);
        worse = if assessment.duality_gap < last {
            0
        } else {
            worse + 1
        };
        last = assessment.duality_gap;
        if assessment.within(task.tolerance)
            || worse > MAX_WORSE_SETS
            || iterations >= task.max_iterations
        {
            break;
        }
        // The assessment lists every point with pressure or overlap. The first set is the free ones among
        // them, the later sets are those that `update_set` has left in `held`.
        if set == 0 {
            work.keep_free();
        } else {
            std::mem::swap(&mut work.runs, &mut work.held);
        }
        // A single patch, or patches of few cells: without a coarse space the sets bring no advantage.
        if !(G::RUNS_ARE_PATCHES
            && work
                .coarse
                .prepare(work.pressure.len(), level.boundary, &work.runs))
        {
            work.list_loaded();
            break;
        }
        let most = task.max_iterations - iterations;
        iterations += solve_on_set(
            level,
            work,
            task,
            forgiven,
            most.min(MAX_ITERATIONS_PER_SET),
        )?;
        work.update_set(task, forgiven);
        // Restores the load that clipping changed and computes the opening in double precision.
        settle(level, work, task);
    }
    Ok(iterations)
}

/// The inner loop: conjugate gradients on the runs, all of whose points are free, until the residual is
/// small enough to update the set. Returns the number of iterations.
///
/// A set that would not change is the right one; only then is it solved on to the residual that the
/// tolerance permits.
fn solve_on_set<G: Grid>(
    level: Level<G>,
    work: &mut Workspace,
    task: &Task,
    forgiven: f64,
    most: usize,
) -> Result<usize, Cancelled> {
    let mut residual = work.measure_set();
    // A first step with the patches only: a new set mostly lacks the right load of each patch.
    remove_patch_means(work, task, residual.mean);
    step(level, work, task);
    residual = work.measure_set();
    let mut search = Search::default();
    let mut goal = (SET_TOLERANCE * residual.largest).max(forgiven);
    for iteration in 0..most {
        checkpoint()?;
        if residual.largest <= goal {
            if goal <= forgiven || work.has_to_change(task, residual.mean, forgiven) {
                return Ok(iteration);
            }
            goal = forgiven;
        }
        let points = work.residual.len();
        choose_direction(level, work, task, points, residual.mean, &mut search);
        if !step(level, work, task) {
            return Ok(iteration);
        }
        residual = work.measure_set();
    }
    Ok(most)
}

/// Moves to the minimum of the energy along the direction, without regard to the bounds; false when
/// the direction has no minimum.
///
/// The direction is scaled to one for the transform in single precision.
fn step<G: Grid>(level: Level<G>, work: &mut Workspace, task: &Task) -> bool {
    let (runs, direction, residual) = (&work.runs, &work.direction, &work.residual);
    let mut lanes = Lanes::new([0.0]);
    for (run, _) in parts(runs) {
        lanes.fold([&direction[run]], |[most], [d]| [most.max(d.abs())]);
    }
    let [largest] = lanes.reduce(|a, b| [a[0].max(b[0])]);
    if !(largest > 0.0 && largest.is_finite()) {
        return false;
    }
    let steps = work.single_buffers.signal(residual.len());
    for (run, place) in parts(runs) {
        for (step, d) in steps[place].iter_mut().zip(&direction[run]) {
            *step = (d / largest) as f32;
        }
    }
    let buffers = &mut work.single_buffers;
    level.single.filter_runs(buffers, 1.0, runs);
    let change = &*buffers.signal(direction.len());
    let scale = largest * task.compliance;
    let (mut slope, mut curvature) = (0.0, 0.0);
    for (run, place) in parts(runs) {
        let values = direction[run.clone()].iter().zip(&residual[place]);
        for ((d, r), change) in values.zip(&change[run]) {
            slope += r * d;
            curvature += d * (scale * f64::from(*change));
        }
    }
    let length = -slope / curvature;
    if !(length.is_finite() && length > 0.0) {
        return false;
    }
    for (run, _) in parts(runs) {
        let pairs = work.pressure[run.clone()].iter_mut().zip(&direction[run]);
        pairs.for_each(|(p, d)| *p += length * d);
    }
    work.open(length, scale, 0.0);
    true
}

/// Mean and largest deviation of the opening on a set.
struct SetResidual {
    /// α
    mean: f64,
    /// Largest |v − α|.
    largest: f64,
}

impl Workspace {
    /// Reduces the runs to the points of F.
    fn keep_free(&mut self) {
        self.next.clear();
        for (run, place) in parts(&self.runs) {
            let points = run.zip(&self.free[place]);
            for (point, _) in points.filter(|(_, free)| **free) {
                Run::push(&mut self.next, point);
            }
        }
        std::mem::swap(&mut self.runs, &mut self.next);
    }

    /// Sets the residual to v on the runs, all of whose points are free, without subtracting its mean.
    fn measure_set(&mut self) -> SetResidual {
        let points = listed(&self.runs);
        self.free.clear();
        self.free.resize(points, true);
        self.residual.resize(points, 0.0);
        let (opening, residual, runs) = (&self.opening, &mut self.residual, &self.runs);
        let mut sum = Lanes::new([0.0]);
        for (run, place) in parts(runs) {
            let v = &opening[run];
            residual[place].copy_from_slice(v);
            sum.fold([v], |[sum], [v]| [sum + v]);
        }
        let mean = sum.total()[0] / points as f64;
        let mut largest = Lanes::new([0.0]);
        vectorised(
            #[inline(always)]
            || {
                largest.fold([&*residual], |[most], [v]| {
                    let size = (v - mean).abs();
                    [if size > most { size } else { most }]
                });
            },
        );
        let [largest] = largest.reduce(|a, b| [a[0].max(b[0])]);
        SetResidual { mean, largest }
    }

    /// Whether a point has to leave or to join the set.
    fn has_to_change(&self, task: &Task, approach: f64, forgiven: f64) -> bool {
        let (limit, pressure, opening) = (task.limit, &self.pressure, &self.opening);
        vectorised(
            #[inline(always)]
            || {
                let mut blocks = pressure.chunks(BLOCK).zip(opening.chunks(BLOCK));
                blocks.any(|(pressure, opening)| {
                    pressure.iter().zip(opening).fold(false, |any, (&p, &v)| {
                        any | (p < 0.0) | (p > limit) | joins(p, v - approach, limit, forgiven)
                    })
                })
            },
        )
    }

    /// F' = {0 < p < p_max} ∪ {p = 0, g < 0} ∪ {p = p_max, g > 0}, p and g solving on F    `[Active-1]`
    ///
    /// Leaves F' in `held` and clips the pressure to its bounds.
    fn update_set(&mut self, task: &Task, forgiven: f64) {
        cite!("Active-1");
        let (approach, limit) = (self.measure_set().mean, task.limit);
        self.held.clear();
        let blocks = self
            .pressure
            .chunks_mut(BLOCK)
            .zip(self.opening.chunks(BLOCK));
        for (block, (pressure, opening)) in blocks.enumerate() {
            let mut free = 0;
            vectorised(
                #[inline(always)]
                || {
                    let touches = |(p, v): (&f64, &f64)| (*p != 0.0) | (v - approach < -forgiven);
                    let points = pressure.iter().zip(opening.iter()).map(touches);
                    if !points.fold(false, |any, touches| any | touches) {
                        return;
                    }
                    for (k, (p, v)) in pressure.iter_mut().zip(opening).enumerate() {
                        let stays = (*p > 0.0) & (*p < limit);
                        let is_free = stays | joins(*p, v - approach, limit, forgiven);
                        free |= u64::from(is_free) << k;
                        *p = p.clamp(0.0, limit);
                    }
                },
            );
            extend(&mut self.held, block * BLOCK, free);
        }
    }
}

/// Whether a point at a bound has a gap of the wrong sign: overlap without pressure, or a gap that opens
/// at the pressure limit.
#[inline(always)]
fn joins(pressure: f64, gap: f64, limit: f64, forgiven: f64) -> bool {
    ((pressure == 0.0) & (gap < -forgiven)) | ((pressure == limit) & (gap > forgiven))
}
