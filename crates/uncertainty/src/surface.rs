//! A quadratic surface through evaluations of a function of a few standardised constants.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | z | standardised constants, 0 at their medians | - |
//! | y | the function, less its value at the medians | - |
//! | g, H | gradient and second derivatives | - |

use asperity_core::cite;
use asperity_core::numerics::{Cholesky, add_times};
use serde::{Deserialize, Serialize};

/// Square of a pivot of standardised rows below which their columns depend on each other.
const LEAST: f64 = 1e-10;

/// The x with the least Σ_k (y_k − row_k·x)², and 0 for a column of zeros; `None` if the rows do not determine it.
#[must_use]
pub fn least_squares(rows: &[Vec<f64>], values: &[f64]) -> Option<Vec<f64>> {
    let columns = rows.first()?.len();
    let product = |i: usize, j: usize| rows.iter().map(|row| row[i] * row[j]).sum();
    let normal = |i, j| match product(i, j) {
        0.0 if i == j => 1.0,
        product => product,
    };
    let factor = Cholesky::new(columns, normal, LEAST)?;
    let mut found = vec![0.0; columns];
    // The second step removes the round-off of the products.
    for _ in 0..2 {
        let mut step = vec![0.0; columns];
        for (row, value) in rows.iter().zip(values) {
            let terms = row.iter().zip(&found).map(|(z, x)| z * x);
            add_times(&mut step, value - terms.sum::<f64>(), row);
        }
        factor.solve(&mut step);
        add_times(&mut found, 1.0, &step);
    }
    Some(found)
}

/// y(z) = g·z + z·H z/2, which is 0 at the medians.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct QuadraticSurface {
    /// Coefficients of z₁ .. z_n, then of z_i z_j, i ≤ j.
    coefficients: Vec<f64>,
}

impl QuadraticSurface {
    /// Evaluations that determine the surface of `dimensions` constants with 20 to spare.
    pub fn evaluations(dimensions: usize) -> usize {
        match dimensions {
            0 => 0,
            n => (n + 1) * (n + 2) / 2 + 20,
        }
    }

    /// The surface closest to `values` at `points` (least squares); `None` if they do not determine it.
    ///
    /// ```text
    /// Σ_k (y_k − g·z_k − z_k·H z_k/2)² = min                                  [Quadratic-surface]
    /// ```
    pub fn fit(points: &[Vec<f64>], values: &[f64]) -> Option<Self> {
        cite!("Quadratic-surface");
        let rows: Vec<Vec<f64>> = points.iter().map(|point| terms(point)).collect();
        let coefficients = least_squares(&rows, values)?;
        Some(Self { coefficients })
    }

    /// y at `z`.
    pub fn at(&self, z: &[f64]) -> f64 {
        // Every draw comes here: the terms of the fit, without storing them, and without those of constants at their medians.
        let (slopes, mut curvatures) = self.coefficients.split_at(z.len());
        let end = z.iter().rposition(|z| *z != 0.0).map_or(0, |k| k + 1);
        let mut sum = 0.0;
        for (i, (own, slope)) in z[..end].iter().zip(slopes).enumerate() {
            let (row, rest) = curvatures.split_at(z.len() - i);
            if *own != 0.0 {
                let others = row.iter().zip(&z[i..end]);
                let bent: f64 = others.map(|(c, other)| c * other).sum();
                sum += own * (slope + bent);
            }
            curvatures = rest;
        }
        sum
    }
}

fn terms(z: &[f64]) -> Vec<f64> {
    let products = (0..z.len()).flat_map(|i| (i..z.len()).map(move |j| z[i] * z[j]));
    z.iter().copied().chain(products).collect()
}
