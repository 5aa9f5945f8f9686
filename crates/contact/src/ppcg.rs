//! Projected preconditioned conjugate gradients for bounded pressures.
//!
//! One displacement and one preconditioner application per iteration, where the method of
//! Polonsky and Keer (1999) needs two displacements and three to twelve times the iterations. The
//! free set holds the points between the bounds and those at a bound with the gap on its wrong
//! side. A trial step along the direction is clipped and its load restored; the exact line search
//! is then made along the feasible difference, whose displacement is the only one needed.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | p, u, h | pressure, displacement, undeformed gap | Pa, m, m |
//! | α, g | approach, gap u + h − α | m |
//! | F, r | free set, residual: g on F without its mean | -, m |
//! | z = M r | preconditioned residual | Pa |
//! | d, τ | direction, length of the trial step along it | Pa, - |
//! | Δ, s | feasible step, its length by exact line search | Pa, - |

use realfft::RealFftPlanner;

use crate::half_plane::{displacement_filter, inverse_filter};
use crate::problem::Boundary;
use crate::projection::restore_load;
use crate::transform::EvenFilter;

/// Updates of the displacement after which it is computed afresh, before round-off gathers.
const REFRESH: usize = 50;
/// Iterations without a smaller duality gap after which no more progress is expected.
const STALL: usize = 400;
/// A clipped step is taken whole when the line search would go at least half as far: the energy
/// then decreases, and the bounds are identified exactly.
const WHOLE: f64 = 0.5;

/// Operators of one grid.
pub(crate) struct Level {
    pub(crate) displacement: EvenFilter,
    inverse: EvenFilter,
}

impl Level {
    pub(crate) fn new(
        planner: &mut RealFftPlanner<f64>,
        points: usize,
        boundary: Boundary,
    ) -> Self {
        Self {
            displacement: displacement_filter(planner, points, boundary),
            inverse: inverse_filter(planner, points),
        }
    }
}

/// What is minimised on one grid.
pub(crate) struct Task<'a> {
    /// h [m], with the displacement by prescribed pressures; less the approach when it is controlled.
    pub(crate) gap: &'a [f64],
    /// Σp [Pa], unless the approach is controlled.
    pub(crate) sum: Option<f64>,
    /// Limit of the pressure [Pa], infinite for none.
    pub(crate) limit: f64,
    /// a/(π·E*) [m/Pa].
    pub(crate) compliance: f64,
    /// Displacement per Σp by the datum [m/Pa]; only matters when the approach is controlled.
    pub(crate) datum: f64,
    pub(crate) reference_gap: f64,
    pub(crate) tolerance: f64,
    pub(crate) max_iterations: usize,
}

/// The arrays of an iteration; `pressure` is both start and result.
#[derive(Default)]
pub(crate) struct Workspace {
    pub(crate) pressure: Vec<f64>,
    pub(crate) displacement: Vec<f64>,
    residual: Vec<f64>,
    previous: Vec<f64>,
    direction: Vec<f64>,
    trial: Vec<f64>,
    free: Vec<bool>,
}

/// What is known of a pressure.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Assessment {
    /// α [m]; zero when the approach is controlled.
    pub(crate) approach: f64,
    pub(crate) duality_gap: f64,
    pub(crate) penetration: f64,
    free: usize,
    residual_sum: f64,
}

impl Assessment {
    pub(crate) fn within(&self, tolerance: f64) -> bool {
        self.duality_gap <= tolerance && self.penetration <= tolerance
    }
}

/// Memory of the search from one iteration to the next.
struct Search {
    /// τ, not known before the first direction.
    length: Option<f64>,
    /// r·z of the last direction, or zero to begin anew along z.
    descent: f64,
}

impl Workspace {
    /// Sets the size of all arrays but the pressure, which decides it.
    fn resize(&mut self) {
        let points = self.pressure.len();
        for array in [
            &mut self.displacement,
            &mut self.residual,
            &mut self.previous,
            &mut self.direction,
            &mut self.trial,
        ] {
            array.clear();
            array.resize(points, 0.0);
        }
        self.free.clear();
        self.free.resize(points, false);
    }

    /// u = A p
    pub(crate) fn refresh(&mut self, level: &mut Level, task: &Task) {
        level.displacement.signal().copy_from_slice(&self.pressure);
        let datum = displace(level, task);
        let fresh = level.displacement.signal();
        self.displacement.clear();
        self.displacement.extend(fresh.iter().map(|u| u + datum));
    }

