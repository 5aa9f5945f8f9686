//! Readings from the text export of a PCS traction machine (MTM, EHD), in steps: separated by tabs, or as a spreadsheet saves
//! it, with decimal points or commas.
//!
//! Every step whose table has load, rolling speed, slide-to-roll ratio and traction coefficient is read, whatever the type
//! of the step is called. A line with a single cell of text is a remark. The first columns of a table are repeated further right; the last one of each name is taken.
//!
//! A step with the column of an average film measures film thickness, usually on glass, and no traction. Its films replace the
//! computed ones at the same load and set temperature, between its speeds, along straight lines over the logarithms.

use asperity_core::quantity::{Force, Length, Speed, Temperature};
use asperity_core::{Fault, RepeatedFault, number as number_text};

use super::error as oil_error;
use super::machine::{Machine, Setting};
use super::reading::{Reading, is_same};

const TRACTION: &str = "Traction Coeff (-)";
const SLIDE: &str = "SRR (%)";
const SPEED: &str = "Rolling Speed (mm/s)";
const LOAD: &str = "Ball Load (N)";
const SLIDING: &str = "Sliding Speed (mm/s)";
const TEMPERATURE: &str = "temperature";
const FORCE: &str = "Traction Force (N)";
const FILM: &str = "Average Film (nm)";
/// Possible films \[nm\]; others are fringes that the machine did not find.
const POSSIBLE_FILMS: std::ops::RangeInclusive<f64> = 0.1..=1e5;
/// Beginnings of the names of the temperatures of the oil at the contact, and of the pot.
const LUBE: [&str; 2] = ["Lube RTD Temp", "Lube Temp"];
const POT: [&str; 2] = ["Pot RTD Temp", "Pot Temp"];
/// Difference \[K\] from the pot at which a probe of the oil reads air.
const AIR: f64 = 15.0;
/// Relative difference of two columns that state one quantity; what was rounded away in the printed digits comes on top.
const SAME: f64 = 0.02;
/// Number of readings of which one may contradict itself; more point to a fault of the table.
const ONE_IN: usize = 20;

/// Probe whose temperature is taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Deserialize, schemars::JsonSchema)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
#[serde(rename_all = "kebab-case")]
pub enum Probe {
    /// In the oil at the contact.
    #[default]
    Lube,
    /// In the pot.
    Pot,
}

/// Whether a text is an export of such a machine: by its title, or a step that starts in it.
#[must_use]
pub fn is_pcs(text: &str) -> bool {
    let first = text.lines().next().unwrap_or_default();
    first.contains("Test Data File") || text.lines().any(starts_step)
}

fn starts_step(line: &str) -> bool {
    let line = line.trim_start_matches('\u{feff}');
    line.starts_with("Step ") && line.contains(" started at")
}

/// Reads an export.
///
/// # Errors
/// When no table has the columns of a traction curve, a cell is not a number, two columns contradict each other in more than
/// one reading of twenty, or the probe of the oil reads air.
pub fn read_pcs(
    name: &str,
    text: &str,
    machine: &Machine,
    probe: Probe,
) -> Result<Vec<Reading>, Fault> {
    let (mut readings, mut films) = (Vec::new(), Vec::new());
    let (mut step, mut columns) = (0, None);
    let mut fault: Option<Fault> = None;
    let [mut faults, mut contradictions] = [(); 2].map(|()| RepeatedFault::default());
    let separator = ['\t', ';'].into_iter().find(|sign| text.contains(*sign));
    let separator = separator.unwrap_or(',');
    for (number, line) in text.lines().enumerate() {
        let cells = line.trim_end_matches('\r').split(separator);
        let cells: Vec<&str> = cells.map(|cell| cell.trim().trim_matches('"')).collect();
        if starts_step(line) {
            (step, columns) = (step + 1, None);
        } else if let Some(found) = PcsColumns::from_cells(&cells, probe) {
            columns = Some(found);
        } else if cells.iter().all(|cell| cell.is_empty()) {
            columns = None;
        } else if let Some(columns) = columns.as_ref().filter(|_| !is_remark(&cells)) {
            let place = PcsPlace {
                file: name,
                line: number + 1,
            };
            columns.refuse_air(&cells, place)?;
            let read = match columns.film {
                Some(_) => columns.film(&cells, place).map(|film| films.extend(film)),
                None => columns.reading(&cells, machine, place).map(|reading| {
                    if reading.contradiction.is_some() {
                        contradictions.add(number + 1, line);
                    }
                    readings.push(Reading { step, ..reading });
                }),
            };
            if let Err(row) = read {
                fault.get_or_insert(row);
                faults.add(number + 1, line);
            }
        }
    }
    if let Some(fault) = fault {
        let seems = "the column seems to hold something else";
        return Err(oil_error::repeated(fault, &faults, seems));
    }
    if readings.is_empty() {
        Err(oil_error::no_table(name))
    } else {
        let wrong = readings.iter().filter(|one| one.contradiction.is_some());
        if let Some(first) = wrong.clone().next()
            && wrong.count() * ONE_IN > readings.len()
        {
            let rule = first.contradiction.clone().unwrap_or_default();
            let line = first.line;
            let fault = PcsPlace { file: name, line }.fault(rule);
            let seems = "the columns seem to be mixed up";
            return Err(oil_error::repeated(fault, &contradictions, seems));
        }
        for reading in &mut readings {
            reading.film = film_at(&films, reading);
        }
        Ok(readings)
    }
}

