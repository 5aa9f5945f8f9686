//! Reading of a cycle, and conversion to the pinion.

use std::f64::consts::PI;
use std::path::Path;

use asperity::case::{VehicleInput, range_of};
use asperity::message::Warning;
use asperity::profile_io::read::read_table;
use asperity_core::{Code, Fault, decimals};
use asperity_table::Table;

use super::error;
use crate::map::forwards;

/// Density of air at 20 °C \[kg/m³\].
const AIR: f64 = 1.204;
/// Standard acceleration of gravity \[m/s²\].
const GRAVITY: f64 = 9.806_65;
/// Default ratio of effective mass, including rotating parts, to mass: 4 % for a single-speed electric car, a choice of
/// this program.
const INERTIA: f64 = 1.04;

/// Cycle at the pinion.
#[derive(Debug, Clone, PartialEq)]
pub struct Cycle {
    /// Points.
    pub points: Vec<CyclePoint>,
    /// Distance driven \[km\]; `None` without a vehicle.
    pub distance_km: Option<f64>,
    /// Unusual numbers of the vehicle.
    pub warnings: Vec<Warning>,
}

/// Point of a cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CyclePoint {
    /// Time \[s\].
    pub time_s: f64,
    /// Time that the point represents \[s\]: half of both adjacent intervals.
    pub weight_s: f64,
    /// Torque at the pinion \[N m\].
    pub torque_nm: f64,
    /// Speed of the pinion \[1/min\]; negative in reverse.
    pub speed_rpm: f64,
    /// Line of the table, counted from 1.
    pub line: usize,
    /// Acceleration of the vehicle from the point before \[m/s²\], by its speed in the table, 0 at the first; `None` of a table
    /// without it.
    pub acceleration: Option<f64>,
}

impl CyclePoint {
    /// Torque \[N m\], positive while the pinion drives, and speed \[1/min\] of the same power forwards.
    #[must_use]
    pub fn forwards(&self) -> [f64; 2] {
        forwards(self.torque_nm, self.speed_rpm)
    }

    /// Power at the pinion \[W\]; negative while the wheel drives.
    #[must_use]
    pub fn power_w(&self) -> f64 {
        self.torque_nm * self.speed_rpm * PI / 30.0
    }
}

/// Largest size of a table in bytes.
pub const LARGEST_TABLE: u64 = 100_000_000;

/// Reads the cycle in a file, as [`cycle`].
///
/// # Errors
/// As [`cycle`], and when the file cannot be read.
pub fn read(file: &Path, vehicle: Option<&VehicleInput>) -> Result<Cycle, Fault> {
    let text = read_table(file, LARGEST_TABLE)?;
    let found = cycle(&text, vehicle);
    found.map_err(|error| error.about(file.display()))
}

/// Reads the cycle in `text`, a table with a header row ([`Table`]), whose columns may have the names that other programs give
/// them. The speed of a vehicle is converted to the
/// pinion with `vehicle`.
///
/// # Errors
/// When the table is not valid, time does not increase, or a vehicle is required and not given.
///
/// ```
/// use asperity_studies::cycle::cycle;
/// let found = cycle("time_s,torque_nm,speed_rpm\n0,10,1000\n1,20,1000\n3,0,0\n", None)?;
/// assert_eq!(found.points[1].weight_s, 1.5);
/// assert!(cycle("time_s,speed_km_h\n0,0\n1,3\n", None).is_err());
/// # Ok::<(), asperity_core::Fault>(())
/// ```
pub fn cycle(text: &str, vehicle: Option<&VehicleInput>) -> Result<Cycle, Fault> {
    named_cycle(text, None, vehicle)
}

