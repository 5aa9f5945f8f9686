//! Readings of a traction machine, and the set points that they belong to.

use std::collections::BTreeMap;

use asperity_core::quantity::{Force, Length, Speed, Temperature};

use super::machine::{Machine, Setting};

/// Reading of a machine.
#[derive(Debug, Clone, PartialEq)]
pub struct Reading {
    /// Name of the file.
    pub file: String,
    /// Line in the file, from 1.
    pub line: usize,
    /// Step of the file, 0 if it has none.
    pub step: usize,
    /// Group of readings with a common calibration of load and force.
    pub group: String,
    /// The machine.
    pub machine: Machine,
    /// Load, mean speed, slide-to-roll ratio and temperature.
    pub setting: Setting,
    /// Temperature that the machine was set to \[°C\].
    pub set_temperature_c: f64,
    /// Time for which the specimens have rubbed before \[s\], if stated.
    pub rubbing_s: Option<f64>,
    /// Friction coefficient.
    pub traction: f64,
    /// Its standard deviation, if stated.
    pub sigma: Option<f64>,
    /// Measured film, if stated.
    pub film: Option<Length>,
    /// Two columns of the reading that contradict each other, in words; set points leave such a reading out.
    pub contradiction: Option<String>,
}

impl Reading {
    /// Temperature of a reading in °C rounded to 5 K, as a machine is set.
    #[must_use]
    pub(crate) fn rounded_temperature(celsius: f64) -> f64 {
        const STEP: f64 = 5.0;
        (celsius / STEP).round() * STEP
    }
}

/// Mean of the readings at one load, speed, slide-to-roll ratio and set temperature.
#[derive(Debug, Clone, PartialEq)]
pub struct SetPoint {
    /// Mean of its readings; the line of the first.
    pub reading: Reading,
    /// Number of readings.
    pub readings: usize,
    /// Curve: one load, speed, set temperature, time of rubbing and file or step.
    pub curve: usize,
    /// Whether it is half the difference of readings with both signs of the slide-to-roll ratio.
    pub has_both_signs: bool,
}

/// Relative difference below which two settings are the same.
const SAME: f64 = 0.01;

/// Whether two settings are the same.
pub(super) fn is_same(a: f64, b: f64) -> bool {
    (a - b).abs() <= SAME * a.abs().max(b.abs())
}

fn is_same_curve(a: &Reading, b: &Reading) -> bool {
    a.file == b.file
        && a.step == b.step
        && a.group == b.group
        && a.machine == b.machine
        && a.set_temperature_c == b.set_temperature_c
        && a.rubbing_s == b.rubbing_s
        && is_same(a.setting.load.si(), b.setting.load.si())
        && is_same(a.setting.mean_speed.si(), b.setting.mean_speed.si())
}

/// Mean of readings at one setting.
fn mean(readings: &[&Reading]) -> Reading {
    let of = |value: &dyn Fn(&Reading) -> f64| {
        readings.iter().map(|reading| value(reading)).sum::<f64>() / readings.len() as f64
    };
    let first = readings[0];
    let sigma = readings.iter().map(|reading| reading.sigma);
    let sigma: Option<Vec<f64>> = sigma.collect();
    let film = readings.iter().map(|reading| reading.film.map(Length::si));
    let film: Option<Vec<f64>> = film.collect();
    let count = readings.len() as f64;
    Reading {
        setting: Setting {
            load: Force::from_si(of(&|one| one.setting.load.si())),
            mean_speed: Speed::from_si(of(&|one| one.setting.mean_speed.si())),
            slide_to_roll: of(&|one| one.setting.slide_to_roll),
            temperature: Temperature::from_si(of(&|one| one.setting.temperature.si())),
        },
        traction: of(&|one| one.traction),
        // Of the mean of independent readings.
        sigma: sigma.map(|all| all.iter().map(|s| s * s).sum::<f64>().sqrt() / count),
        film: film.map(|all| Length::from_si(all.iter().sum::<f64>() / count)),
        ..first.clone()
    }
}

