//! Fisher's information of a design: the expected covariance of the parameters before any measurement.

use asperity_core::cite;
use nalgebra::{DMatrix, DVector};

/// Information on the variables from the derivatives `slopes` of the residuals, one row per point in standard deviations:
///
/// ```text
/// I = Σ j jᵀ,  C = I⁻¹                                                        [Fisher-information]
/// ```
///
/// Priors are rows like points.
///
/// ```
/// use asperity_calibration::information::{covariance, information};
/// use nalgebra::DMatrix;
/// // A straight line a + b t at t = -1, 0, 1, each ± 0.1: var a = 0.01/3, var b = 0.01/2.
/// let slopes = DMatrix::from_row_slice(3, 2, &[1.0, -1.0, 1.0, 0.0, 1.0, 1.0]) / 0.1;
/// let found = covariance(&information(&slopes)).ok_or("singular")?;
/// assert!((found[(0, 0)] - 0.01 / 3.0).abs() < 1e-15 && (found[(1, 1)] - 0.005).abs() < 1e-15);
/// # Ok::<(), &str>(())
/// ```
#[must_use]
pub fn information(slopes: &DMatrix<f64>) -> DMatrix<f64> {
    cite!("Fisher-information");
    slopes.transpose() * slopes
}

/// Covariance of the variables; `None` if a combination of them is not identified.
#[must_use]
pub fn covariance(information: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    information
        .clone()
        .cholesky()
        .map(|factor| factor.inverse())
}

/// Variances of the variables of a covariance after a further point with the derivatives `slope`, by Sherman and Morrison:
///
/// ```text
/// diag(C − C j jᵀ C/(1 + jᵀ C j))
/// ```
#[must_use]
pub(crate) fn variances_after(covariance: &DMatrix<f64>, slope: &DVector<f64>) -> DVector<f64> {
    let moved = covariance * slope;
    let whole = 1.0 + slope.dot(&moved);
    covariance.diagonal() - moved.map(|value| value * value / whole)
}

/// Standard deviation of variable `k` without its own prior of width `prior`; `None` if only the prior determines it.
#[must_use]
pub(crate) fn deviation_without_prior(
    information: &DMatrix<f64>,
    k: usize,
    prior: f64,
) -> Option<f64> {
    without_prior(covariance(information)?[(k, k)], prior)
}

/// Standard deviation of a variable with this `variance` without its own prior of width `prior`; `None` if only the prior
/// determines it.
#[must_use]
pub(crate) fn without_prior(variance: f64, prior: f64) -> Option<f64> {
    /// Information that is only round-off.
    const LEAST: f64 = 1e-9;
    let information = 1.0 / variance - 1.0 / (prior * prior);
    (information > LEAST).then(|| information.sqrt().recip())
}

/// Correlations of a covariance.
#[must_use]
pub fn correlations(covariance: &DMatrix<f64>) -> DMatrix<f64> {
    let deviations: DVector<f64> = covariance.diagonal().map(f64::sqrt);
    DMatrix::from_fn(covariance.nrows(), covariance.ncols(), |i, j| {
        // The diagonal is exactly one, without round-off.
        if i == j {
            1.0
        } else {
            covariance[(i, j)] / (deviations[i] * deviations[j])
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_information_of_a_line_is_that_of_its_normal_equations() {
        let times = [-2.0, 0.5, 1.0, 3.0];
        let sigma = 0.2;
        let rows = times.iter().flat_map(|t| [1.0 / sigma, t / sigma]);
        let slopes = DMatrix::from_row_iterator(4, 2, rows);
        let found = covariance(&information(&slopes)).unwrap();
        let mean = times.iter().sum::<f64>() / 4.0;
        let spread: f64 = times.iter().map(|t| (t - mean) * (t - mean)).sum();
        // Closed forms of a straight line.
        let slope = sigma * sigma / spread;
        let offset = sigma * sigma * (0.25 + mean * mean / spread);
        assert!((found[(1, 1)] / slope - 1.0).abs() < 1e-12);
        assert!((found[(0, 0)] / offset - 1.0).abs() < 1e-12);
        let correlation = correlations(&found)[(0, 1)];
        assert!(
            (correlation + mean / (0.25 * times.iter().map(|t| t * t).sum::<f64>()).sqrt()).abs()
                < 1e-12
        );
    }

    #[test]
    fn a_variable_that_no_point_touches_is_known_by_its_prior_alone() {
        let slopes = DMatrix::from_row_slice(2, 2, &[10.0, 0.0, 0.0, 1.0 / 0.7]);
        let found = information(&slopes);
        assert_eq!(deviation_without_prior(&found, 1, 0.7), None);
        let prior = DMatrix::from_row_slice(1, 2, &[1.0 / 0.5, 0.0]);
        let with = information(&slopes) + information(&prior);
        assert!((deviation_without_prior(&with, 0, 0.5).unwrap() - 0.1).abs() < 1e-12);
        assert!(covariance(&DMatrix::zeros(2, 2)).is_none());
    }

    #[test]
    fn variances_after_a_point_are_those_of_the_information_with_it() {
        let slopes = DMatrix::from_row_slice(3, 2, &[1.0, -1.0, 1.0, 0.5, 0.0, 2.0]);
        let further = DVector::from_column_slice(&[3.0, -0.7]);
        let whole = information(&slopes);
        let found = variances_after(&covariance(&whole).unwrap(), &further);
        let expected = covariance(&(whole + &further * further.transpose())).unwrap();
        assert!((found - expected.diagonal()).amax() < 1e-15);
    }
}
