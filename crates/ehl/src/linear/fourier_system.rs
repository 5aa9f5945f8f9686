//! Linear systems on an even grid: fast products with the kernel, two-level preconditioned GMRES.
//!
//! The matrix is film·K + local with the dense, symmetric Toeplitz kernel K of the elastic half-planes. It is never
//! formed: K·p costs two FFTs, and GMRES (Saad and Schultz, SIAM J. Sci. Stat. Comput. 7, 1986, 856-869) needs only
//! products. Long waves, which K makes stiff, and the load balance are solved on the coarse level, short waves by banded
//! factors on the fine level; the two corrections are applied one after the other.

use asperity_core::numerics::SymmetricToeplitz;

use super::coarse_level::CoarseLevel;
use super::fine_level::FineLevel;
use super::gmres::{Gmres, Preconditioned};
use super::small_lu::dot;
use super::system::{ElasticSystem, LinearEffort, Linearised};
use crate::hat_kernel::hat_column;

/// Largest number of iterations of a linear solution. A solution at the cap is still used as a Newton step and counted
/// by [`LinearEffort::capped`].
const CAP: usize = 80;
/// Coarse cells on grids of at least `COARSE_CELLS`·`LEAST_RATIO` cells.
const COARSE_CELLS: usize = 64;
/// Fewest coarse cells.
const LEAST_COARSE_CELLS: usize = 32;
/// Fewest fine cells of a coarse cell on larger grids.
const LEAST_RATIO: usize = 8;

/// Coarse cells with storage, where the fine level leaves only the longest waves.
const TRANSIENT_COARSE_CELLS: usize = 32;

pub(crate) struct FourierSystem {
    levels: Levels,
    gmres: Gmres,
}

struct Levels {
    product: SymmetricToeplitz,
    coarse: CoarseLevel,
    fine: FineLevel,
    pressure: Vec<f64>,
    displacement: Vec<f64>,
    defect: Vec<f64>,
    fine_image: Vec<f64>,
    spacing: f64,
    cells: usize,
}

impl FourierSystem {
    /// System on `cells` even cells; a multiple of four.
    pub(crate) fn new(spacing: f64, cells: usize) -> Self {
        let kernel = hat_column(spacing, cells + 1);
        let ratio = (cells / COARSE_CELLS)
            .max(LEAST_RATIO)
            .min(cells / LEAST_COARSE_CELLS);
        Self {
            levels: Levels {
                // The end nodes carry no pressure, so the longest lag never counts.
                product: SymmetricToeplitz::new(&kernel[..cells], cells + 1),
                coarse: CoarseLevel::new(&kernel, cells, ratio),
                fine: FineLevel::new(&kernel),
                pressure: vec![0.0; cells + 1],
                displacement: vec![0.0; cells + 1],
                defect: vec![0.0; cells + 2],
                fine_image: vec![0.0; cells + 2],
                spacing,
                cells,
            },
            gmres: Gmres::default(),
        }
    }

    /// Prepares the preconditioner for balances with storage.
    pub(crate) fn prepare_transient(&mut self) {
        let levels = &mut self.levels;
        let cells = levels.cells;
        levels.fine.prepare_transient(levels.spacing, cells);
        let kernel = hat_column(levels.spacing, cells + 1);
        levels.coarse = CoarseLevel::new(&kernel, cells, cells / TRANSIENT_COARSE_CELLS);
    }
}

impl Levels {
    /// J·x.
    fn multiply(&mut self, system: &Linearised, x: &[f64], output: &mut [f64]) {
        let nodes = self.pressure.len();
        for ((p, value), cavitated) in self.pressure.iter_mut().zip(x).zip(system.masked) {
            *p = if *cavitated { 0.0 } else { *value };
        }
        self.product.apply(&self.pressure, &mut self.displacement);
        let approach = x[nodes];
        for u in &mut self.displacement {
            *u += approach;
        }
        let (balances, load) = output.split_at_mut(nodes);
        balances.fill(0.0);
        system.film.multiply_add(&self.displacement, balances);
        system.local.multiply_add(&x[..nodes], balances);
        load[0] = dot(system.weights, &self.pressure);
    }
}

struct Operator<'a> {
    levels: &'a mut Levels,
    system: &'a Linearised<'a>,
}

impl Preconditioned for Operator<'_> {
    fn apply(&mut self, residual: &[f64], correction: &mut [f64], image: &mut [f64]) {
        let nodes = residual.len() - 1;
        self.levels.coarse.correct(residual, correction);
        self.levels.multiply(self.system, correction, image);
        let mut defect = std::mem::take(&mut self.levels.defect);
        for ((d, r), y) in defect.iter_mut().zip(residual).zip(image.iter()) {
            *d = r - y;
        }
        defect[nodes] = 0.0;
        self.levels.fine.correct(self.system, &mut defect[..nodes]);
        let mut fine_image = std::mem::take(&mut self.levels.fine_image);
        self.levels.multiply(self.system, &defect, &mut fine_image);
        for (sum, value) in correction.iter_mut().zip(&defect) {
            *sum += value;
        }
        for (sum, value) in image.iter_mut().zip(&fine_image) {
            *sum += value;
        }
        self.levels.defect = defect;
        self.levels.fine_image = fine_image;
    }
}

impl ElasticSystem for FourierSystem {
    fn displacement(&mut self, pressure: &[f64], output: &mut [f64]) {
        self.levels.product.apply(pressure, output);
    }

    fn solve(
        &mut self,
        system: &Linearised,
        right: &[f64],
        solution: &mut [f64],
        tolerance: f64,
    ) -> LinearEffort {
        self.levels.coarse.set_up(system);
        self.levels.fine.set_up(system);
        let mut operator = Operator {
            levels: &mut self.levels,
            system,
        };
        self.gmres
            .solve(&mut operator, right, solution, tolerance, CAP)
    }
}
