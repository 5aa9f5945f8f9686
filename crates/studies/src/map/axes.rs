//! Axes of a map.

use asperity::case::train::Train;
use asperity_core::number;
use asperity_core::numerics::distinct;
use asperity_core::{Code, Fault};
use asperity_report::axis::{MOST_NODES, rounded_to};
use serde::{Deserialize, Serialize};

/// Nodes of a map, ascending along each axis.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Axes {
    /// Torque at the pinion or input shaft \[N m\].
    pub torque_nm: Vec<f64>,
    /// Speed of the pinion or input shaft \[1/min\].
    pub speed_rpm: Vec<f64>,
    /// Temperature of the flanks \[°C\].
    pub temperature_c: Vec<f64>,
}

/// A value is not permitted.
fn no_node(axis: &'static str, value: f64, unit: &'static str, rule: &'static str) -> Fault {
    Fault::new(
        Code::E209,
        format!(
            "{value} {unit} is not a node of an axis of the {axis}: {rule}",
            value = number(value)
        ),
    )
}

/// The axis has no or too many values.
fn node_count(axis: &'static str, count: usize, most: usize) -> Fault {
    Fault::new(
        Code::E209,
        format!("an axis of the {axis} with {count} nodes; from 1 to {most} are possible"),
    )
}

/// Number of positive torques of the default axis.
const TORQUES: usize = 12;
/// Smallest torque of the default axis relative to the largest.
const SMALLEST: f64 = 0.01;
/// Number of speeds above 1 1/min of the default axis.
const SPEEDS: usize = 16;
/// Digits of default nodes, few for readability.
const DIGITS: i32 = 4;
/// Lowest temperature \[°C\].
const ABSOLUTE_ZERO: f64 = -273.15;

impl Axes {
    /// Makes axes of distinct, sorted nodes. A node at standstill is added, and a node at zero torque if there are torques
    /// of both signs: the loss torque has a kink there, which interpolation would lose.
    ///
    /// # Errors
    /// When an axis is empty or a node is not permitted.
    pub fn new(torque_nm: &[f64], speed_rpm: &[f64], temperature_c: &[f64]) -> Result<Self, Fault> {
        check("torque", torque_nm, "N m", "must be finite", |_| true)?;
        let not_negative = "must be finite and not negative; torque has the sign";
        check("speed", speed_rpm, "1/min", not_negative, |v| v >= 0.0)?;
        let above = "must be above absolute zero";
        check("temperature", temperature_c, "°C", above, |v| {
            v > ABSOLUTE_ZERO
        })?;
        let mut torque = torque_nm.to_vec();
        let has = |is: fn(&f64) -> bool| torque_nm.iter().any(is);
        if has(|t| *t < 0.0) && has(|t| *t > 0.0) {
            torque.push(0.0);
        }
        let mut speed = speed_rpm.to_vec();
        speed.push(0.0);
        Ok(Self {
            torque_nm: rising(torque),
            speed_rpm: rising(speed),
            temperature_c: rising(temperature_c.to_vec()),
        })
    }

    /// Default torques of a case: 0, a geometric series from 1 % of the largest, and the same with negative sign.
    #[must_use]
    pub(crate) fn default_torque(case: &Train) -> Vec<f64> {
        let (torque, _) = case.input.map_limits();
        let most = torque.si().abs();
        let step = SMALLEST.powf(-1.0 / (TORQUES - 1) as f64);
        let node = |k: usize| rounded(most * SMALLEST * step.powi(k as i32));
        let drive = (0..TORQUES).map(|k| if k + 1 == TORQUES { most } else { node(k) });
        drive
            .flat_map(|torque| [-torque, torque])
            .chain([0.0])
            .collect()
    }

    /// Default speeds of a case: 0, 1 1/min, then with smaller steps at low speed.
    #[must_use]
    pub(crate) fn default_speed(case: &Train) -> Vec<f64> {
        let (_, speed) = case.input.map_limits();
        let most = speed.si() * 30.0 / std::f64::consts::PI;
        let node = |k: usize| rounded(most * (k as f64 / SPEEDS as f64).powi(2));
        [0.0, 1.0]
            .into_iter()
            .chain((1..=SPEEDS).map(node))
            .collect()
    }

    /// Temperature at which a case states its load \[°C\], rounded as a node; of a train that of its first mesh.
    #[must_use]
    pub fn case_temperature(case: &Train) -> f64 {
        let first = case.meshes().next();
        first.map_or(f64::NAN, |mesh| {
            rounded(mesh.case.case.stated_temperature.celsius())
        })
    }

    /// Number of points of the map.
    #[must_use]
    pub fn points(&self) -> usize {
        self.torque_nm.len() * self.speed_rpm.len() * self.temperature_c.len()
    }

    /// Index of a point, in the order of temperature, torque and speed.
    #[must_use]
    pub fn index(&self, temperature: usize, torque: usize, speed: usize) -> usize {
        (temperature * self.torque_nm.len() + torque) * self.speed_rpm.len() + speed
    }
}

fn check(
    axis: &'static str,
    values: &[f64],
    unit: &'static str,
    rule: &'static str,
    is_possible: impl Fn(f64) -> bool,
) -> Result<(), Fault> {
    let count = values.len();
    if !(1..=MOST_NODES).contains(&count) {
        return Err(node_count(axis, count, MOST_NODES));
    }
    let wrong = |value: &&f64| !(value.is_finite() && is_possible(**value));
    match values.iter().find(wrong) {
        None => Ok(()),
        Some(&value) => Err(no_node(axis, value, unit, rule)),
    }
}

fn rising(values: Vec<f64>) -> Vec<f64> {
    // −0 becomes 0.
    distinct(values.into_iter().map(|value| value + 0.0))
}

fn rounded(value: f64) -> f64 {
    rounded_to(value, DIGITS)
}
