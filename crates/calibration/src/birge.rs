//! Scatter of a fit relative to the stated errors, and its effect on the bands.

use asperity_core::cite;
use asperity_core::numerics::{standard_normal_quantile, student_t_quantile};

/// Sum of the squared residuals of a fit with its degrees of freedom.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scatter {
    /// Sum of the squared residuals of measurements and nuisance terms, in standard deviations.
    pub chi_squared: f64,
    /// Number of measurements minus number of fitted constants. Nuisance terms do not count: each is a variable and,
    /// by its prior, a residual.
    pub freedom: usize,
}

impl Scatter {
    /// Birge ratio above which the model does not explain the measurements.
    pub(crate) const LARGEST_RATIO: f64 = 3.0;
    /// Fewest degrees of freedom that can confirm the stated errors.
    pub(crate) const LEAST_FREEDOM: usize = 3;

    /// Ratio of the scatter to the stated errors.
    ///
    /// ```text
    /// B = √(χ²/ν)                                                                  [Birge-ratio]
    /// ```
    ///
    /// ```
    /// use asperity_calibration::birge::Scatter;
    /// let scatter = Scatter { chi_squared: 36.0, freedom: 9 };
    /// assert_eq!(scatter.ratio(), 2.0);
    /// // Student's t with nine degrees of freedom, 2.262, replaces 1.960.
    /// assert!((scatter.quantile(0.95) - 2.262).abs() < 5e-4);
    /// ```
    #[must_use]
    pub fn ratio(&self) -> f64 {
        cite!("Birge-ratio");
        (self.chi_squared / self.freedom as f64).sqrt()
    }

    /// Factor on all standard deviations: the Birge ratio, but at least 1.
    #[must_use]
    pub fn widening(&self) -> f64 {
        self.ratio().max(1.0)
    }

    /// Widened standard deviations from a value to an end of its band with this confidence: normal if the stated errors
    /// hold, otherwise Student's t, because the errors are then estimated from the residuals.
    #[must_use]
    pub fn quantile(&self, confidence: f64) -> f64 {
        if self.ratio() > 1.0 {
            student_t_quantile(confidence, self.freedom as f64)
        } else {
            standard_normal_quantile(0.5 * (1.0 + confidence))
        }
    }
}

#[cfg(test)]
mod tests {
    use asperity_core::numerics::Z_975;
    use chacha20::ChaCha8Rng;
    use nalgebra::DVector;
    use rand_core::{Rng, SeedableRng};

    use super::*;
    use crate::fit::{Fit, spread};
    use crate::least_squares::minimum;
    use crate::problem::{Observation, PointSurfaces, Problem};
    use crate::response::{Region, Response};

    const POINTS: usize = 12;
    const CONSTANTS: usize = 3;
    const SIGMA: f64 = 0.1;

    /// Losses of twelve points in a box of three constants and the temperature. The constants change the differences
    /// of the points and not their level, and the errors are larger than the priors of the nuisance terms: the bands
    /// hardly depend on those priors, which are exact.
    fn surfaces(region: &Region) -> Vec<PointSurfaces> {
        let at = |k: usize| {
            let step = std::f64::consts::TAU * k as f64 / POINTS as f64;
            let log_loss = |y: &Vec<f64>| {
                let angles = (1..=CONSTANTS).map(|j| j as f64 * step);
                let linear: f64 = angles.zip(y).map(|(angle, y)| angle.cos() * y).sum();
                4.0 + linear + 0.1 * linear * linear
            };
            let values: Vec<f64> = region.settings().iter().map(log_loss).collect();
            PointSurfaces {
                sliding: Response::through(4, &values),
                rolling: Response::tangent(4, &[-5.0; 5]),
            }
        };
        (0..POINTS).map(at).collect()
    }

    /// Share of the 95 % intervals of all fits that hold the truth, the same without widening, and share of the fits that are
    /// refused, if the errors are `factor` times as large as stated.
    fn coverage(factor: f64, rigs: u64) -> [f64; 3] {
        let region = Region {
            centre: vec![0.0; 4],
            half_width: vec![1.0, 1.0, 1.0, 4.0],
        };
        let (surfaces, priors) = (surfaces(&region), [4.0; CONSTANTS]);
        let observation = |point: usize| Observation {
            point,
            assembly: 0,
            log_loss: 4.0,
            sigma: SIGMA,
            omega: 100.0,
            bearing_torque: 0.0,
        };
        let truth = [0.1, -0.05, -0.1];
        let (mut held, mut plain, mut refused) = (0, 0, 0);
        for seed in 0..rigs {
            let mut random = ChaCha8Rng::seed_from_u64(seed);
            let mut normal = || {
                let even = (random.next_u64() >> 11) as f64 + 0.5;
                asperity_core::numerics::standard_normal_quantile(even / (1_u64 << 53) as f64)
            };
            let observations = (0..POINTS).map(observation).collect();
            let mut problem = Problem::new(&surfaces, &region, &priors, observations);
            let mut x = DVector::from_fn(problem.variables(), |_, _| normal());
            x.rows_mut(0, CONSTANTS).copy_from_slice(&truth);
            for k in 0..POINTS {
                let (log_loss, _) = problem.predicted(&x, &problem.observations[k]);
                problem.observations[k].log_loss = log_loss + factor * SIGMA * normal();
            }
            let all: Vec<usize> = (0..problem.variables()).collect();
            let minimum = minimum(&problem, &DVector::zeros(all.len()), &all).unwrap();
            let fit = Fit {
                region: region.clone(),
                surfaces: surfaces.clone(),
                priors: priors.to_vec(),
                observations: problem.observations.clone(),
                covariance: spread(&problem, &minimum).unwrap(),
                minimum,
                stages: Vec::new(),
                rounds: 1,
                is_settled: true,
            };
            refused += u32::from(fit.scatter().ratio() > Scatter::LARGEST_RATIO);
            let (most, widening) = (
                fit.scatter().quantile(0.95).powi(2),
                fit.scatter().widening(),
            );
            for (k, truth) in truth.iter().enumerate() {
                let rise = fit.rise(k, *truth).unwrap();
                held += u32::from(rise <= most);
                plain += u32::from(rise * widening * widening <= Z_975.powi(2));
            }
            if seed == 0 {
                for end in fit.band(0, 0.95).unwrap().ends {
                    assert!((fit.rise(0, end).unwrap() / most - 1.0).abs() < 1e-4);
                }
            }
        }
        let bands = (CONSTANTS as u64 * rigs) as f64;
        [
            f64::from(held) / bands,
            f64::from(plain) / bands,
            f64::from(refused) / rigs as f64,
        ]
    }

    #[test]
    fn bands_hold_the_truth_if_errors_are_understated() {
        // An independent linear computation: .961, .946, .949, without widening .945, .67, .50; refused 0, 1.6, 45 %.
        for (factor, most, expected) in [(1.0, 1.0, 0.0), (2.0, 0.75, 0.016), (3.0, 0.6, 0.45)] {
            let [held, plain, refused] = coverage(factor, 400);
            println!(
                "errors {factor} times as stated: {held:.3}, {plain:.3}, refused {refused:.3}"
            );
            // Four standard errors of 1200 bands.
            assert!((0.921..0.986).contains(&held), "{factor}: {held}");
            assert!(plain < most, "{factor}: {plain}");
            assert!((refused - expected).abs() < 0.1, "{factor}: {refused}");
        }
    }
}
