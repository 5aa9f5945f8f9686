//! Rows that no fit explains.

use nalgebra::DVector;

use crate::error::CalibrationError;
use crate::least_squares::minimum;
use crate::problem::{Observation, Problem};
use crate::rig::Rig;

/// Standard deviations beyond which a row is an outlier.
const OUTLIER: f64 = 10.0;
/// Part of the rows that are taken out at most while looking.
const MOST: f64 = 0.2;

impl Rig {
    /// Refuses rows off the fit of all others by more than ten standard deviations. The worst is taken out and the
    /// fit made again until none is left, so that one row does not hide behind another or drag the fit to it.
    ///
    /// # Errors
    /// When there are such rows, or a fit does not converge.
    pub fn check_outliers(&self, problem: &Problem<'_>) -> Result<(), CalibrationError> {
        let mut kept: Vec<usize> = (0..problem.observations.len()).collect();
        let all: Vec<usize> = (0..problem.variables()).collect();
        let mut x = DVector::zeros(problem.variables());
        let most = (MOST * kept.len() as f64).ceil() as usize;
        for _ in 0..=most {
            let taken: Vec<Observation> = kept.iter().map(|k| problem.observations[*k]).collect();
            let mut part = problem.with(taken);
            part.assemblies = problem.assemblies;
            x = minimum(&part, &x, &all)?.x;
            let residuals = part.of_measurements(&x);
            let worst =
                (0..kept.len()).max_by(|a, b| residuals[*a].abs().total_cmp(&residuals[*b].abs()));
            match worst.filter(|k| residuals[*k].abs() > OUTLIER) {
                Some(k) => drop(kept.remove(k)),
                None => break,
            }
        }
        let residuals = problem.of_measurements(&x);
        let rows = self.table.rows.iter().zip(&residuals);
        let outliers: Vec<(usize, f64)> = rows
            .filter(|(_, residual)| residual.abs() > OUTLIER)
            .map(|(row, residual)| (row.line, *residual))
            .collect();
        match outliers.is_empty() {
            true => Ok(()),
            false => Err(CalibrationError::Outliers {
                file: self.table.name.clone(),
                outliers,
                rows: self.table.rows.len(),
            }),
        }
    }
}
