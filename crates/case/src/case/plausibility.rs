//! Numbers outside the usual range of their row, of which W201 warns, or outside its possible range, which E212 refuses.
//!
//! The usual ranges are those of gear drives from toys to wind turbines, the possible ones leave some powers
//! of ten around them. Both are choices of this program: they are there to catch a wrong unit, not to judge a
//! design. Zero, negative and missing numbers are judged by the equations that take them.

use std::borrow::Cow;
use std::f64::consts::PI;

use asperity_core::decimals;
use asperity_core::quantity::{AngularSpeed, Pressure, Torque};
use asperity_gear::GearPair;
use asperity_oil::{LubricantInput, LubricantState, ViscosityLaw};

use super::error::CaseError;
use super::input::{CaseInput, GearsInput, OperationInput, TEMPERATURE_KEYS};
use super::rows::{Limits, Table, in_unit, limits};
use super::section::Section;
use super::source::Source;
use crate::message::Warning;
use crate::physical_limits::{HIGHEST_PRESSURE, HIGHEST_SPEED};

/// Code of the warning about an unusual number.
const UNUSUAL: &str = "W201";
/// Code of a division of the profile shifts.
const DIVIDED: &str = "W445";
/// Code of the warning that names the keys of symbols.
pub(super) const SYMBOLS: &str = "W202";
/// Code of a key that is read by its former name.
const FORMER_NAME: &str = "W203";

limits! {
    LubricantInput;
    density = "kg/m3" usual [700.0, 1200.0] possible [300.0, 3000.0];
    thermal_expansion = "1/K" usual [4e-4, 1.2e-3] possible [1e-6, 1e-2];
    pressure_viscosity_factor = "" usual [0.5, 1.5] possible [0.1, 10.0];
    limiting_shear_temperature = "1/K" usual [-0.005, 0.01] possible [-0.02, 0.02];
    thermal_conductivity = "W/(m K)" usual [0.08, 0.3] possible [0.005, 5.0];
    heat_capacity = "J/(kg K)" usual [1400.0, 3000.0] possible [200.0, 10_000.0];
    temperature_coefficient = "1/K" usual [0.005, 0.15] possible [1e-4, 1.0];
}

/// Rows of the viscosity, whose keys depend on its law.
const VISCOSITY: [Limits<LubricantInput>; 3] = [
    Limits {
        name: "viscosity",
        unit: "mPa s",
        usual: [1.0, 10_000.0],
        possible: [0.05, 100_000.0],
        numbers: |oil| match oil.viscosity {
            Some(ViscosityLaw::Given {
                dynamic_viscosity, ..
            }) => vec![in_unit(dynamic_viscosity, "mPa s")],
            _ => Vec::new(),
        },
    },
    Limits {
        name: "viscosity.at_40",
        unit: "mm2/s",
        usual: [4.0, 2000.0],
        possible: [0.3, 1e5],
        numbers: |oil| match oil.viscosity {
            Some(ViscosityLaw::AstmD341 { at_40, .. }) => vec![in_unit(at_40, "mm2/s")],
            _ => Vec::new(),
        },
    },
    Limits {
        name: "viscosity.at_100",
        unit: "mm2/s",
        usual: [1.0, 150.0],
        possible: [0.2, 1e4],
        numbers: |oil| match oil.viscosity {
            Some(ViscosityLaw::AstmD341 { at_100, .. }) => vec![in_unit(at_100, "mm2/s")],
            _ => Vec::new(),
        },
    },
];

/// Ranges of a key of the case file, with the numbers that a case states for it.
#[derive(Clone)]
pub(super) struct Range {
    table: &'static str,
    name: &'static str,
    pub(super) unit: &'static str,
    usual: [f64; 2],
    possible: [f64; 2],
    numbers: Vec<f64>,
}

/// Every range of the case file, with the numbers of `input`; without numbers if there is no case.
fn ranges(input: Option<&CaseInput>) -> Vec<Range> {
    let (surface, material) = (
        input.map(|case| &case.surface),
        input.map(|case| &case.material),
    );
    let lubricant = input.map(|case| &case.lubricant);
    let wheel = material.and_then(|steels| steels.wheel.as_ref());
    let wheel_flank = surface.and_then(|flanks| flanks.wheel.as_ref());
    [
        of_table("gears", input.map(|case| &case.gears)),
        of_table("operation", input.map(|case| &case.operation)),
        of_table("lubricant", lubricant),
        of_rows("lubricant", &VISCOSITY, lubricant),
        of_table("material.pinion", material.map(|steels| &steels.pinion)),
        of_table("material.wheel", wheel),
        of_table("surface.pinion", surface.map(|flanks| &flanks.pinion)),
        of_table("surface.wheel", wheel_flank),
    ]
    .concat()
}

fn of_table<T: Table>(table: &'static str, stated: Option<&T>) -> Vec<Range> {
    of_rows(table, T::LIMITS, stated)
}