    /// α: mean of v = u + h between the bounds; with no such point the largest v under pressure.
    fn approach(&self, task: &Task) -> f64 {
        if task.sum.is_none() {
            return 0.0;
        }
        let (mut sum, mut count, mut most) = (0.0, 0_usize, f64::NEG_INFINITY);
        for ((&p, &u), &h) in self.pressure.iter().zip(&self.displacement).zip(task.gap) {
            if p > 0.0 {
                most = most.max(u + h);
                if p < task.limit {
                    sum += u + h;
                    count += 1;
                }
            }
        }
        if count > 0 { sum / count as f64 } else { most }
    }

    /// g = u + h − α
    pub(crate) fn gap(&self, task: &Task, approach: f64) -> impl Iterator<Item = f64> {
        let pairs = self.displacement.iter().zip(task.gap);
        pairs.map(move |(u, h)| u + h - approach)
    }

    /// F, after an assessment.
    pub(crate) fn free(&self) -> &[bool] {
        &self.free
    }

    /// Free set, residual and certificate of the present pressure and displacement.
    pub(crate) fn assess(&mut self, task: &Task) -> Assessment {
        let approach = self.approach(task);
        let limited = task.limit.is_finite();
        let (mut sum, mut energy, mut excess) = (0.0, 0.0, 0.0);
        let (mut least, mut residual_sum, mut free) = (0.0_f64, 0.0, 0);
        self.residual.resize(self.pressure.len(), 0.0);
        self.free.resize(self.pressure.len(), false);
        for (i, &p) in self.pressure.iter().enumerate() {
            let g = self.displacement[i] + task.gap[i] - approach;
            sum += p;
            energy += p * if limited { g.max(0.0) } else { g };
            let below = p < task.limit;
            if below {
                least = least.min(g);
                if limited {
                    excess += (task.limit - p) * (-g).max(0.0);
                }
            }
            let is_free = if p <= 0.0 { g < 0.0 } else { below || g > 0.0 };
            self.free[i] = is_free;
            self.residual[i] = if is_free { g } else { 0.0 };
            residual_sum += self.residual[i];
            free += usize::from(is_free);
        }
        let bound = if limited {
            energy + excess
        } else {
            energy - least * sum
        };
        Assessment {
            approach,
            duality_gap: if bound == 0.0 {
                0.0
            } else {
                bound / (sum * task.reference_gap)
            },
            penetration: if least == 0.0 {
                0.0
            } else {
                -least / task.reference_gap
            },
            free,
            residual_sum,
        }
    }
}

/// Replaces the signal by its displacement with C(0) = 0; returns what the datum adds.
fn displace(level: &mut Level, task: &Task) -> f64 {
    let datum = if task.sum.is_some() || task.datum == 0.0 {
        0.0
    } else {
        task.datum * level.displacement.signal().iter().sum::<f64>()
    };
    level.displacement.apply(task.compliance);
    datum
}

