//! Outliers: rows that no fit explains.

use crate::error;
use asperity_core::Fault;
use nalgebra::DVector;

use crate::least_squares::minimum;
use crate::problem::{Observation, Problem};
use crate::rig::Rig;

/// Standard deviations above which a row is an outlier.
const OUTLIER: f64 = 10.0;
/// Largest share of the rows that the search removes.
const MOST: f64 = 0.2;

impl Rig {
    /// Rejects rows that deviate by more than ten standard deviations from the fit of the others. The worst row is
    /// removed and the fit repeated until none is left, so that an outlier neither hides another nor attracts the fit.
    ///
    /// # Errors
    /// When there are such rows, or a fit does not converge.
    pub(crate) fn check_outliers(&self, problem: &Problem<'_>) -> Result<(), Fault> {
        let mut rows: Vec<usize> = (0..problem.observations.len()).collect();
        let all: Vec<usize> = (0..problem.variables()).collect();
        let mut x = DVector::zeros(problem.variables());
        let most = (MOST * rows.len() as f64).ceil() as usize;
        for _ in 0..=most {
            let measurements: Vec<Observation> =
                rows.iter().map(|k| problem.observations[*k]).collect();
            let part = problem.with(measurements);
            x = minimum(&part, &x, &all)?.x;
            let residuals = part.of_measurements(&x);
            let worst =
                (0..rows.len()).max_by(|a, b| residuals[*a].abs().total_cmp(&residuals[*b].abs()));
            match worst.filter(|k| residuals[*k].abs() > OUTLIER) {
                Some(k) => drop(rows.remove(k)),
                None => break,
            }
        }
        let residuals = problem.of_measurements(&x);
        let rows = self.table.rows.iter().zip(&residuals);
        let outliers: Vec<(usize, f64)> = rows
            .filter(|(_, residual)| residual.abs() > OUTLIER)
            .map(|(row, residual)| (row.line, *residual))
            .collect();
        if outliers.is_empty() {
            Ok(())
        } else {
            Err(error::outliers(
                &self.table.name,
                &outliers,
                self.table.rows.len(),
            ))
        }
    }
}
