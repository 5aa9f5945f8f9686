//! Optimal design of a calibration within the limits of a rig.

use crate::error;
use asperity::LoadedCase;
use asperity::case::CalibratedName;
use asperity::message::Warning;
use asperity::result::SCHEMA_VERSION;
use asperity_core::numerics::Z_95;
use asperity_core::{Code, Estimate, EstimateKeys, Fault, PROGRAM};
use nalgebra::{DMatrix, DVector};
use serde::{Deserialize, Serialize};

use crate::birge::Scatter;
use crate::identifiability::{lambda_star_range, missing_for_share};
use crate::information::{covariance, deviation_without_prior, information};
use crate::optimal_design::d_optimal;
use crate::parameters::Parameter;
use crate::problem::{Observation, Problem};
use crate::result::{IdentifiedParameter, Ranged};
use crate::rig::parameters;
use crate::rig_model::{OperatingPoint, PointLosses, Progress, RigModel};
use crate::simulate::{Simulated, losses};
use crate::surfaces::{slope_region, tangents};

/// Limits of a rig.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Limits {
    /// Available torques \[N m\].
    pub torques_nm: Vec<f64>,
    /// Available speeds \[1/min\].
    pub speeds_rpm: Vec<f64>,
    /// Available temperatures \[°C\].
    pub temperatures_c: Vec<f64>,
    /// Measuring time in hours, without heating.
    pub hours: f64,
    /// Minutes per point.
    pub minutes_per_point: f64,
    /// Standard deviation of a point relative to its loss.
    pub sigma: f64,
    /// Number of assemblies; each measures all points.
    pub assemblies: usize,
}

/// Design of a calibration.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct Design {
    /// Version of this structure.
    pub schema_version: u32,
    /// Program and version.
    pub program: String,
    /// Title of the case.
    pub title: String,
    /// Boundary friction, positions and offsets of the losses, in words.
    pub settings: String,
    /// The limits.
    pub limits: Limits,
    /// Points of each assembly, by temperature.
    pub points: Vec<DesignPoint>,
    /// Smallest and largest Λ* of the points.
    pub lambda_star: Option<[f64; 2]>,
    /// Expected result for the parameters, with their priors.
    pub parameters: Vec<ExpectedParameter>,
    /// Number of candidate points.
    pub candidates: usize,
    /// Warnings.
    pub warnings: Vec<Warning>,
    /// Simulated losses at the points \[W\], as [`simulated`] gives them, for a table of their own.
    #[serde(skip)]
    pub simulated_w: Option<Vec<f64>>,
}

/// Point to measure.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct DesignPoint {
    /// Torque \[N m\].
    pub torque_nm: f64,
    /// Speed \[1/min\].
    pub speed_rpm: f64,
    /// Temperature \[°C\].
    pub temperature_c: f64,
    /// Number of measurements by each assembly.
    pub repeats: usize,
    /// Loss of the mesh by the model \[W\].
    pub loss_w: f64,
    /// Median of Λ* over the path.
    pub lambda_star: Option<f64>,
}

/// Expected result for a parameter.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct ExpectedParameter {
    /// Key, standard deviation without its prior, verdict.
    #[serde(flatten)]
    pub identified: IdentifiedParameter,
    /// Value of the case in SI units with its expected 5 % and 95 % quantile, its prior included.
    #[serde(flatten, with = "Ranged")]
    pub expected: Estimate,
    /// Range of a case without calibration.
    pub default_range: [f64; 2],
}

/// The settings of a case that change its losses as much as the points do, in words.
fn settings_of(case: &LoadedCase) -> String {
    let model = &case.case.model;
    format!(
        "boundary friction {}, {}",
        model.boundary_friction,
        case.case.sampling()
    )
}

/// Evaluations of the model for a design: of every point, and of its plane over parameters and temperature.
fn evaluations(points: usize, parameters: usize) -> usize {
    points * (1 + (parameters + 2))
}

