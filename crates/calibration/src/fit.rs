//! The fit: in stages, then of all parameters, on response surfaces that are recomputed about the optimum until it is
//! stationary.

use crate::error;
use asperity::case::CalibratedName;
use asperity_core::Fault;
use nalgebra::{DMatrix, DVector};

use crate::birge::Scatter;
use crate::information::{covariance, information};
use crate::least_squares::{Minimum, minimum};
use crate::parameters::TEMPERATURE;
use crate::problem::{Observation, PointSurfaces, Problem};
use crate::profile_likelihood::{ProfileBand, profile_band};
use crate::response::Region;
use crate::result::StageRow;
use crate::rig::Rig;
use crate::rig_model::Progress;
use crate::surfaces::surfaces;

/// Share of the load on the boundary layer below which film friction dominates a point.
const FILM: f64 = 0.02;
/// Fraction of the largest such share from which boundary friction dominates a point.
const PLATEAU: f64 = 0.5;

/// Fit with its response surfaces.
#[derive(Debug, Clone)]
pub struct Fit {
    /// Box of the surfaces.
    pub region: Region,
    /// The surfaces.
    pub surfaces: Vec<PointSurfaces>,
    /// Priors of the parameters.
    pub priors: Vec<f64>,
    /// The measurements.
    pub observations: Vec<Observation>,
    /// Minimum over the variables: logarithms of the parameters relative to their centres, then nuisance terms.
    pub minimum: Minimum,
    /// Covariance of the variables.
    pub covariance: DMatrix<f64>,
    /// Stages before the last fit.
    pub stages: Vec<StageRow>,
    /// Number of rounds of response surfaces.
    pub rounds: usize,
    /// Whether the optimum is well inside the last box.
    pub is_settled: bool,
}

impl Fit {
    /// The least squares problem of the fit.
    #[must_use]
    pub fn problem(&self) -> Problem<'_> {
        Problem::new(
            &self.surfaces,
            &self.region,
            &self.priors,
            self.observations.clone(),
        )
    }

    /// Scatter of the measurements about the fit.
    #[must_use]
    pub fn scatter(&self) -> Scatter {
        self.problem().scatter(&self.minimum.x)
    }

    /// Standard deviation of a variable, widened by the [`Scatter`].
    #[must_use]
    pub fn deviation(&self, k: usize) -> f64 {
        self.scatter().widening() * self.covariance[(k, k)].sqrt()
    }

    /// Rise of the least sum of squares with parameter `k` at `value`, in widened variances.
    ///
    /// # Errors
    /// When the fit of the other variables does not converge.
    pub fn rise(&self, k: usize, value: f64) -> Result<f64, Fault> {
        let problem = self.problem();
        let free: Vec<usize> = (0..problem.variables()).filter(|j| *j != k).collect();
        let mut start = self.minimum.x.clone();
        // The other variables start at their conditional means, close to their optimum.
        let step = value - start[k];
        let along = self.covariance.column(k) * (step / self.covariance[(k, k)]);
        start += along;
        start[k] = value;
        let rise = minimum(&problem, &start, &free)?.squares - self.minimum.squares;
        Ok(rise / self.scatter().widening().powi(2))
    }

    /// Band of parameter `k` with this confidence by its profile likelihood, widened by the [`Scatter`], in logarithms
    /// relative to its centre.
    ///
    /// # Errors
    /// When a fit of the profile does not converge.
    pub fn band(&self, k: usize, confidence: f64) -> Result<ProfileBand, Fault> {
        let quantile = self.scatter().quantile(confidence);
        profile_band(self.minimum.x[k], self.deviation(k), quantile, |value| {
            self.rise(k, value)
        })
    }
}

impl Rig {
    /// Fits the measurements, starting with the surfaces `first`.
    ///
    /// # Errors
    /// When a fit does not converge, or the model has no solution at a point.
    pub fn fit(
        &self,
        observations: Vec<Observation>,
        first: (Region, Vec<PointSurfaces>),
        progress: Progress<'_>,
    ) -> Result<Fit, Fault> {
        /// Largest number of rounds.
        const MOST_ROUNDS: usize = 8;
        let priors = self.priors();
        let (mut region, mut made) = first;
        let mut rounds = 1;
        let (mut stages, mut start) = (Vec::new(), None);
        loop {
            let problem = Problem::new(&made, &region, &priors, observations.clone());
            let begin = match start.take() {
                Some(begin) => begin,
                None => {
                    let staged = self.staged(&problem)?;
                    stages = staged.1;
                    staged.0
                }
            };
            let all: Vec<usize> = (0..problem.variables()).collect();
            let minimum = minimum(&problem, &begin, &all)?;
            let covariance = spread(&problem, &minimum)?;
            let is_settled = rounds > 1 && is_settled(&region, &minimum.x, &covariance);
            if is_settled || rounds == MOST_ROUNDS {
                return Ok(Fit {
                    region,
                    surfaces: made,
                    priors,
                    observations,
                    minimum,
                    covariance,
                    stages,
                    rounds,
                    is_settled,
                });
            }
            let widening = problem.scatter(&minimum.x).widening();
            let widened = covariance * widening.min(Scatter::LARGEST_RATIO).powi(2);
            region = next_region(&region, &minimum.x, &widened);
            made = surfaces(&self.model, &region, progress)?;
            start = Some(minimum.x);
            rounds += 1;
        }
    }

