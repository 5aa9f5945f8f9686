//! Shares of a cycle outside of a map.

use super::trace::{Cycle, CyclePoint};
use crate::map::Surface;
use asperity_core::remedy::{Remedy, Setting, Value};
use asperity_core::{Code, Fault};

/// Largest share of the energy at the pinion outside of a map, where losses are extrapolated: a choice of this program.
const MOST_OUTSIDE: f64 = 0.05;

/// Shares of a cycle outside of a map.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coverage {
    /// Share of the energy at the pinion, driving and braking, outside of the map.
    pub outside_energy: f64,
    /// Share of the moving time outside of the map.
    pub outside_time: f64,
    torque_nm: [f64; 2],
    speed_rpm: f64,
    of_map: [f64; 3],
}

/// Error: too much of a cycle is outside of a map.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error(
    "{:.1} % of the energy of the cycle is outside of the map, at most {:.0} % is permitted: torque {:.1} to {:.1} N m and speed up to {:.0} 1/min on a map of {:.1} to {:.1} N m up to {:.0} 1/min",
    100.0 * .0.outside_energy, 100.0 * MOST_OUTSIDE, .0.torque_nm[0], .0.torque_nm[1], .0.speed_rpm,
    .0.of_map[0], .0.of_map[1], .0.of_map[2]
)]
pub struct Uncovered(Coverage);

impl Coverage {
    /// Computes the shares of `cycle` outside of `surface`.
    #[must_use]
    pub fn of(surface: &Surface, cycle: &Cycle) -> Self {
        let energy = |point: &CyclePoint| point.power_w().abs() * point.weight_s;
        let is_outside = |point: &CyclePoint| {
            let at = surface.loss_torque(point.torque_nm, point.speed_rpm);
            at.is_outside
        };
        let outside = |of: &dyn Fn(&CyclePoint) -> f64| share(cycle, of, &is_outside);
        let torques = || cycle.points.iter().map(|point| point.forwards()[0]);
        let speeds = cycle.points.iter().map(|point| point.speed_rpm.abs());
        let end = |nodes: &[f64]| nodes.last().copied().unwrap_or_default();
        Self {
            outside_energy: outside(&energy),
            outside_time: outside(&moving_time),
            torque_nm: [torques().fold(0.0, f64::min), torques().fold(0.0, f64::max)],
            speed_rpm: speeds.fold(0.0, f64::max),
            of_map: [
                surface.torque_nm.first().copied().unwrap_or_default(),
                end(&surface.torque_nm),
                end(&surface.speed_rpm),
            ],
        }
    }

    /// Rejects a cycle with more than 5 % of its energy outside of the map.
    ///
    /// # Errors
    /// When more than 5 % is outside.
    pub fn check(self) -> Result<(), Uncovered> {
        match self.outside_energy > MOST_OUTSIDE {
            true => Err(Uncovered(self)),
            false => Ok(()),
        }
    }
}

/// Time of a point in motion \[s\].
pub(super) fn moving_time(point: &CyclePoint) -> f64 {
    match point.speed_rpm == 0.0 {
        true => 0.0,
        false => point.weight_s,
    }
}

/// Share of the selected points in the sum of `of`; 0 if the sum is zero.
pub(super) fn share(
    cycle: &Cycle,
    of: &dyn Fn(&CyclePoint) -> f64,
    is_selected: &dyn Fn(&CyclePoint) -> bool,
) -> f64 {
    let all: f64 = cycle.points.iter().map(of).sum();
    let selected = cycle.points.iter().filter(|point| is_selected(point));
    if all > 0.0 {
        // A sum of nothing is -0.
        selected.map(of).sum::<f64>() / all + 0.0
    } else {
        0.0
    }
}

impl From<Uncovered> for Fault {
    fn from(error: Uncovered) -> Self {
        let remedy = Remedy::act("compute the map up to these torques and speeds")
            .or_set(Setting::Key("allow_outside"), Value::Any)
            .because("to accept the ratio of loss to torque at the edge");
        Self::of(Code::E314, error).with(remedy)
    }
}
