//! Arrays and operators of an iteration on one grid, and the assessment of a pressure.
//!
//! All passes except the transforms and one over v are restricted to the points with pressure or
//! overlap, held as runs of neighbours: a rough contact covers a small part of its grid.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | p, u, h | pressure, displacement, undeformed gap | Pa, m, m |
//! | v, α, g | u + h, approach, gap v − α | m |
//! | F | free set: points between the bounds, and points at a bound whose gap has the wrong sign | - |

use asperity_core::cite;

use super::coarse_space::CoarseSpace;
use crate::boundary::Boundary;
use crate::convolution::{Buffers, Convolution, Lanes, Run, extend, listed, parts, vectorised};
use crate::grid::Grid;

/// Points that are searched together for overlap: the bits of an integer mark those in contact.
pub(crate) const BLOCK: usize = u64::BITS as usize;

/// Operators of one grid.
pub(crate) struct Level<'a, G: Grid> {
    pub(crate) displacement: &'a G::Filter<f64>,
    /// The displacement in single precision, for steps and preconditioner.
    pub(crate) single: &'a G::Filter<f32>,
    /// The symbol |q|, nearly the inverse of the displacement.
    pub(crate) inverse: &'a G::Filter<f32>,
    pub(crate) boundary: Boundary,
}

impl<G: Grid> Clone for Level<'_, G> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<G: Grid> Copy for Level<'_, G> {}

/// Bounded quadratic problem on one grid.
pub(crate) struct Task<'a> {
    /// h plus the displacement by the prescribed pressure, minus a controlled approach, in m.
    pub(crate) gap: &'a [f64],
    /// Points along rolling; there are as many rows along the lead as the gap holds.
    pub(crate) columns: usize,
    /// Σp in Pa, unless the approach is controlled.
    pub(crate) sum: Option<f64>,
    /// Limit of the pressure in Pa, infinite for none.
    pub(crate) limit: f64,
    /// a/(π·E*) in m/Pa.
    pub(crate) compliance: f64,
    /// Displacement by the datum per Σp in m/Pa; used only when the approach is controlled.
    pub(crate) datum: f64,
    pub(crate) reference_gap: f64,
    pub(crate) reference_bounds: ReferenceBounds,
    pub(crate) tolerance: f64,
    /// Least tolerance of a coarser grid, whose tolerance is `gain` times the certificate of its start.
    pub(crate) least_tolerance: f64,
    /// Certificate of the solution of a coarser grid relative to its start.
    pub(crate) gain: f64,
    pub(crate) max_iterations: usize,
}

/// Bounds of the reference gap in m, known before the solution.
#[derive(Clone, Copy)]
pub(crate) struct ReferenceBounds {
    pub(crate) least: f64,
    /// Range of the gap.
    pub(crate) most: f64,
}

impl ReferenceBounds {
    /// The smaller of the ranges of gap and deformation in m, at least the lower bound.
    pub(crate) fn between(self, deformation: f64) -> f64 {
        let Self { least, most } = self;
        if deformation > 0.0 {
            most.min(deformation).max(least)
        } else {
            most.max(least)
        }
    }
}

impl Task<'_> {
    /// Displacement by the datum in m for pressures of this sum.
    pub(crate) fn datum_displacement(&self, sum: impl FnOnce() -> f64) -> f64 {
        if self.sum.is_some() || self.datum == 0.0 {
            0.0
        } else {
            self.datum * sum()
        }
    }
}

/// Arrays of an iteration; `pressure` is the start and the result.
#[derive(Default)]
pub(crate) struct Workspace {
    pub(crate) buffers: Buffers,
    pub(crate) single_buffers: Buffers<f32>,
    pub(crate) coarse: CoarseSpace,
    pub(crate) pressure: Vec<f64>,
    /// v
    pub(crate) opening: Vec<f64>,
    /// Direction of the last iteration; zero outside of the runs.
    pub(crate) direction: Vec<f64>,
    /// Residual of the last iteration; zero outside of the runs.
    pub(crate) previous: Vec<f64>,
    /// Runs of points with pressure or overlap, in order: the listed points.
    pub(crate) runs: Vec<Run>,
    /// Memory for the runs that replace `runs`.
    pub(crate) next: Vec<Run>,
    /// Free set of the next iterations.
    pub(crate) held: Vec<Run>,
    /// Residual of each listed point, zero outside of F.
    pub(crate) residual: Vec<f64>,
    /// Preconditioned residual of each listed point.
    pub(crate) ascent: Vec<f64>,
    /// Trial pressure of each listed point.
    pub(crate) trial: Vec<f64>,
    /// Whether a listed point is in F.
    pub(crate) free: Vec<bool>,
}

