//! The active set: Newton's method on which points touch, with a few conjugate gradients per set.
//!
//! On a given free set F the pressure is the solution of a linear problem, whatever its sign; where
//! it leaves the bounds the point leaves F, and where the bodies overlap outside F the point joins
//! it (primal-dual active set; Hintermüller, Ito & Kunisch 2002, SIAM J. Optim. 13). Each linear
//! problem is solved only to a twentieth of its first residual before the set is looked at again.
//! Near the solution a handful of sets is enough, and no step is spoilt by clipping, which is what
//! lets the coarse space of contact patches pay. Far from it the sets may cycle: projected
//! conjugate gradients then take over.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | p, v, h | pressure, displacement with the undeformed gap | Pa, m |
//! | F, α, g | free set, mean of v over F, gap v − α | -, m, m |

use crate::ppcg::{Search, choose_direction, exact_length, level_forces, settle};
use crate::runs::{Lanes, Run, listed, parts, vectorised};
use crate::state::{Level, Task, Workspace};

/// Sets after which another way is tried.
const SETS: usize = 16;
/// Iterations on one set.
const ITERATIONS: usize = 60;
/// Residual over the first one of a set at which the set is looked at again.
const LOOSE: f64 = 0.05;
/// Residual and overlap that the tolerance forgives, in units of the tolerated penetration.
const FORGIVEN: f64 = 0.25;
/// Growth of the duality gap over its least value that tells of a cycle.
const WORSE: f64 = 3.0;

/// Improves `work.pressure` until its certificate is within the tolerance or the sets do not
/// settle; returns the iterations. The opening belongs to the pressure on return.
pub(crate) fn minimise(level: Level, work: &mut Workspace, task: &Task) -> usize {
    let (mut iterations, mut best) = (0, f64::INFINITY);
    let mut held: Option<Vec<Run>> = None;
    for sets in 0..SETS {
        work.list_all();
        let assessment = work.assess(task);
        if std::env::var_os("DBGI").is_some() {
            eprintln!("n {} SET gap {:.1e} pen {:.1e} its {}", work.pressure.len(), assessment.duality_gap, assessment.penetration, iterations);
        }
        let done = assessment.within(task.tolerance) || assessment.free == 0;
        if done || (sets > 2 && assessment.duality_gap > WORSE * best) || iterations >= task.max_iterations {
            break;
        }
        best = best.min(assessment.duality_gap);
        match held.take() {
            Some(runs) => work.runs = runs,
            None => {
                work.keep_free();
                let (runs, free) = (&work.runs, &work.free[..listed(&work.runs)]);
                if !work.coarse.prepare(work.pressure.len(), level.boundary, runs, free) { break; }
            }
        }
        iterations += solve_on_set(level, work, task);
        let change = work.update_set(task, FORGIVEN * task.tolerance * task.reference_gap);
        held = Some(std::mem::take(&mut work.runs));
        if change.clipped {
            settle(level, work, task);
        }
        if !change.clipped && !change.joined {
            break;
        }
    }
    for array in [&mut work.direction, &mut work.previous] {
        array.fill(0.0);
    }
    iterations
}

/// Conjugate gradients on the points of the runs, all of them free, until the set has to change or
/// the tolerance is met.
fn solve_on_set(level: Level, work: &mut Workspace, task: &Task) -> usize {
    let mut search = Search::default();
    let least = FORGIVEN * task.tolerance * task.reference_gap;
    let mut assessment = work.measure_set();
    if level_forces(level, work, task, assessment.mean) {
        step(level, work, task);
        assessment = work.measure_set();
    }
    let mut goal = (LOOSE * assessment.largest).max(least);
    for iteration in 0..ITERATIONS {
        if assessment.largest <= goal {
            if goal <= least || work.leaves_set(task, assessment.mean, least) {
                return iteration;
            }
            goal = least;
        }
        choose_direction(level, work, task, assessment.free, assessment.mean, &mut search);
        if !step(level, work, task) {
            return iteration;
        }
        assessment = work.measure_set();
    }
    ITERATIONS
}

