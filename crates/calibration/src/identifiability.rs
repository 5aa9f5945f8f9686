//! Identifiability of the parameters by the points of a rig, and the most useful further measurements, before the fit.

use crate::error;
use asperity::case::CalibratedName;
use asperity::message::Warning;
use asperity_core::numerics::{median, range};
use asperity_core::{Code, Fault};
use nalgebra::{DMatrix, DVector};

use crate::information::{
    correlations, covariance, deviation_without_prior, information, variances_after, without_prior,
};
use crate::parameters::Parameter;
use crate::problem::{Observation, Problem};
use crate::result::{HelpfulPoint, Identifiability, IdentifiedParameter, Verdict};
use crate::rig::Rig;
use crate::rig_model::{OperatingPoint, Progress};
use crate::surfaces::{slope_region, tangents};

/// Range of Λ* that the speeds must exceed at both ends for a fit of the boundary share.
pub(crate) const SWEEP: [f64; 2] = [0.3, 1.5];
/// Difference below which temperatures are grouped \[K\].
const SAME_TEMPERATURE: f64 = 5.0;
/// Least temperature range for a fit of the boundary share \[K\].
const LEAST_SPAN: f64 = 10.0;
/// Fewest operating points for a fit of the boundary share: one per parameter, and one to test the fit.
const FEWEST_POINTS: usize = 5;

/// Distinct temperatures \[°C\] in ascending order; close temperatures are replaced by their mean.
#[must_use]
pub fn temperatures(all: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut values: Vec<f64> = all.collect();
    values.sort_by(f64::total_cmp);
    let mut groups: Vec<Vec<f64>> = Vec::new();
    for value in values {
        match groups.last_mut() {
            Some(group) if value - group[0] <= SAME_TEMPERATURE => group.push(value),
            _ => groups.push(vec![value]),
        }
    }
    groups
        .iter()
        .map(|group| group.iter().sum::<f64>() / group.len() as f64)
        .collect()
}

/// Conditions under which points identify the boundary layer, which determines the boundary share, and that are not
/// fulfilled: several temperatures, enough points, and speeds with Λ* below 0.3 and above 1.5; none if it is not fitted.
pub(crate) fn missing_for_share(
    parameters: &[Parameter],
    points: &[([f64; 3], Option<f64>)],
) -> Vec<String> {
    let is_fitted = parameters
        .iter()
        .any(|parameter| parameter.name == CalibratedName::BoundaryLayer);
    if !is_fitted {
        return Vec::new();
    }
    let mut missing = Vec::new();
    if points.len() < FEWEST_POINTS {
        missing.push(format!(
            "{FEWEST_POINTS} operating points or more are required"
        ));
    }
    let temperatures = temperatures(points.iter().map(|(at, _)| at[2]));
    let span = temperatures
        .last()
        .zip(temperatures.first())
        .map_or(0.0, |(high, low)| high - low);
    if span < LEAST_SPAN {
        let listed: Vec<String> = temperatures
            .iter()
            .map(|value| format!("{value:.0} °C"))
            .collect();
        missing.push(format!(
            "temperature: only {}; two temperatures {LEAST_SPAN:.0} K apart are required, three are better",
            listed.join(", ")
        ));
    }
    match lambda_star_range(points.iter().map(|(_, ratio)| *ratio)) {
        None => missing.push("Lambda* is not known, because the flanks have no peaks".to_owned()),
        Some([low, high]) if low > SWEEP[0] || high < SWEEP[1] => missing.push(format!(
            "speed range: Lambda* from {low:.2} to {high:.2}; from below {} (slow, hot) to above {} (fast, cold) is required",
            SWEEP[0], SWEEP[1]
        )),
        Some(_) => {}
    }
    missing
}

/// Smallest and largest Λ*; `None` if one is not known.
pub(crate) fn lambda_star_range(all: impl Iterator<Item = Option<f64>>) -> Option<[f64; 2]> {
    let known: Option<Vec<f64>> = all.collect();
    let known = known.filter(|values| !values.is_empty())?;
    Some(range(known))
}