/// Half the difference of the means at both signs of the slide-to-roll ratio, which removes zero and rolling friction.
fn half_difference(positive: &Reading, negative: &Reading) -> Reading {
    let both = mean(&[positive, negative]);
    Reading {
        setting: Setting {
            slide_to_roll: 0.5 * (positive.setting.slide_to_roll - negative.setting.slide_to_roll),
            ..both.setting
        },
        traction: 0.5 * (positive.traction - negative.traction),
        ..both
    }
}

/// Sign convention of the friction of a file.
///
/// A single curve does not determine it: its friction may be smaller than the zero error of the machine.
#[derive(Debug, Clone, Copy, Default)]
struct Signs {
    /// Sum of the friction at positive slide-to-roll ratios.
    ahead: f64,
    /// Sum of the friction at negative ratios.
    behind: f64,
}

impl Signs {
    fn by_file(readings: &[Reading]) -> BTreeMap<&str, Self> {
        let mut files: BTreeMap<&str, Self> = BTreeMap::new();
        for reading in readings {
            let signs = files.entry(&reading.file).or_default();
            match reading.setting.slide_to_roll {
                slide if slide > 0.0 => signs.ahead += reading.traction,
                slide if slide < 0.0 => signs.behind += reading.traction,
                _ => {}
            }
        }
        files
    }

    /// Whether the force is the one on the other body.
    fn is_opposed(self) -> bool {
        self.ahead < 0.0
    }

    /// Whether the friction at negative slide-to-roll ratios has their sign, and is not only a magnitude.
    fn is_signed(self) -> bool {
        if self.is_opposed() {
            self.behind >= 0.0
        } else {
            self.behind <= 0.0
        }
    }
}

/// A reading at a negative slide-to-roll ratio as one at a positive ratio.
fn turned(mut negative: Reading, is_signed: bool) -> Reading {
    if is_signed {
        negative.traction *= -1.0;
    }
    negative.setting.slide_to_roll *= -1.0;
    negative
}

/// The readings that contradict themselves, in words; `None` if there are none.
pub(super) fn left_out(readings: &[Reading]) -> Option<String> {
    let with = |reading: &Reading| {
        let rule = reading.contradiction.as_ref()?;
        Some(format!("{}:{}: {rule}", reading.file, reading.line))
    };
    let mut found = readings.iter().filter_map(with);
    let first = found.next()?;
    Some(match found.count() {
        0 => format!("one reading is left out: {first}"),
        more => format!("{} readings are left out, the first is {first}", more + 1),
    })
}

/// The set points of readings, in the order of curves and slide-to-roll ratios; whatever the order of the readings.
///
/// A set point with a negative slide-to-roll ratio only has the sign of ratio and friction changed. So has the friction of a
/// file that is negative at positive ratios: the force is the one on the other body.
#[must_use]
pub fn set_points(readings: &[Reading]) -> Vec<SetPoint> {
    let mut curves: Vec<Vec<&Reading>> = Vec::new();
    for reading in readings.iter().filter(|one| one.contradiction.is_none()) {
        match curves
            .iter_mut()
            .find(|curve| is_same_curve(curve[0], reading))
        {
            Some(curve) => curve.push(reading),
            None => curves.push(vec![reading]),
        }
    }
    let key = |curve: &Vec<&Reading>| {
        let at = &curve[0].setting;
        let rubbing = curve[0].rubbing_s.unwrap_or(0.0);
        let celsius = curve[0].set_temperature_c;
        [rubbing, celsius, at.load.si(), at.mean_speed.si()]
    };
    curves.sort_by(|a, b| {
        let places = [a, b].map(|curve| (&curve[0].file, curve[0].step));
        let pairs = key(a).into_iter().zip(key(b));
        let order = pairs.map(|(a, b)| a.total_cmp(&b));
        let order = order.fold(std::cmp::Ordering::Equal, std::cmp::Ordering::then);
        order.then(places[0].cmp(&places[1]))
    });
    let signs = Signs::by_file(readings);
    let curves = curves.iter().enumerate();
    curves
        .flat_map(|(number, curve)| points_of(number, curve, signs[curve[0].file.as_str()]))
        .collect()
}

