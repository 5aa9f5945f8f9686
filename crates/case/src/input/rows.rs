//! Rows of the case file: one for each key, from which its field, ranges, default and check follow.
//!
//! [`table!`] makes the structure of a table as the user writes it, with the usual and the possible range of its numbers.
//! [`choices!`] makes a table whose keys all have a default: the structure as written, the structure with a value
//! for every key, and the function that converts the first into the second and checks the numbers. Documentation, schema,
//! known keys and keys set by their path follow from the structures.

use asperity_core::quantity::{
    Angle, AngularSpeed, Area, Density, DynamicViscosity, Force, KinematicViscosity, Length, Mass,
    PerKelvin, Power, Pressure, PressureViscosity, Quantity, Ratio, Scale, SpecificHeat, Speed,
    Temperature, TemperatureDifference, ThermalConductance, ThermalConductivity, Torque,
    VolumeFlow,
};

use asperity_core::hardness::Hardness;
use asperity_ehl_regime::inlet_flow::Lay;
use asperity_profile_io::read::{Columns, TraceRange};

use super::one_or_two::OneOrTwo;
use super::path_point::PathPoint;

/// Usual and possible range of the numbers of a key, as a row states it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// Quantity that follows from several keys; empty for the numbers of a single key.
    pub relation: &'static str,
    /// Unit of the ranges, as messages print it.
    pub unit: &'static str,
    /// Whether the ranges are for each millimetre of the module.
    pub per_module: bool,
    /// Range outside of which W201 warns.
    pub usual: [f64; 2],
    /// Range outside of which E212 refuses.
    pub possible: [f64; 2],
}

/// Possible range of a number whose limits follow from an equation.
pub(crate) const OPEN: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

/// Path of a table or key in the case; its text is `gears.pinion.crowning`.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct KeyPath<'a> {
    above: Option<&'a Self>,
    name: &'a str,
    /// Number of the entry in a list, which has the path of the list.
    entry: Option<usize>,
}

impl<'a> KeyPath<'a> {
    /// Path of the key `name` of this table.
    pub fn below(&'a self, name: &'a str) -> Self {
        Self {
            above: Some(self),
            name,
            entry: None,
        }
    }

    /// Number of the entry of a list that the key belongs to, counted from 1.
    pub fn entry(&self) -> Option<usize> {
        self.entry.or_else(|| self.above?.entry())
    }
}

impl std::fmt::Display for KeyPath<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.above {
            Some(above) if !above.name.is_empty() => write!(f, "{above}.{}", self.name),
            _ => f.write_str(self.name),
        }
    }
}