/// Approach, error bounds and free set of a pressure.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Assessment {
    /// α in m; zero when the approach is controlled.
    pub(crate) approach: f64,
    pub(crate) duality_gap: f64,
    pub(crate) penetration: f64,
    /// Points in F.
    pub(crate) free: usize,
    /// Σ g over F.
    pub(crate) residual_sum: f64,
}

impl Assessment {
    pub(crate) fn within(&self, tolerance: f64) -> bool {
        self.duality_gap <= tolerance && self.penetration <= tolerance
    }
}

impl Workspace {
    /// Sizes all arrays for the pressure, so that the iteration allocates nothing.
    pub(crate) fn resize(&mut self) {
        let points = self.pressure.len();
        for array in [&mut self.direction, &mut self.previous] {
            array.clear();
            array.resize(points, 0.0);
        }
        for array in [&mut self.residual, &mut self.ascent, &mut self.trial] {
            array.clear();
            array.reserve(points);
        }
        self.free.clear();
        self.free.reserve(points);
        // At most every other point begins a run.
        for runs in [&mut self.runs, &mut self.next, &mut self.held] {
            runs.clear();
            runs.reserve(points.div_ceil(2));
        }
    }

    /// Frees the memory that only an iteration needs.
    pub(crate) fn release(&mut self) {
        self.single_buffers = Buffers::default();
        self.coarse = CoarseSpace::default();
        for array in [
            &mut self.direction,
            &mut self.previous,
            &mut self.ascent,
            &mut self.trial,
        ] {
            *array = Vec::new();
        }
    }

    /// Recomputes v = A p + h in double precision from the pressure on the runs, outside of which it is zero, with
    ///
    /// A p = (1/(π·E*))·Σⱼ C_ij·p_j  `[P1]`
    pub(crate) fn refresh(&mut self, displacement: &impl Convolution<f64>, task: &Task) {
        cite!("P1");
        let (buffers, pressure, runs) = (&mut self.buffers, &self.pressure, &self.runs);
        let signal = buffers.signal(pressure.len());
        for (run, place) in parts(runs) {
            signal[place].copy_from_slice(&pressure[run]);
        }
        displacement.filter_runs(buffers, task.compliance, runs);
        let datum = task.datum_displacement(|| pressure.iter().sum());
        let pairs = buffers.signal(pressure.len()).iter().zip(task.gap);
        self.opening.clear();
        self.opening.extend(pairs.map(|(u, h)| u + datum + h));
    }