/// As [`cycle`], of a table whose columns have these `names`: instead of its own, or if it has none. A column named `-` is
/// left out.
///
/// # Errors
/// As [`cycle`].
///
/// ```
/// use asperity_studies::cycle::named_cycle;
/// let names = ["time_s", "-", "torque_nm", "speed_rpm"].map(str::to_owned);
/// let found = named_cycle("0\t7\t10\t1000\n1\t7\t20\t1000\n", Some(&names), None)?;
/// assert_eq!(found.points[1].torque_nm, 20.0);
/// # Ok::<(), asperity_core::Fault>(())
/// ```
pub fn named_cycle(
    text: &str,
    names: Option<&[String]>,
    vehicle: Option<&VehicleInput>,
) -> Result<Cycle, Fault> {
    let table = CycleColumns(Table::named(text, names).map_err(error::ragged)?);
    let time = table.time()?;
    if time.len() < 2 {
        return Err(error::short());
    }
    if let Some(row) = (1..time.len()).find(|&k| time[k] <= time[k - 1]) {
        return Err(error::time(table.line(row), time[row], time[row - 1]));
    }
    let vehicle = vehicle.map(checked).transpose()?;
    let warnings = vehicle.map(VehicleInput::unusual).transpose();
    let mut warnings = warnings?.unwrap_or_default();
    let mut accelerations = Vec::new();
    let (torque, speed, way) = match [table.found("torque_nm")?, table.found("speed_rpm")?] {
        [Some(torque), Some(speed)] => {
            let (torque, speed) = (table.numbers(torque)?, table.numbers(speed)?);
            let way = vehicle.map(|vehicle| {
                let turns = speed.iter().map(|rpm| rpm.abs() * PI / 30.0);
                turns
                    .map(|omega| omega * vehicle.wheel_radius.si() / vehicle.ratio)
                    .collect()
            });
            (torque, speed, way)
        }
        _ => {
            let speed = table.column("speed_km_h")?;
            let speed = speed.ok_or_else(|| table.lacking())?;
            let vehicle = vehicle.ok_or_else(error::no_vehicle)?;
            let grade = table.column("grade_percent")?;
            let speeds: Vec<f64> = speed.iter().map(|speed| speed / 3.6).collect();
            accelerations = steps(&time, &speeds);
            let (torque, rpm) = at_the_pinion(vehicle, &time, &speeds, grade.as_deref());
            table.check("torque_nm of the vehicle", &torque)?;
            table.check("speed_rpm of the vehicle", &rpm)?;
            (torque, rpm, Some(speeds))
        }
    };
    warnings.extend(table.0.unread("the cycle"));
    let weights = weights(&time);
    let way_km = |speeds: Vec<f64>| {
        let metres = speeds.iter().zip(&weights).map(|(v, dt)| v.abs() * dt);
        metres.sum::<f64>() * 1e-3
    };
    let distance_km = way.map(way_km);
    let points = table.0.rows().enumerate().map(|(k, row)| CyclePoint {
        time_s: time[k],
        weight_s: weights[k],
        torque_nm: torque[k],
        speed_rpm: speed[k],
        line: row.line,
        acceleration: accelerations.get(k).copied(),
    });
    let points: Vec<CyclePoint> = points.collect();
    warnings.extend(jump(&points));
    Ok(Cycle {
        points,
        distance_km,
        warnings,
    })
}

/// Largest acceleration of a vehicle that its tyres transmit \[m/s²\]: a friction coefficient of 1.2 on dry asphalt, which
/// no tyre of road cars exceeds, times the standard acceleration of gravity. A larger one in a cycle is a fault of its recording.
pub(super) const MOST_ACCELERATION: f64 = 12.0;

/// W201 about the largest acceleration, if no tyre transmits it.
fn jump(points: &[CyclePoint]) -> Option<Warning> {
    let most = Extreme::most(points, |point| point.acceleration.map(f64::abs))?;
    let point = points.get(most.row)?;
    (most.value > MOST_ACCELERATION).then(|| {
        let text = format!(
            "{}: the speed of the vehicle changes by {:.1} m/s2 from the row before, more than the {MOST_ACCELERATION:.0} m/s2 that tyres \
                transmit; the torque there follows from it. Correct the recording",
            most.place(),
            point.acceleration.unwrap_or_default()
        );
        Warning::new(Code::W201, text)
    })
}

/// The largest number of a cycle, and its row.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Extreme {
    pub value: f64,
    pub row: usize,
    pub line: usize,
    pub time_s: f64,
}

impl Extreme {
    /// The largest of the numbers `of` the points; `None` of no number.
    pub(super) fn most(
        points: &[CyclePoint],
        of: impl Fn(&CyclePoint) -> Option<f64>,
    ) -> Option<Self> {
        let numbers = points.iter().enumerate();
        let numbers = numbers.filter_map(|(row, point)| Some((of(point)?, row, point)));
        // The first of several.
        let (value, row, point) = numbers.rev().max_by(|a, b| a.0.total_cmp(&b.0))?;
        Some(Self {
            value,
            row,
            line: point.line,
            time_s: point.time_s,
        })
    }

    /// Line and time in words.
    pub(super) fn place(&self) -> String {
        format!("line {} (t = {} s)", self.line, decimals(self.time_s, 2))
    }
}

/// Torque \[N m\] and speed \[1/min\] of the pinion from the speeds of the vehicle \[m/s\], both positive where the vehicle is
/// driven forwards. Drag and rolling resistance act against the motion; a positive grade rises forwards. At standstill the
/// brakes hold the vehicle.
fn at_the_pinion(
    vehicle: &VehicleInput,
    time: &[f64],
    speeds: &[f64],
    grade: Option<&[f64]>,
) -> (Vec<f64>, Vec<f64>) {
    let (mass, radius) = (vehicle.mass.si(), vehicle.wheel_radius.si());
    let inertia = vehicle.inertia_factor.unwrap_or(INERTIA);
    let usual = vehicle.grade.map_or(0.0, |grade| grade.value());
    let last = speeds.len() - 1;
    let force = |k: usize| {
        let (a, b) = (k.saturating_sub(1), (k + 1).min(last));
        let acceleration = (speeds[b] - speeds[a]) / (time[b] - time[a]);
        let slope = grade.map_or(usual, |grade| grade[k] / 100.0).atan();
        let v = speeds[k];
        let weight = if v == 0.0 { 0.0 } else { mass * GRAVITY };
        mass * inertia * acceleration
            + 0.5 * AIR * vehicle.drag_area.si() * v * v.abs()
            + weight * (v.signum() * vehicle.rolling_resistance * slope.cos() + slope.sin())
    };
    let torque = (0..=last).map(|k| force(k) * radius / vehicle.ratio);
    let rpm = speeds
        .iter()
        .map(|v| v / radius * vehicle.ratio * 30.0 / PI);
    (torque.collect(), rpm.collect())
}

