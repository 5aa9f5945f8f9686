//! Residuals of the measurements and of the priors, with response surfaces.
//!
//! ```text
//! L = s_a (S(θ, δT) + ρ R(δT)) + q ω + c |M| ω
//! r = (ln L_measured − ln L)/(σ/L_measured)                                  [Rig-residual]
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | S, R | sliding and rolling loss of the model | W |
//! | θ | logarithms of the parameters relative to their centres | - |
//! | δT | offset of the oil temperature | K |
//! | s_a | scale of assembly a | - |
//! | ρ | rolling loss relative to the model | - |
//! | q | loss torque without load | N m |
//! | c | loss torque of the bearings relative to the torque M, if the point includes it | - |
//!
//! The nuisance terms are in standard deviations of their priors; every prior adds a residual.

use asperity_core::cite;
use asperity_core::numerics::median;
use nalgebra::{DMatrix, DVector};

use crate::birge::Scatter;
use crate::least_squares::Residuals;
use crate::parameters::{ASSEMBLY, BEARINGS, NO_LOAD, ROLLING, TEMPERATURE};
use crate::response::{Region, Response};
use crate::rig_table::{RigRow, Scope};

/// Response surfaces of the logarithms of both losses at an operating point.
#[derive(Debug, Clone, PartialEq)]
pub struct PointSurfaces {
    /// Sliding loss as a function of the parameters and the temperature.
    pub sliding: Response,
    /// Rolling loss as a function of the same.
    pub rolling: Response,
}

/// Measurement in the form of the residuals.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Observation {
    /// Index of its operating point.
    pub point: usize,
    /// Index of its assembly.
    pub assembly: usize,
    /// Logarithm of the measured loss \[W\].
    pub log_loss: f64,
    /// Its standard deviation.
    pub sigma: f64,
    /// Speed \[rad/s\].
    pub omega: f64,
    /// Absolute torque of a point whose loss includes the bearings \[N m\]; otherwise 0.
    pub bearing_torque: f64,
}

impl Observation {
    /// Makes the measurement of a table row at an operating point and assembly.
    #[must_use]
    pub fn new(row: &RigRow, point: usize, assembly: usize) -> Self {
        Self {
            point,
            assembly,
            log_loss: row.loss_w.ln(),
            sigma: row.relative_sigma(),
            omega: row.omega(),
            bearing_torque: match row.includes {
                Scope::Mesh => 0.0,
                Scope::MeshAndBearings => row.torque_nm.abs(),
            },
        }
    }

    /// Loss torque \[N m\].
    #[must_use]
    pub fn loss_torque(&self) -> f64 {
        self.log_loss.exp() / self.omega
    }
}

/// Least squares problem of a fit.
#[derive(Debug, Clone, PartialEq)]
pub struct Problem<'a> {
    /// Response surfaces by operating point.
    pub surfaces: &'a [PointSurfaces],
    /// Box of the surfaces: the parameters, then the temperature \[K\].
    pub region: &'a Region,
    /// Standard deviations of the priors of the parameters.
    pub priors: &'a [f64],
    /// The measurements.
    pub observations: Vec<Observation>,
    /// Number of assemblies.
    pub assemblies: usize,
    /// Standard deviation of the loss torque without load \[N m\].
    pub no_load: f64,
}

/// Number of nuisance terms besides the scales of the assemblies: temperature, rolling, no load, bearings.
pub const COMMON: usize = 4;

impl<'a> Problem<'a> {
    /// Makes the problem of `observations`, which are at the points of `surfaces`.
    #[must_use]
    pub fn new(
        surfaces: &'a [PointSurfaces],
        region: &'a Region,
        priors: &'a [f64],
        observations: Vec<Observation>,
    ) -> Self {
        let assemblies = observations
            .iter()
            .map(|observation| observation.assembly + 1)
            .max();
        let torques = observations.iter().map(Observation::loss_torque);
        Self {
            surfaces,
            region,
            priors,
            assemblies: assemblies.unwrap_or(0),
            no_load: NO_LOAD * median(torques).unwrap_or(1.0),
            observations,
        }
    }