    /// Range of the deformation in m from half a contact width before the first column under pressure
    /// to half a contact width behind the last; zero without pressure.
    pub(crate) fn deformation(&self, task: &Task) -> f64 {
        let columns = task.columns;
        let Some([first, last]) = loaded_columns(&self.pressure, columns) else {
            return 0.0;
        };
        let half_width = (last - first + 1).div_ceil(2);
        let about = first.saturating_sub(half_width)..(last + half_width + 1).min(columns);
        let mut lanes = Lanes::new([f64::INFINITY, f64::NEG_INFINITY]);
        vectorised(
            #[inline(always)]
            || {
                let rows = self.opening.chunks_exact(columns);
                for (opening, gap) in rows.zip(task.gap.chunks_exact(columns)) {
                    let arrays = [&opening[about.clone()], &gap[about.clone()]];
                    lanes.fold(arrays, |[least, most], [v, h]| {
                        let u = v - h;
                        [
                            if u < least { u } else { least },
                            if u > most { u } else { most },
                        ]
                    });
                }
            },
        );
        let [least, most] = lanes.reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])]);
        most - least
    }

    /// Reference gap of the present pressure in m.
    pub(crate) fn reference_gap(&self, task: &Task) -> f64 {
        task.reference_bounds.between(self.deformation(task))
    }

    pub(crate) fn list_all(&mut self) {
        self.runs.clear();
        self.runs.push(Run::new(0, self.pressure.len()));
    }

    /// Lists blocks that hold all points whose pressure is not zero. Sums over blocks in [`Lanes`] equal those over all points to
    /// the last digit.
    pub(crate) fn list_loaded(&mut self) {
        let (pressure, runs) = (&self.pressure, &mut self.runs);
        runs.clear();
        vectorised(
            #[inline(always)]
            || {
                for (block, values) in pressure.chunks(BLOCK).enumerate() {
                    if values.iter().fold(false, |any, p| any | (*p != 0.0)) {
                        let first = block * BLOCK;
                        runs.push(Run::new(first, first + values.len()));
                    }
                }
            },
        );
    }

    /// Updates v to v + s·(A Δ + `datum`), with A Δ the signal of the single-precision buffers times
    /// `scale`; the pressure has been updated before.
    pub(crate) fn open(&mut self, length: f64, scale: f64, datum: f64) {
        let change = &*self.single_buffers.signal(self.opening.len());
        let (opening, slope, rise) = (&mut self.opening, length * scale, length * datum);
        vectorised(
            #[inline(always)]
            || {
                for (v, &change) in opening.iter_mut().zip(change) {
                    *v += slope * f64::from(change) + rise;
                }
            },
        );
    }

    /// Largest magnitude in the signal of the single-precision buffers.
    pub(crate) fn largest_change(&mut self) -> f64 {
        let change = &*self.single_buffers.signal(self.opening.len());
        let (mut least, mut most) = ([0_f32; 8], [0_f32; 8]);
        vectorised(
            #[inline(always)]
            || {
                for block in change.as_chunks::<8>().0 {
                    for lane in 0..8 {
                        least[lane] = if block[lane] < least[lane] {
                            block[lane]
                        } else {
                            least[lane]
                        };
                        most[lane] = if block[lane] > most[lane] {
                            block[lane]
                        } else {
                            most[lane]
                        };
                    }
                }
            },
        );
        let largest = most
            .iter()
            .zip(&least)
            .fold(0.0, |m, (a, b)| f32::max(m, a.max(-b)));
        f64::from(largest)
    }

    /// α: mean of v over the points between the bounds; without such points the largest v under pressure.
    fn approach(&self, task: &Task) -> f64 {
        if task.sum.is_none() {
            return 0.0;
        }
        let limit = task.limit;
        let mut lanes = Lanes::new([0.0, 0.0, f64::NEG_INFINITY]);
        vectorised(
            #[inline(always)]
            || {
                for (run, _) in parts(&self.runs) {
                    let arrays = [&self.pressure[run.clone()], &self.opening[run]];
                    lanes.fold(arrays, |[sum, count, most], [p, v]| {
                        let between = (p > 0.0) & (p < limit);
                        [
                            sum + if between { v } else { 0.0 },
                            count + if between { 1.0 } else { 0.0 },
                            if (p > 0.0) & (v > most) { v } else { most },
                        ]
                    });
                }
            },
        );
        let [sum, count, most] = lanes.reduce(|a, b| [a[0] + b[0], a[1] + b[1], a[2].max(b[2])]);
        if count > 0.0 { sum / count } else { most }
    }

    /// Lists the points with pressure or overlap. Points with pressure are among those listed before, so
    /// only overlap is searched outside of the old runs.
    fn relist(&mut self, approach: f64) {
        let Self {
            pressure,
            opening,
            direction,
            previous,
            runs,
            next,
            ..
        } = self;
        next.clear();
        vectorised(
            #[inline(always)]
            || {
                let mut known = runs.iter().map(|run| run.range()).peekable();
                for (block, opening) in opening.chunks(BLOCK).enumerate() {
                    let first = block * BLOCK;
                    let range = first..first + opening.len();
                    while known.next_if(|run| run.end <= first).is_some() {}
                    let was_listed = known.peek().is_some_and(|run| run.start < range.end);
                    let overlaps = |any, &v: &f64| any | (v < approach);
                    if !was_listed && !opening.iter().fold(false, overlaps) {
                        continue;
                    }
                    let touches = |(p, v): (&f64, &f64)| (*v < approach) | (*p > 0.0);
                    let points = pressure[range.clone()].iter().zip(opening);
                    let mut bits = 0;
                    for (k, point) in points.clone().enumerate() {
                        bits |= u64::from(touches(point)) << k;
                    }
                    extend(next, first, bits);
                    if was_listed && bits != u64::MAX {
                        for array in [&mut *direction, &mut *previous] {
                            // Without iterations there are no directions.
                            let values = array.get_mut(range.clone()).unwrap_or_default();
                            for (value, point) in values.iter_mut().zip(points.clone()) {
                                *value = if touches(point) { *value } else { 0.0 };
                            }
                        }
                    }
                }
            },
        );
        std::mem::swap(runs, next);
    }

    /// Updates list, free set and residual from the present pressure and v, and computes the certificate.
    pub(crate) fn assess(&mut self, task: &Task) -> Assessment {
        let approach = self.approach(task);
        self.relist(approach);
        let count = listed(&self.runs);
        self.residual.resize(count, 0.0);
        self.free.resize(count, false);
        let Self {
            pressure,
            opening,
            residual,
            free,
            runs,
            ..
        } = self;
        let limit = task.limit;
        let limited = limit.is_finite();
        let mut lanes = Lanes::new([0.0; 5]);
        vectorised(
            #[inline(always)]
            || {
                for (run, place) in parts(runs) {
                    let (p, v) = (&pressure[run.clone()], &opening[run]);
                    let to = residual[place.clone()]
                        .iter_mut()
                        .zip(&mut free[place.clone()]);
                    for ((residual, free), (&p, &v)) in to.zip(p.iter().zip(v)) {
                        let g = v - approach;
                        *free = if p <= 0.0 {
                            g < 0.0
                        } else {
                            (p < limit) | (g > 0.0)
                        };
                        *residual = if *free { g } else { 0.0 };
                    }
                    let arrays = [p, v, &residual[place]];
                    lanes.fold(
                        arrays,
                        |[sum, energy, excess, least, residuals], [p, v, r]| {
                            let g = v - approach;
                            let overlap = if g < 0.0 { -g } else { 0.0 };
                            let room = if limited { limit - p } else { 0.0 };
                            [
                                sum + p,
                                energy + p * if limited { g + overlap } else { g },
                                excess + room * overlap,
                                if (p < limit) & (g < least) { g } else { least },
                                residuals + r,
                            ]
                        },
                    );
                }
            },
        );
        let [sum, energy, excess, least, residual_sum] = lanes.reduce(|a, b| {
            let least = a[3].min(b[3]);
            [a[0] + b[0], a[1] + b[1], a[2] + b[2], least, a[4] + b[4]]
        });
        // As in `certificate::duality_gap`, except that under a limit a controlled approach leaves only the
        // first bound: its load may change.
        let bound = match (limited, task.sum) {
            (true, None) => energy + excess,
            (true, Some(_)) => energy + excess.min(-least * sum),
            (false, _) => energy - least * sum,
        };
        let over = |value: f64, size: f64| if value == 0.0 { 0.0 } else { value / size };
        Assessment {
            approach,
            duality_gap: over(bound, sum * task.reference_gap),
            penetration: over(-least, task.reference_gap),
            free: free.iter().filter(|&&free| free).count(),
            residual_sum,
        }
    }
}

/// First and last column under pressure.
pub(crate) fn loaded_columns(pressure: &[f64], columns: usize) -> Option<[usize; 2]> {
    let loaded = |p: &f64| *p > 0.0;
    let rows = pressure.chunks_exact(columns);
    let ends = rows.filter_map(|row| {
        let first = row.iter().position(loaded)?;
        Some([first, row.iter().rposition(loaded)?])
    });
    ends.reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])])
}
