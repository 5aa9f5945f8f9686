//! Plan of traction measurements: curves to measure, the error of each constant that they would leave, and the points that
//! narrow the loss of a case most.
//!
//! The standard plan has three temperatures, two loads, two speeds and ten slide-to-roll ratios, both signs of each.

use asperity::{Contacts, LoadedCase};
use asperity_core::quantity::Length;
use asperity_core::task::try_par_map;
use asperity_core::{Fault, PROGRAM};
use nalgebra::{DMatrix, DVector};
use serde::{Deserialize, Serialize};

use super::base::OilBase;
use super::case_loss::loss_slopes;
use super::fit::{PointErrors, expected_covariance, planned};
use super::grid::OilGrid;
use super::helpful;
use super::machine::Machine;
use super::problem::{CONSTANTS, FACTOR, Priors, STATED, STATED_CONSTANTS, Zero, distinct};
use super::reading::SetPoint;
use super::selection::{Dropped, Judged, judge};
use super::simulate::simulated;
use crate::information::information;
use crate::least_squares::Residuals;
use crate::optimal_design::d_optimal;

/// Slide-to-roll ratios of a curve.
const SLIDES: &[f64] = &[0.01, 0.02, 0.03, 0.05, 0.07, 0.1, 0.15, 0.2, 0.3, 0.5];
/// Temperatures \[°C\] of the plans.
const TEMPERATURES: &[f64] = &[40.0, 80.0, 120.0];
const ONE_CURVE: OilGrid<'static> = OilGrid {
    loads: &[30.0],
    speeds: &[2.0],
    slides: SLIDES,
    temperatures: &[100.0],
};
const THREE_CURVES: OilGrid<'static> = OilGrid {
    temperatures: TEMPERATURES,
    ..ONE_CURVE
};
const STANDARD: OilGrid<'static> = OilGrid {
    loads: &[20.0, 60.0],
    speeds: &[1.0, 3.0],
    slides: SLIDES,
    temperatures: TEMPERATURES,
};
/// Curves of a small ball, at about 2 GPa.
const SMALL_BALL: OilGrid<'static> = OilGrid {
    loads: &[75.0],
    speeds: &[3.0],
    slides: SLIDES,
    temperatures: TEMPERATURES,
};
/// Stage of one curve.
const ONE: &str = "one curve";
/// Stage of the standard plan.
pub const WHOLE: &str = "standard plan";
/// Radius of the small ball.
const SMALL_RADIUS: Length = Length::from_si(4.75e-3);
/// Minutes of a curve with both signs, and of heating to a temperature.
const MINUTES: [f64; 2] = [4.0, 15.0];
/// Points chosen one by one.
const CHOSEN: usize = 10;

/// Settings of a plan.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlanSettings {
    /// The machine.
    pub machine: Machine,
    /// Whether the priors leave the constants to the points.
    pub is_wide: bool,
    /// Zeros of the friction.
    pub zero: Zero,
    /// Errors of the points.
    pub errors: PointErrors,
    /// Seed of simulated readings of the standard plan.
    pub simulate: Option<u64>,
}

/// Error of a constant that points would leave.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct ExpectedError {
    /// Key.
    pub key: String,
    /// Standard deviation: of the logarithm, or in 1/K of the temperature coefficient.
    pub deviation: f64,
    /// The same over its value before any test.
    pub share: f64,
}

/// Amount of measurement with the errors that it would leave.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct Stage {
    /// Name.
    pub name: String,
    /// Points that the law of the film describes, each with both signs of the slide-to-roll ratio.
    pub points: usize,
    /// Duration \[min\], with heating.
    pub minutes: f64,
    /// Errors of the constants.
    pub constants: Vec<ExpectedError>,
    /// Standard deviation of the logarithm of the loss of the case by these constants; `None` without a case.
    pub loss_deviation: Option<f64>,
}

/// Curve of the plan.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct PlannedCurve {
    /// Temperature \[°C\].
    pub temperature_c: f64,
    /// Load \[N\].
    pub load_n: f64,
    /// Mean speed \[m/s\].
    pub mean_speed_m_s: f64,
    /// Largest Hertz pressure \[GPa\].
    pub pressure_gpa: f64,
    /// Smallest film over roughness.
    pub film_ratio: f64,
    /// Slide-to-roll ratios to measure \[%\], both signs; empty if the curve is left out.
    pub slides_percent: Vec<f64>,
    /// Rules that leave points out.
    pub dropped: Vec<Dropped>,
}

