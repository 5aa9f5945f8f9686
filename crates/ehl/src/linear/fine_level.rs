//! Fine level of the preconditioner: banded factors.
//!
//! Without storage the matrix is the near field of the kernel, band(local + film·K). With storage the balance of a node
//! depends almost only on its own film, so the film is the unknown: z = G·[band(local·G + film)]⁻¹ with
//! the periodic inverse G of the kernel.

use asperity_core::numerics::SymmetricToeplitz;

use super::band_matrix::BandMatrix;
use super::system::Linearised;
use crate::hat_kernel::inverse_column;

/// Half width of the near field without storage.
const NEAR_FIELD: usize = 6;
/// Half width of the inverse kernel with storage: the inverse decays with the square of the distance, the kernel only
/// with its logarithm.
const INVERSE_FIELD: usize = 4;

pub(crate) struct FineLevel {
    band: BandMatrix,
    kernel: Vec<f64>,
    inverse: Option<Inverse>,
    free: Vec<f64>,
    solution: Vec<f64>,
}

struct Inverse {
    column: Vec<f64>,
    product: SymmetricToeplitz,
}

impl FineLevel {
    pub(crate) fn new(kernel: &[f64]) -> Self {
        Self {
            band: BandMatrix::default(),
            kernel: kernel[..kernel.len().min(NEAR_FIELD + 4)].to_vec(),
            inverse: None,
            free: Vec::new(),
            solution: Vec::new(),
        }
    }

    /// Prepares the inverse of the kernel on `cells` cells.
    pub(crate) fn prepare_transient(&mut self, spacing: f64, cells: usize) {
        let column = inverse_column(spacing, 2 * cells, cells);
        self.inverse = Some(Inverse {
            product: SymmetricToeplitz::new(&column, cells + 1),
            column,
        });
        self.free = vec![0.0; cells + 1];
        self.solution = vec![0.0; cells + 1];
    }

    pub(crate) fn set_up(&mut self, system: &Linearised) {
        let nodes = system.weights.len();
        match &self.inverse {
            Some(inverse) if system.transient => {
                let half = INVERSE_FIELD + 2;
                self.band.reset(nodes, half);
                for i in 0..nodes {
                    let row = self.band.row_mut(i);
                    inverse_row(system, &inverse.column, i, half, row);
                }
            }
            _ => {
                self.band.reset(nodes, NEAR_FIELD);
                for i in 0..nodes {
                    near_field_row(system, &self.kernel, i, self.band.row_mut(i));
                }
            }
        }
        self.band.factor();
    }

    /// Replaces the residual on the nodes by the correction of their unknowns.
    pub(crate) fn correct(&mut self, system: &Linearised, residual: &mut [f64]) {
        self.band.solve(residual);
        let Some(inverse) = self.inverse.as_mut().filter(|_| system.transient) else {
            return;
        };
        let last = residual.len() - 1;
        self.free.copy_from_slice(residual);
        self.free[0] = 0.0;
        self.free[last] = 0.0;
        for (value, cavitated) in self.free.iter_mut().zip(system.masked) {
            if *cavitated {
                *value = 0.0;
            }
        }
        let (first_value, last_value) = (residual[0], residual[last]);
        self.solution.copy_from_slice(residual);
        inverse.product.apply(&self.free, residual);
        for ((value, solution), cavitated) in
            residual.iter_mut().zip(&self.solution).zip(system.masked)
        {
            if *cavitated {
                *value = *solution;
            }
        }
        residual[0] = first_value;
        residual[last] = last_value;
    }
}

/// Row of local + film·K within the near field; K acts on the pressure of free nodes.
fn near_field_row(system: &Linearised, kernel: &[f64], i: usize, row: &mut [f64]) {
    let half = NEAR_FIELD;
    let nodes = system.weights.len();
    let (low, high) = (i.saturating_sub(half), (i + half + 1).min(nodes));
    for (j, value) in system.film.row(i).filter(|(_, value)| *value != 0.0) {
        for k in (low..high).filter(|&k| !system.masked[k]) {
            row[k + half - i] += value * kernel[j.abs_diff(k)];
        }
    }
    for (j, value) in system.local.row(i) {
        row[j + half - i] += value;
    }
}

/// Row of local·G + film; only of local in the columns of nodes whose unknown is the void fraction.
fn inverse_row(system: &Linearised, inverse: &[f64], i: usize, half: usize, row: &mut [f64]) {
    let nodes = system.weights.len();
    if i == 0 || i + 1 == nodes {
        row[half] = 1.0;
        return;
    }
    for (j, value) in system.local.row(i) {
        if system.masked[j] {
            row[j + half - i] += value;
        } else if value != 0.0 {
            let low = j.saturating_sub(INVERSE_FIELD);
            for k in low..(j + INVERSE_FIELD + 1).min(nodes) {
                row[k + half - i] += value * inverse[k.abs_diff(j)];
            }
        }
    }
    for (j, value) in system.film.row(i) {
        if !system.masked[j] {
            row[j + half - i] += value;
        }
    }
}