fn of_rows<T>(table: &'static str, rows: &[Limits<T>], stated: Option<&T>) -> Vec<Range> {
    let range = |row: &Limits<T>| Range {
        table,
        name: row.name,
        unit: row.unit,
        usual: row.usual,
        possible: row.possible,
        numbers: stated.map_or_else(Vec::new, row.numbers),
    };
    rows.iter().map(range).collect()
}

/// Smallest and largest possible size of the number at `key` in the unit that messages print; `None` for a key without
/// a range.
///
/// ```
/// use asperity_case::case::possible_range;
/// assert_eq!(possible_range("operation.speed"), Some([1e-6, 1e6]));
/// assert_eq!(possible_range("operation.bulk"), None);
/// ```
#[must_use]
pub fn possible_range(key: &str) -> Option<[f64; 2]> {
    range_of(key).map(|range| range.possible)
}

/// The range of the numbers at `key`.
pub(super) fn range_of(key: &str) -> Option<Range> {
    ranges(None).into_iter().find(|range| range.key() == key)
}

/// Viscosity of the oil at the bulk temperature \[Pa s\]: usual, and beyond which it is no oil of a gear drive.
const OIL_USUAL: [f64; 2] = [1e-3, 10.0];
const OIL_POSSIBLE: [f64; 2] = [1e-5, 100.0];

fn within(value: f64, range: [f64; 2]) -> bool {
    (range[0]..=range[1]).contains(&value)
}

impl Range {
    fn key(&self) -> Cow<'static, str> {
        format!("{}.{}", self.table, self.name).into()
    }

    /// The usual range as text with its unit.
    pub(super) fn usual(&self) -> String {
        let [low, high] = self.usual;
        with_unit(&format!("{} to {}", digits(low), digits(high)), self.unit)
    }

    /// The first number outside `range`. If the range is of positive numbers, others are left to the equation that takes
    /// them.
    fn outside(&self, range: [f64; 2]) -> Option<f64> {
        let judged = |value: &f64| range[0] < 0.0 || *value > 0.0;
        let mut numbers = self.numbers.iter().copied().filter(judged);
        numbers.find(|value| !within(*value, range))
    }

    /// The error of a number outside the possible range, if there is one.
    fn refused(&self, source: &Source) -> Option<CaseError> {
        let value = self.outside(self.possible)?;
        let seen = with_unit(&digits(value), self.unit);
        Some(impossible_at(source, self.key(), seen, self.usual()))
    }
}