/// Point to measure.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct PlannedPoint {
    /// Load \[N\].
    pub load_n: f64,
    /// Mean speed \[m/s\].
    pub mean_speed_m_s: f64,
    /// Slide-to-roll ratio \[%\].
    pub slide_roll_percent: f64,
    /// Temperature \[°C\].
    pub temperature_c: f64,
    /// Friction with the constants before any test.
    pub expected_traction: f64,
    /// Film over roughness.
    pub film_ratio: f64,
    /// Simulated friction, with the errors of a machine.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub simulated_traction: Option<f64>,
}

/// Plan of traction measurements.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct OilPlan {
    /// Program and version.
    pub program: String,
    /// Title.
    pub title: String,
    /// Name of the oil.
    pub oil: String,
    /// Case whose loss is narrowed.
    pub case: Option<String>,
    /// Changes of the logarithm of its loss by a standard deviation of each constant before any test.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub loss_slopes: Option<[f64; CONSTANTS]>,
    /// Width of the interval of ln loss that the standard plan leaves, over its present width, as `asperity evidence`
    /// prints it; `None` without a case whose loss has an interval.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub remaining_width: Option<f64>,
    /// Root mean square roughness of both specimens \[nm\].
    pub roughness_nm: f64,
    /// Relative radius of the contact along the motion \[mm\].
    pub radius_mm: f64,
    /// Amounts of measurement with the errors that they would leave.
    pub stages: Vec<Stage>,
    /// Curves of the standard plan.
    pub curves: Vec<PlannedCurve>,
    /// Points of the standard plan.
    pub points: Vec<PlannedPoint>,
    /// The few points that narrow the loss of the case most; without a case, all constants together.
    pub chosen: Vec<PlannedPoint>,
}

/// Computation of the errors that points would leave.
struct Planner<'a> {
    oil: &'a OilBase,
    settings: &'a PlanSettings,
    priors: Priors,
    /// Derivatives of the logarithm of the loss of the case.
    slopes: Option<DVector<f64>>,
}

/// One curve and the standard plan for the loss of `case`, and the derivative of ln loss by a standard deviation of the
/// pressure-viscosity coefficient in the friction only.
///
/// # Errors
/// When the film has no solution at a point, or the case has no loss.
pub(crate) fn stages_of_case(
    oil: &OilBase,
    case: (&LoadedCase, &Contacts),
    settings: &PlanSettings,
) -> Result<([Stage; 2], f64), Fault> {
    let priors = Priors::new(oil, settings.is_wide);
    let slopes = loss_slopes(case.0, Some(case.1), priors)?;
    let planner = Planner {
        oil,
        settings,
        priors,
        slopes: Some(DVector::from_row_slice(&slopes)),
    };
    let stage = |name: &str, grid: &OilGrid<'_>| {
        planner.stage(name, &grid.described(oil, &settings.machine)?)
    };
    let stages = [stage(ONE, &ONE_CURVE)?, stage(WHOLE, &STANDARD)?];
    Ok((stages, slopes[FACTOR]))
}

impl OilPlan {
    /// Title of the result for an oil.
    pub(super) fn title_of(oil: &OilBase) -> String {
        format!("Traction plan of {}", oil.name)
    }

