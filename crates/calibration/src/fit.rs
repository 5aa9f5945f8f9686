//! The fit: stages, then all together, on response surfaces that are made anew about the optimum until it stays.

use asperity::case::CalibratedName;
use nalgebra::{DMatrix, DVector};

use crate::error::CalibrationError;
use crate::information::{covariance, information};
use crate::least_squares::{Minimum, minimum};
use crate::parameters::TEMPERATURE;
use crate::problem::{Observation, PointSurfaces, Problem};
use crate::profile_likelihood::{ProfileBand, profile_band};
use crate::response::Region;
use crate::result::StageRow;
use crate::rig::Rig;
use crate::rig_model::Told;
use crate::surfaces::surfaces;

/// Share of the load on the boundary layer below which a point is of the film.
const FILM: f64 = 0.02;
/// Part of the largest such share from which a point is of the boundary layer.
const PLATEAU: f64 = 0.5;

/// A fit with the surfaces that it was made on.
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
    /// The variables: logarithms of the parameters over their centres, then nuisance terms.
    pub minimum: Minimum,
    /// Their covariance.
    pub covariance: DMatrix<f64>,
    /// Fits before the last one.
    pub stages: Vec<StageRow>,
    /// Surfaces made one after the other.
    pub rounds: usize,
    /// Whether the optimum stayed well inside the last of them.
    pub is_settled: bool,
}

impl Fit {
    /// The residuals that were minimised.
    #[must_use]
    pub fn problem(&self) -> Problem<'_> {
        Problem::new(
            &self.surfaces,
            &self.region,
            &self.priors,
            self.observations.clone(),
        )
    }

    /// Standard deviation of a variable.
    #[must_use]
    pub fn deviation(&self, k: usize) -> f64 {
        self.covariance[(k, k)].sqrt()
    }

    /// The band of parameter `k` by its profile likelihood, in logarithms over its centre.
    ///
    /// # Errors
    /// When a fit on the way does not converge.
    pub fn band(&self, k: usize) -> Result<ProfileBand, CalibrationError> {
        let problem = self.problem();
        let free: Vec<usize> = (0..problem.variables()).filter(|j| *j != k).collect();
        profile_band(self.minimum.x[k], self.deviation(k), |value| {
            let mut start = self.minimum.x.clone();
            // The others follow along the covariance, which is nearly where they end.
            let step = value - start[k];
            let along = self.covariance.column(k) * (step / self.covariance[(k, k)]);
            start += along;
            start[k] = value;
            Ok(minimum(&problem, &start, &free)?.squares - self.minimum.squares)
        })
    }
}

impl Rig {
    /// Fits the measurements, beginning on `first` surfaces.
    ///
    /// # Errors
    /// When a fit does not converge, or the model has no solution at a point.
    pub fn fit(
        &self,
        observations: Vec<Observation>,
        first: (Region, Vec<PointSurfaces>),
        told: Told<'_>,
    ) -> Result<Fit, CalibrationError> {
        /// Surfaces that are made at most.
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
            let found = minimum(&problem, &begin, &all)?;
            let covariance = spread(&problem, &found)?;
            let is_settled = rounds > 1 && is_settled(&region, &found.x, &covariance);
            if is_settled || rounds == MOST_ROUNDS {
                return Ok(Fit {
                    region,
                    surfaces: made,
                    priors,
                    observations,
                    minimum: found,
                    covariance,
                    stages,
                    rounds,
                    is_settled,
                });
            }
            let next = next_region(&region, &found.x, &covariance);
            region = next;
            made = surfaces(&self.model, &region, told)?;
            start = Some(found.x);
            rounds += 1;
        }
    }

    /// Film traction from points without asperities, boundary friction from those where it has most of the load,
    /// the boundary layer from all: the start of the whole fit.
    fn staged(
        &self,
        problem: &Problem<'_>,
    ) -> Result<(DVector<f64>, Vec<StageRow>), CalibrationError> {
        use CalibratedName::{BoundaryFriction, BoundaryLayer, EyringStress, LimitingShear};
        let share = |seen: &Observation| self.nominal[seen.point].boundary_share;
        let most = problem.observations.iter().map(share).fold(0.0, f64::max);
        let film = |seen: &Observation| share(seen) < FILM;
        let plateau = |seen: &Observation| share(seen) >= PLATEAU * most;
        let every = |_: &Observation| true;
        type Kept<'a> = &'a dyn Fn(&Observation) -> bool;
        let plan: [(&str, Kept<'_>, &[CalibratedName]); 3] = [
            (
                "film traction, from points without asperities",
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
        for (name, kept, names) in plan {
            let of_stage = |k: &usize| names.contains(&self.parameters[*k].name);
            let free: Vec<usize> = (0..self.parameters.len()).filter(of_stage).collect();
            let taken: Vec<Observation> = problem
                .observations
                .iter()
                .filter(|seen| kept(seen))
                .copied()
                .collect();
            if free.is_empty() || taken.len() <= free.len() {
                continue;
            }
            let points = taken.len();
            let mut part = problem.with(taken);
            // Assemblies keep their numbers.
            part.assemblies = problem.assemblies;
            x = minimum(&part, &x, &free)?.x;
            let value = |k: &usize| {
                let parameter = &self.parameters[*k];
                (parameter.words().to_owned(), parameter.centre * x[*k].exp())
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
pub(crate) fn spread(
    problem: &Problem<'_>,
    found: &Minimum,
) -> Result<DMatrix<f64>, CalibrationError> {
    // Every variable has a prior, so that only rounding could make this singular.
    covariance(&information(&problem.slopes(&found.x))).ok_or_else(|| {
        CalibrationError::NotConverged {
            reason: "the information of the fit is singular".to_owned(),
        }
    })
}

/// The parameters and the offset of the temperature, as the surfaces take them, with their standard deviations.
fn places(region: &Region, x: &DVector<f64>, covariance: &DMatrix<f64>) -> Vec<[f64; 2]> {
    let n = region.centre.len() - 1;
    let place = |k: usize| {
        let unit = if k < n { 1.0 } else { TEMPERATURE };
        [unit * x[k], unit * covariance[(k, k)].sqrt()]
    };
    (0..=n).map(place).collect()
}

/// The box about the optimum, as wide as its uncertainty; where the optimum lies beyond the last box, a step towards
/// it as wide as that.
fn next_region(region: &Region, x: &DVector<f64>, covariance: &DMatrix<f64>) -> Region {
    /// Standard deviations of half a box, and its least share of the last.
    const WIDTH: f64 = 2.5;
    const LEAST: f64 = 0.2;
    let found = places(region, x, covariance);
    let axes = || {
        found
            .iter()
            .zip(region.centre.iter().zip(&region.half_width))
    };
    Region {
        centre: axes()
            .map(|([at, _], (centre, width))| at.clamp(centre - width, centre + width))
            .collect(),
        half_width: axes()
            .map(
                |([at, deviation], (centre, width))| match (at - centre).abs() > *width {
                    true => *width,
                    false => (WIDTH * deviation).clamp(LEAST * width, *width),
                },
            )
            .collect(),
    }
}

/// Whether the optimum lies well inside its box.
fn is_settled(region: &Region, x: &DVector<f64>, covariance: &DMatrix<f64>) -> bool {
    /// Half-widths that the optimum may lie off the middle.
    const OFF: f64 = 0.5;
    let found = places(region, x, covariance);
    let at: Vec<f64> = found.iter().map(|[at, _]| *at).collect();
    region.place(&at).iter().all(|u| u.abs() <= OFF)
}
