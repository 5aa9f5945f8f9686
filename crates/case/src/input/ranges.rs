//! Numbers outside the usual range of their row, of which W201 warns, or outside its possible range, which E212 refuses.
//!
//! The usual ranges cover gear drives from toys to wind turbines, the possible ones leave some powers
//! of ten around them. Both are choices of this program: they are there to catch a wrong unit, not to judge a
//! design. Modifications of the flanks are checked as shares of the module. Zero, negative and missing numbers are checked
//! by the equations that take them, unless a range has negative numbers.

use std::borrow::Cow;

use asperity_core::Code;
use asperity_core::quantity::Length;
use asperity_gear::LoadLaw;
use asperity_oil::viscosity_index::viscosity_index;
use asperity_oil::{LubricantInput, ViscosityLaw};

use super::case_input::{CaseInput, VehicleInput};
use super::rows::{Judge, KeyPath, Limits, OPEN, RangedKey, in_unit, limits};
use crate::error::Error;
use crate::source::case_error::CaseError;
use crate::source::source_text::{Source, is_within};
use asperity_core::message::Warning;

/// Code of the warning about an unusual number.
pub(crate) const UNUSUAL: Code = Code::W201;

limits! {
    LubricantInput;
    viscosity => table;
    density = "kg/m3" usual [700.0, 1200.0] possible [300.0, 3000.0];
    density_temperature = "°C" usual [-30.0, 160.0] possible [-100.0, 400.0];
    thermal_expansion = "1/K" usual [4e-4, 1.2e-3] possible [1e-6, 1e-2];
    pressure_viscosity = "1/GPa" usual [3.0, 60.0] possible OPEN;
    pressure_viscosity_factor = "" usual [0.5, 1.5] possible [0.1, 10.0];
    limiting_shear_temperature = "1/K" usual [-0.005, 0.01] possible [-0.02, 0.02];
    thermal_conductivity = "W/(m K)" usual [0.08, 0.3] possible [0.005, 5.0];
    heat_capacity = "J/(kg K)" usual [1400.0, 3000.0] possible [200.0, 10_000.0];
    temperature_coefficient = "1/K" usual [0.005, 0.15] possible [1e-4, 1.0];
}

impl RangedKey for ViscosityLaw {
    fn visit(stated: Option<&Self>, at: KeyPath<'_>, judge: Judge<'_>) {
        for (name, limits, number) in &VISCOSITY {
            let number = stated.copied().and_then(number);
            let key = match name {
                &"" => at,
                name => at.below(name),
            };
            judge(key, limits, number.as_slice());
        }
    }
}

impl RangedKey for LoadLaw {
    fn visit(stated: Option<&Self>, at: KeyPath<'_>, judge: Judge<'_>) {
        let rows: &[(f64, f64)] = match stated {
            Some(Self::Table(rows)) => rows,
            _ => &[],
        };
        let numbers: Vec<f64> = rows
            .iter()
            .flat_map(|(at, weight)| [*at, *weight])
            .collect();
        judge(at.below("table"), &of_law("", [0.0, 10.0], OPEN), &numbers);
    }
}

/// A number of a viscosity law, in the unit of its ranges.
type OfViscosity = fn(ViscosityLaw) -> Option<f64>;

/// Ranges of a number of a law.
pub(crate) const fn of_law(unit: &'static str, usual: [f64; 2], possible: [f64; 2]) -> Limits {
    Limits {
        relation: "",
        unit,
        per_module: false,
        usual,
        possible,
    }
}

