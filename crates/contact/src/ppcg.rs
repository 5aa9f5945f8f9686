//! Projected preconditioned conjugate gradients for bounded pressures.
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

use crate::projection::{clip, restore_load};
use crate::runs::{Lanes, parts, vectorised};
use crate::state::{Assessment, Level, Task, Workspace};
use crate::step::{exact_length, farthest, line_search, take_step, try_gradient, try_step};

/// Updates of the displacement after which it is computed afresh, before round-off gathers.
const REFRESH: usize = 50;
/// Iterations without a smaller duality gap after which no more progress is expected.
const STALL: usize = 400;
/// A clipped step is taken whole when the line search would go at least half as far: the energy
/// then decreases, and the bounds are identified exactly.
const WHOLE: f64 = 0.5;
/// Error of a displacement in single precision over its largest value: a tenth to a half of this from
/// 50 to 30 000 points.
pub(crate) const SINGLE: f64 = 1e-6;
/// Share of the gap left to close that the error of the displacement may have.
const DRIFT: f64 = 0.1;

/// Memory of the search from one iteration to the next.
struct Search {
    /// τ, not known before the first direction.
    length: Option<f64>,
    /// r·z of the last direction, or zero to begin anew along z.
    descent: f64,
    /// Error in m of the displacement by what single precision lost.
    drift: f64,
}

/// Improves `work.pressure` until its certificate is within the tolerance or no progress is left;
/// returns the iterations.
pub(crate) fn minimise(level: Level, work: &mut Workspace, task: &Task) -> usize {
    work.resize();
    settle(level, work, task);
    let mut search = Search {
        length: None,
        descent: 0.0,
        drift: 0.0,
    };
    let (mut iterations, mut updates, mut stalled, mut best) = (0, 0, 0, f64::INFINITY);
    loop {
        let mut assessment = work.assess(task);
        let left = assessment.penetration.max(task.tolerance) * task.reference_gap;
        let drifted = search.drift > DRIFT * left || updates >= REFRESH;
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
            || iterations >= task.max_iterations
            || stalled > STALL
            || !advance(level, work, task, &assessment, &mut search)
        {
            return iterations;
        }
        iterations += 1;
        updates += 1;
    }
}

/// Makes the pressure feasible and computes its displacement afresh: both drift by round-off.
fn settle(level: Level, work: &mut Workspace, task: &Task) {
    make_feasible(&mut work.pressure, task);
    work.refresh(level.displacement, task);
}

