//! Boundary friction from Stribeck curves of ball and disc, before and after rubbing.
//!
//! Where the film is at most a fifth of the roughness, the boundary layer carries all and the friction is that of boundary
//! lubrication. Rubbing makes the layer of the additives: in a public record of a machine (120 °C, 50 N, pure sliding) the
//! friction doubles within 7000 s, from 0.059 to 0.117. The error of the transfer from the machine to a gear is 10 %
//! (assumed). The thickness of the layer does not follow from smooth specimens, nor does the least share on it of asperities that
//! come into contact past the inlet: their film is that of the roughness.

use super::error as oil_error;
use asperity::message::Warning;
use asperity_core::numerics::{Z_95, Z_975};
use asperity_core::{Code, Estimate, EstimateKeys, Fault, PROGRAM, estimate_keys};
use serde::{Deserialize, Serialize};

use super::base::OilBase;
use super::problem::distinct;
use super::reading::{SetPoint, left_out, set_points};
use super::selection::LEAST_SLIDE;
use super::text::Readings;
use super::traction::BOUNDARY_RATIO;

/// Fewest points in boundary lubrication.
const FEWEST: usize = 4;
/// Largest change of the friction over a decade of speed, relative to it.
const LARGEST_SLOPE: f64 = 0.1;
/// Standard deviation of the logarithm of the boundary friction by the transfer from a machine to a gear (assumed).
const TRANSFER: f64 = 0.1;
/// Distance of the temperature of a case from the tested ones that is worth a warning \[K\].
const FAR: f64 = 20.0;

/// Boundary friction after one time of rubbing.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct BoundaryState {
    /// Time of rubbing \[s\].
    pub rubbing_s: f64,
    /// Points in boundary lubrication.
    pub points: usize,
    /// Mean of their friction; `None` without points.
    pub boundary_friction: Option<f64>,
    /// Standard deviation of their friction relative to the mean.
    pub scatter: f64,
    /// Change over a decade of speed relative to the mean; `None` if they have one speed.
    pub slope_per_decade: Option<f64>,
}

/// Point of a Stribeck curve.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct StribeckPoint {
    /// File.
    pub file: String,
    /// Line of its first reading.
    pub line: usize,
    /// Load \[N\].
    pub load_n: f64,
    /// Mean speed \[m/s\].
    pub mean_speed_m_s: f64,
    /// Slide-to-roll ratio \[%\].
    pub slide_roll_percent: f64,
    /// Temperature \[°C\].
    pub temperature_c: f64,
    /// Time of rubbing \[s\].
    pub rubbing_s: f64,
    /// Number of readings.
    pub readings: usize,
    /// Film over roughness.
    pub film_ratio: f64,
    /// Friction coefficient.
    pub traction: f64,
    /// Whether the boundary layer carries all, and the surfaces slide.
    pub is_boundary: bool,
}

estimate_keys! { BoundaryFriction: "boundary_friction" "range"; }

/// Boundary friction of an oil from Stribeck curves.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct Stribeck {
    /// Program and version.
    pub program: String,
    /// Title.
    pub title: String,
    /// Files with their SHA-256.
    pub sources: Vec<[String; 2]>,
    /// Root mean square roughness of both specimens \[nm\].
    pub roughness_nm: f64,
    /// Boundary friction after the longest rubbing with 5 % and 95 % quantile, as printed.
    #[serde(flatten, with = "BoundaryFriction")]
    pub boundary_friction: Estimate,
    /// Standard deviation of its logarithm: transfer to a gear and scatter.
    pub deviation: f64,
    /// 2.5 % and 97.5 % quantile, as files state them.
    pub band: [f64; 2],
    /// Boundary friction after each time of rubbing, in ascending order.
    pub states: Vec<BoundaryState>,
    /// Set temperatures \[°C\] of the points behind the boundary friction.
    pub temperatures_c: Vec<f64>,
    /// All points.
    pub points: Vec<StribeckPoint>,
    /// Warnings.
    pub warnings: Vec<Warning>,
}

impl Stribeck {
    /// Title of the result for an oil.
    pub(super) fn title_of(oil: &OilBase) -> String {
        format!("Boundary friction of {}", oil.name)
    }

