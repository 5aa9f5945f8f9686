//! Further settings that would determine a constant best.

use asperity_core::quantity::{Force, Speed, Temperature};
use nalgebra::{DMatrix, DVector};

use super::base::OilBase;
use super::error::OilError;
use super::fit::{PointErrors, set_errors};
use super::machine::Setting;
use super::problem::{Priors, STATED, TractionProblem, Zero};
use super::reading::SetPoint;
use super::selection::judge;
use crate::information::{covariance, information};
use crate::least_squares::Residuals;

/// Settings to choose from: loads \[N\], mean speeds \[m/s\], slide-to-roll ratios, temperatures \[°C\].
const LOADS: [f64; 3] = [10.0, 30.0, 70.0];
const SPEEDS: [f64; 3] = [0.5, 1.0, 3.0];
const SLIDES: [f64; 4] = [0.01, 0.05, 0.2, 1.0];
const TEMPERATURES: [f64; 3] = [40.0, 80.0, 120.0];
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
fn candidates(oil: &OilBase, points: &[SetPoint]) -> Result<Vec<SetPoint>, OilError> {
    let Some(first) = points.first() else {
        return Ok(Vec::new());
    };
    let mut all = Vec::new();
    for load in LOADS {
        for speed in SPEEDS {
            for celsius in TEMPERATURES {
                for slide_to_roll in SLIDES {
                    let mut point = first.clone();
                    point.curve = usize::MAX - all.len() / SLIDES.len();
                    point.reading.set_temperature_c = celsius;
                    point.reading.film = None;
                    point.reading.sigma = None;
                    point.reading.setting = Setting {
                        load: Force::from_si(load),
                        mean_speed: Speed::from_si(speed),
                        slide_to_roll,
                        temperature: Temperature::from_celsius(celsius),
                    };
                    all.push(point);
                }
            }
        }
    }
    let mut kept = Vec::new();
    for point in all {
        if judge(oil, &point)?.dropped.is_none() {
            kept.push(point);
        }
    }
    Ok(kept)
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
) -> Result<[Option<Helpful>; STATED], OilError> {
    let further = candidates(oil, points)?;
    let all = [points, &further].concat();
    let law = oil.rheology.laws().1;
    let mut problem = TractionProblem::new(oil, law, priors, zero, &all);
    let x = DVector::zeros(problem.variables());
    let friction = problem.predicted(&x)?;
    let stated: Vec<Option<f64>> = all.iter().map(|point| point.reading.sigma).collect();
    set_errors(&mut problem, &stated, errors, &friction);
    let slopes = problem.at(&x).1;
    let columns = slopes.ncols();
    let of = |from: usize, rows: usize| slopes.rows(from, rows).into_owned();
    let measured = information(&of(0, points.len()));
    let of_priors = information(&of(all.len(), columns));
    let whole: DMatrix<f64> = measured + of_priors;
    let mut best = [None::<Helpful>; STATED];
    for (number, point) in further.iter().enumerate() {
        let row = of(points.len() + number, 1);
        let Some(after) = covariance(&(&whole + information(&row) * READINGS)) else {
            continue;
        };
        for (k, best) in best.iter_mut().enumerate() {
            let posterior = after[(k, k)].sqrt();
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