    /// Plans the measurement of `oil`, for the loss of `case` if there is one.
    ///
    /// # Errors
    /// When the film has no solution at a point, or the case has no loss.
    ///
    /// ```
    /// use asperity_calibration::oil::{OilBase, OilPlan, OilPlanSettings};
    /// use asperity_report::Settings;
    /// let settings = OilPlanSettings::usual()?.plan()?;
    /// let plan = OilPlan::new(&OilBase::of_library("m100")?, None, &settings)?;
    /// assert_eq!((plan.curves.len(), plan.points.len()), (12, 120));
    /// // A full plan leaves less of each error than one curve.
    /// let left = |stage: usize| plan.stages[stage].constants.iter().map(|one| one.share);
    /// assert!(left(3).zip(left(1)).all(|(full, one)| full <= one));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(
        oil: &OilBase,
        case: Option<&LoadedCase>,
        settings: &PlanSettings,
    ) -> Result<Self, Fault> {
        let priors = Priors::new(oil, settings.is_wide);
        let slopes = case
            .map(|case| loss_slopes(case, None, priors))
            .transpose()?;
        let planner = Planner {
            oil,
            settings,
            priors,
            slopes: slopes.map(|slopes| DVector::from_row_slice(&slopes)),
        };
        let small = Machine {
            radii: [SMALL_RADIUS; 2],
            ..settings.machine
        };
        let described = |grid: &OilGrid<'_>| grid.described(oil, &settings.machine);
        let standard = described(&STANDARD)?;
        let mut further = SMALL_BALL.described(oil, &small)?;
        for point in &mut further {
            point.curve += standard.len();
        }
        let chosen = planner.chosen(&described(&helpful::GRID)?)?;
        let chosen_points = format!("{CHOSEN} chosen points");
        let stages = [
            ("before any test", Vec::new()),
            (ONE, described(&ONE_CURVE)?),
            ("three curves", described(&THREE_CURVES)?),
            (WHOLE, standard.clone()),
            ("with a small ball", [&standard[..], &further].concat()),
            (&chosen_points, chosen.clone()),
        ];
        let stages = try_par_map(&stages, |(name, points)| planner.stage(name, points))?;
        Ok(Self {
            program: PROGRAM.to_owned(),
            title: Self::title_of(oil),
            oil: oil.name.clone(),
            case: case.map(|case| case.case.title.clone()),
            loss_slopes: slopes,
            remaining_width: None,
            roughness_nm: 1e9 * settings.machine.roughness.si(),
            radius_mm: 1e3 * settings.machine.radii[0].si(),
            stages,
            curves: planner.curves()?,
            points: planner.points(&standard, settings.simulate)?,
            chosen: planner.points(&chosen, None)?,
        })
    }
}

