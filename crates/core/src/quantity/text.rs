//! Quantities from text and to text.

use super::error::{QuantityError, with_article};
use super::unit::{ICE, Quantity, Scale, Unit};
use crate::unit_text;

/// All units that a quantity accepts, with their other spellings.
pub(super) fn accepted<Q: Quantity>() -> String {
    let units = Q::UNITS.iter();
    let units = units.flat_map(|unit| std::iter::once(&unit.symbol).chain(unit.spellings));
    units.copied().collect::<Vec<_>>().join(", ")
}

/// The error for a bare number where a quantity is due.
fn bare<Q: Quantity>(number: impl std::fmt::Display) -> QuantityError {
    QuantityError::NoUnit {
        quantity: Q::NAME,
        text: number.to_string(),
        accepted: accepted::<Q>(),
        example: Q::UNITS.first().map_or(Q::SI_UNIT, |unit| unit.symbol),
    }
}

fn find_unit<Q: Quantity>(unit: &str) -> Option<&'static Unit> {
    let spelling = unit_text::normalise(unit);
    Q::UNITS.iter().find(|unit| {
        unit_text::normalise(unit.symbol) == spelling || unit.spellings.contains(&spelling.as_str())
    })
}

/// Reads a number with a unit; the heart of every quantity's `FromStr`.
pub(super) fn parse<Q: Quantity>(text: &str) -> Result<Q, QuantityError> {
    let (number, unit) = unit_text::split(text);
    let impossible = || QuantityError::Impossible {
        quantity: Q::NAME,
        text: text.trim().to_owned(),
    };
    // "1/min" alone would split as the number 1 and the unit "/min".
    if number.is_empty() || unit.starts_with('/') {
        return Err(QuantityError::NotANumber {
            quantity: Q::NAME,
            text: text.trim().to_owned(),
            accepted: accepted::<Q>(),
        });
    }
    if number.contains(',') {
        return Err(QuantityError::DecimalComma {
            quantity: Q::NAME,
            text: text.trim().to_owned(),
        });
    }
    if unit.is_empty() {
        return Err(bare::<Q>(number));
    }
    let Some(matching) = find_unit::<Q>(unit) else {
        return Err(QuantityError::UnknownUnit {
            quantity: Q::NAME,
            unit: unit.to_owned(),
            accepted: accepted::<Q>(),
        });
    };
    let value = unit_value(number, matching.scale).ok_or_else(|| QuantityError::NotANumber {
        quantity: Q::NAME,
        text: text.trim().to_owned(),
        accepted: accepted::<Q>(),
    })?;
    // A temperature, in °C or in K, is not below absolute zero.
    let is_temperature = Q::UNITS
        .iter()
        .any(|unit| matches!(unit.scale, Scale::Celsius));
    if is_temperature && value < 0.0 {
        return Err(impossible());
    }
    if value.is_finite() {
        Ok(Q::from_si(value))
    } else {
        Err(impossible())
    }
}

fn unit_value(number: &str, scale: Scale) -> Option<f64> {
    match scale {
        Scale::Decimal(shift) => unit_text::parse_shifted(number, shift),
        Scale::Factor(factor) => unit_text::parse_shifted(number, 0).map(|v| v * factor),
        Scale::Celsius => unit_text::parse_shifted(number, 0).map(|v| v + ICE),
    }
}

/// The value in a unit as text that reads back to the same bits, if the unit can do that.
fn text_in(value: f64, unit: &Unit) -> Option<String> {
    let candidate = match unit.scale {
        Scale::Decimal(shift) => return Some(unit_text::format_shifted(value, shift)),
        Scale::Factor(factor) => value / factor,
        Scale::Celsius => value - ICE,
    };
    // A rounded conversion may be off by a few last bits: prefer few digits that read back.
    (1..=17).find_map(|digits| {
        let text = format!("{candidate:.*e}", digits - 1);
        let shortened = unit_text::format_shifted(text.parse().ok()?, 0);
        (unit_value(&shortened, unit.scale) == Some(value)).then_some(shortened)
    })
}

/// The value in a unit with this many significant digits, without trailing zeros.
fn rounded(value: f64, unit: &Unit, digits: usize) -> Option<String> {
    let in_unit = match unit.scale {
        Scale::Decimal(shift) => value / 10f64.powi(shift),
        Scale::Factor(factor) => value / factor,
        Scale::Celsius => value - ICE,
    };
    let text = format!("{in_unit:.*e}", digits.max(1) - 1);
    Some(unit_text::format_shifted(text.parse().ok()?, 0))
}

pub(super) fn print<Q: Quantity>(quantity: Q, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
    let value = quantity.si();
    let size = |unit: &Unit| match unit.scale {
        Scale::Decimal(shift) => value.abs() / 10f64.powi(shift),
        Scale::Factor(factor) => value.abs() / factor,
        Scale::Celsius => f64::INFINITY,
    };
    let printing = || Q::UNITS.iter().filter(|unit| unit.prints);
    // Zero prints in the first unit; a small value in the last.
    let chosen = printing()
        .find(|unit| value == 0.0 || size(unit) >= 1.0)
        .or_else(|| printing().next_back());
    let text = |unit: &Unit| match f.precision() {
        None => text_in(value, unit),
        Some(digits) => rounded(value, unit, digits),
    };
    match chosen.and_then(|unit| Some((text(unit)?, unit.symbol))) {
        Some((text, symbol)) => write!(f, "{text} {symbol}"),
        None => write!(f, "{} {}", unit_text::format_shifted(value, 0), Q::SI_UNIT),
    }
}

/// Reads a quantity from a structured format: text, and nothing else.
pub(super) struct QuantityVisitor<Q>(pub(super) std::marker::PhantomData<Q>);

impl<Q: Quantity> serde::de::Visitor<'_> for QuantityVisitor<Q> {
    type Value = Q;

    fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(
            f,
            "{} as text with a unit ({})",
            with_article(Q::NAME),
            accepted::<Q>()
        )
    }

    fn visit_str<E: serde::de::Error>(self, text: &str) -> Result<Q, E> {
        parse(text).map_err(E::custom)
    }

    fn visit_f64<E: serde::de::Error>(self, number: f64) -> Result<Q, E> {
        Err(E::custom(bare::<Q>(number)))
    }

    fn visit_i64<E: serde::de::Error>(self, number: i64) -> Result<Q, E> {
        Err(E::custom(bare::<Q>(number)))
    }

    fn visit_u64<E: serde::de::Error>(self, number: u64) -> Result<Q, E> {
        Err(E::custom(bare::<Q>(number)))
    }
}
