//! Fit of the oil constants to traction curves, by both laws of pressure.

use crate::error;
use asperity::oil::PressureLaw;
use asperity_core::Fault;
use nalgebra::{DMatrix, DVector};

use super::base::OilBase;
use super::problem::{CONSTANTS, FACTOR, Priors, TractionProblem, Zero};
use super::reading::SetPoint;
use crate::information::{covariance, information};
use crate::least_squares::{Residuals, TOLERANCE, minimum_within};

/// Start of the factor f of Roelands' law, which bends below Barus' with the same coefficient.
const ROELANDS_START: f64 = 1.4;
/// Tolerances of the passes, each with the errors of the points from the friction fitted before.
const PASSES: [f64; 3] = [1e-5, 1e-5, TOLERANCE];

/// Errors of the points that state none.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointErrors {
    /// Standard deviation relative to the fitted friction.
    pub relative: f64,
    /// Least standard deviation of the friction coefficient.
    pub floor: f64,
}

impl PointErrors {
    /// Standard deviation at a friction.
    #[must_use]
    pub fn of(&self, friction: f64) -> f64 {
        (self.relative * friction.max(0.0)).hypot(self.floor)
    }
}

/// Fit by one law of pressure.
#[derive(Debug, Clone)]
pub struct LawFit<'a> {
    /// The problem with the errors of its points.
    pub problem: TractionProblem<'a>,
    /// The variables at the minimum.
    pub x: DVector<f64>,
    /// Covariance of the variables, not yet widened.
    pub covariance: DMatrix<f64>,
    /// Sum of the squared residuals of the points.
    pub points_squared: f64,
    /// Sum of all squared residuals.
    pub total_squared: f64,
    /// Friction at the points, with gain and zero.
    pub fitted: Vec<f64>,
}

impl LawFit<'_> {
    /// Sum of squares of the points over their number.
    #[must_use]
    pub fn squares_per_point(&self) -> f64 {
        self.points_squared / self.problem.points.len() as f64
    }

    /// Factor on all standard deviations: the residuals relative to the stated errors, but at least 1.
    #[must_use]
    pub fn widening(&self) -> f64 {
        self.squares_per_point().max(1.0).sqrt()
    }

    /// Standard deviation of variable `k` in units of its prior, widened by the residuals.
    #[must_use]
    pub fn deviation(&self, k: usize) -> f64 {
        self.widening() * self.covariance[(k, k)].sqrt()
    }

    /// Standard deviation of constant `k`, widened by the residuals: of the logarithm, but of b_L itself.
    #[must_use]
    pub(crate) fn constant_deviation(&self, k: usize) -> f64 {
        self.problem.priors.constants[k] * self.deviation(k)
    }

    /// Sum of squares without the prior of the factor f.
    #[must_use]
    pub(crate) fn without_factor_prior(&self) -> f64 {
        self.total_squared - self.x[FACTOR] * self.x[FACTOR]
    }
}

/// Sets the errors of the points from their friction: stated ones stay.
pub(super) fn set_errors(
    problem: &mut TractionProblem<'_>,
    stated: &[Option<f64>],
    errors: PointErrors,
    friction: &[f64],
) {
    for ((point, stated), friction) in problem.points.iter_mut().zip(stated).zip(friction) {
        point.sigma = stated.unwrap_or_else(|| errors.of(*friction));
    }
}

/// Fits the constants by one law of pressure.
///
/// # Errors
/// When the fit does not converge.
pub fn fit_law<'a>(
    oil: &'a OilBase,
    law: PressureLaw,
    priors: Priors,
    zero: Zero,
    errors: PointErrors,
    points: &[SetPoint],
) -> Result<LawFit<'a>, Fault> {
    let mut problem = TractionProblem::new(oil, law, priors, zero, points);
    let stated: Vec<Option<f64>> = points.iter().map(|point| point.reading.sigma).collect();
    let mut friction: Vec<f64> = points.iter().map(|point| point.reading.traction).collect();
    let free: Vec<usize> = (0..problem.variables()).collect();
    let mut x = DVector::zeros(free.len());
    if law == PressureLaw::Roelands {
        x[FACTOR] = ROELANDS_START.ln() / priors.constants[FACTOR];
    }
    let mut total_squared = 0.0;
    for tolerance in PASSES {
        set_errors(&mut problem, &stated, errors, &friction);
        let found = minimum_within(tolerance, &problem, &x, &free)?;
        x = found.x;
        total_squared = found.squares;
        friction = problem.predicted(&x)?;
    }
    let (residuals, slopes) = problem.at(&x);
    let points_squared = residuals.rows(0, problem.points.len()).norm_squared();
    let covariance = covariance(&information(&slopes)).ok_or_else(|| {
        let reason = "the constants have no covariance".to_owned();
        error::not_converged(reason)
    })?;
    Ok(LawFit {
        problem,
        x,
        covariance,
        points_squared,
        total_squared,
        fitted: friction,
    })
}

/// The problem of points that are still to be measured, with the friction of the family's constants.
pub(super) fn planned<'a>(
    oil: &'a OilBase,
    priors: Priors,
    zero: Zero,
    errors: PointErrors,
    points: &[SetPoint],
) -> Result<TractionProblem<'a>, Fault> {
    let law = oil.rheology.laws().1;
    let mut problem = TractionProblem::new(oil, law, priors, zero, points);
    let friction = problem.predicted(&DVector::zeros(problem.variables()))?;
    let stated: Vec<Option<f64>> = points.iter().map(|point| point.reading.sigma).collect();
    set_errors(&mut problem, &stated, errors, &friction);
    Ok(problem)
}

/// Covariance of the constants, in standard deviations of their priors, that points would leave: before any measurement.
///
/// # Errors
/// When the friction has no solution at a point.
pub(crate) fn expected_covariance(
    oil: &OilBase,
    priors: Priors,
    zero: Zero,
    errors: PointErrors,
    points: &[SetPoint],
) -> Result<DMatrix<f64>, Fault> {
    let problem = planned(oil, priors, zero, errors, points)?;
    let slopes = problem.at(&DVector::zeros(problem.variables())).1;
    let all = covariance(&information(&slopes));
    Ok(all.map_or_else(
        || DMatrix::identity(CONSTANTS, CONSTANTS),
        |all| all.view((0, 0), (CONSTANTS, CONSTANTS)).into_owned(),
    ))
}

/// Standard deviations of the constants, over those of their priors, of `expected_covariance`.
///
/// # Errors
/// When the friction has no solution at a point.
pub fn expected(
    oil: &OilBase,
    priors: Priors,
    zero: Zero,
    errors: PointErrors,
    points: &[SetPoint],
) -> Result<[f64; CONSTANTS], Fault> {
    let all = expected_covariance(oil, priors, zero, errors, points)?;
    Ok(std::array::from_fn(|k| all[(k, k)].sqrt()))
}
