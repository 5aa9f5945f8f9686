//! Line search: trial step within the bounds, exact step length, update of the pressure.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | p, q | pressure, trial pressure | Pa |
//! | d, τ | direction, length of the trial step along it | Pa, - |
//! | Δ = q − p, s | feasible step, its length by exact line search | Pa, - |
//! | v, α, g | u + h, approach, gap v − α | m |

use super::feasible_pressure::{clip, project, restore_load};
use super::workspace::{Level, Task, Workspace};
use crate::convolution::{Lanes, listed, parts, vectorised};

/// Step along the gradient, in π·E*/a: about the stiffness of pressure moved to the next cell,
/// whose kernel differs by 6.6·a.
const GRADIENT: f64 = 0.1;

/// Pressure left of that before a step that is nothing but round-off. A point that keeps it counts
/// as lying between the bounds, and can hold the iteration where no step improves anything.
const DUST: f64 = 1e-15;

/// Error of a displacement in single precision over its largest value: a tenth to a half of this from
/// 50 to 30 000 points.
pub(crate) const SINGLE: f64 = 1e-6;

/// Makes the pressure feasible and computes its displacement afresh: both drift by round-off.
pub(crate) fn settle(level: Level, work: &mut Workspace, task: &Task) {
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

/// q = p + τ·d, clipped and with its load restored; whether it had to be.
pub(crate) fn try_step(work: &mut Workspace, task: &Task, reach: f64) -> bool {
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
pub(crate) fn try_gradient(work: &mut Workspace, task: &Task, approach: f64) {
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
pub(crate) fn farthest(work: &Workspace, limit: f64) -> f64 {
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

/// Length of the step along d that minimises the energy without bounds.
pub(crate) fn exact_length(level: Level, work: &mut Workspace, task: &Task) -> f64 {
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

/// The energy along Δ = q − p: slope·s + ½·curvature·s².
pub(crate) struct Line {
    pub(crate) slope: f64,
    pub(crate) curvature: f64,
    /// Of the displacement that the buffers hold.
    pub(crate) scale: f64,
    /// Contribution of the datum to the displacement by Δ.
    pub(crate) datum: f64,
}

impl Line {
    pub(crate) fn descends(&self) -> bool {
        self.curvature > 0.0 && self.slope < 0.0
    }
}

/// Leaves the displacement by q − p, but for a scale and the datum, in the signal of the
/// single-precision buffers: as steps become short, so does what is lost of them.
pub(crate) fn line_search(level: Level, work: &mut Workspace, task: &Task, approach: f64) -> Line {
    let (unit, sum) = load_steps(work);
    let (scale, datum) = (unit * task.compliance, task.datum_displacement(|| sum));
    let (buffers, runs) = (&mut work.single_buffers, &work.runs);
    level.single.filter_runs(buffers, 1.0, runs);
    let change = &*buffers.signal(work.pressure.len());
    let (pressure, opening, trial) = (&work.pressure, &work.opening, &work.trial);
    // The ascent has made its direction: its place holds the change of the listed points.
    let spare = &mut work.ascent;
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

/// Puts q − p of the listed points into the single-precision buffers, in units of the largest.
/// Returns the unit and the sum.
fn load_steps(work: &mut Workspace) -> (f64, f64) {
    let (pressure, runs, trial) = (&work.pressure, &work.runs, &work.trial);
    let mut lanes = Lanes::new([0.0; 2]);
    vectorised(
        #[inline(always)]
        || {
            for (run, place) in parts(runs) {
                lanes.fold(
                    [&pressure[run], &trial[place]],
                    |[sum, most], [from, to]| {
                        let size = (to - from).abs();
                        [sum + (to - from), if size > most { size } else { most }]
                    },
                );
            }
        },
    );
    let [sum, largest] = lanes.reduce(|a, b| [a[0] + b[0], a[1].max(b[1])]);
    let unit = if largest > 0.0 { largest } else { 1.0 };
    let steps = work.single_buffers.signal(trial.len());
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
    (unit, sum)
}

/// p + s·Δ
pub(crate) fn take_step(work: &mut Workspace, task: &Task, length: f64) {
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

#[cfg(test)]
mod tests {
    use rustfft::FftPlanner;

    use super::*;
    use crate::boundary::{Boundary, PeriodicKernel};
    use crate::convolution::Buffers;
    use crate::half_plane::displacement_filter;

    #[test]
    fn single_precision_loses_little_of_a_displacement() {
        for boundary in [
            Boundary::FreeEnds,
            Boundary::Periodic(PeriodicKernel::Strip),
        ] {
            for points in [50, 1_000, 30_000] {
                let (mut planner, mut singles) = (FftPlanner::new(), FftPlanner::new());
                let mut buffers = Buffers::default();
                let filter =
                    displacement_filter(&mut planner, points, boundary, &mut vec![], &mut buffers);
                let single = filter.single(&mut singles);
                let mut single_buffers = Buffers::default();
                buffers.reserve(&filter);
                single_buffers.reserve(&single);
                // Steps of constant load, smooth and rough.
                for roughness in [0.0, 1.0] {
                    let value = |i: usize| {
                        let x = i as f64 / points as f64 - 0.5;
                        x + roughness * (12.9898 * (i * i) as f64).sin()
                    };
                    let mean = (0..points).map(value).sum::<f64>() / points as f64;
                    let steps: Vec<f64> = (0..points).map(|i| value(i) - mean).collect();
                    let rounded: Vec<f32> = steps.iter().map(|&x| x as f32).collect();
                    filter.filter(&mut buffers, 1.0, &steps);
                    single.filter(&mut single_buffers, 1.0, &rounded);
                    let exact = buffers.signal(points);
                    let found = single_buffers.signal(points);
                    let most = exact.iter().fold(0.0, |m: f64, u| m.max(u.abs()));
                    let pairs = exact.iter().zip(found);
                    let lost = pairs.fold(0.0, |m: f64, (u, s)| m.max((u - f64::from(*s)).abs()));
                    assert!(lost < SINGLE * most);
                }
            }
        }
    }
}
