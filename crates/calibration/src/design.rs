//! Points that find the parameters best, within the limits of a rig.

use asperity::LoadedCase;
use asperity::case::CalibratedName;
use nalgebra::{DMatrix, DVector};
use serde::{Deserialize, Serialize};

use crate::error::CalibrationError;
use crate::identifiability::{check_share, swept};
use crate::information::{covariance, deviation_without_prior, information};
use crate::optimal_design::d_optimal;
use crate::parameters::Parameter;
use crate::problem::{Observation, Problem};
use crate::result::{IdentifiedParameter, SCHEMA_VERSION};
use crate::rig::parameters;
use crate::rig_model::{Parts, RigModel, Told, Wanted};
use crate::simulate::{Simulated, losses};
use crate::surfaces::{slope_region, tangents};

/// Limits of a rig.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Limits {
    /// Torques that may be set \[N m\].
    pub torques_nm: Vec<f64>,
    /// Speeds that may be set \[1/min\].
    pub speeds_rpm: Vec<f64>,
    /// Temperatures that may be set \[°C\].
    pub temperatures_c: Vec<f64>,
    /// Hours of measuring, heating left out.
    pub hours: f64,
    /// Minutes of a point.
    pub minutes_per_point: f64,
    /// Standard deviation of a point over its loss.
    pub sigma: f64,
    /// Assemblies, which all measure the same points.
    pub assemblies: usize,
}

/// A design.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct Design {
    /// Version of this structure.
    pub schema_version: u32,
    /// The program and its version.
    pub program: String,
    /// Title of the case.
    pub title: String,
    /// The limits.
    pub limits: Limits,
    /// Points of each assembly, temperature by temperature.
    pub points: Vec<DesignPoint>,
    /// Smallest and largest Λ* of the points.
    pub lambda_star: Option<[f64; 2]>,
    /// What they would find, with their priors.
    pub parameters: Vec<ExpectedParameter>,
    /// Measurements that were chosen from.
    pub candidates: usize,
}

/// A point to measure.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct DesignPoint {
    /// Torque \[N m\].
    pub torque_nm: f64,
    /// Speed \[1/min\].
    pub speed_rpm: f64,
    /// Temperature \[°C\].
    pub temperature_c: f64,
    /// How often each assembly measures it.
    pub repeats: usize,
    /// Loss of the mesh by the model \[W\].
    pub loss_w: f64,
    /// Λ*, median over the path.
    pub lambda_star: Option<f64>,
}

/// What a design would find.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct ExpectedParameter {
    /// Key, standard deviation without its own prior, verdict.
    #[serde(flatten)]
    pub identified: IdentifiedParameter,
    /// Value of the case in SI units.
    pub value: f64,
    /// Expected 95 % band, its prior included.
    pub band: [f64; 2],
    /// Range of a case without calibration.
    pub default_range: [f64; 2],
}

/// z of a 95 % band.
const BAND: f64 = 1.959_963_984_540_054;

/// Proposes the points for `case` that find the parameters which are not `held` best within `limits` (D-optimal),
/// those of least and largest Λ* among them.
///
/// # Errors
/// When the limits leave nothing to choose from or cannot find the share, or the model has no solution at a point.
pub fn plan(
    case: &LoadedCase,
    limits: &Limits,
    held: &[CalibratedName],
    told: Told<'_>,
) -> Result<Design, CalibrationError> {
    let count = points_of(limits)?;
    let parameters = parameters(case, held)?;
    let wanted = grid(limits);
    let model = RigModel::new(std::slice::from_ref(case), &parameters, &wanted)?;
    let centre = vec![0.0; parameters.len() + 1];
    let nominal: Vec<Parts> = model
        .evaluate(&[centre], told)?
        .into_iter()
        .flatten()
        .collect();
    let reach: Vec<_> = wanted
        .iter()
        .zip(&nominal)
        .map(|(point, parts)| (point.at, parts.lambda_star))
        .collect();
    check_share(&case.case.title, &parameters, &reach)?;
    let region = slope_region(&parameters);
    let planes = tangents(&model, &region, told)?;
    let priors: Vec<f64> = parameters.iter().map(Parameter::prior).collect();
    let seen = |point: usize, assembly: usize| Observation {
        point,
        assembly,
        log_loss: (nominal[point].sliding_w + nominal[point].rolling_w).ln(),
        sigma: limits.sigma,
        omega: wanted[point].at[1] * std::f64::consts::PI / 30.0,
        bearing_torque: 0.0,
    };
    let all = (0..limits.assemblies)
        .flat_map(|assembly| (0..wanted.len()).map(move |point| seen(point, assembly)));
    let problem = Problem::new(&planes, &region, &priors, all.collect());
    let chosen = chosen(&problem, wanted.len(), count, &nominal);
    let measured: Vec<Observation> = (0..limits.assemblies)
        .flat_map(|assembly| chosen.iter().map(move |point| (*point, assembly)))
        .map(|(point, assembly)| seen(point, assembly))
        .collect();
    let expected = expected(&parameters, &problem, measured);
    let mut numbers: Vec<usize> = chosen.clone();
    let order = |point: usize| {
        let [torque, speed, temperature] = wanted[point].at;
        [temperature, torque, speed]
    };
    numbers.sort_by(|a, b| {
        order(*a)
            .partial_cmp(&order(*b))
            .unwrap_or(std::cmp::Ordering::Equal)
    });
    numbers.dedup();
    let point = |number: &usize| {
        let [torque_nm, speed_rpm, temperature_c] = wanted[*number].at;
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
        program: format!("asperity {}", env!("CARGO_PKG_VERSION")),
        title: case.case.title.clone(),
        limits: limits.clone(),
        lambda_star: swept(numbers.iter().map(|number| nominal[*number].lambda_star)),
        points: numbers.iter().map(point).collect(),
        parameters: expected,
        candidates: wanted.len(),
    })
}

