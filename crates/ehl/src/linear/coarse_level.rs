//! Coarse level of the preconditioner: a Galerkin system on every `ratio`-th node, bordered by the approach of the bodies
//! and the load balance.
//!
//! R·(film·K·D + local)·P with linear interpolation P, its transpose R, and the mask D of nodes without unknown
//! pressure. A column of K·D·P is a shifted copy of one stored column unless the mask cuts its hat; only these are
//! summed again, so that the set-up costs far less than a product with K per coarse node.

use super::small_lu::{SmallLu, dot};
use super::system::Linearised;

/// Storage of a column of K·D·P; D masks the pressure of cavitated nodes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum CoarseColumn {
    /// A shifted copy of the column of one hat.
    Shifted,
    /// Zero: every node of the hat is cavitated.
    Zero,
    /// Its own column, at this index.
    Own(usize),
}

pub(crate) struct CoarseLevel {
    cells: usize,
    ratio: usize,
    kernel: Vec<f64>,
    /// Displacement by a whole coarse hat at the lags −cells..=cells.
    hat: Vec<f64>,
    /// Displacement by the half hats at the two ends.
    ends: [Vec<f64>; 2],
    /// Coarse node before each fine node, and the weight of the one after it.
    places: Vec<(usize, f64)>,
    columns: Vec<CoarseColumn>,
    own: Vec<Vec<f64>>,
    factors: SmallLu,
    right: Vec<f64>,
    film_weights: Vec<f64>,
    local_weights: Vec<f64>,
}

impl CoarseLevel {
    /// Coarse level of `cells` = `ratio`·(coarse cells) with the first column `kernel` of K.
    pub(crate) fn new(kernel: &[f64], cells: usize, ratio: usize) -> Self {
        let weight = |k: isize| 1.0 - k.unsigned_abs() as f64 / ratio as f64;
        let reach = ratio as isize - 1;
        let sum = |center: isize, from: isize, to: isize| -> f64 {
            (from..=to)
                .map(|k| weight(k) * kernel[(center - k).unsigned_abs()])
                .sum()
        };
        let (n, inner) = (cells as isize, (cells - ratio) as isize);
        let hat = (-n..=n)
            .map(|lag| {
                if lag.abs() <= inner {
                    sum(lag, -reach, reach)
                } else {
                    0.0
                }
            })
            .collect();
        let ends = [
            (0..=n).map(|i| sum(i, 0, reach)).collect(),
            (0..=n).map(|i| sum(i - n, -reach, 0)).collect(),
        ];
        let count = cells / ratio + 1;
        let place = |i: usize| {
            let before = (i / ratio).min(count - 2);
            (before, (i - before * ratio) as f64 / ratio as f64)
        };
        Self {
            cells,
            ratio,
            kernel: kernel.to_vec(),
            hat,
            ends,
            places: (0..=cells).map(place).collect(),
            columns: vec![CoarseColumn::Shifted; count],
            own: Vec::new(),
            factors: SmallLu::default(),
            right: vec![0.0; count + 1],
            film_weights: Vec::new(),
            local_weights: Vec::new(),
        }
    }

    fn count(&self) -> usize {
        self.columns.len()
    }

    /// Fine nodes of the hat of coarse node `q`.
    fn support(&self, q: usize) -> std::ops::Range<usize> {
        let center = q * self.ratio;
        let low = (center + 1).saturating_sub(self.ratio);
        low..(center + self.ratio).min(self.cells + 1)
    }

    fn hat_weight(&self, q: usize, i: usize) -> f64 {
        1.0 - (q * self.ratio).abs_diff(i) as f64 / self.ratio as f64
    }

    /// Sets up and factors the Galerkin matrix.
    pub(crate) fn set_up(&mut self, system: &Linearised) {
        self.mask(system.masked);
        let count = self.count();
        self.factors.reset(count + 1);
        for a in 0..count {
            self.galerkin_row(system, a);
        }
        let load = self.factors.row_mut(count);
        let nodes = system.weights.iter().zip(system.masked);
        for ((w, cavitated), &(before, part)) in nodes.zip(&self.places) {
            if !cavitated {
                load[before] += w * (1.0 - part);
                load[before + 1] += w * part;
            }
        }
        self.factors.factor();
    }

