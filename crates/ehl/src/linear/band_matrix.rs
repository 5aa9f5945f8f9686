//! Banded LU factors without pivoting.

/// Diagonals on each side of the main one. The few elements beyond, where nodes have two unknowns, are left out.
pub(crate) const HALF: usize = 8;
/// Smallest pivot; a zero pivot of a preconditioner must not stop the iteration.
const LEAST_PIVOT: f64 = 1e-300;

/// Band matrix, row by row, and its factors, column by column.
#[derive(Debug, Clone, Default)]
pub(crate) struct BandMatrix {
    /// Row i begins with the element of column i − [`HALF`].
    rows: Vec<[f64; 2 * HALF + 1]>,
    /// Elements of the lower factor below the diagonal, downwards.
    lower: Vec<[f64; HALF]>,
    /// Elements of the upper factor above the diagonal, upwards.
    upper: Vec<[f64; HALF]>,
    /// Reciprocals of the pivots.
    reciprocals: Vec<f64>,
}

impl BandMatrix {
    /// Makes this a zero matrix of `rows` rows.
    pub(crate) fn reset(&mut self, rows: usize) {
        self.rows.clear();
        self.rows.resize(rows, [0.0; 2 * HALF + 1]);
    }

    /// Row `i`, whose first element is in column i − [`HALF`].
    pub(crate) fn row_mut(&mut self, i: usize) -> &mut [f64] {
        &mut self.rows[i]
    }

    /// Adds `value` at row `i` and column `j`, if that is within the band.
    pub(crate) fn add(&mut self, i: usize, j: usize, value: f64) {
        if let Some(element) = self.rows[i].get_mut((j + HALF).wrapping_sub(i)) {
            *element += value;
        }
    }

    /// Factors the matrix.
    pub(crate) fn factor(&mut self) {
        let n = self.rows.len();
        for factor in [&mut self.lower, &mut self.upper] {
            factor.clear();
            factor.resize(n, [0.0; HALF]);
        }
        self.reciprocals.clear();
        for i in 0..n {
            let (done, below) = self.rows.split_at_mut(i + 1);
            let pivot_row = &done[i];
            let pivot = match pivot_row[HALF] {
                small if small.abs() < LEAST_PIVOT => LEAST_PIVOT,
                pivot => pivot,
            };
            let reciprocal = 1.0 / pivot;
            self.reciprocals.push(reciprocal);
            let right = &pivot_row[HALF + 1..];
            for (k, row) in below.iter_mut().take(HALF).enumerate() {
                let first = HALF - 1 - k;
                let factor = row[first] * reciprocal;
                self.lower[i][k] = factor;
                for (value, pivot) in row[first + 1..].iter_mut().zip(right) {
                    *value -= factor * pivot;
                }
            }
            for (k, value) in right.iter().take(n - 1 - i).enumerate() {
                self.upper[i + 1 + k][k] = *value;
            }
        }
    }

    /// Solves in place with the factors.
    pub(crate) fn solve(&self, right: &mut [f64]) {
        // What the values found so far take from the next ones.
        let mut taken = [0.0; HALF];
        for (value, column) in right.iter_mut().zip(&self.lower) {
            *value -= taken[0];
            taken = passed_on(&taken, column, *value);
        }
        let mut taken = [0.0; HALF];
        let columns = self.upper.iter().zip(&self.reciprocals).rev();
        for (value, (column, reciprocal)) in right.iter_mut().rev().zip(columns) {
            *value = (*value - taken[0]) * reciprocal;
            taken = passed_on(&taken, column, *value);
        }
    }
}

/// `taken` from the second element on, and `column` times `value`.
fn passed_on(taken: &[f64; HALF], column: &[f64; HALF], value: f64) -> [f64; HALF] {
    std::array::from_fn(|k| taken.get(k + 1).copied().unwrap_or(0.0) + column[k] * value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_factors_solve_a_band_system() {
        let (n, half) = (24, HALF);
        let mut matrix = BandMatrix::default();
        matrix.reset(n);
        let value = |i: usize, j: usize| match i.abs_diff(j) {
            0 => 9.0 + i as f64,
            d => 1.0 / (d as f64 + i as f64 + 2.0 * j as f64),
        };
        for i in 0..n {
            for j in i.saturating_sub(half)..(i + half + 1).min(n) {
                matrix.row_mut(i)[j + half - i] = value(i, j);
            }
        }
        let solution: Vec<f64> = (0..n).map(|i| (i as f64 * 0.7).cos()).collect();
        let mut right: Vec<f64> = (0..n)
            .map(|i| {
                (i.saturating_sub(half)..(i + half + 1).min(n))
                    .map(|j| value(i, j) * solution[j])
                    .sum()
            })
            .collect();
        matrix.factor();
        matrix.solve(&mut right);
        for (value, expected) in right.iter().zip(&solution) {
            assert!((value - expected).abs() < 1e-14);
        }
    }
}