impl Rig {
    /// Holds the boundary layer, with a warning, if `missing_for_share` lists anything.
    ///
    /// # Errors
    /// When no other parameter is fitted.
    pub(crate) fn without_open_layer(mut self) -> Result<Self, Fault> {
        let points = self.operating_points.iter().zip(&self.nominal);
        let points: Vec<_> = points
            .map(|(point, parts)| (point.at, parts.lambda_star))
            .collect();
        let missing = missing_for_share(&self.parameters, &points);
        if missing.is_empty() {
            return Ok(self);
        }
        self.parameters
            .retain(|parameter| parameter.name != CalibratedName::BoundaryLayer);
        if self.parameters.is_empty() {
            return Err(error::share(&self.table.name, points.len(), &missing));
        }
        self.model = self.model.with_parameters(&self.parameters);
        self.table.warnings.push(Warning::new(
            Code::W436,
            format!(
                "the boundary layer is fixed, because these {} points do not identify it: {}",
                points.len(),
                missing.join("; ")
            ),
        ));
        Ok(self)
    }

    /// Identifiability by the points of `problem`, from the derivatives of the model with the parameters at their centres.
    ///
    /// # Errors
    /// When the model has no solution at a further point.
    pub fn identifiability(
        &self,
        problem: &Problem<'_>,
        progress: Progress<'_>,
    ) -> Result<Identifiability, Fault> {
        let region = slope_region(&self.parameters);
        let planes = tangents(&self.model, &region, progress)?;
        let local = Problem {
            surfaces: &planes,
            region: &region,
            ..problem.clone()
        };
        let start = DVector::zeros(problem.variables());
        let whole = information(&local.slopes(&start));
        let verdict = |k: usize, parameter: &Parameter| {
            let deviation = deviation_without_prior(&whole, k, parameter.prior);
            IdentifiedParameter {
                key: parameter.name.key().to_owned(),
                name: parameter.words().to_owned(),
                deviation,
                prior: parameter.prior,
                verdict: verdict(deviation, parameter.prior),
            }
        };
        let named = self.parameters.iter().enumerate();
        Ok(Identifiability {
            points: self.operating_points.len(),
            temperatures_c: temperatures(self.operating_points.iter().map(|point| point.at[2])),
            lambda_star: lambda_star_range(self.nominal.iter().map(|parts| parts.lambda_star)),
            parameters: named.map(|(k, parameter)| verdict(k, parameter)).collect(),
            worst_correlation: worst_correlation(&self.parameters, &whole),
            helpful: self.helpful(problem, &whole, progress)?,
        })
    }

    /// Further points with their gain, best first.
    fn helpful(
        &self,
        problem: &Problem<'_>,
        whole: &DMatrix<f64>,
        progress: Progress<'_>,
    ) -> Result<Vec<HelpfulPoint>, Fault> {
        /// Number of points reported.
        const REPORTED: usize = 3;
        let candidates = self.candidates();
        let model = self.model.at_points(&candidates);
        let region = slope_region(&self.parameters);
        let planes = tangents(&model, &region, progress)?;
        let sigmas = problem.observations.iter().map(|one| one.sigma);
        let sigma = median(sigmas).unwrap_or(f64::NAN);
        let Some(before) = covariance(whole) else {
            return Ok(Vec::new());
        };
        let other = Problem {
            surfaces: &planes,
            region: &region,
            ..problem.clone()
        };
        let start = DVector::zeros(problem.variables());
        let mut gains: Vec<(f64, HelpfulPoint)> = Vec::new();
        for (point, operating_points) in candidates.iter().enumerate() {
            let [torque_nm, speed_rpm, temperature_c] = operating_points.at;
            let observation = Observation {
                point,
                assembly: 0,
                log_loss: 0.0,
                sigma,
                omega: speed_rpm * std::f64::consts::PI / 30.0,
                bearing_torque: 0.0,
            };
            let slope = other.predicted(&start, &observation).1 / sigma;
            let after = variances_after(&before, &slope);
            let shrunk = |k: usize| (before[(k, k)] / after[k]).ln();
            let gain: f64 = (0..self.parameters.len()).map(shrunk).sum();
            let most = (0..self.parameters.len()).max_by(|a, b| shrunk(*a).total_cmp(&shrunk(*b)));
            let k = most.unwrap_or_default();
            // As in the list of the parameters; the prior where the points leave the parameter open.
            let prior = self.parameters[k].prior;
            let by_points = |variance| without_prior(variance, prior).unwrap_or(prior);
            let helpful = HelpfulPoint {
                torque_nm,
                speed_rpm,
                temperature_c,
                gains_most: self.parameters[k].words().to_owned(),
                deviation: [before[(k, k)], after[k]].map(by_points),
            };
            gains.push((gain, helpful));
        }
        gains.sort_by(|a, b| b.0.total_cmp(&a.0));
        Ok(gains
            .into_iter()
            .take(REPORTED)
            .map(|(_, helpful)| helpful)
            .collect())
    }

