//! Readings of a traction machine from a table with named columns.
//!
//! | column | meaning |
//! |---|---|
//! | `max_pressure_gpa` | largest Hertz pressure, instead of `load_n` |
//! | `load_n`, `mean_speed_m_s`, `slide_roll_percent`, `temperature_c` | setting; 200 % is pure sliding |
//! | `traction` | friction coefficient |
//! | `sigma` | its standard deviation |
//! | `group` | name of a calibration of load and force, with a gain of its own |
//! | `set_temperature_c` | temperature that the machine was set to; default the reading rounded to 5 K |
//! | `ball_radius_mm`, `second_radius_mm` | radii of both bodies; default 9.525 mm and a flat |
//! | `radius_rolling_mm`, `radius_across_mm` | relative radii along and across the motion, instead of both |
//! | `youngs_modulus_gpa`, `poisson`, `conductivity_w_mk` | of both specimens |
//! | `film_nm` | measured central film |
//! | `rubbing_s` | time for which the specimens have rubbed before \[s\] |

use crate::error;
use asperity_core::Fault;
use asperity_core::message::Warning;
use asperity_core::quantity::{Force, Length, Pressure, Speed, Temperature, ThermalConductivity};

use super::machine::{Machine, Setting};
use super::reading::Reading;
use asperity_table::{Row, RowFault};

use crate::number_table;
use crate::rig_table::SIMULATED_COLUMN;

/// Known columns.
const KNOWN: [&str; 16] = [
    "load_n",
    "mean_speed_m_s",
    "slide_roll_percent",
    "temperature_c",
    "traction",
    "sigma",
    "group",
    "set_temperature_c",
    "ball_radius_mm",
    "second_radius_mm",
    "radius_rolling_mm",
    "radius_across_mm",
    "youngs_modulus_gpa",
    "poisson",
    "conductivity_w_mk",
    PRESSURE,
];
/// Column of a largest Hertz pressure, instead of a load.
const PRESSURE: &str = "max_pressure_gpa";
/// Column of a measured film.
const FILM: &str = "film_nm";
/// Columns of a plan that hold no measurement, and the mark of simulated ones; they are left out without a warning.
const OF_A_PLAN: [&str; 3] = ["expected_traction", "film_ratio", SIMULATED_COLUMN];
/// Columns that a table needs.
const NEEDED: usize = 5;
/// Prefixes of column names, with the known column of the quantity.
const STEMS: [(&str, &str); 12] = [
    ("load", "load_n"),
    ("ball_load", "load_n"),
    ("mean_speed", "mean_speed_m_s"),
    ("rolling_speed", "mean_speed_m_s"),
    ("speed", "mean_speed_m_s"),
    ("slide", "slide_roll_percent"),
    ("srr", "slide_roll_percent"),
    ("temperature", "temperature_c"),
    ("friction", "traction"),
    ("traction", "traction"),
    ("max", PRESSURE),
    ("hertz", PRESSURE),
];
/// Prefixes of columns of a contact along a line.
const LINE_CONTACT: [&str; 6] = [
    "line_load",
    "load_n_m",
    "length",
    "contact_length",
    "width",
    "face_width",
];
const LINE_RULE: &str = "of a contact along a line; its losses are fitted by asperity calibrate";
/// Largest ellipticity that the formula of the film covers.
const LARGEST_ELLIPTICITY: f64 = 8.0;
/// Columns with their possible numbers, far wider than any machine needs.
const POSSIBLE: [(&str, [f64; 2], &str); 15] = [
    ("load_n", [0.01, 1e5], "N"),
    (PRESSURE, [0.05, 10.0], "GPa"),
    ("mean_speed_m_s", [1e-4, 200.0], "m/s"),
    ("slide_roll_percent", [-200.0, 200.0], "%"),
    ("temperature_c", [-60.0, 250.0], "°C"),
    ("set_temperature_c", [-60.0, 250.0], "°C"),
    ("traction", [-1.0, 1.0], ""),
    ("sigma", [1e-6, 0.1], ""),
    ("ball_radius_mm", [0.1, 1e4], "mm"),
    ("second_radius_mm", [0.1, 1e6], "mm"),
    ("youngs_modulus_gpa", [10.0, 1000.0], "GPa"),
    ("poisson", [0.0, 0.49], ""),
    ("conductivity_w_mk", [0.1, 1000.0], "W/(m K)"),
    ("film_nm", [0.1, 1e5], "nm"),
    ("rubbing_s", [0.0, 1e7], "s"),
];