fn points_of(curve: usize, readings: &[&Reading], signs: Signs) -> Vec<SetPoint> {
    let mut sorted = readings.to_vec();
    sorted.sort_by(|a, b| {
        let slides = [a, b].map(|one| one.setting.slide_to_roll);
        slides[0]
            .total_cmp(&slides[1])
            .then(a.traction.total_cmp(&b.traction))
    });
    let mut settings: Vec<Vec<&Reading>> = Vec::new();
    for reading in sorted {
        let slide = reading.setting.slide_to_roll;
        match settings.last_mut() {
            Some(last) if is_same(last[0].setting.slide_to_roll, slide) => last.push(reading),
            _ => settings.push(vec![reading]),
        }
    }
    let mut means: Vec<(Reading, usize)> =
        settings.iter().map(|all| (mean(all), all.len())).collect();
    if signs.is_opposed() {
        means.iter_mut().for_each(|(one, _)| one.traction *= -1.0);
    }
    let (negative, positive): (Vec<_>, Vec<_>) = means
        .into_iter()
        .partition(|(one, _)| one.setting.slide_to_roll < 0.0);
    let mut points: BTreeMap<u64, SetPoint> = BTreeMap::new();
    let mut put = |reading: Reading, readings: usize, has_both_signs: bool| {
        let point = SetPoint {
            reading,
            readings,
            curve,
            has_both_signs,
        };
        // Positive numbers are in the order of their bits.
        points.insert(point.reading.setting.slide_to_roll.to_bits(), point);
    };
    let is_signed = signs.is_signed();
    let mut unpaired = negative;
    for (reading, count) in positive {
        let slide = reading.setting.slide_to_roll;
        let other = unpaired
            .iter()
            .position(|(one, _)| is_same(-one.setting.slide_to_roll, slide));
        match other.map(|k| unpaired.remove(k)) {
            Some((other, more)) if is_signed => {
                put(half_difference(&reading, &other), count + more, true);
            }
            Some((other, more)) => put(
                mean(&[&reading, &turned(other, is_signed)]),
                count + more,
                false,
            ),
            None => put(reading, count, false),
        }
    }
    for (reading, count) in unpaired {
        put(turned(reading, is_signed), count, false);
    }
    points.into_values().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn reading(slide_to_roll: f64, traction: f64) -> Reading {
        let length = Length::from_si;
        Reading {
            file: "a.csv".to_owned(),
            line: 2,
            step: 0,
            group: String::new(),
            machine: Machine::ball_on_disc(length(9.525e-3), None, length(15e-9)).unwrap(),
            setting: Setting {
                load: Force::from_si(30.0),
                mean_speed: Speed::from_si(2.0),
                slide_to_roll,
                temperature: Temperature::from_celsius(81.0),
            },
            set_temperature_c: Reading::rounded_temperature(81.0),
            rubbing_s: None,
            traction,
            sigma: None,
            film: None,
            contradiction: None,
        }
    }

    #[test]
    fn readings_of_a_set_point_are_averaged_and_both_signs_subtracted() {
        let mut all = vec![
            reading(0.1, 0.021),
            reading(0.1004, 0.023),
            reading(-0.1, -0.016),
            reading(-0.2, -0.024),
            reading(0.3, 0.03),
        ];
        let points = set_points(&all);
        let seen: Vec<(f64, f64, usize, bool)> = points
            .iter()
            .map(|p| {
                (
                    p.reading.setting.slide_to_roll,
                    p.reading.traction,
                    p.readings,
                    p.has_both_signs,
                )
            })
            .collect();
        let expected = [
            (0.1001, 0.019, 3, true),
            (0.2, 0.024, 1, false),
            (0.3, 0.03, 1, false),
        ];
        assert_eq!(seen.len(), 3);
        for (seen, expected) in seen.iter().zip(expected) {
            assert!((seen.0 - expected.0).abs() < 1e-12 && (seen.1 - expected.1).abs() < 1e-12);
            assert_eq!((seen.2, seen.3), (expected.2, expected.3));
        }
        assert_eq!(points[0].reading.set_temperature_c, 80.0);
        all.reverse();
        assert_eq!(set_points(&all).len(), 3);
        // The force on the other body.
        let opposed: Vec<Reading> = all
            .iter()
            .map(|one| reading(one.setting.slide_to_roll, -one.traction))
            .collect();
        assert_eq!(set_points(&opposed), set_points(&all));
        assert!((set_points(&all)[0].reading.traction - 0.019).abs() < 1e-12);
    }
}
