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

use crate::active_set;
use crate::projection::{clip, project, restore_load};
use crate::runs::{Lanes, listed, parts, vectorised};
use crate::state::{Assessment, Level, Task, Workspace};

/// Updates of the displacement after which it is computed afresh, before round-off gathers.
const REFRESH: usize = 50;
/// Iterations without a smaller duality gap after which no more progress is expected.
const STALL: usize = 400;
/// A clipped step is taken whole when the line search would go at least half as far: the energy
/// then decreases, and the bounds are identified exactly.
const WHOLE: f64 = 0.5;
/// Step along the gradient, in π·E*/a: about the stiffness of pressure moved to the next cell,
/// whose kernel differs by 6.6·a.
const GRADIENT: f64 = 0.1;

/// Error of a displacement in single precision over its largest value: a tenth to a half of this from
/// 50 to 30 000 points.
pub(crate) const SINGLE: f64 = 1e-6;
/// Share of the gap left to close that the error of the displacement may have.
const DRIFT: f64 = 0.1;

/// Pressure left of that before a step that is nothing but round-off. A point that keeps it counts
/// as lying between the bounds, and can hold the iteration where no step improves anything.
const DUST: f64 = 1e-15;

/// Memory of the search from one iteration to the next.
#[derive(Default)]
pub(crate) struct Search {
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
    let mut iterations = match task.sum {
        Some(_) => active_set::minimise(level, work, task),
        None => 0,
    };
    let mut search = Search::default();
    let (mut updates, mut stalled, mut best) = (0, 0, f64::INFINITY);
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
pub(crate) fn settle(level: Level, work: &mut Workspace, task: &Task) {
    make_feasible(&mut work.pressure, task);
    work.refresh(level.displacement, task);
}

/// Clips to the bounds, and restores the load when it is given.
fn make_feasible(pressure: &mut [f64], task: &Task) {
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

/// p + s·Δ
fn take_step(work: &mut Workspace, task: &Task, length: f64) {
    let (pressure, runs, trial) = (&mut work.pressure, &work.runs, &work.trial);
    vectorised(
        #[inline(always)]
        || {
            for (run, place) in parts(runs) {
                let (pressure, trial) = (&mut pressure[run], &trial[place]);
                if length == 1.0 {
                    // A step that is taken whole must land on the bounds to the last bit.
                    pressure.copy_from_slice(trial);
                    continue;
                }
                for (p, to) in pressure.iter_mut().zip(trial) {
                    let moved = (*p + length * (to - *p)).clamp(0.0, task.limit);
                    *p = if moved > DUST * *p { moved } else { 0.0 };
                }
            }
        },
    );
}

/// The energy along Δ = q − p: slope·s + ½·curvature·s².
struct Line {
    slope: f64,
    curvature: f64,
    /// Of the displacement that the buffers hold.
    scale: f64,
    /// What the datum adds to the displacement by Δ.
    datum: f64,
}

impl Line {
    fn descends(&self) -> bool {
        self.curvature > 0.0 && self.slope < 0.0
    }
}

/// Leaves the displacement by q − p, but for a scale and the datum, in the signal of the
/// single-precision buffers: as steps become short, so does what is lost of them.
fn line_search(level: Level, work: &mut Workspace, task: &Task, approach: f64) -> Line {
    let (pressure, runs, trial) = (&work.pressure, &work.runs, &work.trial);
    let mut lanes = Lanes::new([0.0; 2]);
    vectorised(
        #[inline(always)]
        || {
            for (run, place) in parts(runs) {
                lanes.fold(
                    [&pressure[run], &trial[place]],
                    |[sum, most], [from, to]| {
                        let step = to - from;
                        let size = step.abs();
                        [sum + step, if size > most { size } else { most }]
                    },
                );
            }
        },
    );
    let [sum, largest] = lanes.reduce(|a, b| [a[0] + b[0], a[1].max(b[1])]);
    let datum = task.datum_displacement(|| sum);
    let unit = if largest > 0.0 { largest } else { 1.0 };
    let steps = work.inverse_buffers.signal(trial.len());
    vectorised(
        #[inline(always)]
        || {
            let per_unit = 1.0 / unit;
            for (run, place) in parts(runs) {
                let pairs = trial[place.clone()].iter().zip(&pressure[run]);
                for (step, (to, from)) in steps[place].iter_mut().zip(pairs) {
                    *step = ((to - from) * per_unit) as f32;
                }
            }
        },
    );
    level
        .single
        .filter_runs(&mut work.inverse_buffers, 1.0, runs);
    let scale = unit * task.compliance;
    let change = &*work.inverse_buffers.signal(pressure.len());
    let (opening, trial, spare) = (&work.opening, &work.trial, &mut work.ascent);
    spare.resize(trial.len(), 0.0);
    let mut lanes = Lanes::new([0.0; 2]);
    vectorised(
        #[inline(always)]
        || {
            for (run, place) in parts(runs) {
                let change = change[run.clone()].iter();
                for (to, &change) in spare[place.clone()].iter_mut().zip(change) {
                    *to = scale * f64::from(change) + datum;
                }
                let (p, v) = (&pressure[run.clone()], &opening[run]);
                let arrays = [p, &trial[place.clone()], v, &spare[place]];
                lanes.fold(arrays, |[slope, curvature], [p, to, v, change]| {
                    let step = to - p;
                    [slope + step * (v - approach), curvature + step * change]
                });
            }
        },
    );
    let [slope, curvature] = lanes.total();
    Line {
        slope,
        curvature,
        scale,
        datum,
    }
}

/// d = −z + β·d on F without its mean, with Polak and Ribière's β ≥ 0; −z when that is no descent.
pub(crate) fn choose_direction(
    level: Level,
    work: &mut Workspace,
    task: &Task,
    free: usize,
    residual_mean: f64,
    search: &mut Search,
) {
    // Steps of constant load have no mean, nor has what matters of the residual.
    let count = free as f64;
    let mean = |sum: f64| if task.sum.is_some() { sum / count } else { 0.0 };
    precondition(level, work, task, residual_mean);
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
    let (ascent, runs) = (&mut work.ascent, &work.runs);
    ascent.resize(free.len(), 0.0);
    vectorised(
        #[inline(always)]
        || {
            for (run, place) in parts(runs) {
                let values = z[run].iter().zip(&free[place.clone()]);
                for (to, (z, &free)) in ascent[place].iter_mut().zip(values) {
                    *to = if free { 0.5 * f64::from(*z) } else { 0.0 };
                }
            }
        },
    );
    if work.coarse.is_active() {
        deflate(level, work, scale);
    }
    let stiffness = scale / task.compliance;
    vectorised(|| work.ascent.iter_mut().for_each(|z| *z *= stiffness));
}

/// Lets z leave no mean residual on any contact patch. Both are in units of the residual's scale.
fn deflate(level: Level, work: &mut Workspace, scale: f64) {
    let (ascent, residual, runs) = (&mut work.ascent, &work.residual, &work.runs);
    let mean = ascent.iter().sum::<f64>() / ascent.len() as f64;
    let buffers = &mut work.inverse_buffers;
    let signal = buffers.signal(ascent.len());
    for (to, z) in signal.iter_mut().zip(&mut *ascent) {
        *z -= mean;
        *to = *z as f32;
    }
    level.single.filter_runs(buffers, 1.0, runs);
    let change = &*buffers.signal(work.pressure.len());
    let left = &mut work.trial;
    left.resize(ascent.len(), 0.0);
    for (run, place) in parts(runs) {
        let values = residual[place.clone()].iter().zip(&change[run]);
        for (to, (r, u)) in left[place].iter_mut().zip(values) {
            *to = r / scale - f64::from(*u);
        }
    }
    work.coarse.correct(left, ascent);
}

/// d = even pressures on the patches that remove the means of the residual over them. Takes the
/// mean of all from the residual.
pub(crate) fn remove_patch_means(work: &mut Workspace, task: &Task, residual_mean: f64) {
    let (ascent, residual) = (&mut work.ascent, &mut work.residual);
    residual.iter_mut().for_each(|r| *r -= residual_mean);
    ascent.clear();
    ascent.resize(residual.len(), 0.0);
    work.coarse.correct(residual, ascent);
    for (run, place) in parts(&work.runs) {
        let pairs = work.direction[run].iter_mut().zip(&ascent[place]);
        pairs.for_each(|(d, z)| *d = -z / task.compliance);
    }
}

/// Length of the step along d that minimises the energy without bounds.
fn exact_length(level: Level, work: &mut Workspace, task: &Task) -> f64 {
    let (runs, direction, residual) = (&work.runs, &work.direction, &work.residual);
    let steps = work.buffers.signal(listed(runs));
    for (run, place) in parts(runs) {
        steps[place].copy_from_slice(&direction[run]);
    }
    let datum = task.datum_displacement(|| steps.iter().sum());
    level
        .displacement
        .filter_runs(&mut work.buffers, task.compliance, runs);
    let change = &*work.buffers.signal(direction.len());
    let mut lanes = Lanes::new([0.0; 2]);
    for (run, place) in parts(runs) {
        let arrays = [&direction[run.clone()], &residual[place], &change[run]];
        lanes.fold(arrays, |[slope, curvature], [d, r, change]| {
            [slope + r * d, curvature + d * (change + datum)]
        });
    }
    let [slope, curvature] = lanes.total();
    if curvature > 0.0 {
        -slope / curvature
    } else {
        1.0
    }
}

/// q = p + τ·d, clipped and with its load restored; whether it had to be.
fn try_step(work: &mut Workspace, task: &Task, reach: f64) -> bool {
    let capacity = task.limit * listed(&work.runs) as f64;
    if task.sum.is_some_and(|sum| capacity <= sum) {
        work.list_all();
    }
    work.trial.resize(listed(&work.runs), 0.0);
    let (pressure, direction) = (&work.pressure, &work.direction);
    let (runs, trial) = (&work.runs, &mut work.trial);
    let mut outside = false;
    vectorised(
        #[inline(always)]
        || {
            for (run, place) in parts(runs) {
                let pairs = pressure[run.clone()].iter().zip(&direction[run]);
                for (to, (p, d)) in trial[place].iter_mut().zip(pairs) {
                    *to = p + reach * d;
                    outside |= (*to < 0.0) | (*to > task.limit);
                }
            }
        },
    );
    if outside {
        make_feasible(&mut work.trial, task);
    }
    outside
}

/// q = nearest feasible pressure to p − τ·g. It always descends, however few points can move:
/// clipping d and shifting the rest can lead back to p.
fn try_gradient(work: &mut Workspace, task: &Task, approach: f64) {
    let stiffness = GRADIENT / task.compliance;
    work.list_all();
    work.trial.clear();
    let pairs = work.pressure.iter().zip(&work.opening);
    work.trial
        .extend(pairs.map(|(p, v)| p - stiffness * (v - approach)));
    match task.sum {
        Some(sum) => project(&mut work.trial, sum, task.limit),
        None => clip(&mut work.trial, task.limit),
    }
}

/// Length of the step to the first bound.
fn farthest(work: &Workspace, limit: f64) -> f64 {
    let mut length = f64::INFINITY;
    for (run, place) in parts(&work.runs) {
        for (from, to) in work.pressure[run].iter().zip(&work.trial[place]) {
            let step = to - from;
            if step < 0.0 {
                length = length.min(from / -step);
            } else if step > 0.0 {
                length = length.min((limit - from) / step);
            }
        }
    }
    length
}