fn checked(vehicle: &VehicleInput) -> Result<&VehicleInput, Fault> {
    let positive = [
        ("mass", vehicle.mass.si()),
        ("wheel_radius", vehicle.wheel_radius.si()),
        ("ratio", vehicle.ratio),
        ("inertia_factor", vehicle.inertia_factor.unwrap_or(INERTIA)),
    ];
    let not_negative = [
        ("drag_area", vehicle.drag_area.si()),
        ("rolling_resistance", vehicle.rolling_resistance),
    ];
    for (key, value) in positive {
        if !(value.is_finite() && value > 0.0) {
            let rule = "greater than zero";
            return Err(error::vehicle(key, value, rule));
        }
    }
    for (key, value) in not_negative {
        if !(value.is_finite() && value >= 0.0) {
            let rule = "zero or more";
            return Err(error::vehicle(key, value, rule));
        }
    }
    Ok(vehicle)
}

/// Slope from the row before to each row; 0 at the first.
fn steps(time: &[f64], values: &[f64]) -> Vec<f64> {
    let step = |(t, v): (&[f64], &[f64])| (v[1] - v[0]) / (t[1] - t[0]);
    let steps = time.windows(2).zip(values.windows(2)).map(step);
    std::iter::once(0.0).chain(steps).collect()
}

/// Half of both adjacent intervals.
fn weights(time: &[f64]) -> Vec<f64> {
    let last = time.len() - 1;
    let weight = |k: usize| 0.5 * (time[(k + 1).min(last)] - time[k.saturating_sub(1)]);
    (0..=last).map(weight).collect()
}

/// Largest time \[s\]: about thirty years.
const LONGEST: f64 = 1e9;
/// Largest speed of a vehicle \[km/h\], above the land speed record of 1228 km/h.
const FASTEST: f64 = 1500.0;
/// Largest grade \[%\]: 45 degrees.
const STEEPEST: f64 = 100.0;

/// Largest possible absolute value of a column; for the pinion, the limits of a case.
fn limit(column: &str) -> f64 {
    let of_case = |key| range_of(key).map_or(f64::MAX, |range| range.possible[1]);
    match column {
        "time_s" => LONGEST,
        "speed_km_h" => FASTEST,
        "grade_percent" => STEEPEST,
        column if column.starts_with("torque_nm") => of_case("operation.torque"),
        _ => of_case("operation.speed"),
    }
}

/// A quantity of a cycle: its column, the words that name it in other programs, and their units.
struct CycleQuantity {
    column: &'static str,
    words: &'static [&'static str],
    units: &'static [(&'static str, Unit)],
    /// Whole names without a unit.
    names: &'static [(&'static str, Unit)],
}

/// Unit of a column.
#[derive(Clone, Copy)]
enum Unit {
    /// This number of units of the quantity's own column.
    Of(f64),
    /// An angle of slope in degrees; the grade \[%\] is 100 tan of it.
    Degrees,
}

impl Unit {
    /// The unit of the quantity's own column.
    const OWN: Self = Self::Of(1.0);

    /// `value` in the unit of the quantity's own column.
    fn converted(self, value: f64) -> f64 {
        match self {
            Self::Of(factor) => factor * value,
            Self::Degrees => 100.0 * value.to_radians().tan(),
        }
    }
}