/// Reads a table; `machine` has radii, material and roughness of rows that state none. A warning names the columns that were not
/// read.
///
/// # Errors
/// When a column is missing or a row is not valid; lists all such rows.
pub fn read_table(
    name: &str,
    text: &str,
    machine: &Machine,
) -> Result<(Vec<Reading>, Option<Warning>), Fault> {
    let table = number_table::read(name, text)?;
    let refuse = |rule: String| error::column(name, rule);
    let mut renamed = Vec::new();
    for column in table.names() {
        if LINE_CONTACT.iter().any(|stem| column.starts_with(stem)) {
            return Err(refuse(format!("column {column}: {LINE_RULE}")));
        }
        let is_known = KNOWN.contains(&column.as_str()) || column == FILM;
        let stem = STEMS.iter().find(|(stem, _)| column.starts_with(stem));
        let has_load = table.has("load_n") || table.has(PRESSURE);
        let is_there = |known: &str| match known {
            "load_n" | PRESSURE => has_load,
            known => table.has(known),
        };
        if let Some((_, known)) = stem.filter(|(_, known)| !is_known && !is_there(known)) {
            renamed.push(format!("column {column} is not known; write {known}"));
        }
    }
    let mut missing: Vec<&str> = KNOWN[..NEEDED].to_vec();
    missing.retain(|needed| !(table.has(needed) || *needed == "load_n" && table.has(PRESSURE)));
    if renamed.is_empty() {
        let known = [&KNOWN[..], &OF_A_PLAN, &[FILM]].concat();
        renamed = number_table::misspelt(&table, &missing, &known);
    }
    if !renamed.is_empty() {
        let unit = "names end in the unit of their numbers";
        return Err(refuse(format!("{} ({unit})", renamed.join(", "))));
    }
    match missing.as_slice() {
        [] => {}
        [one] => return Err(refuse(format!("column {one} is missing"))),
        several => {
            return Err(refuse(format!(
                "columns {} are missing",
                several.join(", ")
            )));
        }
    }
    let readings = number_table::all(name, &table, |row| reading(name, row, machine))?;
    Ok((readings, table.unread(name)))
}

fn reading(file: &str, row: Row<'_>, machine: &Machine) -> Result<Reading, RowFault> {
    for (column, [low, high], unit) in POSSIBLE {
        let value = row.optional(column)?;
        if let Some(value) = value.filter(|value| !(low..=high).contains(value)) {
            let rule = format!("{value} {unit}; expected is {low} to {high} {unit}");
            return Err(row.fault(column, rule));
        }
    }
    for column in OF_A_PLAN {
        let _ = row.text(column);
    }
    let celsius = row.number("temperature_c")?;
    let set = row.optional("set_temperature_c")?;
    let film = row.optional(FILM)?;
    let machine = machine_of(row, machine)?;
    let load = match (row.optional("load_n")?, row.optional(PRESSURE)?) {
        (None, Some(gpa)) => machine
            .load_at(Pressure::from_si(1e9 * gpa))
            .map_err(|error| row.fault(PRESSURE, error.to_string()))?,
        (Some(newtons), None) => Force::from_si(newtons),
        (None, None) => Force::from_si(row.number("load_n")?),
        (Some(_), Some(_)) => {
            let rule = format!("is given in addition to {PRESSURE}; leave one of the two out");
            return Err(row.fault("load_n", rule));
        }
    };
    Ok(Reading {
        file: file.to_owned(),
        line: row.line,
        step: 0,
        group: row.text("group").unwrap_or_default().to_owned(),
        machine,
        setting: Setting {
            load,
            mean_speed: Speed::from_si(row.number("mean_speed_m_s")?),
            slide_to_roll: 0.01 * row.number("slide_roll_percent")?,
            temperature: Temperature::from_celsius(celsius),
        },
        set_temperature_c: set.unwrap_or_else(|| Reading::rounded_temperature(celsius)),
        rubbing_s: row.optional("rubbing_s")?,
        traction: row.number("traction")?,
        sigma: row.optional("sigma")?,
        film: film.map(|nm| Length::from_si(1e-9 * nm)),
        contradiction: None,
    })
}

/// The machine of a row.
fn machine_of(row: Row<'_>, default: &Machine) -> Result<Machine, RowFault> {
    let mut machine = *default;
    let millimetres = |column| -> Result<Option<Length>, RowFault> {
        let value = row.optional(column)?;
        Ok(value.map(|mm| Length::from_si(1e-3 * mm)))
    };
    let ball = millimetres("ball_radius_mm")?;
    let second = millimetres("second_radius_mm")?;
    if ball.is_some() || second.is_some() {
        let ball = ball.unwrap_or(default.radii[0]);
        let made = Machine::ball_on_disc(ball, second, default.roughness);
        let made = made.map_err(|error| row.fault("ball_radius_mm", error.to_string()))?;
        machine.radii = made.radii;
    }
    let relative = [
        millimetres("radius_rolling_mm")?,
        millimetres("radius_across_mm")?,
    ];
    match relative {
        [Some(along), Some(across)] if along.si() > 0.0 && across.si() > 0.0 => {
            machine.radii = [along, across];
        }
        [None, None] => {}
        _ => {
            let rule = "needs radius_across_mm as well, both positive";
            return Err(row.fault("radius_rolling_mm", rule));
        }
    }
    let [along, across] = machine.radii;
    if (across / along).powf(std::f64::consts::FRAC_2_PI) > LARGEST_ELLIPTICITY {
        return Err(row.fault("radius_across_mm", LINE_RULE));
    }
    if let Some(value) = row.optional("youngs_modulus_gpa")? {
        machine.material.young = Pressure::from_si(1e9 * value);
    }
    if let Some(value) = row.optional("poisson")? {
        machine.material.poisson = value;
    }
    if let Some(value) = row.optional("conductivity_w_mk")? {
        machine.material.conductivity = ThermalConductivity::from_si(value);
    }
    Ok(machine)
}
