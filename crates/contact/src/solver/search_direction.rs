//! Search directions: preconditioned residuals, each conjugate to the direction before.
//!
//! The preconditioner is the symbol |q| of the inverse of the half-plane, masked to the free points.
//! The coarse space of the contact patches then removes the mean residual of every patch.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | F, r | free set, residual: g on F without its mean | -, m |
//! | z = M r | preconditioned residual | Pa |
//! | d, β | direction, share of the last one | Pa, - |

use super::workspace::{Level, Task, Workspace};
use crate::convolution::{Convolution, Lanes, parts, vectorised};
use crate::grid::Grid;
use asperity_core::cite;

/// State of the search between iterations.
#[derive(Default)]
pub(crate) struct Search {
    /// τ; `None` before the first direction.
    pub(crate) length: Option<f64>,
    /// r·z of the last direction; zero restarts the conjugate directions.
    pub(crate) descent: f64,
    /// Error of the displacement in m from single precision.
    pub(crate) drift: f64,
}

/// d = −z + β·d on F without its mean, with β ≥ 0 after Polak and Ribière (1969); −z if that is not a
/// descent.
///
/// This β, unlike the one by Fletcher and Reeves, becomes small after an iteration with little progress,
/// as after clipping, and so restarts the directions by itself.
pub(crate) fn choose_direction<G: Grid>(
    level: Level<G>,
    work: &mut Workspace,
    task: &Task,
    free: usize,
    residual_mean: f64,
    search: &mut Search,
) {
    // A step of constant load has no mean, so means are removed; a controlled approach keeps them.
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

/// Sums over F.
struct AscentSums {
    /// Σ z
    z: f64,
    /// Σ r·z
    r_z: f64,
    /// Sum of the residual of the last iteration.
    old: f64,
    /// Sum of the residual of the last iteration, times z.
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

/// Subtracts the mean from r and computes z = M r.
fn precondition<G: Grid>(level: Level<G>, work: &mut Workspace, task: &Task, residual_mean: f64) {
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
    // Scaled to one, so that single precision neither overflows nor underflows in any units.
    let [largest] = lanes.reduce(|a, b| [a[0].max(b[0])]);
    let scale = if largest > 0.0 { largest } else { 1.0 };
    let buffers = &mut work.single_buffers;
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

/// z = B r + Z·K⁻¹·Zᵀ(r − A·B r), B r being z before, Z even pressures on the patches   `[Deflation-1]`
///
/// z then leaves no mean residual on any contact patch. This is the preconditioner A-DEF2 of Tang et
/// al. (2009). All values are in units of the largest residual.
fn deflate<G: Grid>(level: Level<G>, work: &mut Workspace, scale: f64) {
    cite!("Deflation-1");
    let (ascent, residual, runs) = (&mut work.ascent, &work.residual, &work.runs);
    let mean = ascent.iter().sum::<f64>() / ascent.len() as f64;
    ascent.iter_mut().for_each(|z| *z -= mean);
    let left = &mut work.trial;
    left.clear();
    left.extend(residual.iter().map(|r| r / scale));
    if work.coarse.correct_displaced(left, ascent) {
        return;
    }
    let buffers = &mut work.single_buffers;
    let signal = buffers.signal(ascent.len());
    for (to, z) in signal.iter_mut().zip(&*ascent) {
        *to = *z as f32;
    }
    level.single.filter_runs(buffers, 1.0, runs);
    let change = &*buffers.signal(work.pressure.len());
    for (run, place) in parts(runs) {
        for (left, u) in left[place].iter_mut().zip(&change[run]) {
            *left -= f64::from(*u);
        }
    }
    work.coarse.correct(left, ascent);
}

/// Sets d to the uniform pressures on the patches that remove the means of the residual over them.
/// Subtracts the mean over all points from the residual.
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