    /// Candidates within the limits of the rig, by default the range of the table: least and largest torque, speeds
    /// between the least and the largest, the temperatures or the ends and the middle of their range.
    fn candidates(&self) -> Vec<OperatingPoint> {
        const SPEEDS: usize = 6;
        let reach = &self.table.reach;
        let ends = |k: usize| range(self.operating_points.iter().map(|point| point.at[k]));
        let [least, most] = ends(1);
        let high = reach.speed_max_rpm.unwrap_or(most);
        let low = least.min(high);
        let [cold, hot] = ends(2);
        let middle = vec![cold, (0.5 * (cold + hot)).round(), hot];
        let mut temperatures = reach.temperatures_c.clone().unwrap_or(middle);
        temperatures.dedup();
        let mut torques = self.model.torques(0);
        torques.retain(|torque| reach.torque_max_nm.is_none_or(|most| torque.abs() <= most));
        let ends = torques.first().into_iter().chain(torques.last());
        let mut ends: Vec<f64> = ends.copied().collect();
        ends.dedup();
        let mut candidates = Vec::new();
        for torque in ends {
            for temperature in &temperatures {
                for k in 0..SPEEDS {
                    let speed = low * (high / low).powf(k as f64 / (SPEEDS - 1) as f64);
                    let point = OperatingPoint {
                        case: 0,
                        at: [torque, rounded(speed).clamp(low, high), *temperature],
                    };
                    if candidates.last() != Some(&point) {
                        candidates.push(point);
                    }
                }
            }
        }
        candidates
    }
}

/// Rounds to two digits, as a rig is set.
#[must_use]
pub fn rounded(value: f64) -> f64 {
    let power = 10f64.powf(value.abs().log10().floor() - 1.0);
    (value / power).round() * power
}

pub(crate) fn verdict(deviation: Option<f64>, prior: f64) -> Verdict {
    match deviation {
        Some(deviation) if deviation <= 0.5 * prior => Verdict::Identified,
        Some(deviation) if deviation <= prior => Verdict::Partly,
        _ => Verdict::NotIdentified,
    }
}

fn worst_correlation(
    parameters: &[Parameter],
    whole: &DMatrix<f64>,
) -> Option<(String, String, f64)> {
    let correlations = correlations(&covariance(whole)?);
    let n = parameters.len();
    let pairs = (0..n).flat_map(|i| (i + 1..n).map(move |j| (i, j)));
    let worst = pairs.max_by(|a, b| correlations[*a].abs().total_cmp(&correlations[*b].abs()))?;
    let name = |k: usize| parameters[k].words().to_owned();
    Some((name(worst.0), name(worst.1), correlations[worst]))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn layer() -> Vec<Parameter> {
        let case =
            asperity::case::load("../../fixtures/cases/e-drive.toml".as_ref(), None).unwrap();
        Parameter::all(&case).unwrap()
    }

    fn points(temperatures: &[f64], ratios: &[f64]) -> Vec<([f64; 3], Option<f64>)> {
        let of = |t: &f64| {
            ratios
                .iter()
                .map(|r| ([100.0, 100.0 * r, *t], Some(*r)))
                .collect::<Vec<_>>()
        };
        temperatures.iter().flat_map(of).collect()
    }

    #[test]
    fn one_temperature_is_named_and_two_that_sweep_are_enough() {
        let all = layer();
        let ratios = [0.2, 0.6, 1.0, 1.6];
        let missing = missing_for_share(&all, &points(&[89.0, 91.0], &ratios)).join("; ");
        assert!(missing.contains("temperature: only 90 °C"), "{missing}");
        assert!(!missing.contains("speed range"), "{missing}");
        assert!(missing_for_share(&all, &points(&[40.0, 90.0], &ratios)).is_empty());
    }

    #[test]
    fn two_points_lack_everything_and_a_held_layer_lacks_nothing() {
        let all = layer();
        let few = points(&[90.0], &[0.4, 1.0]);
        let text = missing_for_share(&all, &few).join("; ");
        for part in [
            "5 operating points",
            "temperature: only 90 °C",
            "Lambda* from 0.40 to 1.00",
        ] {
            assert!(text.contains(part), "{part}: {text}");
        }
        let held: Vec<Parameter> = all
            .into_iter()
            .filter(|one| one.name != CalibratedName::BoundaryLayer)
            .collect();
        assert!(missing_for_share(&held, &few).is_empty());
    }

    #[test]
    fn numbers_of_a_rig_have_two_digits() {
        assert_eq!(rounded(2166.0), 2200.0);
        assert!((rounded(0.0347) - 0.035).abs() < 1e-15);
    }
}
