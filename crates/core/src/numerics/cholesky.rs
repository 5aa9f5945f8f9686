//! Cholesky factor of a symmetric matrix.

use super::dot;

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
    lower: Vec<Vec<f64>>,
}

impl Cholesky {
    /// The factor of the matrix of `n` rows whose lower triangle is `element(row, column)`; `None` if an element is not
    /// finite or the square of a pivot is not above 0 and at least `least`.
    pub fn new(n: usize, element: impl Fn(usize, usize) -> f64, least: f64) -> Option<Self> {
        let row = |i| (0..=i).map(|j| element(i, j)).collect();
        Self::of_rows((0..n).map(row).collect(), least)
    }

    /// The factor of the matrix with these rows of its lower triangle, as [`new`](Self::new) makes it.
    fn of_rows(mut lower: Vec<Vec<f64>>, least: f64) -> Option<Self> {
        for i in 0..lower.len() {
            let (done, rest) = lower.split_at_mut(i);
            let row = &mut rest[0];
            for (j, above) in done.iter().enumerate() {
                row[j] = (row[j] - dot(&row[..j], &above[..j])) / above[j];
            }
            let square = row[i] - dot(&row[..i], &row[..i]);
            if !(square.is_finite() && square > 0.0 && square >= least) {
                return None;
            }
            row[i] = square.sqrt();
        }
        Some(Self { lower })
    }

    /// The rows of L, each up to the diagonal.
    #[must_use]
    pub fn lower(&self) -> &[Vec<f64>] {
        &self.lower
    }

    /// Replaces the right-hand side b by the solution of A x = b.
    pub fn solve(&self, right: &mut [f64]) {
        for (i, row) in self.lower.iter().enumerate() {
            right[i] = (right[i] - dot(&row[..i], &right[..i])) / row[i];
        }
        for (i, row) in self.lower.iter().enumerate().rev() {
            let value = right[i] / row[i];
            right[i] = value;
            for (left, l) in right[..i].iter_mut().zip(row) {
                *left -= l * value;
            }
        }
    }
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