/// Clips to the bounds, and restores the load when it is given.
pub(crate) fn make_feasible(pressure: &mut [f64], task: &Task) {
    match task.sum {
        Some(sum) => restore_load(pressure, sum, task.limit),
        None => clip(pressure, task.limit),
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
    choose_direction(level, work, task, assessment, search);
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
        if s < WHOLE {
            search.descent = 0.0;
        }
        if s < WHOLE { s } else { 1.0 }
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

/// d = −z + β·d on F without its mean, with Polak and Ribière's β ≥ 0; −z when that is no descent.
fn choose_direction(
    level: Level,
    work: &mut Workspace,
    task: &Task,
    assessment: &Assessment,
    search: &mut Search,
) {
    // Steps of constant load have no mean, nor has what matters of the residual.
    let count = assessment.free as f64;
    let mean = |sum: f64| if task.sum.is_some() { sum / count } else { 0.0 };
    precondition(level, work, task, mean(assessment.residual_sum));
    let sums = ascent_sums(work);
    let z_mean = mean(sums.z);
    let old_z = sums.old_z - z_mean * sums.old;
    let beta = if search.descent > 0.0 {
        ((sums.r_z - old_z) / search.descent).max(0.0)
    } else {
        0.0
    };
    let (runs, free, ascent, residual) = (&work.runs, &work.free, &work.ascent, &work.residual);
    let (direction, previous) = (&mut work.direction, &mut work.previous);
    let mut lanes = Lanes::new([0.0; 2]);
    vectorised(
        #[inline(always)]
        || {
            for (run, place) in parts(runs) {
                let (z, r) = (&ascent[place.clone()], &residual[place.clone()]);
                let d = &mut direction[run];
                for ((d, z), free) in d.iter_mut().zip(z).zip(&free[place]) {
                    *d = if *free { z_mean - z + beta * *d } else { 0.0 };
                }
                lanes.fold([&*d, r], |[sum, r_d], [d, r]| [sum + d, r_d + r * d]);
            }
        },
    );
    let [d_sum, r_d] = lanes.total();
    let d_mean = mean(d_sum);
    let descends = r_d < 0.0;
    vectorised(
        #[inline(always)]
        || {
            for (run, place) in parts(runs) {
                let values = ascent[place.clone()].iter().zip(&free[place.clone()]);
                for (d, (z, free)) in direction[run.clone()].iter_mut().zip(values) {
                    let anew = if descends { *d - d_mean } else { z_mean - z };
                    *d = if *free { anew } else { 0.0 };
                }
                previous[run].copy_from_slice(&residual[place]);
            }
        },
    );
    search.descent = sums.r_z;
}

/// Sums over F: of z, r·z, the residual of the last iteration, and that times z.
struct AscentSums {
    z: f64,
    r_z: f64,
    old: f64,
    old_z: f64,
}

fn ascent_sums(work: &mut Workspace) -> AscentSums {
    let (runs, free, ascent, residual) = (&work.runs, &work.free, &work.ascent, &work.residual);
    let previous = &mut work.previous;
    let mut lanes = Lanes::new([0.0; 4]);
    vectorised(
        #[inline(always)]
        || {
            for (run, place) in parts(runs) {
                let (z, r) = (&ascent[place.clone()], &residual[place.clone()]);
                let previous = &mut previous[run];
                for (old, free) in previous.iter_mut().zip(&free[place]) {
                    *old = if *free { *old } else { 0.0 };
                }
                lanes.fold([z, r, previous], |sums, [z, r, old]| {
                    [
                        sums[0] + z,
                        sums[1] + r * z,
                        sums[2] + old,
                        sums[3] + old * z,
                    ]
                });
            }
        },
    );
    let [z, r_z, old, old_z] = lanes.total();
    AscentSums { z, r_z, old, old_z }
}

/// Takes the mean from r, and z = M r.
fn precondition(level: Level, work: &mut Workspace, task: &Task, residual_mean: f64) {
    let (residual, free) = (&mut work.residual, &work.free);
    let mut lanes = Lanes::new([0.0]);
    vectorised(
        #[inline(always)]
        || {
            for (r, &free) in residual.iter_mut().zip(free) {
                *r = if free { *r - residual_mean } else { 0.0 };
            }
            let larger =
                |[most]: [f64; 1], [r]: [f64; 1]| [if r.abs() > most { r.abs() } else { most }];
            lanes.fold([&*residual], larger);
        },
    );
    // Scaled so that single precision neither overflows nor vanishes, whatever the units.
    let [largest] = lanes.reduce(|a, b| [a[0].max(b[0])]);
    let scale = if largest > 0.0 { largest } else { 1.0 };
    let buffers = &mut work.inverse_buffers;
    let scaled = buffers.signal(residual.len());
    vectorised(
        #[inline(always)]
        || {
            for (to, r) in scaled.iter_mut().zip(residual) {
                *to = (*r * (1.0 / scale)) as f32;
            }
        },
    );
    level.inverse.filter_runs(buffers, 1.0, &work.runs);
    let z = &*buffers.signal(work.pressure.len());
    let stiffness = 0.5 / task.compliance * scale;
    let (ascent, runs) = (&mut work.ascent, &work.runs);
    ascent.resize(free.len(), 0.0);
    vectorised(
        #[inline(always)]
        || {
            for (run, place) in parts(runs) {
                let values = z[run].iter().zip(&free[place.clone()]);
                for (to, (z, &free)) in ascent[place].iter_mut().zip(values) {
                    *to = if free { stiffness * f64::from(*z) } else { 0.0 };
                }
            }
        },
    );
}
