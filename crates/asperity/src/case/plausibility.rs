//! Usual and possible range of every number of a case: outside the first W201 warns, outside the second
//! E212 refuses.
//!
//! The usual ranges are those of gear drives from toys to wind turbines, the possible ones leave some powers
//! of ten around them. Both are choices of this program: they are there to catch a wrong unit, not to judge a
//! design. Zero, negative and missing numbers are judged by the equations that take them.

use asperity_core::quantity::Quantity;
use asperity_oil::{LubricantState, ViscosityLaw};

use super::error::CaseError;
use super::input::{BodyInput, CaseInput, FlankInput};
use super::source::Source;
use crate::message::Warning;

/// Code of the warning about an unusual number.
const UNUSUAL: &str = "W201";
const DEGREE: f64 = std::f64::consts::PI / 180.0;
const PER_MINUTE: f64 = 2.0 * std::f64::consts::PI / 60.0;

/// A number of a case and its ranges.
struct Row {
    key: &'static str,
    unit: &'static str,
    usual: [f64; 2],
    possible: [f64; 2],
    /// The numbers at the key, in `unit`.
    numbers: fn(&CaseInput) -> Vec<f64>,
}

const fn row(
    key: &'static str,
    unit: &'static str,
    usual: [f64; 2],
    possible: [f64; 2],
    numbers: fn(&CaseInput) -> Vec<f64>,
) -> Row {
    Row {
        key,
        unit,
        usual,
        possible,
        numbers,
    }
}

fn one<Q: Quantity>(given: Option<Q>, unit: f64) -> Vec<f64> {
    given.map(|value| value.si() / unit).into_iter().collect()
}

/// No limit that this table knows: an equation has its own.
const OPEN: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

#[rustfmt::skip]
const GEARS_AND_OPERATION: &[Row] = &[
    row("gears.teeth", "", [10.0, 300.0], [3.0, 5000.0], |c| c.gears.teeth.map(f64::from).to_vec()),
    row("gears.module", "mm", [0.3, 40.0], [0.02, 200.0], |c| vec![c.gears.module.si() / 1e-3]),
    row("gears.helix", "deg", [-45.0, 45.0], OPEN, |c| one(c.gears.helix, DEGREE)),
    row("gears.pressure_angle", "deg", [14.0, 30.0], OPEN, |c| one(c.gears.pressure_angle, DEGREE)),
    row("gears.face_width", "mm", [1.0, 1000.0], [0.01, 10_000.0], |c| c.gears.face_width.both().map(|b| b.si() / 1e-3).to_vec()),
    row("gears.profile_shift", "", [-1.5, 1.5], OPEN, |c| c.gears.profile_shift.map_or(Vec::new(), |x| x.to_vec())),
    row("gears.centre_distance", "mm", [5.0, 5000.0], [0.1, 50_000.0], |c| one(c.gears.centre_distance, 1e-3)),
    row("gears.tip_diameter", "mm", [3.0, 5000.0], [0.1, 50_000.0], |c| c.gears.tip_diameter.map_or(Vec::new(), |d| d.map(|d| d.si() / 1e-3).to_vec())),
    row("gears.addendum", "", [0.6, 1.6], OPEN, |c| c.gears.addendum.into_iter().collect()),
    row("operation.torque", "N m", [0.01, 1e6], [1e-9, 1e8], |c| vec![c.operation.torque.si().abs()]),
    row("operation.speed", "1/min", [1.0, 60_000.0], [1e-6, 1e6], |c| vec![c.operation.speed.si() / PER_MINUTE]),
    row("operation.temperature", "°C", [-30.0, 180.0], [-100.0, 400.0], |c| vec![c.operation.temperature.celsius()]),
];

#[rustfmt::skip]
const LUBRICANT: &[Row] = &[
    row("lubricant.density", "kg/m3", [700.0, 1200.0], [300.0, 3000.0], |c| one(c.lubricant.density, 1.0)),
    row("lubricant.thermal_expansion", "1/K", [4e-4, 1.2e-3], [1e-6, 1e-2], |c| one(c.lubricant.thermal_expansion, 1.0)),
    row("lubricant.thermal_conductivity", "W/(m K)", [0.08, 0.3], [0.005, 5.0], |c| one(c.lubricant.thermal_conductivity, 1.0)),
    row("lubricant.heat_capacity", "J/(kg K)", [1400.0, 3000.0], [200.0, 10_000.0], |c| one(c.lubricant.heat_capacity, 1.0)),
    row("lubricant.temperature_coefficient", "1/K", [0.005, 0.15], [1e-4, 1.0], |c| one(c.lubricant.temperature_coefficient, 1.0)),
    row("lubricant.viscosity", "mPa s", [1.0, 10_000.0], [0.05, 100_000.0], |c| match c.lubricant.viscosity {
        Some(ViscosityLaw::Given { dynamic_viscosity, .. }) => vec![dynamic_viscosity.si() / 1e-3],
        _ => Vec::new(),
    }),
    row("lubricant.viscosity.at_40", "mm2/s", [4.0, 2000.0], [0.3, 1e5], |c| match c.lubricant.viscosity {
        Some(ViscosityLaw::AstmD341 { at_40, .. }) => vec![at_40.si() / 1e-6],
        _ => Vec::new(),
    }),
    row("lubricant.viscosity.at_100", "mm2/s", [1.0, 150.0], [0.2, 1e4], |c| match c.lubricant.viscosity {
        Some(ViscosityLaw::AstmD341 { at_100, .. }) => vec![at_100.si() / 1e-6],
        _ => Vec::new(),
    }),
];

