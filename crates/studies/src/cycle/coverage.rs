//! Shares of a cycle outside of a map.

use super::trace::{Cycle, CyclePoint, Extreme, MOST_ACCELERATION};
use crate::map::Surface;
use asperity_core::remedy::{Remedy, Setting, Value};
use asperity_core::{Code, Fault, decimals};

/// Largest share of the energy at the pinion outside of a map, where losses are extrapolated: a choice of this program.
const MOST_OUTSIDE: f64 = 0.05;

/// Shares of a cycle outside of a map.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coverage {
    /// Share of the energy at the pinion, driving and braking, outside of the map.
    pub outside_energy: f64,
    /// Share of the moving time outside of the map.
    pub outside_time: f64,
    rows: [usize; 2],
    torque_nm: [Option<Extreme>; 2],
    speed_rpm: Option<Extreme>,
    /// Braking and driving \[m/s²\].
    acceleration: [Option<Extreme>; 2],
    of_map: [f64; 3],
}

/// Error: too much of a cycle is outside of a map.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{text}")]
pub struct Uncovered {
    text: String,
    /// Place of a jump of the speed.
    jump: Option<String>,
}

impl Coverage {
    /// Computes the shares of `cycle` outside of `surface`.
    #[must_use]
    pub fn new(surface: &Surface, cycle: &Cycle) -> Self {
        let energy = |point: &CyclePoint| point.power_w().abs() * point.weight_s;
        let is_outside = |point: &CyclePoint| {
            let at = surface.loss_torque(point.torque_nm, point.speed_rpm);
            at.is_outside
        };
        let outside = |of: &dyn Fn(&CyclePoint) -> f64| share(cycle, of, &is_outside);
        let most = |of: &dyn Fn(&CyclePoint) -> Option<f64>| Extreme::most(&cycle.points, of);
        let both = |of: &dyn Fn(&CyclePoint) -> Option<f64>| {
            let least = most(&|point| of(point).map(|value| -value));
            let least = least.map(|least| Extreme {
                value: -least.value,
                ..least
            });
            [least, most(of)]
        };
        let end = |nodes: &[f64]| nodes.last().copied().unwrap_or_default();
        Self {
            outside_energy: outside(&energy),
            outside_time: outside(&moving_time),
            rows: [
                cycle
                    .points
                    .iter()
                    .filter(|point| is_outside(point))
                    .count(),
                cycle.points.len(),
            ],
            torque_nm: both(&|point| Some(point.forwards()[0])),
            speed_rpm: most(&|point| Some(point.speed_rpm.abs())),
            acceleration: both(&|point| point.acceleration),
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
        if self.outside_energy > MOST_OUTSIDE {
            Err(Uncovered {
                text: self.text(),
                jump: self.jump().map(|jump| jump.place()),
            })
        } else {
            Ok(())
        }
    }

    /// The largest acceleration, if no tyre transmits it.
    fn jump(&self) -> Option<Extreme> {
        let jumps = self.acceleration.iter().flatten();
        let jumps = jumps.filter(|most| most.value.abs() > MOST_ACCELERATION);
        jumps
            .max_by(|a, b| a.value.abs().total_cmp(&b.value.abs()))
            .copied()
    }

    /// The part outside, with line and time of each extreme.
    fn text(&self) -> String {
        let at = |most: Option<Extreme>, places: usize| {
            most.map_or_else(String::new, |most| {
                format!("{} at {}", decimals(most.value, places), most.place())
            })
        };
        let [least, largest] = self.torque_nm.map(|torque| at(torque, 1));
        let [first, last, fastest] = self.of_map;
        let accelerations = match self.acceleration {
            [Some(_), Some(_)] => {
                let [brakes, drives] = self.acceleration.map(|of| at(of, 1));
                format!("; acceleration of the vehicle in m/s2 {brakes} to {drives}")
            }
            _ => String::new(),
        };
        let jump = self.jump().map_or_else(String::new, |jump| {
            format!(
                "; the jump of the speed at {} is more than the {MOST_ACCELERATION:.0} m/s2 that tyres transmit",
                jump.place()
            )
        });
        format!(
            "{:.1} % of the energy of the cycle is outside of the map, at most {:.0} % is permitted: {} of {} rows, torque in N m {least} \
                to {largest}, speed in 1/min up to {} on a map of {first:.1} to {last:.1} N m up to {fastest:.0} 1/min{accelerations}{jump}",
            100.0 * self.outside_energy,
            100.0 * MOST_OUTSIDE,
            self.rows[0],
            self.rows[1],
            at(self.speed_rpm, 0)
        )
    }
}

/// Time of a point in motion \[s\].
pub(super) fn moving_time(point: &CyclePoint) -> f64 {
    if point.speed_rpm == 0.0 {
        0.0
    } else {
        point.weight_s
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
        let way = match &error.jump {
            Some(place) => format!(
                "correct the recording at {place}, where rows are missing or another recording begins"
            ),
            None => "compute the map up to these torques and speeds".to_owned(),
        };
        let remedy = Remedy::act(way)
            .or_set(Setting::Key("allow_outside"), Value::Any)
            .because("to accept the ratio of loss to torque at the edge");
        Self::from_cause(Code::E314, error).with(remedy)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cycle::cycle;
    use asperity::case::VehicleInput;

    /// Losses from -150 to 150 N m up to 16000 1/min.
    fn surface() -> Surface {
        Surface {
            torque_nm: vec![-150.0, 0.0, 150.0],
            speed_rpm: vec![0.0, 16_000.0],
            loss_torque_nm: vec![1.0, 1.0, 0.1, 0.1, 1.0, 1.0],
        }
    }

    fn vehicle() -> VehicleInput {
        VehicleInput {
            mass: "1600 kg".parse().unwrap(),
            wheel_radius: "310 mm".parse().unwrap(),
            ratio: 9.0,
            drag_area: "0.6 m2".parse().unwrap(),
            rolling_resistance: 0.009,
            inertia_factor: None,
            grade: None,
        }
    }

    /// The refusal of a cycle of speeds \[m/s\] at these times \[s\], with its remedy, and the number of warnings of the cycle.
    fn refusal(rows: impl Iterator<Item = [f64; 2]>) -> (String, usize) {
        let rows: String = rows.map(|[t, v]| format!("{t},{v}\n")).collect();
        let found = cycle(&format!("time_s,v_mps\n{rows}"), Some(&vehicle())).unwrap();
        let fault = Fault::from(Coverage::new(&surface(), &found).check().unwrap_err());
        assert_eq!(fault.code(), Code::E314);
        (format!("{fault}; {}", fault.remedy()), found.warnings.len())
    }

    /// A drive of 20 s at 20 Hz by its speed \[m/s\].
    fn drive(speed: impl Fn(usize) -> f64) -> impl Iterator<Item = [f64; 2]> {
        (0..400).map(move |k| [0.05 * k as f64, speed(k)])
    }

    fn holds(text: &str, parts: &[&str]) {
        for part in parts {
            assert!(text.contains(part), "{part}: {text}");
        }
    }

    #[test]
    fn a_jump_of_the_speed_is_named_by_line_time_and_acceleration() {
        let stops = |k| if k < 200 { 4.5 } else { 0.0 };
        let (text, warnings) = refusal(drive(stops));
        assert_eq!(warnings, 1);
        // Row 200 is in line 202.
        holds(
            &text,
            &[
                "-90.0 at line 202 (t = 10.00 s) to 0.0 at line 2",
                "jump of the speed at line 202 (t = 10.00 s) is more than the 12 m/s2 that tyres transmit",
                "Correct the recording at line 202",
            ],
        );
        assert!(!text.contains("ompute the map up to"), "{text}");
        let (text, _) = refusal(drive(|k| if k < 200 { 0.0 } else { 4.5 }));
        holds(
            &text,
            &[
                "to 90.0 at line 202 (t = 10.00 s)",
                "Correct the recording at line 202",
            ],
        );
        assert!(!text.contains("ompute the map up to"), "{text}");
    }

    #[test]
    fn a_spike_of_one_row_is_named() {
        let (text, _) = refusal(drive(|k| if k == 120 { 21.0 } else { 10.0 }));
        holds(
            &text,
            &[
                "-220.0 at line 123 (t = 6.05 s) to 220.0 at line 122 (t = 6.00 s)",
                "Correct the recording at line 122",
            ],
        );
        // Of torque and speed, without a vehicle.
        let row = |k: usize| format!("{k},{},3000\n", if k == 70 { 9000.0 } else { 50.0 });
        let rows: String = (0..100).map(row).collect();
        let text = format!("time_s,torque_nm,speed_rpm\n{rows}");
        let found = cycle(&text, None).unwrap();
        let fault = Coverage::new(&surface(), &found).check().unwrap_err();
        holds(
            &fault.to_string(),
            &[
                "1 of 100 rows",
                "to 9000.0 at line 72 (t = 70.00 s)",
                "3000 at line",
            ],
        );
        assert!(!fault.to_string().contains("acceleration"), "{fault}");
    }

    #[test]
    fn a_high_demand_that_tyres_transmit_asks_for_a_wider_map() {
        // 8 m/s2 for two seconds.
        let speed = |k: usize| 2.0 + 0.4 * (k.clamp(100, 140) - 100) as f64;
        let (text, warnings) = refusal(drive(speed));
        assert_eq!(warnings, 0);
        holds(
            &text,
            &[
                "to 8.0 at line",
                "Compute the map up to these torques and speeds",
                "rows, torque in N m",
            ],
        );
        assert!(!text.contains("jump"), "{text}");
        // Speeds beyond the map.
        let rows = (0..9)
            .map(|k| format!("{k},20,{}\n", 4000 * k))
            .collect::<String>();
        let found = cycle(&format!("time_s,torque_nm,speed_rpm\n{rows}"), None).unwrap();
        let fault = Coverage::new(&surface(), &found).check().unwrap_err();
        holds(
            &fault.to_string(),
            &["speed in 1/min up to 32000 at line 10 (t = 8.00 s)"],
        );
    }
}
