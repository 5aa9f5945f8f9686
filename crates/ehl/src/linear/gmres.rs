//! Generalised minimal residuals (GMRES) with a preconditioner on the right.
//!
//! The preconditioner is on the right so that the residual of the original equations is minimised. There are no
//! restarts: the cap of iterations bounds the memory. Corrections are stored next to the basis, so that the preconditioner need not
//! be applied again for the solution and may vary between iterations (flexible GMRES, Saad 1993).

use super::small_lu::dot;
use super::system::LinearEffort;

/// Applies preconditioner and matrix: given r, writes z = M⁻¹·r and J·z.
pub(crate) trait Preconditioned {
    fn apply(&mut self, residual: &[f64], correction: &mut [f64], image: &mut [f64]);
}

/// Arrays of the iteration, reused for every solution.
#[derive(Default)]
pub(crate) struct Gmres {
    basis: Vec<Vec<f64>>,
    corrections: Vec<Vec<f64>>,
    /// Columns of the triangular factor.
    triangle: Vec<Vec<f64>>,
    rotations: Vec<(f64, f64)>,
    right: Vec<f64>,
}

impl Gmres {
    /// Solves to a residual of `tolerance` times `right`, or up to `cap` iterations.
    pub(crate) fn solve(
        &mut self,
        operator: &mut impl Preconditioned,
        right: &[f64],
        solution: &mut [f64],
        tolerance: f64,
        cap: usize,
    ) -> LinearEffort {
        solution.fill(0.0);
        let size = dot(right, right).sqrt();
        if size == 0.0 {
            return LinearEffort::default();
        }
        self.clear_other_sizes(right.len());
        self.reserve(0, right.len());
        self.rotations.clear();
        self.right.clear();
        self.right.push(size);
        for (value, r) in self.basis[0].iter_mut().zip(right) {
            *value = r / size;
        }
        let mut iterations = 0;
        while iterations < cap {
            self.reserve(iterations + 1, right.len());
            let left = self.step(operator, iterations);
            iterations += 1;
            if left <= tolerance * size {
                break;
            }
        }
        self.combine(iterations, solution);
        let left = self.right[iterations].abs();
        LinearEffort {
            iterations,
            capped: left.is_nan() || left > tolerance * size,
        }
    }

    fn clear_other_sizes(&mut self, size: usize) {
        for vectors in [&mut self.basis, &mut self.corrections] {
            if vectors.first().is_some_and(|v| v.len() != size) {
                vectors.clear();
            }
        }
    }

    /// Room for the vectors up to number `last`; most solutions need few.
    fn reserve(&mut self, last: usize, size: usize) {
        for vectors in [&mut self.basis, &mut self.corrections] {
            while vectors.len() <= last {
                vectors.push(vec![0.0; size]);
            }
        }
        while self.triangle.len() <= last {
            self.triangle.push(vec![0.0; self.triangle.len() + 2]);
        }
    }

    /// Adds a vector to the basis; returns the remaining residual.
    fn step(&mut self, operator: &mut impl Preconditioned, k: usize) -> f64 {
        let (known, new) = self.basis.split_at_mut(k + 1);
        let image = &mut new[0];
        operator.apply(&known[k], &mut self.corrections[k], image);
        // Modified Gram-Schmidt against the basis; the coefficients are a column of the Hessenberg matrix.
        let column = &mut self.triangle[k];
        for (value, vector) in column.iter_mut().zip(known.iter()) {
            *value = dot(image, vector);
            for (a, b) in image.iter_mut().zip(vector) {
                *a -= *value * b;
            }
        }
        let norm = dot(image, image).sqrt();
        if norm > 0.0 {
            image.iter_mut().for_each(|value| *value /= norm);
        }
        // Earlier Givens rotations, then the one that removes the element below the diagonal.
        for (i, (c, s)) in self.rotations.iter().enumerate() {
            let (a, b) = (column[i], column[i + 1]);
            column[i] = c * a + s * b;
            column[i + 1] = c * b - s * a;
        }
        let length = column[k].hypot(norm);
        let (c, s) = if length > 0.0 {
            (column[k] / length, norm / length)
        } else {
            (1.0, 0.0)
        };
        column[k] = length;
        self.rotations.push((c, s));
        let last = self.right[k];
        self.right[k] = c * last;
        self.right.push(-s * last);
        (s * last).abs()
    }

    /// Back substitution: adds the combination of the corrections with the smallest residual.
    fn combine(&self, count: usize, solution: &mut [f64]) {
        let mut weights = self.right[..count].to_vec();
        for i in (0..count).rev() {
            for j in i + 1..count {
                weights[i] -= self.triangle[j][i] * weights[j];
            }
            let pivot = self.triangle[i][i];
            weights[i] = if pivot == 0.0 {
                0.0
            } else {
                weights[i] / pivot
            };
        }
        for (weight, correction) in weights.iter().zip(&self.corrections) {
            for (value, c) in solution.iter_mut().zip(correction) {
                *value += weight * c;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Diagonal;

    impl Preconditioned for Diagonal {
        fn apply(&mut self, residual: &[f64], correction: &mut [f64], image: &mut [f64]) {
            correction.copy_from_slice(residual);
            for (i, (out, value)) in image.iter_mut().zip(residual).enumerate() {
                *out = value * [1.0, 2.0, 5.0][i % 3];
            }
        }
    }

    #[test]
    fn three_eigenvalues_take_three_iterations() {
        let right: Vec<f64> = (0..20).map(|i| 1.0 + f64::from(i)).collect();
        let mut solution = vec![0.0; 20];
        let effort = Gmres::default().solve(&mut Diagonal, &right, &mut solution, 1e-12, 10);
        assert_eq!(effort.iterations, 3);
        assert!(!effort.capped);
        for (i, value) in solution.iter().enumerate() {
            let expected = right[i] / [1.0, 2.0, 5.0][i % 3];
            assert!((value - expected).abs() < 1e-11);
        }
    }
}