/// Rows of the viscosity, whose keys depend on its law.
const VISCOSITY: [(&str, Limits, OfViscosity); 10] = [
    (
        "at_40",
        of_law("mm2/s", [5.0, 2000.0], [0.3, 1e5]),
        |law| match law {
            ViscosityLaw::AstmD341 { at_40, .. } => Some(in_unit(at_40, "mm2/s")),
            _ => None,
        },
    ),
    (
        "at_100",
        of_law("mm2/s", [1.8, 150.0], [0.2, 1e4]),
        |law| match law {
            ViscosityLaw::AstmD341 { at_100, .. } => Some(in_unit(at_100, "mm2/s")),
            _ => None,
        },
    ),
    ("grade", of_law("", [5.0, 1500.0], OPEN), |law| match law {
        ViscosityLaw::IsoVg { grade, .. } => Some(grade),
        _ => None,
    }),
    (
        "viscosity_index",
        of_law("", INDEX_USUAL, INDEX_POSSIBLE),
        |law| match law {
            ViscosityLaw::IsoVg {
                viscosity_index, ..
            } => Some(viscosity_index),
            _ => None,
        },
    ),
    (
        "limit_viscosity",
        of_law("mPa s", [1e-4, 1.0], [1e-9, 100.0]),
        |law| match law {
            ViscosityLaw::Vogel {
                limit_viscosity, ..
            } => Some(in_unit(limit_viscosity, "mPa s")),
            _ => None,
        },
    ),
    (
        "slope_kelvin",
        of_law("", [400.0, 3000.0], [10.0, 30_000.0]),
        |law| match law {
            ViscosityLaw::Vogel { slope_kelvin, .. } => Some(slope_kelvin),
            _ => None,
        },
    ),
    (
        "pole_kelvin",
        of_law("", [50.0, 260.0], OPEN),
        |law| match law {
            ViscosityLaw::Vogel { pole_kelvin, .. } => Some(pole_kelvin),
            _ => None,
        },
    ),
    (
        "dynamic_viscosity",
        of_law("mPa s", [1.0, 2000.0], [0.05, 100_000.0]),
        |law| match law {
            ViscosityLaw::Given {
                dynamic_viscosity, ..
            } => Some(in_unit(dynamic_viscosity, "mPa s")),
            _ => None,
        },
    ),
    (
        "temperature",
        of_law("°C", [-30.0, 160.0], [-100.0, 400.0]),
        |law| match law {
            ViscosityLaw::Given { temperature, .. } => temperature.map(|at| in_unit(at, "°C")),
            _ => None,
        },
    ),
    (
        "",
        Limits {
            relation: "viscosity index (by the viscosities at 40 and 100 °C)",
            ..of_law("", INDEX_USUAL, INDEX_POSSIBLE)
        },
        |law| match law {
            // Exchanged viscosities are refused by the law, and the index begins at 2 mm²/s.
            ViscosityLaw::AstmD341 { at_40, at_100 } if at_40 > at_100 => {
                viscosity_index(at_40, at_100).ok()
            }
            _ => None,
        },
    ),
];

/// Viscosity indices from naphthenic and traction fluids to silicone oils.
const INDEX_USUAL: [f64; 2] = [-100.0, 450.0];
const INDEX_POSSIBLE: [f64; 2] = [-2000.0, 2000.0];

pub(crate) fn within(value: f64, range: [f64; 2]) -> bool {
    (range[0]..=range[1]).contains(&value)
}

/// A number of a case outside a range of its key.
struct Outside {
    key: String,
    /// Number of the entry of a list with the key.
    entry: Option<usize>,
    limits: Limits,
    /// The number, in the unit of its row.
    value: f64,
    /// The number that the ranges are of.
    judged: f64,
    /// Whether the number is possible, and only unusual.
    is_possible: bool,
}

/// The numbers of a table that are outside the ranges of their rows, one for each row.
fn outside<T: JudgedValue>(table: &T) -> Vec<Outside> {
    let mut found: Vec<Outside> = Vec::new();
    let module_mm = table.module().map_or(f64::NAN, |module| 1e3 * module.si());
    let mut judge = |at: KeyPath<'_>, limits: &Limits, numbers: &[f64]| {
        let divisor = if limits.per_module { module_mm } else { 1.0 };
        let first = |range: [f64; 2]| {
            // A range of positive numbers leaves others to the equation that takes them.
            let is_judged = |number: &f64| range[0] < 0.0 || *number > 0.0;
            let mut numbers = numbers.iter().copied().filter(is_judged);
            numbers
                .find(|number| (number / divisor).is_finite() && !within(number / divisor, range))
        };
        let impossible = first(limits.possible);
        // Nearly all numbers are usual, and every change of a case has all of them judged: they need no text of their key.
        let Some(value) = impossible.or_else(|| first(limits.usual)) else {
            return;
        };
        let key = at.to_string();
        // A relation follows from numbers of its table, which may be known as impossible.
        let table = key.rsplit_once('.').map_or("", |(table, _)| table);
        let follows = |before: &Outside| !before.is_possible && is_within(&before.key, table);
        if limits.relation.is_empty() || !found.iter().any(follows) {
            found.push(Outside {
                key,
                entry: at.entry(),
                limits: *limits,
                value,
                judged: value / divisor,
                is_possible: impossible.is_none(),
            });
        }
    };
    T::visit(Some(table), KeyPath::default().below(T::TABLE), &mut judge);
    found
}

impl Limits {
    /// The usual range as text with its unit.
    pub(crate) fn usual(&self) -> String {
        let [low, high] = self.usual;
        self.with_unit(&format!("{} to {}", digits(low), digits(high)))
    }

    fn with_unit(&self, text: &str) -> String {
        let text = with_unit(text, self.unit);
        if self.per_module {
            text + " per mm of module"
        } else {
            text
        }
    }
}