/// Measured film.
struct MeasuredFilm {
    load: f64,
    set_temperature_c: f64,
    speed: f64,
    nanometres: f64,
}

/// Measured film at the load, set temperature and speed of a reading; `None` outside of the measured speeds.
fn film_at(films: &[MeasuredFilm], reading: &Reading) -> Option<Length> {
    let is_of = |film: &&MeasuredFilm| {
        film.set_temperature_c == reading.set_temperature_c
            && is_same(film.load, reading.setting.load.si())
    };
    let mut curve: Vec<[f64; 2]> = films
        .iter()
        .filter(is_of)
        .map(|film| [film.speed, film.nanometres].map(f64::ln))
        .collect();
    curve.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let speed = reading.setting.mean_speed.si();
    // Repeated at one speed: the mean of the logarithms.
    let at: Vec<f64> = curve
        .iter()
        .filter(|[other, _]| is_same(other.exp(), speed))
        .map(|[_, film]| *film)
        .collect();
    let between = || {
        let next = curve.iter().position(|[other, _]| *other > speed.ln())?;
        let [[x0, y0], [x1, y1]] = [*curve.get(next.checked_sub(1)?)?, curve[next]];
        Some(y0 + (y1 - y0) * (speed.ln() - x0) / (x1 - x0))
    };
    let logarithm = if at.is_empty() {
        between()?
    } else {
        at.iter().sum::<f64>() / at.len() as f64
    };
    Some(Length::from_si(1e-9 * logarithm.exp()))
}

/// Place of a row.
#[derive(Clone, Copy)]
struct PcsPlace<'a> {
    file: &'a str,
    line: usize,
}

impl PcsPlace<'_> {
    fn fault(self, rule: String) -> Fault {
        oil_error::row(self.file, self.line, rule)
    }
}

/// Whether a line is a single cell of text.
fn is_remark(cells: &[&str]) -> bool {
    let mut filled = cells.iter().filter(|cell| !cell.is_empty());
    let is_text = |cell: &&&str| cell.replace(',', ".").parse::<f64>().is_err();
    filled.next().filter(is_text).is_some() && filled.next().is_none()
}

/// Number of a cell.
fn number(cells: &[&str], index: usize, name: &str, place: PcsPlace<'_>) -> Result<f64, Fault> {
    let cell = cells.get(index).copied().unwrap_or_default();
    let value = cell.replace(',', ".").parse::<f64>().ok();
    let fault = || place.fault(format!("{name}: {cell:?} is not a finite number"));
    value.filter(|value| value.is_finite()).ok_or_else(fault)
}

/// Half a unit of the last printed digit of a cell, in its own unit.
fn rounded_away(cells: &[&str], index: usize) -> f64 {
    let cell = cells.get(index).copied().unwrap_or_default();
    let mantissa = cell.split(['e', 'E']).next().unwrap_or_default();
    let decimals = mantissa
        .split_once(['.', ','])
        .map_or(0, |(_, after)| after.len());
    let exponent: i32 = cell
        .split_once(['e', 'E'])
        .and_then(|(_, e)| e.parse().ok())
        .unwrap_or(0);
    0.5 * 10_f64.powi(exponent.saturating_sub(decimals.try_into().unwrap_or(i32::MAX)))
}