/// Goes along the direction to the least energy, whatever the bounds; false when there is none.
fn step(level: Level, work: &mut Workspace, task: &Task) -> bool {
    let length = exact_length(level, work, task);
    if !(length.is_finite() && length > 0.0) {
        return false;
    }
    for (run, _) in parts(&work.runs) {
        let pairs = work.pressure[run.clone()].iter_mut().zip(&work.direction[run]);
        pairs.for_each(|(p, d)| *p += length * d);
    }
    work.open(length, 0.0);
    true
}

/// What is known of the residual on a set.
struct SetResidual {
    free: usize,
    /// α
    mean: f64,
    /// Largest |v − α|.
    largest: f64,
}

/// What the next set has that the last had not.
struct Change {
    clipped: bool,
    joined: bool,
}

impl Workspace {
    /// Keeps of the runs the points of F only.
    fn keep_free(&mut self) {
        let mut kept = vec![];
        for (run, place) in parts(&self.runs) {
            for (point, _) in run.zip(&self.free[place]).filter(|(_, free)| **free) {
                Run::push(&mut kept, point);
            }
        }
        self.free.clear();
        self.free.resize(listed(&kept), true);
        self.runs = kept;
    }

    /// v less its mean over the runs, all of whose points are free.
    fn measure_set(&mut self) -> SetResidual {
        let free = listed(&self.runs);
        self.free.clear();
        self.free.resize(free, true);
        self.residual.resize(free, 0.0);
        let Self { opening, residual, runs, .. } = self;
        let mut lanes = Lanes::new([0.0]);
        vectorised(|| {
            for (run, place) in parts(runs) {
                let v = &opening[run];
                residual[place].copy_from_slice(v);
                lanes.fold([v], |[sum], [v]| [sum + v]);
            }
        });
        let mean = lanes.total()[0] / free as f64;
        let mut lanes = Lanes::new([0.0]);
        let larger = |[most]: [f64; 1], [v]: [f64; 1]| {
            let size = (v - mean).abs();
            [if size > most { size } else { most }]
        };
        vectorised(|| lanes.fold([&*residual], larger));
        let [largest] = lanes.reduce(|a, b| [a[0].max(b[0])]);
        SetResidual { free, mean, largest }
    }

    /// Whether a point would leave the set or join it.
    fn leaves_set(&self, task: &Task, approach: f64, forgiven: f64) -> bool {
        let limit = task.limit;
        let outside = parts(&self.runs)
            .any(|(run, _)| self.pressure[run].iter().any(|&p| p < 0.0 || p > limit));
        outside || self.joins(task, approach, forgiven)
    }

    fn joins(&self, task: &Task, approach: f64, forgiven: f64) -> bool {
        let points = self.pressure.iter().zip(&self.opening);
        let mut any = false;
        vectorised(|| {
            for (&p, &v) in points {
                any |= joins(p, v - approach, task.limit, forgiven);
            }
        });
        any
    }

    /// Clips the pressure to its bounds, and takes the points between them and those on the wrong
    /// side of one as the next set.
    fn update_set(&mut self, task: &Task, forgiven: f64) -> Change {
        let approach = self.measure_set().mean;
        let limit = task.limit;
        let mut change = Change { clipped: false, joined: false };
        let mut next = vec![];
        for (i, (p, v)) in self.pressure.iter_mut().zip(&self.opening).enumerate() {
            let joins = joins(*p, v - approach, limit, forgiven);
            change.joined |= joins;
            if *p < 0.0 || *p > limit {
                change.clipped = true;
                *p = p.clamp(0.0, limit);
            } else if joins || (*p > 0.0 && *p < limit) {
                Run::push(&mut next, i);
            }
        }
        self.runs = next;
        change
    }
}

/// Whether a point at a bound is on its wrong side.
#[inline(always)]
fn joins(pressure: f64, gap: f64, limit: f64, forgiven: f64) -> bool {
    ((pressure == 0.0) & (gap < -forgiven)) | ((pressure == limit) & (gap > forgiven))
}