/// Smallest and largest possible size of the number at `key`, one of gears, operation and lubricant, in the unit that
/// messages name; none of another key.
///
/// ```
/// use asperity::case::possible_range;
/// assert_eq!(possible_range("operation.speed"), Some([1e-6, 1e6]));
/// assert_eq!(possible_range("operation.bulk"), None);
/// ```
#[must_use]
pub fn possible_range(key: &str) -> Option<[f64; 2]> {
    let rows = GEARS_AND_OPERATION.iter().chain(LUBRICANT);
    rows.into_iter()
        .find(|row| row.key == key)
        .map(|row| row.possible)
}

/// Rows of the material at a key, for the pinion or the wheel.
macro_rules! body {
    ($table:literal, $of:path) => {
        &[
            row(
                concat!($table, ".young"),
                "GPa",
                [50.0, 500.0],
                [0.05, 1500.0],
                |c| $of(c).map_or(Vec::new(), |b| one(b.young, 1e9)),
            ),
            row(concat!($table, ".poisson"), "", [0.2, 0.42], OPEN, |c| {
                $of(c).and_then(|b| b.poisson).into_iter().collect()
            }),
            row(
                concat!($table, ".elastic_limit"),
                "MPa",
                [150.0, 4000.0],
                [1.0, 30_000.0],
                |c| $of(c).map_or(Vec::new(), |b| one(b.elastic_limit, 1e6)),
            ),
            row(
                concat!($table, ".flow_pressure"),
                "GPa",
                [0.3, 20.0],
                [1e-3, 150.0],
                |c| $of(c).map_or(Vec::new(), |b| one(b.flow_pressure, 1e9)),
            ),
            row(
                concat!($table, ".density"),
                "kg/m3",
                [1000.0, 9000.0],
                [100.0, 25_000.0],
                |c| $of(c).map_or(Vec::new(), |b| one(b.density, 1.0)),
            ),
            row(
                concat!($table, ".conductivity"),
                "W/(m K)",
                [0.2, 120.0],
                [0.01, 3000.0],
                |c| $of(c).map_or(Vec::new(), |b| one(b.conductivity, 1.0)),
            ),
            row(
                concat!($table, ".heat_capacity"),
                "J/(kg K)",
                [300.0, 2000.0],
                [50.0, 10_000.0],
                |c| $of(c).map_or(Vec::new(), |b| one(b.heat_capacity, 1.0)),
            ),
        ]
    };
}

/// Rows of a flank known by its values, for the pinion or the wheel.
macro_rules! flank {
    ($table:literal, $of:path) => {
        &[
            row(
                concat!($table, ".rq"),
                "um",
                [0.01, 5.0],
                [0.0, 200.0],
                |c| $of(c).map_or(Vec::new(), |f| one(f.rq, 1e-6)),
            ),
            row(
                concat!($table, ".ra"),
                "um",
                [0.01, 4.0],
                [0.0, 200.0],
                |c| $of(c).map_or(Vec::new(), |f| one(f.ra, 1e-6)),
            ),
            row(
                concat!($table, ".rz"),
                "um",
                [0.05, 40.0],
                [0.0, 2000.0],
                |c| $of(c).map_or(Vec::new(), |f| one(f.rz, 1e-6)),
            ),
            row(
                concat!($table, ".rpk"),
                "um",
                [0.005, 10.0],
                [0.0, 500.0],
                |c| $of(c).map_or(Vec::new(), |f| one(f.rpk, 1e-6)),
            ),
            row(
                concat!($table, ".asperity_radius"),
                "um",
                [0.5, 10_000.0],
                [1e-3, 1e7],
                |c| $of(c).map_or(Vec::new(), |f| one(f.asperity_radius, 1e-6)),
            ),
        ]
    };
}

fn pinion_body(case: &CaseInput) -> Option<&BodyInput> {
    Some(&case.material.pinion)
}

fn wheel_body(case: &CaseInput) -> Option<&BodyInput> {
    case.material.wheel.as_ref()
}

fn pinion_flank(case: &CaseInput) -> Option<&FlankInput> {
    Some(&case.surface.pinion)
}

fn wheel_flank(case: &CaseInput) -> Option<&FlankInput> {
    case.surface.wheel.as_ref()
}

#[rustfmt::skip]
const PINION: &[Row] = body!("material.pinion", pinion_body);
#[rustfmt::skip]
const WHEEL: &[Row] = body!("material.wheel", wheel_body);
#[rustfmt::skip]
const PINION_FLANK: &[Row] = flank!("surface.pinion", pinion_flank);
#[rustfmt::skip]
const WHEEL_FLANK: &[Row] = flank!("surface.wheel", wheel_flank);