    /// Start of the fit, in stages: film traction from points without asperity contact, boundary friction from points
    /// where it dominates, the boundary layer from all points.
    fn staged(&self, problem: &Problem<'_>) -> Result<(DVector<f64>, Vec<StageRow>), Fault> {
        use CalibratedName::{BoundaryFriction, BoundaryLayer, EyringStress, LimitingShear};
        let share = |observation: &Observation| self.nominal[observation.point].boundary_share;
        let most = problem.observations.iter().map(share).fold(0.0, f64::max);
        let film = |observation: &Observation| share(observation) < FILM;
        let plateau = |observation: &Observation| share(observation) >= PLATEAU * most;
        let every = |_: &Observation| true;
        type Selected<'a> = &'a dyn Fn(&Observation) -> bool;
        let plan: [(&str, Selected<'_>, &[CalibratedName]); 3] = [
            (
                "film traction, from points without asperity contact",
                &film,
                &[LimitingShear, EyringStress],
            ),
            (
                "boundary friction, from points on the boundary layer",
                &plateau,
                &[BoundaryFriction],
            ),
            ("boundary layer, from all points", &every, &[BoundaryLayer]),
        ];
        let mut x = DVector::zeros(problem.variables());
        let mut stages = Vec::new();
        for (name, selected, names) in plan {
            let of_stage = |k: &usize| names.contains(&self.parameters[*k].name);
            let free: Vec<usize> = (0..self.parameters.len()).filter(of_stage).collect();
            let taken: Vec<Observation> = problem
                .observations
                .iter()
                .filter(|observation| selected(observation))
                .copied()
                .collect();
            if free.is_empty() || taken.len() <= free.len() {
                continue;
            }
            let points = taken.len();
            x = minimum(&problem.with(taken), &x, &free)?.x;
            let value = |k: &usize| {
                let parameter = &self.parameters[*k];
                (
                    parameter.words().to_owned(),
                    parameter.default.value * x[*k].exp(),
                )
            };
            stages.push(StageRow {
                name: name.to_owned(),
                points,
                values: free.iter().map(value).collect(),
            });
        }
        Ok((x, stages))
    }
}

/// Covariance at a minimum, priors included.
pub(crate) fn spread(problem: &Problem<'_>, minimum: &Minimum) -> Result<DMatrix<f64>, Fault> {
    // Every variable has a prior, so only round-off can make the information singular.
    covariance(&information(&problem.slopes(&minimum.x)))
        .ok_or_else(|| error::not_converged("the information of the fit is singular"))
}

/// The coordinates of the surfaces at `x`, the parameters and the temperature offset, with their standard deviations.
fn coordinates(region: &Region, x: &DVector<f64>, covariance: &DMatrix<f64>) -> Vec<[f64; 2]> {
    let n = region.centre.len() - 1;
    let coordinate = |k: usize| {
        let unit = if k < n { 1.0 } else { TEMPERATURE };
        [unit * x[k], unit * covariance[(k, k)].sqrt()]
    };
    (0..=n).map(coordinate).collect()
}

/// Box about the optimum, as wide as its uncertainty. If the optimum is outside of the last box, a box of the last
/// width, moved towards the optimum.
fn next_region(region: &Region, x: &DVector<f64>, covariance: &DMatrix<f64>) -> Region {
    /// Half width of a box in standard deviations.
    const WIDTH: f64 = 2.5;
    /// Least and largest width of a box relative to the last one. It must be able to grow: a surface is not valid far
    /// outside its box, which would cut off the band of a parameter that the points hardly determine.
    const RANGE: [f64; 2] = [0.2, 2.0];
    let coordinates = coordinates(region, x, covariance);
    let axes = || {
        coordinates
            .iter()
            .zip(region.centre.iter().zip(&region.half_width))
    };
    Region {
        centre: axes()
            .map(|([at, _], (centre, width))| at.clamp(centre - width, centre + width))
            .collect(),
        half_width: axes()
            .map(|([at, deviation], (centre, width))| {
                if (at - centre).abs() > *width {
                    *width
                } else {
                    (WIDTH * deviation).clamp(RANGE[0] * width, RANGE[1] * width)
                }
            })
            .collect(),
    }
}

/// Whether the optimum is well inside its box.
fn is_settled(region: &Region, x: &DVector<f64>, covariance: &DMatrix<f64>) -> bool {
    /// Distance of the optimum from the centre, in half widths.
    const OFF: f64 = 0.5;
    let coordinates = coordinates(region, x, covariance);
    let at: Vec<f64> = coordinates.iter().map(|[at, _]| *at).collect();
    region.normalised(&at).iter().all(|u| u.abs() <= OFF)
}