/// Function of a key, its ranges, and its numbers in the unit of the ranges.
pub(crate) type Judge<'a> = &'a mut dyn FnMut(KeyPath<'_>, &Limits, &[f64]);

/// A table of the case file whose numbers have ranges.
pub(crate) trait RangedKey {
    /// Calls `judge` with every key with ranges; without numbers if the table is not stated.
    fn visit(stated: Option<&Self>, at: KeyPath<'_>, judge: Judge<'_>);
}

impl<T: RangedKey> RangedKey for Option<T> {
    fn visit(stated: Option<&Self>, at: KeyPath<'_>, judge: Judge<'_>) {
        T::visit(stated.and_then(Self::as_ref), at, judge);
    }
}

impl<T: RangedKey> RangedKey for Vec<T> {
    fn visit(stated: Option<&Self>, at: KeyPath<'_>, judge: Judge<'_>) {
        let Some(entries) = stated else {
            return T::visit(None, at, judge);
        };
        for (index, entry) in entries.iter().enumerate() {
            let number = (entries.len() > 1).then_some(index + 1);
            T::visit(
                Some(entry),
                KeyPath {
                    entry: number,
                    ..at
                },
                judge,
            );
        }
    }
}

/// Numbers of a value, in a unit that its quantity accepts.
pub(crate) trait KeyNumbers {
    fn numbers(&self, unit: &str) -> Vec<f64>;
}

impl KeyNumbers for f64 {
    fn numbers(&self, _: &str) -> Vec<f64> {
        vec![*self]
    }
}

/// Ranges apply to the magnitude: the number of teeth of a ring is negative.
impl KeyNumbers for i32 {
    fn numbers(&self, _: &str) -> Vec<f64> {
        vec![f64::from(self.unsigned_abs())]
    }
}

impl KeyNumbers for usize {
    fn numbers(&self, _: &str) -> Vec<f64> {
        vec![*self as f64]
    }
}

impl KeyNumbers for u32 {
    fn numbers(&self, _: &str) -> Vec<f64> {
        vec![f64::from(*self)]
    }
}

impl KeyNumbers for u8 {
    fn numbers(&self, unit: &str) -> Vec<f64> {
        u32::from(*self).numbers(unit)
    }
}

impl KeyNumbers for Hardness {
    fn numbers(&self, _: &str) -> Vec<f64> {
        // Another scale ends where steel does.
        self.vickers().into_iter().collect()
    }
}

impl KeyNumbers for Lay {
    fn numbers(&self, _: &str) -> Vec<f64> {
        vec![self.gamma()]
    }
}

impl KeyNumbers for PathPoint {
    fn numbers(&self, _: &str) -> Vec<f64> {
        match self {
            Self::Fraction(fraction) => vec![*fraction],
            Self::Named(_) => Vec::new(),
        }
    }
}

impl KeyNumbers for Columns {
    fn numbers(&self, _: &str) -> Vec<f64> {
        let columns = self.x.into_iter().chain([self.z]);
        columns.map(|column| column as f64).collect()
    }
}

impl KeyNumbers for TraceRange {
    fn numbers(&self, unit: &str) -> Vec<f64> {
        self.ends().numbers(unit)
    }
}

/// The ranges of a share are stated in per cent, as it is written.
impl KeyNumbers for Ratio {
    fn numbers(&self, _: &str) -> Vec<f64> {
        vec![1e2 * self.value()]
    }
}

/// Ranges apply to the magnitude: a negative torque means that the wheel drives.
impl KeyNumbers for Torque {
    fn numbers(&self, unit: &str) -> Vec<f64> {
        vec![in_unit(*self, unit).abs()]
    }
}

macro_rules! quantities {
    ($($quantity:ident),*) => {
        $(impl KeyNumbers for $quantity {
            fn numbers(&self, unit: &str) -> Vec<f64> {
                vec![in_unit(*self, unit)]
            }
        })*
    };
}

quantities!(
    Angle,
    AngularSpeed,
    Area,
    Density,
    DynamicViscosity,
    Force,
    KinematicViscosity,
    Length,
    Mass,
    PerKelvin,
    Power,
    Pressure,
    PressureViscosity,
    SpecificHeat,
    Speed,
    Temperature,
    TemperatureDifference,
    ThermalConductance,
    ThermalConductivity,
    VolumeFlow
);

impl<T: KeyNumbers> KeyNumbers for Option<T> {
    fn numbers(&self, unit: &str) -> Vec<f64> {
        self.iter().flat_map(|value| value.numbers(unit)).collect()
    }
}

impl<T: KeyNumbers, const N: usize> KeyNumbers for [T; N] {
    fn numbers(&self, unit: &str) -> Vec<f64> {
        self.iter().flat_map(|value| value.numbers(unit)).collect()
    }
}

impl<T: KeyNumbers> KeyNumbers for Vec<T> {
    fn numbers(&self, unit: &str) -> Vec<f64> {
        self.iter().flat_map(|value| value.numbers(unit)).collect()
    }
}

impl<T: KeyNumbers + Copy> KeyNumbers for OneOrTwo<T> {
    fn numbers(&self, unit: &str) -> Vec<f64> {
        self.both().numbers(unit)
    }
}

/// Ratio of two numbers; none unless both are positive, which other rules judge.
pub(crate) fn ratio(above: Option<f64>, below: Option<f64>) -> Vec<f64> {
    let both = above.zip(below).into_iter();
    both.filter(|(above, below)| *above > 0.0 && *below > 0.0)
        .map(|(above, below)| above / below)
        .collect()
}

/// Relation of `unit` to the SI unit of a quantity.
fn scale_of<Q: Quantity>(unit: &str) -> Option<Scale> {
    let accepted = Q::UNITS.iter().find(|accepted| accepted.symbol == unit);
    accepted.map(|accepted| accepted.scale)
}

/// The value in `unit`; in SI units if its quantity does not accept the unit.
pub(crate) fn in_unit<Q: Quantity>(value: Q, unit: &str) -> f64 {
    match scale_of::<Q>(unit) {
        Some(Scale::Decimal(power)) => value.si() / 10.0_f64.powi(power),
        Some(Scale::Factor(factor)) => value.si() / factor,
        Some(Scale::Celsius) => Temperature::from_si(value.si()).celsius(),
        None => value.si(),
    }
}

/// The rows of a table.
///
/// ```text
/// /// Documentation, printed by messages and in docs/CASE_FILE.md.
/// #[serde(...)]                       if results omit the key unless it is stated
/// name: Type = "unit" usual [low, high] possible [low, high];
/// name: Type = "unit" per module usual [low, high] possible [low, high];     for each mm of the module
/// name: Type => table;                                    a table whose keys have rows of their own
/// => {                                                    relations of several keys, reported at one of them
///     "name": "quantity", |table| numbers, "unit" usual [low, high] possible [low, high];
/// }
/// ```
///
/// A key without ranges takes no number; `Option<Type>` is optional.
macro_rules! table {
    (
        $(#[$meta:meta])* $table:ident $(<$kind:ident = $default:ty>)?;
        $($(#[$attr:meta])* $name:ident: $type:ty
            $(= $unit:literal $(per $module:ident)? usual $usual:tt possible $possible:tt)?
            $(=> $inner:ident)?;)*
        $(=> { $($relations:tt)* })?
    ) => {
        $(#[$meta])*
        #[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
        #[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
        #[serde(deny_unknown_fields)]
        pub struct $table $(<$kind = $default>)? {
            $($(#[$attr])* pub $name: $type,)*
        }

        $crate::input::rows::limits! {
            $table $(<$kind>)?;
            $($($name = $unit $(per $module)? usual $usual possible $possible;)?
            $($name => $inner;)?)*
            $(=> { $($relations)* })?
        }
    };
}

/// The ranges of a table, as the rows of [`table!`] without types.
macro_rules! limits {
    (
        $table:ident $(<$kind:ident>)?;
        $($name:ident
            $(= $unit:literal $(per $module:ident)? usual $usual:tt possible $possible:tt)?
            $(=> $inner:ident)?;)*
        $(=> {
            $($key:literal: $relation:literal, $value:expr, $of:literal usual $usually:tt possible $possibly:tt;)*
        })?
    ) => {
        impl $(<$kind>)? $crate::input::rows::RangedKey for $table $(<$kind>)? {
            fn visit(
                stated: Option<&Self>,
                at: $crate::input::rows::KeyPath<'_>,
                judge: $crate::input::rows::Judge<'_>,
            ) {
                $(
                    let key = at.below(stringify!($name));
                    let value = stated.map(|table| &table.$name);
                    $(
                        let limits = $crate::input::rows::Limits {
                            relation: "",
                            unit: $unit,
                            per_module: !stringify!($($module)?).is_empty(),
                            usual: $usual,
                            possible: $possible,
                        };
                        let numbers = value.map(|value| $crate::input::rows::KeyNumbers::numbers(value, $unit));
                        judge(key, &limits, &numbers.unwrap_or_default());
                    )?
                    $(
                        $crate::input::rows::opened!($inner);
                        $crate::input::rows::RangedKey::visit(value, key, judge);
                    )?
                )*
                $($(
                    let limits = $crate::input::rows::Limits {
                        relation: $relation,
                        unit: $of,
                        per_module: false,
                        usual: $usually,
                        possible: $possibly,
                    };
                    let value: fn(&Self) -> Vec<f64> = $value;
                    let numbers = stated.map(value).unwrap_or_default();
                    judge(at.below($key), &limits, &numbers);
                )*)?
            }
        }
    };
}

/// The only word behind `=>` in a row.
macro_rules! opened {
    (table) => {};
}

/// Conversion of a value as written in the file into the value used in the computation.
pub(crate) trait Resolved<T> {
    fn resolved(self) -> T;
}

impl<T> Resolved<T> for T {
    fn resolved(self) -> T {
        self
    }
}

impl<T: Copy> Resolved<[T; 2]> for OneOrTwo<T> {
    fn resolved(self) -> [T; 2] {
        self.both()
    }
}

impl Resolved<f64> for Ratio {
    fn resolved(self) -> f64 {
        self.value()
    }
}

/// The number that a check compares with its rule, in SI units.
pub(crate) trait Checkable {
    fn number(&self) -> f64;
}

impl Checkable for f64 {
    fn number(&self) -> f64 {
        *self
    }
}

impl Checkable for usize {
    fn number(&self) -> f64 {
        *self as f64
    }
}

impl Checkable for Length {
    fn number(&self) -> f64 {
        self.si()
    }
}

/// Value of a key as a case states it, and the default that its formulation states.
#[derive(Debug, Clone, Copy)]
pub(crate) struct StatedRow<T> {
    pub by_case: Option<T>,
    pub by_formulation: Option<T>,
}

impl<T> StatedRow<T> {
    /// The value of a key that has no default of its own.
    pub fn value(self) -> Option<T> {
        self.by_case.or(self.by_formulation)
    }
}

/// The rows of a table whose keys all have a default.
///
/// ```text
/// /// Documentation, printed by messages and in docs/CASE_FILE.md.
/// name: Type => TypeInTheRun = default(arguments) usual "unit" [low, high], check("name", |v| condition, "rule");
/// name: Type => TypeInTheRun = default(arguments) => table;      a table whose keys have rows of their own
/// (crate) name: Type = default(arguments);                       a name for which the run has another value
/// ```
///
/// A number has a usual range (W201); what is possible is its check.
/// `default` is a method of the context: it returns the stated value, or the default, which it adds to the list of defaults.
/// A formulation may state another default.
/// Arguments may use the values of the rows above. `with` adds values that follow from several rows.
macro_rules! choices {
    (
        $(#[doc = $of_input:literal])* $input:ident => $(#[doc = $of_choice:literal])* $choice:ident
        in $table:literal by $context:ty;
        with { $($(#[doc = $of_extra:literal])* $extra:ident: $extra_type:ty = $value:expr;)* }
        $($(#[doc = $doc:literal])* $(#[serde($($serde:tt)*)])?
            $(($choice_in:ident))? $name:ident: $type:ty $(=> $own:ty)? = $default:ident($($arg:expr),*)
            $(usual $unit:literal $usual:tt)? $(=> $inner:ident)?
            $(, check($called:literal, $holds:expr, $rule:literal))?;)*
    ) => {
        $(#[doc = $of_input])*
        #[derive(Debug, Clone, PartialEq, Default, serde::Serialize, serde::Deserialize)]
        #[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
        #[serde(deny_unknown_fields)]
        pub struct $input {
            $($(#[doc = $doc])* $(#[serde($($serde)*)])? pub $name: Option<$type>,)*
        }

        $crate::input::rows::limits! {
            $input;
            $($($name = $unit usual $usual possible OPEN;)?
            $($name => $inner;)?)*
        }

        $(#[doc = $of_choice])*
        #[derive(Debug, Clone, PartialEq)]
        #[non_exhaustive]
        pub struct $choice {
            $($(#[doc = $doc])* pub $(($choice_in))? $name: $crate::input::rows::own!($type $(, $own)?),)*
            $($(#[doc = $of_extra])* pub $extra: $extra_type,)*
        }

        impl $choice {
            /// Fills in every key, lists the defaults used, and checks the numbers.
            fn from_input(
                stated: &$input,
                by_formulation: &$input,
                at: &mut $context,
            ) -> Result<Self, $crate::source::case_error::CaseError> {
                $(
                    let key = concat!($table, ".", stringify!($name));
                    let values = $crate::input::rows::StatedRow {
                        by_case: Clone::clone(&stated.$name),
                        by_formulation: Clone::clone(&by_formulation.$name),
                    };
                    let chosen = at.$default(key, values $(, $arg)*)?;
                    let $name: $crate::input::rows::own!($type $(, $own)?) =
                        $crate::input::rows::Resolved::resolved(chosen);
                    $(
                        let number = $crate::input::rows::Checkable::number(&$name);
                        let holds: fn(f64) -> bool = $holds;
                        asperity_core::DomainError::require(holds(number), $called, number, "-", $rule)
                            .map_err($crate::source::section::domain(at.source, key))?;
                    )?
                )*
                $(let $extra = $value;)*
                Ok(Self { $($name,)* $($extra,)* })
            }
        }
    };
}

/// The second type if there is one.
macro_rules! own {
    ($type:ty) => {
        $type
    };
    ($type:ty, $own:ty) => {
        $own
    };
}

pub(crate) use {choices, limits, opened, own, table};