    /// The boundary friction of `oil` from readings, which state the time of rubbing.
    ///
    /// # Errors
    /// When a reading does not state the time of rubbing, all specimens are new, too few points are in boundary lubrication,
    /// or their friction depends on the speed.
    pub fn new(oil: &OilBase, readings: Readings) -> Result<Self, Fault> {
        let Readings { all, sources, .. } = readings;
        if let Some(reading) = all.iter().find(|one| one.rubbing_s.is_none()) {
            return Err(oil_error::no_rubbing(&reading.file, reading.line));
        }
        let row = |point: &SetPoint| -> Result<StribeckPoint, Fault> {
            let reading = &point.reading;
            let at = &reading.setting;
            let machine = &reading.machine;
            let (_, film) = machine.film(&oil.rheology, at, reading.film, 1.0)?;
            let film_ratio = film / machine.roughness;
            Ok(StribeckPoint {
                file: reading.file.clone(),
                line: reading.line,
                load_n: at.load.si(),
                mean_speed_m_s: at.mean_speed.si(),
                slide_roll_percent: 100.0 * at.slide_to_roll,
                temperature_c: at.temperature.celsius(),
                rubbing_s: reading.rubbing_s.unwrap_or_default(),
                readings: point.readings,
                film_ratio,
                traction: reading.traction,
                is_boundary: film_ratio <= BOUNDARY_RATIO && at.slide_to_roll >= LEAST_SLIDE,
            })
        };
        let found = set_points(&all);
        let points = found.iter().map(row);
        let points = points.collect::<Result<Vec<StribeckPoint>, Fault>>()?;
        let times = distinct(points.iter().map(|point| point.rubbing_s));
        let states: Vec<BoundaryState> = times.iter().map(|time| state(*time, &points)).collect();
        let last = states.last().filter(|last| last.rubbing_s > 0.0);
        let last = last.ok_or_else(oil_error::not_rubbed)?;
        let (boundary_friction, scatter) = accepted(last, &points)?;
        let deviation = TRANSFER.hypot(scatter);
        let quantiles = |z: f64| [-z, z].map(|z| boundary_friction * (z * deviation).exp());
        let both = found.iter().zip(&points);
        let used = both.filter(|(_, row)| row.is_boundary && row.rubbing_s == last.rubbing_s);
        let temperatures_c = distinct(used.map(|(point, _)| point.reading.set_temperature_c));
        let texts = left_out(&all);
        let texts = texts.into_iter().chain(oil.outside(&temperatures_c, FAR));
        let mut warnings = readings.warnings;
        warnings.extend(texts.map(|text| Warning::new(Code::W441, text)));
        let roughness = found.first().map(|point| point.reading.machine.roughness);
        Ok(Self {
            program: PROGRAM.to_owned(),
            title: Self::title_of(oil),
            sources,
            roughness_nm: 1e9 * roughness.map_or(0.0, |roughness| roughness.si()),
            boundary_friction: Estimate::new(boundary_friction, quantiles(Z_95)),
            deviation,
            band: quantiles(Z_975),
            warnings,
            states,
            temperatures_c,
            points,
        })
    }
}

fn state(rubbing_s: f64, points: &[StribeckPoint]) -> BoundaryState {
    let of = |point: &&StribeckPoint| point.is_boundary && point.rubbing_s == rubbing_s;
    let of: Vec<&StribeckPoint> = points.iter().filter(of).collect();
    let count = of.len() as f64;
    let mean = of.iter().map(|point| point.traction).sum::<f64>() / count;
    let squares = of.iter().map(|point| (point.traction - mean).powi(2));
    let variance = squares.sum::<f64>() / (count - 1.0).max(1.0);
    BoundaryState {
        rubbing_s,
        points: of.len(),
        boundary_friction: (!of.is_empty()).then_some(mean),
        scatter: if of.is_empty() {
            0.0
        } else {
            variance.sqrt() / mean
        },
        slope_per_decade: slope(&of).map(|slope| slope / mean),
    }
}

/// Slope of the friction over the decimal logarithm of the speed within points of one load, temperature and slide-to-roll
/// ratio; `None` if none of them have two speeds.
fn slope(points: &[&StribeckPoint]) -> Option<f64> {
    let key = |point: &StribeckPoint| {
        let percent = point.slide_roll_percent.round();
        [point.load_n.round(), point.temperature_c.round(), percent]
    };
    let (mut products, mut squares) = (0.0, 0.0);
    for curve in distinct(points.iter().map(|point| key(point))) {
        let of: Vec<[f64; 2]> = points
            .iter()
            .filter(|point| key(point) == curve)
            .map(|point| [point.mean_speed_m_s.log10(), point.traction])
            .collect();
        let mean = |k: usize| of.iter().map(|at| at[k]).sum::<f64>() / of.len() as f64;
        let [x, y] = [mean(0), mean(1)];
        products += of.iter().map(|at| (at[0] - x) * (at[1] - y)).sum::<f64>();
        squares += of.iter().map(|at| (at[0] - x).powi(2)).sum::<f64>();
    }
    /// Square of the spread of the logarithm of one speed.
    const ONE_SPEED: f64 = 1e-4;
    (squares > ONE_SPEED).then(|| products / squares)
}

/// Boundary friction and scatter of a state, if its points determine it.
fn accepted(state: &BoundaryState, points: &[StribeckPoint]) -> Result<(f64, f64), Fault> {
    let of_state = || points.iter().filter(|one| one.rubbing_s == state.rubbing_s);
    let few = || {
        oil_error::few_boundary(
            state.points,
            of_state().count(),
            BOUNDARY_RATIO,
            of_state().fold(f64::INFINITY, |least, one| least.min(one.film_ratio)),
            FEWEST,
        )
    };
    let (Some(friction), Some(slope)) = (state.boundary_friction, state.slope_per_decade) else {
        return Err(few());
    };
    if state.points < FEWEST {
        return Err(few());
    }
    if slope.abs() > LARGEST_SLOPE {
        return Err(oil_error::sloping(state.points, 100.0 * slope));
    }
    Ok((friction, state.scatter))
}
