//! Banded LU factors without pivoting.

/// Smallest pivot; a zero pivot of a preconditioner must not stop the iteration.
const LEAST_PIVOT: f64 = 1e-300;

/// Band matrix of equal half widths, row by row, factored in place.
#[derive(Debug, Clone, Default)]
pub(crate) struct BandMatrix {
    half: usize,
    values: Vec<f64>,
}

impl BandMatrix {
    /// Makes this a zero matrix of `rows` rows and half width `half`.
    pub(crate) fn reset(&mut self, rows: usize, half: usize) {
        self.half = half;
        self.values.clear();
        self.values.resize(rows * (2 * half + 1), 0.0);
    }

    /// Row `i`, whose first element is in column i − half width.
    pub(crate) fn row_mut(&mut self, i: usize) -> &mut [f64] {
        let width = 2 * self.half + 1;
        &mut self.values[i * width..(i + 1) * width]
    }

    /// Replaces the matrix by its LU factors; the diagonal holds the reciprocals of the pivots.
    pub(crate) fn factor(&mut self) {
        let (half, width) = (self.half, 2 * self.half + 1);
        let rows = self.values.len() / width;
        for i in 0..rows {
            let (done, below) = self.values.split_at_mut((i + 1) * width);
            let pivot_row = &mut done[i * width..];
            if pivot_row[half].abs() < LEAST_PIVOT {
                pivot_row[half] = LEAST_PIVOT;
            }
            pivot_row[half] = 1.0 / pivot_row[half];
            for (k, row) in below.chunks_exact_mut(width).take(half).enumerate() {
                let first = half - 1 - k;
                let factor = row[first] * pivot_row[half];
                row[first] = factor;
                if factor != 0.0 {
                    for (value, pivot) in row[first + 1..first + 1 + half]
                        .iter_mut()
                        .zip(&pivot_row[half + 1..])
                    {
                        *value -= factor * pivot;
                    }
                }
            }
        }
    }

    /// Solves in place with the factors.
    pub(crate) fn solve(&self, right: &mut [f64]) {
        let (half, width) = (self.half, 2 * self.half + 1);
        let n = right.len();
        for i in 0..n {
            let row = &self.values[i * width..(i + 1) * width];
            let low = i.saturating_sub(half);
            let sum: f64 = row[low + half - i..half]
                .iter()
                .zip(&right[low..i])
                .map(|(a, b)| a * b)
                .sum();
            right[i] -= sum;
        }
        for i in (0..n).rev() {
            let row = &self.values[i * width..(i + 1) * width];
            let high = (i + half + 1).min(n);
            let sum: f64 = row[half + 1..half + high - i]
                .iter()
                .zip(&right[i + 1..high])
                .map(|(a, b)| a * b)
                .sum();
            right[i] = (right[i] - sum) * row[half];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_factors_solve_a_band_system() {
        let (n, half) = (12, 3);
        let mut matrix = BandMatrix::default();
        matrix.reset(n, half);
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