/// Points of an assembly in the hours of a rig.
fn points_of(limits: &Limits) -> Result<usize, CalibrationError> {
    let refuse = |name, value, rule| Err(CalibrationError::Limit { name, value, rule });
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
            return refuse(name, 0.0, "at least one is needed");
        }
    }
    if let Some(speed) = limits.speeds_rpm.iter().find(|speed| **speed <= 0.0) {
        return refuse("speeds", *speed, "must be positive");
    }
    if let Some(torque) = limits.torques_nm.iter().find(|torque| **torque == 0.0) {
        return refuse("torques", *torque, "must not be 0");
    }
    /// Fewest and most points of an assembly.
    const POINTS: [f64; 2] = [5.0, 500.0];
    let points =
        (60.0 * limits.hours / limits.minutes_per_point / limits.assemblies as f64).floor();
    if points < POINTS[0] {
        return refuse(
            "points of an assembly",
            points,
            "5 or more are needed; give more hours, or fewer minutes a point",
        );
    }
    Ok(points.min(POINTS[1]) as usize)
}

fn grid(limits: &Limits) -> Vec<Wanted> {
    let mut found = Vec::new();
    for torque in &limits.torques_nm {
        for speed in &limits.speeds_rpm {
            found.extend(limits.temperatures_c.iter().map(|temperature| Wanted {
                case: 0,
                at: [*torque, *speed, *temperature],
            }));
        }
    }
    found
}

/// The slopes of a measurement by every assembly, in standard deviations.
fn slopes(problem: &Problem<'_>, point: usize) -> DMatrix<f64> {
    let x = DVector::zeros(problem.variables());
    let of_point = problem
        .observations
        .iter()
        .filter(|seen| seen.point == point);
    let rows: Vec<_> = of_point
        .map(|seen| (problem.predicted(&x, seen).1 / seen.sigma).transpose())
        .collect();
    DMatrix::from_rows(&rows)
}

/// Information of the priors alone.
fn of_priors(problem: &Problem<'_>) -> DMatrix<f64> {
    let none = problem.with(Vec::new());
    let none = Problem {
        assemblies: problem.assemblies,
        ..none
    };
    information(&none.slopes(&DVector::zeros(problem.variables())))
}

fn chosen(problem: &Problem<'_>, candidates: usize, count: usize, nominal: &[Parts]) -> Vec<usize> {
    let each: Vec<DMatrix<f64>> = (0..candidates)
        .map(|point| slopes(problem, point))
        .collect();
    let ratio = |point: &usize| nominal[*point].lambda_star.unwrap_or(f64::NAN);
    let least = (0..candidates).min_by(|a, b| ratio(a).total_cmp(&ratio(b)));
    let most = (0..candidates).max_by(|a, b| ratio(a).total_cmp(&ratio(b)));
    let mut ends: Vec<usize> = least.into_iter().chain(most).collect();
    ends.dedup();
    let of_ends: DMatrix<f64> = ends.iter().fold(of_priors(problem), |sum, point| {
        sum + information(&each[*point])
    });
    // Points that lie apart also tell whether the model holds, which repeats do not: a point is repeated only where
    // there are fewer candidates than points.
    let repeats = count.div_ceil(candidates.max(1));
    let others: Vec<usize> = (0..candidates)
        .filter(|point| !ends.contains(point))
        .collect();
    let of_others: Vec<DMatrix<f64>> = others.iter().map(|point| each[*point].clone()).collect();
    let rest = count.saturating_sub(ends.len());
    let best = d_optimal(&of_others, (rest, repeats), problem.parameters(), &of_ends);
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
        let deviation = deviation_without_prior(&whole, k, parameter.prior());
        let width = spread
            .as_ref()
            .map_or(parameter.prior(), |found| found[(k, k)].sqrt());
        ExpectedParameter {
            identified: IdentifiedParameter {
                key: parameter.name.key().to_owned(),
                name: parameter.words().to_owned(),
                deviation,
                prior: parameter.prior(),
                verdict: crate::identifiability::verdict(deviation, parameter.prior()),
            },
            value: parameter.centre,
            band: [-BAND, BAND].map(|z| parameter.centre * (z * width).exp()),
            default_range: parameter.range,
        }
    };
    parameters.iter().enumerate().map(one).collect()
}

/// Losses \[W\] that a rig might measure at the points of `design` with `case`: assembly by assembly, a point as often
/// as it is repeated. Simulated, with the errors of [`losses`].
///
/// # Errors
/// When the model has no solution at a point.
pub fn simulated(
    case: &LoadedCase,
    design: &Design,
    seed: u64,
) -> Result<Vec<f64>, CalibrationError> {
    let at = |point: &DesignPoint| [point.torque_nm, point.speed_rpm, point.temperature_c];
    let wanted: Vec<Wanted> = design
        .points
        .iter()
        .map(|point| Wanted {
            case: 0,
            at: at(point),
        })
        .collect();
    let model = RigModel::new(std::slice::from_ref(case), &[], &wanted)?;
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
    /// Number of the point and of the assembly of every row to measure.
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

    /// Measurements of all assemblies.
    #[must_use]
    pub fn size(&self) -> usize {
        self.points.iter().map(|point| point.repeats).sum::<usize>() * self.limits.assemblies
    }
}