impl Planner<'_> {
    fn stage(&self, name: &str, points: &[SetPoint]) -> Result<Stage, Fault> {
        let PlanSettings { zero, errors, .. } = *self.settings;
        let covariance = expected_covariance(self.oil, self.priors, zero, errors, points)?;
        let constants = STATED_CONSTANTS.iter().enumerate().map(|(k, (key, ..))| {
            let share = covariance[(k, k)].sqrt();
            ExpectedError {
                key: (*key).to_owned(),
                deviation: share * self.priors.constants[k],
                share,
            }
        });
        let loss = self.slopes.as_ref().map(|slopes| {
            let variance = slopes.dot(&(&covariance * slopes));
            variance.sqrt()
        });
        let temperature = |point: &SetPoint| {
            let radius = point.reading.machine.radii[0].si();
            [radius, point.reading.set_temperature_c]
        };
        let heated = distinct(points.iter().map(temperature)).len();
        let curves = points.len() as f64 / SLIDES.len() as f64;
        Ok(Stage {
            name: name.to_owned(),
            points: points.len(),
            minutes: MINUTES[0] * curves + MINUTES[1] * heated as f64,
            constants: constants.collect(),
            loss_deviation: loss,
        })
    }

    /// The candidates that narrow the loss of the case most; without a case, all stated constants together.
    fn chosen(&self, candidates: &[SetPoint]) -> Result<Vec<SetPoint>, Fault> {
        let PlanSettings { zero, errors, .. } = *self.settings;
        let problem = planned(self.oil, self.priors, zero, errors, candidates)?;
        let mut slopes = problem.at(&DVector::zeros(problem.variables())).1;
        let interest = match &self.slopes {
            Some(loss) => {
                slopes *= reflection(loss, slopes.ncols());
                1
            }
            None => STATED,
        };
        let row = |k: usize| slopes.rows(k, 1).into_owned();
        let rows: Vec<DMatrix<f64>> = (0..candidates.len()).map(row).collect();
        let of_priors = slopes.rows(candidates.len(), slopes.ncols()).into_owned();
        let mut chosen = d_optimal(&rows, CHOSEN, 1, interest, &information(&of_priors));
        chosen.sort_unstable();
        Ok(chosen.into_iter().map(|k| candidates[k].clone()).collect())
    }

    fn curves(&self) -> Result<Vec<PlannedCurve>, Fault> {
        let all = STANDARD.points(&self.settings.machine);
        let curve = |points: &[SetPoint]| -> Result<PlannedCurve, Fault> {
            let judged = points.iter().map(|point| judge(self.oil, point));
            let judged = judged.collect::<Result<Vec<Judged>, Fault>>()?;
            let both = || points.iter().zip(&judged);
            let setting = &points[0].reading.setting;
            let kept = both().filter(|(_, judged)| judged.dropped.is_none());
            let rules = Dropped::ALL.into_iter();
            Ok(PlannedCurve {
                temperature_c: setting.temperature.celsius(),
                load_n: setting.load.si(),
                mean_speed_m_s: setting.mean_speed.si(),
                pressure_gpa: 1e-9 * judged[0].max_pressure,
                film_ratio: judged
                    .iter()
                    .fold(f64::INFINITY, |least, one| least.min(one.film_ratio)),
                slides_percent: kept.map(|(point, _)| percent(point)).collect(),
                dropped: rules
                    .filter(|rule| judged.iter().any(|one| one.dropped == Some(*rule)))
                    .collect(),
            })
        };
        let curves: Vec<&[SetPoint]> = all.chunks(SLIDES.len()).collect();
        let mut curves = try_par_map(curves, curve)?;
        curves.sort_by(|a, b| a.temperature_c.total_cmp(&b.temperature_c));
        Ok(curves)
    }

    /// Rows of points, by temperature, with simulated friction if there is a seed.
    fn points(&self, points: &[SetPoint], seed: Option<u64>) -> Result<Vec<PlannedPoint>, Fault> {
        let PlanSettings { zero, errors, .. } = *self.settings;
        let problem = planned(self.oil, self.priors, zero, errors, points)?;
        let measured = seed.map(|seed| simulated(&problem, false, errors, seed));
        let measured = measured.transpose()?.map(|(_, friction)| friction);
        let row = |k: usize| -> Result<PlannedPoint, Fault> {
            let point = &points[k];
            let reading = &point.reading;
            let at = &reading.setting;
            let found = reading.machine.predict(&self.oil.rheology, at)?;
            Ok(PlannedPoint {
                load_n: at.load.si(),
                mean_speed_m_s: at.mean_speed.si(),
                slide_roll_percent: percent(point),
                temperature_c: at.temperature.celsius(),
                expected_traction: found.friction.coefficient,
                film_ratio: found.film / reading.machine.roughness,
                simulated_traction: measured.as_ref().map(|friction| friction[k]),
            })
        };
        let mut rows = try_par_map(0..points.len(), row)?;
        rows.sort_by(|a, b| a.temperature_c.total_cmp(&b.temperature_c));
        Ok(rows)
    }
}

/// Slide-to-roll ratio \[%\] without round-off.
fn percent(point: &SetPoint) -> f64 {
    (1e4 * point.reading.setting.slide_to_roll).round() / 100.0
}

/// Householder's reflection that turns the first of `size` variables into the combination `of` of the first ones.
fn reflection(of: &DVector<f64>, size: usize) -> DMatrix<f64> {
    let mut normal = DVector::zeros(size);
    normal.rows_mut(0, of.len()).copy_from(&of.normalize());
    normal[0] -= 1.0;
    let square = normal.norm_squared();
    let identity = DMatrix::identity(size, size);
    if square > f64::EPSILON {
        identity - (2.0 / square) * &normal * normal.transpose()
    } else {
        identity
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_variable_becomes_the_combination() {
        let of = DVector::from_row_slice(&[3.0, 0.0, -4.0]);
        let turned = reflection(&of, 5);
        let first = DVector::from_row_slice(&[0.6, 0.0, -0.8, 0.0, 0.0]);
        assert!((turned.column(0) - first).norm() < 1e-15);
        assert!((&turned * &turned - DMatrix::identity(5, 5)).norm() < 1e-14);
        let along = reflection(&DVector::from_row_slice(&[2.0, 0.0]), 3);
        assert_eq!(along, DMatrix::identity(3, 3));
    }
}