    /// The problem with other measurements of the same operating points: the assemblies keep their numbers, the loss without
    /// load its prior.
    #[must_use]
    pub fn with(&self, observations: Vec<Observation>) -> Self {
        Self {
            observations,
            ..self.clone()
        }
    }

    /// Number of parameters.
    #[must_use]
    pub fn parameters(&self) -> usize {
        self.priors.len()
    }

    /// Number of variables: parameters and nuisance terms.
    #[must_use]
    pub fn variables(&self) -> usize {
        self.parameters() + COMMON + self.assemblies
    }

    /// Index of the variable that scales an assembly.
    #[must_use]
    pub fn scale(&self, assembly: usize) -> usize {
        self.parameters() + COMMON + assembly
    }

    /// Logarithm of the predicted loss of a measurement, and its derivatives by all variables.
    #[must_use]
    pub fn predicted(&self, x: &DVector<f64>, observation: &Observation) -> (f64, DVector<f64>) {
        let n = self.parameters();
        let x = x.as_slice();
        let mut at = x[..n].to_vec();
        at.push(TEMPERATURE * x[n]);
        let u = self.region.normalised(&at);
        let surfaces = &self.surfaces[observation.point];
        let (log_sliding, sliding_slope) = surfaces.sliding.at(&u);
        let (log_rolling, rolling_slope) = surfaces.rolling.at(&u);
        let scale_at = self.scale(observation.assembly);
        let scale = (ASSEMBLY * x[scale_at]).exp();
        let sliding = scale * log_sliding.exp();
        let rolling = scale * (ROLLING * x[n + 1]).exp() * log_rolling.exp();
        let bearings = BEARINGS[0] + BEARINGS[1] * x[n + 3];
        let least = f64::MIN_POSITIVE;
        let additional = self.no_load * x[n + 2] * observation.omega
            + bearings * observation.bearing_torque * observation.omega;
        let loss = (sliding + rolling + additional).max(least);
        let mut slope = vec![0.0; self.variables()];
        for (k, width) in self.region.half_width.iter().enumerate() {
            let by = (sliding * sliding_slope[k] + rolling * rolling_slope[k]) / width;
            slope[k] = if k < n { by } else { TEMPERATURE * by };
        }
        slope[n + 1] = ROLLING * rolling;
        slope[n + 2] = self.no_load * observation.omega;
        slope[n + 3] = BEARINGS[1] * observation.bearing_torque * observation.omega;
        slope[scale_at] = ASSEMBLY * (sliding + rolling);
        slope.iter_mut().for_each(|slope| *slope /= loss);
        (loss.ln(), slope.into())
    }

    /// Derivatives of the residuals of measurements and priors, one row each, without the residuals that keep a fit near
    /// its box.
    #[must_use]
    pub fn slopes(&self, x: &DVector<f64>) -> DMatrix<f64> {
        let rows = self.observations.len() + self.variables();
        self.at(x).1.rows(0, rows).into_owned()
    }

    /// Residuals of the measurements only.
    #[must_use]
    pub fn of_measurements(&self, x: &DVector<f64>) -> Vec<f64> {
        let residual = |observation: &Observation| {
            (observation.log_loss - self.predicted(x, observation).0) / observation.sigma
        };
        self.observations.iter().map(residual).collect()
    }

    /// Scatter at the minimum `x`. The priors of the parameters do not count.
    #[must_use]
    pub fn scatter(&self, x: &DVector<f64>) -> Scatter {
        let nuisance = x.iter().skip(self.parameters()).copied();
        let residuals = self.of_measurements(x).into_iter().chain(nuisance);
        Scatter {
            chi_squared: residuals.map(|residual| residual * residual).sum(),
            freedom: self.observations.len().saturating_sub(self.parameters()),
        }
    }
}

