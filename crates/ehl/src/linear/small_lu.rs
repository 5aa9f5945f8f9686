//! Dense LU factors of a small matrix with partial pivoting and scaled rows.

/// Smallest pivot; a singular coarse level must not stop the iteration.
const LEAST_PIVOT: f64 = 1e-300;

/// Square matrix by rows, factored in place.
#[derive(Debug, Clone, Default)]
pub(crate) struct SmallLu {
    size: usize,
    values: Vec<f64>,
    scales: Vec<f64>,
    pivots: Vec<usize>,
}

impl SmallLu {
    /// Makes this a zero matrix of `size` rows.
    pub(crate) fn reset(&mut self, size: usize) {
        self.size = size;
        self.values.clear();
        self.values.resize(size * size, 0.0);
    }

    /// Row `i`.
    pub(crate) fn row_mut(&mut self, i: usize) -> &mut [f64] {
        &mut self.values[i * self.size..(i + 1) * self.size]
    }

    /// Replaces the matrix by its factors; the diagonal holds the reciprocals of the pivots.
    pub(crate) fn factor(&mut self) {
        let n = self.size;
        self.scale_rows();
        self.pivots.clear();
        for k in 0..n {
            let pivot = self.largest_below(k);
            self.pivots.push(pivot);
            if pivot != k {
                for j in 0..n {
                    self.values.swap(k * n + j, pivot * n + j);
                }
            }
            let (done, below) = self.values.split_at_mut((k + 1) * n);
            let pivot_row = &mut done[k * n..];
            if pivot_row[k].abs() < LEAST_PIVOT {
                pivot_row[k] = LEAST_PIVOT;
            }
            pivot_row[k] = 1.0 / pivot_row[k];
            for row in below.chunks_exact_mut(n) {
                let factor = row[k] * pivot_row[k];
                row[k] = factor;
                if factor != 0.0 {
                    for (value, pivot) in row[k + 1..].iter_mut().zip(&pivot_row[k + 1..]) {
                        *value -= factor * pivot;
                    }
                }
            }
        }
    }

    fn scale_rows(&mut self) {
        self.scales.clear();
        for row in self.values.chunks_exact_mut(self.size) {
            let largest = row.iter().fold(LEAST_PIVOT, |m, v| v.abs().max(m));
            let scale = 1.0 / largest;
            row.iter_mut().for_each(|value| *value *= scale);
            self.scales.push(scale);
        }
    }

    fn largest_below(&self, k: usize) -> usize {
        let n = self.size;
        (k + 1..n).fold(k, |best, i| {
            let larger = self.values[i * n + k].abs() > self.values[best * n + k].abs();
            if larger { i } else { best }
        })
    }

    /// Solves in place with the factors.
    pub(crate) fn solve(&self, right: &mut [f64]) {
        let n = self.size;
        for (value, scale) in right.iter_mut().zip(&self.scales) {
            *value *= scale;
        }
        for (k, &pivot) in self.pivots.iter().enumerate() {
            right.swap(k, pivot);
        }
        for i in 0..n {
            let row = &self.values[i * n..i * n + i];
            right[i] -= dot(row, &right[..i]);
        }
        for i in (0..n).rev() {
            let row = &self.values[i * n + i + 1..(i + 1) * n];
            right[i] = (right[i] - dot(row, &right[i + 1..n])) * self.values[i * n + i];
        }
    }
}

/// Σ a·b in eight partial sums, which vectorise.
pub(crate) fn dot(a: &[f64], b: &[f64]) -> f64 {
    const LANES: usize = 8;
    let mut sums = [0.0; LANES];
    let (a_blocks, b_blocks) = (a.chunks_exact(LANES), b.chunks_exact(LANES));
    let rest: f64 = a_blocks
        .remainder()
        .iter()
        .zip(b_blocks.remainder())
        .map(|(x, y)| x * y)
        .sum();
    for (x, y) in a_blocks.zip(b_blocks) {
        for (sum, (x, y)) in sums.iter_mut().zip(x.iter().zip(y)) {
            *sum += x * y;
        }
    }
    sums.iter().sum::<f64>() + rest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_factors_solve_a_system_that_needs_pivots() {
        let n = 9;
        let value = |i: usize, j: usize| {
            let base = ((i * 7 + j * 3) % 11) as f64 - 4.0;
            if i == j {
                0.0
            } else {
                base * 10f64.powi(i as i32 - 4)
            }
        };
        let mut matrix = SmallLu::default();
        matrix.reset(n);
        for i in 0..n {
            for j in 0..n {
                matrix.row_mut(i)[j] = value(i, j);
            }
        }
        let solution: Vec<f64> = (0..n).map(|i| 1.0 + i as f64).collect();
        let mut right: Vec<f64> = (0..n)
            .map(|i| (0..n).map(|j| value(i, j) * solution[j]).sum())
            .collect();
        matrix.factor();
        matrix.solve(&mut right);
        for (value, expected) in right.iter().zip(&solution) {
            assert!((value - expected).abs() < 1e-11, "{value} {expected}");
        }
    }
}
