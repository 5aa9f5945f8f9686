//! Traction that a machine would measure: over the slide-to-roll ratio, and over the speed.
//!
//! Predicted where the film is at least three times as thick as the roughness. Below, a dashed guide in the chart leads to
//! the boundary friction, straight over the logarithm of the film thickness down to a fifth of the roughness; it has no
//! band and is in no file.

use asperity::mixed_film::LoadShareError;
use asperity_core::numerics::Z_95;
use asperity_core::quantity::{Force, Length, Speed, Temperature};
use asperity_core::task::try_par_map;
use asperity_core::{DomainError, Fault, PROGRAM};
use serde::Serialize;

use super::base::OilBase;
use super::machine::{Machine, PredictedFriction, Setting};

/// Film thickness over roughness from which the film separates the surfaces.
pub(super) const LEAST_RATIO: f64 = 3.0;
/// Film thickness over roughness at which the boundary layer carries all.
pub(super) const BOUNDARY_RATIO: f64 = 0.2;
/// Ends of the slide-to-roll ratios: below, the creep of the bodies counts.
const SLIDES: [f64; 2] = [0.005, 1.0];
/// Ends of the speeds \[m/s\].
const SPEEDS: [f64; 2] = [0.01, 10.0];
/// Points of a curve.
const POINTS: usize = 41;
/// Step of the logarithm of a constant in the derivative of the friction.
const STEP: f64 = 1e-3;

/// Conditions of traction curves.
#[derive(Debug, Clone, PartialEq)]
pub struct TractionRange {
    /// The machine.
    pub machine: Machine,
    /// Load.
    pub load: Force,
    /// Mean speed of the curves over the slide-to-roll ratio.
    pub mean_speed: Speed,
    /// Slide-to-roll ratio of the curves over the speed.
    pub slide_to_roll: f64,
    /// Temperatures of the oil bath.
    pub temperatures: Vec<Temperature>,
    /// Boundary friction to which the guide leads.
    pub boundary_friction: f64,
}

/// Predicted traction at a setting.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct PredictedPoint {
    /// Load \[N\].
    pub load_n: f64,
    /// Mean speed \[m/s\].
    pub mean_speed_m_s: f64,
    /// Slide-to-roll ratio \[%\].
    pub slide_roll_percent: f64,
    /// Temperature of the oil bath \[°C\].
    pub temperature_c: f64,
    /// Friction coefficient.
    pub traction: f64,
    /// Its 5 % quantile, from the constants of the oil only.
    pub traction_p05: f64,
    /// Its 95 % quantile.
    pub traction_p95: f64,
    /// Central film \[nm\].
    pub film_nm: f64,
    /// Central film over the roughness of the specimens.
    pub film_ratio: f64,
    /// Rise of the surface temperature \[K\].
    pub surface_rise_k: f64,
    /// Largest rise of the film above the surfaces \[K\].
    pub film_rise_k: f64,
}

/// Curves at one temperature.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct ComputedCurves {
    pub temperature_c: f64,
    pub over_slide: Vec<PredictedPoint>,
    pub over_speed: Vec<PredictedPoint>,
    /// Speed and friction of the guide.
    pub guide: Vec<[f64; 2]>,
    /// Film over roughness at the speed of the curve over the slide-to-roll ratio, where that is 5 %.
    pub film_ratio: f64,
}

/// Traction curves of an oil.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct TractionCurves {
    /// Program and version.
    pub program: String,
    /// Name of the oil.
    pub title: String,
    /// Law of pressure.
    pub pressure_law: String,
    /// Largest Hertz pressure \[GPa\].
    pub max_pressure_gpa: f64,
    /// Load \[N\].
    pub load_n: f64,
    /// Mean speed of the curves over the slide-to-roll ratio \[m/s\].
    pub mean_speed_m_s: f64,
    /// Slide-to-roll ratio of the curves over the speed \[%\].
    pub slide_roll_percent: f64,
    /// Roughness of both specimens together \[nm\].
    pub roughness_nm: f64,
    /// Boundary friction to which the guide of the chart leads.
    pub boundary_friction: f64,
    /// Standard deviations of the logarithms of Eyring stress, limiting shear stress and pressure-viscosity coefficient
    /// behind the band.
    pub deviations: [f64; 3],
    /// Points of the curves over the slide-to-roll ratio.
    pub over_slide: Vec<PredictedPoint>,
    /// Points of the curves over the speed.
    pub over_speed: Vec<PredictedPoint>,
    /// Curves by temperature, with the guides.
    #[serde(skip)]
    pub(super) curves: Vec<ComputedCurves>,
}

/// Values from the first to the second in equal ratios.
fn spaced([low, high]: [f64; 2]) -> impl Iterator<Item = f64> {
    let ratio = (high / low).ln() / (POINTS - 1) as f64;
    (0..POINTS).map(move |k| low * (ratio * k as f64).exp())
}

impl TractionCurves {
    /// Title of the result for an oil.
    pub(super) fn title_of(oil: &OilBase) -> String {
        format!("Traction of {}", oil.name)
    }

