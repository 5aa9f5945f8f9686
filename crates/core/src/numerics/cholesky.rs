//! Cholesky factor of a symmetric matrix.

use super::{dot, vectorised};

/// Lower triangle L of a symmetric positive definite matrix A = L Lᵀ.
///
/// ```
/// use asperity_core::numerics::Cholesky;
/// let matrix = [[4.0, 2.0], [2.0, 5.0]];
/// let factor = Cholesky::new(2, |i, j| matrix[i][j], 0.0).ok_or("not positive definite")?;
/// let mut right = [8.0, 12.0];
/// factor.solve(&mut right);
/// assert_eq!(right, [1.0, 2.0]);
/// # Ok::<(), &str>(())
/// ```
#[derive(Debug, Clone, Default)]
pub struct Cholesky {
    /// Rows of L, each up to the diagonal.
    lower: Vec<f64>,
    rows: usize,
}

/// Place of the first element of a row.
#[inline(always)]
fn first(row: usize) -> usize {
    row * (row + 1) / 2
}

impl Cholesky {
    /// The factor of the matrix of `n` rows whose lower triangle is `element(row, column)`; `None` if an element is not
    /// finite or the square of a pivot is not above 0 and at least `least`.
    pub fn new(n: usize, element: impl Fn(usize, usize) -> f64, least: f64) -> Option<Self> {
        let mut lower = Vec::with_capacity(first(n));
        for i in 0..n {
            lower.extend((0..=i).map(|j| element(i, j)));
        }
        let is_definite = vectorised(
            #[inline(always)]
            || factored(&mut lower, n, least),
        );
        is_definite.then_some(Self { lower, rows: n })
    }

    /// The rows of L, each up to the diagonal.
    pub fn lower(&self) -> impl Iterator<Item = &[f64]> {
        (0..self.rows).map(|i| &self.lower[first(i)..first(i + 1)])
    }

    /// Replaces the right-hand side b by the solution of A x = b.
    pub fn solve(&self, right: &mut [f64]) {
        vectorised(
            #[inline(always)]
            || {
                for i in 0..self.rows {
                    let row = &self.lower[first(i)..first(i + 1)];
                    right[i] = (right[i] - dot(&row[..i], &right[..i])) / row[i];
                }
                for i in (0..self.rows).rev() {
                    let row = &self.lower[first(i)..first(i + 1)];
                    let value = right[i] / row[i];
                    right[i] = value;
                    for (left, l) in right[..i].iter_mut().zip(row) {
                        *left -= l * value;
                    }
                }
            },
        );
    }
}

/// Replaces the lower triangle of a matrix of `n` rows by L, column after column: the products of a column do not wait for each
/// other. False if it is not positive definite.
#[inline(always)]
fn factored(lower: &mut [f64], n: usize, least: f64) -> bool {
    for j in 0..n {
        let (above, below) = lower.split_at_mut(first(j + 1));
        let pivot = &mut above[first(j)..];
        let (pivot, diagonal) = pivot.split_at_mut(j);
        let square = diagonal[0] - dot(pivot, pivot);
        if !(square.is_finite() && square > 0.0 && square >= least) {
            return false;
        }
        diagonal[0] = square.sqrt();
        let mut rest = below;
        for i in j + 1..n {
            let row;
            (row, rest) = rest.split_at_mut(i + 1);
            row[j] = (row[j] - dot(&row[..j], pivot)) / diagonal[0];
        }
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_solution_solves_its_system_and_an_indefinite_matrix_has_no_factor() {
        // 1/(1 + |i − j|) + the identity is positive definite.
        let element =
            |i: usize, j: usize| 1.0 / (1.0 + i.abs_diff(j) as f64) + f64::from(u8::from(i == j));
        let n = 37;
        let factor = Cholesky::new(n, element, 0.0).unwrap();
        let right: Vec<f64> = (0..n).map(|i| (i as f64).sin()).collect();
        let mut found = right.clone();
        factor.solve(&mut found);
        for (i, value) in right.iter().enumerate() {
            let seen: f64 = (0..n).map(|j| element(i, j) * found[j]).sum();
            assert!((seen - value).abs() < 1e-14, "{i}: {seen} {value}");
        }
        let contrary = |i: usize, j: usize| if i == j { 1.0 } else { 2.0 };
        assert!(Cholesky::new(2, contrary, 0.0).is_none());
        assert!(Cholesky::new(1, |_, _| f64::NAN, 0.0).is_none());
        assert!(Cholesky::new(1, |_, _| 1e-7, 1e-6).is_none());
    }
}
