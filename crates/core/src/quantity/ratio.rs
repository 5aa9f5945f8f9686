//! Shares without unit.

use super::QuantityError;
use crate::unit_text;

/// A share without unit; reads "1 %" as 0.01 and bare numbers as they are.
///
/// ```
/// use asperity_core::quantity::Ratio;
/// assert_eq!("1 %".parse::<Ratio>().map(Ratio::value), Ok(0.01));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd, Default)]
pub struct Ratio(f64);

impl Ratio {
    /// The share of this value: 0.01 is one percent.
    pub const fn new(value: f64) -> Self {
        Self(value)
    }

    /// The share as a number.
    pub const fn value(self) -> f64 {
        self.0
    }
}

impl std::str::FromStr for Ratio {
    type Err = QuantityError;

    fn from_str(text: &str) -> Result<Self, QuantityError> {
        let (number, unit) = unit_text::split(text);
        let shift = match unit {
            "" => 0,
            "%" => -2,
            _ => {
                return Err(QuantityError::UnknownUnit {
                    quantity: "ratio",
                    unit: unit.to_owned(),
                    accepted: "%, or none".to_owned(),
                });
            }
        };
        unit_text::parse_shifted(number, shift)
            .map(Self)
            .ok_or_else(|| QuantityError::NotANumber {
                quantity: "ratio",
                text: text.to_owned(),
                accepted: "%, or none".to_owned(),
            })
    }
}

impl std::fmt::Display for Ratio {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} %", unit_text::format_shifted(self.0, -2))
    }
}

impl serde::Serialize for Ratio {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl<'de> serde::Deserialize<'de> for Ratio {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Visitor;
        impl serde::de::Visitor<'_> for Visitor {
            type Value = Ratio;
            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                write!(f, "a number, or text with %")
            }
            fn visit_str<E: serde::de::Error>(self, text: &str) -> Result<Ratio, E> {
                text.parse().map_err(E::custom)
            }
            fn visit_f64<E: serde::de::Error>(self, number: f64) -> Result<Ratio, E> {
                Ok(Ratio(number))
            }
            fn visit_i64<E: serde::de::Error>(self, number: i64) -> Result<Ratio, E> {
                Ok(Ratio(number as f64))
            }
            fn visit_u64<E: serde::de::Error>(self, number: u64) -> Result<Ratio, E> {
                Ok(Ratio(number as f64))
            }
        }
        deserializer.deserialize_any(Visitor)
    }
}

#[cfg(feature = "schema")]
impl schemars::JsonSchema for Ratio {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Ratio".into()
    }

    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schemars::json_schema!({
            "type": ["number", "string"],
            "description": "a share: 0.01 or \"1 %\"",
        })
    }
}
