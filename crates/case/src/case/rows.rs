//! Rows of the case file: one for each key, from which its field, ranges, default and check follow.
//!
//! [`table!`] makes the structure of a table as the user writes it, with the usual and the possible range of its numbers.
//! [`choices!`] makes a table whose keys all have a default: the structure as written, the structure with a value
//! for every key, and the function that converts the first into the second and checks the numbers. Documentation, schema,
//! known keys and keys set by their path follow from the structures.

use asperity_core::quantity::{
    Angle, AngularSpeed, Area, Density, Force, Length, Mass, PerKelvin, Pressure, Quantity, Ratio,
    Scale, SpecificHeat, Speed, Temperature, ThermalConductance, ThermalConductivity, Torque,
    VolumeFlow,
};

use super::one_or_two::OneOrTwo;

/// Usual and possible range of the numbers of a key, as a row states it.
pub(super) struct Limits<T: 'static> {
    /// Name of the key in its table.
    pub name: &'static str,
    /// Unit of the ranges, as messages print it.
    pub unit: &'static str,
    /// Range outside of which W201 warns.
    pub usual: [f64; 2],
    /// Range outside of which E212 refuses.
    pub possible: [f64; 2],
    /// The numbers of the key in `unit`.
    pub numbers: fn(&T) -> Vec<f64>,
}

/// Possible range of a number whose limits follow from an equation.
pub(super) const OPEN: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

/// A table of the case file whose numbers have ranges.
pub(super) trait Table: Sized + 'static {
    /// One row for each key with ranges.
    const LIMITS: &'static [Limits<Self>];
}

/// Numbers of a value, in a unit that its quantity accepts.
pub(super) trait Numbers {
    fn numbers(&self, unit: &str) -> Vec<f64>;
}

impl Numbers for f64 {
    fn numbers(&self, _: &str) -> Vec<f64> {
        vec![*self]
    }
}

impl Numbers for i32 {
    fn numbers(&self, _: &str) -> Vec<f64> {
        vec![f64::from(*self)]
    }
}

/// Ranges apply to the magnitude: a negative torque means that the wheel drives.
impl Numbers for Torque {
    fn numbers(&self, unit: &str) -> Vec<f64> {
        vec![in_unit(*self, unit).abs()]
    }
}

macro_rules! quantities {
    ($($quantity:ident),*) => {
        $(impl Numbers for $quantity {
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
    Force,
    Length,
    Mass,
    PerKelvin,
    Pressure,
    SpecificHeat,
    Speed,
    Temperature,
    ThermalConductance,
    ThermalConductivity,
    VolumeFlow
);

impl<T: Numbers> Numbers for Option<T> {
    fn numbers(&self, unit: &str) -> Vec<f64> {
        self.iter().flat_map(|value| value.numbers(unit)).collect()
    }
}

impl<T: Numbers> Numbers for [T; 2] {
    fn numbers(&self, unit: &str) -> Vec<f64> {
        self.iter().flat_map(|value| value.numbers(unit)).collect()
    }
}

impl<T: Numbers + Copy> Numbers for OneOrTwo<T> {
    fn numbers(&self, unit: &str) -> Vec<f64> {
        self.both().numbers(unit)
    }
}

/// Relation of `unit` to the SI unit of a quantity.
fn scale_of<Q: Quantity>(unit: &str) -> Option<Scale> {
    let accepted = Q::UNITS.iter().find(|accepted| accepted.symbol == unit);
    accepted.map(|accepted| accepted.scale)
}

/// The value in `unit`; in SI units if its quantity does not accept the unit.
pub(super) fn in_unit<Q: Quantity>(value: Q, unit: &str) -> f64 {
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
/// ```
///
/// A key without `= ...` has no ranges; `Option<Type>` is optional.
macro_rules! table {
    (
        $(#[$meta:meta])* $table:ident;
        $($(#[$attr:meta])* $name:ident: $type:ty
            $(= $unit:literal usual $usual:tt possible $possible:tt)?;)*
    ) => {
        $(#[$meta])*
        #[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
        #[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
        #[serde(deny_unknown_fields)]
        pub struct $table {
            $($(#[$attr])* pub $name: $type,)*
        }

        $crate::case::rows::limits! {
            $table;
            $($($name = $unit usual $usual possible $possible;)?)*
        }
    };
}

/// The ranges of a table: `name = "unit" usual [low, high] possible [low, high];`.
macro_rules! limits {
    ($table:ident; $($name:ident = $unit:literal usual $usual:tt possible $possible:tt;)*) => {
        impl $crate::case::rows::Table for $table {
            const LIMITS: &'static [$crate::case::rows::Limits<Self>] = &[
                $($crate::case::rows::Limits {
                    name: stringify!($name),
                    unit: $unit,
                    usual: $usual,
                    possible: $possible,
                    numbers: |table| $crate::case::rows::Numbers::numbers(&table.$name, $unit),
                },)*
            ];
        }
    };
}

/// Conversion of a value as written in the file into the value used in the computation.
pub(super) trait Resolved<T> {
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
pub(super) trait Checkable {
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

/// The rows of a table whose keys all have a default.
///
/// ```text
/// /// Documentation, printed by messages and in docs/CASE_FILE.md.
/// name: Type => TypeInTheRun = default(arguments), check("name", |v| condition, "rule");
/// ```
///
/// `default` is a method of the context: it returns the stated value, or the default, which it adds to the list of defaults.
/// Arguments may use the values of the rows above. `with` adds values that follow from several rows.
macro_rules! choices {
    (
        $(#[doc = $of_input:literal])* $input:ident => $(#[doc = $of_choice:literal])* $choice:ident
        in $table:literal by $context:ty;
        with { $($(#[doc = $of_extra:literal])* $extra:ident: $extra_type:ty = $value:expr;)* }
        $($(#[doc = $doc:literal])* $(#[serde($($serde:tt)*)])?
            $name:ident: $type:ty $(=> $own:ty)? = $default:ident($($arg:expr),*)
            $(, check($called:literal, $holds:expr, $rule:literal))?;)*
    ) => {
        $(#[doc = $of_input])*
        #[derive(Debug, Clone, PartialEq, Default, serde::Serialize, serde::Deserialize)]
        #[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
        #[serde(deny_unknown_fields)]
        pub struct $input {
            $($(#[doc = $doc])* $(#[serde($($serde)*)])? pub $name: Option<$type>,)*
        }

        $(#[doc = $of_choice])*
        #[derive(Debug, Clone, PartialEq)]
        #[non_exhaustive]
        pub struct $choice {
            $($(#[doc = $doc])* pub $name: $crate::case::rows::own!($type $(, $own)?),)*
            $($(#[doc = $of_extra])* pub $extra: $extra_type,)*
        }

        impl $choice {
            /// Fills in every key, lists the defaults used, and checks the numbers.
            fn of(stated: &$input, at: &mut $context) -> Result<Self, $crate::case::CaseError> {
                $(
                    let key = concat!($table, ".", stringify!($name));
                    let chosen = at.$default(key, Clone::clone(&stated.$name) $(, $arg)*)?;
                    let $name: $crate::case::rows::own!($type $(, $own)?) =
                        $crate::case::rows::Resolved::resolved(chosen);
                    $(
                        let number = $crate::case::rows::Checkable::number(&$name);
                        let holds: fn(f64) -> bool = $holds;
                        asperity_core::DomainError::require(holds(number), $called, number, "-", $rule)
                            .map_err($crate::case::section::domain(at.source, key))?;
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

pub(super) use {choices, limits, own, table};
