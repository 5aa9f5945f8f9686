//! Units, and what a quantity is.

use super::QuantityError;

/// 0 °C \[K\].
pub(super) const ICE: f64 = 273.15;

/// Relation of a unit to the SI unit of its quantity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Scale {
    /// 10 to this power SI units; conversion of text is exact.
    Decimal(i32),
    /// This many SI units.
    Factor(f64),
    /// Degrees Celsius: SI = value + 273.15.
    Celsius,
}

/// A unit that a quantity accepts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unit {
    /// As printed in messages.
    pub symbol: &'static str,
    /// Other spellings, already without blanks, dots and brackets.
    pub spellings: &'static [&'static str],
    /// Relation to the SI unit.
    pub scale: Scale,
    /// Whether values may be printed in this unit.
    pub prints: bool,
}

/// A physical quantity: a number with a dimension.
pub trait Quantity:
    Copy + PartialOrd + std::fmt::Debug + std::fmt::Display + std::str::FromStr
{
    /// Name in messages: "torque".
    const NAME: &'static str;
    /// SI unit in messages: "N m".
    const SI_UNIT: &'static str;
    /// Accepted units; those that print are tried from the first, the largest first.
    const UNITS: &'static [Unit];
    /// The value in SI units.
    fn si(self) -> f64;
    /// The quantity of this SI value.
    fn from_si(value: f64) -> Self;
}

/// Name of a quantity and the units it reads.
#[derive(Debug, Clone, Copy)]
pub struct Description {
    /// Name of its type: "Torque".
    pub type_name: &'static str,
    /// Name in messages: "torque".
    pub name: &'static str,
    /// SI unit.
    pub si_unit: &'static str,
    /// Accepted units.
    pub units: &'static [Unit],
    /// Reads a number with a unit as its SI value.
    pub read: fn(&str) -> Result<f64, QuantityError>,
}