/// Whether two statements of one quantity agree, of whose printed digits `rounding` was cut off.
fn agree([a, b]: [f64; 2], rounding: f64) -> bool {
    (a - b).abs() <= SAME * a.max(b) + rounding * (1.0 + 1e-9)
}

/// Indices of the columns of a table.
struct PcsColumns {
    /// Film of a step that measures no traction.
    film: Option<usize>,
    traction: usize,
    slide: usize,
    speed: usize,
    load: usize,
    temperature: usize,
    pot: Option<usize>,
    sliding: Option<usize>,
    force: Option<usize>,
}

impl PcsColumns {
    fn from_cells(cells: &[&str], probe: Probe) -> Option<Self> {
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
        let film = named(FILM);
        // A step of films may lack traction.
        let of_traction = |name: &str| named(name).or(film);
        Some(Self {
            film,
            traction: of_traction(TRACTION)?,
            slide: of_traction(SLIDE)?,
            speed: named(SPEED)?,
            load: named(LOAD)?,
            temperature: temperature?,
            pot: pot.filter(|_| probe == Probe::Lube),
            sliding: named(SLIDING),
            force: named(FORCE),
        })
    }

    /// The film of a row; `None` if the machine found none.
    fn film(&self, cells: &[&str], place: PcsPlace<'_>) -> Result<Option<MeasuredFilm>, Fault> {
        let number = |index: usize, name: &str| number(cells, index, name, place);
        let nanometres = number(self.film.unwrap_or(self.traction), FILM)?;
        let celsius = number(self.temperature, TEMPERATURE)?;
        let film = MeasuredFilm {
            load: number(self.load, LOAD)?,
            set_temperature_c: Reading::rounded_temperature(celsius),
            speed: 1e-3 * number(self.speed, SPEED)?,
            nanometres,
        };
        Ok(Some(film).filter(|film| POSSIBLE_FILMS.contains(&nanometres) && film.speed > 0.0))
    }

    /// Refuses a row in which the probe of the oil reads air.
    fn refuse_air(&self, cells: &[&str], place: PcsPlace<'_>) -> Result<(), Fault> {
        let at = |index: usize| number(cells, index, TEMPERATURE, place).ok();
        let temperatures = at(self.temperature).zip(self.pot.and_then(at));
        match temperatures {
            Some((celsius, pot)) if (pot - celsius).abs() > AIR => {
                Err(oil_error::air(place.file, place.line, celsius, pot))
            }
            _ => Ok(()),
        }
    }

    fn reading(
        &self,
        cells: &[&str],
        machine: &Machine,
        place: PcsPlace<'_>,
    ) -> Result<Reading, Fault> {
        let number = |index: usize, name: &str| number(cells, index, name, place);
        let optional = |index: Option<usize>, name: &str| {
            let filled = index.filter(|k| cells.get(*k).is_some_and(|cell| !cell.is_empty()));
            filled.map(|k| number(k, name)).transpose()
        };
        let (load, speed) = (number(self.load, LOAD)?, number(self.speed, SPEED)?);
        let (slide, traction) = (number(self.slide, SLIDE)?, number(self.traction, TRACTION)?);
        let celsius = number(self.temperature, TEMPERATURE)?;
        // Half a unit of the last printed digit of each.
        let [of_slide, of_speed] = [self.slide, self.speed].map(|k| rounded_away(cells, k));
        let [of_traction, of_load] = [self.traction, self.load].map(|k| rounded_away(cells, k));
        let contradiction = if let Some((k, sliding)) =
            self.sliding.zip(optional(self.sliding, SLIDING)?)
            && !agree(
                [sliding.abs(), 0.01 * (slide * speed).abs()],
                rounded_away(cells, k) + 0.01 * (of_slide * speed.abs() + of_speed * slide.abs()),
            ) {
            Some(format!(
                "sliding speed {} mm/s is not the slide-to-roll ratio of {} % times the rolling speed of {} mm/s",
                number_text(sliding),
                number_text(slide),
                number_text(speed)
            ))
        } else if let Some((k, force)) = self.force.zip(optional(self.force, FORCE)?)
            && !agree(
                [force.abs(), (traction * load).abs()],
                rounded_away(cells, k) + of_traction * load.abs() + of_load * traction.abs(),
            )
        {
            Some(format!(
                "traction force {} N is not the traction coefficient {} times the load of {} N",
                number_text(force),
                number_text(traction),
                number_text(load)
            ))
        } else {
            None
        };
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
            contradiction,
        })
    }
}