/// Chooses the D-optimal points within `limits` for the parameters of `case` that are not `held`. The points of the
/// smallest and the largest Λ* are always included. If the limits do not identify the boundary share, the boundary layer
/// is held and a warning states what is missing.
///
/// # Errors
/// When the limits leave no candidates or too few points, or the model has no solution at a point.
pub fn plan(
    case: &LoadedCase,
    limits: &Limits,
    held: &[CalibratedName],
    watch: asperity::pipeline::Progress<'_>,
) -> Result<Design, Fault> {
    let count = points_per_assembly(limits)?;
    let mut fitted = parameters(case, held)?;
    let operating_points = grid(limits);
    let total = evaluations(operating_points.len(), fitted.len());
    let progress: Progress<'_> = &|done| watch(done, total);
    let model = RigModel::new(std::slice::from_ref(case), &[], &operating_points)?;
    let nominal: Vec<PointLosses> = model.evaluate(&[vec![0.0]], progress)?.concat();
    let lambda_stars: Vec<_> = operating_points
        .iter()
        .zip(&nominal)
        .map(|(point, parts)| (point.at, parts.lambda_star))
        .collect();
    let mut warnings = Vec::new();
    let missing = missing_for_share(&fitted, &lambda_stars);
    if !missing.is_empty() {
        let held = [held, &[CalibratedName::BoundaryLayer]].concat();
        fitted = parameters(case, &held)?;
        warnings.push(Warning::new(
            Code::W436,
            format!(
                "the boundary layer is fixed, because points within these limits do not identify it: {}; state the largest torque and speed and the temperatures of the rig if it reaches further",
                missing.join("; ")
            ),
        ));
    }
    let rows = count * limits.assemblies;
    if rows < fitted.len() + Scatter::LEAST_FREEDOM {
        return Err(error::limit(
            "points",
            rows as f64,
            "are too few to confirm the errors; give more hours or fewer minutes per point",
        ));
    }
    let model = model.with_parameters(&fitted);
    let region = slope_region(&fitted);
    let planes = tangents(&model, &region, progress)?;
    // Fewer evaluations where the boundary layer was held meanwhile.
    watch(total, total);
    let priors: Vec<f64> = fitted.iter().map(|parameter| parameter.prior).collect();
    let observation = |point: usize, assembly: usize| Observation {
        point,
        assembly,
        log_loss: (nominal[point].sliding_w + nominal[point].rolling_w).ln(),
        sigma: limits.sigma,
        omega: operating_points[point].at[1] * std::f64::consts::PI / 30.0,
        bearing_torque: 0.0,
    };
    let all = (0..limits.assemblies).flat_map(|assembly| {
        (0..operating_points.len()).map(move |point| observation(point, assembly))
    });
    let problem = Problem::new(&planes, &region, &priors, all.collect());
    let chosen = chosen(&problem, operating_points.len(), count, &nominal);
    let measured: Vec<Observation> = (0..limits.assemblies)
        .flat_map(|assembly| chosen.iter().map(move |point| (*point, assembly)))
        .map(|(point, assembly)| observation(point, assembly))
        .collect();
    let expected = expected(&fitted, &problem, measured);
    let mut numbers: Vec<usize> = chosen.clone();
    let order = |point: usize| {
        let [torque, speed, temperature] = operating_points[point].at;
        [temperature, torque, speed]
    };
    numbers.sort_by(|a, b| {
        order(*a)
            .partial_cmp(&order(*b))
            .unwrap_or(std::cmp::Ordering::Equal)
    });
    numbers.dedup();
    let point = |number: &usize| {
        let [torque_nm, speed_rpm, temperature_c] = operating_points[*number].at;
        let parts = &nominal[*number];
        DesignPoint {
            torque_nm,
            speed_rpm,
            temperature_c,
            repeats: chosen.iter().filter(|other| *other == number).count(),
            loss_w: parts.sliding_w + parts.rolling_w,
            lambda_star: parts.lambda_star,
        }
    };
    Ok(Design {
        schema_version: SCHEMA_VERSION,
        program: PROGRAM.to_owned(),
        title: case.case.title.clone(),
        settings: settings_of(case),
        limits: limits.clone(),
        lambda_star: lambda_star_range(numbers.iter().map(|number| nominal[*number].lambda_star)),
        points: numbers.iter().map(point).collect(),
        parameters: expected,
        candidates: operating_points.len(),
        warnings,
        simulated_w: None,
    })
}

/// Number of points per assembly in the measuring time.
fn points_per_assembly(limits: &Limits) -> Result<usize, Fault> {
    let refuse = |name, value, rule| Err(error::limit(name, value, rule));
    for (name, value) in [
        ("hours", limits.hours),
        ("minutes of a point", limits.minutes_per_point),
    ] {
        if !(value.is_finite() && value > 0.0) {
            return refuse(name, value, "must be positive");
        }
    }
    if !(5e-4..=0.5).contains(&limits.sigma) {
        return refuse("sigma", limits.sigma, "must be 0.05 to 50 %");
    }
    if limits.assemblies == 0 {
        return refuse("assemblies", 0.0, "must be 1 or more");
    }
    for (name, values) in [
        ("torques", &limits.torques_nm),
        ("speeds", &limits.speeds_rpm),
        ("temperatures", &limits.temperatures_c),
    ] {
        if values.is_empty() {
            return refuse(name, 0.0, "at least one is required");
        }
    }
    if let Some(speed) = limits.speeds_rpm.iter().find(|speed| **speed <= 0.0) {
        return refuse("speeds", *speed, "must be positive");
    }
    if let Some(torque) = limits.torques_nm.iter().find(|torque| **torque == 0.0) {
        return refuse("torques", *torque, "must not be 0");
    }
    /// Least and largest number of points per assembly.
    const POINTS: [f64; 2] = [5.0, 500.0];
    let points =
        (60.0 * limits.hours / limits.minutes_per_point / limits.assemblies as f64).floor();
    if points < POINTS[0] {
        return refuse(
            "points of an assembly",
            points,
            "5 or more are required; give more hours or fewer minutes per point",
        );
    }
    Ok(points.min(POINTS[1]) as usize)
}

