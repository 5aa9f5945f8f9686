//! Line search: trial step within the bounds, exact step length, update of the pressure.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | p, q | pressure, trial pressure | Pa |
//! | d, τ | direction, length of the trial step along it | Pa, - |
//! | Δ = q − p, s | feasible step, its length by exact line search | Pa, - |
//! | v, α, g | u + h, approach, gap v − α | m |

use super::feasible_pressure::{clip, project, restore_load, shift_load};
use super::workspace::{Level, Task, Workspace};
use crate::convolution::{Convolution, Lanes, listed, parts, vectorised};
use crate::grid::Grid;

/// Step along the gradient, in units of π·E*/a: about the stiffness against pressure that moves to the
/// next cell, where the kernel is smaller by 6.6·a.
const GRADIENT: f64 = 0.1;

/// Pressure after a step, relative to the pressure before, that is only round-off and is set to zero.
/// Otherwise the point would count as lying between the bounds and could stall the iteration.
const RESIDUE: f64 = 1e-15;

/// Error of a displacement in single precision relative to its largest value. The errors for 50 to
/// 30 000 points are a tenth to a half of this.
pub(crate) const SINGLE: f64 = 1e-6;

/// Makes the pressure feasible and recomputes its displacement in double precision: both drift by round-off. Lists blocks of points
/// with pressure.
pub(crate) fn settle<G: Grid>(level: Level<G>, work: &mut Workspace, task: &Task) {
    work.list_loaded();
    work.trial.resize(listed(&work.runs), 0.0);
    for (run, place) in parts(&work.runs) {
        work.trial[place].copy_from_slice(&work.pressure[run]);
    }
    let points = work.pressure.len();
    let lacking = match task.sum {
        Some(sum) => (!shift_load(&mut work.trial, points, sum, task.limit)).then_some(sum),
        None => {
            clip(&mut work.trial, task.limit);
            None
        }
    };
    for (run, place) in parts(&work.runs) {
        work.pressure[run].copy_from_slice(&work.trial[place]);
    }
    if let Some(sum) = lacking {
        project(&mut work.pressure, sum, task.limit);
        work.list_loaded();
    }
    work.refresh(level.displacement, task);
}

/// Sets the trial pressure q = p + τ·d, with τ = `reach`, and makes it feasible. Returns whether it was
/// outside of its bounds.
pub(crate) fn try_step(work: &mut Workspace, task: &Task, reach: f64) -> bool {
    // Listed points that cannot carry the load at the limit leave no feasible trial pressure.
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
        match task.sum {
            Some(sum) => restore_load(&mut work.trial, sum, task.limit),
            None => clip(&mut work.trial, task.limit),
        }
    }
    outside
}

/// Sets the trial pressure q to the projection of p − τ·g onto the feasible pressures.
///
/// A projected gradient always descends, at any number of points between the bounds; a conjugate
/// direction that is clipped and shifted may lead back to p.
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

/// Length of the step at which the first point reaches a bound.
pub(crate) fn length_to_bound(work: &Workspace, limit: f64) -> f64 {
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

/// Length of the step along d that minimises the energy, without regard to the bounds.
pub(crate) fn exact_length<G: Grid>(level: Level<G>, work: &mut Workspace, task: &Task) -> f64 {
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

/// Energy along Δ = q − p: slope·s + ½·curvature·s².
pub(crate) struct Line {
    pub(crate) slope: f64,
    pub(crate) curvature: f64,
    /// Scale of the displacement in the buffers.
    pub(crate) scale: f64,
    /// Contribution of the datum to the displacement by Δ.
    pub(crate) datum: f64,
}

impl Line {
    pub(crate) fn descends(&self) -> bool {
        self.curvature > 0.0 && self.slope < 0.0
    }
}

/// Computes the energy along q − p and leaves the displacement by q − p, without scale and datum, in
/// the signal of the single-precision buffers.
///
/// Single precision is enough: its error is relative to the step and vanishes with it.
pub(crate) fn line_search<G: Grid>(
    level: Level<G>,
    work: &mut Workspace,
    task: &Task,
    approach: f64,
) -> Line {
    let (unit, sum) = load_steps(work);
    let (scale, datum) = (unit * task.compliance, task.datum_displacement(|| sum));
    let (buffers, runs) = (&mut work.single_buffers, &work.runs);
    level.single.filter_runs(buffers, 1.0, runs);
    let change = &*buffers.signal(work.pressure.len());
    let (pressure, opening, trial) = (&work.pressure, &work.opening, &work.trial);
    // The direction is known, so the ascent is no longer needed; its memory holds the displacements.
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

/// Writes q − p of the listed points to the single-precision buffers, in units of the largest.
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

/// Updates the pressure to p + s·Δ.
pub(crate) fn take_step(work: &mut Workspace, task: &Task, length: f64) {
    let (pressure, runs, trial) = (&mut work.pressure, &work.runs, &work.trial);
    vectorised(
        #[inline(always)]
        || {
            for (run, place) in parts(runs) {
                let (pressure, trial) = (&mut pressure[run], &trial[place]);
                if length == 1.0 {
                    // Points at a bound must be there to the last bit, or they would count as free.
                    pressure.copy_from_slice(trial);
                    continue;
                }
                for (p, to) in pressure.iter_mut().zip(trial) {
                    let moved = (*p + length * (to - *p)).clamp(0.0, task.limit);
                    *p = if moved > RESIDUE * *p { moved } else { 0.0 };
                }
            }
        },
    );
}

#[cfg(test)]
mod tests {
    use asperity_core::numerics::FourierNumber;

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
                let (mut planner, mut singles) = (f64::planner(), f32::planner());
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
                    let in_single = single_buffers.signal(points);
                    let most = exact.iter().fold(0.0, |m: f64, u| m.max(u.abs()));
                    let pairs = exact.iter().zip(in_single);
                    let lost = pairs.fold(0.0, |m: f64, (u, s)| m.max((u - f64::from(*s)).abs()));
                    assert!(lost < SINGLE * most);
                }
            }
        }
    }
}
