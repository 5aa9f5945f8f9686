//! The one way a number outside its domain is reported.

use serde::Serialize;

use crate::message_number::number_with_unit;
use crate::quantity::Quantity;

/// An input that an equation does not accept, with what it must satisfy.
#[derive(Debug, Clone, PartialEq, Serialize, thiserror::Error)]
#[error("{name} = {}: {rule}", number_with_unit(*value, unit))]
pub struct DomainError {
    /// The input, by the name a reader of the signature knows.
    pub name: &'static str,
    /// The value seen, in `unit`.
    pub value: f64,
    /// Unit of `value`; `-` when it has none.
    pub unit: &'static str,
    /// Expectation as a phrase: "must be positive".
    pub rule: &'static str,
}

impl DomainError {
    /// The SI value of `quantity` when it is finite and above zero.
    ///
    /// ```
    /// use asperity_core::{DomainError, quantity::Length};
    /// assert_eq!(DomainError::positive("radius", Length::from_si(0.01)), Ok(0.01));
    /// assert!(DomainError::positive("radius", Length::from_si(0.0)).is_err());
    /// ```
    pub fn positive<Q: Quantity>(name: &'static str, quantity: Q) -> Result<f64, Self> {
        let value = quantity.si();
        Self::require(
            value.is_finite() && value > 0.0,
            name,
            value,
            Q::SI_UNIT,
            "must be finite and greater than zero",
        )
    }

    /// The SI value of `quantity` when it is finite and not below zero.
    pub fn non_negative<Q: Quantity>(name: &'static str, quantity: Q) -> Result<f64, Self> {
        let value = quantity.si();
        Self::require(
            value.is_finite() && value >= 0.0,
            name,
            value,
            Q::SI_UNIT,
            "must be finite and not negative",
        )
    }

    /// The SI value of `quantity` when it is finite.
    pub fn finite<Q: Quantity>(name: &'static str, quantity: Q) -> Result<f64, Self> {
        let value = quantity.si();
        Self::require(value.is_finite(), name, value, Q::SI_UNIT, "must be finite")
    }

    /// `value` when `holds`, otherwise the error that names it and the rule.
    pub fn require(
        holds: bool,
        name: &'static str,
        value: f64,
        unit: &'static str,
        rule: &'static str,
    ) -> Result<f64, Self> {
        if holds {
            Ok(value)
        } else {
            Err(Self {
                name,
                value,
                unit,
                rule,
            })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_message_reads_like_a_sentence() {
        let error = |value, unit| DomainError {
            name: "cut-off",
            value,
            unit,
            rule: "must be positive",
        };
        let text = |value, unit| error(value, unit).to_string();
        assert_eq!(text(-0.0025, "m"), "cut-off = -0.0025 m: must be positive");
        assert_eq!(text(f64::NAN, "-"), "cut-off = NaN: must be positive");
        assert_eq!(
            text(2.200_499_999_999_8e-3, "m"),
            "cut-off = 0.0022005 m: must be positive"
        );
    }
}
