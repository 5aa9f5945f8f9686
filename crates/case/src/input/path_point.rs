//! A point on the path of contact, as a case names it.

use asperity_gear::PathOfContact;
use serde::de::value::StrDeserializer;
use serde::de::{IntoDeserializer, Visitor};
use serde::{Deserialize, Deserializer, Serialize};

/// Places of the path of contact that represent the mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Positions {
    /// Cells of the whole path.
    AlongPath,
    /// The place `model.position` alone.
    Single,
}

/// A point on the path of contact.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(untagged)]
pub enum PathPoint {
    /// One of the points A to E.
    Named(NamedPoint),
    /// 0 at A (start of contact), 1 at E (end).
    Fraction(f64),
}

impl PathPoint {
    /// Fraction of `path` at the point, 0 at A and 1 at E.
    pub fn fraction_of(self, path: &PathOfContact) -> f64 {
        let s = match self {
            Self::Fraction(fraction) => return fraction,
            Self::Named(NamedPoint::A) => path.a,
            Self::Named(NamedPoint::B) => path.b,
            Self::Named(NamedPoint::C) => path.c,
            Self::Named(NamedPoint::D) => path.d,
            Self::Named(NamedPoint::E) => path.e,
        };
        (s - path.a) / (path.e - path.a)
    }
}

impl<'de> Deserialize<'de> for PathPoint {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(PathPointVisitor)
    }
}

struct PathPointVisitor;

impl Visitor<'_> for PathPointVisitor {
    type Value = PathPoint;

    fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "one of A, B, C, D, E, or a number from 0 (A) to 1 (E)")
    }

    fn visit_str<E: serde::de::Error>(self, text: &str) -> Result<Self::Value, E> {
        let name: StrDeserializer<'_, E> = text.into_deserializer();
        NamedPoint::deserialize(name).map(PathPoint::Named)
    }

    fn visit_f64<E: serde::de::Error>(self, number: f64) -> Result<Self::Value, E> {
        Ok(PathPoint::Fraction(number))
    }

    fn visit_i64<E: serde::de::Error>(self, number: i64) -> Result<Self::Value, E> {
        Ok(PathPoint::Fraction(number as f64))
    }

    fn visit_u64<E: serde::de::Error>(self, number: u64) -> Result<Self::Value, E> {
        Ok(PathPoint::Fraction(number as f64))
    }
}

/// Reads a point as the command line takes it: `C`, or `0.25`.
impl std::str::FromStr for PathPoint {
    type Err = serde::de::value::Error;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        match text.parse() {
            Ok(fraction) => Ok(Self::Fraction(fraction)),
            Err(_) => Self::deserialize(text.into_deserializer()),
        }
    }
}

/// The points A to E of the path of contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum NamedPoint {
    /// Start of contact (tip of the wheel).
    A,
    /// Start of single contact.
    B,
    /// Pitch point.
    C,
    /// End of single contact.
    D,
    /// End of contact (tip of the pinion).
    E,
}
