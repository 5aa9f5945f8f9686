//! Least squares by the method of Levenberg and Marquardt, over some or all variables.

use crate::error;
use asperity_core::Fault;
use levenberg_marquardt::{LeastSquaresProblem, LevenbergMarquardt, TerminationReason};
use nalgebra::{DMatrix, DVector, Dyn, Owned};

/// Residuals as a function of the variables.
pub trait Residuals {
    /// Residuals at `x` and their derivatives, one row per residual.
    fn at(&self, x: &DVector<f64>) -> (DVector<f64>, DMatrix<f64>);
}

/// Minimum of a sum of squares.
#[derive(Debug, Clone, PartialEq)]
pub struct Minimum {
    /// The variables.
    pub x: DVector<f64>,
    /// Sum of the squared residuals.
    pub squares: f64,
    /// Number of evaluations of the residuals.
    pub evaluations: usize,
}

/// The problem over the free variables.
struct Free<'a> {
    residuals: &'a dyn Residuals,
    whole: DVector<f64>,
    free: &'a [usize],
    /// Residuals and their derivatives by the free variables.
    value: (DVector<f64>, DMatrix<f64>),
}

impl Free<'_> {
    fn evaluate(&mut self) {
        let (residuals, slopes) = self.residuals.at(&self.whole);
        self.value = (residuals, slopes.select_columns(self.free));
    }
}

impl LeastSquaresProblem<f64, Dyn, Dyn> for Free<'_> {
    type ResidualStorage = Owned<f64, Dyn>;
    type JacobianStorage = Owned<f64, Dyn, Dyn>;
    type ParameterStorage = Owned<f64, Dyn>;

    fn set_params(&mut self, x: &DVector<f64>) {
        for (k, value) in self.free.iter().zip(x.iter()) {
            self.whole[*k] = *value;
        }
        self.evaluate();
    }

    fn params(&self) -> DVector<f64> {
        self.whole.select_rows(self.free)
    }

    fn residuals(&self) -> Option<DVector<f64>> {
        Some(self.value.0.clone())
    }

    fn jacobian(&self) -> Option<DMatrix<f64>> {
        Some(self.value.1.clone())
    }
}

/// Relative change of sum and variables at which a fit ends, far below the digits of a band.
pub const TOLERANCE: f64 = 1e-10;

/// Minimises the sum of squares over the variables `free`, from `start`; the other variables are constant.
///
/// # Errors
/// When the method does not converge to a minimum.
pub fn minimum(
    residuals: &dyn Residuals,
    start: &DVector<f64>,
    free: &[usize],
) -> Result<Minimum, Fault> {
    minimum_within(TOLERANCE, residuals, start, free)
}

/// Minimises as [`minimum`], until sum and variables change by less than `tolerance` of them.
///
/// # Errors
/// When the method does not converge to a minimum.
pub(crate) fn minimum_within(
    tolerance: f64,
    residuals: &dyn Residuals,
    start: &DVector<f64>,
    free: &[usize],
) -> Result<Minimum, Fault> {
    let mut problem = Free {
        residuals,
        whole: start.clone(),
        free,
        value: (DVector::zeros(0), DMatrix::zeros(0, 0)),
    };
    problem.evaluate();
    if free.is_empty() {
        let squares = problem.value.0.norm_squared();
        return Ok(Minimum {
            x: problem.whole,
            squares,
            evaluations: 1,
        });
    }
    let method = LevenbergMarquardt::new()
        .with_ftol(tolerance)
        .with_xtol(tolerance)
        .with_gtol(tolerance);
    let (problem, report) = method.minimize(problem);
    // Within round-off no step improves the sum: also a minimum.
    let is_at_round_off = matches!(
        report.termination,
        TerminationReason::NoImprovementPossible(_)
    );
    if !report.termination.was_successful() && !is_at_round_off {
        let reason = format!("{:?}", report.termination);
        return Err(error::not_converged(reason));
    }
    Ok(Minimum {
        squares: 2.0 * report.objective_function,
        x: problem.whole,
        evaluations: report.number_of_evaluations,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// y = a exp(b t) through exact data.
    struct Exponential;

    impl Residuals for Exponential {
        fn at(&self, x: &DVector<f64>) -> (DVector<f64>, DMatrix<f64>) {
            let times = [0.0, 0.5, 1.0, 2.0];
            let model = |t: f64| x[0] * (x[1] * t).exp();
            let residuals = times.iter().map(|t| model(*t) - 2.0 * (-0.7 * t).exp());
            let slopes = times.iter().flat_map(|t| [model(*t) / x[0], model(*t) * t]);
            (
                DVector::from_iterator(4, residuals),
                DMatrix::from_row_iterator(4, 2, slopes),
            )
        }
    }

    #[test]
    fn exact_data_give_their_parameters_back() {
        let start = DVector::from_vec(vec![1.0, 0.0]);
        let found = minimum(&Exponential, &start, &[0, 1]).unwrap();
        assert!((found.x[0] - 2.0).abs() < 1e-9 && (found.x[1] + 0.7).abs() < 1e-9);
        assert!(found.squares < 1e-18 && found.evaluations < 15, "{found:?}");
    }

    #[test]
    fn a_variable_that_is_not_free_stays() {
        let start = DVector::from_vec(vec![2.0, 0.3]);
        let found = minimum(&Exponential, &start, &[1]).unwrap();
        assert_eq!(found.x[0], 2.0);
        assert!((found.x[1] + 0.7).abs() < 1e-8);
    }
}
