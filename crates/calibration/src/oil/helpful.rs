//! Further settings that would determine a constant best.

use asperity_core::Fault;
use nalgebra::DVector;

use super::base::OilBase;
use super::fit::{PointErrors, planned};
use super::grid::OilGrid;
use super::machine::Setting;
use super::problem::{Priors, STATED, Zero};
use super::reading::SetPoint;
use crate::information::{covariance, information, variances_after};
use crate::least_squares::Residuals;

/// Settings to choose from.
pub(super) const GRID: OilGrid<'static> = OilGrid {
    loads: &[10.0, 30.0, 70.0],
    speeds: &[0.5, 1.0, 3.0],
    slides: &[0.01, 0.05, 0.2, 1.0],
    temperatures: &[40.0, 80.0, 120.0],
};
/// Readings at a setting.
const READINGS: f64 = 10.0;

/// A setting with the error that ten readings there would leave of a constant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Helpful {
    /// The setting.
    pub setting: Setting,
    /// Posterior over prior standard deviation.
    pub posterior: f64,
}

/// The candidates that the law of the film describes, on the machine of `points`.
fn candidates(oil: &OilBase, points: &[SetPoint]) -> Result<Vec<SetPoint>, Fault> {
    let Some(first) = points.first() else {
        return Ok(Vec::new());
    };
    let mut further = GRID.described(oil, &first.reading.machine)?;
    for point in &mut further {
        // Curves of their own, of the calibration of the first.
        point.curve = usize::MAX - point.curve;
        point.reading.group.clone_from(&first.reading.group);
        point.has_both_signs = first.has_both_signs;
    }
    Ok(further)
}

/// The most helpful further setting for each stated constant, with the constants of the family; `None` if there is none.
///
/// # Errors
/// When the friction has no solution at a point.
pub fn helpful(
    oil: &OilBase,
    priors: Priors,
    zero: Zero,
    errors: PointErrors,
    points: &[SetPoint],
) -> Result<[Option<Helpful>; STATED], Fault> {
    let further = candidates(oil, points)?;
    let all = [points, &further].concat();
    let problem = planned(oil, priors, zero, errors, &all)?;
    let slopes = problem.at(&DVector::zeros(problem.variables())).1;
    let columns = slopes.ncols();
    let of = |from: usize, rows: usize| slopes.rows(from, rows).into_owned();
    let measured = information(&of(0, points.len()));
    let of_priors = information(&of(all.len(), columns));
    let mut best = [None::<Helpful>; STATED];
    let Some(before) = covariance(&(measured + of_priors)) else {
        return Ok(best);
    };
    for (number, point) in further.iter().enumerate() {
        let row = slopes.row(points.len() + number);
        let after = variances_after(&before, &(row.transpose() * READINGS.sqrt()));
        for (k, best) in best.iter_mut().enumerate() {
            let posterior = after[k].sqrt();
            if best.is_none_or(|best| posterior < best.posterior) {
                *best = Some(Helpful {
                    setting: point.reading.setting,
                    posterior,
                });
            }
        }
    }
    Ok(best)
}