/// Viscosity of the oil at the bulk temperature \[Pa s\]: usual, and beyond which it is no oil of a gear drive.
const OIL_USUAL: [f64; 2] = [1e-3, 10.0];
const OIL_POSSIBLE: [f64; 2] = [1e-5, 100.0];

/// Every row of the table.
fn rows() -> impl Iterator<Item = &'static Row> {
    [
        GEARS_AND_OPERATION,
        LUBRICANT,
        PINION,
        WHEEL,
        PINION_FLANK,
        WHEEL_FLANK,
    ]
    .into_iter()
    .flatten()
}

fn within(value: f64, range: [f64; 2]) -> bool {
    (range[0]..=range[1]).contains(&value)
}

/// The usual range of the numbers at `key`, as text with its unit.
pub(super) fn usual_of(key: &str) -> Option<String> {
    rows().find(|row| row.key == key).map(Row::usual)
}

impl Row {
    /// The usual range as text with its unit.
    fn usual(&self) -> String {
        let [low, high] = self.usual;
        with_unit(&format!("{} to {}", digits(low), digits(high)), self.unit)
    }

    /// The first number outside `range`. Where the range is of positive numbers, others are the business of the
    /// equation that takes them.
    fn outside(&self, case: &CaseInput, range: [f64; 2]) -> Option<f64> {
        let judged = |value: &f64| range[0] < 0.0 || *value > 0.0;
        let mut numbers = (self.numbers)(case).into_iter().filter(judged);
        numbers.find(|value| !within(*value, range))
    }

    fn refused(&self, value: f64, source: &Source) -> CaseError {
        CaseError::Impossible {
            place: source.place_of(self.key),
            key: self.key,
            written: source.written(self.key).map(str::to_owned),
            seen: with_unit(&digits(value), self.unit),
            usual: self.usual(),
        }
    }
}

fn with_unit(text: &str, unit: &str) -> String {
    match unit {
        "" => text.to_owned(),
        unit => format!("{text} {unit}"),
    }
}

fn digits(value: f64) -> String {
    let size = value.abs();
    if size != 0.0 && !(1e-3..1e7).contains(&size) {
        return format!("{value:.3e}");
    }
    let text = format!("{value:.4}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// Every number that no gear drive has.
pub(super) fn impossible(input: &CaseInput, source: &Source) -> Vec<CaseError> {
    let found = |row: &Row| Some(row.refused(row.outside(input, row.possible)?, source));
    rows().filter_map(found).collect()
}

/// Refuses the first number that no gear drive has.
pub(super) fn refuse_impossible(input: &CaseInput, source: &Source) -> Result<(), CaseError> {
    match impossible(input, source).into_iter().next() {
        Some(error) => Err(error),
        None => Ok(()),
    }
}

/// Refuses an oil that does not flow at the bulk temperature, or is a gas there.
pub(super) fn refuse_stiff_oil(oil: &LubricantState, source: &Source) -> Result<(), CaseError> {
    let viscosity = oil.dynamic_viscosity.si();
    if within(viscosity, OIL_POSSIBLE) {
        return Ok(());
    }
    let key = "operation.temperature";
    Err(CaseError::Impossible {
        place: source.place_of(key),
        key,
        written: source.written(key).map(str::to_owned),
        seen: format!("an oil of {} Pa s there", digits(viscosity)),
        usual: format!("{} to {} Pa s", OIL_USUAL[0], OIL_USUAL[1]),
    })
}

/// Warnings about the unusual numbers of a case.
pub(super) fn unusual(input: &CaseInput, oil: &LubricantState) -> Vec<Warning> {
    let note = |row: &Row| {
        let value = row.outside(input, row.usual)?;
        let value = with_unit(&digits(value), row.unit);
        let text = format!("{} = {value} is unusual; usual is {}", row.key, row.usual());
        Some(Warning::new(UNUSUAL, text))
    };
    let mut warnings: Vec<Warning> = rows().filter_map(note).collect();
    let viscosity = oil.dynamic_viscosity.si();
    if !within(viscosity, OIL_USUAL) {
        warnings.push(Warning::new(
            UNUSUAL,
            format!(
                "operation.temperature: the oil has {} Pa s there; usual is {} to {} Pa s",
                digits(viscosity),
                OIL_USUAL[0],
                OIL_USUAL[1]
            ),
        ));
    }
    warnings
}

/// The warnings that are not about numbers of the case.
pub(super) fn of_files(warnings: &[Warning]) -> Vec<Warning> {
    let is_kept = |warning: &&Warning| warning.code != UNUSUAL;
    warnings.iter().filter(is_kept).cloned().collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::known_keys::first_unknown;
    use crate::case::schema;

    #[test]
    fn every_key_is_a_key_of_the_case_file_and_its_usual_range_is_possible() {
        assert_eq!(first_unknown(&schema(), rows().map(|row| row.key)), None);
        for row in rows() {
            let [low, high] = row.possible;
            assert!(low < row.usual[0] && row.usual[0] < row.usual[1] && row.usual[1] < high);
        }
    }
}