fn impossible_at(
    source: &Source,
    key: Cow<'static, str>,
    seen: String,
    usual: String,
) -> CaseError {
    CaseError::Impossible {
        place: source.place_of(&key),
        written: source.written(&key).map(str::to_owned),
        key,
        seen,
        usual,
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
    let ranges = ranges(Some(input));
    ranges
        .iter()
        .filter_map(|range| range.refused(source))
        .collect()
}

/// Refuses the first number that no gear drive has.
pub(super) fn refuse_impossible(input: &CaseInput, source: &Source) -> Result<(), CaseError> {
    match impossible(input, source).into_iter().next() {
        Some(error) => Err(error),
        None => Ok(()),
    }
}

/// Refuses an oil that does not flow at the bulk temperature, or is a gas there.
pub(super) fn refuse_stiff_oil(
    oil: &LubricantState,
    operation: &OperationInput,
    source: &Source,
) -> Result<(), CaseError> {
    let viscosity = oil.dynamic_viscosity.si();
    if within(viscosity, OIL_POSSIBLE) {
        return Ok(());
    }
    let seen = format!("an oil of {} Pa s there", digits(viscosity));
    let usual = format!("{} to {} Pa s", OIL_USUAL[0], OIL_USUAL[1]);
    let key = operation.temperature_key().into();
    Err(impossible_at(source, key, seen, usual))
}

/// A quantity at the pitch point, which shows a wrong unit of the keys that it follows from.
pub(super) struct AtPitchPoint {
    value: f64,
    unit: &'static str,
    usual: [f64; 2],
    most: f64,
    /// The key of the operation that it is reported at.
    key: &'static str,
    name: &'static str,
}

/// Hertz pressure with the load on one pair of teeth, and pitch-line speed:
///
/// p₀ = √(w E*/(π R)) with w = |T|/(r_b1 b), R = C (T₁T₂ − C)/(T₁T₂ cos β_b); v = r_w1 ω.
pub(super) fn at_pitch_point(
    gears: &GearPair,
    modulus: Pressure,
    torque: Torque,
    speed: AngularSpeed,
) -> [AtPitchPoint; 2] {
    let path = gears.path();
    let (c, whole) = (path.c.si(), path.t1t2.si());
    let radius = c * (whole - c) / whole / gears.base_helix.si().cos();
    let load = torque.si().abs() / (gears.base_radius[0].si() * gears.face_width.si());
    [
        AtPitchPoint {
            value: 1e-9 * (load * modulus.si() / (PI * radius)).sqrt(),
            unit: "GPa",
            usual: [0.06, 3.0],
            most: 1e-9 * HIGHEST_PRESSURE.si(),
            key: "torque",
            name: "Hertz pressure at the pitch point (by torque, face width, teeth, module, Young's modulus)",
        },
        AtPitchPoint {
            value: gears.working_pitch_radius[0].si().abs() * speed.si(),
            unit: "m/s",
            usual: [0.0, 200.0],
            most: HIGHEST_SPEED,
            key: "speed",
            name: "pitch-line speed (by speed, teeth, module)",
        },
    ]
}

impl AtPitchPoint {
    pub(super) fn usual(&self) -> String {
        let [low, high] = self.usual;
        format!("{low} to {high} {}", self.unit)
    }

    /// Refuses a load or a speed that no pair of gears has.
    pub(super) fn refuse_impossible(&self, source: &Source) -> Result<(), CaseError> {
        if self.value <= self.most {
            return Ok(());
        }
        let key = Section::of(source, "operation").key(self.key);
        let seen = format!(
            "a {} of {} {}",
            self.name,
            decimals(self.value, 0),
            self.unit
        );
        Err(impossible_at(source, key, seen, self.usual()))
    }

    fn unusual(&self) -> Option<Warning> {
        let text = || {
            let value = with_unit(&digits(self.value), self.unit);
            let (key, name, usual) = (self.key, self.name, self.usual());
            format!("operation.{key}: a {name} of {value} is unusual; usual is {usual}")
        };
        (!within(self.value, self.usual)).then(|| Warning::new(UNUSUAL, text()))
    }
}

/// The note that the temperature is stated by its former name.
fn former_name(operation: &OperationInput) -> Option<Warning> {
    operation.temperature?;
    let [(of_flanks, _), (of_oil, _), (former, _)] = TEMPERATURE_KEYS;
    let now = match operation.bulk {
        Some(_) => of_oil,
        None => of_flanks,
    };
    let text = format!("{former} is the former name of {now}, as which it is read");
    Some(Warning::new(FORMER_NAME, text))
}

/// Warnings about the unusual numbers of a case.
pub(super) fn unusual(
    input: &CaseInput,
    source: &Source,
    oil: &LubricantState,
    loads: &[AtPitchPoint],
) -> Vec<Warning> {
    let note = |range: &Range| {
        let value = with_unit(&digits(range.outside(range.usual)?), range.unit);
        let (key, usual) = (source.key_in_train(range.key()), range.usual());
        let text = format!("{key} = {value} is unusual; usual is {usual}");
        Some(Warning::new(UNUSUAL, text))
    };
    let mut warnings: Vec<Warning> = ranges(Some(input)).iter().filter_map(note).collect();
    let viscosity = oil.dynamic_viscosity.si();
    if !within(viscosity, OIL_USUAL) {
        let [low, high] = OIL_USUAL;
        let viscosity = digits(viscosity);
        let key = input.operation.temperature_key();
        let text =
            format!("{key}: the oil has {viscosity} Pa s there; usual is {low} to {high} Pa s");
        warnings.push(Warning::new(UNUSUAL, text));
    }
    warnings.extend(loads.iter().filter_map(AtPitchPoint::unusual));
    warnings.extend(former_name(&input.operation));
    warnings
}

/// Warns of a pinion with more teeth than the wheel, which may be exchanged; not in a gear train.
pub(super) fn step_up(gears: &GearPair, source: &Source) -> Option<Warning> {
    let [pinion, wheel] = gears.teeth;
    let text = || {
        format!(
            "gears.teeth: the pinion, which is named first and has the speed and the torque of the case, has {pinion} teeth and the wheel {wheel}"
        )
    };
    (pinion > wheel && source.mesh().is_none()).then(|| Warning::new(UNUSUAL, text()))
}

/// W445: profile shifts of which the case gives only the sum, by its centre distance.
pub(super) fn divided_shifts(
    input: &GearsInput,
    gears: &GearPair,
    source: &Source,
) -> Option<Warning> {
    let is_stated = input.profile_shift.is_some() || input.tip_diameter.is_some();
    let [x1, x2] = gears.profile_shift?;
    (input.centre_distance.is_some() && !is_stated).then(|| {
        let sum = gears.profile_shift_sum;
        let key = source.key_in_train("gears.profile_shift".into());
        let text = format!(
            "{key}: the centre distance gives the sum {sum:.3}, taken as [{x1:.3}, {x2:.3}] with equal specific sliding at both ends of contact"
        );
        Warning::new(DIVIDED, text)
    })
}

/// The warnings that are not about numbers of the case.
pub(super) fn of_files(warnings: &[Warning]) -> Vec<Warning> {
    let is_of_a_file =
        |warning: &&Warning| ![UNUSUAL, SYMBOLS, FORMER_NAME, DIVIDED].contains(&&*warning.code);
    warnings.iter().filter(is_of_a_file).cloned().collect()
}