    /// Row of one coarse node: R·(film·K·D + local)·P.
    fn galerkin_row(&mut self, system: &Linearised, a: usize) {
        let rows = self.support(a);
        let low = rows.start.saturating_sub(2);
        let high = (rows.end + 1).min(self.cells + 1);
        self.film_weights.clear();
        self.film_weights.resize(high - low, 0.0);
        self.local_weights.clear();
        self.local_weights.resize(high - low, 0.0);
        for i in rows {
            let weight = self.hat_weight(a, i);
            for (j, value) in system.film.row(i) {
                self.film_weights[j - low] += weight * value;
            }
            for (j, value) in system.local.row(i) {
                self.local_weights[j - low] += weight * value;
            }
        }
        let count = self.count();
        let row = self.factors.row_mut(a);
        for (q, element) in row[..count].iter_mut().enumerate() {
            let column = match self.columns[q] {
                CoarseColumn::Zero => continue,
                CoarseColumn::Own(k) => &self.own[k][low..high],
                CoarseColumn::Shifted if q == 0 => &self.ends[0][low..high],
                CoarseColumn::Shifted if q + 1 == count => &self.ends[1][low..high],
                CoarseColumn::Shifted => {
                    let shift = self.cells - q * self.ratio;
                    &self.hat[shift + low..shift + high]
                }
            };
            *element += dot(&self.film_weights, column);
        }
        for (weight, &(before, part)) in self.local_weights.iter().zip(&self.places[low..high]) {
            row[before] += weight * (1.0 - part);
            row[before + 1] += weight * part;
        }
        row[count] = self.film_weights.iter().sum();
    }

    /// Columns of K·D·P for these cavitated nodes.
    fn mask(&mut self, cavitated: &[bool]) {
        let mut used = 0;
        for q in 0..self.count() {
            let support = self.support(q);
            let size = support.len();
            let closed = cavitated[support].iter().filter(|c| **c).count();
            self.columns[q] = if closed == 0 {
                CoarseColumn::Shifted
            } else if closed == size {
                CoarseColumn::Zero
            } else {
                self.own_column(q, used, cavitated, 2 * closed > size);
                used += 1;
                CoarseColumn::Own(used - 1)
            };
        }
    }

    /// Column `q` with its own mask: the free nodes added up, or the cavitated ones taken away.
    fn own_column(&mut self, q: usize, index: usize, cavitated: &[bool], add: bool) {
        if self.own.len() == index {
            self.own.push(vec![0.0; self.cells + 1]);
        }
        let mut column = std::mem::take(&mut self.own[index]);
        if add {
            column.fill(0.0);
        } else {
            let last = self.count() - 1;
            let shift = self.cells - q * self.ratio;
            column.copy_from_slice(match q {
                0 => &self.ends[0],
                _ if q == last => &self.ends[1],
                _ => &self.hat[shift..=shift + self.cells],
            });
        }
        let sign = if add { 1.0 } else { -1.0 };
        for j in self.support(q).filter(|&j| cavitated[j] != add) {
            let weight = sign * self.hat_weight(q, j);
            for (value, kernel) in column[j..].iter_mut().zip(&self.kernel) {
                *value += weight * kernel;
            }
            for (value, kernel) in column[..j].iter_mut().rev().zip(&self.kernel[1..]) {
                *value += weight * kernel;
            }
        }
        self.own[index] = column;
    }

    /// Writes the coarse correction of the residual into `output`.
    pub(crate) fn correct(&mut self, residual: &[f64], output: &mut [f64]) {
        let count = self.count();
        self.right.fill(0.0);
        for (value, &(before, part)) in residual.iter().zip(&self.places) {
            self.right[before] += (1.0 - part) * value;
            self.right[before + 1] += part * value;
        }
        self.right[count] = residual[self.cells + 1];
        self.factors.solve(&mut self.right);
        for (value, &(before, part)) in output.iter_mut().zip(&self.places) {
            *value = (1.0 - part) * self.right[before] + part * self.right[before + 1];
        }
        output[self.cells + 1] = self.right[count];
    }
}