    /// Predicts the curves of an oil.
    ///
    /// # Errors
    /// When an input is outside its domain.
    ///
    /// ```
    /// use asperity_calibration::oil::{Machine, OilBase, TractionCurves, TractionRange};
    /// let range = TractionRange {
    ///     machine: Machine::ball_on_disc("9.525 mm".parse()?, None, "15 nm".parse()?)?,
    ///     load: "30 N".parse()?, mean_speed: "2 m/s".parse()?, slide_to_roll: 0.05,
    ///     temperatures: vec!["40 °C".parse()?, "120 °C".parse()?], boundary_friction: 0.09,
    /// };
    /// let curves = TractionCurves::new(&OilBase::of_library("m100")?, &range)?;
    /// assert!(curves.over_slide.iter().all(|point| point.film_ratio >= 3.0 && point.traction < 0.05));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(oil: &OilBase, range: &TractionRange) -> Result<Self, Fault> {
        let slide = range.slide_to_roll;
        let rule = "must be positive and at most 2 (200 % is pure sliding)";
        let is_valid = slide > 0.0 && slide <= 2.0;
        DomainError::require(is_valid, "slide-to-roll ratio", slide, "-", rule)
            .map_err(LoadShareError::from)?;
        let curves = try_par_map(&range.temperatures, |temperature| {
            curves_at(oil, range, *temperature)
        })?;
        let hertz = range
            .machine
            .contact(&setting(range, range.temperatures[0]))
            .hertz()?;
        let all = |of: fn(&ComputedCurves) -> &[PredictedPoint]| {
            let points = curves.iter().flat_map(|curves| of(curves).iter().copied());
            points.collect::<Vec<PredictedPoint>>()
        };
        Ok(Self {
            program: PROGRAM.to_owned(),
            title: Self::title_of(oil),
            pressure_law: oil.rheology.laws().1.name().to_owned(),
            max_pressure_gpa: 1e-9 * hertz.max_pressure.si(),
            load_n: range.load.si(),
            mean_speed_m_s: range.mean_speed.si(),
            slide_roll_percent: 100.0 * range.slide_to_roll,
            roughness_nm: 1e9 * range.machine.roughness.si(),
            boundary_friction: range.boundary_friction,
            deviations: oil.deviations,
            over_slide: all(|curves| &curves.over_slide),
            over_speed: all(|curves| &curves.over_speed),
            curves,
        })
    }
}

fn setting(range: &TractionRange, temperature: Temperature) -> Setting {
    Setting {
        load: range.load,
        mean_speed: range.mean_speed,
        slide_to_roll: range.slide_to_roll,
        temperature,
    }
}

fn curves_at(
    oil: &OilBase,
    range: &TractionRange,
    temperature: Temperature,
) -> Result<ComputedCurves, Fault> {
    let at = setting(range, temperature);
    let ratio = |film: Length| film / range.machine.roughness;
    let mut over_slide = Vec::new();
    for slide_to_roll in spaced(SLIDES) {
        let at = Setting {
            slide_to_roll,
            ..at
        };
        let found = range.machine.predict(&oil.rheology, &at)?;
        if ratio(found.film) >= LEAST_RATIO {
            over_slide.push(point(oil, &range.machine, &at, &found)?);
        }
    }
    let mut over_speed = Vec::new();
    let mut below = Vec::new();
    for speed in spaced(SPEEDS) {
        let at = Setting {
            mean_speed: Speed::from_si(speed),
            ..at
        };
        let found = range.machine.predict(&oil.rheology, &at)?;
        if ratio(found.film) >= LEAST_RATIO {
            over_speed.push(point(oil, &range.machine, &at, &found)?)
        } else {
            below.push([speed, ratio(found.film)])
        }
    }
    let film = range.machine.predict(&oil.rheology, &at)?.film;
    Ok(ComputedCurves {
        temperature_c: temperature.celsius(),
        guide: guide(&below, over_speed.first(), range.boundary_friction),
        over_slide,
        over_speed,
        film_ratio: ratio(film),
    })
}

/// The guide from the boundary friction to the slowest predicted point, over speeds with their film ratios; none without
/// such a point.
fn guide(
    below: &[[f64; 2]],
    slowest: Option<&PredictedPoint>,
    boundary_friction: f64,
) -> Vec<[f64; 2]> {
    let Some(slowest) = slowest.filter(|_| !below.is_empty()) else {
        return Vec::new();
    };
    let whole = (slowest.film_ratio / BOUNDARY_RATIO).ln();
    let at = |&[speed, ratio]: &[f64; 2]| {
        let share = ((ratio / BOUNDARY_RATIO).ln() / whole).max(0.0);
        let friction = boundary_friction + share * (slowest.traction - boundary_friction);
        [speed, friction]
    };
    let end = [slowest.mean_speed_m_s, slowest.traction];
    below.iter().map(at).chain([end]).collect()
}

fn point(
    oil: &OilBase,
    machine: &Machine,
    at: &Setting,
    found: &PredictedFriction,
) -> Result<PredictedPoint, Fault> {
    let traction = found.friction.coefficient;
    let mut variance = 0.0;
    for (k, deviation) in oil.deviations.iter().enumerate() {
        let mut logs = [0.0; 3];
        logs[k] = STEP;
        let moved = machine.predict(&oil.shifted(logs)?, at)?;
        let slope = (moved.friction.coefficient / traction).ln() / STEP;
        variance += (slope * deviation).powi(2);
    }
    let spread = Z_95 * variance.sqrt();
    Ok(PredictedPoint {
        load_n: at.load.si(),
        mean_speed_m_s: at.mean_speed.si(),
        slide_roll_percent: 100.0 * at.slide_to_roll,
        temperature_c: at.temperature.celsius(),
        traction,
        traction_p05: traction * (-spread).exp(),
        traction_p95: traction * spread.exp(),
        film_nm: 1e9 * found.film.si(),
        film_ratio: found.film / machine.roughness,
        surface_rise_k: found.friction.surface_rise,
        film_rise_k: found.friction.largest_film_rise,
    })
}
