//! The arrays and operators of an iteration on one grid, and what is known of a pressure.
//!
//! Everything but the transforms and one pass over v happens on the list of points that touch or
//! overlap: a rough contact covers a small part of its grid.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | p, u, h | pressure, displacement, undeformed gap | Pa, m, m |
//! | v, α, g | u + h, approach, gap v − α | m |
//! | F | free set: points between the bounds, and those at one with the gap on its wrong side | - |

use crate::transform::{Buffers, EvenFilter};

/// Points looked at together for one that overlaps.
const BLOCK: usize = 64;

/// Operators of one grid.
#[derive(Clone, Copy)]
pub(crate) struct Level<'a> {
    pub(crate) displacement: &'a EvenFilter,
    pub(crate) inverse: &'a EvenFilter<f32>,
}

/// What is minimised on one grid.
pub(crate) struct Task<'a> {
    /// h in m, with the displacement by prescribed pressures; less the approach when it is controlled.
    pub(crate) gap: &'a [f64],
    /// Σp in Pa, unless the approach is controlled.
    pub(crate) sum: Option<f64>,
    /// Limit of the pressure in Pa, infinite for none.
    pub(crate) limit: f64,
    /// a/(π·E*) in m/Pa.
    pub(crate) compliance: f64,
    /// Displacement per Σp by the datum in m/Pa; only matters when the approach is controlled.
    pub(crate) datum: f64,
    pub(crate) reference_gap: f64,
    pub(crate) tolerance: f64,
    pub(crate) max_iterations: usize,
}

impl Task<'_> {
    /// What the datum adds to the displacement by pressures of this sum.
    pub(crate) fn datum_displacement(&self, sum: impl FnOnce() -> f64) -> f64 {
        if self.sum.is_some() || self.datum == 0.0 {
            0.0
        } else {
            self.datum * sum()
        }
    }
}

/// The arrays of an iteration; `pressure` is both start and result.
#[derive(Default)]
pub(crate) struct Workspace {
    pub(crate) buffers: Buffers,
    pub(crate) inverse_buffers: Buffers<f32>,
    pub(crate) pressure: Vec<f64>,
    /// v
    pub(crate) opening: Vec<f64>,
    /// Direction and residual of the last iteration; zero at points off the list.
    pub(crate) direction: Vec<f64>,
    pub(crate) previous: Vec<f64>,
    /// Points with pressure or overlap, in order.
    pub(crate) list: Vec<u32>,
    next: Vec<u32>,
    /// Residual, zero off F; preconditioned residual; trial pressure: one value per listed point.
    pub(crate) residual: Vec<f64>,
    pub(crate) ascent: Vec<f64>,
    pub(crate) trial: Vec<f64>,
    /// Whether a listed point is in F.
    pub(crate) free: Vec<bool>,
}

/// What is known of a pressure.
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
    /// Sets the size of all arrays by that of the pressure; the iteration then needs no memory.
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
        self.list.clear();
        self.list.reserve(points);
        self.next.clear();
        self.next.reserve(points);
    }

    /// Gives back the memory that only an iteration needs.
    pub(crate) fn release(&mut self) {
        self.inverse_buffers = Buffers::default();
        for array in [
            &mut self.direction,
            &mut self.previous,
            &mut self.ascent,
            &mut self.trial,
        ] {
            *array = Vec::new();
        }
    }

    /// v = A p + h, with all points listed.
    pub(crate) fn refresh(&mut self, displacement: &EvenFilter, task: &Task) {
        let points = self.pressure.len();
        let (buffers, pressure) = (&mut self.buffers, &self.pressure);
        displacement.filter(buffers, task.compliance, pressure);
        let datum = task.datum_displacement(|| pressure.iter().sum());
        let pairs = buffers.signal(points).iter().zip(task.gap);
        self.opening.clear();
        self.opening.extend(pairs.map(|(u, h)| u + datum + h));
        self.list_all();
    }

    pub(crate) fn list_all(&mut self) {
        self.list.clear();
        self.list.extend(0..self.pressure.len() as u32);
    }

    /// v + s·(A Δ + `datum`) with A Δ the signal of the buffers; p has taken that step already.
    pub(crate) fn open(&mut self, length: f64, datum: f64) {
        let change = self.buffers.signal(self.opening.len());
        for (v, &change) in self.opening.iter_mut().zip(&*change) {
            *v += length * (change + datum);
        }
    }

    /// α: mean of v between the bounds; with no such point the largest v under pressure.
    fn approach(&self, task: &Task) -> f64 {
        if task.sum.is_none() {
            return 0.0;
        }
        let (mut sum, mut count, mut most) = (0.0, 0_usize, f64::NEG_INFINITY);
        for &i in &self.list {
            let (p, v) = (self.pressure[i as usize], self.opening[i as usize]);
            if p > 0.0 {
                most = most.max(v);
                if p < task.limit {
                    sum += v;
                    count += 1;
                }
            }
        }
        if count > 0 { sum / count as f64 } else { most }
    }

    /// Lists anew the points with pressure, all of which are listed, or with overlap.
    fn relist(&mut self, approach: f64) {
        let (pressure, opening) = (&self.pressure, &self.opening);
        let mut listed = self.list.iter().map(|&i| i as usize).peekable();
        self.next.clear();
        for (block, values) in opening.chunks(BLOCK).enumerate() {
            let (first, end) = (block * BLOCK, block * BLOCK + values.len());
            let mut look = values.iter().fold(false, |any, &v| any | (v < approach));
            while let Some(i) = listed.next_if(|&i| i < end) {
                look = true;
                if pressure[i] <= 0.0 && opening[i] >= approach && i < self.direction.len() {
                    self.direction[i] = 0.0;
                    self.previous[i] = 0.0;
                }
            }
            if look {
                let touches = |i: &usize| opening[*i] < approach || pressure[*i] > 0.0;
                let found = (first..end).filter(touches).map(|i| i as u32);
                self.next.extend(found);
            }
        }
        std::mem::swap(&mut self.list, &mut self.next);
    }

    /// List, free set, residual and certificate of the present pressure and v.
    pub(crate) fn assess(&mut self, task: &Task) -> Assessment {
        let approach = self.approach(task);
        self.relist(approach);
        let limited = task.limit.is_finite();
        let (mut sum, mut energy, mut excess) = (0.0, 0.0, 0.0);
        let (mut least, mut residual_sum, mut free) = (0.0_f64, 0.0, 0);
        self.residual.clear();
        self.free.clear();
        for &i in &self.list {
            let (p, g) = (
                self.pressure[i as usize],
                self.opening[i as usize] - approach,
            );
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
            let residual = if is_free { g } else { 0.0 };
            self.free.push(is_free);
            self.residual.push(residual);
            residual_sum += residual;
            free += usize::from(is_free);
        }
        let bound = if limited {
            energy + excess
        } else {
            energy - least * sum
        };
        let over = |value: f64, size: f64| if value == 0.0 { 0.0 } else { value / size };
        Assessment {
            approach,
            duality_gap: over(bound, sum * task.reference_gap),
            penetration: over(-least, task.reference_gap),
            free,
            residual_sum,
        }
    }
}