/// Columns of a cycle in other programs: VECTO (km/h, grades in per cent), FASTSim 2 and 3 (m/s, grades as fractions),
/// exports and recorded trips in several languages.
const QUANTITIES: [CycleQuantity; 5] = [
    CycleQuantity {
        column: "time_s",
        words: &[
            "time",
            "t",
            "elapsed",
            "cycle",
            "cyc",
            "cumulative",
            "test",
            "zeit",
            "temps",
            "tiempo",
            "tempo",
            "tid",
            "tijd",
        ],
        units: &[
            ("s", Unit::OWN),
            ("sec", Unit::OWN),
            ("secs", Unit::OWN),
            ("second", Unit::OWN),
            ("seconds", Unit::OWN),
            ("sek", Unit::OWN),
            ("ms", Unit::Of(1e-3)),
            ("min", Unit::Of(60.0)),
            ("h", Unit::Of(3600.0)),
        ],
        names: &[
            ("<t>", Unit::OWN),
            ("cycsecs", Unit::OWN),
            ("seconds", Unit::OWN),
            ("secs", Unit::OWN),
            ("sec", Unit::OWN),
        ],
    },
    CycleQuantity {
        column: "torque_nm",
        words: &[
            "torque",
            "trq",
            "pinion",
            "input",
            "shaft",
            "drehmoment",
            "moment",
            "ritzel",
            "couple",
            "par",
            "coppia",
        ],
        units: &[
            ("nm", Unit::OWN),
            ("n_m", Unit::OWN),
            ("knm", Unit::Of(1e3)),
        ],
        names: &[],
    },
    CycleQuantity {
        column: "speed_rpm",
        words: &[
            "speed",
            "n",
            "rotational",
            "pinion",
            "input",
            "shaft",
            "drehzahl",
            "ritzel",
            "vitesse",
            "velocidad",
            "giri",
        ],
        units: &[
            ("rpm", Unit::OWN),
            ("1_min", Unit::OWN),
            ("min_1", Unit::OWN),
            ("u_min", Unit::OWN),
            ("rev_min", Unit::OWN),
            ("tr_min", Unit::OWN),
            ("rad_s", Unit::Of(30.0 / PI)),
        ],
        names: &[],
    },
    CycleQuantity {
        column: "speed_km_h",
        words: &[
            "speed",
            "spd",
            "v",
            "vel",
            "velocity",
            "vehicle",
            "veh",
            "target",
            "cycle",
            "cyc",
            "dyno",
            "geschwindigkeit",
            "fahrzeuggeschwindigkeit",
            "vitesse",
            "velocidad",
            "velocità",
            "velocita",
            "snelheid",
            "hastighet",
        ],
        units: &[
            ("km_h", Unit::OWN),
            ("kmh", Unit::OWN),
            ("kph", Unit::OWN),
            ("kmph", Unit::OWN),
            ("km_hr", Unit::OWN),
            ("m_s", Unit::Of(3.6)),
            ("mps", Unit::Of(3.6)),
            ("m_sec", Unit::Of(3.6)),
            ("meters_per_second", Unit::Of(3.6)),
            ("mph", Unit::Of(MILE)),
            ("mi_h", Unit::Of(MILE)),
            ("miles_per_hour", Unit::Of(MILE)),
        ],
        names: &[
            ("<v>", Unit::OWN),
            ("cycmps", Unit::Of(3.6)),
            ("mps", Unit::Of(3.6)),
            ("mph", Unit::Of(MILE)),
            ("kph", Unit::OWN),
            ("kmh", Unit::OWN),
            ("km_h", Unit::OWN),
        ],
    },
    CycleQuantity {
        column: "grade_percent",
        words: &[
            "grade",
            "grad",
            "road",
            "slope",
            "gradient",
            "steigung",
            "pente",
            "pendiente",
            "pendenza",
        ],
        units: &[
            ("percent", Unit::OWN),
            ("pct", Unit::OWN),
            ("deg", Unit::Degrees),
            ("degrees", Unit::Degrees),
        ],
        names: &[
            ("<grad>", Unit::OWN),
            ("grade", Unit::Of(100.0)),
            ("cycgrade", Unit::Of(100.0)),
        ],
    },
];

/// Kilometres in a mile.
const MILE: f64 = 1.609_344;

/// Names of a column of dates or times of day, which is read as the time if there is no other.
const CLOCKS: [&str; 7] = [
    "datetime",
    "date_time",
    "timestamp",
    "time_stamp",
    "date",
    "zeitstempel",
    "datum",
];

impl CycleQuantity {
    /// Unit of the column `name`; `None` if the name is of another quantity.
    fn unit(&self, name: &str) -> Option<Unit> {
        if name == self.column {
            return Some(Unit::OWN);
        }
        if let Some((_, unit)) = self.names.iter().find(|(known, _)| *known == name) {
            return Some(*unit);
        }
        let of_unit = |(suffix, unit): &(&str, Unit)| {
            let words = name.strip_suffix(suffix)?.strip_suffix('_')?;
            let is_word = |word: &str| self.words.contains(&word);
            words.split('_').all(is_word).then_some(*unit)
        };
        self.units.iter().find_map(of_unit)
    }
}

/// Seconds of a date with a time of day, such as `2007-08-25 11:07:21.5`, since the first day of a calendar.
fn seconds(text: &str) -> Option<f64> {
    let (date, clock) = match text.split_once([' ', 'T']) {
        Some((date, clock)) => (date, clock.trim_end_matches('Z')),
        None => ("0-1-1", text),
    };
    let mut date = date.split(['-', '/']).map(str::parse::<i64>);
    let (Some(Ok(year)), Some(Ok(month @ 1..=12)), Some(Ok(day @ 1..=31)), None) =
        (date.next(), date.next(), date.next(), date.next())
    else {
        return None;
    };
    let mut clock = clock.split(':').map(str::parse::<f64>);
    let (Some(Ok(hour)), Some(Ok(minute)), second, None) =
        (clock.next(), clock.next(), clock.next(), clock.next())
    else {
        return None;
    };
    let second = second.map_or(Some(0.0), Result::ok)?;
    // Days since 1 March of the year 0 in the Gregorian calendar, whose years begin in March.
    let (year, month) = if month < 3 {
        (year - 1, month + 9)
    } else {
        (year, month - 3)
    };
    let days = 365 * year + year.div_euclid(4) - year.div_euclid(100)
        + year.div_euclid(400)
        + (153 * month + 2) / 5
        + day;
    Some(86_400.0 * days as f64 + 3600.0 * hour + 60.0 * minute + second)
}