impl Outside {
    fn seen(&self) -> String {
        let mut seen = with_unit(&digits(self.value), self.limits.unit);
        if self.limits.per_module {
            seen += &format!(" ({})", self.limits.with_unit(&digits(self.judged)));
        }
        if let Some(entry) = self.entry {
            seen += &format!(" (entry {entry} of the list)");
        }
        match self.limits.relation {
            "" => seen,
            relation => format!("{relation} = {seen}"),
        }
    }

    fn error(self, source: &Source) -> CaseError {
        let (seen, usual) = (self.seen(), self.limits.usual());
        impossible_at(source, self.key.into(), seen, usual)
    }

    fn warning(self, source: &Source) -> Warning {
        let (seen, usual) = (self.seen(), self.limits.usual());
        let between = match self.limits.relation {
            "" => " =",
            _ => ":",
        };
        let key = source.key_in_train(self.key.into());
        let text = format!("{key}{between} {seen} is unusual; usual is {usual}");
        Warning::new(UNUSUAL, text)
    }
}

pub(crate) fn impossible_at(
    source: &Source,
    key: Cow<'static, str>,
    seen: String,
    usual: String,
) -> CaseError {
    CaseError::impossible(
        source.place_of(&key),
        &key,
        source.written(&key).map(str::to_owned),
        seen,
        &usual,
    )
}

pub(crate) fn with_unit(text: &str, unit: &str) -> String {
    match unit {
        "" => text.to_owned(),
        unit => format!("{text} {unit}"),
    }
}

pub(crate) fn digits(value: f64) -> String {
    let size = value.abs();
    let (number, power) = if size != 0.0 && !(1e-3..1e7).contains(&size) {
        let text = format!("{value:.3e}");
        let at = text.find('e').unwrap_or(text.len());
        (text[..at].to_owned(), text[at..].to_owned())
    } else {
        (format!("{value:.4}"), String::new())
    };
    number
        .trim_end_matches('0')
        .trim_end_matches('.')
        .to_owned()
        + &power
}

/// A case, or a table that is checked without its case.
pub(crate) trait JudgedValue: RangedKey {
    /// Path of the table; empty for the whole case.
    const TABLE: &'static str = "";

    /// Module of the gears whose modifications it states; a train's modifications are checked with its meshes.
    fn module(&self) -> Option<Length> {
        None
    }
}

impl JudgedValue for CaseInput {
    fn module(&self) -> Option<Length> {
        Some(self.gears.module)
    }
}

impl JudgedValue for VehicleInput {
    const TABLE: &'static str = "vehicle";
}

impl VehicleInput {
    /// W201 of every number that few vehicles have.
    ///
    /// # Errors
    /// When no vehicle has a number.
    pub fn unusual(&self) -> Result<Vec<Warning>, Error> {
        let source = Source::in_memory();
        refuse_impossible(self, &source)?;
        Ok(unusual(self, &source))
    }
}

/// Every number that no gear drive has.
pub(crate) fn impossible<T: JudgedValue>(input: &T, source: &Source) -> Vec<CaseError> {
    let found = outside(input).into_iter();
    let impossible = found.filter(|found| !found.is_possible);
    impossible.map(|found| found.error(source)).collect()
}

/// Refuses the first number that no gear drive has.
pub(crate) fn refuse_impossible<T: JudgedValue>(
    input: &T,
    source: &Source,
) -> Result<(), CaseError> {
    match impossible(input, source).into_iter().next() {
        Some(error) => Err(error),
        None => Ok(()),
    }
}

/// W201 of every number that few gear drives have.
pub(crate) fn unusual<T: JudgedValue>(input: &T, source: &Source) -> Vec<Warning> {
    let found = outside(input).into_iter();
    let unusual = found.filter(|found| found.is_possible);
    unusual.map(|found| found.warning(source)).collect()
}

/// The ranges of the first row of the case `T` that is meant.
pub(crate) fn row_of<T: RangedKey>(is_meant: &dyn Fn(&str) -> bool) -> Option<Limits> {
    let mut found = None;
    let mut judge = |at: KeyPath<'_>, limits: &Limits, _: &[f64]| {
        if limits.relation.is_empty() && found.is_none() && is_meant(&at.to_string()) {
            found = Some(*limits);
        }
    };
    T::visit(None, KeyPath::default(), &mut judge);
    found
}

/// The ranges of the numbers at `key` of a pair of gears.
pub(crate) fn range_in_pair(key: &str) -> Option<Limits> {
    row_of::<CaseInput>(&|row| is_within(key, row))
}
