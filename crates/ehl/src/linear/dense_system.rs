//! Dense linear systems on any grid: O(n³), for tables on graded grids and as oracle of the fast ones.

use super::small_lu::{SmallLu, dot};
use super::system::{ElasticSystem, LinearEffort, Linearised};
use crate::grid::Grid;
use crate::hat_kernel::hat_matrix;

pub(crate) struct DenseSystem {
    nodes: usize,
    kernel: Vec<f64>,
}

impl DenseSystem {
    pub(crate) fn new(grid: &Grid) -> Self {
        Self {
            nodes: grid.nodes(),
            kernel: hat_matrix(grid),
        }
    }

    fn matrix(&self, system: &Linearised) -> SmallLu {
        let n = self.nodes;
        let mut matrix = SmallLu::default();
        matrix.reset(n + 1);
        for i in 0..n {
            self.balance_row(system, i, matrix.row_mut(i));
        }
        let load = matrix.row_mut(n);
        load[..n].copy_from_slice(system.weights);
        mask(load, system.masked);
        matrix
    }

    fn balance_row(&self, system: &Linearised, i: usize, row: &mut [f64]) {
        let n = self.nodes;
        for (j, value) in system.film.row(i).filter(|(_, value)| *value != 0.0) {
            let kernel = &self.kernel[j * n..(j + 1) * n];
            for (element, k) in row.iter_mut().zip(kernel) {
                *element += value * k;
            }
            row[n] += value;
        }
        mask(row, system.masked);
        for (j, value) in system.local.row(i) {
            row[j] += value;
        }
    }
}

/// Sets the elements of cavitated nodes, whose pressure is not unknown, to zero.
fn mask(row: &mut [f64], cavitated: &[bool]) {
    for (value, cavitated) in row.iter_mut().zip(cavitated) {
        if *cavitated {
            *value = 0.0;
        }
    }
}

impl ElasticSystem for DenseSystem {
    fn displacement(&mut self, pressure: &[f64], output: &mut [f64]) {
        for (out, row) in output.iter_mut().zip(self.kernel.chunks_exact(self.nodes)) {
            *out = dot(row, pressure);
        }
    }

    fn solve(
        &mut self,
        system: &Linearised,
        right: &[f64],
        solution: &mut [f64],
        _tolerance: f64,
    ) -> LinearEffort {
        let mut matrix = self.matrix(system);
        matrix.factor();
        let mut x = right.to_vec();
        matrix.solve(&mut x);
        solution.copy_from_slice(&x[..solution.len()]);
        LinearEffort {
            iterations: 1,
            capped: false,
        }
    }
}
