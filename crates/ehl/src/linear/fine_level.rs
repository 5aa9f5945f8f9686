//! Fine level of the preconditioner: banded factors.
//!
//! Without storage the matrix is the near field of the kernel, band(local + film·K). With storage the balance of a node
//! depends almost only on its own film, so the displacement u of every node is the unknown, and its pressure is G·u with the
//! periodic inverse G of the kernel: film·u + local·G·u. A node whose pressure stays (cavitated, or at the ceiling) has its void
//! fraction or its depth of flow as a second unknown, and (G·u)ᵢ = 0 as a second equation; without it, such nodes would hold the
//! surface where it is, and the iterations of a thin rough film are three times as many.

use asperity_core::numerics::SymmetricToeplitz;

use super::band_matrix::{BandMatrix, HALF};
use super::system::Linearised;
use crate::hat_kernel::inverse_column;

/// Half width of the near field without storage.
const NEAR_FIELD: usize = 6;
/// Half width of the inverse kernel with storage: the inverse decays with the square of the distance, the kernel only
/// with its logarithm.
const INVERSE_FIELD: usize = 3;

pub(crate) struct FineLevel {
    band: BandMatrix,
    kernel: Vec<f64>,
    inverse: Option<Inverse>,
}

struct Inverse {
    column: Vec<f64>,
    product: SymmetricToeplitz,
    /// Place of the displacement of each node among the unknowns.
    places: Vec<usize>,
    unknowns: Vec<f64>,
    displacement: Vec<f64>,
}

impl FineLevel {
    pub(crate) fn new(kernel: &[f64]) -> Self {
        Self {
            band: BandMatrix::default(),
            kernel: kernel[..kernel.len().min(NEAR_FIELD + 4)].to_vec(),
            inverse: None,
        }
    }

    /// Prepares the inverse of the kernel on `cells` cells.
    pub(crate) fn prepare_transient(&mut self, spacing: f64, cells: usize) {
        let column = inverse_column(spacing, 2 * cells, cells);
        self.inverse = Some(Inverse {
            product: SymmetricToeplitz::new(&column, cells + 1),
            column,
            places: Vec::new(),
            unknowns: Vec::new(),
            displacement: vec![0.0; cells + 1],
        });
    }

    pub(crate) fn set_up(&mut self, system: &Linearised) {
        match &mut self.inverse {
            Some(inverse) if system.transient => inverse.set_up(system, &mut self.band),
            _ => {
                let nodes = system.weights.len();
                self.band.reset(nodes);
                for i in 0..nodes {
                    near_field_row(system, &self.kernel, i, self.band.row_mut(i));
                }
            }
        }
        self.band.factor();
    }

    /// Replaces the residual on the nodes by the correction of their unknowns.
    pub(crate) fn correct(&mut self, system: &Linearised, residual: &mut [f64]) {
        match &mut self.inverse {
            Some(inverse) if system.transient => inverse.correct(system, &self.band, residual),
            _ => self.band.solve(residual),
        }
    }
}

impl Inverse {
    /// The banded matrix. The unknown of a node is its displacement u; a masked node has its own unknown besides, and
    /// the condition that its pressure G·u stays.
    fn set_up(&mut self, system: &Linearised, band: &mut BandMatrix) {
        let nodes = system.weights.len();
        self.places.clear();
        let mut place = 0;
        for (i, masked) in system.masked.iter().enumerate() {
            self.places.push(place);
            place += 1 + usize::from(*masked && is_inner(i, nodes));
        }
        band.reset(place);
        for i in 0..nodes {
            let row = self.balance_place(system, i);
            if !is_inner(i, nodes) {
                band.add(row, row, 1.0);
                continue;
            }
            if system.masked[i] {
                self.add_pressure(band, self.places[i], i, 1.0);
            }
            for (j, value) in system.film.row(i).filter(|(j, _)| is_inner(*j, nodes)) {
                band.add(row, self.places[j], value);
            }
            for (j, value) in system.local.row(i).filter(|(_, value)| *value != 0.0) {
                if system.masked[j] || !is_inner(j, nodes) {
                    band.add(row, self.balance_place(system, j), value);
                } else {
                    self.add_pressure(band, row, j, value);
                }
            }
        }
    }

    /// Place of the balance of node `i`, and of its unknown where its pressure is masked.
    fn balance_place(&self, system: &Linearised, i: usize) -> usize {
        self.places[i] + usize::from(system.masked[i] && is_inner(i, self.places.len()))
    }

    /// Adds `factor` times the pressure of node `j`, a sum over displacements, to a row.
    fn add_pressure(&self, band: &mut BandMatrix, row: usize, j: usize, factor: f64) {
        let last = self.places.len() - 1;
        for k in j.saturating_sub(INVERSE_FIELD).max(1)..(j + INVERSE_FIELD + 1).min(last) {
            band.add(row, self.places[k], factor * self.column[k.abs_diff(j)]);
        }
    }

    fn correct(&mut self, system: &Linearised, band: &BandMatrix, residual: &mut [f64]) {
        let last = residual.len() - 1;
        self.unknowns.clear();
        let nodes = residual.iter().zip(system.masked).enumerate();
        for (i, (value, masked)) in nodes {
            if *masked && is_inner(i, last + 1) {
                self.unknowns.push(0.0);
            }
            self.unknowns.push(*value);
        }
        band.solve(&mut self.unknowns);
        for (u, place) in self.displacement.iter_mut().zip(&self.places) {
            *u = self.unknowns[*place];
        }
        let ends = [self.displacement[0], self.displacement[last]];
        (self.displacement[0], self.displacement[last]) = (0.0, 0.0);
        self.product.apply(&self.displacement, residual);
        for ((value, place), masked) in residual.iter_mut().zip(&self.places).zip(system.masked) {
            if *masked {
                *value = self.unknowns[(place + 1).min(self.unknowns.len() - 1)];
            }
        }
        (residual[0], residual[last]) = (ends[0], ends[1]);
    }
}

fn is_inner(i: usize, nodes: usize) -> bool {
    i > 0 && i + 1 < nodes
}

/// Row of local + film·K within the near field; K acts on the pressure of free nodes.
fn near_field_row(system: &Linearised, kernel: &[f64], i: usize, row: &mut [f64]) {
    let nodes = system.weights.len();
    let (low, high) = (
        i.saturating_sub(NEAR_FIELD),
        (i + NEAR_FIELD + 1).min(nodes),
    );
    for (j, value) in system.film.row(i).filter(|(_, value)| *value != 0.0) {
        for k in (low..high).filter(|&k| !system.masked[k]) {
            row[k + HALF - i] += value * kernel[j.abs_diff(k)];
        }
    }
    for (j, value) in system.local.row(i) {
        row[j + HALF - i] += value;
    }
}
