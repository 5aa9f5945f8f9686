//! Dense linear systems on any grid: O(n³), for tables on graded grids and as oracle of the fast ones.

use faer::linalg::solvers::Solve;
use faer::{Col, Mat};

use super::small_lu::dot;
use super::system::{ElasticSystem, LinearEffort, Linearised};
use crate::grid::FilmGrid;
use crate::hat_kernel::hat_matrix;

pub(crate) struct DenseSystem {
    nodes: usize,
    kernel: Vec<f64>,
}

impl DenseSystem {
    pub(crate) fn new(grid: &FilmGrid) -> Self {
        Self {
            nodes: grid.nodes(),
            kernel: hat_matrix(grid),
        }
    }

    /// Matrix with the rows scaled to a largest element of one, and the scales.
    fn scaled_matrix(&self, system: &Linearised) -> (Mat<f64>, Vec<f64>) {
        let n = self.nodes;
        let mut matrix = Mat::zeros(n + 1, n + 1);
        let mut scales = Vec::with_capacity(n + 1);
        let mut row = vec![0.0; n + 1];
        for i in 0..=n {
            row.fill(0.0);
            if i < n {
                self.balance_row(system, i, &mut row);
            } else {
                row[..n].copy_from_slice(system.weights);
                mask(&mut row, system.masked);
            }
            let scale = 1.0 / row.iter().fold(f64::MIN_POSITIVE, |m, v| v.abs().max(m));
            for (j, value) in row.iter().enumerate() {
                matrix[(i, j)] = scale * value;
            }
            scales.push(scale);
        }
        (matrix, scales)
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
        let (matrix, scales) = self.scaled_matrix(system);
        let mut x = Col::from_fn(self.nodes + 1, |i| scales[i] * right[i]);
        matrix.partial_piv_lu().solve_in_place(&mut x);
        for (i, value) in solution.iter_mut().enumerate() {
            *value = x[i];
        }
        LinearEffort {
            iterations: 1,
            capped: false,
        }
    }
}
