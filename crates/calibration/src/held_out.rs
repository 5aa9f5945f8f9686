//! Cross-validation: every temperature predicted from the others.

use crate::fit::{Fit, spread};
use crate::identifiability::temperatures;
use crate::least_squares::minimum;
use crate::problem::Observation;
use crate::result::HeldOut;
use crate::rig::Rig;
use asperity_core::Fault;

impl Rig {
    /// Fits the measurements of all temperatures except one and predicts that one, for each of three or more
    /// temperatures.
    ///
    /// # Errors
    /// When a fit does not converge.
    pub fn held_out(&self, fit: &Fit) -> Result<Vec<HeldOut>, Fault> {
        let groups = temperatures(self.operating_points.iter().map(|point| point.at[2]));
        if groups.len() < 3 {
            return Ok(Vec::new());
        }
        let group_of = |observation: &Observation| {
            let temperature = self.operating_points[observation.point].at[2];
            let far = |k: &usize| (groups[*k] - temperature).abs();
            (0..groups.len()).min_by(|a, b| far(a).total_cmp(&far(b)))
        };
        let problem = fit.problem();
        let widening = fit.scatter().widening();
        let all: Vec<usize> = (0..problem.variables()).collect();
        let one = |k: usize| -> Result<HeldOut, Fault> {
            let (held, fitted): (Vec<Observation>, Vec<Observation>) = problem
                .observations
                .iter()
                .partition(|observation| group_of(observation) == Some(k));
            let part = problem.with(fitted);
            let minimum = minimum(&part, &fit.minimum.x, &all)?;
            let covariance = spread(&part, &minimum)?;
            let (mut sum, mut squares, mut expected) = (0.0, 0.0, 0.0);
            for observation in &held {
                let (log_loss, slope) = problem.predicted(&minimum.x, observation);
                let error = observation.log_loss - log_loss;
                sum += error;
                squares += error * error;
                expected += observation.sigma * observation.sigma
                    + (slope.transpose() * &covariance * &slope)[(0, 0)];
            }
            let count = held.len() as f64;
            Ok(HeldOut {
                temperature_c: groups[k],
                points: held.len(),
                mean_error: sum / count,
                rms_error: (squares / count).sqrt(),
                expected_error: widening * (expected / count).sqrt(),
            })
        };
        (0..groups.len()).map(one).collect()
    }
}