fn grid(limits: &Limits) -> Vec<OperatingPoint> {
    let mut points = Vec::new();
    for torque in &limits.torques_nm {
        for speed in &limits.speeds_rpm {
            points.extend(
                limits
                    .temperatures_c
                    .iter()
                    .map(|temperature| OperatingPoint {
                        case: 0,
                        at: [*torque, *speed, *temperature],
                    }),
            );
        }
    }
    points
}

/// Derivatives of the measurements of a point by all assemblies, in standard deviations.
fn slopes(problem: &Problem<'_>, point: usize) -> DMatrix<f64> {
    let x = DVector::zeros(problem.variables());
    let of_point = problem
        .observations
        .iter()
        .filter(|observation| observation.point == point);
    let rows: Vec<_> = of_point
        .map(|observation| (problem.predicted(&x, observation).1 / observation.sigma).transpose())
        .collect();
    DMatrix::from_rows(&rows)
}

/// Information of the priors only.
fn of_priors(problem: &Problem<'_>) -> DMatrix<f64> {
    let none = problem.with(Vec::new());
    information(&none.slopes(&DVector::zeros(problem.variables())))
}

fn chosen(
    problem: &Problem<'_>,
    candidates: usize,
    count: usize,
    nominal: &[PointLosses],
) -> Vec<usize> {
    let information_of: Vec<DMatrix<f64>> = (0..candidates)
        .map(|point| slopes(problem, point))
        .collect();
    let ratio = |point: &usize| nominal[*point].lambda_star.unwrap_or(f64::NAN);
    let least = (0..candidates).min_by(|a, b| ratio(a).total_cmp(&ratio(b)));
    let most = (0..candidates).max_by(|a, b| ratio(a).total_cmp(&ratio(b)));
    let mut ends: Vec<usize> = least.into_iter().chain(most).collect();
    ends.dedup();
    let of_ends: DMatrix<f64> = ends.iter().fold(of_priors(problem), |sum, point| {
        sum + information(&information_of[*point])
    });
    // Distinct points also test the model, repeated points do not: a point is repeated only if there are fewer
    // candidates than points.
    let repeats = count.div_ceil(candidates.max(1));
    let others: Vec<usize> = (0..candidates)
        .filter(|point| !ends.contains(point))
        .collect();
    let of_others: Vec<DMatrix<f64>> = others
        .iter()
        .map(|point| information_of[*point].clone())
        .collect();
    let rest = count.saturating_sub(ends.len());
    let best = d_optimal(&of_others, rest, repeats, problem.parameters(), &of_ends);
    ends.extend(best.into_iter().map(|k| others[k]));
    ends
}

fn expected(
    parameters: &[Parameter],
    problem: &Problem<'_>,
    measured: Vec<Observation>,
) -> Vec<ExpectedParameter> {
    let part = problem.with(measured);
    let whole = information(&part.slopes(&DVector::zeros(part.variables())));
    let spread = covariance(&whole);
    let one = |(k, parameter): (usize, &Parameter)| {
        let deviation = deviation_without_prior(&whole, k, parameter.prior);
        let width = spread
            .as_ref()
            .map_or(parameter.prior, |covariance| covariance[(k, k)].sqrt());
        ExpectedParameter {
            identified: IdentifiedParameter {
                key: parameter.name.key().to_owned(),
                name: parameter.words().to_owned(),
                deviation,
                prior: parameter.prior,
                verdict: crate::identifiability::verdict(deviation, parameter.prior),
            },
            expected: Estimate::new(
                parameter.default.value,
                [-Z_95, Z_95].map(|z| parameter.default.value * (z * width).exp()),
            ),
            default_range: parameter.default.ends(),
        }
    };
    parameters.iter().enumerate().map(one).collect()
}

/// Simulated losses \[W\] at the points of `design` with `case` and the errors of [`losses`], by assembly; a repeated
/// point has several losses.
///
/// # Errors
/// When the model has no solution at a point.
pub fn simulated(case: &LoadedCase, design: &Design, seed: u64) -> Result<Vec<f64>, Fault> {
    let at = |point: &DesignPoint| [point.torque_nm, point.speed_rpm, point.temperature_c];
    let operating_points: Vec<OperatingPoint> = design
        .points
        .iter()
        .map(|point| OperatingPoint {
            case: 0,
            at: at(point),
        })
        .collect();
    let model = RigModel::new(std::slice::from_ref(case), &[], &operating_points)?;
    let measured: Vec<Simulated> = design
        .rows()
        .map(|(point, assembly)| Simulated {
            point,
            assembly,
            omega: design.points[point].speed_rpm * std::f64::consts::PI / 30.0,
        })
        .collect();
    losses(&model, &[], &measured, design.limits.sigma, seed)
}

impl Design {
    /// Index of the point and of the assembly of every row to measure.
    pub fn rows(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        (0..self.limits.assemblies).flat_map(move |assembly| {
            self.points
                .iter()
                .enumerate()
                .flat_map(move |(number, point)| {
                    std::iter::repeat_n((number, assembly), point.repeats)
                })
        })
    }

    /// Number of measurements of all assemblies.
    #[must_use]
    pub fn size(&self) -> usize {
        self.points.iter().map(|point| point.repeats).sum::<usize>() * self.limits.assemblies
    }
}