/// A cycle as a table.
struct CycleColumns(Table);

/// A column of [`QUANTITIES`] in a table.
struct Found<'a> {
    column: &'static str,
    /// Its name in the table.
    name: &'a str,
    unit: Unit,
}

impl CycleColumns {
    fn lacking(&self) -> Fault {
        let found = Vec::from_iter(self.0.heads()).join(", ");
        error::columns(&found, self.0.has_names())
    }

    /// The times \[s\]: a column of them, or of dates, from the first.
    fn time(&self) -> Result<Vec<f64>, Fault> {
        if let Some(time) = self.column("time_s")? {
            return Ok(time);
        }
        let clock = CLOCKS.into_iter().find(|name| self.0.has(name));
        let clock = clock.ok_or_else(|| self.lacking())?;
        let time = self.0.values(|row| {
            let text = row.text(clock).unwrap_or_default();
            let fault = || {
                row.fault(
                    clock,
                    format!("{text:?} is not a date and time, 2026-01-31 12:30:00"),
                )
            };
            seconds(text).ok_or_else(fault)
        });
        let time = time.map_err(error::cell)?;
        Ok(time.iter().map(|at| at - time[0]).collect())
    }

    /// A column of [`QUANTITIES`]; `None` if the table has none of its names.
    fn found(&self, column: &'static str) -> Result<Option<Found<'_>>, Fault> {
        let known = QUANTITIES.iter().find(|quantity| quantity.column == column);
        let names = self.0.names().iter().map(String::as_str);
        let mut there = names.filter_map(|name| Some((name, known?.unit(name)?)));
        let Some((name, unit)) = there.next() else {
            return Ok(None);
        };
        if let Some((other, _)) = there.next() {
            return Err(error::twice(name, other));
        }
        Ok(Some(Found { column, name, unit }))
    }

    /// The numbers of a column that was found.
    fn numbers(&self, found: Found<'_>) -> Result<Vec<f64>, Fault> {
        let Found { column, name, unit } = found;
        let numbers = self.0.values(|row| Ok(unit.converted(row.number(name)?)));
        let numbers = numbers.map_err(error::cell)?;
        self.check(column, &numbers)?;
        Ok(numbers)
    }

    /// The numbers of a column of [`QUANTITIES`]; `None` if the table has none of its names.
    fn column(&self, column: &'static str) -> Result<Option<Vec<f64>>, Fault> {
        let found = self.found(column)?;
        found.map(|found| self.numbers(found)).transpose()
    }

    /// Rejects impossible numbers of a column.
    fn check(&self, column: &'static str, numbers: &[f64]) -> Result<(), Fault> {
        let limit = limit(column);
        let beyond = numbers
            .iter()
            .position(|value| value.abs() > limit || value.is_nan());
        beyond.map_or(Ok(()), |row| {
            Err(error::beyond(self.line(row), column, numbers[row], limit))
        })
    }

    /// Line of the file at which a row begins.
    fn line(&self, row: usize) -> usize {
        self.0.rows().nth(row).map_or(0, |row| row.line)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn vehicle() -> VehicleInput {
        VehicleInput {
            mass: "1500 kg".parse().unwrap(),
            wheel_radius: "300 mm".parse().unwrap(),
            ratio: 10.0,
            drag_area: "0.6 m2".parse().unwrap(),
            rolling_resistance: 0.01,
            inertia_factor: Some(1.0),
            grade: None,
        }
    }

    #[test]
    fn a_steady_speed_meets_drag_and_rolling_resistance_alone() {
        let text = "time_s,speed_km_h\n0,72\n1,72\n2,72\n";
        let found = cycle(text, Some(&vehicle())).unwrap();
        // 20 m/s: 144.48 N of drag, 147.09975 N of rolling resistance.
        let force = 0.5 * 1.204 * 0.6 * 400.0 + 1500.0 * 9.806_65 * 0.01;
        let point = found.points[1];
        assert!((point.torque_nm - force * 0.03).abs() < 1e-12);
        assert!((point.speed_rpm - 20.0 / 0.3 * 10.0 * 30.0 / PI).abs() < 1e-9);
        assert!((found.distance_km.unwrap() - 0.04).abs() < 1e-12);
    }

    #[test]
    fn acceleration_and_grade_add_their_forces() {
        let up = "time_s,speed_km_h,grade_percent\n0,0,0\n1,3.6,0\n2,7.2,100\n3,10.8,0\n";
        let found = cycle(up, Some(&vehicle())).unwrap();
        let level = cycle(
            "time_s,speed_km_h\n0,0\n1,3.6\n2,7.2\n3,10.8\n",
            Some(&vehicle()),
        )
        .unwrap();
        // At standstill the acceleration alone: 1500 N at the wheel.
        assert!((found.points[0].torque_nm - 45.0).abs() < 1e-9);
        let slope = std::f64::consts::FRAC_PI_4;
        let more = 1500.0 * 9.806_65 * (slope.sin() + 0.01 * (slope.cos() - 1.0)) * 0.03;
        let difference = found.points[2].torque_nm - level.points[2].torque_nm;
        assert!((difference - more).abs() < 1e-9);
    }

    #[test]
    fn a_vehicle_in_reverse_has_mirrored_torques_and_equal_power() {
        let text = "time_s,speed_km_h,grade_percent\n0,0,0\n1,3.6,2\n3,9,-5\n4,9,0\n6,0,0\n";
        let mirrored = "time_s,speed_km_h,grade_percent\n0,0,0\n1,-3.6,-2\n3,-9,5\n4,-9,0\n6,0,0\n";
        let [forwards, reverse] =
            [text, mirrored].map(|text| cycle(text, Some(&vehicle())).unwrap());
        for (there, back) in forwards.points.iter().zip(&reverse.points) {
            assert_eq!(there.torque_nm, -back.torque_nm);
            assert_eq!(there.speed_rpm, -back.speed_rpm);
            assert_eq!(there.power_w(), back.power_w());
        }
        assert!(forwards.points[1].power_w() > 0.0 && forwards.points[3].power_w() < 0.0);
        assert_eq!(forwards.distance_km, reverse.distance_km);
    }

    #[test]
    fn a_reversed_cycle_has_the_energy_of_its_mirror() {
        // Times, speeds in km/h and grades in per cent.
        let rows: [&[[f64; 3]]; 12] = [
            &[
                [0.0, 0.0, 0.0],
                [10.0, 10.0, 0.0],
                [20.0, 10.0, 0.0],
                [30.0, 0.0, 0.0],
            ],
            &[
                [0.0, 0.0, 0.0],
                [10.0, 10.0, 4.0],
                [20.0, 10.0, 4.0],
                [30.0, 0.0, 0.0],
            ],
            &[
                [0.0, 0.0, 0.0],
                [10.0, 10.0, -9.0],
                [20.0, 10.0, -9.0],
                [30.0, 0.0, 0.0],
            ],
            &[[0.0, 5.0, 0.0], [1.0, 5.0, 0.0]],
            &[
                [0.0, 0.0, 0.0],
                [1.0, 20.0, 0.0],
                [2.0, -20.0, 0.0],
                [3.0, 0.0, 0.0],
            ],
            &[[0.0, 3.0, 2.0], [0.5, -3.0, 2.0], [7.0, 3.0, -2.0]],
            &[[0.0, 0.0, 8.0], [60.0, 0.0, 8.0], [61.0, 4.0, 8.0]],
            &[[0.0, 120.0, 0.0], [5.0, 0.0, 0.0], [9.0, 0.0, 0.0]],
            &[
                [-5.0, 1.0, 1.0],
                [0.0, 2.0, 3.0],
                [5.0, 4.0, 9.0],
                [11.0, 8.0, 27.0],
            ],
            &[[0.0, 0.1, 0.0], [0.1, 0.2, 0.0], [0.2, 0.1, 0.0]],
            &[[0.0, 30.0, 0.0], [600.0, 30.0, 0.0], [1200.0, 60.0, -1.0]],
            &[[100.0, 7.0, 0.0], [101.0, 0.0, 50.0], [102.0, 7.0, -50.0]],
        ];
        for rows in rows {
            let of = |sign: f64| {
                let row = |[time, speed, grade]: &[f64; 3]| {
                    format!("{time},{},{}\n", sign * speed, sign * grade)
                };
                let table: String = rows.iter().map(row).collect();
                let text = format!("time_s,speed_km_h,grade_percent\n{table}");
                cycle(&text, Some(&vehicle())).unwrap()
            };
            let energy = |cycle: &Cycle, driving: bool| {
                let points = cycle
                    .points
                    .iter()
                    .map(|point| point.power_w() * point.weight_s);
                points
                    .filter(|energy| (*energy > 0.0) == driving)
                    .sum::<f64>()
            };
            let [there, back] = [of(1.0), of(-1.0)];
            assert_eq!(there.distance_km, back.distance_km);
            for driving in [true, false] {
                assert_eq!(energy(&there, driving), energy(&back, driving), "{rows:?}");
            }
            let moving = |(one, _): &(&CyclePoint, &CyclePoint)| one.speed_rpm != 0.0;
            for (one, other) in there.points.iter().zip(&back.points).filter(moving) {
                assert_eq!(one.forwards(), other.forwards(), "{rows:?}");
            }
        }
    }

    #[test]
    fn cycles_of_other_programs_and_tables_are_one() {
        let own = "time_s,speed_km_h,grade_percent\n0,0,0\n10,10.8,1\n20.5,10.8,1\n30,0,0\n";
        let own = cycle(own, Some(&vehicle())).unwrap();
        for text in [
            "<t>,<v>,<grad>\n0,0,0\n10,10.8,1\n20.5,10.8,1\n30,0,0\n",
            "time_seconds,speed_meters_per_second,grade,road_type\n0,0,0,0\n10,3,0.01,0\n20.5,3,0.01,0\n30,0,0,0\n",
            "cycSecs,cycMps,cycGrade,cycRoadType\n0,0,0,0\n10,3,0.01,0\n20.5,3,0.01,0\n30,0,0,0\n",
            "Zeit [s];Geschwindigkeit [km/h];Steigung [%]\n0;0;0\n10;10,8;1\n20,5;10,8;1\n30;0;0\n",
            "time [s]\tspeed [m/s]\tgrade [%]\r\n0\t0\t0\r\n10\t3\t1\r\n20.5\t3\t1\r\n30\t0\t0\r\n",
        ] {
            let found = cycle(text, Some(&vehicle())).unwrap();
            assert_eq!(found.points.len(), own.points.len());
            for (a, b) in found.points.iter().zip(&own.points) {
                assert_eq!(a.time_s, b.time_s);
                assert!((a.torque_nm - b.torque_nm).abs() < 1e-9, "{text}");
                assert!((a.speed_rpm - b.speed_rpm).abs() < 1e-9, "{text}");
            }
        }
        // Speeds of the vehicle 0, 3, 3, 0 m/s and a grade of 1 %, as other programs and people write them.
        for (names, rows, head) in [
            (
                None,
                "0,0,0\n10,10.8,1\n20.5,10.8,1\n30,0,0\n",
                "t [s],v [km/h],grade [%]\n",
            ),
            (
                None,
                "0;0;0\n10;10,8;1\n20,5;10,8;1\n30;0;0\n",
                "Temps [s];Vitesse [km/h];Pente [%]\n",
            ),
            (
                None,
                "0;0;0\n10;10,8;1\n20,5;10,8;1\n30;0;0\n",
                "Tiempo (s);Velocidad (km/h);Pendiente (%)\n",
            ),
            (
                None,
                "0;0;0\n10;10,8;1\n20,5;10,8;1\n30;0;0\n",
                "Tempo [s];Velocità [km/h];Pendenza [%]\n",
            ),
            (
                None,
                "0,0,0\n10,0,1\n20.5,0,1\n30,0,0\n",
                "time_s,speed_mph,slope_pct\n",
            ),
            (
                None,
                "0,0,0\n1,10,10.8\n1,20.5,10.8\n0,30,0\n",
                "Road grade (%),Elapsed time (s),Vehicle speed (km/h)\n",
            ),
            (
                None,
                "0,0,0\n10,3,0.01\n20.5,3,0.01\n30,0,0\n",
                "time_s,mps,grade\n",
            ),
            (
                None,
                "0,0,0\n10,3,0.57293869768\n20.5,3,0.57293869768\n30,0,0\n",
                "time_s,v_mps,grade_deg\n",
            ),
            (
                None,
                "0,0,0\n10,10.8,1\n20.5,10.8,1\n30,0,0\n",
                "Trip 7\ntime,speed,grade\ns,km/h,%\n",
            ),
            (
                None,
                "0  0  0\n10  10.8  1\n20.5  10.8  1\n30  0  0\n",
                "time_s speed_km_h grade_percent\n",
            ),
            (
                None,
                "2026-01-31 23:59:50,0,0\n2026-02-01 00:00:00,10.8,1\n2026-02-01 00:00:10.5,10.8,1\n2026-02-01 00:00:20,0,0\n",
                "timestamp,speed_kph,grade_percent\n",
            ),
            (
                None,
                "12:00:00;0;0\n12:00:10;10,8;1\n12:00:20,5;10,8;1\n12:00:30;0;0\n",
                "Zeitstempel;Geschwindigkeit [km/h];Steigung [%]\n",
            ),
            (
                Some("time_s,speed_km_h,grade_percent"),
                "0 0 0\n10 10.8 1\n20.5 10.8 1\n30 0 0\n",
                "",
            ),
            (
                Some("-,time_s,speed_m_s,grade"),
                "1\t0\t0\t0\n2\t10\t3\t.01\n3\t20.5\t3\t.01\n4\t30\t0\t0\n",
                "a\tb\tc\td\n",
            ),
        ] {
            let names = names.map(|names| names.split(',').map(str::to_owned).collect::<Vec<_>>());
            let rows = if head.contains("mph") {
                rows.replace(",0,1", &format!(",{},1", 10.8 / MILE))
            } else {
                rows.to_owned()
            };
            let rows = if head.contains("Zeitstempel") {
                rows.replace("20,5;", "20.5;").replace("10,8", "10.8")
            } else {
                rows
            };
            let found = named_cycle(
                &(head.to_owned() + &rows),
                names.as_deref(),
                Some(&vehicle()),
            );
            let found = found.unwrap_or_else(|error| panic!("{head}: {error}"));
            assert_eq!(found.warnings, [], "{head}");
            assert_eq!(found.points.len(), own.points.len());
            for (a, b) in found.points.iter().zip(&own.points) {
                assert_eq!(a.time_s, b.time_s, "{head}");
                assert!((a.torque_nm - b.torque_nm).abs() < 1e-7, "{head}");
                assert!((a.speed_rpm - b.speed_rpm).abs() < 1e-9, "{head}");
            }
        }
        // Torque and speed of the pinion.
        for text in [
            "Zeit [s];Drehmoment [Nm];Drehzahl [1/min]\n0;10;60\n1;20;60\n",
            "time_s,torque [N m],pinion speed (rad/s)\n0,10,6.283185307179586\n1,20,6.283185307179586\n",
            "Temps [s];Couple [Nm];Vitesse [tr/min]\n0;10;60\n1;20;60\n",
        ] {
            let found = cycle(text, None).unwrap_or_else(|error| panic!("{text}: {error}"));
            assert!((found.points[1].torque_nm - 20.0).abs() < 1e-12);
            assert!((found.points[1].speed_rpm - 60.0).abs() < 1e-9, "{text}");
        }
        let unread = cycle(
            "time_s,torque_nm,speed_rpm,gear,remark\n0,1,1,2,a\n1,1,1,2,b\n",
            None,
        );
        let [warning] = &unread.unwrap().warnings[..] else {
            panic!("one warning names all columns that are not read");
        };
        assert_eq!(
            warning.to_string(),
            "W454 columns of the cycle that are not read: gear, remark"
        );
        // A grade in per cent in the column of a fraction.
        let steep = "time_seconds,speed_meters_per_second,grade\n0,0,0\n10,3,4\n20,3,0\n";
        let error = cycle(steep, Some(&vehicle())).unwrap_err().to_string();
        assert!(error.contains("grade_percent = 400 is beyond"), "{error}");
    }

    #[test]
    fn what_is_no_cycle_is_told_by_its_line() {
        let of = |text: &str| cycle(text, None).unwrap_err().to_string();
        assert!(of("time_s,torque_nm,speed_rpm\n0,1,1\n0,1,1\n").starts_with("line 3: time_s"));
        assert!(of("time_s,torque_nm,speed_rpm\n0,1,x\n1,1,1\n").starts_with("line 2: speed_rpm"));
        assert!(of("time_s,torque_nm,speed_rpm\n0,1\n1,1,1\n").starts_with("line 2 has 2 cells"));
        let twice = of("time_s,speed_km_h,v [m/s]\n0,1,1\n1,1,1\n");
        assert!(twice.starts_with("columns speed_km_h and v_m_s"), "{twice}");
        assert!(of("t,torque\n0,1\n").contains("t, torque"));
        assert!(of("0,1\n2,3\n").starts_with("no line of names above the first row 0, 1"));
        let back = of("time,torque_nm,speed_rpm\n12:00,1,1\n12:01,1,1\n11:59,1,1\n");
        assert!(back.starts_with("columns time, torque_nm"), "{back}");
        let back = of("timestamp,torque_nm,speed_rpm\n12:00,1,1\n12:01,1,1\n11:59,1,1\n");
        assert!(back.contains("if another recording begins here"), "{back}");
        let bad = VehicleInput {
            ratio: 0.0,
            ..vehicle()
        };
        let error = cycle("time_s,speed_km_h\n0,1\n1,1\n", Some(&bad)).unwrap_err();
        assert!(error.to_string().contains("vehicle.ratio"));
    }

    #[test]
    fn a_number_beyond_any_cycle_is_refused_with_column_and_line() {
        let of = |text: &str| cycle(text, Some(&vehicle())).unwrap_err().to_string();
        let speed = of("# made up\ntime_s,speed_km_h\n0,0\n1,5000\n2,0\n");
        assert!(
            speed.starts_with("line 4: speed_km_h = 5000 is beyond -1500 to 1500"),
            "{speed}"
        );
        for (text, expected) in [
            (
                "time_s,torque_nm,speed_rpm\n0,1,1\n1,1e308,1\n",
                "line 3: torque_nm",
            ),
            (
                "time_s,torque_nm,speed_rpm\n0,1,-2e6\n1,1,1\n",
                "line 2: speed_rpm",
            ),
            (
                "time_s,torque_nm,speed_rpm\n0,1,1\n1e300,1,1\n",
                "line 3: time_s",
            ),
            (
                "time_s,speed_km_h,grade_percent\n0,1,101\n1,1,0\n",
                "line 2: grade_percent",
            ),
            (
                "time_s,speed_km_h\n0,0\n1e-9,1000\n",
                "line 2: torque_nm of the vehicle",
            ),
        ] {
            let said = of(text);
            assert!(said.starts_with(expected), "{said}");
        }
    }
}