impl Residuals for Problem<'_> {
    fn at(&self, x: &DVector<f64>) -> (DVector<f64>, DMatrix<f64>) {
        cite!("Rig-residual");
        let (points, variables, n) = (self.observations.len(), self.variables(), self.parameters());
        let rows = points + variables + n;
        let mut residuals = DVector::zeros(rows);
        let mut slopes = DMatrix::zeros(rows, variables);
        for (k, observation) in self.observations.iter().enumerate() {
            let (log_loss, slope) = self.predicted(x, observation);
            residuals[k] = (observation.log_loss - log_loss) / observation.sigma;
            let (elements, by) = (slopes.as_mut_slice(), -1.0 / observation.sigma);
            for (j, slope) in slope.as_slice().iter().enumerate() {
                elements[k + j * rows] = by * slope;
            }
        }
        for j in 0..variables {
            let width = self.priors.get(j).copied().unwrap_or(1.0);
            residuals[points + j] = x[j] / width;
            slopes[(points + j, j)] = 1.0 / width;
        }
        // A quadratic surface is not valid far outside of its box.
        for j in 0..n {
            /// Distance from the centre in half widths above which a residual is added.
            const REACH: f64 = 1.5;
            /// This residual in standard deviations per half width.
            const FIRMNESS: f64 = 20.0;
            let (centre, width) = (self.region.centre[j], self.region.half_width[j]);
            let beyond = (x[j] - centre) / width;
            if beyond.abs() > REACH {
                residuals[points + variables + j] = FIRMNESS * (beyond.abs() - REACH);
                slopes[(points + variables + j, j)] = FIRMNESS * beyond.signum() / width;
            }
        }
        (residuals, slopes)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn surface(axes: usize, seed: f64) -> Response {
        let count = 1 + 2 * axes + axes * (axes - 1) / 2;
        let values: Vec<f64> = (0..count)
            .map(|k| 3.0 + 0.1 * (seed + 1.7 * k as f64).sin())
            .collect();
        Response::through(axes, &values)
    }

    #[test]
    fn slopes_of_the_residuals_are_their_differences() {
        let region = Region {
            centre: vec![0.1, -0.2, 0.5],
            half_width: vec![0.4, 0.3, 4.0],
        };
        let surfaces = [1.0, 2.0].map(|seed| PointSurfaces {
            sliding: surface(3, seed),
            rolling: surface(3, 10.0 * seed),
        });
        let observation = |point, assembly, bearing_torque| Observation {
            point,
            assembly,
            log_loss: 3.4,
            sigma: 0.03,
            omega: 120.0,
            bearing_torque,
        };
        let observations = vec![
            observation(0, 0, 0.0),
            observation(1, 1, 60.0),
            observation(0, 1, 60.0),
        ];
        let problem = Problem::new(&surfaces, &region, &[0.5, 0.3], observations);
        // Inside the box, and one parameter beyond the reach of its surface.
        for first in [0.2, 0.95] {
            let mut x = DVector::from_fn(problem.variables(), |k, _| 0.3 * (k as f64 - 2.0).sin());
            x[0] = first;
            let slopes = problem.at(&x).1;
            for k in 0..problem.variables() {
                const STEP: f64 = 1e-6;
                let (mut up, mut down) = (x.clone(), x.clone());
                up[k] += STEP;
                down[k] -= STEP;
                let difference = (problem.at(&up).0 - problem.at(&down).0) / (2.0 * STEP);
                let error = (difference - slopes.column(k)).amax();
                assert!(
                    error < 1e-6 * slopes.column(k).amax().max(1.0),
                    "{k}: {error}"
                );
            }
        }
    }

    #[test]
    fn measurements_that_the_model_gives_have_no_residual() {
        let region = Region {
            centre: vec![0.0, 0.0],
            half_width: vec![0.4, 4.0],
        };
        let surfaces = [PointSurfaces {
            sliding: surface(2, 1.0),
            rolling: surface(2, 5.0),
        }];
        let mut observation = Observation {
            point: 0,
            assembly: 0,
            log_loss: 0.0,
            sigma: 0.03,
            omega: 100.0,
            bearing_torque: 0.0,
        };
        let problem = Problem::new(&surfaces, &region, &[0.5], vec![observation]);
        let x = DVector::zeros(problem.variables());
        observation.log_loss = problem.predicted(&x, &observation).0;
        let problem = problem.with(vec![observation]);
        assert_eq!(problem.of_measurements(&x), [0.0]);
        assert_eq!(problem.at(&x).0.amax(), 0.0);
    }
}
