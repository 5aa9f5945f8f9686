//! The arrays and operators of an iteration on one grid, and what is known of a pressure.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | p, u, h | pressure, displacement, undeformed gap | Pa, m, m |
//! | v, α, g | u + h, approach, gap v − α | m |
//! | F | free set: points between the bounds, and those at one with the gap on its wrong side | - |

use realfft::RealFftPlanner;

use crate::half_plane::{displacement_filter, inverse_filter};
use crate::problem::Boundary;
use crate::transform::EvenFilter;

/// Operators of one grid.
pub(crate) struct Level {
    pub(crate) displacement: EvenFilter,
    pub(crate) inverse: EvenFilter,
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

/// The arrays of an iteration; `pressure` is both start and result.
#[derive(Default)]
pub(crate) struct Workspace {
    pub(crate) pressure: Vec<f64>,
    pub(crate) displacement: Vec<f64>,
    pub(crate) residual: Vec<f64>,
    pub(crate) previous: Vec<f64>,
    pub(crate) direction: Vec<f64>,
    pub(crate) trial: Vec<f64>,
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
    /// Sets the size of all arrays but the pressure, which decides it.
    pub(crate) fn resize(&mut self) {
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
pub(crate) fn displace(level: &mut Level, task: &Task) -> f64 {
    let datum = if task.sum.is_some() || task.datum == 0.0 {
        0.0
    } else {
        task.datum * level.displacement.signal().iter().sum::<f64>()
    };
    level.displacement.apply(task.compliance);
    datum
}
