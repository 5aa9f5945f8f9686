//! Readings from the text export of a PCS traction machine (MTM, EHD): tab-separated, in steps.
//!
//! Every step whose table has load, rolling speed, slide-to-roll ratio and traction coefficient is read, whatever the type
//! of the step is called. The first columns of a table are repeated further right; the last one of each name is taken.

use asperity_core::quantity::{Force, Speed, Temperature};

use super::error::OilError;
use super::machine::{Machine, Setting};
use super::reading::Reading;

const TRACTION: &str = "Traction Coeff (-)";
const SLIDE: &str = "SRR (%)";
const SPEED: &str = "Rolling Speed (mm/s)";
const LOAD: &str = "Ball Load (N)";
const SLIDING: &str = "Sliding Speed (mm/s)";
const FORCE: &str = "Traction Force (N)";
/// Beginnings of the names of the temperatures of the oil at the contact, and of the pot.
const LUBE: [&str; 2] = ["Lube RTD Temp", "Lube Temp"];
const POT: [&str; 2] = ["Pot RTD Temp", "Pot Temp"];
/// Difference \[K\] from the pot at which a probe of the oil reads air.
const AIR: f64 = 15.0;
/// Tolerances of two columns that state one quantity: relative, and by rounding.
const SAME: [f64; 2] = [0.02, 1.5e-4];

/// Probe whose temperature is taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Probe {
    /// In the oil at the contact.
    #[default]
    Lube,
    /// In the pot.
    Pot,
}

/// Whether a text is an export of such a machine.
#[must_use]
pub fn is_pcs(text: &str) -> bool {
    let first = text.trim_start_matches('\u{feff}').lines().next();
    first.is_some_and(|line| line.contains("Test Data File"))
}

/// Reads an export.
///
/// # Errors
/// When no table has the columns of a traction curve, a cell is not a number, two columns contradict each other, or the
/// probe of the oil reads air.
pub fn read_pcs(
    name: &str,
    text: &str,
    machine: &Machine,
    probe: Probe,
) -> Result<Vec<Reading>, OilError> {
    let mut readings = Vec::new();
    let (mut step, mut columns) = (0, None);
    for (number, line) in text.lines().enumerate() {
        let cells: Vec<&str> = line
            .trim_end_matches('\r')
            .split('\t')
            .map(str::trim)
            .collect();
        if line.starts_with("Step ") && line.contains(" started at") {
            (step, columns) = (step + 1, None);
        } else if let Some(found) = Columns::of(&cells, probe) {
            columns = Some(found);
        } else if line.trim().is_empty() {
            columns = None;
        } else if let Some(columns) = &columns {
            let place = Place {
                file: name,
                line: number + 1,
            };
            let mut reading = columns.reading(&cells, machine, place)?;
            reading.step = step;
            readings.push(reading);
        }
    }
    match readings.is_empty() {
        true => Err(OilError::NoTable {
            file: name.to_owned(),
        }),
        false => Ok(readings),
    }
}

/// Place of a row.
#[derive(Clone, Copy)]
struct Place<'a> {
    file: &'a str,
    line: usize,
}

impl Place<'_> {
    fn fault(self, rule: String) -> OilError {
        OilError::Row {
            file: self.file.to_owned(),
            line: self.line,
            rule,
        }
    }
}

/// Indices of the columns of a table.
struct Columns {
    traction: usize,
    slide: usize,
    speed: usize,
    load: usize,
    temperature: usize,
    pot: Option<usize>,
    sliding: Option<usize>,
    force: Option<usize>,
}

impl Columns {
    fn of(cells: &[&str], probe: Probe) -> Option<Self> {
        let named = |name: &str| cells.iter().rposition(|cell| *cell == name);
        let beginning = |names: [&str; 2]| {
            let is_it = |cell: &&str| names.iter().any(|name| cell.starts_with(name));
            cells.iter().rposition(is_it)
        };
        let pot = beginning(POT);
        let temperature = match probe {
            Probe::Lube => beginning(LUBE).or(pot),
            Probe::Pot => pot,
        };
        Some(Self {
            traction: named(TRACTION)?,
            slide: named(SLIDE)?,
            speed: named(SPEED)?,
            load: named(LOAD)?,
            temperature: temperature?,
            pot: pot.filter(|_| probe == Probe::Lube),
            sliding: named(SLIDING),
            force: named(FORCE),
        })
    }

    fn reading(
        &self,
        cells: &[&str],
        machine: &Machine,
        place: Place<'_>,
    ) -> Result<Reading, OilError> {
        let number = |index: usize, name: &str| {
            let cell = cells.get(index).copied().unwrap_or_default();
            let value = cell.replace(',', ".").parse::<f64>().ok();
            let fault = || place.fault(format!("{name}: {cell:?} is not a finite number"));
            value.filter(|value| value.is_finite()).ok_or_else(fault)
        };
        let optional = |index: Option<usize>, name: &str| {
            let filled = index.filter(|k| cells.get(*k).is_some_and(|cell| !cell.is_empty()));
            filled.map(|k| number(k, name)).transpose()
        };
        let (load, speed) = (number(self.load, LOAD)?, number(self.speed, SPEED)?);
        let (slide, traction) = (number(self.slide, SLIDE)?, number(self.traction, TRACTION)?);
        let celsius = number(self.temperature, "temperature")?;
        if let Some(pot) = optional(self.pot, POT[0])?.filter(|pot| (pot - celsius).abs() > AIR) {
            return Err(OilError::Air {
                file: place.file.to_owned(),
                line: place.line,
                lube: celsius,
                pot,
            });
        }
        let is_same = |a: f64, b: f64, unit: f64| {
            (a - b).abs() <= SAME[0] * a.abs().max(b.abs()) + SAME[1] * unit
        };
        if let Some(sliding) = optional(self.sliding, SLIDING)?
            && !is_same(sliding.abs(), (0.01 * slide * speed).abs(), speed.abs())
        {
            let rule = format!(
                "sliding speed {sliding} mm/s is not the slide-to-roll ratio of {slide} % times the rolling speed of {speed} mm/s"
            );
            return Err(place.fault(rule));
        }
        if let Some(force) = optional(self.force, FORCE)?
            && !is_same(force.abs(), (traction * load).abs(), load.abs())
        {
            let rule = format!(
                "traction force {force} N is not the traction coefficient {traction} times the load of {load} N"
            );
            return Err(place.fault(rule));
        }
        Ok(Reading {
            file: place.file.to_owned(),
            line: place.line,
            step: 0,
            group: String::new(),
            machine: *machine,
            setting: Setting {
                load: Force::from_si(load),
                mean_speed: Speed::from_si(1e-3 * speed),
                slide_to_roll: 0.01 * slide,
                temperature: Temperature::from_celsius(celsius),
            },
            set_temperature_c: Reading::rounded_temperature(celsius),
            rubbing_s: None,
            traction,
            sigma: None,
            film: None,
        })
    }
}