/// Improves `work.pressure` until its certificate is within the tolerance or no progress is left;
/// returns the iterations.
pub(crate) fn minimise(level: &mut Level, work: &mut Workspace, task: &Task) -> usize {
    work.resize();
    match task.sum {
        Some(sum) => restore_load(&mut work.pressure, sum, task.limit),
        None => clip(&mut work.pressure, task.limit),
    }
    work.refresh(level, task);
    let mut search = Search {
        length: None,
        descent: 0.0,
    };
    let (mut iterations, mut updates, mut stalled, mut best) = (0, 0, 0, f64::INFINITY);
    loop {
        let mut assessment = work.assess(task);
        if updates > 0 && (assessment.within(task.tolerance) || updates >= REFRESH) {
            work.refresh(level, task);
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

fn clip(pressure: &mut [f64], limit: f64) {
    for p in pressure {
        *p = p.clamp(0.0, limit);
    }
}

/// One iteration; false when the energy cannot be lowered along the direction.
fn advance(
    level: &mut Level,
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
    let clipped = try_step(work, task, reach);
    let pairs = work.trial.iter().zip(&work.pressure);
    let signal = level.displacement.signal();
    for (step, (to, from)) in signal.iter_mut().zip(pairs) {
        *step = to - from;
    }
    let datum = displace(level, task);
    let change = level.displacement.signal();
    let (mut slope, mut curvature) = (0.0, 0.0);
    for (i, &change) in change.iter().enumerate() {
        let step = work.trial[i] - work.pressure[i];
        slope += step * (work.displacement[i] + task.gap[i] - assessment.approach);
        curvature += step * (change + datum);
    }
    if !(curvature > 0.0 && slope.is_finite()) {
        return false;
    }
    let s = -slope / curvature;
    let length = if clipped {
        search.length = Some(reach * s.clamp(0.5, 2.0));
        if s < WHOLE {
            search.descent = 0.0;
        }
        if s < WHOLE { s.max(0.0) } else { 1.0 }
    } else {
        search.length = Some(reach * s.clamp(0.1, 4.0));
        if s > 1.0 {
            s.min(farthest(work, task.limit))
        } else {
            s
        }
    };
    for (i, &change) in change.iter().enumerate() {
        let (from, to) = (work.pressure[i], work.trial[i]);
        work.displacement[i] += length * (change + datum);
        // A step that is taken whole must land on the bounds to the last bit.
        work.pressure[i] = if length == 1.0 {
            to
        } else {
            (from + length * (to - from)).clamp(0.0, task.limit)
        };
    }
    true
}

/// d = −z + β·d on F without its mean, with Polak and Ribière's β ≥ 0; −z when that is no descent.
fn choose_direction(
    level: &mut Level,
    work: &mut Workspace,
    task: &Task,
    assessment: &Assessment,
    search: &mut Search,
) {
    let loaded = task.sum.is_some();
    let mean = |sum: f64| {
        if loaded {
            sum / assessment.free as f64
        } else {
            0.0
        }
    };
    let residual_mean = mean(assessment.residual_sum);
    let signal = level.inverse.signal();
    for i in 0..signal.len() {
        if work.free[i] {
            work.residual[i] -= residual_mean;
        }
        signal[i] = work.residual[i];
    }
    level.inverse.apply(0.5 / task.compliance);
    let z = level.inverse.signal();
    let (mut z_sum, mut r_z, mut old_sum, mut old_z) = (0.0, 0.0, 0.0, 0.0);
    for i in 0..z.len() {
        if work.free[i] {
            z_sum += z[i];
            r_z += work.residual[i] * z[i];
            old_sum += work.previous[i];
            old_z += work.previous[i] * z[i];
        }
    }
    let z_mean = mean(z_sum);
    old_z -= z_mean * old_sum;
    let beta = if search.descent > 0.0 {
        ((r_z - old_z) / search.descent).max(0.0)
    } else {
        0.0
    };
    let (mut d_sum, mut r_d) = (0.0, 0.0);
    for i in 0..z.len() {
        let d = if work.free[i] {
            z_mean - z[i] + beta * work.direction[i]
        } else {
            0.0
        };
        work.direction[i] = d;
        d_sum += d;
        r_d += work.residual[i] * d;
    }
    let d_mean = mean(d_sum);
    for i in 0..z.len() {
        if work.free[i] {
            work.direction[i] = if r_d < 0.0 {
                work.direction[i] - d_mean
            } else {
                z_mean - z[i]
            };
        }
    }
    search.descent = r_z;
    std::mem::swap(&mut work.residual, &mut work.previous);
}

/// Length of the step along d that minimises the energy without bounds; r is in `previous`.
fn exact_length(level: &mut Level, work: &Workspace, task: &Task) -> f64 {
    level.displacement.signal().copy_from_slice(&work.direction);
    let datum = displace(level, task);
    let (mut slope, mut curvature) = (0.0, 0.0);
    for (i, &change) in level.displacement.signal().iter().enumerate() {
        slope += work.previous[i] * work.direction[i];
        curvature += work.direction[i] * (change + datum);
    }
    if curvature > 0.0 {
        -slope / curvature
    } else {
        1.0
    }
}

/// q = p + τ·d, clipped and with its load restored; whether it had to be.
fn try_step(work: &mut Workspace, task: &Task, reach: f64) -> bool {
    let mut outside = false;
    for (i, q) in work.trial.iter_mut().enumerate() {
        *q = work.pressure[i] + reach * work.direction[i];
        outside |= *q < 0.0 || *q > task.limit;
    }
    if outside {
        match task.sum {
            Some(sum) => restore_load(&mut work.trial, sum, task.limit),
            None => clip(&mut work.trial, task.limit),
        }
    }
    outside
}

/// Length of the step to the first bound.
fn farthest(work: &Workspace, limit: f64) -> f64 {
    let mut length = f64::INFINITY;
    for (&to, &from) in work.trial.iter().zip(&work.pressure) {
        let step = to - from;
        if step < 0.0 {
            length = length.min(from / -step);
        } else if step > 0.0 {
            length = length.min((limit - from) / step);
        }
    }
    length
}
